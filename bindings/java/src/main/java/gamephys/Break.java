// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * A constraint that broke, or that the caller has broken. Frozen.  Since 1.1.
 * </pre>
 */
public record Break(int body, int constraint, int particleA, int particleB, int tornParticle, int newParticle, float load) implements Value {
    public static final Layout<Break> LAYOUT = new Layout<>(28, 0, Break::read, Break::write);

    static Break read(ByteBuffer memory, int at) {
        return new Break(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16),
                memory.getInt(at + 20),
                memory.getFloat(at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, body);
        memory.putInt(at + 4, constraint);
        memory.putInt(at + 8, particleA);
        memory.putInt(at + 12, particleB);
        memory.putInt(at + 16, tornParticle);
        memory.putInt(at + 20, newParticle);
        memory.putFloat(at + 24, load);
    }
}
