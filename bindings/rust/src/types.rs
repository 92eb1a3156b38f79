// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
use crate::support::{Hook, List, Size};
use std::ffi::c_void;

/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Status(pub i32);
impl Status {
    pub const OK: Status = Status(0);
    /// the query found nothing; outputs untouched
    pub const NO_HIT: Status = Status(1);
    /// more results than the caller's array holds
    pub const INCOMPLETE: Status = Status(2);
    /// the answer is infinite (bounds of a plane); outputs untouched
    pub const UNBOUNDED: Status = Status(3);
    /// null, NaN, infinite, out of range, wrong stride, ...
    pub const ERROR_INVALID_ARGUMENT: Status = Status(-1);
    /// no such model, body, constraint or joint, or no longer
    pub const ERROR_INVALID_ID: Status = Status(-2);
    /// a desc not initialised, or newer than this library
    pub const ERROR_STRUCT_SIZE: Status = Status(-3);
    pub const ERROR_OUT_OF_MEMORY: Status = Status(-4);
    /// more than a limit, 2^24 - 1 unless the function says another
    pub const ERROR_CAPACITY: Status = Status(-5);
    /// a model would become its own ancestor
    pub const ERROR_CYCLE: Status = Status(-6);
    /// the operation has no meaning for this kind of shape
    pub const ERROR_UNSUPPORTED: Status = Status(-7);
    /// a matrix without an inverse
    pub const ERROR_SINGULAR: Status = Status(-8);
    /// a defect of the library; please report it
    pub const ERROR_INTERNAL: Status = Status(-100);
}

pub const FRUSTUM_NEAR: u32 = 0;
pub const FRUSTUM_FAR: u32 = 1;
pub const FRUSTUM_LEFT: u32 = 2;
pub const FRUSTUM_RIGHT: u32 = 3;
pub const FRUSTUM_BOTTOM: u32 = 4;
pub const FRUSTUM_TOP: u32 = 5;

/// the ray or the swept sphere started inside or touching: t is 0
pub const HIT_INSIDE: u32 = 1;
/// a surface was met from behind its normal
pub const HIT_BACK: u32 = 2;

/// Says which struct a `const void* shape` points to.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ShapeType(pub i32);
impl ShapeType {
    /// `Sphere`
    pub const SPHERE: ShapeType = ShapeType(1);
    /// `Capsule`
    pub const CAPSULE: ShapeType = ShapeType(2);
    /// `Aabb`
    pub const AABB: ShapeType = ShapeType(3);
    /// `Obb`
    pub const OBB: ShapeType = ShapeType(4);
    /// `Plane`
    pub const PLANE: ShapeType = ShapeType(5);
    /// `Triangle`
    pub const TRIANGLE: ShapeType = ShapeType(6);
    /// `Frustum`
    pub const FRUSTUM: ShapeType = ShapeType(7);
    /// `Mesh`: the handle itself; a convex hull too
    pub const MESH: ShapeType = ShapeType(8);
    /// `Ray`
    pub const RAY: ShapeType = ShapeType(16);
    /// `Segment`
    pub const SEGMENT: ShapeType = ShapeType(17);
}

/// On which side something is of a plane or a frustum.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Side(pub i32);
impl Side {
    /// wholly behind the plane, wholly outside the frustum
    pub const OUTSIDE: Side = Side(-1);
    /// touches or crosses the boundary
    pub const CROSSING: Side = Side(0);
    /// wholly in front of the plane, wholly inside the frustum
    pub const INSIDE: Side = Side(1);
}

/// Depth range of clip space.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct DepthRange(pub i32);
impl DepthRange {
    /// DirectX, Vulkan, Metal, WebGPU
    pub const ZERO_TO_ONE: DepthRange = DepthRange(0);
    /// OpenGL, WebGL
    pub const MINUS_ONE_TO_ONE: DepthRange = DepthRange(1);
}

/// What a mesh consists of.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct MeshKind(pub i32);
impl MeshKind {
    /// triangles
    pub const SURFACE: MeshKind = MeshKind(0);
    /// the triangles of a cloth: `Mesh`
    pub const BODY_SURFACE: MeshKind = MeshKind(1);
    /// the links and particles of a rope, or free particles: likewise
    pub const BODY_LINKS: MeshKind = MeshKind(2);
    /// a solid: `Mesh`
    pub const HULL: MeshKind = MeshKind(3);
}

/// ignored_model stands for its descendants, too
pub const FILTER_SUBTREE: u32 = 1;
/// planes, triangles and meshes that are not solid are not hit from behind: by
/// rays with `HIT_BACK`, or by sweeps along their normal; other queries
/// have no direction and ignore this flag and the next
pub const FILTER_NO_BACK_FACES: u32 = 2;
/// they are met from behind only: the inside of a closed mesh
pub const FILTER_NO_FRONT_FACES: u32 = 4;

/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Projection(pub i32);
impl Projection {
    pub const PERSPECTIVE: Projection = Projection(0);
    pub const ORTHOGRAPHIC: Projection = Projection(1);
    pub const USER: Projection = Projection(2);
}

/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Handedness(pub i32);
impl Handedness {
    /// looks along its own +Z
    pub const LEFT_HANDED: Handedness = Handedness(0);
    /// looks along its own -Z
    pub const RIGHT_HANDED: Handedness = Handedness(1);
}

