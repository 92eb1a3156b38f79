// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Vec3(float x, float y, float z) implements Value {
    public static final Layout<Vec3> LAYOUT = new Layout<>(12, 0, Vec3::read, Vec3::write);

    static Vec3 read(ByteBuffer memory, int at) {
        return new Vec3(
                memory.getFloat(at),
                memory.getFloat(at + 4),
                memory.getFloat(at + 8));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putFloat(at, x);
        memory.putFloat(at + 4, y);
        memory.putFloat(at + 8, z);
    }
}
