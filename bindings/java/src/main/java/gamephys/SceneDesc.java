// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class SceneDesc {
    private final ByteBuffer memory = Batch.direct(Low.pick(40, 24));

    public SceneDesc() {
        Low.check(Low.gphys_scene_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * null: the C++ runtime's
     * </pre>
     */
    public SceneDesc allocator(Pointer value) {
        pointer().setPointer(Low.pick(8, 4), value);
        return this;
    }

    /**
     * <pre>
     * models to make room for at once; 0
     * </pre>
     */
    public SceneDesc reserveModels(int value) {
        memory.putInt(Low.pick(16, 8), value);
        return this;
    }

    public int reserveModels() {
        return memory.getInt(Low.pick(16, 8));
    }

    /**
     * <pre>
     * provides the worker_count threads; null: the scene's own
     * </pre>
     */
    public SceneDesc taskRunner(Pointer value) {
        pointer().setPointer(Low.pick(24, 12), value);
        return this;
    }

    /**
     * <pre>
     * threads for one call, including the caller's, at most 1024; 0 and 1: that alone
     * </pre>
     */
    public SceneDesc workerCount(int value) {
        memory.putInt(Low.pick(32, 16), value);
        return this;
    }

    public int workerCount() {
        return memory.getInt(Low.pick(32, 16));
    }
}
