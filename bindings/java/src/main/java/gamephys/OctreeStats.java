// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
 * eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen.
 * </pre>
 */
public record OctreeStats(int itemCount, int unboundedCount, int nodeCount, int leafCount, int depth, int rebuilds, float cost, int memoryBytes) implements Value {
    public static final Layout<OctreeStats> LAYOUT = new Layout<>(32, 0, OctreeStats::read, OctreeStats::write);

    static OctreeStats read(ByteBuffer memory, int at) {
        return new OctreeStats(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16),
                memory.getInt(at + 20),
                memory.getFloat(at + 24),
                memory.getInt(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, itemCount);
        memory.putInt(at + 4, unboundedCount);
        memory.putInt(at + 8, nodeCount);
        memory.putInt(at + 12, leafCount);
        memory.putInt(at + 16, depth);
        memory.putInt(at + 20, rebuilds);
        memory.putFloat(at + 24, cost);
        memory.putInt(at + 28, memoryBytes);
    }
}
