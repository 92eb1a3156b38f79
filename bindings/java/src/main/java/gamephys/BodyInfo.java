// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Frozen.
 * </pre>
 */
public record BodyInfo(int kind, int method, int particleCount, int constraintCount, int triangleCount) implements Value {
    public static final Layout<BodyInfo> LAYOUT = new Layout<>(20, 0, BodyInfo::read, BodyInfo::write);

    static BodyInfo read(ByteBuffer memory, int at) {
        return new BodyInfo(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, kind);
        memory.putInt(at + 4, method);
        memory.putInt(at + 8, particleCount);
        memory.putInt(at + 12, constraintCount);
        memory.putInt(at + 16, triangleCount);
    }
}
