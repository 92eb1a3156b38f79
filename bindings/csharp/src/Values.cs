// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
using System;
using System.Runtime.InteropServices;

namespace Gamephys {

public enum Status {
    Ok = 0,
    /// <summary>the query found nothing; outputs untouched</summary>
    NoHit = 1,
    /// <summary>more results than the caller's array holds</summary>
    Incomplete = 2,
    /// <summary>the answer is infinite (bounds of a plane); outputs untouched</summary>
    Unbounded = 3,
    /// <summary>null, NaN, infinite, out of range, wrong stride, ...</summary>
    ErrorInvalidArgument = -1,
    /// <summary>no such model, body, constraint or joint, or no longer</summary>
    ErrorInvalidId = -2,
    /// <summary>a desc not initialised, or newer than this library</summary>
    ErrorStructSize = -3,
    ErrorOutOfMemory = -4,
    /// <summary>more than a limit, 2^24 - 1 unless the function says another</summary>
    ErrorCapacity = -5,
    /// <summary>a model would become its own ancestor</summary>
    ErrorCycle = -6,
    /// <summary>the operation has no meaning for this kind of shape</summary>
    ErrorUnsupported = -7,
    /// <summary>a matrix without an inverse</summary>
    ErrorSingular = -8,
    /// <summary>a defect of the library; please report it</summary>
    ErrorInternal = -100,
}

/// <summary>Says which struct a `const void* shape` points to.</summary>
public enum ShapeType {
    /// <summary>Sphere</summary>
    Sphere = 1,
    /// <summary>Capsule</summary>
    Capsule = 2,
    /// <summary>Aabb</summary>
    Aabb = 3,
    /// <summary>Obb</summary>
    Obb = 4,
    /// <summary>Plane</summary>
    Plane = 5,
    /// <summary>Triangle</summary>
    Triangle = 6,
    /// <summary>Frustum</summary>
    Frustum = 7,
    /// <summary>Mesh: the handle itself; a convex hull too</summary>
    Mesh = 8,
    /// <summary>Ray</summary>
    Ray = 16,
    /// <summary>Segment</summary>
    Segment = 17,
}

/// <summary>On which side something is of a plane or a frustum.</summary>
public enum Side {
    /// <summary>wholly behind the plane, wholly outside the frustum</summary>
    Outside = -1,
    /// <summary>touches or crosses the boundary</summary>
    Crossing = 0,
    /// <summary>wholly in front of the plane, wholly inside the frustum</summary>
    Inside = 1,
}

/// <summary>Depth range of clip space.</summary>
public enum DepthRange {
    /// <summary>DirectX, Vulkan, Metal, WebGPU</summary>
    ZeroToOne = 0,
    /// <summary>OpenGL, WebGL</summary>
    MinusOneToOne = 1,
}

/// <summary>What a mesh consists of.</summary>
public enum MeshKind {
    /// <summary>triangles</summary>
    Surface = 0,
    /// <summary>the triangles of a cloth: Mesh</summary>
    BodySurface = 1,
    /// <summary>the links and particles of a rope, or free particles: likewise</summary>
    BodyLinks = 2,
    /// <summary>a solid: Mesh</summary>
    Hull = 3,
}

public enum Projection {
    Perspective = 0,
    Orthographic = 1,
    User = 2,
}

public enum Handedness {
    /// <summary>looks along its own +Z</summary>
    LeftHanded = 0,
    /// <summary>looks along its own -Z</summary>
    RightHanded = 1,
}

/// <summary>Where the rays of a perspective camera begin.</summary>
public enum PickStart {
    /// <summary>what is drawn can be picked; nothing between camera and near plane</summary>
    NearPlane = 0,
    /// <summary>at the camera's position: what is between it and the near plane, too</summary>
    Centre = 1,
}

public enum BodyKind {
    Particles = 1,
    Rope = 2,
    Cloth = 3,
}

/// <summary>How a body is solved, chosen from its constraints.</summary>
public enum SolveMethod {
    /// <summary>no constraints: exact flight</summary>
    Free = 0,
    /// <summary>chains and trees: Newton on the whole body at once</summary>
    Direct = 1,
    /// <summary>
    /// cycles of constraints, volume, clusters, or a particle with more than 64 constraints:
    /// coloured batches of chains, then the rest, then reach limits
    /// </summary>
    Graph = 2,
}

/// <summary>What a constraint holds.</summary>
public enum ConstraintKind {
    /// <summary>its length: Solver.AddDistance, and those created with a body</summary>
    Distance = 0,
    /// <summary>at most its length; it may go slack: Solver.AddMaxDistance</summary>
    MaxDistance = 1,
}

public static class Constants {
    public const uint FrustumNear = 0;
    public const uint FrustumFar = 1;
    public const uint FrustumLeft = 2;
    public const uint FrustumRight = 3;
    public const uint FrustumBottom = 4;
    public const uint FrustumTop = 5;
    /// <summary>the ray or the swept sphere started inside or touching: t is 0</summary>
    public const uint HitInside = 1;
    /// <summary>a surface was met from behind its normal</summary>
    public const uint HitBack = 2;
    /// <summary>ignored_model stands for its descendants, too</summary>
    public const uint FilterSubtree = 1;
    /// <summary>
    /// planes, triangles and meshes that are not solid are not hit from behind: by
    /// rays with HitBack, or by sweeps along their normal; other queries
    /// have no direction and ignore this flag and the next
    /// </summary>
    public const uint FilterNoBackFaces = 2;
    /// <summary>they are met from behind only: the inside of a closed mesh</summary>
    public const uint FilterNoFrontFaces = 4;
    /// <summary>constraints along both diagonals of each grid cell: stiff like paper</summary>
    public const uint ClothShear = 1;
    /// <summary>constraints that resist folding</summary>
    public const uint ClothBend = 2;
    public const uint VersionMajor = 1;
    public const uint VersionMinor = 1;
    public const uint VersionPatch = 0;
    public const float MaxCoordinate = 1e15f;
    public const uint NoTriangle = 0xffffffffu;
    public const uint NoParticle = 0xffffffffu;
    public const uint AllLayers = 0xffffffffu;
}

/// <summary>
/// Memory functions for one object and everything in it. Both are called on the thread that calls
/// the library, from several threads if the objects that share it are used from several threads.
/// Neither may be null. allocate returns null on failure (reported as Status.ErrorOutOfMemory, nothing changed);
/// release gets the same size and alignment again, a power of two. The struct is copied at creation; what user points
/// to must outlive the object. C++ functions may throw: allocate then failed, and what release throws is ignored.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Allocator {
    public IntPtr Allocate;
    public IntPtr Release;
    /// <summary>The address of a void.</summary>
    public IntPtr User;
}