/// Where the rays of a perspective camera begin.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct PickStart(pub i32);
impl PickStart {
    /// what is drawn can be picked; nothing between camera and near plane
    pub const NEAR_PLANE: PickStart = PickStart(0);
    /// at the camera's position: what is between it and the near plane, too
    pub const CENTRE: PickStart = PickStart(1);
}

/// constraints along both diagonals of each grid cell: stiff like paper
pub const CLOTH_SHEAR: u32 = 1;
/// constraints that resist folding
pub const CLOTH_BEND: u32 = 2;

/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct BodyKind(pub i32);
impl BodyKind {
    pub const PARTICLES: BodyKind = BodyKind(1);
    pub const ROPE: BodyKind = BodyKind(2);
    pub const CLOTH: BodyKind = BodyKind(3);
}

/// How a body is solved, chosen from its constraints.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct SolveMethod(pub i32);
impl SolveMethod {
    /// no constraints: exact flight
    pub const FREE: SolveMethod = SolveMethod(0);
    /// chains and trees: Newton on the whole body at once
    pub const DIRECT: SolveMethod = SolveMethod(1);
    /// cycles of constraints, volume, clusters, or a particle with more than 64 constraints:
    /// coloured batches of chains, then the rest, then reach limits
    pub const GRAPH: SolveMethod = SolveMethod(2);
}

/// What a constraint holds.
/// A later library may have values that are not listed here.
#[repr(transparent)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct ConstraintKind(pub i32);
impl ConstraintKind {
    /// its length: `Solver::add_distance`, and those created with a body
    pub const DISTANCE: ConstraintKind = ConstraintKind(0);
    /// at most its length; it may go slack: `Solver::add_max_distance`
    pub const MAX_DISTANCE: ConstraintKind = ConstraintKind(1);
}

pub const VERSION_MAJOR: u32 = 1;
pub const VERSION_MINOR: u32 = 1;
pub const VERSION_PATCH: u32 = 0;
pub const MAX_COORDINATE: f32 = 1e15;
pub const NO_TRIANGLE: u32 = 0xffffffff;
pub const NO_PARTICLE: u32 = 0xffffffff;
pub const ALL_LAYERS: u32 = 0xffffffff;
pub type ModelId = u32;
pub type BodyId = u32;
pub type ConstraintId = u32;
pub type ClusterId = u32;
pub type JointId = u32;
/// One part of a call's work: the function to call, with the context and an index. Any thread may
/// call it; it returns when that part is done, without calling back.
pub type Task = Option<unsafe extern "C" fn(*mut c_void, u32)>;

/// Memory functions for one object and everything in it. Both are called on the thread that calls
/// the library, from several threads if the objects that share it are used from several threads.
/// Neither may be None. allocate returns None on failure (reported as `Status::ERROR_OUT_OF_MEMORY`, nothing changed);
/// release gets the same size and alignment again, a power of two. The struct is copied at creation; what user points
/// to must outlive the object. C++ functions may throw: allocate then failed, and what release throws is ignored.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct Allocator {
    pub allocate: Option<unsafe extern "C" fn(*mut c_void, usize, usize) -> *mut c_void>,
    pub release: Option<unsafe extern "C" fn(*mut c_void, *mut c_void, usize, usize)>,
    pub user: *mut c_void,
}

/// The caller's own threads (a job system). run calls task(context, 0) .. task(context, count - 1),
/// each once, in any order, on any threads, several at a time or not, and returns when all have
/// returned. It is called on the thread that called the library, and by several threads at the same time
/// if several call the library. It must not call functions of the scene or solver whose work it runs.
/// The struct is copied at creation. A function in C++ may throw, if no call of task begins after that; the
/// thread that called the library waits for those under way and does what is left, and the results are the
/// same.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct TaskRunner {
    pub run: Option<unsafe extern "C" fn(*mut c_void, Task, *mut c_void, u32)>,
    pub user: *mut c_void,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Vec3 {
    pub x: f32,
    pub y: f32,
    pub z: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quat {
    /// rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
    pub x: f32,
    /// rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
    pub y: f32,
    /// rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
    pub z: f32,
    /// rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
    pub w: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mat4 {
    /// element (row, column) is m[4 * column + row]
    pub m: [f32; 16],
}

/// x -> position + rotation * (scale * x); scale > 0.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    pub position: Vec3,
    pub rotation: Quat,
    pub scale: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Ray {
    pub origin: Vec3,
    /// any non-zero length
    pub direction: Vec3,
    /// >= 0, in multiples of direction; INFINITY allowed
    pub t_max: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Segment {
    /// may coincide: a point
    pub a: Vec3,
    /// may coincide: a point
    pub b: Vec3,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Sphere {
    pub center: Vec3,
    /// >= 0
    pub radius: f32,
}

/// All points within radius of the segment a b.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Capsule {
    /// may coincide: a sphere
    pub a: Vec3,
    /// may coincide: a sphere
    pub b: Vec3,
    /// >= 0
    pub radius: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Aabb {
    /// min <= max on each axis; equality gives a flat box
    pub min: Vec3,
    /// min <= max on each axis; equality gives a flat box
    pub max: Vec3,
}

#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Obb {
    pub center: Vec3,
    /// >= 0, along the axes of rotation
    pub half_extents: Vec3,
    pub rotation: Quat,
}

/// The points x with dot(normal, x) = distance. The normal points to the front; it need not be
/// exactly unit: signed distances are divided by its length (for a unit normal, distance is the
/// plane's distance from the origin). distance divided by that length is within the range of
/// coordinates too.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Plane {
    /// not zero
    pub normal: Vec3,
    pub distance: f32,
}

/// May be degenerate: then it is the segment or point that its corners span. The normal is that
/// of cross(b - a, c - a).
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Triangle {
    pub a: Vec3,
    pub b: Vec3,
    pub c: Vec3,
}

/// The points x with dot(`planes[i]`.normal, x - origin) >= `planes[i]`.distance for all six planes,
/// which look inward, in the order of `FRUSTUM_NEAR`, FAR and so on. Distances count from origin, so that a
/// frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Frustum {
    pub origin: Vec3,
    pub planes: [Plane; 6],
}

/// Where a ray, segment or swept sphere first meets something.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Hit {
    /// id of the model, 0 when the query was not of a scene
    pub model: u32,
    /// the model's tag, 0 likewise
    pub tag: u32,
    /// 0 .. t_max; along a segment or sweep 0 .. 1
    pub t: f32,
    /// where the surfaces meet
    pub point: Vec3,
    /// unit, against the motion: dot(normal, direction) <= 0, for rays up to rounding
    pub normal: Vec3,
    /// index within a mesh, else `NO_TRIANGLE`
    pub triangle: u32,
    /// barycentric weights of b and c of a triangle, else 0
    pub u: f32,
    /// barycentric weights of b and c of a triangle, else 0
    pub v: f32,
    /// hit values
    pub flags: u32,
}

