// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
using System;
using System.Runtime.InteropServices;
using static Gamephys.Support;

namespace Gamephys {

/// <summary>Owns a gphys_mesh: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Mesh : IDisposable {
    internal readonly MeshHandle Handle;

    /// <summary>
    /// Build a mesh from copies of the arrays. Triangles of zero area are kept: they are met like the
    /// segments or points that they are, and counted in the report. 0 triangles are allowed.
    /// @param desc  may be NULL
    /// @return GPHYS_ERROR_INVALID_ARGUMENT for an index out of range, an index_count that is no
    ///         multiple of 3 or a bad vertex; gphys_mesh_check tells which.
    /// Cost: O(n log n), about 1 us per triangle.
    /// </summary>
    public unsafe Mesh(ReadOnlySpan<Vec3> vertices, ReadOnlySpan<uint> indices, MeshDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        fixed (Vec3* vertices_ = &MemoryMarshal.GetReference(vertices))
        fixed (uint* indices_ = &MemoryMarshal.GetReference(indices))
        Check(Low.gphys_mesh_create(desc.HasValue ? &desc_ : null, (float*)vertices_, SizeOf(vertices), (uint)vertices.Length, indices_, (uint)indices.Length, &made));
        Handle = new MeshHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>What the mesh was built from.</summary>
    public unsafe MeshReport GetReport() {
        var report = default(MeshReport);
        Check(Low.gphys_mesh_get_report(Handle, &report));
        return report;
    }

    /// <summary>Copy the vertices out; in their original order.</summary>
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

    /// <summary>Copy the indices out; in their original order.</summary>
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

    /// <summary>
    /// All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
    /// Kept when the array is too small: the first ones.  @return GPHYS_OK (also for 0 hits)
    /// </summary>
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

    /// <summary>Whether a ray hits anything; cheaper than the closest hit.</summary>
    public unsafe bool RaycastAny(Ray ray) {
        var hit = default(int);
        Check(Low.gphys_mesh_raycast_any(Handle, &ray, &hit));
        return hit != 0;
    }

    /// <summary>
    /// Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
    /// ascending. Kept when the array is too small: the lowest.
    /// </summary>
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

    /// <summary>Cost: O(nodes).</summary>
    public unsafe OctreeStats GetOctreeStats() {
        var stats = default(OctreeStats);
        Check(Low.gphys_mesh_get_octree_stats(Handle, &stats));
        return stats;
    }

    /// <summary>Boxes of the tree, each parent before its children. Kept when too many: the first.</summary>
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

    /// <summary>
    /// With a worker_count of n, all batch queries of the scene (gphys_camera_pick_batch too), and
    /// adding and moving many models, share their work among n threads; the results have the same bits
    /// for every n. Without a task_runner n - 1 threads are started here and joined by
    /// gphys_scene_destroy. They serve one call at a time: others that come meanwhile do their own
    /// work. They take no signals but faults, and the floating-point settings of the thread that
    /// created them. In a child of fork they are gone: calls there run on one thread, as they do on a
    /// platform without threads (WebAssembly, unless built for shared memory), whatever is asked for.
    /// @param desc  may be NULL
    /// @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started
    /// </summary>
    public unsafe Scene(SceneDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_scene_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new SceneHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>
    /// Move the point of the world that all coordinates of the scene count from, those that it is given
    /// and those that it returns. Models stay where they are in the world: the positions of those without
    /// a parent become what they are from there, kept in double precision and rounded to float32 once,
    /// however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
    /// and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
    /// @param origin  x, y, z in the world, within GPHYS_MAX_COORDINATE; before the first call 0 0 0
    /// @return GPHYS_ERROR_INVALID_ARGUMENT also if a model would leave the range of coordinates
    /// Cost: that of gphys_scene_set_transforms of all models, and 24 bytes a model from the first call
    /// on. Queries cost nothing more.
    /// </summary>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_scene_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the scene's coordinates count from.</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_scene_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>
    /// Add a model.
    /// @param type       sphere, capsule, AABB, OBB, plane, triangle or mesh
    /// @param shape      in the model's own coordinates
    /// @param transform  local; NULL is the identity
    /// @param desc       NULL: no parent, layer 1, tag 0
    /// @return GPHYS_ERROR_UNSUPPORTED for another type, GPHYS_ERROR_INVALID_ID for a stale parent,
    ///         GPHYS_ERROR_CAPACITY
    /// Cost: O(log n) amortised.
    /// </summary>
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

    /// <summary>
    /// Add count models of one type, all or none. A stride of 0 shares one shape or transform (a mesh
    /// needs shape_stride 0). transforms may be NULL. out_models has count elements.
    /// </summary>
    public unsafe void AddBatch(Shapes shapes, Span<uint> models, ReadOnlySpan<Transform> transforms = default(ReadOnlySpan<Transform>), ModelDesc? desc = null) {
        var shapesOne = shapes.One;
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, shapes.Count, Optional(transforms.Length));
        RequireLength(models.Length, count);
        Status status;
        fixed (byte* shapesFirst = &MemoryMarshal.GetReference(shapes.Bytes))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        status = Low.gphys_scene_add_batch(Handle, shapes.Type, shapes.IsOne ? (shapesOne.Mesh == null ? (void*)&shapesOne.Data : shapesOne.Mesh.Pointer) : shapesFirst, shapes.Stride, transforms_, StrideOf(transforms), count, desc.HasValue ? &desc_ : null, models_);
        GC.KeepAlive(shapesOne.Mesh);
        Check(status);
    }

    /// <summary>Remove a model. Its children stay where they are in the world and lose their parent.</summary>
    public unsafe void Remove(uint model) {
        Check(Low.gphys_scene_remove(Handle, model));
    }

    /// <summary>Remove models, all or none. An id that stands twice is GPHYS_ERROR_INVALID_ID.</summary>
    public unsafe void RemoveBatch(ReadOnlySpan<uint> models) {
        var count = CommonLength(models.Length, 1);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        Check(Low.gphys_scene_remove_batch(Handle, models_, count));
    }

    /// <summary>Remove a model and all its descendants.</summary>
    public unsafe void RemoveSubtree(uint model) {
        Check(Low.gphys_scene_remove_subtree(Handle, model));
    }

    /// <summary>Remove all. Ids given out before stay invalid.</summary>
    public unsafe void Clear() {
        Check(Low.gphys_scene_clear(Handle));
    }

    /// <summary>Ids of all models, ascending. Kept when too many: the lowest.</summary>
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

    /// <summary>Kind, parent, layers, tag and number of children of a model.</summary>
    public unsafe ModelInfo GetInfo(uint model) {
        var info = default(ModelInfo);
        Check(Low.gphys_scene_get_info(Handle, model, &info));
        return info;
    }

    /// <summary>
    /// World box of a model, by which queries find it: holds it, and is at most 3 ulps and 2^-19 of the sum
    /// of its sizes wider. GPHYS_UNBOUNDED for a plane. That of an empty mesh is its position.
    /// </summary>
    public unsafe Aabb? GetBounds(uint model) {
        var bounds = default(Aabb);
        var status = Low.gphys_scene_get_bounds(Handle, model, &bounds);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>World box of all bounded models; GPHYS_NO_HIT if there are none. Planes are left out.</summary>
    public unsafe Aabb? GetSceneBounds() {
        var bounds = default(Aabb);
        var status = Low.gphys_scene_get_scene_bounds(Handle, &bounds);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>Change which queries see a model, or what its hits report. Children are not affected.</summary>
    public unsafe void SetLayers(uint model, uint layers = Constants.AllLayers) {
        Check(Low.gphys_scene_set_layers(Handle, model, layers));
    }

    public unsafe void SetTag(uint model, uint tag) {
        Check(Low.gphys_scene_set_tag(Handle, model, tag));
    }

    /// <summary>
    /// Hang a model below another one, or below none (0).
    /// @param keep_world  0: the local transform is kept, the model jumps; 1: the local transform is
    ///                    changed so that the world transform stays (within float32 rounding)
    /// @return GPHYS_ERROR_CYCLE if parent is the model or one of its descendants
    /// </summary>
    public unsafe void SetParent(uint model, uint parent, bool keepWorld) {
        Check(Low.gphys_scene_set_parent(Handle, model, parent, keepWorld ? 1 : 0));
    }

    /// <summary>Set one local transform. Descendants follow. Cost: O(log n) for each model that moves.</summary>
    public unsafe void SetTransform(uint model, Transform transform) {
        Check(Low.gphys_scene_set_transform(Handle, model, &transform));
    }

    /// <summary>
    /// Set many, all or none; a model that stands twice gets the last. Cost: O(log n) for each model
    /// that moves when few move, O(n) when many do.
    /// </summary>
    public unsafe void SetTransforms(ReadOnlySpan<uint> models, ReadOnlySpan<Transform> transforms) {
        var count = CommonLength(models.Length, transforms.Length);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_set_transforms(Handle, models_, transforms_, StrideOf(transforms), count));
    }

    public unsafe void GetTransforms(ReadOnlySpan<uint> models, Span<Transform> transforms) {
        var count = CommonLength(models.Length, 1);
        RequireLength(transforms.Length, count);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_get_transforms(Handle, models_, count, transforms_, (uint)sizeof(Transform)));
    }

    public unsafe void GetWorldTransforms(ReadOnlySpan<uint> models, Span<Transform> transforms) {
        var count = CommonLength(models.Length, 1);
        RequireLength(transforms.Length, count);
        fixed (uint* models_ = &MemoryMarshal.GetReference(models))
        fixed (Transform* transforms_ = &MemoryMarshal.GetReference(transforms))
        Check(Low.gphys_scene_get_world_transforms(Handle, models_, count, transforms_, (uint)sizeof(Transform)));
    }

    /// <summary>
    /// Closest model on a ray; the fields are exact as in gphys_shape_raycast.
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public unsafe Hit? Raycast(Ray ray, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_raycast(Handle, &ray, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    public unsafe void RaycastBatch(ReadOnlySpan<Ray> rays, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_batch(Handle, rays_, StrideOf(rays), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.</summary>
    public unsafe bool RaycastAny(Ray ray, uint layers = Constants.AllLayers) {
        var hit = default(int);
        Check(Low.gphys_scene_raycast_any(Handle, &ray, layers, &hit));
        return hit != 0;
    }

    public unsafe void RaycastAnyBatch(ReadOnlySpan<Ray> rays, Span<int> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, rays.Length);
        RequireLength(hits.Length, count);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        fixed (int* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_raycast_any_batch(Handle, rays_, StrideOf(rays), count, layers, hits_, (uint)sizeof(int)));
    }

    /// <summary>
    /// Every model that a ray meets, each once with its first hit, by t, then id. Kept when too many:
    /// the first.
    /// </summary>
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

    /// <summary>
    /// The hits of ray i stand at out_hits[out_offsets[i]] up to out_offsets[i + 1].
    /// @param out_offsets  count + 1 numbers, always complete, so that a second call can have enough
    ///                     room. Where a ray's range crosses capacity, its first hits are written.
    /// What stands in out_hits behind the last hit afterwards is unspecified.
    /// @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] &gt; capacity
    /// </summary>
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

    /// <summary>Closest model along a segment from a to b, both included; t in 0..1.</summary>
    public unsafe Hit? SegmentTest(Segment segment, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_segment_test(Handle, &segment, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    public unsafe void SegmentTestBatch(ReadOnlySpan<Segment> segments, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, segments.Length);
        RequireLength(hits.Length, count);
        fixed (Segment* segments_ = &MemoryMarshal.GetReference(segments))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_segment_test_batch(Handle, segments_, StrideOf(segments), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>
    /// Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
    /// ascending. Kept when too many: the lowest.
    /// </summary>
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

    /// <summary>Offsets as in gphys_scene_raycast_all_batch.</summary>
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

    /// <summary>
    /// Ids of all models whose world box is not wholly outside one of a frustum's six planes or of its
    /// own box, ascending: for drawing. None that is seen is missed; near the frustum's edges a few
    /// per cent more are listed, which gphys_scene_overlap sorts out by testing the shapes. Kept when
    /// too many: the lowest. Room for all models is best: what out_models has beyond the ids is used
    /// as scratch memory to order them.
    /// </summary>
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

    /// <summary>
    /// The model nearest to a point, and its closest point.
    /// @param max_distance  &gt;= 0, INFINITY allowed; a model at exactly this distance counts
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public unsafe Nearest? Nearest(Vec3 point, float maxDistance = float.PositiveInfinity, uint layers = Constants.AllLayers) {
        var nearest = default(Nearest);
        var status = Low.gphys_scene_nearest(Handle, &point, maxDistance, layers, &nearest);
        return Found(status) ? nearest : (Nearest?)null;
    }

    public unsafe void NearestBatch(ReadOnlySpan<Vec3> points, Span<Nearest> nearest, float maxDistance = float.PositiveInfinity, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, points.Length);
        RequireLength(nearest.Length, count);
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (Nearest* nearest_ = &MemoryMarshal.GetReference(nearest))
        Check(Low.gphys_scene_nearest_batch(Handle, points_, StrideOf(points), count, maxDistance, layers, nearest_, (uint)sizeof(Nearest)));
    }

    /// <summary>
    /// First model that a sphere touches while it moves by displacement; t in 0..1.
    /// Fields as in gphys_shape_sweep_sphere.
    /// </summary>
    public unsafe Hit? SweepSphere(Sphere sphere, Vec3 displacement, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_scene_sweep_sphere(Handle, &sphere, &displacement, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    public unsafe void SweepSphereBatch(ReadOnlySpan<Sphere> spheres, ReadOnlySpan<Vec3> displacements, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, spheres.Length, displacements.Length);
        RequireLength(hits.Length, count);
        fixed (Sphere* spheres_ = &MemoryMarshal.GetReference(spheres))
        fixed (Vec3* displacements_ = &MemoryMarshal.GetReference(displacements))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_scene_sweep_sphere_batch(Handle, spheres_, StrideOf(spheres), displacements_, StrideOf(displacements), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>Cost: O(nodes).</summary>
    public unsafe OctreeStats GetOctreeStats() {
        var stats = default(OctreeStats);
        Check(Low.gphys_scene_get_octree_stats(Handle, &stats));
        return stats;
    }

    /// <summary>Boxes of the tree, each parent before its children. Kept when too many: the first.</summary>
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

    /// <summary>
    /// Check the scene's own structure: every model once in the tree, every box around its content,
    /// parents and children in agreement, free slots free. For tests; O(n).
    /// @return GPHYS_OK, or GPHYS_ERROR_INTERNAL and gphys_last_error() says what is wrong
    /// </summary>
    public unsafe void Validate() {
        Check(Low.gphys_scene_validate(Handle));
    }

}

/// <summary>Owns a gphys_camera: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Camera : IDisposable {
    internal readonly CameraHandle Handle;

    /// <summary>@param desc  may be NULL</summary>
    public unsafe Camera(CameraDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_camera_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new CameraHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>
    /// Move the point of the world that the camera's coordinates count from; see gphys_scene_set_origin.
    /// The camera and the target of its orbit stay where they are in the world. Picking and culling need a
    /// scene of the same origin, else they return GPHYS_ERROR_INVALID_ARGUMENT.
    /// </summary>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_camera_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the camera's coordinates count from.</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_camera_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>
    /// @param fov_y  full vertical angle, 1e-6 &lt;= fov_y &lt; pi
    /// @param near_distance  &gt; 0
    /// @param far_distance   &gt; near_distance; INFINITY allowed
    /// </summary>
    public unsafe void SetPerspective(float fovY, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_perspective(Handle, fovY, nearDistance, farDistance));
    }

    /// <summary>
    /// @param height  metres seen from top to bottom, &gt;= 1e-6; the width follows from the viewport
    /// @param near_distance, far_distance  far at least 1e-6 above near, which may be negative
    /// </summary>
    public unsafe void SetOrthographic(float height, float nearDistance, float farDistance) {
        Check(Low.gphys_camera_set_orthographic(Handle, height, nearDistance, farDistance));
    }

    /// <summary>
    /// Any projection matrix of the camera's depth range and direction (off-centre, oblique, another
    /// library's). It is not changed by gphys_camera_set_viewport.
    /// @return GPHYS_ERROR_SINGULAR if it has no inverse, or is too close to such a matrix to tell;
    ///         GPHYS_ERROR_INVALID_ARGUMENT if a plane other than far lies at infinity, as it does when
    ///         the matrix is for another depth range
    /// </summary>
    public unsafe void SetProjection(Mat4 projection) {
        Check(Low.gphys_camera_set_projection(Handle, &projection));
    }

    /// <summary>The viewport was resized: pixels, 1e-3 .. 1e6. Perspective keeps fov_y, orthographic its height.</summary>
    public unsafe void SetViewport(float width, float height) {
        Check(Low.gphys_camera_set_viewport(Handle, width, height));
    }

    /// <summary>Place the camera.</summary>
    public unsafe void SetTransform(Vec3 position, Quat rotation) {
        Check(Low.gphys_camera_set_transform(Handle, &position, &rotation));
    }

    /// <summary>
    /// Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
    /// kept, then up), so that a matrix which drifted is mended.
    /// @return GPHYS_ERROR_SINGULAR if the axes do not span space, GPHYS_ERROR_INVALID_ARGUMENT if
    ///         they mirror or the last row is not 0 0 0 1
    /// </summary>
    public unsafe void SetWorldMatrix(Mat4 world) {
        Check(Low.gphys_camera_set_world_matrix(Handle, &world));
    }

    /// <summary>
    /// Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
    /// chosen in its place, always the same for the same input.
    /// @return GPHYS_ERROR_INVALID_ARGUMENT if eye equals target or up is zero
    /// </summary>
    public unsafe void LookAt(Vec3 eye, Vec3 target, Vec3 up) {
        Check(Low.gphys_camera_look_at(Handle, &eye, &target, &up));
    }

    /// <summary>Where the camera stands and how it is turned.</summary>
    public unsafe (Vec3 Position, Quat Rotation) GetTransform() {
        var position = default(Vec3);
        var rotation = default(Quat);
        Check(Low.gphys_camera_get_transform(Handle, &position, &rotation));
        return (position, rotation);
    }

    /// <summary>Camera to world.</summary>
    public unsafe Mat4 GetWorldMatrix() {
        var world = default(Mat4);
        Check(Low.gphys_camera_get_world_matrix(Handle, &world));
        return world;
    }

    /// <summary>World to camera: the transpose of the orthonormal world axes, and the position through them.</summary>
    public unsafe Mat4 GetViewMatrix() {
        var view = default(Mat4);
        Check(Low.gphys_camera_get_view_matrix(Handle, &view));
        return view;
    }

    /// <summary>Camera to clip space.</summary>
    public unsafe Mat4 GetProjectionMatrix() {
        var projection = default(Mat4);
        Check(Low.gphys_camera_get_projection_matrix(Handle, &projection));
        return projection;
    }

    /// <summary>Projection * view, multiplied in double precision and rounded once.</summary>
    public unsafe Mat4 GetViewProjectionMatrix() {
        var viewProjection = default(Mat4);
        Check(Low.gphys_camera_get_view_projection_matrix(Handle, &viewProjection));
        return viewProjection;
    }

    /// <summary>
    /// Start orbiting with these settings; places the camera at once and drops pending input. An angle
    /// or a distance outside its limits is brought inside.
    /// </summary>
    public unsafe void SetOrbit(Orbit orbit) {
        Check(Low.gphys_camera_set_orbit(Handle, &orbit));
    }

    /// <summary>
    /// The present settings, angles and distance.
    /// @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
    /// </summary>
    public unsafe Orbit GetOrbit() {
        var orbit = default(Orbit);
        Check(Low.gphys_camera_get_orbit(Handle, &orbit));
        return orbit;
    }

    /// <summary>Add input: yaw by units_x, pitch by units_y, times radians_per_unit. Finite, any size.</summary>
    public unsafe void OrbitRotate(float unitsX, float unitsY) {
        Check(Low.gphys_camera_orbit_rotate(Handle, unitsX, unitsY));
    }

    /// <summary>Add input: come closer by units times metres_per_unit (go back if negative).</summary>
    public unsafe void OrbitZoom(float units) {
        Check(Low.gphys_camera_orbit_zoom(Handle, units));
    }

    /// <summary>
    /// Add input: move the target to the camera's right and up, as the last update left them, by units
    /// times metres_per_unit.
    /// </summary>
    public unsafe void OrbitPan(float unitsRight, float unitsUp) {
        Check(Low.gphys_camera_orbit_pan(Handle, unitsRight, unitsUp));
    }

    /// <summary>
    /// Apply the input since the last update, within the limits, and place the camera. Angles are
    /// wrapped to -pi .. pi in constant time. The orbit's settings must have been set.
    /// </summary>
    public unsafe void OrbitUpdate() {
        Check(Low.gphys_camera_orbit_update(Handle));
    }

    /// <summary>
    /// The seen volume, with origin at the camera's position and planes from its parameters: each
    /// number within 2 ulp. A user projection gives its planes by Gribb-Hartmann in double.
    /// </summary>
    public unsafe Frustum GetFrustum() {
        var frustum = default(Frustum);
        Check(Low.gphys_camera_get_frustum(Handle, &frustum));
        return frustum;
    }

    /// <summary>
    /// World positions of its corners, in the order of gphys_frustum_corners.
    /// @return GPHYS_UNBOUNDED with an infinite far plane
    /// </summary>
    public unsafe Vec3[] GetCorners() {
        var corners = new Vec3[8];
        Status status;
        fixed (Vec3* corners_ = corners)
        status = Low.gphys_camera_get_corners(Handle, corners_);
        return Found(status) ? corners : null;
    }

    /// <summary>
    /// World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the viewport; z is the
    /// depth in the camera's range.
    /// @return GPHYS_NO_HIT if the point is not in front of the camera's centre (no image), or its
    ///         image lies beyond the range of coordinates
    /// </summary>
    public unsafe Vec3? Project(Vec3 point) {
        var pixel = default(Vec3);
        var status = Low.gphys_camera_project(Handle, &point, &pixel);
        return Found(status) ? pixel : (Vec3?)null;
    }

    /// <summary>The same for count points; a point without an image gets x = y = z = INFINITY.</summary>
    public unsafe void ProjectBatch(ReadOnlySpan<Vec3> points, Span<Vec3> pixels) {
        var count = CommonLength(-1, points.Length);
        RequireLength(pixels.Length, count);
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        fixed (Vec3* pixels_ = &MemoryMarshal.GetReference(pixels))
        Check(Low.gphys_camera_project_batch(Handle, points_, StrideOf(points), count, pixels_, (uint)sizeof(Vec3)));
    }

    /// <summary>
    /// Pixel and depth to world point: the inverse of gphys_camera_project.
    /// @return GPHYS_UNBOUNDED for the depth of an infinite far plane, and for points beyond that or
    ///         beyond the range of coordinates
    /// </summary>
    public unsafe Vec3? Unproject(Vec3 pixel) {
        var point = default(Vec3);
        var status = Low.gphys_camera_unproject(Handle, &pixel, &point);
        return Found(status) ? point : (Vec3?)null;
    }

    /// <summary>The same for count pixels; one at infinity gets x = y = z = INFINITY.</summary>
    public unsafe void UnprojectBatch(ReadOnlySpan<Vec3> pixels, Span<Vec3> points) {
        var count = CommonLength(-1, pixels.Length);
        RequireLength(points.Length, count);
        fixed (Vec3* pixels_ = &MemoryMarshal.GetReference(pixels))
        fixed (Vec3* points_ = &MemoryMarshal.GetReference(points))
        Check(Low.gphys_camera_unproject_batch(Handle, pixels_, StrideOf(pixels), count, points_, (uint)sizeof(Vec3)));
    }

    /// <summary>
    /// The ray through a pixel, of unit direction. It starts at the camera's position (perspective) or
    /// on the near plane (orthographic, user) and t_max ends on the far plane (INFINITY without one).
    /// Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, as
    /// near as half an ulp of a direction can be; gphys_camera_pick is not so limited.
    /// For perspective the stretch before the near plane is part of the ray. Pixels outside the
    /// viewport are allowed.
    /// @return GPHYS_UNBOUNDED if the line of sight does not meet the near plane (user projections)
    /// </summary>
    public unsafe Ray? PickRay(float pixelX, float pixelY) {
        var ray = default(Ray);
        var status = Low.gphys_camera_pick_ray(Handle, pixelX, pixelY, &ray);
        return Found(status) ? ray : (Ray?)null;
    }

    /// <summary>Rays for a rectangle of pixel centres, row by row: width * height rays, fewer than 2^32.</summary>
    public unsafe void PickRays(uint x, uint y, uint width, uint height, Span<Ray> rays) {
        RequireLength(rays.Length, (ulong)width * height);
        fixed (Ray* rays_ = &MemoryMarshal.GetReference(rays))
        Check(Low.gphys_camera_pick_rays(Handle, x, y, width, height, rays_, (uint)sizeof(Ray)));
    }

    /// <summary>
    /// The model under a pixel: the first hit of gphys_camera_pick_ray, before that is rounded to
    /// float32; t is in metres.
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public unsafe Hit? Pick(Scene scene, float pixelX, float pixelY, uint layers = Constants.AllLayers) {
        var hit = default(Hit);
        var status = Low.gphys_camera_pick(Handle, scene.Handle, pixelX, pixelY, layers, &hit);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>The same for count pixels, given as x, y pairs of floats. Misses as in the scene's batches.</summary>
    public unsafe void PickBatch(Scene scene, ReadOnlySpan<Vec2> pixels, Span<Hit> hits, uint layers = Constants.AllLayers) {
        var count = CommonLength(-1, pixels.Length);
        RequireLength(hits.Length, count);
        fixed (Vec2* pixels_ = &MemoryMarshal.GetReference(pixels))
        fixed (Hit* hits_ = &MemoryMarshal.GetReference(hits))
        Check(Low.gphys_camera_pick_batch(Handle, scene.Handle, (float*)pixels_, StrideOf(pixels), count, layers, hits_, (uint)sizeof(Hit)));
    }

    /// <summary>
    /// Marquee: ids of all models that show or would show, were nothing in front of them, in the pixel
    /// rectangle, between near and far plane; exact shapes, ascending. Corners in any order.
    /// @return GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area
    /// </summary>
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

    /// <summary>gphys_scene_cull with the camera's frustum.</summary>
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

}

/// <summary>Owns a gphys_solver: freed by Dispose, or else by the garbage collector.</summary>
public sealed partial class Solver : IDisposable {
    internal readonly SolverHandle Handle;

    /// <summary>
    /// With a worker_count of n, n threads share the bodies of a step; the results have the same bits for
    /// every n. Threads are started, joined and lost as those of gphys_scene_create.
    /// @param desc  may be NULL
    /// @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started
    /// </summary>
    public unsafe Solver(SolverDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        IntPtr made;
        Check(Low.gphys_solver_create(desc.HasValue ? &desc_ : null, &made));
        Handle = new SolverHandle(made);
    }

    /// <summary>Frees the object at once. Any use afterwards throws ObjectDisposedException.</summary>
    public void Dispose() { Handle.Dispose(); }

    /// <summary>
    /// Move the point of the world that the coordinates of all particles count from; see
    /// gphys_scene_set_origin. Particles stay where they are in the world and keep moving as they do. A
    /// step and an attachment need a scene of the same origin, else they return
    /// GPHYS_ERROR_INVALID_ARGUMENT. Cost: O(particles).
    /// </summary>
    public unsafe void SetOrigin(ReadOnlySpan<double> origin) {
        RequireLength(origin.Length, 3);
        fixed (double* origin_ = &MemoryMarshal.GetReference(origin))
        Check(Low.gphys_solver_set_origin(Handle, origin_));
    }

    /// <summary>Where in the world the particles' coordinates count from.</summary>
    public unsafe double[] GetOrigin() {
        var origin = new double[3];
        fixed (double* origin_ = origin)
        Check(Low.gphys_solver_get_origin(Handle, origin_));
        return origin;
    }

    /// <summary>m/s^2, from the next step on.</summary>
    public unsafe void SetGravity(Vec3 gravity) {
        Check(Low.gphys_solver_set_gravity(Handle, &gravity));
    }

    /// <summary>
    /// 1 .. 1000. More substeps: smaller errors, proportionally more time. The error of motion goes with the square
    /// of their length. Ropes that move calmly - in a substep no link turns by half a radian, or would swing by one if
    /// its ends were pushed - make each in two stages (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the
    /// error.
    /// </summary>
    public unsafe void SetSubsteps(uint substeps) {
        Check(Low.gphys_solver_set_substeps(Handle, substeps));
    }

    /// <summary>
    /// Add particles without constraints.
    /// @param desc  may be NULL
    /// @param positions  count elements, count &gt;= 1
    /// </summary>
    public unsafe uint AddParticles(ReadOnlySpan<Vec3> positions, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, positions.Length);
        var body = default(uint);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_add_particles(Handle, desc.HasValue ? &desc_ : null, positions_, StrideOf(positions), count, &body));
        return body;
    }

    /// <summary>
    /// Add a rope through the given points, one particle at each.
    /// @param count  &gt;= 2
    /// @param link_length  rest length of each link in metres; 0: as placed
    /// </summary>
    public unsafe uint AddRope(ReadOnlySpan<Vec3> positions, float linkLength = 0, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var count = CommonLength(-1, positions.Length);
        var body = default(uint);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_add_rope(Handle, desc.HasValue ? &desc_ : null, positions_, StrideOf(positions), count, linkLength, &body));
        return body;
    }

    /// <summary>
    /// Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
    /// corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v.
    /// @param columns, rows  &gt;= 2
    /// </summary>
    public unsafe uint AddCloth(Vec3 corner, Vec3 edgeU, Vec3 edgeV, uint columns, uint rows, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var body = default(uint);
        Check(Low.gphys_solver_add_cloth(Handle, desc.HasValue ? &desc_ : null, &corner, &edgeU, &edgeV, columns, rows, &body));
        return body;
    }

    /// <summary>
    /// Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and
    /// with GPHYS_CLOTH_BEND one across each inner edge. Vertices at the same place stay separate.
    /// @param transform  places the mesh; may be NULL
    /// </summary>
    public unsafe uint AddClothMesh(Mesh mesh, Transform? transform = null, BodyDesc? desc = null) {
        var desc_ = desc.GetValueOrDefault();
        var transform_ = transform.GetValueOrDefault();
        var body = default(uint);
        Check(Low.gphys_solver_add_cloth_mesh(Handle, desc.HasValue ? &desc_ : null, mesh.Handle, transform.HasValue ? &transform_ : null, &body));
        return body;
    }

    public unsafe void RemoveBody(uint body) {
        Check(Low.gphys_solver_remove_body(Handle, body));
    }

    /// <summary>Ids of all bodies, ascending. Kept when too many: the lowest.</summary>
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

    /// <summary>
    /// Ids of the bodies that are asleep, ascending. Kept when too many: the lowest.
    /// A body falls asleep at the end of a step when for sleep_time seconds no particle was faster than
    /// sleep_speed and no rigid constraint strained by more than sleep_strain. Its speed is then 0, it
    /// keeps the contacts that it has, and a step costs it no more than a look for models nearby. It
    /// wakes in the step before which a model came, went or moved as near as it could come in a step at
    /// 50 m/s, or one that it is attached to did, or the scene was exchanged; and at once by any change of
    /// its state, of gravity or of the origin.
    /// </summary>
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

    /// <summary>
    /// Wake a body; its time of rest begins again.
    /// @param body  0: all
    /// </summary>
    public unsafe void Wake(uint body) {
        Check(Low.gphys_solver_wake(Handle, body));
    }

    /// <summary>
    /// What a body is made of and how it is solved.  Cost: O(1); after a change of constraints O(particles), and
    /// it allocates.
    /// </summary>
    public unsafe BodyInfo GetBodyInfo(uint body) {
        var info = default(BodyInfo);
        Check(Low.gphys_solver_get_body_info(Handle, body, &info));
        return info;
    }

    /// <summary>Particle numbers of a cloth's triangles, three each; total counts numbers, not triangles.</summary>
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

    /// <summary>Metres.</summary>
    public unsafe void GetPositions(uint body, uint first, Span<Vec3> positions) {
        var count = (uint)positions.Length;
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_get_positions(Handle, body, first, count, positions_, (uint)sizeof(Vec3)));
    }

    /// <summary>Moves particles there at once and without collision on the way; velocities stay as they are.</summary>
    public unsafe void SetPositions(uint body, uint first, ReadOnlySpan<Vec3> positions) {
        var count = CommonLength(-1, positions.Length);
        fixed (Vec3* positions_ = &MemoryMarshal.GetReference(positions))
        Check(Low.gphys_solver_set_positions(Handle, body, first, count, positions_, StrideOf(positions)));
    }

    /// <summary>m/s</summary>
    public unsafe void GetVelocities(uint body, uint first, Span<Vec3> velocities) {
        var count = (uint)velocities.Length;
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_get_velocities(Handle, body, first, count, velocities_, (uint)sizeof(Vec3)));
    }

    public unsafe void SetVelocities(uint body, uint first, ReadOnlySpan<Vec3> velocities) {
        var count = CommonLength(-1, velocities.Length);
        fixed (Vec3* velocities_ = &MemoryMarshal.GetReference(velocities))
        Check(Low.gphys_solver_set_velocities(Handle, body, first, count, velocities_, StrideOf(velocities)));
    }

    /// <summary>kg, &gt; 0. A pinned particle keeps its mass for the time when it is released.</summary>
    public unsafe void GetMasses(uint body, uint first, Span<float> masses) {
        var count = (uint)masses.Length;
        fixed (float* masses_ = &MemoryMarshal.GetReference(masses))
        Check(Low.gphys_solver_get_masses(Handle, body, first, count, masses_, (uint)sizeof(float)));
    }

    public unsafe void SetMasses(uint body, uint first, ReadOnlySpan<float> masses) {
        var count = CommonLength(-1, masses.Length);
        fixed (float* masses_ = &MemoryMarshal.GetReference(masses))
        Check(Low.gphys_solver_set_masses(Handle, body, first, count, masses_, StrideOf(masses)));
    }

    /// <summary>Collision radius, metres, &gt;= 0.</summary>
    public unsafe void SetRadii(uint body, uint first, ReadOnlySpan<float> radii) {
        var count = CommonLength(-1, radii.Length);
        fixed (float* radii_ = &MemoryMarshal.GetReference(radii))
        Check(Low.gphys_solver_set_radii(Handle, body, first, count, radii_, StrideOf(radii)));
    }

    /// <summary>Forces in newtons that act beside gravity, from now on until set again.</summary>
    public unsafe void SetForces(uint body, uint first, ReadOnlySpan<Vec3> forces) {
        var count = CommonLength(-1, forces.Length);
        fixed (Vec3* forces_ = &MemoryMarshal.GetReference(forces))
        Check(Low.gphys_solver_set_forces(Handle, body, first, count, forces_, StrideOf(forces)));
    }

    /// <summary>
    /// Pin (1) or release (0) a range. A pinned particle stays where it is put and moves only by
    /// gphys_solver_set_positions; its speed is 0. Both pinning and releasing end an attachment.
    /// </summary>
    public unsafe void SetPinned(uint body, uint first, uint count, bool pinned) {
        Check(Low.gphys_solver_set_pinned(Handle, body, first, count, pinned ? 1 : 0));
    }

    /// <summary>
    /// Fix a particle to a model: it follows the model's transform in each step, and is released when
    /// the model is gone. Steps must then be given this scene.
    /// @param local_point  in the model's coordinates; NULL: where the particle is now
    /// </summary>
    public unsafe void Attach(Scene scene, uint body, uint particle, uint model, Vec3? localPoint = null) {
        var localPoint_ = localPoint.GetValueOrDefault();
        Check(Low.gphys_solver_attach(Handle, scene.Handle, body, particle, model, localPoint.HasValue ? &localPoint_ : null));
    }

    /// <summary>
    /// Release an attached particle.
    /// @return GPHYS_ERROR_INVALID_ARGUMENT if it is not attached
    /// </summary>
    public unsafe void Detach(uint body, uint particle) {
        Check(Low.gphys_solver_detach(Handle, body, particle));
    }

    /// <summary>
    /// Hold two different particles of a body at a distance.
    /// @param rest_length  metres, &gt;= 0; negative: the present distance
    /// @param compliance   metres per newton, &gt;= 0; 0 is rigid
    /// @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same one
    /// </summary>
    public unsafe uint AddDistance(uint body, uint particleA, uint particleB, float restLength, float compliance = 0) {
        var constraint = default(uint);
        Check(Low.gphys_solver_add_distance(Handle, body, particleA, particleB, restLength, compliance, &constraint));
        return constraint;
    }

    /// <summary>
    /// Keep two different particles of a body from being further apart than a length, like a string between
    /// them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
    /// rigid, the speed at which the particles part is lost and no other.
    /// @param max_length  metres, &gt;= 0; negative: the present distance
    /// @param compliance  metres per newton, &gt;= 0, of what it yields beyond that; 0 is rigid
    /// @return as gphys_solver_add_distance
    /// It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
    /// strained only when it is too long.
    /// </summary>
    public unsafe uint AddMaxDistance(uint body, uint particleA, uint particleB, float maxLength, float compliance = 0) {
        var constraint = default(uint);
        Check(Low.gphys_solver_add_max_distance(Handle, body, particleA, particleB, maxLength, compliance, &constraint));
        return constraint;
    }

    /// <summary>
    /// Damp a constraint that has compliance: at a speed v of its ends apart it pulls with damping * v beside
    /// its tension; one of gphys_solver_add_max_distance never pushes. The decay depends on time, not
    /// on steps. Rigid constraints have nothing to damp.
    /// @param damping  N s/m, &gt;= 0; 0, which every constraint begins with: none
    /// @return GPHYS_ERROR_INVALID_ID for a body or constraint that does not exist
    /// </summary>
    public unsafe void SetConstraintDamping(uint body, uint constraint, float damping) {
        Check(Low.gphys_solver_set_constraint_damping(Handle, body, constraint, damping));
    }

    /// <summary>
    /// Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body; setting
    /// it again changes it, which inflates a body.
    /// @param rest_volume  m^3, &gt; 0; negative: the present volume
    /// @param compliance   m^3 per pascal, &gt;= 0: the volume that a pressure of one pascal takes; 0: as water,
    ///                     which keeps its volume; INFINITY: none, which ends the constraint
    /// @return GPHYS_ERROR_UNSUPPORTED if the triangles do not close (each side is that of two triangles), are
    ///         not all turned the same way, or face inward when the present volume is asked for
    /// Cost: O(triangles) in each substep, twice.
    /// </summary>
    public unsafe void SetVolume(uint body, float restVolume, float compliance = 0) {
        Check(Low.gphys_solver_set_volume(Handle, body, restVolume, compliance));
    }

    /// <summary>
    /// The volume held by gphys_solver_set_volume, m^3, as it is, and the pressure in pascals with which it was
    /// held at the end of the last step: above 0 it pushes outward.
    /// @param out_volume, out_pressure  may be NULL
    /// @return GPHYS_ERROR_UNSUPPORTED if none is held
    /// </summary>
    public unsafe (float Volume, float Pressure) GetVolume(uint body) {
        var volume = default(float);
        var pressure = default(float);
        Check(Low.gphys_solver_get_volume(Handle, body, &volume, &pressure));
        return (volume, pressure);
    }

    public unsafe void RemoveConstraint(uint body, uint constraint) {
        Check(Low.gphys_solver_remove_constraint(Handle, body, constraint));
    }

    /// <summary>All constraints of a body, those of its builder included, by id. Kept when too many: the lowest.</summary>
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

    /// <summary>
    /// Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that are
    /// equal and opposite; either may be pinned or attached. Joined ropes and free particles are solved as one
    /// system, as stiff as one rope; a joined particle of cloth has all that hangs on it for inertia. Free
    /// particles of a joined body fly by the time scheme of ropes, no longer exactly. Joined bodies are moved by
    /// one thread and fall asleep and wake together. A joint goes with either body.
    /// @param rest_length  metres; 0: at the same place; negative: the present distance. Particles that are not
    ///                     as far apart are drawn there within a step, and get the speed of that.
    /// @param compliance   metres per newton, &gt;= 0; 0 is rigid
    /// @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same body (see
    ///         gphys_solver_add_distance); GPHYS_ERROR_CAPACITY beyond 2^24 - 1 joints
    /// Cost: the next step plans all joined ropes again. A link of them takes some three times as long as one
    /// of a rope that is not joined.
    /// </summary>
    public unsafe uint Join(uint bodyA, uint particleA, uint bodyB, uint particleB, float restLength, float compliance = 0) {
        var joint = default(uint);
        Check(Low.gphys_solver_join(Handle, bodyA, particleA, bodyB, particleB, restLength, compliance, &joint));
        return joint;
    }

    /// <summary>
    /// End a joint.
    /// @return GPHYS_ERROR_INVALID_ID for a joint that does not exist, or no longer
    /// </summary>
    public unsafe void Unjoin(uint joint) {
        Check(Low.gphys_solver_unjoin(Handle, joint));
    }

    /// <summary>
    /// Joints of a body, by id. Kept when too many: the lowest.
    /// @param body  0: of all bodies
    /// </summary>
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

    /// <summary>
    /// Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
    /// takes more where they would be longer than 25 ms.
    /// @param scene  to collide with and to follow attachments; NULL: none. Not modified.
    /// @param dt     1e-6 .. 0.5
    /// Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
    /// through particles. Cost: O(particles + constraints)
    /// substeps, and a scene query for particles near models.
    /// </summary>
    public unsafe void Step(float dt, Scene scene = null) {
        Check(Low.gphys_solver_step(Handle, scene == null ? SceneHandle.None : scene.Handle, dt));
    }

    /// <summary>
    /// Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next
    /// frame, so the motion does not depend on the frame rate.
    /// @param frame_time    seconds, &gt;= 0
    /// @param out_steps     steps made; may be NULL
    /// @param out_leftover  0 &lt;= fraction of a step still owed &lt; 1, to blend drawings; may be NULL
    /// </summary>
    public unsafe (uint Steps, float Leftover) Advance(float frameTime, Scene scene = null) {
        var steps = default(uint);
        var leftover = default(float);
        Check(Low.gphys_solver_advance(Handle, scene == null ? SceneHandle.None : scene.Handle, frameTime, &steps, &leftover));
        return (steps, leftover);
    }

    /// <summary>
    /// The substeps that a body took in the last step; 0 before its first.
    /// With gphys_solver_desc.max_strain or tolerance set, each body takes as many as its own motion needs:
    /// their length follows from what the last step measured, the largest strain of its rigid constraints
    /// and the local error of the time scheme, both of which go with its square. It is at
    /// most quartered and grows by at most an eighth from one step to the next, so a sudden blow exceeds a
    /// target for a few steps, one of strain only where links of cloth cannot be relaxed below it. What cannot be
    /// met takes max_substeps. Where positions jump, by contacts, the error is that of the jump.
    /// </summary>
    public unsafe uint GetSubsteps(uint body) {
        var substeps = default(uint);
        Check(Low.gphys_solver_get_substeps(Handle, body, &substeps));
        return substeps;
    }

    /// <summary>@param body  0: all bodies together.  Cost: O(particles + constraints).</summary>
    public unsafe SolverStats GetStats(uint body) {
        var stats = default(SolverStats);
        Check(Low.gphys_solver_get_stats(Handle, body, &stats));
        return stats;
    }

    /// <summary>Contacts of the last step by body, particle, model. Kept when too many: the first.</summary>
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

    /// <summary>
    /// Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
    /// which they fell asleep. Kept when too many: the lowest models.
    /// Divided by dt they are mean forces: what lies on a model presses it with its weight. A particle of
    /// cloth that touches several models at once gives to the one that it touches most. Models have no mass
    /// here; a body of yours much lighter than what hangs from it should be moved in small steps.
    /// Cost: O(models touched); no allocation. The same bits for any number of workers.
    /// </summary>
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

    /// <summary>
    /// Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and impulses, time
    /// that gphys_solver_advance still owes. The scene, workers and allocator are not in it.
    /// @param out_words  the snapshot; written as a whole, or not at all when capacity is too small. It is
    ///                   for the same release of the library and machines of the same byte order; it may
    ///                   be stored, but not changed.
    /// @return GPHYS_INCOMPLETE when *out_total &gt; capacity; GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words
    /// Cost: O(particles + constraints), some 50 words for each.
    /// </summary>
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

    /// <summary>
    /// Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
    /// time of the snapshot. Steps go on with the same bits as they did then, provided that the scene,
    /// too, is as it was.
    /// @return GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot, damaged, of another version or
    ///         byte order; GPHYS_ERROR_OUT_OF_MEMORY. Either way the solver is as before.
    /// Cost: as gphys_solver_get_snapshot; allocates.
    /// </summary>
    public unsafe void Restore(ReadOnlySpan<uint> words) {
        var count = CommonLength(words.Length, 1);
        fixed (uint* words_ = &MemoryMarshal.GetReference(words))
        Check(Low.gphys_solver_restore(Handle, words_, count));
    }

    /// <summary>
    /// A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
    /// different ones differ with near certainty (not against an adversary). Compare it between machines
    /// that simulate the same, to see when they part. Cost: O(particles + constraints).
    /// </summary>
    public unsafe uint[] GetHash() {
        var hash = new uint[2];
        fixed (uint* hash_ = hash)
        Check(Low.gphys_solver_get_hash(Handle, hash_));
        return hash;
    }

}

/// <summary>Questions about single shapes, without a scene.</summary>
public static partial class Geometry {
    /// <summary>
    /// Whether the shape fulfils the ranges beside its struct.
    /// @return GPHYS_OK, or GPHYS_ERROR_INVALID_ARGUMENT and gphys_last_error() names the field.
    /// </summary>
    public static unsafe void Validate(Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var status = Low.gphys_shape_validate(shape.Type, shape_);
        GC.KeepAlive(shape.Mesh);
        Check(status);
    }

    /// <summary>
    /// The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
    /// @return GPHYS_OK; GPHYS_UNBOUNDED for a plane, a ray without end (or with one beyond all floats)
    ///         and a frustum that extends to infinity; GPHYS_NO_HIT for an empty mesh or frustum
    /// </summary>
    public static unsafe Aabb? Bounds(Shape shape) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var bounds = default(Aabb);
        var status = Low.gphys_shape_bounds(shape.Type, shape_, &bounds);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? bounds : (Aabb?)null;
    }

    /// <summary>
    /// Whether the point is within tolerance metres of the shape (solid or surface).
    /// With tolerance 0 the answer is exact: on the plane, on the segment, inside the box (an OBB's
    /// axes are those of its rotation in double precision).
    /// @param tolerance  &gt;= 0
    /// @param out_contains  0 or 1
    /// </summary>
    public static unsafe bool Contains(Shape shape, Vec3 point, float tolerance = 0) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var contains = default(int);
        var status = Low.gphys_shape_contains(shape.Type, shape_, &point, tolerance, &contains);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return contains != 0;
    }

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

    /// <summary>
    /// The point of the shape that is closest to the given point: the point itself inside a solid.
    /// Error: 1 ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest
    /// coordinate difference. If several are equally close, one of them,
    /// always the same. For a ray, t is limited by t_max.
    /// @return GPHYS_NO_HIT only for an empty mesh or an empty frustum.
    /// </summary>
    public static unsafe Nearest? ClosestPoint(Shape shape, Vec3 point) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var nearest = default(Nearest);
        var status = Low.gphys_shape_closest_point(shape.Type, shape_, &point, &nearest);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? nearest : (Nearest?)null;
    }

    /// <summary>The same for count points. An element for which there is none gets distance INFINITY.</summary>
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

    /// <summary>
    /// The closest points of two segments and their distance. Parallel segments have many: the first
    /// along a, always the same. out_a, out_b, out_distance may each be NULL.
    /// </summary>
    public static unsafe (Vec3 Outa, Vec3 Outb, float Distance) SegmentClosestPoints(Segment a, Segment b) {
        var outA = default(Vec3);
        var outB = default(Vec3);
        var distance = default(float);
        Check(Low.gphys_segment_closest_points(&a, &b, &outA, &outB, &distance));
        return (outA, outB, distance);
    }

    /// <summary>
    /// Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane,
    /// triangle, frustum and mesh, in either order.
    /// A mesh is its surface: a sphere deep inside a closed mesh does not overlap it.
    /// Exact between AABBs, planes, triangles, meshes and frusta; other pairs are decided in double
    /// precision and may err only where the gap is below 2^-40 of the largest coordinate difference.
    /// @return GPHYS_ERROR_UNSUPPORTED for a ray or segment (see gphys_shape_segment_test).
    /// </summary>
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

    /// <summary>Pair i is a[i] against b[i]; a stride of 0 tests one shape against many. A mesh needs 0.</summary>
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

    /// <summary>
    /// Classify a sphere, capsule, AABB, OBB or triangle against a plane.
    /// @param out_signed_distance  of the shape's nearest point to the plane: &gt; 0 in front, &lt; 0
    ///                             behind, 0 when crossing; may be NULL
    /// </summary>
    public static unsafe (Side Side, float Signeddistance) ClassifyPlane(Shape shape, Plane plane) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var side = default(Side);
        var signedDistance = default(float);
        var status = Low.gphys_shape_classify_plane(shape.Type, shape_, &plane, &side, &signedDistance);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return (side, signedDistance);
    }