/// <summary>
/// The caller's own threads (a job system). run calls task(context, 0) .. task(context, count - 1),
/// each once, in any order, on any threads, several at a time or not, and returns when all have
/// returned. It is called on the thread that called the library, and by several threads at the same time
/// if several call the library. It must not call functions of the scene or solver whose work it runs.
/// The struct is copied at creation. A function in C++ may throw, if no call of task begins after that; the
/// thread that called the library waits for those under way and does what is left, and the results are the
/// same.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct TaskRunner {
    public IntPtr Run;
    /// <summary>The address of a void.</summary>
    public IntPtr User;
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Vec3 {
    public float X;
    public float Y;
    public float Z;
    public Vec3(float x, float y, float z) { X = x; Y = y; Z = z; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Quat {
    /// <summary>rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))</summary>
    public float X;
    /// <summary>rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))</summary>
    public float Y;
    /// <summary>rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))</summary>
    public float Z;
    /// <summary>rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))</summary>
    public float W;
    public Quat(float x, float y, float z, float w) { X = x; Y = y; Z = z; W = w; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Mat4 {
    /// <summary>element (row, column) is m[4 * column + row]</summary>
    private float m0, m1, m2, m3, m4, m5, m6, m7, m8, m9, m10, m11, m12, m13, m14, m15;
    public unsafe float this[int index] {
        get { fixed (float* first = &m0) return first[InRange(index, 16)]; }
        set { fixed (float* first = &m0) first[InRange(index, 16)] = value; }
    }
    private static int InRange(int index, int count) {
        return index >= 0 && index < count ? index : throw new IndexOutOfRangeException();
    }
}

/// <summary>x -&gt; position + rotation * (scale * x); scale &gt; 0.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Transform {
    public Vec3 Position;
    public Quat Rotation;
    public float Scale;
    public Transform(Vec3 position, Quat rotation, float scale) { Position = position; Rotation = rotation; Scale = scale; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Ray {
    public Vec3 Origin;
    /// <summary>any non-zero length</summary>
    public Vec3 Direction;
    /// <summary>&gt;= 0, in multiples of direction; INFINITY allowed</summary>
    public float TMax;
    public Ray(Vec3 origin, Vec3 direction, float tMax) { Origin = origin; Direction = direction; TMax = tMax; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Segment {
    /// <summary>may coincide: a point</summary>
    public Vec3 A;
    /// <summary>may coincide: a point</summary>
    public Vec3 B;
    public Segment(Vec3 a, Vec3 b) { A = a; B = b; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Sphere {
    public Vec3 Center;
    /// <summary>&gt;= 0</summary>
    public float Radius;
    public Sphere(Vec3 center, float radius) { Center = center; Radius = radius; }
}

/// <summary>All points within radius of the segment a b.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Capsule {
    /// <summary>may coincide: a sphere</summary>
    public Vec3 A;
    /// <summary>may coincide: a sphere</summary>
    public Vec3 B;
    /// <summary>&gt;= 0</summary>
    public float Radius;
    public Capsule(Vec3 a, Vec3 b, float radius) { A = a; B = b; Radius = radius; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Aabb {
    /// <summary>min &lt;= max on each axis; equality gives a flat box</summary>
    public Vec3 Min;
    /// <summary>min &lt;= max on each axis; equality gives a flat box</summary>
    public Vec3 Max;
    public Aabb(Vec3 min, Vec3 max) { Min = min; Max = max; }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct Obb {
    public Vec3 Center;
    /// <summary>&gt;= 0, along the axes of rotation</summary>
    public Vec3 HalfExtents;
    public Quat Rotation;
    public Obb(Vec3 center, Vec3 halfExtents, Quat rotation) { Center = center; HalfExtents = halfExtents; Rotation = rotation; }
}

/// <summary>
/// The points x with dot(normal, x) = distance. The normal points to the front; it need not be
/// exactly unit: signed distances are divided by its length (for a unit normal, distance is the
/// plane's distance from the origin). distance divided by that length is within the range of
/// coordinates too.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Plane {
    /// <summary>not zero</summary>
    public Vec3 Normal;
    public float Distance;
    public Plane(Vec3 normal, float distance) { Normal = normal; Distance = distance; }
}

/// <summary>
/// May be degenerate: then it is the segment or point that its corners span. The normal is that
/// of cross(b - a, c - a).
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Triangle {
    public Vec3 A;
    public Vec3 B;
    public Vec3 C;
    public Triangle(Vec3 a, Vec3 b, Vec3 c) { A = a; B = b; C = c; }
}

/// <summary>
/// The points x with dot(planes[i].normal, x - origin) &gt;= planes[i].distance for all six planes,
/// which look inward, in the order of FrustumNear, FAR and so on. Distances count from origin, so that a
/// frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Frustum {
    public Vec3 Origin;
    private Plane plane0, plane1, plane2, plane3, plane4, plane5;
    public unsafe Plane this[int index] {
        get { fixed (Plane* first = &plane0) return first[InRange(index, 6)]; }
        set { fixed (Plane* first = &plane0) first[InRange(index, 6)] = value; }
    }
    private static int InRange(int index, int count) {
        return index >= 0 && index < count ? index : throw new IndexOutOfRangeException();
    }
}

/// <summary>Where a ray, segment or swept sphere first meets something.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Hit {
    /// <summary>id of the model, 0 when the query was not of a scene</summary>
    public uint Model;
    /// <summary>the model's tag, 0 likewise</summary>
    public uint Tag;
    /// <summary>0 .. t_max; along a segment or sweep 0 .. 1</summary>
    public float T;
    /// <summary>where the surfaces meet</summary>
    public Vec3 Point;
    /// <summary>unit, against the motion: dot(normal, direction) &lt;= 0, for rays up to rounding</summary>
    public Vec3 Normal;
    /// <summary>index within a mesh, else NoTriangle</summary>
    public uint Triangle;
    /// <summary>barycentric weights of b and c of a triangle, else 0</summary>
    public float U;
    /// <summary>barycentric weights of b and c of a triangle, else 0</summary>
    public float V;
    /// <summary>hit values</summary>
    public uint Flags;
}

/// <summary>The closest point of something to a given point.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Nearest {
    /// <summary>as in Hit</summary>
    public uint Model;
    public uint Tag;
    /// <summary>equal to the query point when that is inside a solid</summary>
    public Vec3 Point;
    /// <summary>0 inside a solid</summary>
    public float Distance;
    /// <summary>index within a mesh, else NoTriangle</summary>
    public uint Triangle;
}

/// <summary>How far a ray goes and what it hits: fields of a Hit. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Distance {
    /// <summary>in multiples of the direction, so metres where its length is 1; INFINITY: nothing is hit</summary>
    public float T;
    /// <summary>as in Hit</summary>
    public uint Model;
    public uint Triangle;
}

/// <summary>How a solid gets out of something that it overlaps.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Penetration {
    /// <summary>as in Hit</summary>
    public uint Model;
    public uint Tag;
    /// <summary>on what is overlapped: where the two touch when the solid has gone depth along normal</summary>
    public Vec3 Point;
    /// <summary>unit: the way out, from what is overlapped to the solid</summary>
    public Vec3 Normal;
    /// <summary>metres along normal; 0 for shapes that touch</summary>
    public float Depth;
    /// <summary>index within a mesh, else NoTriangle</summary>
    public uint Triangle;
}

/// <summary>What is in a triangle array. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct MeshReport {
    public uint TriangleCount;
    /// <summary>triangles of exactly zero area</summary>
    public uint DegenerateCount;
    /// <summary>index of the first, or NoTriangle</summary>
    public uint FirstDegenerate;
    /// <summary>triangles with an index &gt;= vertexCount</summary>
    public uint OutOfRangeCount;
    public uint FirstOutOfRange;
    /// <summary>vertices that are not finite or beyond MaxCoordinate</summary>
    public uint BadVertexCount;
    /// <summary>or 0xffffffff</summary>
    public uint FirstBadVertex;
    /// <summary>edges that do not join exactly two triangles; 0 for a closed mesh</summary>
    public uint OpenEdgeCount;
}

[StructLayout(LayoutKind.Sequential)]
public partial struct MeshDesc {
    internal uint StructSize;
    /// <summary>
    /// null: the C++ runtime's
    /// The address of a gphys_allocator.
    /// </summary>
    public IntPtr Allocator;
    /// <summary>1: Mesh.SetVertices will be called; 12 bytes a vertex more. Since 1.1</summary>
    public int Deformable;
    /// <summary>0</summary>
    internal uint Reserved;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe MeshDesc Default {
        get {
            MeshDesc desc;
            Support.Check(Low.gphys_mesh_desc_init(&desc, (uint)sizeof(MeshDesc)));
            return desc;
        }
    }
}

/// <summary>What a mesh is. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct MeshInfo {
    public MeshKind Kind;
    public uint VertexCount;
    public uint TriangleCount;
    /// <summary>1: as MeshDesc.deformable, or in the form of a body</summary>
    public int Deformable;
    /// <summary>1: its form comes from a body, not from Mesh.SetVertices</summary>
    public int FollowsBody;
}

/// <summary>
/// How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
/// eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct OctreeStats {
    /// <summary>models or triangles in the tree</summary>
    public uint ItemCount;
    /// <summary>models of infinite extent, kept beside the tree</summary>
    public uint UnboundedCount;
    public uint NodeCount;
    public uint LeafCount;
    /// <summary>levels; 0 when empty</summary>
    public uint Depth;
    /// <summary>times it was rebuilt as a whole by one call since creation</summary>
    public uint Rebuilds;
    /// <summary>expected node and item tests of a random ray that meets the root box</summary>
    public float Cost;
    /// <summary>of the tree; saturates at 2^32 - 1</summary>
    public uint MemoryBytes;
}

/// <summary>One box of an octree, for drawing. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct OctreeBox {
    public Aabb Bounds;
    /// <summary>0 is the root</summary>
    public uint Depth;
    /// <summary>0 for an inner node</summary>
    public uint ItemCount;
}

[StructLayout(LayoutKind.Sequential)]
public partial struct SceneDesc {
    internal uint StructSize;
    /// <summary>
    /// null: the C++ runtime's
    /// The address of a gphys_allocator.
    /// </summary>
    public IntPtr Allocator;
    /// <summary>models to make room for at once; 0</summary>
    public uint ReserveModels;
    /// <summary>
    /// provides the worker_count threads; null: the scene's own
    /// The address of a gphys_task_runner.
    /// </summary>
    public IntPtr TaskRunner;
    /// <summary>threads for one call, including the caller's, at most 1024; 0 and 1: that alone</summary>
    public uint WorkerCount;
    /// <summary>must be 0</summary>
    internal uint Reserved;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe SceneDesc Default {
        get {
            SceneDesc desc;
            Support.Check(Low.gphys_scene_desc_init(&desc, (uint)sizeof(SceneDesc)));
            return desc;
        }
    }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct ModelDesc {
    internal uint StructSize;
    /// <summary>0: none</summary>
    public uint Parent;
    /// <summary>a query with mask m sees the model if layers &amp; m; default 1</summary>
    public uint Layers;
    /// <summary>any number of the caller's, returned with each hit; 0</summary>
    public uint Tag;
    /// <summary>as Scene.SetScale sets it; 1 1 1, and 0 0 0 is the same. Since 1.1</summary>
    public Vec3 Scale;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe ModelDesc Default {
        get {
            ModelDesc desc;
            Support.Check(Low.gphys_model_desc_init(&desc, (uint)sizeof(ModelDesc)));
            return desc;
        }
    }
}

/// <summary>What a model is. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct ModelInfo {
    public ShapeType Type;
    /// <summary>0: none</summary>
    public uint Parent;
    public uint Layers;
    public uint Tag;
    /// <summary>direct children</summary>
    public uint ChildCount;
}

[StructLayout(LayoutKind.Sequential)]
internal struct QueryFilterDescData {
    internal uint StructSize;
    internal uint Layers;
    internal uint IgnoredModel;
    internal uint Flags;
    internal IntPtr IgnoredModels;
    internal uint IgnoredCount;
    internal uint Reserved;
}

/// <summary>
/// Which models a query sees. Ids that name no model leave out nothing and are not an error: the
/// model that asked may have been removed since.
/// </summary>
public struct QueryFilterDesc {
    internal QueryFilterDescData Data;
    /// <summary>a model is seen if its own mask shares a bit; default AllLayers</summary>
    public uint Layers { get { return Data.Layers; } set { Data.Layers = value; } }
    /// <summary>left out; 0: none; default 0</summary>
    public uint IgnoredModel { get { return Data.IgnoredModel; } set { Data.IgnoredModel = value; } }
    /// <summary>filter values; default 0</summary>
    public uint Flags { get { return Data.Flags; } set { Data.Flags = value; } }
    /// <summary>left out as well, in any order; read during the call; default null</summary>
    public uint[] IgnoredModels;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe QueryFilterDesc Default {
        get {
            QueryFilterDescData desc;
            Support.Check(Low.gphys_query_filter_desc_init(&desc, (uint)sizeof(QueryFilterDescData)));
            return new QueryFilterDesc { Data = desc };
        }
    }
}

// Such settings in memory of the library's layout, with their lists behind them, for the time of a call.
internal unsafe struct QueryFilterDescs : IDisposable {
    internal readonly QueryFilterDescData* Pointer;
    internal readonly uint Stride;

    internal QueryFilterDescs(QueryFilterDesc? desc) : this(desc.HasValue ? new[] { desc.Value } : null) { }

    internal QueryFilterDescs(ReadOnlySpan<QueryFilterDesc> descs) {
        Pointer = null;
        Stride = descs.Length == 1 ? 0 : (uint)sizeof(QueryFilterDescData);
        if (descs.Length == 0) return;
        var bytes = (long)sizeof(QueryFilterDescData) * descs.Length;
        foreach (var desc in descs) {
            bytes += IgnoredModelsOf(desc).Length * (long)sizeof(uint);
        }
        Pointer = (QueryFilterDescData*)Marshal.AllocHGlobal(new IntPtr(bytes));
        var list = (uint*)(Pointer + descs.Length);
        for (var i = 0; i < descs.Length; ++i) {
            Pointer[i] = descs[i].Data;
            var givenIgnoredModels = IgnoredModelsOf(descs[i]);
            Pointer[i].IgnoredModels = givenIgnoredModels.Length == 0 ? IntPtr.Zero : (IntPtr)list;
            Pointer[i].IgnoredCount = (uint)givenIgnoredModels.Length;
            foreach (var number in givenIgnoredModels) *list++ = number;
        }
    }

    private static uint[] IgnoredModelsOf(QueryFilterDesc desc) { return desc.IgnoredModels ?? Array.Empty<uint>(); }
    public void Dispose() { Marshal.FreeHGlobal((IntPtr)Pointer); }
}

[StructLayout(LayoutKind.Sequential)]
public partial struct CameraDesc {
    internal uint StructSize;
    /// <summary>
    /// null: the C++ runtime's
    /// The address of a gphys_allocator.
    /// </summary>
    public IntPtr Allocator;
    public Handedness Handedness;
    public DepthRange DepthRange;
    /// <summary>1: near has the high depth, for float depth buffers</summary>
    public int ReverseZ;
    /// <summary>pixels, 1e-3 .. 1e6</summary>
    public float ViewportWidth;
    public float ViewportHeight;
    /// <summary>not read: a client of release 1.0 has padding here</summary>
    internal uint Reserved;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe CameraDesc Default {
        get {
            CameraDesc desc;
            Support.Check(Low.gphys_camera_desc_init(&desc, (uint)sizeof(CameraDesc)));
            return desc;
        }
    }
}

/// <summary>
/// Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
/// nothing depends on the frame time or on how often update is called. Frozen.
/// </summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Orbit {
    public Vec3 Target;
    /// <summary>any non-zero length; pitch is measured against it</summary>
    public Vec3 Up;
    /// <summary>metres from target, &gt; 0</summary>
    public float Distance;
    /// <summary>
    /// radians; yaw 0 looks along the reference direction that is
    /// perpendicular to up (+Z for up = +Y), yaw &gt; 0 to the right of
    /// it; pitch &gt; 0 looks down
    /// </summary>
    public float Yaw;
    /// <summary>
    /// radians; yaw 0 looks along the reference direction that is
    /// perpendicular to up (+Z for up = +Y), yaw &gt; 0 to the right of
    /// it; pitch &gt; 0 looks down
    /// </summary>
    public float Pitch;
    /// <summary>of Camera.OrbitRotate</summary>
    public float RadiansPerUnit;
    /// <summary>of Camera.OrbitZoom and _pan</summary>
    public float MetresPerUnit;
    /// <summary>0 &lt; min &lt;= max; max INFINITY allowed</summary>
    public float MinDistance;
    /// <summary>0 &lt; min &lt;= max; max INFINITY allowed</summary>
    public float MaxDistance;
    /// <summary>within -pi/2 .. pi/2</summary>
    public float MinPitch;
    /// <summary>within -pi/2 .. pi/2</summary>
    public float MaxPitch;
}

