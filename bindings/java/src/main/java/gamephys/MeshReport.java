// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What is in a triangle array. Frozen.
 * </pre>
 */
public record MeshReport(int triangleCount, int degenerateCount, int firstDegenerate, int outOfRangeCount, int firstOutOfRange, int badVertexCount, int firstBadVertex, int openEdgeCount) implements Value {
    public static final Layout<MeshReport> LAYOUT = new Layout<>(32, 0, MeshReport::read, MeshReport::write);

    static MeshReport read(ByteBuffer memory, int at) {
        return new MeshReport(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16),
                memory.getInt(at + 20),
                memory.getInt(at + 24),
                memory.getInt(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, triangleCount);
        memory.putInt(at + 4, degenerateCount);
        memory.putInt(at + 8, firstDegenerate);
        memory.putInt(at + 12, outOfRangeCount);
        memory.putInt(at + 16, firstOutOfRange);
        memory.putInt(at + 20, badVertexCount);
        memory.putInt(at + 24, firstBadVertex);
        memory.putInt(at + 28, openEdgeCount);
    }
}
