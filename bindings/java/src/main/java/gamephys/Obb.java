// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Obb(Vec3 center, Vec3 halfExtents, Quat rotation) implements Shape, Value {
    public static final Layout<Obb> LAYOUT = new Layout<>(40, Gamephys.SHAPE_OBB, Obb::read, Obb::write);

    static Obb read(ByteBuffer memory, int at) {
        return new Obb(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12),
                Quat.read(memory, at + 24));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        center.write(memory, at);
        halfExtents.write(memory, at + 12);
        rotation.write(memory, at + 24);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_OBB;
    }
}
