// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.util.Optional;

/** Constants, and questions about single shapes. */
public final class Gamephys extends GamephysBase {
    private Gamephys() {}

    public static final int OK = 0;
    public static final int NO_HIT = 1;
    public static final int INCOMPLETE = 2;
    public static final int UNBOUNDED = 3;
    public static final int ERROR_INVALID_ARGUMENT = -1;
    public static final int ERROR_INVALID_ID = -2;
    public static final int ERROR_STRUCT_SIZE = -3;
    public static final int ERROR_OUT_OF_MEMORY = -4;
    public static final int ERROR_CAPACITY = -5;
    public static final int ERROR_CYCLE = -6;
    public static final int ERROR_UNSUPPORTED = -7;
    public static final int ERROR_SINGULAR = -8;
    public static final int ERROR_INTERNAL = -100;
    public static final int FRUSTUM_NEAR = 0;
    public static final int FRUSTUM_FAR = 1;
    public static final int FRUSTUM_LEFT = 2;
    public static final int FRUSTUM_RIGHT = 3;
    public static final int FRUSTUM_BOTTOM = 4;
    public static final int FRUSTUM_TOP = 5;
    public static final int HIT_INSIDE = 1;
    public static final int HIT_BACK = 2;
    public static final int SHAPE_SPHERE = 1;
    public static final int SHAPE_CAPSULE = 2;
    public static final int SHAPE_AABB = 3;
    public static final int SHAPE_OBB = 4;
    public static final int SHAPE_PLANE = 5;
    public static final int SHAPE_TRIANGLE = 6;
    public static final int SHAPE_FRUSTUM = 7;
    public static final int SHAPE_MESH = 8;
    public static final int SHAPE_RAY = 16;
    public static final int SHAPE_SEGMENT = 17;
    public static final int SIDE_OUTSIDE = -1;
    public static final int SIDE_CROSSING = 0;
    public static final int SIDE_INSIDE = 1;
    public static final int DEPTH_ZERO_TO_ONE = 0;
    public static final int DEPTH_MINUS_ONE_TO_ONE = 1;
    public static final int MESH_SURFACE = 0;
    public static final int MESH_BODY_SURFACE = 1;
    public static final int MESH_BODY_LINKS = 2;
    public static final int MESH_HULL = 3;
    public static final int FILTER_SUBTREE = 1;
    public static final int FILTER_NO_BACK_FACES = 2;
    public static final int FILTER_NO_FRONT_FACES = 4;
    public static final int PROJECTION_PERSPECTIVE = 0;
    public static final int PROJECTION_ORTHOGRAPHIC = 1;
    public static final int PROJECTION_USER = 2;
    public static final int LEFT_HANDED = 0;
    public static final int RIGHT_HANDED = 1;
    public static final int PICK_FROM_NEAR_PLANE = 0;
    public static final int PICK_FROM_CENTRE = 1;
    public static final int CLOTH_SHEAR = 1;
    public static final int CLOTH_BEND = 2;
    public static final int BODY_PARTICLES = 1;
    public static final int BODY_ROPE = 2;
    public static final int BODY_CLOTH = 3;
    public static final int SOLVE_FREE = 0;
    public static final int SOLVE_DIRECT = 1;
    public static final int SOLVE_GRAPH = 2;
    public static final int CONSTRAINT_DISTANCE = 0;
    public static final int CONSTRAINT_MAX_DISTANCE = 1;
    public static final int VERSION_MAJOR = 1;
    public static final int VERSION_MINOR = 1;
    public static final int VERSION_PATCH = 0;
    public static final float MAX_COORDINATE = 1000000000000000.0f;
    public static final int NO_TRIANGLE = 0xffffffff;
    public static final int NO_PARTICLE = 0xffffffff;
    public static final int ALL_LAYERS = 0xffffffff;

