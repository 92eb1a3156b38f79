package gamephys;

import com.sun.jna.Native;
import com.sun.jna.Pointer;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.ReadOnlyBufferException;
import java.util.AbstractList;
import java.util.List;

/**
 * Elements of one kind in memory of the library's layout, which it reads and writes in place. As a list
 * it makes an object of each element when asked for it; buffer() gives the numbers themselves.
 */
public final class Batch<T> extends AbstractList<T> {
    private final Layout<T> layout;
    private final ByteBuffer memory;
    private final Pointer pointer;
    private final boolean shared;
    private Object[] kept; // what elements point to

    private Batch(Layout<T> layout, ByteBuffer memory, boolean shared) {
        if (memory.capacity() % layout.bytes() != 0) {
            throw new IllegalArgumentException("not a whole number of elements of " + layout.bytes() + " bytes");
        }
        this.layout = layout;
        this.memory = memory;
        this.pointer = Native.getDirectBufferPointer(memory);
        this.shared = shared;
    }

    static ByteBuffer direct(int bytes) {
        return ByteBuffer.allocateDirect(bytes).order(ByteOrder.nativeOrder());
    }

    /** A number of elements, all zero. */
    public static <T> Batch<T> allocate(Layout<T> layout, int size) {
        return new Batch<>(layout, direct(Math.multiplyExact(layout.bytes(), size)), false);
    }

    /** The memory between position and limit of a direct buffer, without a copy. */
    public static <T> Batch<T> of(Layout<T> layout, ByteBuffer buffer) {
        if (!buffer.isDirect()) throw new IllegalArgumentException("a direct buffer is needed");
        Batch<T> batch = new Batch<>(layout, buffer.slice().order(ByteOrder.nativeOrder()), false);
        if (Pointer.nativeValue(batch.pointer) % 4 != 0) throw new IllegalArgumentException("memory must begin at a multiple of 4 bytes");
        return batch;
    }

    /** A copy of values. */
    public static <T> Batch<T> copyOf(Layout<T> layout, List<? extends T> values) {
        Batch<T> batch = allocate(layout, values.size());
        for (int i = 0; i < values.size(); ++i) batch.set(i, values.get(i));
        return batch;
    }

    /** One value that stands for every element. */
    public static <T> Batch<T> shared(Layout<T> layout, T value) {
        Batch<T> batch = new Batch<>(layout, direct(layout.bytes()), true);
        batch.set(0, value);
        return batch;
    }

    public static Batch<Float> floats(float... values) {
        Batch<Float> batch = allocate(Layout.FLOAT, values.length);
        batch.memory.asFloatBuffer().put(values);
        return batch;
    }

    public static Batch<Integer> ints(int... values) {
        Batch<Integer> batch = allocate(Layout.INT, values.length);
        batch.memory.asIntBuffer().put(values);
        return batch;
    }

    @Override
    public int size() {
        return memory.capacity() / layout.bytes();
    }

    @Override
    public T get(int index) {
        T value = layout.reader().read(memory, at(index));
        if (kept != null && value instanceof Listed) ((Listed) value).list = kept[index];
        return value;
    }

    /** Changes the memory; nothing is returned. */
    @Override
    public T set(int index, T value) {
        layout.writer().write(value, memory, at(index));
        if (value instanceof Listed) {
            if (kept == null) kept = new Object[size()];
            kept[index] = ((Listed) value).list;
        }
        return null;
    }

    /** The memory itself, in the byte order of the machine. */
    public ByteBuffer buffer() {
        return memory.duplicate().order(ByteOrder.nativeOrder());
    }

    /** The first elements, in the same memory. */
    public Batch<T> first(int size) {
        Batch<T> part = new Batch<>(layout, memory.slice(0, size * layout.bytes()).order(ByteOrder.nativeOrder()), false);
        part.kept = kept;
        return part;
    }

    private int at(int index) {
        return java.util.Objects.checkIndex(index, size()) * layout.bytes();
    }

    Layout<T> layout() {
        return layout;
    }

    Pointer pointer() {
        return pointer;
    }

    int stride() {
        return shared ? 0 : layout.bytes();
    }

    /** Bytes from one element to the next where it consists of several numbers. */
    int stride(int bytes) {
        return bytes;
    }

    int size(int width) {
        if (size() % width != 0) throw new IllegalArgumentException("not a whole number of elements of " + width + " numbers");
        return size() / width;
    }

    /** The number of elements, or -1 if it stands for any number. */
    int common() {
        return shared ? -1 : size();
    }

    int common(int width) {
        return size(width);
    }

    static Pointer pointer(Batch<?> batch) {
        return batch == null ? null : batch.pointer;
    }

    static int stride(Batch<?> batch) {
        return batch == null ? 0 : batch.stride();
    }

    static int common(Batch<?> batch) {
        return batch == null ? -1 : batch.common();
    }

    /** Room for results: the caller's, if there is some. */
    static <T> Batch<T> room(Layout<T> layout, int size, Batch<T> out) {
        if (out == null) return allocate(layout, size);
        if (out.size() != size) throw new IllegalArgumentException("room for " + out.size() + " results, not " + size);
        if (out.memory.isReadOnly()) throw new ReadOnlyBufferException();
        return out;
    }
}
