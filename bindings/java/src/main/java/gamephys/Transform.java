// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * x -&gt; position + rotation * (scale * x); scale &gt; 0.
 * </pre>
 */
public record Transform(Vec3 position, Quat rotation, float scale) implements Value {
    public static final Layout<Transform> LAYOUT = new Layout<>(32, 0, Transform::read, Transform::write);

    /** What moves nothing. */
    public static final Transform IDENTITY = at(new Vec3(0, 0, 0));

    /** A place, neither turned nor scaled. */
    public static Transform at(Vec3 position) {
        return new Transform(position, new Quat(0, 0, 0, 1), 1);
    }

    static Transform read(ByteBuffer memory, int at) {
        return new Transform(
                Vec3.read(memory, at),
                Quat.read(memory, at + 12),
                memory.getFloat(at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        position.write(memory, at);
        rotation.write(memory, at + 12);
        memory.putFloat(at + 28, scale);
    }
}
