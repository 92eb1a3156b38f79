package gamephys;

import java.nio.ByteBuffer;

/** The layout of a value in memory: Ray.LAYOUT, Layout.FLOAT. */
public record Layout<T>(int bytes, int kind, Reader<T> reader, Writer<T> writer) {
    /** Reads the value that starts at a byte. */
    public interface Reader<T> {
        T read(ByteBuffer memory, int at);
    }

    /** Writes a value from a byte on. */
    public interface Writer<T> {
        void write(T value, ByteBuffer memory, int at);
    }

    public static final Layout<Integer> INT = new Layout<>(4, 0, ByteBuffer::getInt, (value, memory, at) -> memory.putInt(at, value));
    public static final Layout<Float> FLOAT =
            new Layout<>(4, 0, ByteBuffer::getFloat, (value, memory, at) -> memory.putFloat(at, value));
    public static final Layout<Double> DOUBLE =
            new Layout<>(8, 0, ByteBuffer::getDouble, (value, memory, at) -> memory.putDouble(at, value));
}
