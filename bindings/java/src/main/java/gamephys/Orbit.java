// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
 * nothing depends on the frame time or on how often update is called. Frozen.
 * </pre>
 */
public record Orbit(Vec3 target, Vec3 up, float distance, float yaw, float pitch, float radiansPerUnit, float metresPerUnit, float minDistance, float maxDistance, float minPitch, float maxPitch) implements Value {
    public static final Layout<Orbit> LAYOUT = new Layout<>(60, 0, Orbit::read, Orbit::write);

    static Orbit read(ByteBuffer memory, int at) {
        return new Orbit(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                memory.getFloat(at + 24),
                memory.getFloat(at + 28),
                memory.getFloat(at + 32),
                memory.getFloat(at + 36),
                memory.getFloat(at + 40),
                memory.getFloat(at + 44),
                memory.getFloat(at + 48),
                memory.getFloat(at + 52),
                memory.getFloat(at + 56));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        target.write(memory, at);
        up.write(memory, at + 12);
        memory.putFloat(at + 24, distance);
        memory.putFloat(at + 28, yaw);
        memory.putFloat(at + 32, pitch);
        memory.putFloat(at + 36, radiansPerUnit);
        memory.putFloat(at + 40, metresPerUnit);
        memory.putFloat(at + 44, minDistance);
        memory.putFloat(at + 48, maxDistance);
        memory.putFloat(at + 52, minPitch);
        memory.putFloat(at + 56, maxPitch);
    }
}
