// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class ModelDesc {
    /** For a Batch of copies: Batch.copyOf, or Batch.shared for one that stands for all. */
    public static final Layout<ModelDesc> LAYOUT = new Layout<>(28, 0, ModelDesc::read, ModelDesc::write);

    private final ByteBuffer memory = Batch.direct(28);

    public ModelDesc() {
        Low.check(Low.gphys_model_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * 0: none
     * </pre>
     */
    public ModelDesc parent(int value) {
        memory.putInt(4, value);
        return this;
    }

    public int parent() {
        return memory.getInt(4);
    }

    /**
     * <pre>
     * a query with mask m sees the model if layers &amp; m; default 1
     * </pre>
     */
    public ModelDesc layers(int value) {
        memory.putInt(8, value);
        return this;
    }

    public int layers() {
        return memory.getInt(8);
    }

    /**
     * <pre>
     * any number of the caller's, returned with each hit; 0
     * </pre>
     */
    public ModelDesc tag(int value) {
        memory.putInt(12, value);
        return this;
    }

    public int tag() {
        return memory.getInt(12);
    }

    /**
     * <pre>
     * as Scene.setScale sets it; 1 1 1, and 0 0 0 is the same. Since 1.1
     * </pre>
     */
    public ModelDesc scale(Vec3 value) {
        value.write(memory, 16);
        return this;
    }

    public Vec3 scale() {
        return Vec3.read(memory, 16);
    }

    private static ModelDesc read(ByteBuffer memory, int at) {
        ModelDesc copy = new ModelDesc();
        copy.memory.put(0, memory, at, 28);
        return copy;
    }

    private void write(ByteBuffer to, int at) {
        to.put(at, memory, 0, 28);
    }
}
