package gamephys;

import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.nio.ByteBuffer;
import java.util.List;
import java.util.stream.IntStream;

/** Memory for the arguments and results of single calls, one for each thread: a slot for each argument. */
final class Scratch {
    private static final int SLOTS = 16, BYTES = 128;
    private static final ThreadLocal<Scratch> LOCAL = ThreadLocal.withInitial(Scratch::new);
    final ByteBuffer memory = Batch.direct(SLOTS * BYTES);
    private final Pointer[] slots = new Pointer[SLOTS];

    private Scratch() {
        Pointer start = Native.getDirectBufferPointer(memory);
        for (int i = 0; i < SLOTS; ++i) slots[i] = start.share((long) i * BYTES);
    }

    static Scratch get() {
        return LOCAL.get();
    }

    static int at(int slot) {
        return slot * BYTES;
    }

    Pointer slot(int slot) {
        return slots[slot];
    }

    Pointer put(int slot, Value value) {
        if (value == null) return null;
        value.write(memory, at(slot));
        return slots[slot];
    }

    Pointer put(int slot, double[] values, int count) {
        if (values.length != count) throw new IllegalArgumentException("expected " + count + " numbers, got " + values.length);
        for (int i = 0; i < count; ++i) memory.putDouble(at(slot) + 8 * i, values[i]);
        return slots[slot];
    }

    int getInt(int slot) {
        return memory.getInt(at(slot));
    }

    float getFloat(int slot) {
        return memory.getFloat(at(slot));
    }

    int[] ints(int slot, int count) {
        int[] values = new int[count];
        for (int i = 0; i < count; ++i) values[i] = memory.getInt(at(slot) + 4 * i);
        return values;
    }

    double[] doubles(int slot, int count) {
        double[] values = new double[count];
        for (int i = 0; i < count; ++i) values[i] = memory.getDouble(at(slot) + 8 * i);
        return values;
    }

    <T> List<T> list(int slot, int count, Layout<T> layout) {
        return IntStream.range(0, count).mapToObj(i -> layout.reader().read(memory, at(slot) + i * layout.bytes())).toList();
    }
}