    /**
     * Whether the fields of the shape are in the ranges stated beside its struct.
     * Cost: O(1).
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: and the exception's message names the field
     */
    public static void validate(Shape shape) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_validate(shape.kind(), Low.shape(shape, scratch, 1));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        Low.check(status);
    }

    /**
     * The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
     * Cost: O(1), for a mesh too.
     * @return empty for a plane, a ray without end (or with one beyond all floats) and a frustum that
     *     extends to infinity; for an empty mesh or frustum.
     */
    public static Optional<Aabb> bounds(Shape shape) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_bounds(shape.kind(), Low.shape(shape, scratch, 1), scratch.slot(2));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        return Low.found(status) ? Optional.of(Aabb.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
     * answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
     * rotation in double precision). Others are as Gamephys.overlaps with a sphere.
     * Cost: O(1); O(log n) expected for a mesh.
     * @param tolerance metres, &gt;= 0
     */
    public static boolean contains(Shape shape, Vec3 point, float tolerance) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_contains(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, point), tolerance, scratch.slot(4));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        Low.check(status);
        return scratch.getInt(4) != 0;
    }

    /** The same with defaults. */
    public static boolean contains(Shape shape, Vec3 point) {
        return contains(shape, point, 0);
    }

    /**
     * Whether each of the points is within tolerance metres of one shape, as Gamephys.contains.
     * Cost: that of as many single calls.
     * @param tolerance metres, &gt;= 0, for all points
     */
    public static Batch<Integer> containsBatch(Shape shape, Batch<Vec3> points, float tolerance, Batch<Integer> out) {
        Scratch scratch = Scratch.get();
        int count = Low.common(points.common());
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_contains_batch(shape.kind(), Low.shape(shape, scratch, 1), points.pointer(), points.stride(), count, tolerance, room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape, points, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Integer> containsBatch(Shape shape, Batch<Vec3> points, float tolerance) {
        return containsBatch(shape, points, tolerance, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public static Batch<Integer> containsBatch(Shape shape, Batch<Vec3> points) {
        return containsBatch(shape, points, 0, (Batch<Integer>) null);
    }

    /**
     * The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
     * ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
     * difference. If several are equally close, one of them, always the same. For a ray, t is limited by
     * t_max.
     * Cost: O(1); O(log n) expected for a mesh.
     * @return empty only for an empty mesh or an empty frustum.
     */
    public static Optional<Nearest> closestPoint(Shape shape, Vec3 point) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_closest_point(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, point), scratch.slot(3));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        return Low.found(status) ? Optional.of(Nearest.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * The points of one shape that are closest to each of the points, as Gamephys.closestPoint. An element
     * for which there is none gets distance INFINITY.
     * Cost: that of as many single calls.
     */
    public static Batch<Nearest> closestPointBatch(Shape shape, Batch<Vec3> points, Batch<Nearest> out) {
        Scratch scratch = Scratch.get();
        int count = Low.common(points.common());
        Batch<Nearest> room = Batch.room(Nearest.LAYOUT, count, out);
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_closest_point_batch(shape.kind(), Low.shape(shape, scratch, 1), points.pointer(), points.stride(), count, room.pointer(), Nearest.LAYOUT.bytes());
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape, points, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Nearest> closestPointBatch(Shape shape, Batch<Vec3> points) {
        return closestPointBatch(shape, points, (Batch<Nearest>) null);
    }

    /** What segmentClosestPoints returns. */
    public record SegmentClosestPointsResult(Vec3 a, Vec3 b, float distance) {}

    /**
     * The closest points of two segments and their distance. Parallel segments have many: the first along
     * a, always the same.
     * Cost: O(1).
     * @return metres.
     */
    public static SegmentClosestPointsResult segmentClosestPoints(Segment a, Segment b) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_segment_closest_points(scratch.put(0, a), scratch.put(1, b), scratch.slot(2), scratch.slot(3), scratch.slot(4));
        Low.check(status);
        return new SegmentClosestPointsResult(Vec3.read(scratch.memory, Scratch.at(2)), Vec3.read(scratch.memory, Scratch.at(3)), scratch.getFloat(4));
    }

    /**
     * Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
     * frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
     * not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes, triangles, meshes and
     * frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
     * the largest coordinate difference.
     * Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or segment (see Gamephys.segmentTest)
     */
    public static boolean overlaps(Shape a, Shape b) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(a));
        try {
            Owned.enter(Low.mesh(b));
            try {
                status = Low.gphys_shape_overlaps(a.kind(), Low.shape(a, scratch, 1), b.kind(), Low.shape(b, scratch, 3), scratch.slot(4));
            } finally {
                Owned.leave(Low.mesh(b));
            }
        } finally {
            Owned.leave(Low.mesh(a));
        }
        Low.keep(a, b);
        Low.check(status);
        return scratch.getInt(4) != 0;
    }

    /**
     * Whether the shapes of each of the pairs overlap, as Gamephys.overlaps: pair i is a[i] against b[i].
     * Cost: that of as many single calls.
     * @param a shapes of one type
     * @param b shapes of one type
     * @throws GamephysException with ERROR_UNSUPPORTED: for rays and segments
     */
    public static Batch<Integer> overlapsBatch(Shapes a, Shapes b, Batch<Integer> out) {
        int count = Low.common(a.common(), b.common());
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Owned.enter(a.mesh());
        try {
            Owned.enter(b.mesh());
            try {
                status = Low.gphys_shape_overlaps_batch(a.kind(), a.pointer(), a.stride(), b.kind(), b.pointer(), b.stride(), count, room.pointer(), Layout.INT.bytes());
            } finally {
                Owned.leave(b.mesh());
            }
        } finally {
            Owned.leave(a.mesh());
        }
        Low.keep(a, b, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Integer> overlapsBatch(Shapes a, Shapes b) {
        return overlapsBatch(a, b, (Batch<Integer>) null);
    }

    /** What classifyPlane returns. */
    public record ClassifyPlaneResult(int side, float signedDistance) {}

    /**
     * Classify a sphere, capsule, AABB, OBB or triangle against a plane.
     * Cost: O(1).
     * @return metres, of the shape's nearest point to the plane: &gt; 0 in front, &lt; 0 behind, 0 when
     *     crossing.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types of shapes
     */
    public static ClassifyPlaneResult classifyPlane(Shape shape, Plane plane) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_classify_plane(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, plane), scratch.slot(3), scratch.slot(4));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        Low.check(status);
        return new ClassifyPlaneResult(scratch.getInt(3), scratch.getFloat(4));
    }

    /**
     * Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
     * point is shared, inside that the frustum holds the whole shape.
     * Cost: O(1).
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types of shapes
     */
    public static int classifyFrustum(Shape shape, Frustum frustum) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_classify_frustum(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, frustum), scratch.slot(3));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        Low.check(status);
        return scratch.getInt(3);
    }

    /**
     * First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
     * and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
     * always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
     * all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
     * distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
     * docs/accuracy.md has the bounds of all functions.
     * Cost: O(1); O(log n) expected for a mesh.
     * @return empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or a segment as the shape
     */
    public static Optional<Hit> raycast(Shape shape, Ray ray) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_raycast(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, ray), scratch.slot(3));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * First hits of the rays with one shape, as Gamephys.raycast. A ray that hits nothing gets t =
     * INFINITY, triangle = NO_TRIANGLE and zeros in its hits element.
     * Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or a segment as the shape
     */
    public static Batch<Hit> raycastBatch(Shape shape, Batch<Ray> rays, Batch<Hit> out) {
        Scratch scratch = Scratch.get();
        int count = Low.common(rays.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_raycast_batch(shape.kind(), Low.shape(shape, scratch, 1), rays.pointer(), rays.stride(), count, room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Hit> raycastBatch(Shape shape, Batch<Ray> rays) {
        return raycastBatch(shape, rays, (Batch<Hit>) null);
    }

    /**
     * First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
     * segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
     * direction, the normal is zero.
     * Cost: as Gamephys.raycast.
     * @return empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or a segment as the shape
     */
    public static Optional<Hit> segmentTest(Shape shape, Segment segment) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_segment_test(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, segment), scratch.slot(3));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
     * triangle, frustum or mesh.
     * Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
     * Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
     * mesh.
     * @param displacement metres; may be zero
     * @return t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
     *     the sphere's centre; in double precision its dot with the displacement is never above 0. Already
     *     overlapping: t = 0, HIT_INSIDE, and the normal may be along the displacement too; where the
     *     centre itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere
     *     of radius 0 gets the hit of the ray along its path. empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or a segment as the shape
     */
    public static Optional<Hit> sweepSphere(Shape shape, Sphere sphere, Vec3 displacement) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            status = Low.gphys_shape_sweep_sphere(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, sphere), scratch.put(3, displacement), scratch.slot(4));
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /**
     * First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
     * sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
     * be the hull of its corners (Gamephys.frustumCorners).
     * Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
     * ulp of t. Point and normal are those of that contact.
     * Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.
     * @param displacement metres; may be zero
     * @return t, point and normal as in Gamephys.sweepSphere, which gives the answer for a sphere. The
     *     point is one of those where the two touch, always the same. Already overlapping, except for a
     *     sphere: t = 0, HIT_INSIDE, and point and normal of Gamephys.penetration; for a mesh that is not
     *     a hull, those of its first triangle. empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a ray or a segment as the shape, for a frustum
     *     that is not the hull of its corners, unless a sphere moves, and for other types that move
     */
    public static Optional<Hit> sweep(Shape shape, Shape moving, Vec3 displacement) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            Owned.enter(Low.mesh(moving));
            try {
                status = Low.gphys_shape_sweep(shape.kind(), Low.shape(shape, scratch, 1), moving.kind(), Low.shape(moving, scratch, 3), scratch.put(4, displacement), scratch.slot(5));
            } finally {
                Owned.leave(Low.mesh(moving));
            }
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape, moving);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /**
     * First contacts of count moving shapes of one type with the shapes of another, as Gamephys.sweep:
     * moving[i] with shapes[i]. One that touches nothing gets t = INFINITY, triangle = NO_TRIANGLE and
     * zeros.
     * Cost: that of as many single calls. Since 1.1.
     * @param shapes shapes of one type
     * @param moving shapes of one type
     * @param displacements metres
     * @throws GamephysException with ERROR_UNSUPPORTED: as Gamephys.sweep
     */
    public static Batch<Hit> sweepBatch(Shapes shapes, Shapes moving, Batch<Vec3> displacements, Batch<Hit> out) {
        int count = Low.common(shapes.common(), moving.common(), displacements.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Owned.enter(shapes.mesh());
        try {
            Owned.enter(moving.mesh());
            try {
                status = Low.gphys_shape_sweep_batch(shapes.kind(), shapes.pointer(), shapes.stride(), moving.kind(), moving.pointer(), moving.stride(), displacements.pointer(), displacements.stride(), count, room.pointer(), Hit.LAYOUT.bytes());
            } finally {
                Owned.leave(moving.mesh());
            }
        } finally {
            Owned.leave(shapes.mesh());
        }
        Low.keep(shapes, moving, displacements, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Hit> sweepBatch(Shapes shapes, Shapes moving, Batch<Vec3> displacements) {
        return sweepBatch(shapes, moving, displacements, (Batch<Hit>) null);
    }

    /**
     * The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
     * OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
     * that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
     * translations of their own. Of a hull: out of all of it, and triangle is NO_TRIANGLE. A frustum must
     * be the hull of its corners (Gamephys.frustumCorners).
     * Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
     * ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
     * shape. Added to float positions, the translation may leave an overlap as large as the spacing of
     * floats there.
     * Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
     * separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
     * Keerthi 1988).
     * @return depth and normal of the translation, which is their product; of several equally short ones
     *     always the same one. The deepest point of the solid is point - depth * normal. empty if nothing
     *     is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for rays, segments, frusta that are not the hull
     *     of their corners, and for other types that move
     */
    public static Optional<Penetration> penetration(Shape shape, Shape moving) {
        Scratch scratch = Scratch.get();
        int status;
        Owned.enter(Low.mesh(shape));
        try {
            Owned.enter(Low.mesh(moving));
            try {
                status = Low.gphys_shape_penetration(shape.kind(), Low.shape(shape, scratch, 1), moving.kind(), Low.shape(moving, scratch, 3), scratch.slot(4));
            } finally {
                Owned.leave(Low.mesh(moving));
            }
        } finally {
            Owned.leave(Low.mesh(shape));
        }
        Low.keep(shape, moving);
        return Low.found(status) ? Optional.of(Penetration.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /**
     * The shortest translations that take the shapes of one type out of the shapes of another, as
     * Gamephys.penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY,
     * triangle = NO_TRIANGLE and zeros.
     * Cost: that of as many single calls. Since 1.1.
     * @param shapes shapes of one type
     * @param moving shapes of one type
     * @throws GamephysException with ERROR_UNSUPPORTED: as Gamephys.penetration
     */
    public static Batch<Penetration> penetrationBatch(Shapes shapes, Shapes moving, Batch<Penetration> out) {
        int count = Low.common(shapes.common(), moving.common());
        Batch<Penetration> room = Batch.room(Penetration.LAYOUT, count, out);
        int status;
        Owned.enter(shapes.mesh());
        try {
            Owned.enter(moving.mesh());
            try {
                status = Low.gphys_shape_penetration_batch(shapes.kind(), shapes.pointer(), shapes.stride(), moving.kind(), moving.pointer(), moving.stride(), count, room.pointer(), Penetration.LAYOUT.bytes());
            } finally {
                Owned.leave(moving.mesh());
            }
        } finally {
            Owned.leave(shapes.mesh());
        }
        Low.keep(shapes, moving, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Penetration> penetrationBatch(Shapes shapes, Shapes moving) {
        return penetrationBatch(shapes, moving, (Batch<Penetration>) null);
    }

    /**
     * The eight corners, each the intersection of three planes: near then far, each in the order
     * left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
     * intersections themselves, not rounded to floats) if each is within MAX_COORDINATE and in front of
     * the three planes that do not meet there, by more than 2^-39 of its distance from origin; that is,
     * unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and
     * pushed out of it; for the bounds of their errors, origin counts as a corner.
     * Cost: O(1).
     * @return empty if three planes do not meet in a point (infinite far plane), or meet beyond the
     *     largest float.
     */
    public static Optional<java.util.List<Vec3>> frustumCorners(Frustum frustum) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_frustum_corners(scratch.put(0, frustum), scratch.slot(1));
        return Low.found(status) ? Optional.of(scratch.list(1, 8, Vec3.LAYOUT)) : Optional.empty();
    }

    /**
     * The point that three planes have in common, within an ulp of each coordinate.
     * Cost: O(1). Source: Cramer's rule. Since 1.1.
     * @return empty if the planes have no single point in common, which is decided exactly, or one beyond
     *     MAX_COORDINATE.
     */
    public static Optional<Vec3> planesIntersection(Plane a, Plane b, Plane c) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_planes_intersection(scratch.put(0, a), scratch.put(1, b), scratch.put(2, c), scratch.slot(3));
        return Low.found(status) ? Optional.of(Vec3.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * The points of the triples of planes, as Gamephys.planesIntersection; one without gets x = y = z =
     * INFINITY.
     * Cost: that of as many single calls. Since 1.1.
     * @param a the planes
     * @param b the planes
     * @param c the planes
     */
    public static Batch<Vec3> planesIntersectionBatch(Batch<Plane> a, Batch<Plane> b, Batch<Plane> c, Batch<Vec3> out) {
        int count = Low.common(a.common(), b.common(), c.common());
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status = Low.gphys_planes_intersection_batch(a.pointer(), a.stride(), b.pointer(), b.stride(), c.pointer(), c.stride(), count, room.pointer(), Vec3.LAYOUT.bytes());
        Low.keep(a, b, c, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public static Batch<Vec3> planesIntersectionBatch(Batch<Plane> a, Batch<Plane> b, Batch<Plane> c) {
        return planesIntersectionBatch(a, b, c, (Batch<Vec3>) null);
    }

    /**
     * How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
     * the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
     * for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
     * Cost: O(1). Since 1.1.
     * @param matrix elements within MAX_COORDINATE
     */
    public static float mat4Orthonormality(Mat4 matrix) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_mat4_orthonormality(scratch.put(0, matrix), scratch.slot(1));
        Low.check(status);
        return scratch.getFloat(1);
    }

    /**
     * The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
     * origin (0, 0, 0). For a camera, Camera.getFrustum is more precise.
     * Cost: O(1).
     * @param reverseZ false: near has the low depth; true: near has the high depth
     * @throws GamephysException with ERROR_SINGULAR: if the matrix has no inverse, or what it shows has no
     *     volume: its four near corners are not all finite points in front of the viewer
     */
    public static Frustum frustumFromMatrix(Mat4 viewProjection, int depthRange, boolean reverseZ) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_frustum_from_matrix(scratch.put(0, viewProjection), depthRange, reverseZ ? 1 : 0, scratch.slot(3));
        Low.check(status);
        return Frustum.read(scratch.memory, Scratch.at(3));
    }

    /**
     * Examine arrays without building anything. Allocates while it runs.
     * Cost: O(n log n).
     * @param vertices elements of 3 floats, metres
     * @param indices numbers, three for each triangle
     * @return what was found; indices out of range and bad vertices are counted, not refused.
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for an indexCount that is no multiple of 3
     */
    public static MeshReport meshCheck(Batch<Float> vertices, Batch<Integer> indices) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_mesh_check(vertices.pointer(), vertices.stride(12), vertices.size(3), indices.pointer(), indices.size(), scratch.slot(5));
        Low.keep(vertices, indices);
        Low.check(status);
        return MeshReport.read(scratch.memory, Scratch.at(5));
    }
}
