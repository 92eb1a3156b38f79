// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * One constraint. Frozen.
 * </pre>
 */
public record ConstraintInfo(int id, int particleA, int particleB, float restLength, float compliance) implements Value {
    public static final Layout<ConstraintInfo> LAYOUT = new Layout<>(20, 0, ConstraintInfo::read, ConstraintInfo::write);

    static ConstraintInfo read(ByteBuffer memory, int at) {
        return new ConstraintInfo(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getFloat(at + 12),
                memory.getFloat(at + 16));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, id);
        memory.putInt(at + 4, particleA);
        memory.putInt(at + 8, particleB);
        memory.putFloat(at + 12, restLength);
        memory.putFloat(at + 16, compliance);
    }
}
