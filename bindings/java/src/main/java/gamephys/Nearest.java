// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * The closest point of something to a given point.
 * </pre>
 */
public record Nearest(int model, int tag, Vec3 point, float distance, int triangle) implements Value {
    public static final Layout<Nearest> LAYOUT = new Layout<>(28, 0, Nearest::read, Nearest::write);

    static Nearest read(ByteBuffer memory, int at) {
        return new Nearest(
                memory.getInt(at),
                memory.getInt(at + 4),
                Vec3.read(memory, at + 8),
                memory.getFloat(at + 20),
                memory.getInt(at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, model);
        memory.putInt(at + 4, tag);
        point.write(memory, at + 8);
        memory.putFloat(at + 20, distance);
        memory.putInt(at + 24, triangle);
    }
}
