// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What all particles of a body share and may change later. Fields as in BodyDesc. Frozen.
 * </pre>
 */
public record BodySettings(float damping, float friction, float staticFriction, float restitution, int layers, int bodyLayers, int selfCollision) implements Value {
    public static final Layout<BodySettings> LAYOUT = new Layout<>(28, 0, BodySettings::read, BodySettings::write);

    static BodySettings read(ByteBuffer memory, int at) {
        return new BodySettings(
                memory.getFloat(at),
                memory.getFloat(at + 4),
                memory.getFloat(at + 8),
                memory.getFloat(at + 12),
                memory.getInt(at + 16),
                memory.getInt(at + 20),
                memory.getInt(at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, damping);
        memory.putFloat(at + 4, friction);
        memory.putFloat(at + 8, staticFriction);
        memory.putFloat(at + 12, restitution);
        memory.putInt(at + 16, layers);
        memory.putInt(at + 20, bodyLayers);
        memory.putInt(at + 24, selfCollision);
    }
}
