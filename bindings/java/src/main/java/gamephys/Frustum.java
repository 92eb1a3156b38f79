// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * The points x with dot(planes[i].normal, x - origin) &gt;= planes[i].distance for all six planes,
 * which look inward, in the order of FRUSTUM_NEAR, FAR and so on. Distances count from origin, so that a
 * frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1.
 * </pre>
 */
public record Frustum(Vec3 origin, java.util.List<Plane> planes) implements Shape, Value {
    public static final Layout<Frustum> LAYOUT = new Layout<>(108, Gamephys.SHAPE_FRUSTUM, Frustum::read, Frustum::write);

    public Frustum {
        planes = java.util.List.copyOf(planes);
        if (planes.size() != 6) throw new IllegalArgumentException("Frustum has 6 elements");
    }

    static Frustum read(ByteBuffer memory, int at) {
        return new Frustum(
                Vec3.read(memory, at),
                java.util.stream.IntStream.range(0, 6).mapToObj(i -> Plane.read(memory, at + 12 + 16 * i)).toList());
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        origin.write(memory, at);
        for (int i = 0; i < 6; ++i) planes.get(i).write(memory, at + 12 + 16 * i);
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_FRUSTUM;
    }
}
