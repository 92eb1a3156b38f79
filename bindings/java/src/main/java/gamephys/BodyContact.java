// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Two particles of different bodies that touched in the last step. Frozen.  Since 1.1.
 * </pre>
 */
public record BodyContact(int bodyA, int particleA, int bodyB, int particleB, Vec3 normal, float distance, float impulse) implements Value {
    public static final Layout<BodyContact> LAYOUT = new Layout<>(36, 0, BodyContact::read, BodyContact::write);

    static BodyContact read(ByteBuffer memory, int at) {
        return new BodyContact(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                Vec3.read(memory, at + 16),
                memory.getFloat(at + 28),
                memory.getFloat(at + 32));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, bodyA);
        memory.putInt(at + 4, particleA);
        memory.putInt(at + 8, bodyB);
        memory.putInt(at + 12, particleB);
        normal.write(memory, at + 16);
        memory.putFloat(at + 28, distance);
        memory.putFloat(at + 32, impulse);
    }
}