/// The closest point of something to a given point.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Nearest {
    /// as in `Hit`
    pub model: u32,
    pub tag: u32,
    /// equal to the query point when that is inside a solid
    pub point: Vec3,
    /// 0 inside a solid
    pub distance: f32,
    /// index within a mesh, else `NO_TRIANGLE`
    pub triangle: u32,
}

/// How far a ray goes and what it hits: fields of a `Hit`. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Distance {
    /// in multiples of the direction, so metres where its length is 1; INFINITY: nothing is hit
    pub t: f32,
    /// as in `Hit`
    pub model: u32,
    pub triangle: u32,
}

/// How a solid gets out of something that it overlaps.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Penetration {
    /// as in `Hit`
    pub model: u32,
    pub tag: u32,
    /// on what is overlapped: where the two touch when the solid has gone depth along normal
    pub point: Vec3,
    /// unit: the way out, from what is overlapped to the solid
    pub normal: Vec3,
    /// metres along normal; 0 for shapes that touch
    pub depth: f32,
    /// index within a mesh, else `NO_TRIANGLE`
    pub triangle: u32,
}

/// What is in a triangle array. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct MeshReport {
    pub triangle_count: u32,
    /// triangles of exactly zero area
    pub degenerate_count: u32,
    /// index of the first, or `NO_TRIANGLE`
    pub first_degenerate: u32,
    /// triangles with an index >= vertex_count
    pub out_of_range_count: u32,
    pub first_out_of_range: u32,
    /// vertices that are not finite or beyond `MAX_COORDINATE`
    pub bad_vertex_count: u32,
    /// or 0xffffffff
    pub first_bad_vertex: u32,
    /// edges that do not join exactly two triangles; 0 for a closed mesh
    pub open_edge_count: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct MeshDesc {
    pub struct_size: Size<MeshDesc>,
    /// None: the C++ runtime's
    pub allocator: Hook<Allocator>,
    /// 1: `Mesh::set_vertices` will be called; 12 bytes a vertex more. Since 1.1
    pub deformable: i32,
    /// 0
    pub reserved: u32,
}

/// What a mesh is. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct MeshInfo {
    pub kind: MeshKind,
    pub vertex_count: u32,
    pub triangle_count: u32,
    /// 1: as `MeshDesc`.deformable, or in the form of a body
    pub deformable: i32,
    /// 1: its form comes from a body, not from `Mesh::set_vertices`
    pub follows_body: i32,
}

/// How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
/// eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct OctreeStats {
    /// models or triangles in the tree
    pub item_count: u32,
    /// models of infinite extent, kept beside the tree
    pub unbounded_count: u32,
    pub node_count: u32,
    pub leaf_count: u32,
    /// levels; 0 when empty
    pub depth: u32,
    /// times it was rebuilt as a whole by one call since creation
    pub rebuilds: u32,
    /// expected node and item tests of a random ray that meets the root box
    pub cost: f32,
    /// of the tree; saturates at 2^32 - 1
    pub memory_bytes: u32,
}