/// <summary>What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct OrbitSpeeds {
    /// <summary>radians a unit, of yaw and pitch</summary>
    public float RotateX;
    /// <summary>radians a unit, of yaw and pitch</summary>
    public float RotateY;
    /// <summary>metres a unit</summary>
    public float Zoom;
    /// <summary>metres a unit, to the right and up</summary>
    public float PanX;
    /// <summary>metres a unit, to the right and up</summary>
    public float PanY;
}

[StructLayout(LayoutKind.Sequential)]
public partial struct SolverDesc {
    internal uint StructSize;
    /// <summary>
    /// null: the C++ runtime's
    /// The address of a gphys_allocator.
    /// </summary>
    public IntPtr Allocator;
    /// <summary>m/s^2; default (0, -9.81, 0)</summary>
    public Vec3 Gravity;
    /// <summary>of one step, 1 .. 1000; default 8; with error targets: of the first step</summary>
    public uint Substeps;
    /// <summary>seconds simulated by each step of Solver.Advance; 1/60</summary>
    public float FixedStep;
    /// <summary>most steps of one advance; time beyond is dropped; 8</summary>
    public uint MaxSteps;
    /// <summary>
    /// provides the worker_count threads; null: the solver's own
    /// The address of a gphys_task_runner.
    /// </summary>
    public IntPtr TaskRunner;
    /// <summary>threads for one step, including the caller's, at most 1024; 0 and 1: that alone</summary>
    public uint WorkerCount;
    /// <summary>m/s, see Solver.GetSleeping; 0: bodies never sleep; default 0</summary>
    public float SleepSpeed;
    /// <summary>
    /// of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by
    /// the mean rest length of the body's rigid constraints; default 0.01
    /// </summary>
    public float SleepStrain;
    /// <summary>seconds; default 0.5</summary>
    public float SleepTime;
    /// <summary>of rigid constraints, see Solver.GetSubsteps; 0: none, for cloth 0.02; default 0</summary>
    public float MaxStrain;
    /// <summary>target of positions: metres of error that a second of motion adds; 0: none; default 0</summary>
    public float Tolerance;
    /// <summary>the most that a target may ask for, 1 .. 1000; default 64</summary>
    public uint MaxSubsteps;
    /// <summary>see SolverSettings; 0: no bound; default 0</summary>
    public uint MaxWork;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe SolverDesc Default {
        get {
            SolverDesc desc;
            Support.Check(Low.gphys_solver_desc_init(&desc, (uint)sizeof(SolverDesc)));
            return desc;
        }
    }
}

