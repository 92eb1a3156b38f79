// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Mat4(java.util.List<Float> m) implements Value {
    public static final Layout<Mat4> LAYOUT = new Layout<>(64, 0, Mat4::read, Mat4::write);

    public Mat4 {
        m = java.util.List.copyOf(m);
        if (m.size() != 16) throw new IllegalArgumentException("Mat4 has 16 elements");
    }

    static Mat4 read(ByteBuffer memory, int at) {
        return new Mat4(
                java.util.stream.IntStream.range(0, 16).mapToObj(i -> memory.getFloat(at + 4 * i)).toList());
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        for (int i = 0; i < 16; ++i) memory.putFloat(at + 4 * i, m.get(i));
    }
}