/// One box of an octree, for drawing. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct OctreeBox {
    pub bounds: Aabb,
    /// 0 is the root
    pub depth: u32,
    /// 0 for an inner node
    pub item_count: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SceneDesc {
    pub struct_size: Size<SceneDesc>,
    /// None: the C++ runtime's
    pub allocator: Hook<Allocator>,
    /// models to make room for at once; 0
    pub reserve_models: u32,
    /// provides the worker_count threads; None: the scene's own
    pub task_runner: Hook<TaskRunner>,
    /// threads for one call, including the caller's, at most 1024; 0 and 1: that alone
    pub worker_count: u32,
    /// must be 0
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct ModelDesc {
    pub struct_size: Size<ModelDesc>,
    /// 0: none
    pub parent: ModelId,
    /// a query with mask m sees the model if layers & m; default 1
    pub layers: u32,
    /// any number of the caller's, returned with each hit; 0
    pub tag: u32,
    /// as `Scene::set_scale` sets it; 1 1 1, and 0 0 0 is the same. Since 1.1
    pub scale: Vec3,
}

/// What a model is. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ModelInfo {
    pub type_: ShapeType,
    /// 0: none
    pub parent: ModelId,
    pub layers: u32,
    pub tag: u32,
    /// direct children
    pub child_count: u32,
}

/// Which models a query sees. Ids that name no model leave out nothing and are not an error: the
/// model that asked may have been removed since.
#[repr(C)]
#[cfg_attr(target_pointer_width = "64", repr(align(8)))]
#[derive(Clone, Copy, Debug)]
pub struct QueryFilterDesc<'a> {
    pub struct_size: Size<QueryFilterDesc<'a>>,
    /// a model is seen if its own mask shares a bit; default `ALL_LAYERS`
    pub layers: u32,
    /// left out; 0: none; default 0
    pub ignored_model: ModelId,
    /// filter values; default 0
    pub flags: u32,
    /// left out as well, in any order; read during the call; default None
    pub ignored_models: List<'a, ModelId>,
    /// must be 0
    pub reserved: u32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct CameraDesc {
    pub struct_size: Size<CameraDesc>,
    /// None: the C++ runtime's
    pub allocator: Hook<Allocator>,
    pub handedness: Handedness,
    pub depth_range: DepthRange,
    /// 1: near has the high depth, for float depth buffers
    pub reverse_z: i32,
    /// pixels, 1e-3 .. 1e6
    pub viewport_width: f32,
    pub viewport_height: f32,
    /// not read: a client of release 1.0 has padding here
    pub reserved: u32,
}

/// Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
/// nothing depends on the frame time or on how often update is called. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Orbit {
    pub target: Vec3,
    /// any non-zero length; pitch is measured against it
    pub up: Vec3,
    /// metres from target, > 0
    pub distance: f32,
    /// radians; yaw 0 looks along the reference direction that is
    /// perpendicular to up (+Z for up = +Y), yaw > 0 to the right of
    /// it; pitch > 0 looks down
    pub yaw: f32,
    /// radians; yaw 0 looks along the reference direction that is
    /// perpendicular to up (+Z for up = +Y), yaw > 0 to the right of
    /// it; pitch > 0 looks down
    pub pitch: f32,
    /// of `Camera::orbit_rotate`
    pub radians_per_unit: f32,
    /// of `Camera::orbit_zoom` and _pan
    pub metres_per_unit: f32,
    /// 0 < min <= max; max INFINITY allowed
    pub min_distance: f32,
    /// 0 < min <= max; max INFINITY allowed
    pub max_distance: f32,
    /// within -pi/2 .. pi/2
    pub min_pitch: f32,
    /// within -pi/2 .. pi/2
    pub max_pitch: f32,
}

/// What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct OrbitSpeeds {
    /// radians a unit, of yaw and pitch
    pub rotate_x: f32,
    /// radians a unit, of yaw and pitch
    pub rotate_y: f32,
    /// metres a unit
    pub zoom: f32,
    /// metres a unit, to the right and up
    pub pan_x: f32,
    /// metres a unit, to the right and up
    pub pan_y: f32,
}

#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct SolverDesc {
    pub struct_size: Size<SolverDesc>,
    /// None: the C++ runtime's
    pub allocator: Hook<Allocator>,
    /// m/s^2; default (0, -9.81, 0)
    pub gravity: Vec3,
    /// of one step, 1 .. 1000; default 8; with error targets: of the first step
    pub substeps: u32,
    /// seconds simulated by each step of `Solver::advance`; 1/60
    pub fixed_step: f32,
    /// most steps of one advance; time beyond is dropped; 8
    pub max_steps: u32,
    /// provides the worker_count threads; None: the solver's own
    pub task_runner: Hook<TaskRunner>,
    /// threads for one step, including the caller's, at most 1024; 0 and 1: that alone
    pub worker_count: u32,
    /// m/s, see `Solver::get_sleeping`; 0: bodies never sleep; default 0
    pub sleep_speed: f32,
    /// of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by
    /// the mean rest length of the body's rigid constraints; default 0.01
    pub sleep_strain: f32,
    /// seconds; default 0.5
    pub sleep_time: f32,
    /// of rigid constraints, see `Solver::get_substeps`; 0: none, for cloth 0.02; default 0
    pub max_strain: f32,
    /// target of positions: metres of error that a second of motion adds; 0: none; default 0
    pub tolerance: f32,
    /// the most that a target may ask for, 1 .. 1000; default 64
    pub max_substeps: u32,
    /// see `SolverSettings`; 0: no bound; default 0
    pub max_work: u32,
}