/// <summary>What a solver was created with and may change later. Fields as in SolverDesc. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct SolverSettings {
    /// <summary>m/s^2</summary>
    public Vec3 Gravity;
    /// <summary>1 .. 1000</summary>
    public uint Substeps;
    /// <summary>seconds, 1e-6 .. 0.5</summary>
    public float FixedStep;
    /// <summary>&gt;= 1</summary>
    public uint MaxSteps;
    /// <summary>m/s, &gt;= 0</summary>
    public float SleepSpeed;
    /// <summary>&gt;= 0</summary>
    public float SleepStrain;
    /// <summary>seconds, &gt;= 0</summary>
    public float SleepTime;
    /// <summary>&gt;= 0</summary>
    public float MaxStrain;
    /// <summary>m/s, &gt;= 0</summary>
    public float Tolerance;
    /// <summary>1 .. 1000</summary>
    public uint MaxSubsteps;
    /// <summary>
    /// most particles times substeps of a step; 0: no bound. If bodies need more, all take fewer
    /// substeps in proportion, at least one, and cloth at least one for each 25 ms. It bounds
    /// work, not time, so the bits are the same on every machine
    /// </summary>
    public uint MaxWork;
}

/// <summary>Settings shared by all kinds of bodies.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct BodyDesc {
    internal uint StructSize;
    /// <summary>kg of the whole body, spread evenly; &gt; 0; default 1</summary>
    public float Mass;
    /// <summary>of each particle for collision, metres, &gt;= 0; default 0.01</summary>
    public float Radius;
    /// <summary>rate in 1/s: velocities decay as exp(-damping t); &gt;= 0; default 0</summary>
    public float Damping;
    /// <summary>Coulomb coefficient against models, &gt;= 0; default 0.5</summary>
    public float Friction;
    /// <summary>speed kept in a bounce, 0 .. 1; default 0</summary>
    public float Restitution;
    /// <summary>of stretch, metres per newton, &gt;= 0; 0 is inextensible; default 0</summary>
    public float Compliance;
    /// <summary>of ClothBend constraints, m/N; default 0.001</summary>
    public float BendCompliance;
    /// <summary>cloth values; default SHEAR | BEND</summary>
    public uint ClothFlags;
    /// <summary>mask of the models it collides with; 0: none; default all</summary>
    public uint Layers;
    /// <summary>
    /// of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
    /// friction, or 0: as friction; default 0
    /// </summary>
    public float StaticFriction;
    /// <summary>1: its particles collide with one another, see below; default 0</summary>
    public uint SelfCollision;
    /// <summary>two bodies collide with each other if their masks share a bit; 0: with none; default 0</summary>
    public uint BodyLayers;
    /// <summary>of ClothShear constraints of a grid, m/N, &gt;= 0; 0: as compliance; default 0</summary>
    public float ShearCompliance;
    /// <summary>of each constraint, newtons, &gt;= 0; 0: none breaks; default 0; see Break</summary>
    public float BreakingForce;
    /// <summary>of ropes, E I in N m^2, &gt;= 0; 0: they bend freely; default 0; see below</summary>
    public float BendingStiffness;
    /// <summary>The defaults of the loaded library, to be changed.</summary>
    public static unsafe BodyDesc Default {
        get {
            BodyDesc desc;
            Support.Check(Low.gphys_body_desc_init(&desc, (uint)sizeof(BodyDesc)));
            return desc;
        }
    }
}

