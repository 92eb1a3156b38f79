// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.util.Optional;

/**
 * <pre>
 * Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
 * segments or points that they are, and the report counts them. 0 triangles are allowed.
 * Throws GamephysException with ERROR_INVALID_ARGUMENT for an index out of range, an indexCount that
 * is no multiple of 3 or a bad vertex; Gamephys.meshCheck tells which.
 * Cost: O(n log n), about 1 us per triangle.
 * </pre>
 */
public final class Mesh extends Owned implements Shape {
    public Mesh(Batch<Float> vertices, Batch<Integer> indices, MeshDesc desc) {
        super(create(vertices, indices, desc), Low::gphys_mesh_destroy);
    }

    public Mesh(Batch<Float> vertices, Batch<Integer> indices) {
        super(create(vertices, indices, (MeshDesc) null), Low::gphys_mesh_destroy);
    }

    private static Pointer create(Batch<Float> vertices, Batch<Integer> indices, MeshDesc desc) {
        return Low.create(made -> {
            int status = Low.gphys_mesh_create(desc == null ? null : desc.pointer(), vertices.pointer(), vertices.stride(12), vertices.size(3), indices.pointer(), indices.size(), made);
            Low.keep(desc, vertices, indices);
            return status;
        });
    }

    private Mesh(Pointer made) {
        super(made, Low::gphys_mesh_destroy);
    }

    /**
     * <pre>
     * Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
     * wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
     * stay outside and are pushed out. A ray that starts inside hits at t = 0 with HIT_INSIDE; one from
     * outside hits the face through which it enters, `triangle` says where. Whether a ray hits and whether
     * a point is inside is exact with respect to the points. Inside, the closest point is the point itself
     * and triangle NO_TRIANGLE. Mesh.overlap lists the triangles of the surface; Mesh.raycastAll gives
     * only the first hit. The vertices are the points that are corners of the hull, in their original
     * order; of equal points the first. The triangles come face by face, all that lie in one plane being
     * one face; seen from outside their corners go counterclockwise where axes are right-handed, and the
     * normal cross(b - a, c - a) points out.
     *   - desc: deformable must be 0
     *   - points: elements of 3 floats, metres; copied
     * Throws GamephysException with ERROR_INVALID_ARGUMENT if a point is out of range or if all lie in a
     * plane, which is decided exactly.
     * Throws GamephysException with ERROR_CAPACITY if the hull has more than 256 faces.
     * Throws GamephysException with ERROR_UNSUPPORTED if desc asks for a deformable mesh.
     * Cost: O(pointCount * faces); allocates. Rays take O(log faces), other queries up to O(faces).
     * Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.
     * </pre>
     */
    public static Mesh hull(Batch<Float> points, MeshDesc desc) {
        return new Mesh(createHull(points, desc));
    }

    /**
     * <pre>
     * Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
     * wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
     * stay outside and are pushed out. A ray that starts inside hits at t = 0 with HIT_INSIDE; one from
     * outside hits the face through which it enters, `triangle` says where. Whether a ray hits and whether
     * a point is inside is exact with respect to the points. Inside, the closest point is the point itself
     * and triangle NO_TRIANGLE. Mesh.overlap lists the triangles of the surface; Mesh.raycastAll gives
     * only the first hit. The vertices are the points that are corners of the hull, in their original
     * order; of equal points the first. The triangles come face by face, all that lie in one plane being
     * one face; seen from outside their corners go counterclockwise where axes are right-handed, and the
     * normal cross(b - a, c - a) points out.
     *   - desc: deformable must be 0
     *   - points: elements of 3 floats, metres; copied
     * Throws GamephysException with ERROR_INVALID_ARGUMENT if a point is out of range or if all lie in a
     * plane, which is decided exactly.
     * Throws GamephysException with ERROR_CAPACITY if the hull has more than 256 faces.
     * Throws GamephysException with ERROR_UNSUPPORTED if desc asks for a deformable mesh.
     * Cost: O(pointCount * faces); allocates. Rays take O(log faces), other queries up to O(faces).
     * Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.
     * </pre>
     */
    public static Mesh hull(Batch<Float> points) {
        return new Mesh(createHull(points, (MeshDesc) null));
    }