/// What a solver was created with and may change later. Fields as in `SolverDesc`. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct SolverSettings {
    /// m/s^2
    pub gravity: Vec3,
    /// 1 .. 1000
    pub substeps: u32,
    /// seconds, 1e-6 .. 0.5
    pub fixed_step: f32,
    /// >= 1
    pub max_steps: u32,
    /// m/s, >= 0
    pub sleep_speed: f32,
    /// >= 0
    pub sleep_strain: f32,
    /// seconds, >= 0
    pub sleep_time: f32,
    /// >= 0
    pub max_strain: f32,
    /// m/s, >= 0
    pub tolerance: f32,
    /// 1 .. 1000
    pub max_substeps: u32,
    /// most particles times substeps of a step; 0: no bound. If bodies need more, all take fewer
    /// substeps in proportion, at least one, and cloth at least one for each 25 ms. It bounds
    /// work, not time, so the bits are the same on every machine
    pub max_work: u32,
}

/// Settings shared by all kinds of bodies.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct BodyDesc {
    pub struct_size: Size<BodyDesc>,
    /// kg of the whole body, spread evenly; > 0; default 1
    pub mass: f32,
    /// of each particle for collision, metres, >= 0; default 0.01
    pub radius: f32,
    /// rate in 1/s: velocities decay as exp(-damping t); >= 0; default 0
    pub damping: f32,
    /// Coulomb coefficient against models, >= 0; default 0.5
    pub friction: f32,
    /// speed kept in a bounce, 0 .. 1; default 0
    pub restitution: f32,
    /// of stretch, metres per newton, >= 0; 0 is inextensible; default 0
    pub compliance: f32,
    /// of `CLOTH_BEND` constraints, m/N; default 0.001
    pub bend_compliance: f32,
    /// cloth values; default SHEAR | BEND
    pub cloth_flags: u32,
    /// mask of the models it collides with; 0: none; default all
    pub layers: u32,
    /// of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
    /// friction, or 0: as friction; default 0
    pub static_friction: f32,
    /// 1: its particles collide with one another, see below; default 0
    pub self_collision: u32,
    /// two bodies collide with each other if their masks share a bit; 0: with none; default 0
    pub body_layers: u32,
    /// of `CLOTH_SHEAR` constraints of a grid, m/N, >= 0; 0: as compliance; default 0
    pub shear_compliance: f32,
    /// of each constraint, newtons, >= 0; 0: none breaks; default 0; see `Break`
    pub breaking_force: f32,
    /// of ropes, E I in N m^2, >= 0; 0: they bend freely; default 0; see below
    pub bending_stiffness: f32,
}

/// What all particles of a body share and may change later. Fields as in `BodyDesc`. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct BodySettings {
    /// 1/s, >= 0
    pub damping: f32,
    /// >= 0
    pub friction: f32,
    /// at least friction, or 0: as friction
    pub static_friction: f32,
    /// 0 .. 1
    pub restitution: f32,
    /// of models
    pub layers: u32,
    /// of bodies
    pub body_layers: u32,
    /// 0 or 1; particles nearer than their radii reach when it is set do not collide
    pub self_collision: u32,
}

/// Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct BodyInfo {
    pub kind: BodyKind,
    pub method: SolveMethod,
    pub particle_count: u32,
    pub constraint_count: u32,
    /// of cloth, for drawing
    pub triangle_count: u32,
}

/// The air around a body. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Wind {
    /// of the air, m/s
    pub velocity: Vec3,
    /// kg/m^3, >= 0; 1.2 is air at 20 degrees; 0: none
    pub density: f32,
    /// coefficient C_D, >= 0: a plate across has 1.2, a cylinder 1.2, a sphere 0.5
    pub drag: f32,
    /// coefficient C_L of cloth, >= 0; a plate has as much lift as drag
    pub lift: f32,
}

/// Where an animation wants a particle, and how far from there the particle may be. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct AnimationTarget {
    /// metres
    pub position: Vec3,
    /// of the animated surface, away from the character; any length but 0; not read without
    /// a backstop
    pub normal: Vec3,
    /// metres from position, >= 0; INFINITY: any
    pub max_distance: f32,
    /// metres that the particle may go behind the plane through position across normal, >= 0;
    /// INFINITY: any
    pub backstop: f32,
}

/// A particle that is attached to a model. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Attachment {
    pub particle: u32,
    pub model: ModelId,
    /// in the model's coordinates, as for `Solver::attach`
    pub local_point: Vec3,
}

/// One constraint. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ConstraintInfo {
    pub id: ConstraintId,
    pub particle_a: u32,
    pub particle_b: u32,
    /// metres
    pub rest_length: f32,
    /// metres per newton
    pub compliance: f32,
}

/// The settings of a constraint. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct ConstraintSettings {
    /// metres, >= 0, below 1e-9 as 0; negative, when it is set: the present distance
    pub rest_length: f32,
    /// metres per newton, >= 0; 0 is rigid
    pub compliance: f32,
    /// N s/m, >= 0, of what has compliance; see `Solver::set_constraint_damping`
    pub damping: f32,
}

/// One joint. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct JointInfo {
    pub id: JointId,
    pub body_a: BodyId,
    pub particle_a: u32,
    pub body_b: BodyId,
    pub particle_b: u32,
    /// metres
    pub rest_length: f32,
    /// metres per newton
    pub compliance: f32,
    /// newtons, in the last substep: > 0 pulls them together, < 0 keeps them apart; its
    /// magnitude for a rest length of 0
    pub force: f32,
}

