// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Aabb(Vec3 min, Vec3 max) implements Shape, Value {
    public static final Layout<Aabb> LAYOUT = new Layout<>(24, Gamephys.SHAPE_AABB, Aabb::read, Aabb::write);

    static Aabb read(ByteBuffer memory, int at) {
        return new Aabb(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        min.write(memory, at);
        max.write(memory, at + 12);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_AABB;
    }
}
