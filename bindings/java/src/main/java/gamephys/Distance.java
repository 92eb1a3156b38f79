// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * How far a ray goes and what it hits: fields of a Hit. Frozen.  Since 1.1.
 * </pre>
 */
public record Distance(float t, int model, int triangle) implements Value {
    public static final Layout<Distance> LAYOUT = new Layout<>(12, 0, Distance::read, Distance::write);

    static Distance read(ByteBuffer memory, int at) {
        return new Distance(
                memory.getFloat(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, t);
        memory.putInt(at + 4, model);
        memory.putInt(at + 8, triangle);
    }
}
