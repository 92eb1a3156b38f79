// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * A particle that is attached to a model. Frozen.  Since 1.1.
 * </pre>
 */
public record Attachment(int particle, int model, Vec3 localPoint) implements Value {
    public static final Layout<Attachment> LAYOUT = new Layout<>(20, 0, Attachment::read, Attachment::write);

    static Attachment read(ByteBuffer memory, int at) {
        return new Attachment(
                memory.getInt(at),
                memory.getInt(at + 4),
                Vec3.read(memory, at + 8));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, particle);
        memory.putInt(at + 4, model);
        localPoint.write(memory, at + 8);
    }
}
