// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * One box of an octree, for drawing. Frozen.
 * </pre>
 */
public record OctreeBox(Aabb bounds, int depth, int itemCount) implements Value {
    public static final Layout<OctreeBox> LAYOUT = new Layout<>(32, 0, OctreeBox::read, OctreeBox::write);

    static OctreeBox read(ByteBuffer memory, int at) {
        return new OctreeBox(
                Aabb.read(memory, at),
                memory.getInt(at + 24),
                memory.getInt(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        bounds.write(memory, at);
        memory.putInt(at + 24, depth);
        memory.putInt(at + 28, itemCount);
    }
}
