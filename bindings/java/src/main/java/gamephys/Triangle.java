// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * May be degenerate: then it is the segment or point that its corners span. The normal is that
 * of cross(b - a, c - a).
 * </pre>
 */
public record Triangle(Vec3 a, Vec3 b, Vec3 c) implements Shape, Value {
    public static final Layout<Triangle> LAYOUT = new Layout<>(36, Gamephys.SHAPE_TRIANGLE, Triangle::read, Triangle::write);

    static Triangle read(ByteBuffer memory, int at) {
        return new Triangle(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                Vec3.read(memory, at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        a.write(memory, at);
        b.write(memory, at + 12);
        c.write(memory, at + 24);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_TRIANGLE;
    }
}
