// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1.
 * </pre>
 */
public record OrbitSpeeds(float rotateX, float rotateY, float zoom, float panX, float panY) implements Value {
    public static final Layout<OrbitSpeeds> LAYOUT = new Layout<>(20, 0, OrbitSpeeds::read, OrbitSpeeds::write);

    static OrbitSpeeds read(ByteBuffer memory, int at) {
        return new OrbitSpeeds(
                memory.getFloat(at),
                memory.getFloat(at + 4),
                memory.getFloat(at + 8),
                memory.getFloat(at + 12),
                memory.getFloat(at + 16));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, rotateX);
        memory.putFloat(at + 4, rotateY);
        memory.putFloat(at + 8, zoom);
        memory.putFloat(at + 12, panX);
        memory.putFloat(at + 16, panY);
    }
}
