// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Sphere(Vec3 center, float radius) implements Shape, Value {
    public static final Layout<Sphere> LAYOUT = new Layout<>(16, Gamephys.SHAPE_SPHERE, Sphere::read, Sphere::write);

    static Sphere read(ByteBuffer memory, int at) {
        return new Sphere(
                Vec3.read(memory, at),
                memory.getFloat(at + 12));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        center.write(memory, at);
        memory.putFloat(at + 12, radius);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_SPHERE;
    }
}
