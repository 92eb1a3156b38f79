// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Where an animation wants a particle, and how far from there the particle may be. Frozen.
 * </pre>
 */
public record AnimationTarget(Vec3 position, Vec3 normal, float maxDistance, float backstop) implements Value {
    public static final Layout<AnimationTarget> LAYOUT = new Layout<>(32, 0, AnimationTarget::read, AnimationTarget::write);

    static AnimationTarget read(ByteBuffer memory, int at) {
        return new AnimationTarget(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                memory.getFloat(at + 24),
                memory.getFloat(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        position.write(memory, at);
        normal.write(memory, at + 12);
        memory.putFloat(at + 24, maxDistance);
        memory.putFloat(at + 28, backstop);
    }
}
