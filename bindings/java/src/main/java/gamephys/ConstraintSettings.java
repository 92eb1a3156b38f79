// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * The settings of a constraint. Frozen.
 * </pre>
 */
public record ConstraintSettings(float restLength, float compliance, float damping) implements Value {
    public static final Layout<ConstraintSettings> LAYOUT = new Layout<>(12, 0, ConstraintSettings::read, ConstraintSettings::write);

    static ConstraintSettings read(ByteBuffer memory, int at) {
        return new ConstraintSettings(
                memory.getFloat(at),
                memory.getFloat(at + 4),
                memory.getFloat(at + 8));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, restLength);
        memory.putFloat(at + 4, compliance);
        memory.putFloat(at + 8, damping);
    }
}
