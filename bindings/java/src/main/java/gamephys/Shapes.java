package gamephys;

import com.sun.jna.Pointer;
import java.util.List;

/** Shapes of one kind for a batch, or one that stands for all. */
public final class Shapes {
    private final int kind;
    private final Pointer pointer;
    private final int stride;
    private final int count;
    private final Object owner; // of the memory

    private Shapes(int kind, Pointer pointer, int stride, int count, Object owner) {
        this.kind = kind;
        this.pointer = pointer;
        this.stride = stride;
        this.count = count;
        this.owner = owner;
    }

    /** The memory of a batch. */
    public static Shapes of(Batch<? extends Shape> batch) {
        return new Shapes(batch.layout().kind(), batch.pointer(), batch.stride(), batch.common(), batch);
    }

    /** One shape for every element. */
    @SuppressWarnings("unchecked")
    public static Shapes of(Shape shape) {
        if (shape instanceof Mesh mesh) return new Shapes(mesh.kind(), mesh.opened(), 0, -1, mesh);
        return of(Batch.shared((Layout<Shape>) layoutOf(shape), shape));
    }

    /** Copies of shapes of one kind; none are of any kind. */
    @SuppressWarnings("unchecked")
    public static Shapes of(List<? extends Shape> shapes) {
        for (Shape shape : shapes) {
            if (shape.getClass() != shapes.get(0).getClass()) throw new IllegalArgumentException("shapes of several kinds");
        }
        Layout<? extends Shape> layout = shapes.isEmpty() ? Sphere.LAYOUT : layoutOf(shapes.get(0));
        return of(Batch.copyOf((Layout<Shape>) layout, shapes));
    }

    static Layout<? extends Shape> layoutOf(Shape shape) {
        return layoutOf(shape.kind());
    }

    static Layout<? extends Shape> layoutOf(int kind) {
        return switch (kind) {
            case Gamephys.SHAPE_SPHERE -> Sphere.LAYOUT;
            case Gamephys.SHAPE_CAPSULE -> Capsule.LAYOUT;
            case Gamephys.SHAPE_AABB -> Aabb.LAYOUT;
            case Gamephys.SHAPE_OBB -> Obb.LAYOUT;
            case Gamephys.SHAPE_PLANE -> Plane.LAYOUT;
            case Gamephys.SHAPE_TRIANGLE -> Triangle.LAYOUT;
            case Gamephys.SHAPE_RAY -> Ray.LAYOUT;
            case Gamephys.SHAPE_SEGMENT -> Segment.LAYOUT;
            default -> Frustum.LAYOUT; // the largest
        };
    }

    int kind() {
        return kind;
    }

    /** What a call holds, if they are a mesh. */
    Mesh mesh() {
        return owner instanceof Mesh mesh ? mesh : null;
    }

    /** Of a mesh only as long as it is open. */
    Pointer pointer() {
        return owner instanceof Mesh mesh ? mesh.opened() : pointer;
    }

    int stride() {
        return stride;
    }

    int common() {
        return count;
    }
}
