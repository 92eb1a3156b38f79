// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * How a solid gets out of something that it overlaps.
 * </pre>
 */
public record Penetration(int model, int tag, Vec3 point, Vec3 normal, float depth, int triangle) implements Value {
    public static final Layout<Penetration> LAYOUT = new Layout<>(40, 0, Penetration::read, Penetration::write);

    static Penetration read(ByteBuffer memory, int at) {
        return new Penetration(
                memory.getInt(at),
                memory.getInt(at + 4),
                Vec3.read(memory, at + 8),
                Vec3.read(memory, at + 20),
                memory.getFloat(at + 32),
                memory.getInt(at + 36));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, model);
        memory.putInt(at + 4, tag);
        point.write(memory, at + 8);
        normal.write(memory, at + 20);
        memory.putFloat(at + 32, depth);
        memory.putInt(at + 36, triangle);
    }
}
