// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

public record Segment(Vec3 a, Vec3 b) implements Shape, Value {
    public static final Layout<Segment> LAYOUT = new Layout<>(24, Gamephys.SHAPE_SEGMENT, Segment::read, Segment::write);

    static Segment read(ByteBuffer memory, int at) {
        return new Segment(
                Vec3.read(memory, at),
                Vec3.read(memory, at + 12));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        a.write(memory, at);
        b.write(memory, at + 12);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_SEGMENT;
    }
}