/// <summary>What all particles of a body share and may change later. Fields as in BodyDesc. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct BodySettings {
    /// <summary>1/s, &gt;= 0</summary>
    public float Damping;
    /// <summary>&gt;= 0</summary>
    public float Friction;
    /// <summary>at least friction, or 0: as friction</summary>
    public float StaticFriction;
    /// <summary>0 .. 1</summary>
    public float Restitution;
    /// <summary>of models</summary>
    public uint Layers;
    /// <summary>of bodies</summary>
    public uint BodyLayers;
    /// <summary>0 or 1; particles nearer than their radii reach when it is set do not collide</summary>
    public uint SelfCollision;
}

/// <summary>Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct BodyInfo {
    public BodyKind Kind;
    public SolveMethod Method;
    public uint ParticleCount;
    public uint ConstraintCount;
    /// <summary>of cloth, for drawing</summary>
    public uint TriangleCount;
}

/// <summary>The air around a body. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Wind {
    /// <summary>of the air, m/s</summary>
    public Vec3 Velocity;
    /// <summary>kg/m^3, &gt;= 0; 1.2 is air at 20 degrees; 0: none</summary>
    public float Density;
    /// <summary>coefficient C_D, &gt;= 0: a plate across has 1.2, a cylinder 1.2, a sphere 0.5</summary>
    public float Drag;
    /// <summary>coefficient C_L of cloth, &gt;= 0; a plate has as much lift as drag</summary>
    public float Lift;
}

