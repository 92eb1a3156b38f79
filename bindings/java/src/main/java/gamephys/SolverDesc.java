// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class SolverDesc {
    private final ByteBuffer memory = Batch.direct(Low.pick(40, 32));

    public SolverDesc() {
        Low.check(Low.gphys_solver_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * NULL: the C++ runtime's
     * </pre>
     */
    public SolverDesc allocator(Pointer value) {
        pointer().setPointer(Low.pick(8, 4), value);
        return this;
    }

    /**
     * <pre>
     * m/s^2; default (0, -9.81, 0)
     * </pre>
     */
    public SolverDesc gravity(Vec3 value) {
        value.write(memory, Low.pick(16, 8));
        return this;
    }

    public Vec3 gravity() {
        return Vec3.read(memory, Low.pick(16, 8));
    }

    /**
     * <pre>
     * of one step, 1 .. 1000; default 8
     * </pre>
     */
    public SolverDesc substeps(int value) {
        memory.putInt(Low.pick(28, 20), value);
        return this;
    }

    public int substeps() {
        return memory.getInt(Low.pick(28, 20));
    }

    /**
     * <pre>
     * seconds simulated by each step of gphys_solver_advance; 1/60
     * </pre>
     */
    public SolverDesc fixedStep(float value) {
        memory.putFloat(Low.pick(32, 24), value);
        return this;
    }

    public float fixedStep() {
        return memory.getFloat(Low.pick(32, 24));
    }

    /**
     * <pre>
     * most steps of one advance; time beyond is dropped; 8
     * </pre>
     */
    public SolverDesc maxSteps(int value) {
        memory.putInt(Low.pick(36, 28), value);
        return this;
    }

    public int maxSteps() {
        return memory.getInt(Low.pick(36, 28));
    }
}
