// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What a mesh is. Frozen.  Since 1.1.
 * </pre>
 */
public record MeshInfo(int kind, int vertexCount, int triangleCount, int deformable, int followsBody) implements Value {
    public static final Layout<MeshInfo> LAYOUT = new Layout<>(20, 0, MeshInfo::read, MeshInfo::write);

    static MeshInfo read(ByteBuffer memory, int at) {
        return new MeshInfo(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, kind);
        memory.putInt(at + 4, vertexCount);
        memory.putInt(at + 8, triangleCount);
        memory.putInt(at + 12, deformable);
        memory.putInt(at + 16, followsBody);
    }
}