/// A constraint that broke, or that the caller has broken. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Break {
    pub body: BodyId,
    pub constraint: ConstraintId,
    /// its particles before
    pub particle_a: u32,
    /// its particles before
    pub particle_b: u32,
    /// where cloth parted; `NO_PARTICLE`: nowhere, the constraint was removed
    pub torn_particle: u32,
    /// its copy, the last of the body; `NO_PARTICLE`: none
    pub new_particle: u32,
    /// newtons; 0 if the caller broke it
    pub load: f32,
}

/// Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct SolverStats {
    pub particle_count: u32,
    /// pinned or attached
    pub pinned_count: u32,
    pub constraint_count: u32,
    /// particle and model pairs that touched in the last step, 4 a particle at most
    pub contact_count: u32,
    /// largest |length / rest length - 1| of rigid constraints whose rest length is not 0
    pub strain_max: f32,
    /// root mean square of the same
    pub strain_rms: f32,
    /// joules
    pub kinetic_energy: f32,
    /// joules: of gravity, 0 at the solver's origin, of stretch, bending and held volumes
    pub potential_energy: f32,
}

/// A particle that touched a model in the last step. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Contact {
    pub body: BodyId,
    pub particle: u32,
    pub model: ModelId,
    /// the model's
    pub tag: u32,
    /// on the model, world space
    pub point: Vec3,
    /// unit, from the model to the particle
    pub normal: Vec3,
}

/// Two particles of different bodies that touched in the last step. Frozen.  Since 1.1.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct BodyContact {
    pub body_a: BodyId,
    pub particle_a: u32,
    /// above body_a
    pub body_b: BodyId,
    pub particle_b: u32,
    /// unit, from a to b, when they touched last
    pub normal: Vec3,
    /// metres between their surfaces as they are now; below 0: they overlap
    pub distance: f32,
    /// N s along normal, of the whole step: b got it, and a its opposite. The reactions of links and
    /// models are not in it
    pub impulse: f32,
}

/// What bodies gave a model in the last step, by contacts and by attachments. Frozen.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Default)]
pub struct Impulse {
    pub model: ModelId,
    /// the model's
    pub tag: u32,
    /// N s: what to add to the momentum of the model if it is a body of yours
    pub linear: Vec3,
    /// N m s, about the model's position in the world: likewise for its angular momentum
    pub angular: Vec3,
}

