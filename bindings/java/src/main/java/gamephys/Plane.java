// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * The points x with dot(normal, x) = distance. The normal points to the front; it need not be
 * exactly unit: signed distances are divided by its length (for a unit normal, distance is the
 * plane's distance from the origin). distance divided by that length is within the range of
 * coordinates too.
 * </pre>
 */
public record Plane(Vec3 normal, float distance) implements Shape, Value {
    public static final Layout<Plane> LAYOUT = new Layout<>(16, Gamephys.SHAPE_PLANE, Plane::read, Plane::write);

    static Plane read(ByteBuffer memory, int at) {
        return new Plane(
                Vec3.read(memory, at),
                memory.getFloat(at + 12));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        normal.write(memory, at);
        memory.putFloat(at + 12, distance);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_PLANE;
    }
}
