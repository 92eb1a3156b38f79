// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
using System;
using System.Runtime.InteropServices;
using static Gamephys.Support;

namespace Gamephys {

/// <summary>Owns a gphys_mesh: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Mesh : IDisposable {
    internal readonly MeshHandle Handle;

    /// <summary>Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
    /// segments or points that they are, and the report counts them. 0 triangles are allowed.
    /// Cost: O(n log n), about 1 us per triangle.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for an index out of range, an
    /// indexCount that is no multiple of 3 or a bad vertex; Geometry.MeshCheck tells which</exception>
    public unsafe Mesh(ReadOnlySpan<Vec3> vertices, ReadOnlySpan<uint> indices, MeshDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        fixed (Vec3* vertices_ = &MemoryMarshal.GetReference(vertices))
        fixed (uint* indices_ = &MemoryMarshal.GetReference(indices))
        Check(Low.gphys_mesh_create(desc.HasValue ? &desc_ : null, (float*)vertices_, SizeOf(vertices), (uint)vertices.Length, indices_, (uint)indices.Length, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
    /// wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
    /// stay outside and are pushed out. A ray that starts inside hits at t = 0 with HitInside; one from
    /// outside hits the face through which it enters, `triangle` says where. Whether a ray hits and whether
    /// a point is inside is exact with respect to the points. Inside, the closest point is the point itself
    /// and triangle NoTriangle. Mesh.Overlap lists the triangles of the surface; Mesh.RaycastAll gives only
    /// the first hit. The vertices are the points that are corners of the hull, in their original order; of
    /// equal points the first. The triangles come face by face, all that lie in one plane being one face;
    /// seen from outside their corners go counterclockwise where axes are right-handed, and the normal
    /// cross(b - a, c - a) points out.
    /// Cost: O(pointCount * faces); allocates. Rays take O(log faces), other queries up to O(faces).
    /// Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.</summary>
    /// <param name="desc">deformable must be 0</param>
    /// <param name="points">elements of 3 floats, metres; copied</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if a point is out of range or if
    /// all lie in a plane, which is decided exactly</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: if the hull has more than 256
    /// faces</exception>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if desc asks for a deformable
    /// mesh</exception>
    public unsafe Mesh(ReadOnlySpan<Vec3> points, MeshDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        Check(Low.gphys_mesh_create_hull(desc.HasValue ? &desc_ : null, (float*)points_, SizeOf(points), (uint)points.Length, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
    /// snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
    /// checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
    /// any other; only the counts of its report (triangles of zero area, open edges) are taken from the
    /// words as they are.
    /// Cost: O(n), a small part of Mesh's; allocates.</summary>
    /// <param name="desc">with `deformable` the mesh takes new vertices, even if the one in the snapshot
    /// did not</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for words that are no snapshot of a
    /// mesh, damaged, of a later format or of another byte order</exception>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a deformable hull</exception>
    public unsafe Mesh(ReadOnlySpan<uint> words, MeshDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        fixed (uint* words_ = &MemoryMarshal.GetReference(words))
        Check(Low.gphys_mesh_create_from_snapshot(desc.HasValue ? &desc_ : null, words_, (uint)words.Length, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh.SetVertices does to
    /// it is seen by all its models. It gives the meshes of a restored scene, which are not deformable if
    /// they were embedded in its snapshot.
    /// Cost: O(1). Since 1.1.</summary>
    /// <returns>a reference of its own, which keeps the mesh alive, and is to be destroyed like any
    /// handle.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the model's shape is no
    /// mesh</exception>
    public unsafe Mesh(Scene scene, uint model) {
        IntPtr made;
        Check(Low.gphys_scene_get_mesh(scene.Handle, model, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
    /// be hit by rays, picked, overlapped and culled as models of scenes (Scene.Add with ShapeType.Mesh;
    /// without a transform the model is where the body is) or queried by shape_* and mesh_* functions.
    /// Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
    /// Solver.GetTriangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the link
    /// from particle t to t + 1, a capsule with the smaller of their radii, present while a constraint
    /// holds them together; n - 1 + p is particle p, a sphere, present where no link beside it is as thick.
    /// Free particles are spheres, and `triangle` is the particle. Solver.GetNearestParticle finds the
    /// particle of a hit. The mesh has the new form when Solver.Step, Solver.Advance, Solver.Restore or an
    /// edit of the body returns. When cloth tears (Break), its triangles keep their numbers, and the mesh
    /// gets vertices for the new particles. A model that would leave the range of the world, and a torn
    /// mesh or one of less than 2^-32 m for which there is no memory, keep their form until they can
    /// follow. Solver.SetOrigin moves the coordinates of the mesh, and the models back by as much: they
    /// stay where they are in the world, exactly if scenes have moved their origin before. Bodies neither
    /// collide with models of such meshes nor wake because of them: BodyDesc.body_layers sets which bodies
    /// collide. A restored body is followed if it has the same id and parts as before. Restore the solver
    /// before the scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that
    /// follows nothing; Scene.SetShape gives its model one that does. Mesh and solver are destroyed in any
    /// order. When the body is gone the mesh keeps the form that it had last and is deformable by
    /// Mesh.SetVertices, which returns Status.ErrorUnsupported before. A mesh that neither its handle nor a
    /// model holds follows no more.
    /// Threads: the functions above become edits of the mesh and of each scene that has a model of it.
    /// Cost: as Mesh, and then that of Mesh.SetVertices for a body that has moved; one that rests is
    /// compared, O(particles). Since 1.1.</summary>
    /// <param name="desc">the mesh is deformable whatever it says</param>
    public unsafe Mesh(Solver solver, uint body, MeshDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_mesh_create_from_body(desc.HasValue ? &desc_ : null, solver.Handle, body, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>The planes of a hull's faces: normals are unit and point out, within float32 rounding.
    /// Cost: O(faces). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a mesh that is no hull</exception>
    public unsafe Plane[] GetHullPlanes() {
        var result = new Plane[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Plane* out_ = result)
            status = Low.gphys_mesh_get_hull_planes(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Plane[total];
        }
    }

    /// <summary>For each triangle of a hull the index of its face in the list of Mesh.GetHullPlanes, ascending from
    /// 0.
    /// Cost: O(triangles). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a mesh that is no hull</exception>
    public unsafe uint[] GetHullFaces() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_mesh_get_hull_faces(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
    /// Solver.GetPositions writes it. All models of the mesh take the new form at once, in every scene, and
    /// all answers have the same bits as those of a mesh created from the new vertices. A call that fails
    /// leaves the mesh and the scenes as they were. A solver sees the new form at its next step, as a
    /// surface that stands still.
    /// Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on
    /// these.
    /// Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
    /// refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far that
    /// the boxes of their groups of eight have twice the area, once as much as creating it. Allocates.
    /// Since 1.1.</summary>
    /// <param name="vertices">elements of 3 floats, metres; copied</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the mesh is not
    /// deformable</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for a vertex that is not finite or
    /// too large, or if a model of the mesh would reach beyond the range of coordinates</exception>
    public unsafe void SetVertices(ReadOnlySpan<Vec3> vertices) {
        fixed (Vec3* vertices_ = &MemoryMarshal.GetReference(vertices))
        Check(Low.gphys_mesh_set_vertices(Handle, (float*)vertices_, SizeOf(vertices), (uint)vertices.Length));
    }

    /// <summary>Kind and size of a mesh, and whether its vertices change.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe MeshInfo GetInfo() {
        var info = default(MeshInfo);
        Check(Low.gphys_mesh_get_info(Handle, &info));
        return info;
    }

    /// <summary>What the mesh was built from: the report that Geometry.MeshCheck makes of its arrays.
    /// Cost: O(1); O(triangles) for a deformable mesh.</summary>
    public unsafe MeshReport GetReport() {
        var report = default(MeshReport);
        Check(Low.gphys_mesh_get_report(Handle, &report));
        return report;
    }

    /// <summary>Copy the vertices out, in metres and in their original order.
    /// Cost: O(vertices).</summary>
    public unsafe Vec3[] GetVertices() {
        var result = new Vec3[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Vec3* out_ = result)
            status = Low.gphys_mesh_get_vertices(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Vec3[total];
        }
    }

    /// <summary>Copy the indices out, three for each triangle, in their original order.
    /// Cost: O(n).</summary>
    public unsafe uint[] GetIndices() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_mesh_get_indices(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Copy a mesh out with its tree, from which Mesh makes it without building the tree.
    /// Threads: any.
    /// Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.</summary>
    /// <returns>the snapshot. Words are in the machine's byte order. Every later release of the same major
    /// version reads it.</returns>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^32 - 1 words</exception>
    public unsafe uint[] GetSnapshot() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_mesh_get_snapshot(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
    /// Cost: O(log n + k) expected.</summary>
    public unsafe Hit[] RaycastAll(Ray ray) {
        var result = new Hit[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Hit* out_ = result)
            status = Low.gphys_mesh_raycast_all(Handle, &ray, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Hit[total];
        }
    }

    /// <summary>Whether a ray hits anything; cheaper than the closest hit.
    /// Cost: O(log n) expected.</summary>
    public unsafe bool RaycastAny(Ray ray) {
        var hit = default(int);
        Check(Low.gphys_mesh_raycast_any(Handle, &ray, &hit));
        return hit != 0;
    }

    /// <summary>Whether each of the rays hits anything, as Mesh.RaycastAny.
    /// Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1.</summary>
    public unsafe void RaycastAnyBatch(ReadOnlySpan<Ray> rays, Span<int> hits) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (int* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_mesh_raycast_any_batch(Handle, rays_, StrideOf(rays), count, hits_, (uint)sizeof(int)));
    }

    /// <summary>How far each of the rays goes, and which triangle it hits: t and triangle of Geometry.RaycastBatch
    /// for the mesh, with the same bits, without the rest of a hit; model is 0.
    /// Cost: less than that of Geometry.RaycastBatch. Since 1.1.</summary>
    /// <returns>a ray that hits nothing gets t = INFINITY and triangle = NoTriangle.</returns>
    public unsafe void RaycastDistanceBatch(ReadOnlySpan<Ray> rays, Span<Distance> distances) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(distances.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (Distance* distances_ = &MemoryMarshal.GetReference(distances))
        Check(Low.gphys_mesh_raycast_distance_batch(Handle, rays_, StrideOf(rays), count, distances_, (uint)sizeof(Distance)));
    }

    /// <summary>Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
    /// ascending.
    /// Cost: O(log n + k) expected.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types of shapes</exception>
    public unsafe uint[] Overlap(Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_mesh_overlap(Handle, shape.Type, shape_, out_, (uint)result.Length, &total);
            GC.KeepAlive(shape.Mesh);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>How the mesh's octree is made up.
    /// Cost: O(nodes).</summary>
    public unsafe OctreeStats GetOctreeStats() {
        var stats = default(OctreeStats);
        Check(Low.gphys_mesh_get_octree_stats(Handle, &stats));
        return stats;
    }

    /// <summary>Boxes of the mesh's octree, each parent before its children.
    /// Cost: O(nodes).</summary>
    public unsafe OctreeBox[] GetOctreeBoxes() {
        var result = new OctreeBox[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (OctreeBox* out_ = result)
            status = Low.gphys_mesh_get_octree_boxes(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new OctreeBox[total];
        }
    }

}

/// <summary>Owns a gphys_scene: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Scene : IDisposable {
    internal readonly SceneHandle Handle;

    /// <summary>Create a scene without models. With a worker_count of n, all batch queries of the scene
    /// (Camera.PickBatch too), and adding and moving many models, share their work among n threads; the
    /// results have the same bits for every n. Without a task_runner n - 1 threads are started here and
    /// joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
    /// own thread alone. They take no signals but faults, and have the standard floating-point settings. In
    /// a child of fork they are gone: calls there run on one thread, as they do on a platform without
    /// threads (WebAssembly, unless built for shared memory), whatever is asked for.
    /// Cost: O(reserve_models), and that of starting the threads.</summary>
    /// <param name="desc">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: also if the threads cannot be
    /// started</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: if reserve_models is above 2^24 -
    /// 1</exception>
    public unsafe Scene(SceneDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_scene_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new SceneHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>Change the number of threads that share the calls of a scene, for example when the user changes a
    /// setting. They are those of its task_runner if it was created with one. In a child of fork they are
    /// started again. Answers keep their bits.
    /// Cost: that of joining the former threads and starting others; allocates. Since 1.1.</summary>
    /// <param name="workers">as SceneDesc.worker_count</param>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: also if the threads cannot be started;
    /// the former ones are kept</exception>
    public unsafe void SetWorkerCount(uint workers) {
        Check(Low.gphys_scene_set_worker_count(Handle, workers));
    }

    /// <summary>How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
    /// of fork it is still the number that was set, though calls run on one thread.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe uint GetWorkerCount() {
        var workers = default(uint);
        Check(Low.gphys_scene_get_worker_count(Handle, &workers));
        return workers;
    }

    /// <summary>Move the point of the world that all coordinates of the scene are relative to, those passed to it
    /// and those that it returns. Models stay where they are in the world: the positions of those without a
    /// parent become what they are from there, kept in double precision and rounded to float32 once,
    /// however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
    /// and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
    /// Cost: that of Scene.SetTransforms of all models, and 24 bytes a model from the first call on.
    /// Queries cost nothing more. Allocates.</summary>
    /// <param name="origin">x, y, z in the world, within MaxCoordinate; before the first call 0 0 0</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if a model would leave the
    /// range of coordinates</exception>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_scene_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the scene's coordinates count from.
    /// Cost: O(1).</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_scene_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>Add a model.
    /// Cost: O(log n) amortised.</summary>
    /// <param name="shape">sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)</param>
    /// <param name="shape">in the model's own coordinates</param>
    /// <param name="transform">local; null is the identity</param>
    /// <param name="desc">null: no parent, layer 1, tag 0</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for another type, or a scale that the
    /// shape cannot have (Scene.SetScale)</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a stale parent</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 models</exception>
    public unsafe uint Add(Shape shape, Transform? transform = null, ModelDesc? desc = null) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var transform_ = transform.GetValueOrDefault();
        var desc_ = desc.GetValueOrDefault();
        var model = default(uint);
        var status = Low.gphys_scene_add(Handle, shape.Type, shape_, transform.HasValue ? &transform_ : null, desc.HasValue ? &desc_ : null, &model);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return model;
    }

    /// <summary>Add the models of one type, all or none, as Scene.Add does one.
    /// Fails as Scene.Add.
    /// Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
    /// is of the order of n.</summary>
    /// <param name="shapes">in the models' own coordinates</param>
    /// <param name="transforms">local; null is the identity</param>
    /// <param name="desc">for all; null: no parent, layer 1, tag 0</param>
    public unsafe void AddBatch(Shapes shapes, Span<uint> models, ReadOnlySpan<Transform> transforms = default(ReadOnlySpan<Transform>), ModelDesc? desc = null) {
        var shapesOne = shapes.One;
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, shapes.Count, Optional(transforms));
        RequireLength(models.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        status = Low.gphys_scene_add_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, transforms_, StrideOf(transforms), count, desc.HasValue ? &desc_ : null, models_);
        GC.KeepAlive(shapesOne.Mesh);
        Check(status);
    }

    /// <summary>Add the models of one type, all or none, each with a desc of its own.
    /// Fails as Scene.Add; Status.ErrorStructSize as for a single desc.
    /// Cost: as Scene.AddBatch.</summary>
    /// <param name="shapes">in the models' own coordinates</param>
    /// <param name="transforms">local; null is the identity</param>
    /// <param name="descs">one for each; null: no parent, layer 1, tag 0. Parents are models that the scene
    /// has before the call</param>
    public unsafe void AddDescribedBatch(Shapes shapes, Span<uint> models, ReadOnlySpan<Transform> transforms = default(ReadOnlySpan<Transform>), ReadOnlySpan<ModelDesc> descs = default(ReadOnlySpan<ModelDesc>)) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count, Optional(transforms), Optional(descs));
        RequireLength(models.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        fixed (ModelDesc* descs_ = &MemoryMarshal.GetReference(descs))
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        status = Low.gphys_scene_add_described_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, transforms_, StrideOf(transforms), descs_, StrideOf(descs), count, models_);
        GC.KeepAlive(shapesOne.Mesh);
        Check(status);
    }

    /// <summary>Remove a model. Its children stay where they are in the world and lose their parent.
    /// Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory.</summary>
    public unsafe void Remove(uint model) {
        Check(Low.gphys_scene_remove(Handle, model));
    }

    /// <summary>Remove models, all or none.
    /// Cost: that of as many calls of Scene.Remove. Renews the octree as far as there is memory.</summary>
    /// <param name="models">the ids; an id that appears twice is Status.ErrorInvalidId</param>
    public unsafe void RemoveBatch(ReadOnlySpan<uint> models) {
        var count = CommonLength(models.Length, 1);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        Check(Low.gphys_scene_remove_batch(Handle, models_, count));
    }

    /// <summary>Remove a model and all its descendants.
    /// Cost: O(log n) amortised for each. Renews the octree as far as there is memory.</summary>
    public unsafe void RemoveSubtree(uint model) {
        Check(Low.gphys_scene_remove_subtree(Handle, model));
    }

    /// <summary>Remove all models. Ids given out before stay invalid.
    /// Cost: O(n).</summary>
    public unsafe void Clear() {
        Check(Low.gphys_scene_clear(Handle));
    }

    /// <summary>Ids of all models, ascending.
    /// Cost: O(n).</summary>
    public unsafe uint[] GetModels() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_get_models(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of all models without a parent, ascending.
    /// Cost: O(n).</summary>
    public unsafe uint[] GetRoots() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_get_roots(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the direct children of a model, ascending.
    /// Cost: O(k log k).</summary>
    public unsafe uint[] GetChildren(uint model) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_get_children(Handle, model, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Kind, parent, layers, tag and number of children of a model.
    /// Cost: O(1).</summary>
    public unsafe ModelInfo GetInfo(uint model) {
        var info = default(ModelInfo);
        Check(Low.gphys_scene_get_info(Handle, model, &info));
        return info;
    }

    /// <summary>World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
    /// and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
    /// Cost: O(1).</summary>
    /// <returns>null for a plane.</returns>
    public unsafe Aabb? GetBounds(uint model) {
        var bounds = default(Aabb);
        var status = Low.gphys_scene_get_bounds(Handle, model, &bounds);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>World box of all bounded models. Planes are left out.
    /// Cost: O(1).</summary>
    /// <returns>null if there are none.</returns>
    public unsafe Aabb? GetSceneBounds() {
        var bounds = default(Aabb);
        var status = Low.gphys_scene_get_scene_bounds(Handle, &bounds);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>Give a model another shape, or another mesh, of any type that Scene.Add takes: a character crouches,
    /// a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
    /// transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
    /// do of any solid.
    /// Cost: as Scene.SetTransform of a model without children, whatever the size of a mesh.</summary>
    /// <param name="shape">as in Scene.Add: a struct, copied, or a mesh with ShapeType.Mesh. The scene
    /// holds the new mesh and no longer the old one, which may be the same.</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a frustum, ray or segment, and for
    /// a shape that cannot have the model's scale (Scene.SetScale)</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if the model would leave the
    /// range of the world</exception>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: </exception>
    public unsafe void SetShape(uint model, Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var status = Low.gphys_scene_set_shape(Handle, model, shape.Type, shape_);
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
    /// unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
    /// normals are those of its surface. Children and attached particles (Solver.Attach) are not affected:
    /// they follow the transform, whose scale is one number. A new scale replaces the old one. No scale
    /// mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners of each triangle.
    /// There is no form for many models: three equal numbers belong in their transforms
    /// (Scene.SetTransforms), and Scene.AddDescribedBatch takes a scale for each model that it adds. A mesh
    /// or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled vertices. Of
    /// a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule or plane,
    /// and an OBB whose own rotation is not the identity, take three equal numbers only.
    /// Cost: as Scene.SetTransform of a model without children. Models that have a scale take 16 bytes more
    /// if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to 11 %
    /// more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of the scaled
    /// vertices, whose tree is made for that form.</summary>
    /// <param name="scale">x, y, z, each from 1e-15 to 1e15</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for numbers that are not equal where
    /// they have to be, and for the mesh of a rope or of particles (Mesh) unless it is 1 1 1</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if a coordinate of the scaled
    /// shape would exceed MaxCoordinate, if a number times that of a mesh's world transform is not from
    /// 1e-15 to 1e15, or if the model would leave the range of the world</exception>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: </exception>
    public unsafe void SetScale(uint model, Vec3 scale) {
        Check(Low.gphys_scene_set_scale(Handle, model, &scale));
    }

    /// <summary>The scale of a model's own shape, 1 1 1 unless another was set.
    /// Cost: O(1).</summary>
    public unsafe Vec3 GetScale(uint model) {
        var scale = default(Vec3);
        Check(Low.gphys_scene_get_scale(Handle, model, &scale));
        return scale;
    }

    /// <summary>Change which queries see a model: those with a mask m of which layers &amp; m is not 0. Children are not
    /// affected.
    /// Cost: O(1).</summary>
    /// <param name="layers">any mask; 0: no query sees it</param>
    public unsafe void SetLayers(uint model, uint layers = Constants.AllLayers) {
        Check(Low.gphys_scene_set_layers(Handle, model, layers));
    }

    /// <summary>Change the number that a model's hits report beside its id. Children are not affected.
    /// Cost: O(1).</summary>
    /// <param name="tag">any number of the caller's</param>
    public unsafe void SetTag(uint model, uint tag) {
        Check(Low.gphys_scene_set_tag(Handle, model, tag));
    }

    /// <summary>Make a model the child of another one, or of none (0).
    /// Cost: O(depth of the tree of models), and as Scene.SetTransform for what moves. Renews the octree as
    /// far as there is memory.</summary>
    /// <param name="keepWorld">false: the local transform is kept, the model jumps; true: the local
    /// transform is changed so that the world transform stays (within float32 rounding)</param>
    /// <exception cref="GamephysException">Status.ErrorCycle: if parent is the model or one of its
    /// descendants</exception>
    public unsafe void SetParent(uint model, uint parent, bool keepWorld) {
        Check(Low.gphys_scene_set_parent(Handle, model, parent, keepWorld ? 1 : 0));
    }

    /// <summary>Set a model's local transform. Descendants follow.
    /// Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.</summary>
    /// <param name="transform">relative to the parent; scale &gt; 0</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if it, or a descendant, would
    /// leave the range of the world</exception>
    public unsafe void SetTransform(uint model, Transform transform) {
        Check(Low.gphys_scene_set_transform(Handle, model, &transform));
    }

    /// <summary>Set the local transforms of many models, all or none; a model that appears twice gets the last.
    /// Descendants follow.
    /// Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
    /// the octree as far as there is memory.</summary>
    /// <param name="models">the ids</param>
    /// <param name="transforms">as in Scene.SetTransform</param>
    public unsafe void SetTransforms(ReadOnlySpan<uint> models, ReadOnlySpan<Transform> transforms) {
        var count = CommonLength(models.Length, transforms.Length);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_set_transforms(Handle, models_, transforms_, StrideOf(transforms), count));
    }

    /// <summary>Local transforms of the models, as they were set: relative to the parent.
    /// Cost: O(elements).</summary>
    /// <param name="models">the ids; an id may appear twice</param>
    public unsafe void GetTransforms(ReadOnlySpan<uint> models, Span<Transform> transforms) {
        var count = CommonLength(models.Length, 1);
        RequireLength(transforms.Length, count);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_get_transforms(Handle, models_, count, transforms_, (uint)sizeof(Transform)));
    }

    /// <summary>World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
    /// queries are exact with respect to these.
    /// Cost: O(elements).</summary>
    /// <param name="models">the ids; an id may appear twice</param>
    public unsafe void GetWorldTransforms(ReadOnlySpan<uint> models, Span<Transform> transforms) {
        var count = CommonLength(models.Length, 1);
        RequireLength(transforms.Length, count);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_get_world_transforms(Handle, models_, count, transforms_, (uint)sizeof(Transform)));
    }

    /// <summary>Closest model on a ray; the fields are exact as in Geometry.Raycast.
    /// Cost: O(log n) expected; no allocation.</summary>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? Raycast(Ray ray, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_raycast(Handle, &ray, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>Closest models on the rays, as Scene.Raycast; a ray that hits nothing gets model = 0 and t =
    /// INFINITY.
    /// Cost: at most that of as many single calls; shared among workers.</summary>
    public unsafe void RaycastBatch(ReadOnlySpan<Ray> rays, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_batch(Handle, rays_, StrideOf(rays), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>How far each of the rays goes, and what it hits: t, model and triangle of Scene.RaycastBatch, with
    /// the same bits, without the rest of a hit. For lidars and depth images.
    /// Cost: less than that of Scene.RaycastBatch; shared among workers. Since 1.1.</summary>
    /// <returns>a ray that hits nothing gets t = INFINITY, model = 0 and triangle = NoTriangle.</returns>
    public unsafe void RaycastDistanceBatch(ReadOnlySpan<Ray> rays, Span<Distance> distances, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(distances.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (Distance* distances_ = &MemoryMarshal.GetReference(distances))
        Check(Low.gphys_scene_raycast_distance_batch(Handle, rays_, StrideOf(rays), count, layers, distances_, (uint)sizeof(Distance)));
    }

    /// <summary>Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
    /// Cost: O(log n) expected.</summary>
    public unsafe bool RaycastAny(Ray ray, uint layers = Constants.AllLayers) {
        var hit = default(int);
        Check(Low.gphys_scene_raycast_any(Handle, &ray, layers, &hit));
        return hit != 0;
    }

    /// <summary>Whether each of the rays meets anything, as Scene.RaycastAny.
    /// Cost: at most that of as many single calls; shared among workers.</summary>
    public unsafe void RaycastAnyBatch(ReadOnlySpan<Ray> rays, Span<int> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (int* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_any_batch(Handle, rays_, StrideOf(rays), count, layers, hits_, (uint)sizeof(int)));
    }

    /// <summary>Every model that a ray meets, each once with its first hit, by t, then id.
    /// Cost: O(log n + k log k) expected.</summary>
    public unsafe Hit[] RaycastAll(Ray ray, uint layers = Constants.AllLayers) {
        var result = new Hit[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Hit* out_ = result)
            status = Low.gphys_scene_raycast_all(Handle, &ray, layers, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Hit[total];
        }
    }

    /// <summary>Every model that each of the rays meets, as Scene.RaycastAll: the hits of ray i are at
    /// hits[offsets[i]] up to offsets[i + 1].
    /// The contents of hits behind the last hit are unspecified.
    /// Cost: that of as many single calls; shared among workers.</summary>
    public unsafe Ragged<Hit> RaycastAllBatch(ReadOnlySpan<Ray> rays, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        var result = new Hit[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
            fixed (Hit* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_raycast_all_batch(Handle, rays_, StrideOf(rays), count, layers, out_, (uint)result.Length, offsets_);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<Hit>(result, offsets);
            }
            result = new Hit[total];
        }
    }

    /// <summary>Closest model along a segment from a to b, both included; t in 0..1. Fields as in
    /// Geometry.SegmentTest.
    /// Cost: O(log n) expected.</summary>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? SegmentTest(Segment segment, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_segment_test(Handle, &segment, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>Closest models along the segments, as Scene.SegmentTest; one that hits nothing gets model = 0 and t
    /// = INFINITY.
    /// Cost: that of as many single calls; shared among workers.</summary>
    public unsafe void SegmentTestBatch(ReadOnlySpan<Segment> segments, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, segments.Length);
        RequireLength(hits.Length, count);
        fixed (Segment* segments_ = &MemoryMarshal.GetReference(segments))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_segment_test_batch(Handle, segments_, StrideOf(segments), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
    /// Geometry.Overlaps, ascending.
    /// Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
    /// more saves most of that, unless many models have replaced removed ones.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types of shapes</exception>
    public unsafe uint[] Overlap(Shape shape, uint layers = Constants.AllLayers) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_overlap(Handle, shape.Type, shape_, layers, out_, (uint)result.Length, &total);
            GC.KeepAlive(shape.Mesh);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of all models that each of the shapes of one type overlaps, as Scene.Overlap: those of shape i
    /// are at models[offsets[i]] up to offsets[i + 1], as in Scene.RaycastAllBatch.
    /// Cost: at most that of as many single calls; shared among workers.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as there</exception>
    public unsafe Ragged<uint> OverlapBatch(Shapes shapes, uint layers = Constants.AllLayers) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count);
        var result = new uint[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
            fixed (uint* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_overlap_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, count, layers, out_, (uint)result.Length, offsets_);
            GC.KeepAlive(shapesOne.Mesh);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<uint>(result, offsets);
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
    /// box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
    /// edges are listed, too: a few per cent more where models are compact or not rotated; about a third
    /// more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
    /// many again as are visible where they are as long as the view is wide. Scene.Overlap leaves these out
    /// by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
    /// listed is best: it is used to order them.
    /// Cost: O(log n + k) expected.</summary>
    public unsafe uint[] Cull(Frustum frustum, uint layers = Constants.AllLayers) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_cull(Handle, &frustum, layers, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the models in each of count frusta, as Scene.Cull: for split screens, cascades of shadow
    /// maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
    /// offsets[i + 1], as in Scene.RaycastAllBatch.
    /// Cost: that of as many single calls; shared among workers. Since 1.1.</summary>
    public unsafe Ragged<uint> CullBatch(ReadOnlySpan<Frustum> frusta, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, frusta.Length);
        var result = new uint[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (Frustum* frusta_ = &MemoryMarshal.GetReference(frusta))
            fixed (uint* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_cull_batch(Handle, frusta_, StrideOf(frusta), count, layers, out_, (uint)result.Length, offsets_);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<uint>(result, offsets);
            }
            result = new uint[total];
        }
    }

    /// <summary>The model nearest to a point, and its closest point.
    /// Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
    /// nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
    /// That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
    /// in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
    /// 15 us.</summary>
    /// <param name="maxDistance">metres, &gt;= 0, INFINITY allowed; a model at exactly this distance
    /// counts</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Nearest? Nearest(Vec3 point, float maxDistance = float.PositiveInfinity, uint layers = Constants.AllLayers) {
        var nearest = default(Nearest);
        var status = Low.gphys_scene_nearest(Handle, &point, maxDistance, layers, &nearest);
        return Found(status) ? nearest : (Nearest?)null;
    }

    /// <summary>The models nearest to the points, as Scene.Nearest; a point with none gets model = 0 and distance =
    /// INFINITY.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="maxDistance">metres, &gt;= 0, INFINITY allowed, for all points</param>
    public unsafe void NearestBatch(ReadOnlySpan<Vec3> points, Span<Nearest> nearest, float maxDistance = float.PositiveInfinity, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, points.Length);
        RequireLength(nearest.Length, count);
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (Nearest* nearest_ = &MemoryMarshal.GetReference(nearest))
        Check(Low.gphys_scene_nearest_batch(Handle, points_, StrideOf(points), count, maxDistance, layers, nearest_, (uint)sizeof(Nearest)));
    }

    /// <summary>First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
    /// Geometry.SweepSphere.
    /// Cost: O(log n + k) expected, k the models that the swept box touches.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? SweepSphere(Sphere sphere, Vec3 displacement, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_sweep_sphere(Handle, &sphere, &displacement, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First models that the spheres touch while each moves by its displacement, as Scene.SweepSphere; one
    /// that touches nothing gets model = 0 and t = INFINITY.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="displacements">metres</param>
    public unsafe void SweepSphereBatch(ReadOnlySpan<Sphere> spheres, ReadOnlySpan<Vec3> displacements, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, spheres.Length, displacements.Length);
        RequireLength(hits.Length, count);
        fixed (Sphere* spheres_ = &MemoryMarshal.GetReference(spheres))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_sweep_sphere_batch(Handle, spheres_, StrideOf(spheres), displacements_, StrideOf(displacements), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
    /// turning; t in 0..1. Fields as in Geometry.Sweep.
    /// Cost: O(log n + k) expected, k the models that the swept box touches.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <returns>null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types</exception>
    public unsafe Hit? Sweep(Shape shape, Vec3 displacement, uint layers = Constants.AllLayers) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_scene_sweep(Handle, shape.Type, shape_, &displacement, layers, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First models that the shapes of one type touch while each moves by its displacement, as Scene.Sweep;
    /// one that touches nothing gets model = 0 and t = INFINITY.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="displacements">metres</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Scene.Sweep</exception>
    public unsafe void SweepBatch(Shapes shapes, ReadOnlySpan<Vec3> displacements, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count, displacements.Length);
        RequireLength(hits.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        status = Low.gphys_scene_sweep_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, displacements_, StrideOf(displacements), count, layers, hits_, (uint)sizeof(Hit));
        GC.KeepAlive(shapesOne.Mesh);
        Check(status);
    }

    /// <summary>What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
    /// a mesh one for each triangle, as Geometry.Penetration. Deepest first; equal depths by model, then
    /// triangle. Each is the way out of that one alone. The models are those of Scene.Overlap.
    /// Cost: O(log n + k log k) expected.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types</exception>
    public unsafe Penetration[] Penetration(Shape shape, uint layers = Constants.AllLayers) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var result = new Penetration[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Penetration* out_ = result)
            status = Low.gphys_scene_penetration(Handle, shape.Type, shape_, layers, out_, (uint)result.Length, &total);
            GC.KeepAlive(shape.Mesh);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Penetration[total];
        }
    }

    /// <summary>What each of the shapes of one type overlaps, and how it gets out, as Scene.Penetration: the ways
    /// out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in Scene.RaycastAllBatch. So
    /// a crowd of characters is pushed out in one call.
    /// Cost: that of as many single calls; shared among workers. Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Scene.Penetration</exception>
    public unsafe Ragged<Penetration> PenetrationBatch(Shapes shapes, uint layers = Constants.AllLayers) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count);
        var result = new Penetration[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
            fixed (Penetration* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_penetration_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, count, layers, out_, (uint)result.Length, offsets_);
            GC.KeepAlive(shapesOne.Mesh);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<Penetration>(result, offsets);
            }
            result = new Penetration[total];
        }
    }

    /// <summary>Closest model on a ray that the filter sees, as Scene.Raycast.
    /// Cost: that of Scene.Raycast for one ignored model. For each model that is met within the ray's
    /// reach, besides: O(its depth below its root) with FilterSubtree if ignored_model has children; of m
    /// ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
    /// they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time.</summary>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for unknown flags, or
    /// ignored_models null with an ignored_count above 0</exception>
    public unsafe Hit? RaycastFiltered(Ray ray, QueryFilterDesc? filter = null) {
        var hit = default(Hit);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_scene_raycast_filtered(Handle, &ray, filter_.Pointer, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>Closest models on the rays that the filters see, as Scene.RaycastBatch.
    /// Cost: at most that of as many calls of Scene.RaycastFiltered; shared among workers.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe void RaycastFilteredBatch(ReadOnlySpan<Ray> rays, Span<Hit> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, rays.Length, Optional(filters));
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_filtered_batch(Handle, rays_, StrideOf(rays), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>How far each of the rays goes among the models that its filter sees, as Scene.RaycastDistanceBatch:
    /// a lidar leaves out the robot that carries it.
    /// Cost: less than that of Scene.RaycastFilteredBatch; shared among workers. Since 1.1.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe void RaycastDistanceFilteredBatch(ReadOnlySpan<Ray> rays, Span<Distance> distances, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, rays.Length, Optional(filters));
        RequireLength(distances.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Distance* distances_ = &MemoryMarshal.GetReference(distances))
        Check(Low.gphys_scene_raycast_distance_filtered_batch(Handle, rays_, StrideOf(rays), count, filters_.Pointer, filters_.Stride, distances_, (uint)sizeof(Distance)));
    }

    /// <summary>Whether a ray meets anything that the filter sees, as Scene.RaycastAny: line of sight between two
    /// models that both are left out.
    /// Cost: as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    public unsafe bool RaycastAnyFiltered(Ray ray, QueryFilterDesc? filter = null) {
        var hit = default(int);
        using (var filter_ = new QueryFilterDescs(filter))
        Check(Low.gphys_scene_raycast_any_filtered(Handle, &ray, filter_.Pointer, &hit));
        return hit != 0;
    }

    /// <summary>Whether each of the rays meets anything that its filter sees, as Scene.RaycastAnyBatch.
    /// Cost: at most that of as many single calls; shared among workers.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe void RaycastAnyFilteredBatch(ReadOnlySpan<Ray> rays, Span<int> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, rays.Length, Optional(filters));
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (int* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_any_filtered_batch(Handle, rays_, StrideOf(rays), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(int)));
    }

    /// <summary>Every model that a ray meets and the filter sees, as Scene.RaycastAll.
    /// Cost: that of Scene.RaycastAll, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    public unsafe Hit[] RaycastAllFiltered(Ray ray, QueryFilterDesc? filter = null) {
        var result = new Hit[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (Hit* out_ = result)
            status = Low.gphys_scene_raycast_all_filtered(Handle, &ray, filter_.Pointer, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Hit[total];
        }
    }

    /// <summary>Every model that each of the rays meets and its filter sees, as Scene.RaycastAllBatch.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe Ragged<Hit> RaycastAllFilteredBatch(ReadOnlySpan<Ray> rays, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, rays.Length, Optional(filters));
        var result = new Hit[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
            using (var filters_ = new QueryFilterDescs(filters))
            fixed (Hit* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_raycast_all_filtered_batch(Handle, rays_, StrideOf(rays), count, filters_.Pointer, filters_.Stride, out_, (uint)result.Length, offsets_);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<Hit>(result, offsets);
            }
            result = new Hit[total];
        }
    }

    /// <summary>Closest model along a segment that the filter sees, as Scene.SegmentTest.
    /// Cost: as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? SegmentTestFiltered(Segment segment, QueryFilterDesc? filter = null) {
        var hit = default(Hit);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_scene_segment_test_filtered(Handle, &segment, filter_.Pointer, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>Closest models along the segments that the filters see, as Scene.SegmentTestBatch.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe void SegmentTestFilteredBatch(ReadOnlySpan<Segment> segments, Span<Hit> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, segments.Length, Optional(filters));
        RequireLength(hits.Length, count);
        fixed (Segment* segments_ = &MemoryMarshal.GetReference(segments))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_segment_test_filtered_batch(Handle, segments_, StrideOf(segments), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Ids of all models that overlap a shape and that the filter sees, as Scene.Overlap.
    /// Cost: that of Scene.Overlap, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for types of shapes that Scene.Overlap
    /// does not take</exception>
    public unsafe uint[] OverlapFiltered(Shape shape, QueryFilterDesc? filter = null) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (uint* out_ = result)
            status = Low.gphys_scene_overlap_filtered(Handle, shape.Type, shape_, filter_.Pointer, out_, (uint)result.Length, &total);
            GC.KeepAlive(shape.Mesh);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of all models that each of the shapes of one type overlaps and its filter sees, as
    /// Scene.OverlapBatch.
    /// Cost: at most that of as many single calls; shared among workers.</summary>
    /// <param name="filters">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as there</exception>
    public unsafe Ragged<uint> OverlapFilteredBatch(Shapes shapes, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count, Optional(filters));
        var result = new uint[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
            using (var filters_ = new QueryFilterDescs(filters))
            fixed (uint* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_overlap_filtered_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, count, filters_.Pointer, filters_.Stride, out_, (uint)result.Length, offsets_);
            GC.KeepAlive(shapesOne.Mesh);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<uint>(result, offsets);
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene.Cull: a
    /// player's own head, say, is not drawn.
    /// Cost: that of Scene.Cull, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    public unsafe uint[] CullFiltered(Frustum frustum, QueryFilterDesc? filter = null) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (uint* out_ = result)
            status = Low.gphys_scene_cull_filtered(Handle, &frustum, filter_.Pointer, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the models in each of count frusta that its filter sees, as Scene.CullBatch: each player's
    /// view leaves out the player's own head.
    /// Cost: that of as many single calls; shared among workers. Since 1.1.</summary>
    /// <param name="filters">null: the defaults</param>
    public unsafe Ragged<uint> CullFilteredBatch(ReadOnlySpan<Frustum> frusta, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, frusta.Length, Optional(filters));
        var result = new uint[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (Frustum* frusta_ = &MemoryMarshal.GetReference(frusta))
            using (var filters_ = new QueryFilterDescs(filters))
            fixed (uint* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_cull_filtered_batch(Handle, frusta_, StrideOf(frusta), count, filters_.Pointer, filters_.Stride, out_, (uint)result.Length, offsets_);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<uint>(result, offsets);
            }
            result = new uint[total];
        }
    }

    /// <summary>The model nearest to a point that the filter sees, as Scene.Nearest: the nearest other model, if the
    /// one at the point is left out.
    /// Cost: that of Scene.Nearest, and for each model as Scene.RaycastFiltered; each ignored model that is
    /// nearer than the answer is visited.</summary>
    /// <param name="maxDistance">metres, &gt;= 0, INFINITY allowed; a model at exactly this distance
    /// counts</param>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Nearest? NearestFiltered(Vec3 point, float maxDistance = float.PositiveInfinity, QueryFilterDesc? filter = null) {
        var nearest = default(Nearest);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_scene_nearest_filtered(Handle, &point, maxDistance, filter_.Pointer, &nearest);
        return Found(status) ? nearest : (Nearest?)null;
    }

    /// <summary>The models nearest to the points that the filters see, as Scene.NearestBatch.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="maxDistance">metres, &gt;= 0, INFINITY allowed, for all points</param>
    /// <param name="filters">null: the defaults</param>
    public unsafe void NearestFilteredBatch(ReadOnlySpan<Vec3> points, Span<Nearest> nearest, float maxDistance = float.PositiveInfinity, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, points.Length, Optional(filters));
        RequireLength(nearest.Length, count);
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Nearest* nearest_ = &MemoryMarshal.GetReference(nearest))
        Check(Low.gphys_scene_nearest_filtered_batch(Handle, points_, StrideOf(points), count, maxDistance, filters_.Pointer, filters_.Stride, nearest_, (uint)sizeof(Nearest)));
    }

    /// <summary>First model that a moving sphere touches and the filter sees, as Scene.SweepSphere: the sphere may
    /// be the bounding sphere of the ignored model.
    /// Cost: that of Scene.SweepSphere, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? SweepSphereFiltered(Sphere sphere, Vec3 displacement, QueryFilterDesc? filter = null) {
        var hit = default(Hit);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_scene_sweep_sphere_filtered(Handle, &sphere, &displacement, filter_.Pointer, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First models that count moving spheres touch and the filters see, as Scene.SweepSphereBatch.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="displacements">metres</param>
    /// <param name="filters">null: the defaults</param>
    public unsafe void SweepSphereFilteredBatch(ReadOnlySpan<Sphere> spheres, ReadOnlySpan<Vec3> displacements, Span<Hit> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, spheres.Length, displacements.Length, Optional(filters));
        RequireLength(hits.Length, count);
        fixed (Sphere* spheres_ = &MemoryMarshal.GetReference(spheres))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_sweep_sphere_filtered_batch(Handle, spheres_, StrideOf(spheres), displacements_, StrideOf(displacements), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as Scene.Sweep:
    /// a character leaves out its own model.
    /// Cost: that of Scene.Sweep, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types</exception>
    public unsafe Hit? SweepFiltered(Shape shape, Vec3 displacement, QueryFilterDesc? filter = null) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_scene_sweep_filtered(Handle, shape.Type, shape_, &displacement, filter_.Pointer, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First models that count moving shapes of one type touch and the filters see, as Scene.SweepBatch.
    /// Cost: that of as many single calls; shared among workers.</summary>
    /// <param name="displacements">metres</param>
    /// <param name="filters">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Scene.Sweep</exception>
    public unsafe void SweepFilteredBatch(Shapes shapes, ReadOnlySpan<Vec3> displacements, Span<Hit> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count, displacements.Length, Optional(filters));
        RequireLength(hits.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        status = Low.gphys_scene_sweep_filtered_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, displacements_, StrideOf(displacements), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(Hit));
        GC.KeepAlive(shapesOne.Mesh);
        Check(status);
    }

    /// <summary>What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
    /// Scene.Penetration.
    /// Cost: that of Scene.Penetration, and for each model as Scene.RaycastFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types</exception>
    public unsafe Penetration[] PenetrationFiltered(Shape shape, QueryFilterDesc? filter = null) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var result = new Penetration[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (Penetration* out_ = result)
            status = Low.gphys_scene_penetration_filtered(Handle, shape.Type, shape_, filter_.Pointer, out_, (uint)result.Length, &total);
            GC.KeepAlive(shape.Mesh);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Penetration[total];
        }
    }

    /// <summary>What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
    /// Scene.PenetrationBatch: each character leaves out its own model.
    /// Cost: that of as many single calls; shared among workers. Since 1.1.</summary>
    /// <param name="filters">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Scene.Penetration</exception>
    public unsafe Ragged<Penetration> PenetrationFilteredBatch(Shapes shapes, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var shapesOne = shapes.One;
        var count = CommonLength(-1, shapes.Count, Optional(filters));
        var result = new Penetration[Guess + count];
        var offsets = new uint[count + 1];
        for (;;) {
            Status status;
            fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
            using (var filters_ = new QueryFilterDescs(filters))
            fixed (Penetration* out_ = result)
            fixed (uint* offsets_ = offsets)
            status = Low.gphys_scene_penetration_filtered_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, count, filters_.Pointer, filters_.Stride, out_, (uint)result.Length, offsets_);
            GC.KeepAlive(shapesOne.Mesh);
            Check(status);
            var total = offsets[count];
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return new Ragged<Penetration>(result, offsets);
            }
            result = new Penetration[total];
        }
    }

    /// <summary>Rebuild the scene's octree, as good as that of one Scene.AddBatch. Never required: ids, answers and
    /// their bits do not change. Where many models were added one by one, such as a level that was streamed
    /// in, rays then take 0.6 to 0.95 of the time.
    /// Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: with nothing changed</exception>
    public unsafe void RebuildOctree() {
        Check(Low.gphys_scene_rebuild_octree(Handle));
    }

    /// <summary>Rebuild the octree in parts, one in each call, until it is as good as after Scene.RebuildOctree: for
    /// levels that are streamed in while frames go on. Each Scene.Add and Scene.Remove does a part by
    /// itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are. Models
    /// may be added, moved and removed between the calls. A call that updates an eighth of them or more
    /// restarts it.
    /// Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.</summary>
    /// <param name="budget">how much work to do, as a number of models, of 0.3 to 3 us each. The work is
    /// the same on every machine and does not depend on time.</param>
    /// <returns>1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
    /// again.</returns>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: : the octree is as before, and the next
    /// call begins again</exception>
    public unsafe bool MaintainOctree(uint budget) {
        var done = default(int);
        Check(Low.gphys_scene_maintain_octree(Handle, budget, &done));
        return done != 0;
    }

    /// <summary>How the scene's octree is made up.
    /// Cost: O(nodes).</summary>
    public unsafe OctreeStats GetOctreeStats() {
        var stats = default(OctreeStats);
        Check(Low.gphys_scene_get_octree_stats(Handle, &stats));
        return stats;
    }

    /// <summary>Boxes of the scene's octree, each parent before its children.
    /// Cost: O(nodes).</summary>
    public unsafe OctreeBox[] GetOctreeBoxes() {
        var result = new OctreeBox[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (OctreeBox* out_ = result)
            status = Low.gphys_scene_get_octree_boxes(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new OctreeBox[total];
        }
    }

    /// <summary>Check the scene's own structure: every model once in the tree, every box around its content, parents
    /// and children in agreement, free slots free. For tests.
    /// Cost: O(n).</summary>
    /// <exception cref="GamephysException">Status.ErrorInternal: and the exception's message says what is
    /// wrong</exception>
    public unsafe void Validate() {
        Check(Low.gphys_scene_validate(Handle));
    }

    /// <summary>Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
    /// shapes, the order of future ids, and the octree. Workers and allocator are not in it.
    /// Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (Mesh.GetSnapshot).
    /// Allocates a few words for each different mesh.</summary>
    /// <param name="embedMeshes">true: meshes are in the snapshot, each once, so it is complete in itself:
    /// for saved games and for other machines. false: they are identified by their content, and
    /// Scene.Restore looks for them: for undo, and rollback each frame.</param>
    /// <returns>the snapshot. Words are in the machine's byte order. Every later release of the same major
    /// version reads it.</returns>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^32 - 1 words</exception>
    public unsafe uint[] GetSnapshot(bool embedMeshes) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_scene_get_snapshot(Handle, embedMeshes ? 1 : 0, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
    /// time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
    /// that is restored with its scene continues with the same bits. On an error the scene is as before.
    /// Any words are safe, also from an untrusted source: all that is used as a number or an index is
    /// checked first. Forged words are refused, or taken as a scene like any other.
    /// Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.</summary>
    /// <param name="library">meshes that are not embedded are looked for among those that models of this
    /// scene use, by their content: vertices and indices. A mesh deformed since must get its old form back
    /// first. null: among those that models of `scene` itself use, before it is restored.</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for words that are no snapshot of a
    /// scene, damaged, of a later format or of another byte order, and if a mesh is missing</exception>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: if there is no room for it</exception>
    public unsafe void Restore(ReadOnlySpan<uint> words, Scene library = null) {
        var count = CommonLength(words.Length, 1);
        fixed (uint* words_ = &MemoryMarshal.GetReference(words))
        Check(Low.gphys_scene_restore(Handle, library == null ? SceneHandle.None : library.Handle, words_, count));
    }

    /// <summary>A hash of the whole state except the octree, the low half first; meshes count by their content.
    /// Equal states have equal hashes on every machine; different ones differ with near certainty (not
    /// against an adversary). Compare it between machines that run the same simulation, to detect when they
    /// diverge.
    /// Cost: O(n), some 50 ns for each model.</summary>
    public unsafe uint[] GetHash() {
        var hash = new uint[2];
        fixed (uint* hash_ = hash)
        Check(Low.gphys_scene_get_hash(Handle, hash_));
        return hash;
    }

}

/// <summary>Owns a gphys_camera: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Camera : IDisposable {
    internal readonly CameraHandle Handle;

    /// <summary>Create a camera at the origin, with the projection and the viewport of its desc.
    /// Cost: O(1).</summary>
    /// <param name="desc">null: the defaults</param>
    public unsafe Camera(CameraDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_camera_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new CameraHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>Move the point of the world that the camera's coordinates count from; see Scene.SetOrigin. The
    /// camera and the target of its orbit stay where they are in the world. Picking and culling need a
    /// scene of the same origin, else they fail with Status.ErrorInvalidArgument.
    /// Cost: O(1).</summary>
    /// <param name="origin">x, y, z in the world, metres, within MaxCoordinate</param>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_camera_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the camera's coordinates count from, metres.
    /// Cost: O(1).</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_camera_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>Use a perspective projection: distant objects appear smaller.
    /// Cost: O(1).</summary>
    /// <param name="fovY">full vertical angle in radians, 1e-6 &lt;= fovY &lt; pi</param>
    /// <param name="nearDistance">metres, &gt; 0</param>
    /// <param name="farDistance">metres, &gt; nearDistance; INFINITY allowed</param>
    public unsafe void SetPerspective(float fovY, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_perspective(Handle, fovY, nearDistance, farDistance));
    }

    /// <summary>Use an orthographic projection: the distance does not change apparent size.
    /// Cost: O(1).</summary>
    /// <param name="height">metres seen from top to bottom, &gt;= 1e-6; the width follows from the viewport
    /// and is at most twice MaxCoordinate</param>
    /// <param name="nearDistance">metres, may be negative</param>
    /// <param name="farDistance">metres, at least 1e-6 above nearDistance</param>
    public unsafe void SetOrthographic(float height, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_orthographic(Handle, height, nearDistance, farDistance));
    }

    /// <summary>Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
    /// library's). It is not changed by Camera.SetViewport.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorSingular: if it has no inverse, or is too close to
    /// such a matrix to tell</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if a plane other than far lies at
    /// infinity, as it does when the matrix is for another depth range, or one lies beyond
    /// MaxCoordinate</exception>
    public unsafe void SetProjection(Mat4 projection) {
        Check(Low.gphys_camera_set_projection(Handle, &projection));
    }

    /// <summary>As Camera.SetPerspective, with a fixed aspect ratio: the image is stretched to the viewport, as with
    /// pixels that are not square, and the viewport does not change what is seen.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="fovY">full vertical angle in radians, 1e-6 &lt;= fovY &lt; pi</param>
    /// <param name="aspect">width over height of what is seen, 1e-6 .. 1e6</param>
    /// <param name="nearDistance">metres, &gt; 0</param>
    /// <param name="farDistance">metres, &gt; nearDistance; INFINITY allowed</param>
    public unsafe void SetPerspectiveAspect(float fovY, float aspect, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_perspective_aspect(Handle, fovY, aspect, nearDistance, farDistance));
    }

    /// <summary>As Camera.SetOrthographic, with a width of its own, which the viewport does not change.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="width">metres seen from left to right, &gt;= 1e-6</param>
    /// <param name="height">metres seen from top to bottom, &gt;= 1e-6</param>
    /// <param name="nearDistance">metres, may be negative</param>
    /// <param name="farDistance">metres, at least 1e-6 above nearDistance</param>
    public unsafe void SetOrthographicSize(float width, float height, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_orthographic_size(Handle, width, height, nearDistance, farDistance));
    }

    /// <summary>Set the size of the viewport. A perspective keeps fovY, an orthographic projection its height; the
    /// call is refused if that makes the width more than twice MaxCoordinate.
    /// Cost: O(1).</summary>
    /// <param name="width">pixels, 1e-3 .. 1e6</param>
    /// <param name="height">pixels, 1e-3 .. 1e6</param>
    public unsafe void SetViewport(float width, float height) {
        Check(Low.gphys_camera_set_viewport(Handle, width, height));
    }

    /// <summary>Where the viewport is in its window, as one of several of a split screen: pixels of all functions
    /// count from the window's top left corner. (0, 0) at creation.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="x">pixels from the window's left edge to the viewport's</param>
    /// <param name="y">pixels from the window's top edge to the viewport's</param>
    public unsafe void SetViewportOrigin(float x, float y) {
        Check(Low.gphys_camera_set_viewport_origin(Handle, x, y));
    }

    /// <summary>Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
    /// rays of other projections always begin there.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe void SetPickStart(PickStart start) {
        Check(Low.gphys_camera_set_pick_start(Handle, start));
    }

    /// <summary>How the camera projects, as it was set.
    /// Cost: O(1).</summary>
    /// <returns>what of the following was called last: Camera.SetPerspective, as at creation,
    /// Camera.SetOrthographic (or those with a width of their own), or Camera.SetProjection. the vertical
    /// field of view in radians of a perspective, the height in metres of an orthographic projection, 0 of
    /// a matrix. the distance of the near plane, metres; 0 of a matrix. that of the far plane; INFINITY
    /// without one; 0 of a matrix.</returns>
    public unsafe (Projection Kind, float Size, float Near, float Far) GetProjection() {
        var kind = default(Projection);
        var size = default(float);
        var near = default(float);
        var far = default(float);
        Check(Low.gphys_camera_get_projection(Handle, &kind, &size, &near, &far));
        return (kind, size, near, far);
    }

    /// <summary>The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
    /// image.
    /// Cost: O(1).</summary>
    public unsafe (float Width, float Height) GetViewport() {
        var width = default(float);
        var height = default(float);
        Check(Low.gphys_camera_get_viewport(Handle, &width, &height));
        return (width, height);
    }

    /// <summary>Where the viewport is in its window, in pixels, as it was set.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe (float X, float Y) GetViewportOrigin() {
        var x = default(float);
        var y = default(float);
        Check(Low.gphys_camera_get_viewport_origin(Handle, &x, &y));
        return (x, y);
    }

    /// <summary>Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
    /// viewport.
    /// Cost: O(1). Since 1.1.</summary>
    /// <returns>1 if Camera.SetPerspectiveAspect or Camera.SetOrthographicSize was the last to set the
    /// projection; 0 if it follows the viewport.</returns>
    public unsafe (float Aspect, bool Isfixed) GetAspect() {
        var aspect = default(float);
        var isFixed = default(int);
        Check(Low.gphys_camera_get_aspect(Handle, &aspect, &isFixed));
        return (aspect, isFixed != 0);
    }

    /// <summary>Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
    /// the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
    /// distance by an orthographic projection, in metres as they were set; 0 by a matrix.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe (float Width, float Height) GetImageSize() {
        var width = default(float);
        var height = default(float);
        Check(Low.gphys_camera_get_image_size(Handle, &width, &height));
        return (width, height);
    }

    /// <summary>Where the rays of a perspective begin, as it was set.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe PickStart GetPickStart() {
        var start = default(PickStart);
        Check(Low.gphys_camera_get_pick_start(Handle, &start));
        return start;
    }

    /// <summary>What the camera was created with, as in CameraDesc.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe (Handedness Handedness, DepthRange Depthrange, bool Reversez) GetConventions() {
        var handedness = default(Handedness);
        var depthRange = default(DepthRange);
        var reverseZ = default(int);
        Check(Low.gphys_camera_get_conventions(Handle, &handedness, &depthRange, &reverseZ));
        return (handedness, depthRange, reverseZ != 0);
    }

    /// <summary>Place the camera.
    /// Cost: O(1).</summary>
    /// <param name="position">metres, of its centre</param>
    /// <param name="rotation">from its own axes to those of the world</param>
    public unsafe void SetTransform(Vec3 position, Quat rotation) {
        Check(Low.gphys_camera_set_transform(Handle, &position, &rotation));
    }

    /// <summary>Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
    /// kept, then up), so that a matrix which drifted is corrected.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorSingular: if the axes do not span space</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if they mirror or the last row is
    /// not 0 0 0 1</exception>
    public unsafe void SetWorldMatrix(Mat4 world) {
        Check(Low.gphys_camera_set_world_matrix(Handle, &world));
    }

    /// <summary>Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
    /// Camera.SetWorldMatrix. That of Camera.GetViewMatrix puts a camera back within 2^-22 of its distance
    /// from the origin and 2^-22 rad.
    /// Cost: O(1). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorSingular: if the axes do not span space</exception>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if they mirror, the last row is not
    /// 0 0 0 1, or the camera would be beyond MaxCoordinate</exception>
    public unsafe void SetViewMatrix(Mat4 view) {
        Check(Low.gphys_camera_set_view_matrix(Handle, &view));
    }

    /// <summary>Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
    /// chosen in its place, always the same for the same input.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if eye equals target or up is
    /// zero</exception>
    public unsafe void LookAt(Vec3 eye, Vec3 target, Vec3 up) {
        Check(Low.gphys_camera_look_at(Handle, &eye, &target, &up));
    }

    /// <summary>The camera's position, in metres, and its rotation, rounded to float32.
    /// Cost: O(1).</summary>
    public unsafe (Vec3 Position, Quat Rotation) GetTransform() {
        var position = default(Vec3);
        var rotation = default(Quat);
        Check(Low.gphys_camera_get_transform(Handle, &position, &rotation));
        return (position, rotation);
    }

    /// <summary>The matrix from camera to world.
    /// Cost: O(1).</summary>
    public unsafe Mat4 GetWorldMatrix() {
        var world = default(Mat4);
        Check(Low.gphys_camera_get_world_matrix(Handle, &world));
        return world;
    }

    /// <summary>The matrix from world to camera: the transpose of the orthonormal world axes, and the position
    /// transformed by it.
    /// Cost: O(1).</summary>
    public unsafe Mat4 GetViewMatrix() {
        var view = default(Mat4);
        Check(Low.gphys_camera_get_view_matrix(Handle, &view));
        return view;
    }

    /// <summary>The matrix from camera to clip space.
    /// Cost: O(1).</summary>
    public unsafe Mat4 GetProjectionMatrix() {
        var projection = default(Mat4);
        Check(Low.gphys_camera_get_projection_matrix(Handle, &projection));
        return projection;
    }

    /// <summary>Projection * view, multiplied in double precision and rounded once.
    /// Cost: O(1).</summary>
    public unsafe Mat4 GetViewProjectionMatrix() {
        var viewProjection = default(Mat4);
        Check(Low.gphys_camera_get_view_projection_matrix(Handle, &viewProjection));
        return viewProjection;
    }

    /// <summary>Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
    /// distance outside its limits is brought inside.
    /// Cost: O(1).</summary>
    public unsafe void SetOrbit(Orbit orbit) {
        Check(Low.gphys_camera_set_orbit(Handle, &orbit));
    }

    /// <summary>The present settings, angles and distance of the orbit.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe Orbit GetOrbit() {
        var orbit = default(Orbit);
        Check(Low.gphys_camera_get_orbit(Handle, &orbit));
        return orbit;
    }

    /// <summary>Set a speed for each input of the orbit, in place of the two of Orbit, which Camera.SetOrbit starts
    /// from. Input since the last update uses the new speeds.
    /// Cost: O(1). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe void SetOrbitSpeeds(OrbitSpeeds speeds) {
        Check(Low.gphys_camera_set_orbit_speeds(Handle, &speeds));
    }

    /// <summary>The present speeds of the orbit's inputs.
    /// Cost: O(1). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe OrbitSpeeds GetOrbitSpeeds() {
        var speeds = default(OrbitSpeeds);
        Check(Low.gphys_camera_get_orbit_speeds(Handle, &speeds));
        return speeds;
    }

    /// <summary>Add input to the orbit: yaw by unitsX, pitch by unitsY, times radians_per_unit or the speeds that
    /// were set.
    /// Cost: O(1).</summary>
    /// <param name="unitsX">finite, any size</param>
    /// <param name="unitsY">finite, any size</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe void OrbitRotate(float unitsX, float unitsY) {
        Check(Low.gphys_camera_orbit_rotate(Handle, unitsX, unitsY));
    }

