// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * All points within radius of the segment a b.
 * </pre>
 */
public record Capsule(Vec3 a, Vec3 b, float radius) implements Shape, Value {
    public static final Layout<Capsule> LAYOUT = new Layout<>(28, Gamephys.SHAPE_CAPSULE, Capsule::read, Capsule::write);

    static Capsule read(ByteBuffer memory, int at) {
        return new Capsule(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                memory.getFloat(at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        a.write(memory, at);
        b.write(memory, at + 12);
        memory.putFloat(at + 24, radius);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_CAPSULE;
    }
}