    private static Pointer createHull(Batch<Float> points, MeshDesc desc) {
        return Low.create(made -> {
            int status = Low.gphys_mesh_create_hull(desc == null ? null : desc.pointer(), points.pointer(), points.stride(12), points.size(3), made);
            Low.keep(desc, points);
            return status;
        });
    }

    /**
     * <pre>
     * Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
     * snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
     * checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
     * any other; only the counts of its report (triangles of zero area, open edges) are taken from the
     * words as they are.
     *   - desc: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
     * Throws GamephysException with ERROR_INVALID_ARGUMENT for words that are no snapshot of a mesh,
     * damaged, of a later format or of another byte order.
     * Throws GamephysException with ERROR_UNSUPPORTED for a deformable hull.
     * Cost: O(n), a small part of Mesh's; allocates.
     * </pre>
     */
    public Mesh(Batch<Integer> words, MeshDesc desc) {
        super(create(words, desc), Low::gphys_mesh_destroy);
    }

    /**
     * <pre>
     * Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
     * snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
     * checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
     * any other; only the counts of its report (triangles of zero area, open edges) are taken from the
     * words as they are.
     *   - desc: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
     * Throws GamephysException with ERROR_INVALID_ARGUMENT for words that are no snapshot of a mesh,
     * damaged, of a later format or of another byte order.
     * Throws GamephysException with ERROR_UNSUPPORTED for a deformable hull.
     * Cost: O(n), a small part of Mesh's; allocates.
     * </pre>
     */
    public Mesh(Batch<Integer> words) {
        super(create(words, (MeshDesc) null), Low::gphys_mesh_destroy);
    }

    private static Pointer create(Batch<Integer> words, MeshDesc desc) {
        return Low.create(made -> {
            int status = Low.gphys_mesh_create_from_snapshot(desc == null ? null : desc.pointer(), words.pointer(), words.size(), made);
            Low.keep(desc, words);
            return status;
        });
    }

    /**
     * <pre>
     * A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh.setVertices does to
     * it is seen by all its models. It gives the meshes of a restored scene, which are not deformable if
     * they were embedded in its snapshot.
     * Result: a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.
     * Throws GamephysException with ERROR_UNSUPPORTED if the model's shape is no mesh.
     * Cost: O(1). Since 1.1.
     * </pre>
     */
    public Mesh(Scene scene, int model) {
        super(create(scene, model), Low::gphys_mesh_destroy);
    }