    /// <summary>
    /// Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means
    /// that no point is shared, inside that the frustum holds the whole shape.
    /// </summary>
    public static unsafe Side ClassifyFrustum(Shape shape, Frustum frustum) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var side = default(Side);
        var status = Low.gphys_shape_classify_frustum(shape.Type, shape_, &frustum, &side);
        GC.KeepAlive(shape.Mesh);
        Check(status);
        return side;
    }

    /// <summary>
    /// First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh.
    /// Triangles and meshes are hit from both sides, and meshes are watertight: a ray through a
    /// shared edge or vertex always meets one of the triangles there.
    /// Error: t within 1 ulp. No false miss and no false hit at all for spheres, triangles, meshes, AABBs
    /// and planes; for capsules none but within 2^-48 of the distance. An OBB is met where one larger or
    /// smaller by 2^-40 of the distance would be. docs/accuracy.md has the bounds of all functions.
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public static unsafe Hit? Raycast(Shape shape, Ray ray) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_raycast(shape.Type, shape_, &ray, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>
    /// The same for count rays. A ray that hits nothing gets t = INFINITY, triangle =
    /// GPHYS_NO_TRIANGLE and zeros in its out_hits element.  @return GPHYS_OK
    /// </summary>
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

    /// <summary>
    /// First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly.
    /// A segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, which
    /// then is met from no direction, the normal is zero.
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public static unsafe Hit? SegmentTest(Shape shape, Segment segment) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_segment_test(shape.Type, shape_, &segment, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>
    /// First contact of a sphere that moves by displacement (which may be zero) with a sphere,
    /// capsule, AABB, OBB, plane, triangle, frustum or mesh.
    /// @param out_hit  t in 0..1 of the displacement; point: of contact, on the shape; normal: from
    ///                 the point to the sphere's centre. Already overlapping: t = 0, GPHYS_HIT_INSIDE,
    ///                 and where the centre itself is in a solid, the normal is opposite to the
    ///                 displacement (zero if that is zero).
    /// Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
    /// Cost: a frustum, approached step by step, takes about 10 us.
    /// @return GPHYS_OK or GPHYS_NO_HIT
    /// </summary>
    public static unsafe Hit? SweepSphere(Shape shape, Sphere sphere, Vec3 displacement) {
        void* shape_ = shape.Mesh == null ? (void*)&shape.Data : shape.Mesh.Pointer;
        var hit = default(Hit);
        var status = Low.gphys_shape_sweep_sphere(shape.Type, shape_, &sphere, &displacement, &hit);
        GC.KeepAlive(shape.Mesh);
        return Found(status) ? hit : (Hit?)null;
    }

    /// <summary>
    /// The eight corners, each the intersection of three planes: near then far, each in the order
    /// left-bottom, right-bottom, right-top, left-top.
    /// @return GPHYS_UNBOUNDED if three planes do not meet in a point (infinite far plane)
    /// </summary>
    public static unsafe Vec3[] FrustumCorners(Frustum frustum) {
        var corners = new Vec3[8];
        Status status;
        fixed (Vec3* corners_ = corners)
        status = Low.gphys_frustum_corners(&frustum, corners_);
        return Found(status) ? corners : null;
    }

    /// <summary>
    /// The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
    /// origin (0, 0, 0). A camera knows its frustum better: gphys_camera_get_frustum.
    /// @param reverse_z  0: near has the low depth; 1: near has the high depth
    /// @return GPHYS_ERROR_SINGULAR if the matrix has no volume
    /// </summary>
    public static unsafe Frustum FrustumFromMatrix(Mat4 viewProjection, DepthRange depthRange, bool reverseZ) {
        var frustum = default(Frustum);
        Check(Low.gphys_frustum_from_matrix(&viewProjection, depthRange, reverseZ ? 1 : 0, &frustum));
        return frustum;
    }

    /// <summary>
    /// Examine arrays without building anything. Allocates while it runs. Cost: O(n log n).
    /// @param vertices       vertex_count elements of 3 floats
    /// @param vertex_stride  bytes between vertices, at least 12
    /// @param indices        index_count numbers, three for each triangle
    /// </summary>
    public static unsafe MeshReport MeshCheck(ReadOnlySpan<Vec3> vertices, ReadOnlySpan<uint> indices) {
        var report = default(MeshReport);
        fixed (Vec3* vertices_ = &MemoryMarshal.GetReference(vertices))
        fixed (uint* indices_ = &MemoryMarshal.GetReference(indices))
        Check(Low.gphys_mesh_check((float*)vertices_, SizeOf(vertices), (uint)vertices.Length, indices_, (uint)indices.Length, &report));
        return report;
    }

}

}
