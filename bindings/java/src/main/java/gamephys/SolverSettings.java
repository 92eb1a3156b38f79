// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What a solver was created with and may change later. Fields as in SolverDesc. Frozen.
 * </pre>
 */
public record SolverSettings(Vec3 gravity, int substeps, float fixedStep, int maxSteps, float sleepSpeed, float sleepStrain, float sleepTime, float maxStrain, float tolerance, int maxSubsteps, int maxWork) implements Value {
    public static final Layout<SolverSettings> LAYOUT = new Layout<>(52, 0, SolverSettings::read, SolverSettings::write);

    static SolverSettings read(ByteBuffer memory, int at) {
        return new SolverSettings(
                Vec3.read(memory, at),
                memory.getInt(at + 12),
                memory.getFloat(at + 16),
                memory.getInt(at + 20),
                memory.getFloat(at + 24),
                memory.getFloat(at + 28),
                memory.getFloat(at + 32),
                memory.getFloat(at + 36),
                memory.getFloat(at + 40),
                memory.getInt(at + 44),
                memory.getInt(at + 48));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        gravity.write(memory, at);
        memory.putInt(at + 12, substeps);
        memory.putFloat(at + 16, fixedStep);
        memory.putInt(at + 20, maxSteps);
        memory.putFloat(at + 24, sleepSpeed);
        memory.putFloat(at + 28, sleepStrain);
        memory.putFloat(at + 32, sleepTime);
        memory.putFloat(at + 36, maxStrain);
        memory.putFloat(at + 40, tolerance);
        memory.putInt(at + 44, maxSubsteps);
        memory.putInt(at + 48, maxWork);
    }
}