    private static Pointer create(Scene scene, int model) {
        return Low.create(made -> {
            int status;
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_scene_get_mesh(scene_, model, made);
            } finally {
                Owned.leave(scene);
            }
            Low.keep(scene);
            return status;
        });
    }

    /**
     * <pre>
     * Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
     * be hit by rays, picked, overlapped and culled as models of scenes (Scene.add with SHAPE_MESH;
     * without a transform the model is where the body is) or queried by shape_* and mesh_* functions.
     * Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
     * Solver.getTriangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the link
     * from particle t to t + 1, a capsule with the smaller of their radii, present while a constraint
     * holds them together; n - 1 + p is particle p, a sphere, present where no link beside it is as thick.
     * Free particles are spheres, and `triangle` is the particle. Solver.getNearestParticle finds the
     * particle of a hit. The mesh has the new form when Solver.step, Solver.advance, Solver.restore or an
     * edit of the body returns. When cloth tears (Break), its triangles keep their numbers, and the mesh
     * gets vertices for the new particles. A model that would leave the range of the world, and a torn
     * mesh or one of less than 2^-32 m for which there is no memory, keep their form until they can
     * follow. Solver.setOrigin moves the coordinates of the mesh, and the models back by as much: they
     * stay where they are in the world, exactly if scenes have moved their origin before. Bodies neither
     * collide with models of such meshes nor wake because of them: BodyDesc.body_layers sets which bodies
     * collide. A restored body is followed if it has the same id and parts as before. Restore the solver
     * before the scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that
     * follows nothing; Scene.setShape gives its model one that does. Mesh and solver are destroyed in any
     * order. When the body is gone the mesh keeps the form that it had last and is deformable by
     * Mesh.setVertices, which returns ERROR_UNSUPPORTED before. A mesh that neither its handle nor a model
     * holds follows no more.
     * Threads: the functions above become edits of the mesh and of each scene that has a model of it.
     *   - desc: the mesh is deformable whatever it says
     * Cost: as Mesh, and then that of Mesh.setVertices for a body that has moved; one that rests is
     * compared, O(particles). Since 1.1.
     * </pre>
     */
    public Mesh(Solver solver, int body, MeshDesc desc) {
        super(create(solver, body, desc), Low::gphys_mesh_destroy);
    }

    /**
     * <pre>
     * Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
     * be hit by rays, picked, overlapped and culled as models of scenes (Scene.add with SHAPE_MESH;
     * without a transform the model is where the body is) or queried by shape_* and mesh_* functions.
     * Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
     * Solver.getTriangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the link
     * from particle t to t + 1, a capsule with the smaller of their radii, present while a constraint
     * holds them together; n - 1 + p is particle p, a sphere, present where no link beside it is as thick.
     * Free particles are spheres, and `triangle` is the particle. Solver.getNearestParticle finds the
     * particle of a hit. The mesh has the new form when Solver.step, Solver.advance, Solver.restore or an
     * edit of the body returns. When cloth tears (Break), its triangles keep their numbers, and the mesh
     * gets vertices for the new particles. A model that would leave the range of the world, and a torn
     * mesh or one of less than 2^-32 m for which there is no memory, keep their form until they can
     * follow. Solver.setOrigin moves the coordinates of the mesh, and the models back by as much: they
     * stay where they are in the world, exactly if scenes have moved their origin before. Bodies neither
     * collide with models of such meshes nor wake because of them: BodyDesc.body_layers sets which bodies
     * collide. A restored body is followed if it has the same id and parts as before. Restore the solver
     * before the scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that
     * follows nothing; Scene.setShape gives its model one that does. Mesh and solver are destroyed in any
     * order. When the body is gone the mesh keeps the form that it had last and is deformable by
     * Mesh.setVertices, which returns ERROR_UNSUPPORTED before. A mesh that neither its handle nor a model
     * holds follows no more.
     * Threads: the functions above become edits of the mesh and of each scene that has a model of it.
     *   - desc: the mesh is deformable whatever it says
     * Cost: as Mesh, and then that of Mesh.setVertices for a body that has moved; one that rests is
     * compared, O(particles). Since 1.1.
     * </pre>
     */
    public Mesh(Solver solver, int body) {
        super(create(solver, body, (MeshDesc) null), Low::gphys_mesh_destroy);
    }

    private static Pointer create(Solver solver, int body, MeshDesc desc) {
        return Low.create(made -> {
            int status;
            Pointer solver_ = Owned.enter(solver);
            try {
                status = Low.gphys_mesh_create_from_body(desc == null ? null : desc.pointer(), solver_, body, made);
            } finally {
                Owned.leave(solver);
            }
            Low.keep(desc, solver);
            return status;
        });
    }

    /**
     * The planes of a hull's faces: normals are unit and point out, within float32 rounding.
     * Cost: O(faces). Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a mesh that is no hull
     */
    public Batch<Plane> getHullPlanes() {
        return Low.list(Plane.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_hull_planes(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * For each triangle of a hull the index of its face in the list of Mesh.getHullPlanes, ascending from
     * 0.
     * Cost: O(triangles). Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a mesh that is no hull
     */
    public Batch<Integer> getHullFaces() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_hull_faces(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
     * Solver.getPositions writes it. All models of the mesh take the new form at once, in every scene, and
     * all answers have the same bits as those of a mesh created from the new vertices. A call that fails
     * leaves the mesh and the scenes as they were. A solver sees the new form at its next step, as a
     * surface that stands still.
     * Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on
     * these.
     * Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
     * refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far that
     * the boxes of their groups of eight have twice the area, once as much as creating it. Allocates.
     * Since 1.1.
     * @param vertices elements of 3 floats, metres; copied
     * @throws GamephysException with ERROR_UNSUPPORTED: if the mesh is not deformable
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for a vertex that is not finite or too large,
     *     or if a model of the mesh would reach beyond the range of coordinates
     */
    public void setVertices(Batch<Float> vertices) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_set_vertices(self, vertices.pointer(), vertices.stride(12), vertices.size(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, vertices);
        Low.check(status);
    }

    /**
     * Kind and size of a mesh, and whether its vertices change.
     * Cost: O(1). Since 1.1.
     */
    public MeshInfo getInfo() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_get_info(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return MeshInfo.read(scratch.memory, Scratch.at(1));
    }

    /**
     * What the mesh was built from: the report that Gamephys.meshCheck makes of its arrays.
     * Cost: O(1); O(triangles) for a deformable mesh.
     */
    public MeshReport getReport() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_get_report(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return MeshReport.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Copy the vertices out, in metres and in their original order.
     * Cost: O(vertices).
     */
    public Batch<Vec3> getVertices() {
        return Low.list(Vec3.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_vertices(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Copy the indices out, three for each triangle, in their original order.
     * Cost: O(n).
     */
    public Batch<Integer> getIndices() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_indices(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Copy a mesh out with its tree, from which Mesh makes it without building the tree.
     * Threads: any.
     * Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.
     * @return the snapshot. Words are in the machine's byte order. Every later release of the same major
     *     version reads it.
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^32 - 1 words
     */
    public Batch<Integer> getSnapshot() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_snapshot(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
     * Cost: O(log n + k) expected.
     */
    public Batch<Hit> raycastAll(Ray ray) {
        Scratch scratch = Scratch.get();
        return Low.list(Hit.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_raycast_all(self, scratch.put(1, ray), room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Whether a ray hits anything; cheaper than the closest hit.
     * Cost: O(log n) expected.
     */
    public boolean raycastAny(Ray ray) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_raycast_any(self, scratch.put(1, ray), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(2) != 0;
    }

    /**
     * Whether each of the rays hits anything, as Mesh.raycastAny.
     * Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1.
     */
    public Batch<Integer> raycastAnyBatch(Batch<Ray> rays, Batch<Integer> out) {
        int count = Low.common(rays.common());
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_raycast_any_batch(self, rays.pointer(), rays.stride(), count, room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> raycastAnyBatch(Batch<Ray> rays) {
        return raycastAnyBatch(rays, (Batch<Integer>) null);
    }

    /**
     * How far each of the rays goes, and which triangle it hits: t and triangle of Gamephys.raycastBatch
     * for the mesh, with the same bits, without the rest of a hit; model is 0.
     * Cost: less than that of Gamephys.raycastBatch. Since 1.1.
     * @return a ray that hits nothing gets t = INFINITY and triangle = NO_TRIANGLE.
     */
    public Batch<Distance> raycastDistanceBatch(Batch<Ray> rays, Batch<Distance> out) {
        int count = Low.common(rays.common());
        Batch<Distance> room = Batch.room(Distance.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_raycast_distance_batch(self, rays.pointer(), rays.stride(), count, room.pointer(), Distance.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Distance> raycastDistanceBatch(Batch<Ray> rays) {
        return raycastDistanceBatch(rays, (Batch<Distance>) null);
    }

    /**
     * Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
     * ascending.
     * Cost: O(log n + k) expected.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types of shapes
     */
    public Batch<Integer> overlap(Shape shape) {
        Scratch scratch = Scratch.get();
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(Low.mesh(shape));
                    try {
                        status = Low.gphys_mesh_overlap(self, shape.kind(), Low.shape(shape, scratch, 2), room, capacity, total);
                    } finally {
                        Owned.leave(Low.mesh(shape));
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shape);
                return status;
            });
    }

    /**
     * How the mesh's octree is made up.
     * Cost: O(nodes).
     */
    public OctreeStats getOctreeStats() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_mesh_get_octree_stats(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return OctreeStats.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Boxes of the mesh's octree, each parent before its children.
     * Cost: O(nodes).
     */
    public Batch<OctreeBox> getOctreeBoxes() {
        return Low.list(OctreeBox.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_mesh_get_octree_boxes(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    @Override
    public int kind() {
        return Gamephys.SHAPE_MESH;
    }
}