    /// <summary>Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
    /// away if negative.
    /// Cost: O(1).</summary>
    /// <param name="units">finite, any size</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe void OrbitZoom(float units) {
        Check(Low.gphys_camera_orbit_zoom(Handle, units));
    }

    /// <summary>Add input to the orbit: move the target to the camera's right and up, as the last update left them,
    /// by units times metres_per_unit or the speeds that were set.
    /// Cost: O(1).</summary>
    /// <param name="unitsRight">finite, any size</param>
    /// <param name="unitsUp">finite, any size</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe void OrbitPan(float unitsRight, float unitsUp) {
        Check(Low.gphys_camera_orbit_pan(Handle, unitsRight, unitsUp));
    }

    /// <summary>Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
    /// to -pi .. pi in constant time.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the camera was never set to
    /// orbit</exception>
    public unsafe void OrbitUpdate() {
        Check(Low.gphys_camera_orbit_update(Handle));
    }

    /// <summary>The view frustum, with origin at the camera's position and planes from its parameters: each number
    /// within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
    /// Gribb-Hartmann in double precision.
    /// Cost: O(1).</summary>
    public unsafe Frustum GetFrustum() {
        var frustum = default(Frustum);
        Check(Low.gphys_camera_get_frustum(Handle, &frustum));
        return frustum;
    }

    /// <summary>World positions of the corners of the view frustum, in the order of Geometry.FrustumCorners.
    /// Cost: O(1).</summary>
    /// <returns>null with an infinite far plane, or a corner beyond the largest float.</returns>
    public unsafe Vec3[] GetCorners() {
        var corners = new Vec3[8];
        Status status;
        fixed (Vec3* corners_ = corners)
        status = Low.gphys_camera_get_corners(Handle, corners_);
        return Found(status) ? corners : null;
    }

    /// <summary>What is seen in a rectangle of pixels, as Camera.GetFrustum: of a tile, a marquee, a portal.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="x0">pixels, a corner of the rectangle; may lie outside the viewport</param>
    /// <param name="y0">pixels, a corner of the rectangle; may lie outside the viewport</param>
    /// <param name="x1">pixels, the opposite corner, in any order; may lie outside the viewport</param>
    /// <param name="y1">pixels, the opposite corner, in any order; may lie outside the viewport</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if the rectangle has no area, or a
    /// side of what a matrix shows in it lies at infinity or beyond MaxCoordinate</exception>
    public unsafe Frustum GetRectangleFrustum(float x0, float y0, float x1, float y1) {
        var frustum = default(Frustum);
        Check(Low.gphys_camera_get_rectangle_frustum(Handle, x0, y0, x1, y1, &frustum));
        return frustum;
    }

    /// <summary>World positions of the corners of what is seen in a rectangle of pixels, as Camera.GetCorners.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="x0">as Camera.GetRectangleFrustum</param>
    /// <param name="y0">as Camera.GetRectangleFrustum</param>
    /// <param name="x1">as Camera.GetRectangleFrustum</param>
    /// <param name="y1">as Camera.GetRectangleFrustum</param>
    /// <returns>null as Camera.GetCorners.</returns>
    public unsafe Vec3[] GetRectangleCorners(float x0, float y0, float x1, float y1) {
        var corners = new Vec3[8];
        Status status;
        fixed (Vec3* corners_ = corners)
        status = Low.gphys_camera_get_rectangle_corners(Handle, x0, y0, x1, y1, corners_);
        return Found(status) ? corners : null;
    }

    /// <summary>World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
    /// viewport; z is the depth in the camera's range.
    /// Cost: O(1).</summary>
    /// <returns>null if the point is not in front of the camera's centre (no image), or its image lies
    /// beyond the range of coordinates.</returns>
    public unsafe Vec3? Project(Vec3 point) {
        var pixel = default(Vec3);
        var status = Low.gphys_camera_project(Handle, &point, &pixel);
        return Found(status) ? pixel : (Vec3?)null;
    }

    /// <summary>Pixels of count world points, as Camera.Project; a point without an image gets x = y = z = INFINITY.
    /// Cost: O(elements).</summary>
    /// <param name="points">metres</param>
    public unsafe void ProjectBatch(ReadOnlySpan<Vec3> points, Span<Vec3> pixels) {
        var count = CommonLength(-1, points.Length);
        RequireLength(pixels.Length, count);
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (Vec3* pixels_ = &MemoryMarshal.GetReference(pixels))
        Check(Low.gphys_camera_project_batch(Handle, points_, StrideOf(points), count, pixels_, (uint)sizeof(Vec3)));
    }

    /// <summary>Pixel and depth to world point: the inverse of Camera.Project.
    /// Cost: O(1).</summary>
    /// <returns>null for the depth of an infinite far plane, and for points beyond that or beyond the range
    /// of coordinates.</returns>
    public unsafe Vec3? Unproject(Vec3 pixel) {
        var point = default(Vec3);
        var status = Low.gphys_camera_unproject(Handle, &pixel, &point);
        return Found(status) ? point : (Vec3?)null;
    }

    /// <summary>World points of the pixels with depth, as Camera.Unproject; one at infinity gets x = y = z =
    /// INFINITY.
    /// Cost: O(elements).</summary>
    /// <param name="pixels">x, y in pixels, z the depth</param>
    public unsafe void UnprojectBatch(ReadOnlySpan<Vec3> pixels, Span<Vec3> points) {
        var count = CommonLength(-1, pixels.Length);
        RequireLength(points.Length, count);
        fixed (Vec3* pixels_ = &MemoryMarshal.GetReference(pixels))
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        Check(Low.gphys_camera_unproject_batch(Handle, pixels_, StrideOf(pixels), count, points_, (uint)sizeof(Vec3)));
    }

    /// <summary>The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
    /// (INFINITY without one). With PickStart.Centre that of a perspective starts at the camera's position.
    /// Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, within
    /// half an ulp of its direction. Its start is rounded to float32, too, which moves the ray by half an
    /// ulp of the coordinates (but not from the camera's position, which has float coordinates);
    /// Camera.Pick is not limited in this way.
    /// Cost: O(1).</summary>
    /// <param name="pixelX">pixels; may lie outside the viewport</param>
    /// <param name="pixelY">pixels; may lie outside the viewport</param>
    /// <returns>null if the line of sight does not meet the near plane (user projections), or would begin
    /// beyond MaxCoordinate.</returns>
    public unsafe Ray? PickRay(float pixelX, float pixelY) {
        var ray = default(Ray);
        var status = Low.gphys_camera_pick_ray(Handle, pixelX, pixelY, &ray);
        return Found(status) ? ray : (Ray?)null;
    }

    /// <summary>Rays for a rectangle of pixel centres, as Camera.PickRay, row by row.
    /// Cost: O(width * height).</summary>
    /// <param name="x">the left column of the rectangle</param>
    /// <param name="y">its top row</param>
    /// <param name="width">its columns</param>
    /// <param name="height">its rows; width * height fewer than 2^32</param>
    public unsafe void PickRays(uint x, uint y, uint width, uint height, Span<Ray> rays) {
        RequireLength(rays.Length, (ulong)width * height);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        Check(Low.gphys_camera_pick_rays(Handle, x, y, width, height, rays_, (uint)sizeof(Ray)));
    }

    /// <summary>The model under a pixel: the first hit of Camera.PickRay, before that is rounded to float32; t is in
    /// metres from where it starts.
    /// Cost: O(log n) expected.</summary>
    /// <param name="pixelX">pixels; may lie outside the viewport</param>
    /// <param name="pixelY">pixels; may lie outside the viewport</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? Pick(Scene scene, float pixelX, float pixelY, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_camera_pick(Handle, scene.Handle, pixelX, pixelY, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>The models under the pixels, as Camera.Pick; a pixel without one gets model = 0 and t = INFINITY.
    /// Cost: at most that of as many single calls; shared among the scene's workers.</summary>
    /// <param name="pixels">x, y pairs of floats</param>
    public unsafe void PickBatch(Scene scene, ReadOnlySpan<Vec2> pixels, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, pixels.Length);
        RequireLength(hits.Length, count);
        fixed (Vec2* pixels_ = &MemoryMarshal.GetReference(pixels))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_camera_pick_batch(Handle, scene.Handle, (float*)pixels_, StrideOf(pixels), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
    /// tested by their exact shapes, ascending.
    /// Cost: that of Scene.Overlap.</summary>
    /// <param name="x0">pixels, a corner of the rectangle; may lie outside the viewport</param>
    /// <param name="y0">pixels, a corner of the rectangle; may lie outside the viewport</param>
    /// <param name="x1">pixels, the opposite corner, in any order; may lie outside the viewport</param>
    /// <param name="y1">pixels, the opposite corner, in any order; may lie outside the viewport</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if the rectangle has no
    /// area</exception>
    public unsafe uint[] PickRectangle(Scene scene, float x0, float y0, float x1, float y1, uint layers = Constants.AllLayers) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_camera_pick_rectangle(Handle, scene.Handle, x0, y0, x1, y1, layers, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the models to draw: Scene.Cull with the camera's frustum.
    /// Cost: O(log n + k) expected.</summary>
    public unsafe uint[] Cull(Scene scene, uint layers = Constants.AllLayers) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_camera_cull(Handle, scene.Handle, layers, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>The model under a pixel that the filter sees, as Camera.Pick: what lies behind a selection.
    /// Cost: as Scene.RaycastFiltered.</summary>
    /// <param name="pixelX">pixels; may lie outside the viewport</param>
    /// <param name="pixelY">pixels; may lie outside the viewport</param>
    /// <param name="filter">null: the defaults</param>
    /// <returns>null if nothing is found.</returns>
    public unsafe Hit? PickFiltered(Scene scene, float pixelX, float pixelY, QueryFilterDesc? filter = null) {
        var hit = default(Hit);
        Status status;
        using (var filter_ = new QueryFilterDescs(filter))
        status = Low.gphys_camera_pick_filtered(Handle, scene.Handle, pixelX, pixelY, filter_.Pointer, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>The models under the pixels that the filters see, as Camera.PickBatch.
    /// Cost: at most that of as many single calls; shared among the scene's workers.</summary>
    /// <param name="pixels">x, y pairs of floats</param>
    /// <param name="filters">null: the defaults</param>
    public unsafe void PickFilteredBatch(Scene scene, ReadOnlySpan<Vec2> pixels, Span<Hit> hits, ReadOnlySpan<QueryFilterDesc> filters = default(ReadOnlySpan<QueryFilterDesc>)) {
        var count = CommonLength(-1, pixels.Length, Optional(filters));
        RequireLength(hits.Length, count);
        fixed (Vec2* pixels_ = &MemoryMarshal.GetReference(pixels))
        using (var filters_ = new QueryFilterDescs(filters))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_camera_pick_filtered_batch(Handle, scene.Handle, (float*)pixels_, StrideOf(pixels), count, filters_.Pointer, filters_.Stride, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Marquee: ids of all models in the pixel rectangle that the filter sees, as Camera.PickRectangle.
    /// Cost: as Scene.OverlapFiltered.</summary>
    /// <param name="x0">pixels, a corner of the rectangle</param>
    /// <param name="y0">pixels, a corner of the rectangle</param>
    /// <param name="x1">pixels, the opposite corner, in any order</param>
    /// <param name="y1">pixels, the opposite corner, in any order</param>
    /// <param name="filter">null: the defaults</param>
    public unsafe uint[] PickRectangleFiltered(Scene scene, float x0, float y0, float x1, float y1, QueryFilterDesc? filter = null) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (uint* out_ = result)
            status = Low.gphys_camera_pick_rectangle_filtered(Handle, scene.Handle, x0, y0, x1, y1, filter_.Pointer, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the models to draw that the filter sees: Scene.CullFiltered with the camera's frustum.
    /// Cost: as Scene.CullFiltered.</summary>
    /// <param name="filter">null: the defaults</param>
    public unsafe uint[] CullFiltered(Scene scene, QueryFilterDesc? filter = null) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            using (var filter_ = new QueryFilterDescs(filter))
            fixed (uint* out_ = result)
            status = Low.gphys_camera_cull_filtered(Handle, scene.Handle, filter_.Pointer, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

}

/// <summary>Owns a gphys_solver: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Solver : IDisposable {
    internal readonly SolverHandle Handle;

    /// <summary>Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
    /// results have the same bits for every n. Threads are started, joined and lost as those of Scene.
    /// Cost: O(1), and that of starting the threads.</summary>
    /// <param name="desc">null: the defaults</param>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: also if the threads cannot be
    /// started</exception>
    public unsafe Solver(SolverDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_solver_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new SolverHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>Change the number of threads that share the steps of a solver, as Scene.SetWorkerCount. The bits of
    /// the motion stay the same.
    /// Cost: as Scene.SetWorkerCount; allocates. Since 1.1.</summary>
    /// <param name="workers">as SolverDesc.worker_count</param>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: also if the threads cannot be started;
    /// the former ones are kept</exception>
    public unsafe void SetWorkerCount(uint workers) {
        Check(Low.gphys_solver_set_worker_count(Handle, workers));
    }

    /// <summary>How many threads share the steps of a solver, as Scene.GetWorkerCount.
    /// Cost: O(1). Since 1.1.</summary>
    public unsafe uint GetWorkerCount() {
        var workers = default(uint);
        Check(Low.gphys_solver_get_worker_count(Handle, &workers));
        return workers;
    }

    /// <summary>Move the point of the world that the coordinates of all particles count from; see Scene.SetOrigin.
    /// Particles stay where they are in the world and keep moving as they do. A step and an attachment need
    /// a scene of the same origin, else they fail with Status.ErrorInvalidArgument.
    /// Cost: O(particles).</summary>
    /// <param name="origin">x, y, z in the world, metres, within MaxCoordinate</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if a particle or an animation
    /// target would leave the range of coordinates</exception>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_solver_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the particles' coordinates count from, metres.
    /// Cost: O(1).</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_solver_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
    /// Cost: O(bodies).</summary>
    /// <param name="gravity">m/s^2; may be zero</param>
    public unsafe void SetGravity(Vec3 gravity) {
        Check(Low.gphys_solver_set_gravity(Handle, &gravity));
    }

    /// <summary>Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
    /// The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
    /// link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
    /// (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
    /// Cost: O(1).</summary>
    /// <param name="substeps">1 .. 1000</param>
    public unsafe void SetSubsteps(uint substeps) {
        Check(Low.gphys_solver_set_substeps(Handle, substeps));
    }

    /// <summary>The settings of a solver as they are.
    /// Cost: O(1).</summary>
    public unsafe SolverSettings GetSettings() {
        var settings = default(SolverSettings);
        Check(Low.gphys_solver_get_settings(Handle, &settings));
        return settings;
    }

    /// <summary>Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
    /// if gravity or the settings of sleep change. Time that Solver.Advance owes beyond the new fixed_step
    /// is dropped.
    /// Cost: O(bodies).</summary>
    public unsafe void SetSettings(SolverSettings settings) {
        Check(Low.gphys_solver_set_settings(Handle, &settings));
    }

    /// <summary>Add a body of particles without constraints.
    /// Cost: O(elements).</summary>
    /// <param name="desc">null: the defaults</param>
    /// <param name="positions">metres</param>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 particles or
    /// bodies</exception>
    public unsafe uint AddParticles(ReadOnlySpan<Vec3> positions, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, positions.Length);
        var body = default(uint);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_add_particles(Handle, desc.HasValue ? &desc_ : null, positions_, StrideOf(positions), count, &body));
        return body;
    }

    /// <summary>Add a rope through the given points, one particle at each.
    /// Cost: O(elements).</summary>
    /// <param name="desc">null: the defaults</param>
    /// <param name="positions">metres</param>
    /// <param name="linkLength">rest length of each link in metres; 0: as placed. A length below 1e-9 m
    /// counts as 0. Rigid links get their lengths in the first step, and the particles no speed by
    /// it.</param>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 particles or
    /// bodies</exception>
    public unsafe uint AddRope(ReadOnlySpan<Vec3> positions, float linkLength = 0, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, positions.Length);
        var body = default(uint);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_add_rope(Handle, desc.HasValue ? &desc_ : null, positions_, StrideOf(positions), count, linkLength, &body));
        return body;
    }

    /// <summary>Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
    /// corner + column / (columns - 1) * edgeU + row / (rows - 1) * edgeV. Its constraints, in the order of
    /// their ids, are those from row to row, those from column to column, both diagonals (ClothShear), and
    /// those that resist folding (ClothBend); Solver.SetConstraintSettings makes them softer or stiffer
    /// later.
    /// Cost: O(columns * rows).</summary>
    /// <param name="desc">null: the defaults</param>
    /// <param name="corner">metres</param>
    /// <param name="edgeU">metres, from the corner along a row</param>
    /// <param name="edgeV">metres, from the corner along a column</param>
    /// <param name="columns">&gt;= 2</param>
    /// <param name="rows">&gt;= 2</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if the edges are parallel or
    /// zero</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 particles, links or
    /// bodies</exception>
    public unsafe uint AddCloth(Vec3 corner, Vec3 edgeU, Vec3 edgeV, uint columns, uint rows, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var body = default(uint);
        Check(Low.gphys_solver_add_cloth(Handle, desc.HasValue ? &desc_ : null, &corner, &edgeU, &edgeV, columns, rows, &body));
        return body;
    }

    /// <summary>Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
    /// ClothBend one across each inner edge, whose ids come after those of the edges. Vertices at the same
    /// place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a rest
    /// length of 0.
    /// Cost: O(n log n).</summary>
    /// <param name="desc">null: the defaults</param>
    /// <param name="transform">places the mesh; null is the identity</param>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 particles or
    /// bodies</exception>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a mesh made from a rope or from
    /// particles, which has no triangles</exception>
    public unsafe uint AddClothMesh(Mesh mesh, Transform? transform = null, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var transform_ = transform.GetValueOrDefault();
        var body = default(uint);
        Check(Low.gphys_solver_add_cloth_mesh(Handle, desc.HasValue ? &desc_ : null, mesh.Handle, transform.HasValue ? &transform_ : null, &body));
        return body;
    }

    /// <summary>Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
    /// the last step are no longer listed.
    /// Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
    /// impulses to the same models).</summary>
    public unsafe void RemoveBody(uint body) {
        Check(Low.gphys_solver_remove_body(Handle, body));
    }

    /// <summary>Ids of all bodies, ascending.
    /// Cost: O(bodies).</summary>
    public unsafe uint[] GetBodies() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_bodies(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
    /// sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by more
    /// than sleep_strain; cloth, when its root mean square speed from step to step was no higher, no
    /// particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of
    /// cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it
    /// keeps its contacts, and a step costs it one query for models nearby. It wakes in the next step after
    /// a model within reach (as far as one could move in a step at 50 m/s) was added, removed or moved, or
    /// a model that it is attached to, or after the scene was replaced; and at once by any change of its
    /// state, of gravity or of the origin. Cloth is brought to rest, whatever sleep_speed is, once friction
    /// holds it on models that stand still and it moves by centimetres a second without sagging further:
    /// within a second it is slowed down to 0. It moves again when one of these models or the body changes.
    /// Not in wind, with joints, animation targets, clusters or a volume, or near other bodies.
    /// Cost: O(bodies).</summary>
    public unsafe uint[] GetSleeping() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_sleeping(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Wake a body; its time of rest begins again.
    /// Cost: O(1) a body.</summary>
    /// <param name="body">0: all</param>
    public unsafe void Wake(uint body) {
        Check(Low.gphys_solver_wake(Handle, body));
    }

    /// <summary>The present settings of a body; static_friction as it acts, at least friction.
    /// Cost: O(1).</summary>
    public unsafe BodySettings GetBodySettings(uint body) {
        var settings = default(BodySettings);
        Check(Low.gphys_solver_get_body_settings(Handle, body, &settings));
        return settings;
    }

    /// <summary>Change all settings of a body, from the next step on: read them, change some, and give them back.
    /// Wakes the body.
    /// Cost: O(1); O(particles) when self_collision changes, and it allocates.</summary>
    public unsafe void SetBodySettings(uint body, BodySettings settings) {
        Check(Low.gphys_solver_set_body_settings(Handle, body, &settings));
    }

    /// <summary>What a body is made of and how it is solved.
    /// Cost: O(1); after a change of constraints O(particles), and it allocates.</summary>
    public unsafe BodyInfo GetBodyInfo(uint body) {
        var info = default(BodyInfo);
        Check(Low.gphys_solver_get_body_info(Handle, body, &info));
        return info;
    }

    /// <summary>Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
    /// change, and their number does not.
    /// Cost: O(triangles).</summary>
    public unsafe uint[] GetTriangles(uint body) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_triangles(Handle, body, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
    /// Cost: O(1); O(particles) for NoTriangle. Since 1.1.</summary>
    /// <param name="triangle">as in a hit, nearest or penetration of the body's mesh: its corners are
    /// compared, of a rope the ends of the link, or the particle; NoTriangle: all particles</param>
    /// <param name="point">metres, in the solver's coordinates: that of the hit</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: also if the mesh has no such
    /// triangle</exception>
    public unsafe uint GetNearestParticle(uint body, uint triangle, Vec3 point) {
        var particle = default(uint);
        Check(Low.gphys_solver_get_nearest_particle(Handle, body, triangle, &point, &particle));
        return particle;
    }

    /// <summary>Where the particles are, metres.
    /// Cost: O(count).</summary>
    /// <param name="first">the first particle</param>
    /// <param name="count">how many from there on; a range beyond the body is
    /// Status.ErrorInvalidArgument</param>
    public unsafe void GetPositions(uint body, uint first, Span<Vec3> positions) {
        var count = (uint)positions.Length;
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_get_positions(Handle, body, first, count, positions_, (uint)sizeof(Vec3)));
    }

    /// <summary>Move particles at once and without collision on the way; velocities stay as they are. Wakes the
    /// body. Rigid links that are too long or too short then get their lengths in the next step, and the
    /// particles no speed by it. Pinned particles that are moved alone pull the others: during the next
    /// step they go evenly from where they were to their new places, as attached ones do. They are placed
    /// at once before the body's first step, or if a free particle of the body is placed as well.
    /// Cost: O(elements).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    public unsafe void SetPositions(uint body, uint first, ReadOnlySpan<Vec3> positions) {
        var count = CommonLength(-1, positions.Length);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_set_positions(Handle, body, first, count, positions_, StrideOf(positions)));
    }

    /// <summary>How fast the particles are, m/s.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    /// <returns>0 of what is pinned and stands still.</returns>
    public unsafe void GetVelocities(uint body, uint first, Span<Vec3> velocities) {
        var count = (uint)velocities.Length;
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_get_velocities(Handle, body, first, count, velocities_, (uint)sizeof(Vec3)));
    }

    /// <summary>Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
    /// Cost: O(elements).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="velocities">m/s</param>
    public unsafe void SetVelocities(uint body, uint first, ReadOnlySpan<Vec3> velocities) {
        var count = CommonLength(-1, velocities.Length);
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_set_velocities(Handle, body, first, count, velocities_, StrideOf(velocities)));
    }

    /// <summary>Masses of particles, kg. That of a pinned particle is what it has when it is released.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetMasses(uint body, uint first, Span<float> masses) {
        var count = (uint)masses.Length;
        fixed (float* masses_ = &MemoryMarshal.GetReference(masses))
        Check(Low.gphys_solver_get_masses(Handle, body, first, count, masses_, (uint)sizeof(float)));
    }

    /// <summary>Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
    /// Wakes the body.
    /// Cost: O(elements).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="masses">kg, &gt; 0</param>
    public unsafe void SetMasses(uint body, uint first, ReadOnlySpan<float> masses) {
        var count = CommonLength(-1, masses.Length);
        fixed (float* masses_ = &MemoryMarshal.GetReference(masses))
        Check(Low.gphys_solver_set_masses(Handle, body, first, count, masses_, StrideOf(masses)));
    }

    /// <summary>Collision radii of particles, metres.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetRadii(uint body, uint first, Span<float> radii) {
        var count = (uint)radii.Length;
        fixed (float* radii_ = &MemoryMarshal.GetReference(radii))
        Check(Low.gphys_solver_get_radii(Handle, body, first, count, radii_, (uint)sizeof(float)));
    }

    /// <summary>Change the collision radii of particles. Wakes the body.
    /// Cost: O(elements).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="radii">metres, &gt;= 0</param>
    public unsafe void SetRadii(uint body, uint first, ReadOnlySpan<float> radii) {
        var count = CommonLength(-1, radii.Length);
        fixed (float* radii_ = &MemoryMarshal.GetReference(radii))
        Check(Low.gphys_solver_set_radii(Handle, body, first, count, radii_, StrideOf(radii)));
    }

    /// <summary>Friction factors of particles; 1 until they are set.
    /// Cost: O(count). Since 1.1.</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetFrictionFactors(uint body, uint first, Span<float> factors) {
        var count = (uint)factors.Length;
        fixed (float* factors_ = &MemoryMarshal.GetReference(factors))
        Check(Low.gphys_solver_get_friction_factors(Handle, body, first, count, factors_, (uint)sizeof(float)));
    }

    /// <summary>Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
    /// contact, with models and with particles, the coefficients of a particle are the friction and the
    /// static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
    /// coefficients; Solver.SetBodySettings scales them all and keeps the factors. Wakes the body.
    /// Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="factors">&gt;= 0</param>
    public unsafe void SetFrictionFactors(uint body, uint first, ReadOnlySpan<float> factors) {
        var count = CommonLength(-1, factors.Length);
        fixed (float* factors_ = &MemoryMarshal.GetReference(factors))
        Check(Low.gphys_solver_set_friction_factors(Handle, body, first, count, factors_, StrideOf(factors)));
    }

    /// <summary>The forces that were set for particles, newtons.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetForces(uint body, uint first, Span<Vec3> forces) {
        var count = (uint)forces.Length;
        fixed (Vec3* forces_ = &MemoryMarshal.GetReference(forces))
        Check(Low.gphys_solver_get_forces(Handle, body, first, count, forces_, (uint)sizeof(Vec3)));
    }

    /// <summary>Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
    /// Cost: O(elements).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="forces">newtons</param>
    public unsafe void SetForces(uint body, uint first, ReadOnlySpan<Vec3> forces) {
        var count = CommonLength(-1, forces.Length);
        fixed (Vec3* forces_ = &MemoryMarshal.GetReference(forces))
        Check(Low.gphys_solver_set_forces(Handle, body, first, count, forces_, StrideOf(forces)));
    }

    /// <summary>Which particles are pinned or attached.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetPinned(uint body, uint first, Span<int> pinned) {
        var count = (uint)pinned.Length;
        fixed (int* pinned_ = &MemoryMarshal.GetReference(pinned))
        Check(Low.gphys_solver_get_pinned(Handle, body, first, count, pinned_, (uint)sizeof(int)));
    }

    /// <summary>Pin or release particles. A pinned particle stays where it is put and moves only by
    /// Solver.SetPositions, or with an animation target of maxDistance 0; else its speed is 0. Both pinning
    /// and releasing end an attachment.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    /// <param name="pinned">true: pin; false: release</param>
    public unsafe void SetPinned(uint body, uint first, uint count, bool pinned) {
        Check(Low.gphys_solver_set_pinned(Handle, body, first, count, pinned ? 1 : 0));
    }

    /// <summary>Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
    /// relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
    /// C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
    /// the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
    /// effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
    /// along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
    /// cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
    /// u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
    /// reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
    /// at the beginning of the step.
    /// Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
    /// as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.</summary>
    /// <param name="body">0: all bodies there are</param>
    /// <param name="wind">of density 0: no air</param>
    public unsafe void SetWind(uint body, Wind wind) {
        Check(Low.gphys_solver_set_wind(Handle, body, &wind));
    }

    /// <summary>The air around a body as it was set; zeros if it was not.
    /// Cost: O(1).</summary>
    public unsafe Wind GetWind(uint body) {
        var wind = default(Wind);
        Check(Low.gphys_solver_get_wind(Handle, body, &wind));
        return wind;
    }

    /// <summary>Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
    /// eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
    /// Cost: O(elements); the first time O(particles), and it allocates.</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="velocities">m/s</param>
    public unsafe void SetAirVelocities(uint body, uint first, ReadOnlySpan<Vec3> velocities) {
        var count = CommonLength(-1, velocities.Length);
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_set_air_velocities(Handle, body, first, count, velocities_, StrideOf(velocities)));
    }

    /// <summary>Velocities of the air at particles, m/s, beside that of Wind.
    /// Cost: O(count).</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetAirVelocities(uint body, uint first, Span<Vec3> velocities) {
        var count = (uint)velocities.Length;
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_get_air_velocities(Handle, body, first, count, velocities_, (uint)sizeof(Vec3)));
    }

    /// <summary>Give particles animation targets, before each step that is to follow an animation: a cape or skirt
    /// that is skinned to its character stays within maxDistance of the skinned vertices and does not sink
    /// into the body behind them. In the next step position and normal go evenly from the old target to the
    /// new one, substep by substep; distances act at once. A target that is not set again stands still. A
    /// first target, and that of a particle which Solver.SetPositions has moved since the last step, takes
    /// effect at its new place at once: to teleport, make that call and this one. If the body is attached
    /// to a model that jumps (Solver.Step), this call alone is enough. maxDistance 0 carries a particle: it
    /// is at its target, as if attached there, and moves links with infinite mass; this also moves a pinned
    /// particle, which stays pinned, at constant speed during a step. Otherwise particles that are pinned
    /// or attached are not moved. A particle that is out of its bounds at the end of a substep is put on
    /// the nearest place within both, without friction; its velocity across them is then that of the
    /// target. What lies within its bounds is not touched. Bounds act after constraints and before models:
    /// where a target is inside a model, or behind one, the particle stays outside. Links yield to bounds
    /// that contradict them. What hangs from a particle at its bounds is carried, in cloth and in ropes
    /// that are moved alone; ropes and free particles that are joined, or collide with bodies, are put back
    /// particle by particle, and links beside these may be strained by the motion of a substep. Wakes the
    /// body if a target changes.
    /// Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
    /// particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="targets">maxDistance and backstop INFINITY: no target any more</param>
    public unsafe void SetAnimationTargets(uint body, uint first, ReadOnlySpan<AnimationTarget> targets) {
        var count = CommonLength(-1, targets.Length);
        fixed (AnimationTarget* targets_ = &MemoryMarshal.GetReference(targets))
        Check(Low.gphys_solver_set_animation_targets(Handle, body, first, count, targets_, StrideOf(targets)));
    }

    /// <summary>Animation targets of particles as they were set; 0 and INFINITY of what has none.
    /// Cost: O(count). Since 1.1.</summary>
    /// <param name="first">as in Solver.GetPositions</param>
    /// <param name="count">as in Solver.GetPositions</param>
    public unsafe void GetAnimationTargets(uint body, uint first, Span<AnimationTarget> targets) {
        var count = (uint)targets.Length;
        fixed (AnimationTarget* targets_ = &MemoryMarshal.GetReference(targets))
        Check(Low.gphys_solver_get_animation_targets(Handle, body, first, count, targets_, (uint)sizeof(AnimationTarget)));
    }

    /// <summary>Fix a particle to a model: it follows the model's transform in each step, and is released when the
    /// model is gone. Steps must then be given this scene; in a step without one the particle stays where
    /// it is. If the model jumps (Solver.Step), the whole body goes with it as if it were rigid, and its
    /// velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
    /// particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
    /// constraints.
    /// Cost: O(1); allocates.</summary>
    /// <param name="scene">of the same origin as the solver; not modified</param>
    /// <param name="localPoint">in the model's coordinates, to which its transform applies, with the
    /// transform's scale, and not Scene.SetScale; null: where the particle is now</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for a particle that does not
    /// exist</exception>
    public unsafe void Attach(Scene scene, uint body, uint particle, uint model, Vec3? localPoint = null) {
        var localPoint_ = localPoint.GetValueOrDefault();
        Check(Low.gphys_solver_attach(Handle, scene.Handle, body, particle, model, localPoint.HasValue ? &localPoint_ : null));
    }

    /// <summary>Release an attached particle.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: if it is not attached, or does not
    /// exist</exception>
    public unsafe void Detach(uint body, uint particle) {
        Check(Low.gphys_solver_detach(Handle, body, particle));
    }

    /// <summary>The attachments of a body, by particle. One to a model that is gone is listed until the next step.
    /// Cost: O(attachments). Since 1.1.</summary>
    public unsafe Attachment[] GetAttachments(uint body) {
        var result = new Attachment[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Attachment* out_ = result)
            status = Low.gphys_solver_get_attachments(Handle, body, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Attachment[total];
        }
    }

    /// <summary>Hold two different particles of a body at a distance.
    /// Cost: O(1); the next step plans the body again, O(constraints).</summary>
    /// <param name="restLength">metres, &gt;= 0; negative: the present distance. Below 1e-9 m it counts as
    /// 0.</param>
    /// <param name="compliance">metres per newton, &gt;= 0; 0 is rigid</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for a particle that does not exist
    /// or twice the same one</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 constraints of a
    /// body</exception>
    public unsafe uint AddDistance(uint body, uint particleA, uint particleB, float restLength, float compliance = 0) {
        var constraint = default(uint);
        Check(Low.gphys_solver_add_distance(Handle, body, particleA, particleB, restLength, compliance, &constraint));
        return constraint;
    }

    /// <summary>Keep two different particles of a body from being further apart than a length, like a string between
    /// them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
    /// rigid, only the speed at which the particles separate is lost.
    /// Fails as Solver.AddDistance.
    /// It is a constraint like others: listed with maxLength as its restLength, removed as they are, and
    /// strained only when it is too long.
    /// Cost: as Solver.AddDistance.</summary>
    /// <param name="maxLength">metres, &gt;= 0; negative: the present distance. Below 1e-9 m it counts as
    /// 0.</param>
    /// <param name="compliance">metres per newton, &gt;= 0, of what it yields beyond that; 0 is
    /// rigid</param>
    public unsafe uint AddMaxDistance(uint body, uint particleA, uint particleB, float maxLength, float compliance = 0) {
        var constraint = default(uint);
        Check(Low.gphys_solver_add_max_distance(Handle, body, particleA, particleB, maxLength, compliance, &constraint));
        return constraint;
    }

    /// <summary>Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
    /// in addition to its tension; one of Solver.AddMaxDistance never pushes. The decay depends on time,
    /// not on steps. Rigid constraints have nothing to damp.
    /// Cost: as Solver.AddDistance.</summary>
    /// <param name="damping">N s/m, &gt;= 0; 0, which every constraint begins with: none</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a body or constraint that does not
    /// exist</exception>
    public unsafe void SetConstraintDamping(uint body, uint constraint, float damping) {
        Check(Low.gphys_solver_set_constraint_damping(Handle, body, constraint, damping));
    }

    /// <summary>Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
    /// setting it again changes it, which inflates a body.
    /// Cost: O(triangles) in each substep, twice. Allocates.</summary>
    /// <param name="restVolume">m^3, &gt; 0; negative: the present volume</param>
    /// <param name="compliance">m^3 per pascal, &gt;= 0: the volume that a pressure of one pascal takes; 0:
    /// as water, which keeps its volume; INFINITY: none, which ends the constraint</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if the triangles do not close (each
    /// side is that of two triangles), are not oriented consistently, or face inward when the present
    /// volume is asked for</exception>
    public unsafe void SetVolume(uint body, float restVolume, float compliance = 0) {
        Check(Low.gphys_solver_set_volume(Handle, body, restVolume, compliance));
    }

    /// <summary>The volume held by Solver.SetVolume, m^3, as it is, and the pressure in pascals with which it was
    /// held at the end of the last step: above 0 it pushes outward.
    /// Cost: O(triangles).</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if none is held</exception>
    public unsafe (float Volume, float Pressure) GetVolume(uint body) {
        var volume = default(float);
        var pressure = default(float);
        Check(Low.gphys_solver_get_volume(Handle, body, &volume, &pressure));
        return (volume, pressure);
    }

    /// <summary>What was given to Solver.SetVolume: m^3 (for a negative volume the one at that time), and m^3 per
    /// pascal.
    /// Cost: O(1). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: if none is held</exception>
    public unsafe (float Restvolume, float Compliance) GetVolumeSettings(uint body) {
        var restVolume = default(float);
        var compliance = default(float);
        Check(Low.gphys_solver_get_volume_settings(Handle, body, &restVolume, &compliance));
        return (restVolume, compliance);
    }

    /// <summary>Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
    /// triangles of cloth stay together: Solver.BreakConstraint tears them apart.
    /// Cost: as Solver.AddDistance; allocates.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a body or constraint that does not
    /// exist, or no longer</exception>
    public unsafe void RemoveConstraint(uint body, uint constraint) {
        Check(Low.gphys_solver_remove_constraint(Handle, body, constraint));
    }

    /// <summary>All constraints of a body, including those created with the body, by id.
    /// Cost: O(constraints).</summary>
    public unsafe ConstraintInfo[] GetConstraints(uint body) {
        var result = new ConstraintInfo[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (ConstraintInfo* out_ = result)
            status = Low.gphys_solver_get_constraints(Handle, body, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new ConstraintInfo[total];
        }
    }

    /// <summary>Which constraints keep a length, and which a maximum.
    /// Cost: O(elements). Since 1.1.</summary>
    /// <param name="constraints">the ids; one may appear twice</param>
    public unsafe void GetConstraintKinds(uint body, ReadOnlySpan<uint> constraints, Span<ConstraintKind> kinds) {
        var count = CommonLength(constraints.Length, 1);
        RequireLength(kinds.Length, count);
        fixed (uint* constraints_ = &MemoryMarshal.GetReference(constraints))
        fixed (ConstraintKind* kinds_ = &MemoryMarshal.GetReference(kinds))
        Check(Low.gphys_solver_get_constraint_kinds(Handle, body, constraints_, count, kinds_, (uint)sizeof(ConstraintKind)));
    }

    /// <summary>The present settings of constraints.
    /// Cost: O(elements).</summary>
    /// <param name="constraints">the ids; one may appear twice</param>
    public unsafe void GetConstraintSettings(uint body, ReadOnlySpan<uint> constraints, Span<ConstraintSettings> settings) {
        var count = CommonLength(constraints.Length, 1);
        RequireLength(settings.Length, count);
        fixed (uint* constraints_ = &MemoryMarshal.GetReference(constraints))
        fixed (ConstraintSettings* settings_ = &MemoryMarshal.GetReference(settings))
        Check(Low.gphys_solver_get_constraint_settings(Handle, body, constraints_, count, settings_, (uint)sizeof(ConstraintSettings)));
    }

    /// <summary>Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
    /// the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
    /// that is v dt shorter before each step of dt. Wakes the body.
    /// Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
    /// gets longer links O(n log n). Chains are not planned again. Allocates.</summary>
    /// <param name="constraints">the ids; one that appears twice gets the last</param>
    public unsafe void SetConstraintSettings(uint body, ReadOnlySpan<uint> constraints, ReadOnlySpan<ConstraintSettings> settings) {
        var count = CommonLength(constraints.Length, settings.Length);
        fixed (uint* constraints_ = &MemoryMarshal.GetReference(constraints))
        fixed (ConstraintSettings* settings_ = &MemoryMarshal.GetReference(settings))
        Check(Low.gphys_solver_set_constraint_settings(Handle, body, constraints_, settings_, StrideOf(settings), count));
    }

    /// <summary>Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
    /// turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links between
    /// them are not needed. A particle may be in several clusters: planks with two particles in common are
    /// hinged there, with one they are jointed. The mass of a cluster is that of its particles; hollow
    /// shapes are light in the middle. Particles that are pinned or attached stay where they are held: with
    /// one the cluster swings about it, with two about the line through them, and with three that are not
    /// on a line it does not move. Models that particles are attached to get the impulses. Contacts with
    /// models move the cluster as a whole, with friction; only particles touch, not the faces between them,
    /// so they should be no further apart than the thickness of the thinnest thing that a cluster meets. It
    /// bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its
    /// restitution that its particles in contact have of its mass. A shape is matched once in each substep,
    /// after the links: then what hangs from it by links may be strained a little, and clusters that share
    /// particles approach their shapes in eight passes. What is joined to it by Solver.Join is solved
    /// together with it, unless one of its particles is attached, or another cluster has it, too: hang
    /// heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
    /// cloth (SolveMethod.Graph), ropes and free particles too. The rest positions of cloth are not changed
    /// by a cluster.
    /// Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
    /// us one that touches a model, and up to eight times that if clusters of the body share particles; the
    /// first and the last cluster plan the body again, O(constraints). Since 1.1.</summary>
    /// <param name="particles">count different particles, at least 2</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for a particle that does not exist
    /// or appears twice</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 clusters of a body, or
    /// that many particles in them</exception>
    public unsafe uint AddCluster(uint body, ReadOnlySpan<uint> particles) {
        var count = CommonLength(particles.Length, 1);
        var cluster = default(uint);
        fixed (uint* particles_ = &MemoryMarshal.GetReference(particles))
        Check(Low.gphys_solver_add_cluster(Handle, body, particles_, count, &cluster));
        return cluster;
    }

    /// <summary>End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
    /// Cost: O(particles in clusters of the body). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a body or cluster that does not
    /// exist, or no longer</exception>
    public unsafe void RemoveCluster(uint body, uint cluster) {
        Check(Low.gphys_solver_remove_cluster(Handle, body, cluster));
    }

    /// <summary>All clusters of a body, by id.
    /// Cost: O(clusters). Since 1.1.</summary>
    public unsafe uint[] GetClusters(uint body) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_clusters(Handle, body, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>The particles of a cluster, in the order in which they were given.
    /// Cost: O(particles of the cluster). Since 1.1.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a body or cluster that does not
    /// exist, or no longer</exception>
    public unsafe uint[] GetClusterParticles(uint body, uint cluster) {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_cluster_particles(Handle, body, cluster, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
    /// are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
    /// clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
    /// of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
    /// longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
    /// removed with either body. Particles of the two that are linked to a joint within touch of each other
    /// do not collide there.
    /// Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
    /// of a rope that is not joined. Allocates.</summary>
    /// <param name="restLength">metres; 0: at the same place, as below 1e-9; negative: the present
    /// distance. Particles at another distance are moved to it in the next step; by a rigid joint without
    /// speed.</param>
    /// <param name="compliance">metres per newton, &gt;= 0; 0 is rigid</param>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for a particle that does not exist
    /// or twice the same body (see Solver.AddDistance)</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 joints</exception>
    public unsafe uint Join(uint bodyA, uint particleA, uint bodyB, uint particleB, float restLength, float compliance = 0) {
        var joint = default(uint);
        Check(Low.gphys_solver_join(Handle, bodyA, particleA, bodyB, particleB, restLength, compliance, &joint));
        return joint;
    }

    /// <summary>End a joint. Wakes both bodies.
    /// Cost: as Solver.Join.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidId: for a joint that does not exist, or no
    /// longer</exception>
    public unsafe void Unjoin(uint joint) {
        Check(Low.gphys_solver_unjoin(Handle, joint));
    }

    /// <summary>Joints of a body, by id.
    /// Cost: O(joints of the solver).</summary>
    /// <param name="body">0: of all bodies</param>
    public unsafe JointInfo[] GetJoints(uint body) {
        var result = new JointInfo[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (JointInfo* out_ = result)
            status = Low.gphys_solver_get_joints(Handle, body, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new JointInfo[total];
        }
    }

    /// <summary>Breaking forces of constraints. Wakes the body.
    /// Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
    /// pin. Allocates. Since 1.1.</summary>
    /// <param name="constraints">the ids; one that appears twice gets the last</param>
    /// <param name="forces">newtons, &gt;= 0; 0: never breaks, as all that are added to a body
    /// later</param>
    public unsafe void SetBreakingForces(uint body, ReadOnlySpan<uint> constraints, ReadOnlySpan<float> forces) {
        var count = CommonLength(constraints.Length, forces.Length);
        fixed (uint* constraints_ = &MemoryMarshal.GetReference(constraints))
        fixed (float* forces_ = &MemoryMarshal.GetReference(forces))
        Check(Low.gphys_solver_set_breaking_forces(Handle, body, constraints_, forces_, StrideOf(forces), count));
    }

    /// <summary>What Solver.SetBreakingForces or BodyDesc.breaking_force has set; 0: never breaks.
    /// Cost: O(elements). Since 1.1.</summary>
    /// <param name="constraints">the ids; one may appear twice</param>
    /// <returns>newtons.</returns>
    public unsafe void GetBreakingForces(uint body, ReadOnlySpan<uint> constraints, Span<float> forces) {
        var count = CommonLength(constraints.Length, 1);
        RequireLength(forces.Length, count);
        fixed (uint* constraints_ = &MemoryMarshal.GetReference(constraints))
        fixed (float* forces_ = &MemoryMarshal.GetReference(forces))
        Check(Low.gphys_solver_get_breaking_forces(Handle, body, constraints_, count, forces_, (uint)sizeof(float)));
    }

    /// <summary>Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
    /// Cost: O(particles + constraints); allocates. Since 1.1.</summary>
    /// <returns>what came of it.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: and nothing has changed, for an edge
    /// where the cloth cannot part: of a triangle that is connected to no other</exception>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^24 - 1 particles or
    /// constraints</exception>
    public unsafe Break BreakConstraint(uint body, uint constraint) {
        var result = default(Break);
        Check(Low.gphys_solver_break_constraint(Handle, body, constraint, &result));
        return result;
    }

    /// <summary>Constraints that broke in the last Solver.Step or Solver.Advance, in its order: for sounds, dust,
    /// and to know that a body has more particles. Not those that the caller broke. They are not part of
    /// snapshots: after Solver.Restore there are none.
    /// Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1.</summary>
    public unsafe Break[] GetBreaks() {
        var result = new Break[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Break* out_ = result)
            status = Low.gphys_solver_get_breaks(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Break[total];
        }
    }

    /// <summary>Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
    /// takes more where they would be longer than 25 ms.
    /// Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
    /// through particles. A model moves evenly from its place at the last step to its present one, unless
    /// it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
    /// that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
    /// is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
    /// Allocates when what it steps has changed.
    /// Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
    /// scene query for a body that the last step, of the same dt, left exactly as it was.</summary>
    /// <param name="scene">to collide with and to follow attachments; null: none. Not modified.</param>
    /// <param name="dt">seconds, 1e-6 .. 0.5</param>
    public unsafe void Step(float dt, Scene scene = null) {
        Check(Low.gphys_solver_step(Handle, scene == null ? SceneHandle.None : scene.Handle, dt));
    }

    /// <summary>Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
    /// so the motion does not depend on the frame rate. Models, pins and animation targets are given the
    /// places of the end of the frame. They move there evenly in the time since the last step: attached
    /// particles, pins and what lies on models are at their places of the time that the solver has reached,
    /// leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
    /// step.
    /// Cost: that of the steps made.</summary>
    /// <param name="frameTime">seconds, &gt;= 0</param>
    /// <returns>steps made. 0 &lt;= fraction of a step still owed &lt; 1, to interpolate when
    /// drawing.</returns>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: if there is none for the first step:
    /// nothing has changed. If there is none for a later one</exception>
    public unsafe (uint Steps, float Leftover) Advance(float frameTime, Scene scene = null) {
        var steps = default(uint);
        var leftover = default(float);
        Check(Low.gphys_solver_advance(Handle, scene == null ? SceneHandle.None : scene.Handle, frameTime, &steps, &leftover));
        return (steps, leftover);
    }

    /// <summary>The fraction of a step that Solver.Advance still owes: what it gave last as leftover, unless the
    /// solver was restored or given another fixed_step since.
    /// Cost: O(1). Since 1.1.</summary>
    /// <returns>from 0 to below 1.</returns>
    public unsafe float GetLeftover() {
        var leftover = default(float);
        Check(Low.gphys_solver_get_leftover(Handle, &leftover));
        return leftover;
    }

    /// <summary>The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain or
    /// tolerance set, each body takes as many as its own motion needs: their length follows from what the
    /// last step measured, the largest strain of its rigid constraints and the local error of the time
    /// scheme, both proportional to the square of that length. It is at most quartered and grows by at most
    /// an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
    /// strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
    /// max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
    /// by contacts, the error is that of the jump. What may meet others takes at least the set number.
    /// Cost: O(1).</summary>
    public unsafe uint GetSubsteps(uint body) {
        var substeps = default(uint);
        Check(Low.gphys_solver_get_substeps(Handle, body, &substeps));
        return substeps;
    }

    /// <summary>Counts, strain and energy of a body at present.
    /// Cost: O(particles + constraints).</summary>
    /// <param name="body">0: all bodies together</param>
    public unsafe SolverStats GetStats(uint body) {
        var stats = default(SolverStats);
        Check(Low.gphys_solver_get_stats(Handle, body, &stats));
        return stats;
    }

    /// <summary>Contacts of the last step by body, particle, model.
    /// Cost: O(contacts).</summary>
    public unsafe Contact[] GetContacts() {
        var result = new Contact[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Contact* out_ = result)
            status = Low.gphys_solver_get_contacts(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Contact[total];
        }
    }

    /// <summary>Contacts between bodies in the last step, of any substep, by bodyA, particleA, bodyB, particleB: for
    /// sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep. Contacts
    /// with a body that was removed are no longer listed. They are not part of snapshots: after
    /// Solver.Restore there are none until the next step. Contacts within a body (BodyDesc.self_collision)
    /// are not listed. where particles have more than 12 contacts on average, not all are known.
    /// Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1.</summary>
    public unsafe BodyContact[] GetBodyContacts() {
        var result = new BodyContact[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (BodyContact* out_ = result)
            status = Low.gphys_solver_get_body_contacts(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new BodyContact[total];
        }
    }

    /// <summary>Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
    /// which they fell asleep. After Solver.Advance, times the steps that it made, they are those of the
    /// frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
    /// particle of cloth that touches several models at once gives its impulse to the one that it touches
    /// most. Models have no mass here: the step does as if they went where you put them, whatever the
    /// force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
    /// well below the mass of the body, which needs some damping; a body of yours much lighter than what
    /// hangs from it should be moved in small steps.
    /// Cost: O(models touched); no allocation. The same bits for any number of workers.</summary>
    public unsafe Impulse[] GetImpulses() {
        var result = new Impulse[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (Impulse* out_ = result)
            status = Low.gphys_solver_get_impulses(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new Impulse[total];
        }
    }

    /// <summary>Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
    /// impulses, time that Solver.Advance still owes. The scene, workers and allocator are not in it.
    /// Cost: O(particles + constraints), some 50 words for each.</summary>
    /// <returns>the snapshot. It is for the same release of the library and machines of the same byte
    /// order; it may be stored, but not changed.</returns>
    /// <exception cref="GamephysException">Status.ErrorCapacity: beyond 2^32 - 1 words</exception>
    public unsafe uint[] GetSnapshot() {
        var result = new uint[Guess];
        for (;;) {
            uint total;
            Status status;
            fixed (uint* out_ = result)
            status = Low.gphys_solver_get_snapshot(Handle, out_, (uint)result.Length, &total);
            Check(status);
            if (status != Status.Incomplete) {
                Array.Resize(ref result, (int)total);
                return result;
            }
            result = new uint[total];
        }
    }

    /// <summary>Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
    /// time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
    /// too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
    /// source: all that is used as a number or an index is checked first. Forged words are refused, or
    /// taken as a state whose numbers are in range.
    /// Cost: as Solver.GetSnapshot; allocates.</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for words that are no snapshot,
    /// damaged, of another version or byte order</exception>
    /// <exception cref="GamephysException">Status.ErrorOutOfMemory: if there is no room for it</exception>
    public unsafe void Restore(ReadOnlySpan<uint> words) {
        var count = CommonLength(words.Length, 1);
        fixed (uint* words_ = &MemoryMarshal.GetReference(words))
        Check(Low.gphys_solver_restore(Handle, words_, count));
    }

    /// <summary>A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
    /// different ones differ with near certainty (not against an adversary). Compare it between machines
    /// that run the same simulation, to detect when they diverge.
    /// Cost: O(particles + constraints).</summary>
    public unsafe uint[] GetHash() {
        var hash = new uint[2];
        fixed (uint* hash_ = hash)
        Check(Low.gphys_solver_get_hash(Handle, hash_));
        return hash;
    }

}

/// <summary>Questions about single shapes, without a scene.</summary>
public static partial class Geometry {
    /// <summary>Whether the fields of the shape are in the ranges stated beside its struct.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: and the exception's message names
    /// the field</exception>
    public static unsafe void Validate(Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var status = Low.gphys_shape_validate(shape.Type, shape_);
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
    /// Cost: O(1), for a mesh too.</summary>
    /// <returns>null for a plane, a ray without end (or with one beyond all floats) and a frustum that
    /// extends to infinity; for an empty mesh or frustum.</returns>
    public static unsafe Aabb? Bounds(Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var bounds = default(Aabb);
        var status = Low.gphys_shape_bounds(shape.Type, shape_, &bounds);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
    /// answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
    /// rotation in double precision). Others are as Geometry.Overlaps with a sphere.
    /// Cost: O(1); O(log n) expected for a mesh.</summary>
    /// <param name="tolerance">metres, &gt;= 0</param>
    public static unsafe bool Contains(Shape shape, Vec3 point, float tolerance = 0) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var contains = default(int);
        var status = Low.gphys_shape_contains(shape.Type, shape_, &point, tolerance, &contains);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return contains != 0;
    }

    /// <summary>Whether each of the points is within tolerance metres of one shape, as Geometry.Contains.
    /// Cost: that of as many single calls.</summary>
    /// <param name="tolerance">metres, &gt;= 0, for all points</param>
    public static unsafe void ContainsBatch(Shape shape, ReadOnlySpan<Vec3> points, Span<int> contains, float tolerance = 0) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var count = CommonLength(-1, points.Length);
        RequireLength(contains.Length, count);
        Status status;
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (int* contains_ = &MemoryMarshal.GetReference(contains))
        status = Low.gphys_shape_contains_batch(shape.Type, shape_, points_, StrideOf(points), count, tolerance, contains_, (uint)sizeof(int));
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
    /// ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
    /// difference. If several are equally close, one of them, always the same. For a ray, t is limited by
    /// t_max.
    /// Cost: O(1); O(log n) expected for a mesh.</summary>
    /// <returns>null only for an empty mesh or an empty frustum.</returns>
    public static unsafe Nearest? ClosestPoint(Shape shape, Vec3 point) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var nearest = default(Nearest);
        var status = Low.gphys_shape_closest_point(shape.Type, shape_, &point, &nearest);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? nearest : (Nearest?)null;
    }

    /// <summary>The points of one shape that are closest to each of the points, as Geometry.ClosestPoint. An element
    /// for which there is none gets distance INFINITY.
    /// Cost: that of as many single calls.</summary>
    public static unsafe void ClosestPointBatch(Shape shape, ReadOnlySpan<Vec3> points, Span<Nearest> nearest) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var count = CommonLength(-1, points.Length);
        RequireLength(nearest.Length, count);
        Status status;
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (Nearest* nearest_ = &MemoryMarshal.GetReference(nearest))
        status = Low.gphys_shape_closest_point_batch(shape.Type, shape_, points_, StrideOf(points), count, nearest_, (uint)sizeof(Nearest));
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>The closest points of two segments and their distance. Parallel segments have many: the first along
    /// a, always the same.
    /// Cost: O(1).</summary>
    /// <returns>metres.</returns>
    public static unsafe (Vec3 Outa, Vec3 Outb, float Distance) SegmentClosestPoints(Segment a, Segment b) {
        var outA = default(Vec3);
        var outB = default(Vec3);
        var distance = default(float);
        Check(Low.gphys_segment_closest_points(&a, &b, &outA, &outB, &distance));
        return (outA, outB, distance);
    }

    /// <summary>Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
    /// frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
    /// not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes, triangles, meshes and
    /// frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
    /// the largest coordinate difference.
    /// Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or segment (see
    /// Geometry.SegmentTest)</exception>
    public static unsafe bool Overlaps(Shape a, Shape b) {
        void* a_ = a.Mesh == null ? (void*)&a.Data : a.Mesh.Pointer;
        void* b_ = b.Mesh == null ? (void*)&b.Data : b.Mesh.Pointer;
        var overlaps = default(int);
        var status = Low.gphys_shape_overlaps(a.Type, a_, b.Type, b_, &overlaps);
        GC.KeepAlive(a.Mesh);
        GC.KeepAlive(b.Mesh);
        Check(status);
        return overlaps != 0;
    }

    /// <summary>Whether the shapes of each of the pairs overlap, as Geometry.Overlaps: pair i is a[i] against b[i].
    /// Cost: that of as many single calls.</summary>
    /// <param name="a">shapes of one type</param>
    /// <param name="b">shapes of one type</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for rays and segments</exception>
    public static unsafe void OverlapsBatch(Shapes a, Shapes b, Span<int> overlaps) {
        var aOne = a.One;
        var bOne = b.One;
        var count = CommonLength(-1, a.Count, b.Count);
        RequireLength(overlaps.Length, count);
        Status status;
        fixed (byte* aFirst = &MemoryMarshal.GetReference(a.Bytes))
        fixed (byte* bFirst = &MemoryMarshal.GetReference(b.Bytes))
        fixed (int* overlaps_ = &MemoryMarshal.GetReference(overlaps))
        status = Low.gphys_shape_overlaps_batch(a.Type, a.IsOne ? (aOne.Mesh == null ? (void*)&aOne.Data : aOne.Mesh.Pointer) : aFirst, a.Stride, b.Type, b.IsOne ? (bOne.Mesh == null ? (void*)&bOne.Data : bOne.Mesh.Pointer) : bFirst, b.Stride, count, overlaps_, (uint)sizeof(int));
        GC.KeepAlive(aOne.Mesh);
        GC.KeepAlive(bOne.Mesh);
        Check(status);
    }

    /// <summary>Classify a sphere, capsule, AABB, OBB or triangle against a plane.
    /// Cost: O(1).</summary>
    /// <returns>metres, of the shape's nearest point to the plane: &gt; 0 in front, &lt; 0 behind, 0 when
    /// crossing.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types of shapes</exception>
    public static unsafe (Side Side, float Signeddistance) ClassifyPlane(Shape shape, Plane plane) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var side = default(Side);
        var signedDistance = default(float);
        var status = Low.gphys_shape_classify_plane(shape.Type, shape_, &plane, &side, &signedDistance);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return (side, signedDistance);
    }

    /// <summary>Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
    /// point is shared, inside that the frustum holds the whole shape.
    /// Cost: O(1).</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for other types of shapes</exception>
    public static unsafe Side ClassifyFrustum(Shape shape, Frustum frustum) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var side = default(Side);
        var status = Low.gphys_shape_classify_frustum(shape.Type, shape_, &frustum, &side);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return side;
    }

    /// <summary>First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
    /// and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
    /// always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
    /// all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
    /// distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
    /// docs/accuracy.md has the bounds of all functions.
    /// Cost: O(1); O(log n) expected for a mesh.</summary>
    /// <returns>null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or a segment as the
    /// shape</exception>
    public static unsafe Hit? Raycast(Shape shape, Ray ray) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_raycast(shape.Type, shape_, &ray, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First hits of the rays with one shape, as Geometry.Raycast. A ray that hits nothing gets t =
    /// INFINITY, triangle = NoTriangle and zeros in its hits element.
    /// Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.</summary>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or a segment as the
    /// shape</exception>
    public static unsafe void RaycastBatch(Shape shape, ReadOnlySpan<Ray> rays, Span<Hit> hits) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        Status status;
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        status = Low.gphys_shape_raycast_batch(shape.Type, shape_, rays_, StrideOf(rays), count, hits_, (uint)sizeof(Hit));
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
    /// segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
    /// direction, the normal is zero.
    /// Cost: as Geometry.Raycast.</summary>
    /// <returns>null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or a segment as the
    /// shape</exception>
    public static unsafe Hit? SegmentTest(Shape shape, Segment segment) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_segment_test(shape.Type, shape_, &segment, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
    /// triangle, frustum or mesh.
    /// Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
    /// Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
    /// mesh.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <returns>t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
    /// the sphere's centre; in double precision its dot with the displacement is never above 0. Already
    /// overlapping: t = 0, HitInside, and the normal may be along the displacement too; where the centre
    /// itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere of radius
    /// 0 gets the hit of the ray along its path. null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or a segment as the
    /// shape</exception>
    public static unsafe Hit? SweepSphere(Shape shape, Sphere sphere, Vec3 displacement) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_sweep_sphere(shape.Type, shape_, &sphere, &displacement, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
    /// sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
    /// be the hull of its corners (Geometry.FrustumCorners).
    /// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
    /// ulp of t. Point and normal are those of that contact.
    /// Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.</summary>
    /// <param name="displacement">metres; may be zero</param>
    /// <returns>t, point and normal as in Geometry.SweepSphere, which gives the answer for a sphere. The
    /// point is one of those where the two touch, always the same. Already overlapping, except for a
    /// sphere: t = 0, HitInside, and point and normal of Geometry.Penetration; for a mesh that is not a
    /// hull, those of its first triangle. null if nothing is found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for a ray or a segment as the shape,
    /// for a frustum that is not the hull of its corners, unless a sphere moves, and for other types that
    /// move</exception>
    public static unsafe Hit? Sweep(Shape shape, Shape moving, Vec3 displacement) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        void* moving_ = moving.Mesh == null ? (void*)&moving.Data : moving.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_sweep(shape.Type, shape_, moving.Type, moving_, &displacement, &hit);
        GC.KeepAlive(shape.Mesh);
        GC.KeepAlive(moving.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>First contacts of count moving shapes of one type with the shapes of another, as Geometry.Sweep:
    /// moving[i] with shapes[i]. One that touches nothing gets t = INFINITY, triangle = NoTriangle and
    /// zeros.
    /// Cost: that of as many single calls. Since 1.1.</summary>
    /// <param name="shapes">shapes of one type</param>
    /// <param name="moving">shapes of one type</param>
    /// <param name="displacements">metres</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Geometry.Sweep</exception>
    public static unsafe void SweepBatch(Shapes shapes, Shapes moving, ReadOnlySpan<Vec3> displacements, Span<Hit> hits) {
        var shapesOne = shapes.One;
        var movingOne = moving.One;
        var count = CommonLength(-1, shapes.Count, moving.Count, displacements.Length);
        RequireLength(hits.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (byte* movingFirst = &MemoryMarshal.GetReference(moving.Bytes))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        status = Low.gphys_shape_sweep_batch(shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, moving.Type, moving.IsOne ? (movingOne.Mesh == null ? (void*)&movingOne.Data : movingOne.Mesh.Pointer) : movingFirst, moving.Stride, displacements_, StrideOf(displacements), count, hits_, (uint)sizeof(Hit));
        GC.KeepAlive(shapesOne.Mesh);
        GC.KeepAlive(movingOne.Mesh);
        Check(status);
    }

    /// <summary>The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
    /// OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
    /// that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
    /// translations of their own. Of a hull: out of all of it, and triangle is NoTriangle. A frustum must
    /// be the hull of its corners (Geometry.FrustumCorners).
    /// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
    /// ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
    /// shape. Added to float positions, the translation may leave an overlap as large as the spacing of
    /// floats there.
    /// Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
    /// separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
    /// Keerthi 1988).</summary>
    /// <returns>depth and normal of the translation, which is their product; of several equally short ones
    /// always the same one. The deepest point of the solid is point - depth * normal. null if nothing is
    /// found.</returns>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: for rays, segments, frusta that are not
    /// the hull of their corners, and for other types that move</exception>
    public static unsafe Penetration? Penetration(Shape shape, Shape moving) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        void* moving_ = moving.Mesh == null ? (void*)&moving.Data : moving.Mesh.Pointer;
        var penetration = default(Penetration);
        var status = Low.gphys_shape_penetration(shape.Type, shape_, moving.Type, moving_, &penetration);
        GC.KeepAlive(shape.Mesh);
        GC.KeepAlive(moving.Mesh);
        return Found(status) ? penetration : (Penetration?)null;
    }

    /// <summary>The shortest translations that take the shapes of one type out of the shapes of another, as
    /// Geometry.Penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY,
    /// triangle = NoTriangle and zeros.
    /// Cost: that of as many single calls. Since 1.1.</summary>
    /// <param name="shapes">shapes of one type</param>
    /// <param name="moving">shapes of one type</param>
    /// <exception cref="GamephysException">Status.ErrorUnsupported: as Geometry.Penetration</exception>
    public static unsafe void PenetrationBatch(Shapes shapes, Shapes moving, Span<Penetration> penetrations) {
        var shapesOne = shapes.One;
        var movingOne = moving.One;
        var count = CommonLength(-1, shapes.Count, moving.Count);
        RequireLength(penetrations.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (byte* movingFirst = &MemoryMarshal.GetReference(moving.Bytes))
        fixed (Penetration* penetrations_ = &MemoryMarshal.GetReference(penetrations))
        status = Low.gphys_shape_penetration_batch(shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, moving.Type, moving.IsOne ? (movingOne.Mesh == null ? (void*)&movingOne.Data : movingOne.Mesh.Pointer) : movingFirst, moving.Stride, count, penetrations_, (uint)sizeof(Penetration));
        GC.KeepAlive(shapesOne.Mesh);
        GC.KeepAlive(movingOne.Mesh);
        Check(status);
    }

    /// <summary>The eight corners, each the intersection of three planes: near then far, each in the order
    /// left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
    /// intersections themselves, not rounded to floats) if each is within MaxCoordinate and in front of the
    /// three planes that do not meet there, by more than 2^-39 of its distance from origin; that is, unless
    /// it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and pushed
    /// out of it; for the bounds of their errors, origin counts as a corner.
    /// Cost: O(1).</summary>
    /// <returns>null if three planes do not meet in a point (infinite far plane), or meet beyond the
    /// largest float.</returns>
    public static unsafe Vec3[] FrustumCorners(Frustum frustum) {
        var corners = new Vec3[8];
        Status status;
        fixed (Vec3* corners_ = corners)
        status = Low.gphys_frustum_corners(&frustum, corners_);
        return Found(status) ? corners : null;
    }

    /// <summary>The point that three planes have in common, within an ulp of each coordinate.
    /// Cost: O(1). Source: Cramer's rule. Since 1.1.</summary>
    /// <returns>null if the planes have no single point in common, which is decided exactly, or one beyond
    /// MaxCoordinate.</returns>
    public static unsafe Vec3? PlanesIntersection(Plane a, Plane b, Plane c) {
        var point = default(Vec3);
        var status = Low.gphys_planes_intersection(&a, &b, &c, &point);
        return Found(status) ? point : (Vec3?)null;
    }

    /// <summary>The points of the triples of planes, as Geometry.PlanesIntersection; one without gets x = y = z =
    /// INFINITY.
    /// Cost: that of as many single calls. Since 1.1.</summary>
    /// <param name="a">the planes</param>
    /// <param name="b">the planes</param>
    /// <param name="c">the planes</param>
    public static unsafe void PlanesIntersectionBatch(ReadOnlySpan<Plane> a, ReadOnlySpan<Plane> b, ReadOnlySpan<Plane> c, Span<Vec3> points) {
        var count = CommonLength(-1, a.Length, b.Length, c.Length);
        RequireLength(points.Length, count);
        fixed (Plane* a_ = &MemoryMarshal.GetReference(a))
        fixed (Plane* b_ = &MemoryMarshal.GetReference(b))
        fixed (Plane* c_ = &MemoryMarshal.GetReference(c))
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        Check(Low.gphys_planes_intersection_batch(a_, StrideOf(a), b_, StrideOf(b), c_, StrideOf(c), count, points_, (uint)sizeof(Vec3)));
    }

    /// <summary>How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
    /// the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
    /// for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
    /// Cost: O(1). Since 1.1.</summary>
    /// <param name="matrix">elements within MaxCoordinate</param>
    public static unsafe float Mat4Orthonormality(Mat4 matrix) {
        var deviation = default(float);
        Check(Low.gphys_mat4_orthonormality(&matrix, &deviation));
        return deviation;
    }

    /// <summary>The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
    /// origin (0, 0, 0). For a camera, Camera.GetFrustum is more precise.
    /// Cost: O(1).</summary>
    /// <param name="reverseZ">false: near has the low depth; true: near has the high depth</param>
    /// <exception cref="GamephysException">Status.ErrorSingular: if the matrix has no inverse, or what it
    /// shows has no volume: its four near corners are not all finite points in front of the
    /// viewer</exception>
    public static unsafe Frustum FrustumFromMatrix(Mat4 viewProjection, DepthRange depthRange, bool reverseZ) {
        var frustum = default(Frustum);
        Check(Low.gphys_frustum_from_matrix(&viewProjection, depthRange, reverseZ ? 1 : 0, &frustum));
        return frustum;
    }

    /// <summary>Examine arrays without building anything. Allocates while it runs.
    /// Cost: O(n log n).</summary>
    /// <param name="vertices">elements of 3 floats, metres</param>
    /// <param name="indices">numbers, three for each triangle</param>
    /// <returns>what was found; indices out of range and bad vertices are counted, not refused.</returns>
    /// <exception cref="GamephysException">Status.ErrorInvalidArgument: for an indexCount that is no
    /// multiple of 3</exception>
    public static unsafe MeshReport MeshCheck(ReadOnlySpan<Vec3> vertices, ReadOnlySpan<uint> indices) {
        var report = default(MeshReport);
        fixed (Vec3* vertices_ = &MemoryMarshal.GetReference(vertices))
        fixed (uint* indices_ = &MemoryMarshal.GetReference(indices))
        Check(Low.gphys_mesh_check((float*)vertices_, SizeOf(vertices), (uint)vertices.Length, indices_, (uint)indices.Length, &report));
        return report;
    }

}

}
