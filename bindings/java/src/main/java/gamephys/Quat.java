// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Quat(float x, float y, float z, float w) implements Value {
    public static final Layout<Quat> LAYOUT = new Layout<>(16, 0, Quat::read, Quat::write);

    static Quat read(ByteBuffer memory, int at) {
        return new Quat(
                memory.getFloat(at),
                memory.getFloat(at + 4),
                memory.getFloat(at + 8),
                memory.getFloat(at + 12));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, x);
        memory.putFloat(at + 4, y);
        memory.putFloat(at + 8, z);
        memory.putFloat(at + 12, w);
    }
}