/// <summary>Where an animation wants a particle, and how far from there the particle may be. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct AnimationTarget {
    /// <summary>metres</summary>
    public Vec3 Position;
    /// <summary>
    /// of the animated surface, away from the character; any length but 0; not read without
    /// a backstop
    /// </summary>
    public Vec3 Normal;
    /// <summary>metres from position, &gt;= 0; INFINITY: any</summary>
    public float MaxDistance;
    /// <summary>
    /// metres that the particle may go behind the plane through position across normal, &gt;= 0;
    /// INFINITY: any
    /// </summary>
    public float Backstop;
}

/// <summary>A particle that is attached to a model. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Attachment {
    public uint Particle;
    public uint Model;
    /// <summary>in the model's coordinates, as for Solver.Attach</summary>
    public Vec3 LocalPoint;
}

/// <summary>One constraint. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct ConstraintInfo {
    public uint Id;
    public uint ParticleA;
    public uint ParticleB;
    /// <summary>metres</summary>
    public float RestLength;
    /// <summary>metres per newton</summary>
    public float Compliance;
}

/// <summary>The settings of a constraint. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct ConstraintSettings {
    /// <summary>metres, &gt;= 0, below 1e-9 as 0; negative, when it is set: the present distance</summary>
    public float RestLength;
    /// <summary>metres per newton, &gt;= 0; 0 is rigid</summary>
    public float Compliance;
    /// <summary>N s/m, &gt;= 0, of what has compliance; see Solver.SetConstraintDamping</summary>
    public float Damping;
}

