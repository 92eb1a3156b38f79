// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What bodies gave a model in the last step, by contacts and by attachments. Frozen.
 * </pre>
 */
public record Impulse(int model, int tag, Vec3 linear, Vec3 angular) implements Value {
    public static final Layout<Impulse> LAYOUT = new Layout<>(32, 0, Impulse::read, Impulse::write);

    static Impulse read(ByteBuffer memory, int at) {
        return new Impulse(
                memory.getInt(at),
                memory.getInt(at + 4),
                Vec3.read(memory, at + 8),
                Vec3.read(memory, at + 20));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, model);
        memory.putInt(at + 4, tag);
        linear.write(memory, at + 8);
        angular.write(memory, at + 20);
    }
}
