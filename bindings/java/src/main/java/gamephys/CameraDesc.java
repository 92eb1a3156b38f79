// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class CameraDesc {
    private final ByteBuffer memory = Batch.direct(Low.pick(40, 32));

    public CameraDesc() {
        Low.check(Low.gphys_camera_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * null: the C++ runtime's
     * </pre>
     */
    public CameraDesc allocator(Pointer value) {
        pointer().setPointer(Low.pick(8, 4), value);
        return this;
    }

    public CameraDesc handedness(int value) {
        memory.putInt(Low.pick(16, 8), value);
        return this;
    }

    public int handedness() {
        return memory.getInt(Low.pick(16, 8));
    }

    public CameraDesc depthRange(int value) {
        memory.putInt(Low.pick(20, 12), value);
        return this;
    }

    public int depthRange() {
        return memory.getInt(Low.pick(20, 12));
    }

    /**
     * <pre>
     * 1: near has the high depth, for float depth buffers
     * </pre>
     */
    public CameraDesc reverseZ(int value) {
        memory.putInt(Low.pick(24, 16), value);
        return this;
    }

    public int reverseZ() {
        return memory.getInt(Low.pick(24, 16));
    }

    /**
     * <pre>
     * pixels, 1e-3 .. 1e6
     * </pre>
     */
    public CameraDesc viewportWidth(float value) {
        memory.putFloat(Low.pick(28, 20), value);
        return this;
    }

    public float viewportWidth() {
        return memory.getFloat(Low.pick(28, 20));
    }

    public CameraDesc viewportHeight(float value) {
        memory.putFloat(Low.pick(32, 24), value);
        return this;
    }

    public float viewportHeight() {
        return memory.getFloat(Low.pick(32, 24));
    }
}
