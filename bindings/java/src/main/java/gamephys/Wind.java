// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * The air around a body. Frozen.
 * </pre>
 */
public record Wind(Vec3 velocity, float density, float drag, float lift) implements Value {
    public static final Layout<Wind> LAYOUT = new Layout<>(24, 0, Wind::read, Wind::write);

    static Wind read(ByteBuffer memory, int at) {
        return new Wind(
                Vec3.read(memory, at),
                memory.getFloat(at + 12),
                memory.getFloat(at + 16),
                memory.getFloat(at + 20));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        velocity.write(memory, at);
        memory.putFloat(at + 12, density);
        memory.putFloat(at + 16, drag);
        memory.putFloat(at + 20, lift);
    }
}