/// <summary>One joint. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct JointInfo {
    public uint Id;
    public uint BodyA;
    public uint ParticleA;
    public uint BodyB;
    public uint ParticleB;
    /// <summary>metres</summary>
    public float RestLength;
    /// <summary>metres per newton</summary>
    public float Compliance;
    /// <summary>
    /// newtons, in the last substep: &gt; 0 pulls them together, &lt; 0 keeps them apart; its
    /// magnitude for a rest length of 0
    /// </summary>
    public float Force;
}

/// <summary>A constraint that broke, or that the caller has broken. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Break {
    public uint Body;
    public uint Constraint;
    /// <summary>its particles before</summary>
    public uint ParticleA;
    /// <summary>its particles before</summary>
    public uint ParticleB;
    /// <summary>where cloth parted; NoParticle: nowhere, the constraint was removed</summary>
    public uint TornParticle;
    /// <summary>its copy, the last of the body; NoParticle: none</summary>
    public uint NewParticle;
    /// <summary>newtons; 0 if the caller broke it</summary>
    public float Load;
}

/// <summary>Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct SolverStats {
    public uint ParticleCount;
    /// <summary>pinned or attached</summary>
    public uint PinnedCount;
    public uint ConstraintCount;
    /// <summary>particle and model pairs that touched in the last step, 4 a particle at most</summary>
    public uint ContactCount;
    /// <summary>largest |length / rest length - 1| of rigid constraints whose rest length is not 0</summary>
    public float StrainMax;
    /// <summary>root mean square of the same</summary>
    public float StrainRms;
    /// <summary>joules</summary>
    public float KineticEnergy;
    /// <summary>joules: of gravity, 0 at the solver's origin, of stretch, bending and held volumes</summary>
    public float PotentialEnergy;
}

/// <summary>A particle that touched a model in the last step. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Contact {
    public uint Body;
    public uint Particle;
    public uint Model;
    /// <summary>the model's</summary>
    public uint Tag;
    /// <summary>on the model, world space</summary>
    public Vec3 Point;
    /// <summary>unit, from the model to the particle</summary>
    public Vec3 Normal;
}

/// <summary>Two particles of different bodies that touched in the last step. Frozen.  Since 1.1.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct BodyContact {
    public uint BodyA;
    public uint ParticleA;
    /// <summary>above bodyA</summary>
    public uint BodyB;
    public uint ParticleB;
    /// <summary>unit, from a to b, when they touched last</summary>
    public Vec3 Normal;
    /// <summary>metres between their surfaces as they are now; below 0: they overlap</summary>
    public float Distance;
    /// <summary>
    /// N s along normal, of the whole step: b got it, and a its opposite. The reactions of links and
    /// models are not in it
    /// </summary>
    public float Impulse;
}

/// <summary>What bodies gave a model in the last step, by contacts and by attachments. Frozen.</summary>
[StructLayout(LayoutKind.Sequential)]
public partial struct Impulse {
    public uint Model;
    /// <summary>the model's</summary>
    public uint Tag;
    /// <summary>N s: what to add to the momentum of the model if it is a body of yours</summary>
    public Vec3 Linear;
    /// <summary>N m s, about the model's position in the world: likewise for its angular momentum</summary>
    public Vec3 Angular;
}

[StructLayout(LayoutKind.Explicit)]
internal struct AnyShape {
    [FieldOffset(0)] internal Sphere Sphere;
    [FieldOffset(0)] internal Capsule Capsule;
    [FieldOffset(0)] internal Aabb Aabb;
    [FieldOffset(0)] internal Obb Obb;
    [FieldOffset(0)] internal Plane Plane;
    [FieldOffset(0)] internal Triangle Triangle;
    [FieldOffset(0)] internal Frustum Frustum;
    [FieldOffset(0)] internal Ray Ray;
    [FieldOffset(0)] internal Segment Segment;
}

