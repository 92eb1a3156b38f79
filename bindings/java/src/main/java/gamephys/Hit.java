// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Where a ray, segment or swept sphere first meets something.
 * </pre>
 */
public record Hit(int model, int tag, float t, Vec3 point, Vec3 normal, int triangle, float u, float v, int flags) implements Value {
    public static final Layout<Hit> LAYOUT = new Layout<>(52, 0, Hit::read, Hit::write);

    static Hit read(ByteBuffer memory, int at) {
        return new Hit(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getFloat(at + 8),
                Vec3.read(memory, at + 12),
                Vec3.read(memory, at + 24),
                memory.getInt(at + 36),
                memory.getFloat(at + 40),
                memory.getFloat(at + 44),
                memory.getInt(at + 48));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, model);
        memory.putInt(at + 4, tag);
        memory.putFloat(at + 8, t);
        point.write(memory, at + 12);
        normal.write(memory, at + 24);
        memory.putInt(at + 36, triangle);
        memory.putFloat(at + 40, u);
        memory.putFloat(at + 44, v);
        memory.putInt(at + 48, flags);
    }
}
