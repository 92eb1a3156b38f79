// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Ray(Vec3 origin, Vec3 direction, float tMax) implements Shape, Value {
    public static final Layout<Ray> LAYOUT = new Layout<>(28, Gamephys.SHAPE_RAY, Ray::read, Ray::write);

    static Ray read(ByteBuffer memory, int at) {
        return new Ray(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                memory.getFloat(at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        origin.write(memory, at);
        direction.write(memory, at + 12);
        memory.putFloat(at + 24, tMax);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_RAY;
    }
}