public partial struct Shape {
    public static implicit operator Shape(Sphere shape) {
        return new Shape { Type = ShapeType.Sphere, Data = new AnyShape { Sphere = shape } };
    }
    public Sphere Sphere { get { return Type == ShapeType.Sphere ? Data.Sphere : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Capsule shape) {
        return new Shape { Type = ShapeType.Capsule, Data = new AnyShape { Capsule = shape } };
    }
    public Capsule Capsule { get { return Type == ShapeType.Capsule ? Data.Capsule : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Aabb shape) {
        return new Shape { Type = ShapeType.Aabb, Data = new AnyShape { Aabb = shape } };
    }
    public Aabb Aabb { get { return Type == ShapeType.Aabb ? Data.Aabb : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Obb shape) {
        return new Shape { Type = ShapeType.Obb, Data = new AnyShape { Obb = shape } };
    }
    public Obb Obb { get { return Type == ShapeType.Obb ? Data.Obb : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Plane shape) {
        return new Shape { Type = ShapeType.Plane, Data = new AnyShape { Plane = shape } };
    }
    public Plane Plane { get { return Type == ShapeType.Plane ? Data.Plane : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Triangle shape) {
        return new Shape { Type = ShapeType.Triangle, Data = new AnyShape { Triangle = shape } };
    }
    public Triangle Triangle { get { return Type == ShapeType.Triangle ? Data.Triangle : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Frustum shape) {
        return new Shape { Type = ShapeType.Frustum, Data = new AnyShape { Frustum = shape } };
    }
    public Frustum Frustum { get { return Type == ShapeType.Frustum ? Data.Frustum : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Ray shape) {
        return new Shape { Type = ShapeType.Ray, Data = new AnyShape { Ray = shape } };
    }
    public Ray Ray { get { return Type == ShapeType.Ray ? Data.Ray : throw new InvalidCastException("the shape is a " + Type); } }
    public static implicit operator Shape(Segment shape) {
        return new Shape { Type = ShapeType.Segment, Data = new AnyShape { Segment = shape } };
    }
    public Segment Segment { get { return Type == ShapeType.Segment ? Data.Segment : throw new InvalidCastException("the shape is a " + Type); } }
}

public readonly ref partial struct Shapes {
    public static implicit operator Shapes(Sphere[] shapes) {
        return new Shapes(ShapeType.Sphere, MemoryMarshal.AsBytes<Sphere>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Sphere> shapes) {
        return new Shapes(ShapeType.Sphere, MemoryMarshal.AsBytes<Sphere>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Sphere> shapes) {
        return new Shapes(ShapeType.Sphere, MemoryMarshal.AsBytes<Sphere>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Capsule[] shapes) {
        return new Shapes(ShapeType.Capsule, MemoryMarshal.AsBytes<Capsule>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Capsule> shapes) {
        return new Shapes(ShapeType.Capsule, MemoryMarshal.AsBytes<Capsule>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Capsule> shapes) {
        return new Shapes(ShapeType.Capsule, MemoryMarshal.AsBytes<Capsule>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Aabb[] shapes) {
        return new Shapes(ShapeType.Aabb, MemoryMarshal.AsBytes<Aabb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Aabb> shapes) {
        return new Shapes(ShapeType.Aabb, MemoryMarshal.AsBytes<Aabb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Aabb> shapes) {
        return new Shapes(ShapeType.Aabb, MemoryMarshal.AsBytes<Aabb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Obb[] shapes) {
        return new Shapes(ShapeType.Obb, MemoryMarshal.AsBytes<Obb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Obb> shapes) {
        return new Shapes(ShapeType.Obb, MemoryMarshal.AsBytes<Obb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Obb> shapes) {
        return new Shapes(ShapeType.Obb, MemoryMarshal.AsBytes<Obb>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Plane[] shapes) {
        return new Shapes(ShapeType.Plane, MemoryMarshal.AsBytes<Plane>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Plane> shapes) {
        return new Shapes(ShapeType.Plane, MemoryMarshal.AsBytes<Plane>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Plane> shapes) {
        return new Shapes(ShapeType.Plane, MemoryMarshal.AsBytes<Plane>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Triangle[] shapes) {
        return new Shapes(ShapeType.Triangle, MemoryMarshal.AsBytes<Triangle>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Triangle> shapes) {
        return new Shapes(ShapeType.Triangle, MemoryMarshal.AsBytes<Triangle>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Triangle> shapes) {
        return new Shapes(ShapeType.Triangle, MemoryMarshal.AsBytes<Triangle>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Frustum[] shapes) {
        return new Shapes(ShapeType.Frustum, MemoryMarshal.AsBytes<Frustum>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Frustum> shapes) {
        return new Shapes(ShapeType.Frustum, MemoryMarshal.AsBytes<Frustum>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Frustum> shapes) {
        return new Shapes(ShapeType.Frustum, MemoryMarshal.AsBytes<Frustum>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Ray[] shapes) {
        return new Shapes(ShapeType.Ray, MemoryMarshal.AsBytes<Ray>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Ray> shapes) {
        return new Shapes(ShapeType.Ray, MemoryMarshal.AsBytes<Ray>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Ray> shapes) {
        return new Shapes(ShapeType.Ray, MemoryMarshal.AsBytes<Ray>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Segment[] shapes) {
        return new Shapes(ShapeType.Segment, MemoryMarshal.AsBytes<Segment>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(Span<Segment> shapes) {
        return new Shapes(ShapeType.Segment, MemoryMarshal.AsBytes<Segment>(shapes), shapes.Length);
    }
    public static implicit operator Shapes(ReadOnlySpan<Segment> shapes) {
        return new Shapes(ShapeType.Segment, MemoryMarshal.AsBytes<Segment>(shapes), shapes.Length);
    }
}

}