// The layouts are those of C, or this does not compile.
#[cfg(target_pointer_width = "64")]
const _: () = {
    assert!(std::mem::size_of::<Allocator>() == 24);
    assert!(std::mem::size_of::<TaskRunner>() == 16);
    assert!(std::mem::size_of::<Vec3>() == 12);
    assert!(std::mem::size_of::<Quat>() == 16);
    assert!(std::mem::size_of::<Mat4>() == 64);
    assert!(std::mem::size_of::<Transform>() == 32);
    assert!(std::mem::size_of::<Ray>() == 28);
    assert!(std::mem::size_of::<Segment>() == 24);
    assert!(std::mem::size_of::<Sphere>() == 16);
    assert!(std::mem::size_of::<Capsule>() == 28);
    assert!(std::mem::size_of::<Aabb>() == 24);
    assert!(std::mem::size_of::<Obb>() == 40);
    assert!(std::mem::size_of::<Plane>() == 16);
    assert!(std::mem::size_of::<Triangle>() == 36);
    assert!(std::mem::size_of::<Frustum>() == 108);
    assert!(std::mem::size_of::<Hit>() == 52);
    assert!(std::mem::size_of::<Nearest>() == 28);
    assert!(std::mem::size_of::<Distance>() == 12);
    assert!(std::mem::size_of::<Penetration>() == 40);
    assert!(std::mem::size_of::<MeshReport>() == 32);
    assert!(std::mem::size_of::<MeshDesc>() == 24);
    assert!(std::mem::size_of::<MeshInfo>() == 20);
    assert!(std::mem::size_of::<OctreeStats>() == 32);
    assert!(std::mem::size_of::<OctreeBox>() == 32);
    assert!(std::mem::size_of::<SceneDesc>() == 40);
    assert!(std::mem::size_of::<ModelDesc>() == 28);
    assert!(std::mem::size_of::<ModelInfo>() == 20);
    assert!(std::mem::size_of::<QueryFilterDesc>() == 32);
    assert!(std::mem::size_of::<CameraDesc>() == 40);
    assert!(std::mem::size_of::<Orbit>() == 60);
    assert!(std::mem::size_of::<OrbitSpeeds>() == 20);
    assert!(std::mem::size_of::<SolverDesc>() == 80);
    assert!(std::mem::size_of::<SolverSettings>() == 52);
    assert!(std::mem::size_of::<BodyDesc>() == 64);
    assert!(std::mem::size_of::<BodySettings>() == 28);
    assert!(std::mem::size_of::<BodyInfo>() == 20);
    assert!(std::mem::size_of::<Wind>() == 24);
    assert!(std::mem::size_of::<AnimationTarget>() == 32);
    assert!(std::mem::size_of::<Attachment>() == 20);
    assert!(std::mem::size_of::<ConstraintInfo>() == 20);
    assert!(std::mem::size_of::<ConstraintSettings>() == 12);
    assert!(std::mem::size_of::<JointInfo>() == 32);
    assert!(std::mem::size_of::<Break>() == 28);
    assert!(std::mem::size_of::<SolverStats>() == 32);
    assert!(std::mem::size_of::<Contact>() == 40);
    assert!(std::mem::size_of::<BodyContact>() == 36);
    assert!(std::mem::size_of::<Impulse>() == 32);
};
#[cfg(target_pointer_width = "32")]
const _: () = {
    assert!(std::mem::size_of::<Allocator>() == 12);
    assert!(std::mem::size_of::<TaskRunner>() == 8);
    assert!(std::mem::size_of::<Vec3>() == 12);
    assert!(std::mem::size_of::<Quat>() == 16);
    assert!(std::mem::size_of::<Mat4>() == 64);
    assert!(std::mem::size_of::<Transform>() == 32);
    assert!(std::mem::size_of::<Ray>() == 28);
    assert!(std::mem::size_of::<Segment>() == 24);
    assert!(std::mem::size_of::<Sphere>() == 16);
    assert!(std::mem::size_of::<Capsule>() == 28);
    assert!(std::mem::size_of::<Aabb>() == 24);
    assert!(std::mem::size_of::<Obb>() == 40);
    assert!(std::mem::size_of::<Plane>() == 16);
    assert!(std::mem::size_of::<Triangle>() == 36);
    assert!(std::mem::size_of::<Frustum>() == 108);
    assert!(std::mem::size_of::<Hit>() == 52);
    assert!(std::mem::size_of::<Nearest>() == 28);
    assert!(std::mem::size_of::<Distance>() == 12);
    assert!(std::mem::size_of::<Penetration>() == 40);
    assert!(std::mem::size_of::<MeshReport>() == 32);
    assert!(std::mem::size_of::<MeshDesc>() == 16);
    assert!(std::mem::size_of::<MeshInfo>() == 20);
    assert!(std::mem::size_of::<OctreeStats>() == 32);
    assert!(std::mem::size_of::<OctreeBox>() == 32);
    assert!(std::mem::size_of::<SceneDesc>() == 24);
    assert!(std::mem::size_of::<ModelDesc>() == 28);
    assert!(std::mem::size_of::<ModelInfo>() == 20);
    assert!(std::mem::size_of::<QueryFilterDesc>() == 28);
    assert!(std::mem::size_of::<CameraDesc>() == 32);
    assert!(std::mem::size_of::<Orbit>() == 60);
    assert!(std::mem::size_of::<OrbitSpeeds>() == 20);
    assert!(std::mem::size_of::<SolverDesc>() == 68);
    assert!(std::mem::size_of::<SolverSettings>() == 52);
    assert!(std::mem::size_of::<BodyDesc>() == 64);
    assert!(std::mem::size_of::<BodySettings>() == 28);
    assert!(std::mem::size_of::<BodyInfo>() == 20);
    assert!(std::mem::size_of::<Wind>() == 24);
    assert!(std::mem::size_of::<AnimationTarget>() == 32);
    assert!(std::mem::size_of::<Attachment>() == 20);
    assert!(std::mem::size_of::<ConstraintInfo>() == 20);
    assert!(std::mem::size_of::<ConstraintSettings>() == 12);
    assert!(std::mem::size_of::<JointInfo>() == 32);
    assert!(std::mem::size_of::<Break>() == 28);
    assert!(std::mem::size_of::<SolverStats>() == 32);
    assert!(std::mem::size_of::<Contact>() == 40);
    assert!(std::mem::size_of::<BodyContact>() == 36);
    assert!(std::mem::size_of::<Impulse>() == 32);
};
#[cfg(all(test, target_pointer_width = "64"))]
#[test]
fn fields_stand_where_c_has_them() {
    let s = std::mem::MaybeUninit::<Allocator>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).allocate) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).release) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).user) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<TaskRunner>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).run) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).user) } as usize - p as usize, 8);
    let s = std::mem::MaybeUninit::<Vec3>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).x) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).y) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).z) } as usize - p as usize, 8);
    let s = std::mem::MaybeUninit::<Quat>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).x) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).y) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).z) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).w) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Mat4>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).m) } as usize - p as usize, 0);
    let s = std::mem::MaybeUninit::<Transform>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).position) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rotation) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).scale) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<Ray>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).origin) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).direction) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).t_max) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<Segment>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).a) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).b) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Sphere>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).center) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).radius) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Capsule>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).a) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).b) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).radius) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<Aabb>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).min) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Obb>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).center) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).half_extents) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rotation) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<Plane>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).distance) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Triangle>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).a) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).b) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).c) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<Frustum>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).origin) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).planes) } as usize - p as usize, 12);
    let s = std::mem::MaybeUninit::<Hit>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).t) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).point) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle) } as usize - p as usize, 36);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).u) } as usize - p as usize, 40);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).v) } as usize - p as usize, 44);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).flags) } as usize - p as usize, 48);
    let s = std::mem::MaybeUninit::<Nearest>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).point) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).distance) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<Distance>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).t) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle) } as usize - p as usize, 8);
    let s = std::mem::MaybeUninit::<Penetration>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).point) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).depth) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle) } as usize - p as usize, 36);
    let s = std::mem::MaybeUninit::<MeshReport>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle_count) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).degenerate_count) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).first_degenerate) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).out_of_range_count) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).first_out_of_range) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).bad_vertex_count) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).first_bad_vertex) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).open_edge_count) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<MeshDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).allocator) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).deformable) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reserved) } as usize - p as usize, 20);
    let s = std::mem::MaybeUninit::<MeshInfo>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).kind) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).vertex_count) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle_count) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).deformable) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).follows_body) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<OctreeStats>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).item_count) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).unbounded_count) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).node_count) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).leaf_count) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).depth) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rebuilds) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).cost) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).memory_bytes) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<OctreeBox>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).bounds) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).depth) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).item_count) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<SceneDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).allocator) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reserve_models) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).task_runner) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).worker_count) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reserved) } as usize - p as usize, 36);
    let s = std::mem::MaybeUninit::<ModelDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).parent) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).layers) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).scale) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<ModelInfo>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).type_) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).parent) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).layers) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).child_count) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<QueryFilterDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).layers) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).ignored_model) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).flags) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).ignored_models) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reserved) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<CameraDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).allocator) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).handedness) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).depth_range) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reverse_z) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).viewport_width) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).viewport_height) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).reserved) } as usize - p as usize, 36);
    let s = std::mem::MaybeUninit::<Orbit>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).target) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).up) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).distance) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).yaw) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).pitch) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).radians_per_unit) } as usize - p as usize, 36);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).metres_per_unit) } as usize - p as usize, 40);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).min_distance) } as usize - p as usize, 44);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_distance) } as usize - p as usize, 48);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).min_pitch) } as usize - p as usize, 52);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_pitch) } as usize - p as usize, 56);
    let s = std::mem::MaybeUninit::<OrbitSpeeds>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rotate_x) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rotate_y) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).zoom) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).pan_x) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).pan_y) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<SolverDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).allocator) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).gravity) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).substeps) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).fixed_step) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_steps) } as usize - p as usize, 36);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).task_runner) } as usize - p as usize, 40);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).worker_count) } as usize - p as usize, 48);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_speed) } as usize - p as usize, 52);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_strain) } as usize - p as usize, 56);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_time) } as usize - p as usize, 60);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_strain) } as usize - p as usize, 64);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tolerance) } as usize - p as usize, 68);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_substeps) } as usize - p as usize, 72);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_work) } as usize - p as usize, 76);
    let s = std::mem::MaybeUninit::<SolverSettings>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).gravity) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).substeps) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).fixed_step) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_steps) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_speed) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_strain) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).sleep_time) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_strain) } as usize - p as usize, 36);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tolerance) } as usize - p as usize, 40);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_substeps) } as usize - p as usize, 44);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_work) } as usize - p as usize, 48);
    let s = std::mem::MaybeUninit::<BodyDesc>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).struct_size) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).mass) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).radius) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).damping) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).friction) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).restitution) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).compliance) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).bend_compliance) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).cloth_flags) } as usize - p as usize, 32);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).layers) } as usize - p as usize, 36);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).static_friction) } as usize - p as usize, 40);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).self_collision) } as usize - p as usize, 44);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_layers) } as usize - p as usize, 48);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).shear_compliance) } as usize - p as usize, 52);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).breaking_force) } as usize - p as usize, 56);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).bending_stiffness) } as usize - p as usize, 60);
    let s = std::mem::MaybeUninit::<BodySettings>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).damping) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).friction) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).static_friction) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).restitution) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).layers) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_layers) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).self_collision) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<BodyInfo>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).kind) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).method) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_count) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).constraint_count) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).triangle_count) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<Wind>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).velocity) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).density) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).drag) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).lift) } as usize - p as usize, 20);
    let s = std::mem::MaybeUninit::<AnimationTarget>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).position) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).max_distance) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).backstop) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<Attachment>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).local_point) } as usize - p as usize, 8);
    let s = std::mem::MaybeUninit::<ConstraintInfo>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).id) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_a) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_b) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rest_length) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).compliance) } as usize - p as usize, 16);
    let s = std::mem::MaybeUninit::<ConstraintSettings>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rest_length) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).compliance) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).damping) } as usize - p as usize, 8);
    let s = std::mem::MaybeUninit::<JointInfo>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).id) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_a) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_a) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_b) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_b) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).rest_length) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).compliance) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).force) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<Break>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).constraint) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_a) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_b) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).torn_particle) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).new_particle) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).load) } as usize - p as usize, 24);
    let s = std::mem::MaybeUninit::<SolverStats>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_count) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).pinned_count) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).constraint_count) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).contact_count) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).strain_max) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).strain_rms) } as usize - p as usize, 20);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).kinetic_energy) } as usize - p as usize, 24);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).potential_energy) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<Contact>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).point) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 28);
    let s = std::mem::MaybeUninit::<BodyContact>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_a) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_a) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).body_b) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).particle_b) } as usize - p as usize, 12);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).normal) } as usize - p as usize, 16);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).distance) } as usize - p as usize, 28);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).impulse) } as usize - p as usize, 32);
    let s = std::mem::MaybeUninit::<Impulse>::uninit();
    let p = s.as_ptr();
    assert_eq!(unsafe { std::ptr::addr_of!((*p).model) } as usize - p as usize, 0);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).tag) } as usize - p as usize, 4);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).linear) } as usize - p as usize, 8);
    assert_eq!(unsafe { std::ptr::addr_of!((*p).angular) } as usize - p as usize, 20);
}
