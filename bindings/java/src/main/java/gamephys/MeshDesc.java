// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class MeshDesc {
    private final ByteBuffer memory = Batch.direct(Low.pick(24, 16));

    public MeshDesc() {
        Low.check(Low.gphys_mesh_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * null: the C++ runtime's
     * </pre>
     */
    public MeshDesc allocator(Pointer value) {
        pointer().setPointer(Low.pick(8, 4), value);
        return this;
    }

    /**
     * <pre>
     * 1: Mesh.setVertices will be called; 12 bytes a vertex more. Since 1.1
     * </pre>
     */
    public MeshDesc deformable(int value) {
        memory.putInt(Low.pick(16, 8), value);
        return this;
    }

    public int deformable() {
        return memory.getInt(Low.pick(16, 8));
    }
}
