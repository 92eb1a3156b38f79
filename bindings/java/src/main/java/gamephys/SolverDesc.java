// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/** Settings: the library's defaults, until one is changed. */
public final class SolverDesc {
    private final ByteBuffer memory = Batch.direct(Low.pick(80, 68));

    public SolverDesc() {
        Low.check(Low.gphys_solver_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * null: the C++ runtime's
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
     * of one step, 1 .. 1000; default 8; with error targets: of the first step
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
     * seconds simulated by each step of Solver.advance; 1/60
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

    /**
     * <pre>
     * provides the worker_count threads; null: the solver's own
     * </pre>
     */
    public SolverDesc taskRunner(Pointer value) {
        pointer().setPointer(Low.pick(40, 32), value);
        return this;
    }

    /**
     * <pre>
     * threads for one step, including the caller's, at most 1024; 0 and 1: that alone
     * </pre>
     */
    public SolverDesc workerCount(int value) {
        memory.putInt(Low.pick(48, 36), value);
        return this;
    }

    public int workerCount() {
        return memory.getInt(Low.pick(48, 36));
    }

    /**
     * <pre>
     * m/s, see Solver.getSleeping; 0: bodies never sleep; default 0
     * </pre>
     */
    public SolverDesc sleepSpeed(float value) {
        memory.putFloat(Low.pick(52, 40), value);
        return this;
    }

    public float sleepSpeed() {
        return memory.getFloat(Low.pick(52, 40));
    }

    /**
     * <pre>
     * of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by
     * the mean rest length of the body's rigid constraints; default 0.01
     * </pre>
     */
    public SolverDesc sleepStrain(float value) {
        memory.putFloat(Low.pick(56, 44), value);
        return this;
    }

    public float sleepStrain() {
        return memory.getFloat(Low.pick(56, 44));
    }

    /**
     * <pre>
     * seconds; default 0.5
     * </pre>
     */
    public SolverDesc sleepTime(float value) {
        memory.putFloat(Low.pick(60, 48), value);
        return this;
    }

    public float sleepTime() {
        return memory.getFloat(Low.pick(60, 48));
    }

    /**
     * <pre>
     * of rigid constraints, see Solver.getSubsteps; 0: none, for cloth 0.02; default 0
     * </pre>
     */
    public SolverDesc maxStrain(float value) {
        memory.putFloat(Low.pick(64, 52), value);
        return this;
    }

    public float maxStrain() {
        return memory.getFloat(Low.pick(64, 52));
    }

    /**
     * <pre>
     * target of positions: metres of error that a second of motion adds; 0: none; default 0
     * </pre>
     */
    public SolverDesc tolerance(float value) {
        memory.putFloat(Low.pick(68, 56), value);
        return this;
    }

    public float tolerance() {
        return memory.getFloat(Low.pick(68, 56));
    }

    /**
     * <pre>
     * the most that a target may ask for, 1 .. 1000; default 64
     * </pre>
     */
    public SolverDesc maxSubsteps(int value) {
        memory.putInt(Low.pick(72, 60), value);
        return this;
    }

    public int maxSubsteps() {
        return memory.getInt(Low.pick(72, 60));
    }

    /**
     * <pre>
     * see SolverSettings; 0: no bound; default 0
     * </pre>
     */
    public SolverDesc maxWork(int value) {
        memory.putInt(Low.pick(76, 64), value);
        return this;
    }

    public int maxWork() {
        return memory.getInt(Low.pick(76, 64));
    }
}
