package gamephys;

/** A sphere, capsule, AABB, OBB, plane, triangle, frustum, ray, segment or mesh. */
public sealed interface Shape
        permits Sphere, Capsule, Aabb, Obb, Plane, Triangle, Frustum, Ray, Segment, Mesh {
    /** One of the constants Gamephys.SHAPE_... */
    int kind();
}
