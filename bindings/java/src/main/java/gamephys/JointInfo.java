// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * One joint. Frozen.
 * </pre>
 */
public record JointInfo(int id, int bodyA, int particleA, int bodyB, int particleB, float restLength, float compliance, float force) implements Value {
    public static final Layout<JointInfo> LAYOUT = new Layout<>(32, 0, JointInfo::read, JointInfo::write);

    static JointInfo read(ByteBuffer memory, int at) {
        return new JointInfo(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16),
                memory.getFloat(at + 20),
                memory.getFloat(at + 24),
                memory.getFloat(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, id);
        memory.putInt(at + 4, bodyA);
        memory.putInt(at + 8, particleA);
        memory.putInt(at + 12, bodyB);
        memory.putInt(at + 16, particleB);
        memory.putFloat(at + 20, restLength);
        memory.putFloat(at + 24, compliance);
        memory.putFloat(at + 28, force);
    }
}
