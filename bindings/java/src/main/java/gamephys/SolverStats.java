// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * Frozen.
 * </pre>
 */
public record SolverStats(int particleCount, int pinnedCount, int constraintCount, int contactCount, float strainMax, float strainRms, float kineticEnergy, float potentialEnergy) implements Value {
    public static final Layout<SolverStats> LAYOUT = new Layout<>(32, 0, SolverStats::read, SolverStats::write);

    static SolverStats read(ByteBuffer memory, int at) {
        return new SolverStats(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getFloat(at + 16),
                memory.getFloat(at + 20),
                memory.getFloat(at + 24),
                memory.getFloat(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, particleCount);
        memory.putInt(at + 4, pinnedCount);
        memory.putInt(at + 8, constraintCount);
        memory.putInt(at + 12, contactCount);
        memory.putFloat(at + 16, strainMax);
        memory.putFloat(at + 20, strainRms);
        memory.putFloat(at + 24, kineticEnergy);
        memory.putFloat(at + 28, potentialEnergy);
    }
}
