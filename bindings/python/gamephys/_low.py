"""Generated from gamephys_api.json by bindings/generate.py. Not for editing."""

from __future__ import annotations

from ctypes import POINTER, Array, Structure, c_char_p, c_float, c_int32, c_size_t, c_uint32, c_void_p
from struct import Struct
from typing import Any, Sequence

from numpy import dtype
from numpy.typing import NDArray

from ._library import function, needs
from ._runtime import shape_types
from ._values import NOT_NUMBERS, Built, Desc, Field, List, Value, Vector, VectorLike, struct

OK = 0
NO_HIT = 1  # the query found nothing; outputs untouched
INCOMPLETE = 2  # more results than the caller's array holds
UNBOUNDED = 3  # the answer is infinite (bounds of a plane); outputs untouched
ERROR_INVALID_ARGUMENT = -1  # null, NaN, infinite, out of range, wrong stride, ...
ERROR_INVALID_ID = -2  # no such model, body, constraint or joint, or no longer
ERROR_STRUCT_SIZE = -3  # a desc not initialised, or newer than this library
ERROR_OUT_OF_MEMORY = -4
ERROR_CAPACITY = -5  # more than a limit, 2^24 - 1 unless the function says another
ERROR_CYCLE = -6  # a model would become its own ancestor
ERROR_UNSUPPORTED = -7  # the operation has no meaning for this kind of shape
ERROR_SINGULAR = -8  # a matrix without an inverse
ERROR_INTERNAL = -100  # a defect of the library; please report it

FRUSTUM_NEAR = 0
FRUSTUM_FAR = 1
FRUSTUM_LEFT = 2
FRUSTUM_RIGHT = 3
FRUSTUM_BOTTOM = 4
FRUSTUM_TOP = 5

HIT_INSIDE = 1  # the ray or the swept sphere started inside or touching: t is 0
HIT_BACK = 2  # a surface was met from behind its normal

SHAPE_SPHERE = 1  # Sphere
SHAPE_CAPSULE = 2  # Capsule
SHAPE_AABB = 3  # Aabb
SHAPE_OBB = 4  # Obb
SHAPE_PLANE = 5  # Plane
SHAPE_TRIANGLE = 6  # Triangle
SHAPE_FRUSTUM = 7  # Frustum
SHAPE_MESH = 8  # Mesh: the handle itself; a convex hull too
SHAPE_RAY = 16  # Ray
SHAPE_SEGMENT = 17  # Segment

SIDE_OUTSIDE = -1  # wholly behind the plane, wholly outside the frustum
SIDE_CROSSING = 0  # touches or crosses the boundary
SIDE_INSIDE = 1  # wholly in front of the plane, wholly inside the frustum

DEPTH_ZERO_TO_ONE = 0  # DirectX, Vulkan, Metal, WebGPU
DEPTH_MINUS_ONE_TO_ONE = 1  # OpenGL, WebGL

MESH_SURFACE = 0  # triangles
MESH_BODY_SURFACE = 1  # the triangles of a cloth: Mesh
MESH_BODY_LINKS = 2  # the links and particles of a rope, or free particles: likewise
MESH_HULL = 3  # a solid: Mesh

FILTER_SUBTREE = 1  # ignored_model stands for its descendants, too
FILTER_NO_BACK_FACES = 2  # planes, triangles and meshes that are not solid are not hit from behind: by rays with HIT_BACK, or by sweeps along their normal; other queries have no direction and ignore this flag and the next
FILTER_NO_FRONT_FACES = 4  # they are met from behind only: the inside of a closed mesh

PROJECTION_PERSPECTIVE = 0
PROJECTION_ORTHOGRAPHIC = 1
PROJECTION_USER = 2

LEFT_HANDED = 0  # looks along its own +Z
RIGHT_HANDED = 1  # looks along its own -Z

PICK_FROM_NEAR_PLANE = 0  # what is drawn can be picked; nothing between camera and near plane
PICK_FROM_CENTRE = 1  # at the camera's position: what is between it and the near plane, too

CLOTH_SHEAR = 1  # constraints along both diagonals of each grid cell: stiff like paper
CLOTH_BEND = 2  # constraints that resist folding

BODY_PARTICLES = 1
BODY_ROPE = 2
BODY_CLOTH = 3

SOLVE_FREE = 0  # no constraints: exact flight
SOLVE_DIRECT = 1  # chains and trees: Newton on the whole body at once
SOLVE_GRAPH = 2  # cycles of constraints, volume, clusters, or a particle with more than 64 constraints: coloured batches of chains, then the rest, then reach limits

CONSTRAINT_DISTANCE = 0  # its length: Solver.add_distance, and those created with a body
CONSTRAINT_MAX_DISTANCE = 1  # at most its length; it may go slack: Solver.add_max_distance

VERSION_MAJOR = 1
VERSION_MINOR = 1
VERSION_PATCH = 0
MAX_COORDINATE = 1e15
NO_TRIANGLE = 0xffffffff
NO_PARTICLE = 0xffffffff
ALL_LAYERS = 0xffffffff

needs(VERSION_MAJOR, VERSION_MINOR)

_pack_3 = Struct("3f").pack_into
_pack_4 = Struct("4f").pack_into
_pack_6 = Struct("6f").pack_into
_pack_7 = Struct("7f").pack_into
_pack_8 = Struct("8f").pack_into
_pack_9 = Struct("9f").pack_into
_pack_10 = Struct("10f").pack_into


@struct
class Vec3(Vector, Array[c_float]):
    """Vec3: x, y, z."""

    __slots__ = ()
    x: float
    y: float
    z: float
    _type_ = c_float
    _length_ = 3

    def __init__(self, x: float = 0, y: float = 0, z: float = 0) -> None:
        try:
            _pack_3(self, 0, x, y, z)
        except NOT_NUMBERS:
            self._set(x=x, y=y, z=z)


vec3_dtype: dtype[Any] = dtype(("<f4", (3,)))
Vec3.dtype = vec3_dtype


@struct
class Quat(Vector, Array[c_float]):
    """Quat: x, y, z, w.

    Fields:
        x: rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
        y: rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
        z: rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))
        w: rotation of angle a about unit axis n: (n sin(a/2), cos(a/2))"""

    __slots__ = ()
    x: float
    y: float
    z: float
    w: float
    _type_ = c_float
    _length_ = 4

    def __init__(self, x: float = 0, y: float = 0, z: float = 0, w: float = 1) -> None:
        try:
            _pack_4(self, 0, x, y, z, w)
        except NOT_NUMBERS:
            self._set(x=x, y=y, z=z, w=w)


quat_dtype: dtype[Any] = dtype(("<f4", (4,)))
Quat.dtype = quat_dtype


@struct
class Mat4(Value, Structure):
    """Mat4: m.

    Fields:
        m: element (row, column) is m[4 * column + row]"""

    __slots__ = ()
    m: Any
    _fields_ = [("m", c_float * 16)]


mat4_dtype: dtype[Any] = dtype(("<f4", (16,)))
Mat4.dtype = mat4_dtype


@struct
class Transform(Built, Structure):
    """x -> position + rotation * (scale * x); scale > 0."""

    __slots__ = ()
    position: Field[Vec3]
    rotation: Field[Quat]
    scale: float
    _fields_ = [("position", Vec3), ("rotation", Quat), ("scale", c_float)]

    def __init__(self, position: VectorLike = (0, 0, 0), rotation: VectorLike = (0, 0, 0, 1), scale: float = 1) -> None:
        try:
            position_x, position_y, position_z = position
            rotation_x, rotation_y, rotation_z, rotation_w = rotation
            _pack_8(self, 0, position_x, position_y, position_z, rotation_x, rotation_y, rotation_z, rotation_w, scale)
        except NOT_NUMBERS:
            self._set(position=position, rotation=rotation, scale=scale)


transform_dtype: dtype[Any] = dtype([("position", "<f4", (3,)), ("rotation", "<f4", (4,)), ("scale", "<f4")])
Transform.dtype = transform_dtype


@struct
class Ray(Built, Structure):
    """Ray: origin, direction, t_max.

    Fields:
        direction: any non-zero length
        t_max: >= 0, in multiples of direction; INFINITY allowed"""

    __slots__ = ()
    origin: Field[Vec3]
    direction: Field[Vec3]
    t_max: float
    _fields_ = [("origin", Vec3), ("direction", Vec3), ("t_max", c_float)]

    def __init__(self, origin: VectorLike = (0, 0, 0), direction: VectorLike = (0, 0, 0), t_max: float = float("inf")) -> None:
        try:
            origin_x, origin_y, origin_z = origin
            direction_x, direction_y, direction_z = direction
            _pack_7(self, 0, origin_x, origin_y, origin_z, direction_x, direction_y, direction_z, t_max)
        except NOT_NUMBERS:
            self._set(origin=origin, direction=direction, t_max=t_max)


ray_dtype: dtype[Any] = dtype([("origin", "<f4", (3,)), ("direction", "<f4", (3,)), ("t_max", "<f4")])
Ray.dtype = ray_dtype


@struct
class Segment(Built, Structure):
    """Segment: a, b.

    Fields:
        a: may coincide: a point
        b: may coincide: a point"""

    __slots__ = ()
    a: Field[Vec3]
    b: Field[Vec3]
    _fields_ = [("a", Vec3), ("b", Vec3)]

    def __init__(self, a: VectorLike = (0, 0, 0), b: VectorLike = (0, 0, 0)) -> None:
        try:
            a_x, a_y, a_z = a
            b_x, b_y, b_z = b
            _pack_6(self, 0, a_x, a_y, a_z, b_x, b_y, b_z)
        except NOT_NUMBERS:
            self._set(a=a, b=b)


segment_dtype: dtype[Any] = dtype([("a", "<f4", (3,)), ("b", "<f4", (3,))])
Segment.dtype = segment_dtype


@struct
class Sphere(Built, Structure):
    """Sphere: center, radius.

    Fields:
        radius: >= 0"""

    __slots__ = ()
    center: Field[Vec3]
    radius: float
    _fields_ = [("center", Vec3), ("radius", c_float)]

    def __init__(self, center: VectorLike = (0, 0, 0), radius: float = 0) -> None:
        try:
            center_x, center_y, center_z = center
            _pack_4(self, 0, center_x, center_y, center_z, radius)
        except NOT_NUMBERS:
            self._set(center=center, radius=radius)


sphere_dtype: dtype[Any] = dtype([("center", "<f4", (3,)), ("radius", "<f4")])
Sphere.dtype = sphere_dtype


@struct
class Capsule(Built, Structure):
    """All points within radius of the segment a b.

    Fields:
        a: may coincide: a sphere
        b: may coincide: a sphere
        radius: >= 0"""

    __slots__ = ()
    a: Field[Vec3]
    b: Field[Vec3]
    radius: float
    _fields_ = [("a", Vec3), ("b", Vec3), ("radius", c_float)]

    def __init__(self, a: VectorLike = (0, 0, 0), b: VectorLike = (0, 0, 0), radius: float = 0) -> None:
        try:
            a_x, a_y, a_z = a
            b_x, b_y, b_z = b
            _pack_7(self, 0, a_x, a_y, a_z, b_x, b_y, b_z, radius)
        except NOT_NUMBERS:
            self._set(a=a, b=b, radius=radius)


capsule_dtype: dtype[Any] = dtype([("a", "<f4", (3,)), ("b", "<f4", (3,)), ("radius", "<f4")])
Capsule.dtype = capsule_dtype


@struct
class Aabb(Built, Structure):
    """Aabb: min, max.

    Fields:
        min: min <= max on each axis; equality gives a flat box
        max: min <= max on each axis; equality gives a flat box"""

    __slots__ = ()
    min: Field[Vec3]
    max: Field[Vec3]
    _fields_ = [("min", Vec3), ("max", Vec3)]

    def __init__(self, min: VectorLike = (0, 0, 0), max: VectorLike = (0, 0, 0)) -> None:
        try:
            min_x, min_y, min_z = min
            max_x, max_y, max_z = max
            _pack_6(self, 0, min_x, min_y, min_z, max_x, max_y, max_z)
        except NOT_NUMBERS:
            self._set(min=min, max=max)


aabb_dtype: dtype[Any] = dtype([("min", "<f4", (3,)), ("max", "<f4", (3,))])
Aabb.dtype = aabb_dtype


@struct
class Obb(Built, Structure):
    """Obb: center, half_extents, rotation.

    Fields:
        half_extents: >= 0, along the axes of rotation"""

    __slots__ = ()
    center: Field[Vec3]
    half_extents: Field[Vec3]
    rotation: Field[Quat]
    _fields_ = [("center", Vec3), ("half_extents", Vec3), ("rotation", Quat)]

    def __init__(self, center: VectorLike = (0, 0, 0), half_extents: VectorLike = (0, 0, 0), rotation: VectorLike = (0, 0, 0, 1)) -> None:
        try:
            center_x, center_y, center_z = center
            half_extents_x, half_extents_y, half_extents_z = half_extents
            rotation_x, rotation_y, rotation_z, rotation_w = rotation
            _pack_10(self, 0, center_x, center_y, center_z, half_extents_x, half_extents_y, half_extents_z, rotation_x, rotation_y, rotation_z, rotation_w)
        except NOT_NUMBERS:
            self._set(center=center, half_extents=half_extents, rotation=rotation)


obb_dtype: dtype[Any] = dtype([("center", "<f4", (3,)), ("half_extents", "<f4", (3,)), ("rotation", "<f4", (4,))])
Obb.dtype = obb_dtype


@struct
class Plane(Built, Structure):
    """The points x with dot(normal, x) = distance. The normal points to the front; it need not be
    exactly unit: signed distances are divided by its length (for a unit normal, distance is the
    plane's distance from the origin). distance divided by that length is within the range of
    coordinates too.

    Fields:
        normal: not zero"""

    __slots__ = ()
    normal: Field[Vec3]
    distance: float
    _fields_ = [("normal", Vec3), ("distance", c_float)]

    def __init__(self, normal: VectorLike = (0, 0, 0), distance: float = 0) -> None:
        try:
            normal_x, normal_y, normal_z = normal
            _pack_4(self, 0, normal_x, normal_y, normal_z, distance)
        except NOT_NUMBERS:
            self._set(normal=normal, distance=distance)


plane_dtype: dtype[Any] = dtype([("normal", "<f4", (3,)), ("distance", "<f4")])
Plane.dtype = plane_dtype


@struct
class Triangle(Built, Structure):
    """May be degenerate: then it is the segment or point that its corners span. The normal is that
    of cross(b - a, c - a)."""

    __slots__ = ()
    a: Field[Vec3]
    b: Field[Vec3]
    c: Field[Vec3]
    _fields_ = [("a", Vec3), ("b", Vec3), ("c", Vec3)]

    def __init__(self, a: VectorLike = (0, 0, 0), b: VectorLike = (0, 0, 0), c: VectorLike = (0, 0, 0)) -> None:
        try:
            a_x, a_y, a_z = a
            b_x, b_y, b_z = b
            c_x, c_y, c_z = c
            _pack_9(self, 0, a_x, a_y, a_z, b_x, b_y, b_z, c_x, c_y, c_z)
        except NOT_NUMBERS:
            self._set(a=a, b=b, c=c)


triangle_dtype: dtype[Any] = dtype([("a", "<f4", (3,)), ("b", "<f4", (3,)), ("c", "<f4", (3,))])
Triangle.dtype = triangle_dtype


@struct
class Frustum(Value, Structure):
    """The points x with dot(planes[i].normal, x - origin) >= planes[i].distance for all six planes,
    which look inward, in the order of FRUSTUM_NEAR, FAR and so on. Distances count from origin, so that a
    frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1."""

    __slots__ = ()
    origin: Field[Vec3]
    planes: Any
    _fields_ = [("origin", Vec3), ("planes", Plane * 6)]


frustum_dtype: dtype[Any] = dtype([("origin", "<f4", (3,)), ("planes", plane_dtype, (6,))])
Frustum.dtype = frustum_dtype


@struct
class Hit(Value, Structure):
    """Where a ray, segment or swept sphere first meets something.

    Fields:
        model: id of the model, 0 when the query was not of a scene
        tag: the model's tag, 0 likewise
        t: 0 .. t_max; along a segment or sweep 0 .. 1
        point: where the surfaces meet
        normal: unit, against the motion: dot(normal, direction) <= 0, for rays up to rounding
        triangle: index within a mesh, else NO_TRIANGLE
        u: barycentric weights of b and c of a triangle, else 0
        v: barycentric weights of b and c of a triangle, else 0
        flags: hit values"""

    __slots__ = ()
    model: int
    tag: int
    t: float
    point: Field[Vec3]
    normal: Field[Vec3]
    triangle: int
    u: float
    v: float
    flags: int
    _fields_ = [("model", c_uint32), ("tag", c_uint32), ("t", c_float), ("point", Vec3), ("normal", Vec3), ("triangle", c_uint32), ("u", c_float), ("v", c_float), ("flags", c_uint32)]


hit_dtype: dtype[Any] = dtype([("model", "<u4"), ("tag", "<u4"), ("t", "<f4"), ("point", "<f4", (3,)), ("normal", "<f4", (3,)), ("triangle", "<u4"), ("u", "<f4"), ("v", "<f4"), ("flags", "<u4")])
Hit.dtype = hit_dtype


@struct
class Nearest(Value, Structure):
    """The closest point of something to a given point.

    Fields:
        model: as in Hit
        point: equal to the query point when that is inside a solid
        distance: 0 inside a solid
        triangle: index within a mesh, else NO_TRIANGLE"""

    __slots__ = ()
    model: int
    tag: int
    point: Field[Vec3]
    distance: float
    triangle: int
    _fields_ = [("model", c_uint32), ("tag", c_uint32), ("point", Vec3), ("distance", c_float), ("triangle", c_uint32)]


nearest_dtype: dtype[Any] = dtype([("model", "<u4"), ("tag", "<u4"), ("point", "<f4", (3,)), ("distance", "<f4"), ("triangle", "<u4")])
Nearest.dtype = nearest_dtype


@struct
class Distance(Value, Structure):
    """How far a ray goes and what it hits: fields of a Hit. Frozen.  Since 1.1.

    Fields:
        t: in multiples of the direction, so metres where its length is 1; INFINITY: nothing is hit
        model: as in Hit"""

    __slots__ = ()
    t: float
    model: int
    triangle: int
    _fields_ = [("t", c_float), ("model", c_uint32), ("triangle", c_uint32)]


distance_dtype: dtype[Any] = dtype([("t", "<f4"), ("model", "<u4"), ("triangle", "<u4")])
Distance.dtype = distance_dtype


@struct
class Penetration(Value, Structure):
    """How a solid gets out of something that it overlaps.

    Fields:
        model: as in Hit
        point: on what is overlapped: where the two touch when the solid has gone depth along normal
        normal: unit: the way out, from what is overlapped to the solid
        depth: metres along normal; 0 for shapes that touch
        triangle: index within a mesh, else NO_TRIANGLE"""

    __slots__ = ()
    model: int
    tag: int
    point: Field[Vec3]
    normal: Field[Vec3]
    depth: float
    triangle: int
    _fields_ = [("model", c_uint32), ("tag", c_uint32), ("point", Vec3), ("normal", Vec3), ("depth", c_float), ("triangle", c_uint32)]


penetration_dtype: dtype[Any] = dtype([("model", "<u4"), ("tag", "<u4"), ("point", "<f4", (3,)), ("normal", "<f4", (3,)), ("depth", "<f4"), ("triangle", "<u4")])
Penetration.dtype = penetration_dtype


@struct
class MeshReport(Value, Structure):
    """What is in a triangle array. Frozen.

    Fields:
        degenerate_count: triangles of exactly zero area
        first_degenerate: index of the first, or NO_TRIANGLE
        out_of_range_count: triangles with an index >= vertex_count
        bad_vertex_count: vertices that are not finite or beyond MAX_COORDINATE
        first_bad_vertex: or 0xffffffff
        open_edge_count: edges that do not join exactly two triangles; 0 for a closed mesh"""

    __slots__ = ()
    triangle_count: int
    degenerate_count: int
    first_degenerate: int
    out_of_range_count: int
    first_out_of_range: int
    bad_vertex_count: int
    first_bad_vertex: int
    open_edge_count: int
    _fields_ = [("triangle_count", c_uint32), ("degenerate_count", c_uint32), ("first_degenerate", c_uint32), ("out_of_range_count", c_uint32), ("first_out_of_range", c_uint32), ("bad_vertex_count", c_uint32), ("first_bad_vertex", c_uint32), ("open_edge_count", c_uint32)]


mesh_report_dtype: dtype[Any] = dtype([("triangle_count", "<u4"), ("degenerate_count", "<u4"), ("first_degenerate", "<u4"), ("out_of_range_count", "<u4"), ("first_out_of_range", "<u4"), ("bad_vertex_count", "<u4"), ("first_bad_vertex", "<u4"), ("open_edge_count", "<u4")])
MeshReport.dtype = mesh_report_dtype


@struct
class MeshDesc(Desc, Structure):
    """MeshDesc: allocator, deformable.

    Fields:
        allocator: None: the C++ runtime's
        deformable: 1: Mesh.set_vertices will be called; 12 bytes a vertex more. Since 1.1"""

    __slots__ = ()
    struct_size: int
    allocator: int | None
    deformable: int
    reserved: int
    _fields_ = [("struct_size", c_uint32), ("allocator", c_void_p), ("deformable", c_int32), ("reserved", c_uint32)]

    def __init__(self, *, allocator: int | None = None, deformable: bool | None = None) -> None:
        self._start()
        if allocator is not None:
            self.allocator = allocator
        if deformable is not None:
            self.deformable = deformable


mesh_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("allocator", "P"), ("deformable", "<i4"), ("reserved", "<u4")], align=True)
MeshDesc.dtype = mesh_desc_dtype


@struct
class MeshInfo(Value, Structure):
    """What a mesh is. Frozen.  Since 1.1.

    Fields:
        deformable: 1: as MeshDesc.deformable, or in the form of a body
        follows_body: 1: its form comes from a body, not from Mesh.set_vertices"""

    __slots__ = ()
    kind: int
    vertex_count: int
    triangle_count: int
    deformable: int
    follows_body: int
    _fields_ = [("kind", c_int32), ("vertex_count", c_uint32), ("triangle_count", c_uint32), ("deformable", c_int32), ("follows_body", c_int32)]


mesh_info_dtype: dtype[Any] = dtype([("kind", "<i4"), ("vertex_count", "<u4"), ("triangle_count", "<u4"), ("deformable", "<i4"), ("follows_body", "<i4")])
MeshInfo.dtype = mesh_info_dtype


@struct
class OctreeStats(Value, Structure):
    """How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
    eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen.

    Fields:
        item_count: models or triangles in the tree
        unbounded_count: models of infinite extent, kept beside the tree
        depth: levels; 0 when empty
        rebuilds: times it was rebuilt as a whole by one call since creation
        cost: expected node and item tests of a random ray that meets the root box
        memory_bytes: of the tree; saturates at 2^32 - 1"""

    __slots__ = ()
    item_count: int
    unbounded_count: int
    node_count: int
    leaf_count: int
    depth: int
    rebuilds: int
    cost: float
    memory_bytes: int
    _fields_ = [("item_count", c_uint32), ("unbounded_count", c_uint32), ("node_count", c_uint32), ("leaf_count", c_uint32), ("depth", c_uint32), ("rebuilds", c_uint32), ("cost", c_float), ("memory_bytes", c_uint32)]


octree_stats_dtype: dtype[Any] = dtype([("item_count", "<u4"), ("unbounded_count", "<u4"), ("node_count", "<u4"), ("leaf_count", "<u4"), ("depth", "<u4"), ("rebuilds", "<u4"), ("cost", "<f4"), ("memory_bytes", "<u4")])
OctreeStats.dtype = octree_stats_dtype


@struct
class OctreeBox(Value, Structure):
    """One box of an octree, for drawing. Frozen.

    Fields:
        depth: 0 is the root
        item_count: 0 for an inner node"""

    __slots__ = ()
    bounds: Aabb
    depth: int
    item_count: int
    _fields_ = [("bounds", Aabb), ("depth", c_uint32), ("item_count", c_uint32)]


octree_box_dtype: dtype[Any] = dtype([("bounds", aabb_dtype), ("depth", "<u4"), ("item_count", "<u4")])
OctreeBox.dtype = octree_box_dtype


@struct
class SceneDesc(Desc, Structure):
    """SceneDesc: allocator, reserve_models, task_runner, worker_count.

    Fields:
        allocator: None: the C++ runtime's
        reserve_models: models to make room for at once; 0
        task_runner: provides the worker_count threads; None: the scene's own
        worker_count: threads for one call, including the caller's, at most 1024; 0 and 1: that alone"""

    __slots__ = ()
    struct_size: int
    allocator: int | None
    reserve_models: int
    task_runner: int | None
    worker_count: int
    reserved: int
    _fields_ = [("struct_size", c_uint32), ("allocator", c_void_p), ("reserve_models", c_uint32), ("task_runner", c_void_p), ("worker_count", c_uint32), ("reserved", c_uint32)]

    def __init__(self, *, allocator: int | None = None, reserve_models: int | None = None, task_runner: int | None = None, worker_count: int | None = None) -> None:
        self._start()
        if allocator is not None:
            self.allocator = allocator
        if reserve_models is not None:
            self.reserve_models = reserve_models
        if task_runner is not None:
            self.task_runner = task_runner
        if worker_count is not None:
            self.worker_count = worker_count


scene_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("allocator", "P"), ("reserve_models", "<u4"), ("task_runner", "P"), ("worker_count", "<u4"), ("reserved", "<u4")], align=True)
SceneDesc.dtype = scene_desc_dtype


@struct
class ModelDesc(Desc, Structure):
    """ModelDesc: parent, layers, tag, scale.

    Fields:
        parent: 0: none
        layers: a query with mask m sees the model if layers & m; default 1
        tag: any number of the caller's, returned with each hit; 0
        scale: as Scene.set_scale sets it; 1 1 1, and 0 0 0 is the same. Since 1.1"""

    __slots__ = ()
    struct_size: int
    parent: int
    layers: int
    tag: int
    scale: Field[Vec3]
    _fields_ = [("struct_size", c_uint32), ("parent", c_uint32), ("layers", c_uint32), ("tag", c_uint32), ("scale", Vec3)]

    def __init__(self, *, parent: int | None = None, layers: int | None = None, tag: int | None = None, scale: VectorLike | None = None) -> None:
        self._start()
        if parent is not None:
            self.parent = parent
        if layers is not None:
            self.layers = layers
        if tag is not None:
            self.tag = tag
        if scale is not None:
            self.scale = scale


model_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("parent", "<u4"), ("layers", "<u4"), ("tag", "<u4"), ("scale", "<f4", (3,))])
ModelDesc.dtype = model_desc_dtype


@struct
class ModelInfo(Value, Structure):
    """What a model is. Frozen.

    Fields:
        parent: 0: none
        child_count: direct children"""

    __slots__ = ()
    type: int
    parent: int
    layers: int
    tag: int
    child_count: int
    _fields_ = [("type", c_int32), ("parent", c_uint32), ("layers", c_uint32), ("tag", c_uint32), ("child_count", c_uint32)]


model_info_dtype: dtype[Any] = dtype([("type", "<i4"), ("parent", "<u4"), ("layers", "<u4"), ("tag", "<u4"), ("child_count", "<u4")])
ModelInfo.dtype = model_info_dtype


@struct
class QueryFilterDesc(Desc, Structure):
    """Which models a query sees. Ids that name no model leave out nothing and are not an error: the
    model that asked may have been removed since.

    Fields:
        layers: a model is seen if its own mask shares a bit; default ALL_LAYERS
        ignored_model: left out; 0: none; default 0
        flags: filter values; default 0
        ignored_models: left out as well, in any order; read during the call; default None"""

    __slots__ = ("_ignored_models",)
    _lists = {"ignored_models": "ignored_count"}
    struct_size: int
    layers: int
    ignored_model: int
    flags: int
    ignored_models: List
    ignored_count: int
    reserved: int
    _fields_ = [("struct_size", c_uint32), ("layers", c_uint32), ("ignored_model", c_uint32), ("flags", c_uint32), ("ignored_models", c_void_p), ("ignored_count", c_uint32), ("reserved", c_uint32)]

    def __init__(self, *, layers: int | None = None, ignored_model: int | None = None, flags: int | None = None, ignored_models: Sequence[int] | NDArray[Any] | None = None) -> None:
        self._start()
        if layers is not None:
            self.layers = layers
        if ignored_model is not None:
            self.ignored_model = ignored_model
        if flags is not None:
            self.flags = flags
        if ignored_models is not None:
            self.ignored_models = ignored_models


query_filter_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("layers", "<u4"), ("ignored_model", "<u4"), ("flags", "<u4"), ("ignored_models", "P"), ("ignored_count", "<u4"), ("reserved", "<u4")], align=True)
QueryFilterDesc.dtype = query_filter_desc_dtype


@struct
class CameraDesc(Desc, Structure):
    """CameraDesc: allocator, handedness, depth_range, reverse_z, viewport_width, viewport_height.

    Fields:
        allocator: None: the C++ runtime's
        reverse_z: 1: near has the high depth, for float depth buffers
        viewport_width: pixels, 1e-3 .. 1e6"""

    __slots__ = ()
    struct_size: int
    allocator: int | None
    handedness: int
    depth_range: int
    reverse_z: int
    viewport_width: float
    viewport_height: float
    reserved: int
    _fields_ = [("struct_size", c_uint32), ("allocator", c_void_p), ("handedness", c_int32), ("depth_range", c_int32), ("reverse_z", c_int32), ("viewport_width", c_float), ("viewport_height", c_float), ("reserved", c_uint32)]

    def __init__(self, *, allocator: int | None = None, handedness: int | None = None, depth_range: int | None = None, reverse_z: bool | None = None, viewport_width: float | None = None, viewport_height: float | None = None) -> None:
        self._start()
        if allocator is not None:
            self.allocator = allocator
        if handedness is not None:
            self.handedness = handedness
        if depth_range is not None:
            self.depth_range = depth_range
        if reverse_z is not None:
            self.reverse_z = reverse_z
        if viewport_width is not None:
            self.viewport_width = viewport_width
        if viewport_height is not None:
            self.viewport_height = viewport_height


camera_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("allocator", "P"), ("handedness", "<i4"), ("depth_range", "<i4"), ("reverse_z", "<i4"), ("viewport_width", "<f4"), ("viewport_height", "<f4"), ("reserved", "<u4")], align=True)
CameraDesc.dtype = camera_desc_dtype


@struct
class Orbit(Value, Structure):
    """Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
    nothing depends on the frame time or on how often update is called. Frozen.

    Fields:
        up: any non-zero length; pitch is measured against it
        distance: metres from target, > 0
        yaw: radians; yaw 0 looks along the reference direction that is perpendicular to up (+Z for up = +Y), yaw
            > 0 to the right of it; pitch > 0 looks down
        pitch: radians; yaw 0 looks along the reference direction that is perpendicular to up (+Z for up = +Y),
            yaw > 0 to the right of it; pitch > 0 looks down
        radians_per_unit: of Camera.orbit_rotate
        metres_per_unit: of Camera.orbit_zoom and _pan
        min_distance: 0 < min <= max; max INFINITY allowed
        max_distance: 0 < min <= max; max INFINITY allowed
        min_pitch: within -pi/2 .. pi/2
        max_pitch: within -pi/2 .. pi/2"""

    __slots__ = ()
    target: Field[Vec3]
    up: Field[Vec3]
    distance: float
    yaw: float
    pitch: float
    radians_per_unit: float
    metres_per_unit: float
    min_distance: float
    max_distance: float
    min_pitch: float
    max_pitch: float
    _fields_ = [("target", Vec3), ("up", Vec3), ("distance", c_float), ("yaw", c_float), ("pitch", c_float), ("radians_per_unit", c_float), ("metres_per_unit", c_float), ("min_distance", c_float), ("max_distance", c_float), ("min_pitch", c_float), ("max_pitch", c_float)]


orbit_dtype: dtype[Any] = dtype([("target", "<f4", (3,)), ("up", "<f4", (3,)), ("distance", "<f4"), ("yaw", "<f4"), ("pitch", "<f4"), ("radians_per_unit", "<f4"), ("metres_per_unit", "<f4"), ("min_distance", "<f4"), ("max_distance", "<f4"), ("min_pitch", "<f4"), ("max_pitch", "<f4")])
Orbit.dtype = orbit_dtype


@struct
class OrbitSpeeds(Value, Structure):
    """What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1.

    Fields:
        rotate_x: radians a unit, of yaw and pitch
        rotate_y: radians a unit, of yaw and pitch
        zoom: metres a unit
        pan_x: metres a unit, to the right and up
        pan_y: metres a unit, to the right and up"""

    __slots__ = ()
    rotate_x: float
    rotate_y: float
    zoom: float
    pan_x: float
    pan_y: float
    _fields_ = [("rotate_x", c_float), ("rotate_y", c_float), ("zoom", c_float), ("pan_x", c_float), ("pan_y", c_float)]


orbit_speeds_dtype: dtype[Any] = dtype([("rotate_x", "<f4"), ("rotate_y", "<f4"), ("zoom", "<f4"), ("pan_x", "<f4"), ("pan_y", "<f4")])
OrbitSpeeds.dtype = orbit_speeds_dtype


@struct
class SolverDesc(Desc, Structure):
    """SolverDesc: allocator, gravity, substeps, fixed_step, max_steps, task_runner, worker_count, sleep_speed, sleep_strain, sleep_time, max_strain, tolerance, max_substeps, max_work.

    Fields:
        allocator: None: the C++ runtime's
        gravity: m/s^2; default (0, -9.81, 0)
        substeps: of one step, 1 .. 1000; default 8; with error targets: of the first step
        fixed_step: seconds simulated by each step of Solver.advance; 1/60
        max_steps: most steps of one advance; time beyond is dropped; 8
        task_runner: provides the worker_count threads; None: the solver's own
        worker_count: threads for one step, including the caller's, at most 1024; 0 and 1: that alone
        sleep_speed: m/s, see Solver.get_sleeping; 0: bodies never sleep; default 0
        sleep_strain: of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by the
            mean rest length of the body's rigid constraints; default 0.01
        sleep_time: seconds; default 0.5
        max_strain: of rigid constraints, see Solver.get_substeps; 0: none, for cloth 0.02; default 0
        tolerance: target of positions: metres of error that a second of motion adds; 0: none; default 0
        max_substeps: the most that a target may ask for, 1 .. 1000; default 64
        max_work: see SolverSettings; 0: no bound; default 0"""

    __slots__ = ()
    struct_size: int
    allocator: int | None
    gravity: Field[Vec3]
    substeps: int
    fixed_step: float
    max_steps: int
    task_runner: int | None
    worker_count: int
    sleep_speed: float
    sleep_strain: float
    sleep_time: float
    max_strain: float
    tolerance: float
    max_substeps: int
    max_work: int
    _fields_ = [("struct_size", c_uint32), ("allocator", c_void_p), ("gravity", Vec3), ("substeps", c_uint32), ("fixed_step", c_float), ("max_steps", c_uint32), ("task_runner", c_void_p), ("worker_count", c_uint32), ("sleep_speed", c_float), ("sleep_strain", c_float), ("sleep_time", c_float), ("max_strain", c_float), ("tolerance", c_float), ("max_substeps", c_uint32), ("max_work", c_uint32)]

    def __init__(self, *, allocator: int | None = None, gravity: VectorLike | None = None, substeps: int | None = None, fixed_step: float | None = None, max_steps: int | None = None, task_runner: int | None = None, worker_count: int | None = None, sleep_speed: float | None = None, sleep_strain: float | None = None, sleep_time: float | None = None, max_strain: float | None = None, tolerance: float | None = None, max_substeps: int | None = None, max_work: int | None = None) -> None:
        self._start()
        if allocator is not None:
            self.allocator = allocator
        if gravity is not None:
            self.gravity = gravity
        if substeps is not None:
            self.substeps = substeps
        if fixed_step is not None:
            self.fixed_step = fixed_step
        if max_steps is not None:
            self.max_steps = max_steps
        if task_runner is not None:
            self.task_runner = task_runner
        if worker_count is not None:
            self.worker_count = worker_count
        if sleep_speed is not None:
            self.sleep_speed = sleep_speed
        if sleep_strain is not None:
            self.sleep_strain = sleep_strain
        if sleep_time is not None:
            self.sleep_time = sleep_time
        if max_strain is not None:
            self.max_strain = max_strain
        if tolerance is not None:
            self.tolerance = tolerance
        if max_substeps is not None:
            self.max_substeps = max_substeps
        if max_work is not None:
            self.max_work = max_work


solver_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("allocator", "P"), ("gravity", "<f4", (3,)), ("substeps", "<u4"), ("fixed_step", "<f4"), ("max_steps", "<u4"), ("task_runner", "P"), ("worker_count", "<u4"), ("sleep_speed", "<f4"), ("sleep_strain", "<f4"), ("sleep_time", "<f4"), ("max_strain", "<f4"), ("tolerance", "<f4"), ("max_substeps", "<u4"), ("max_work", "<u4")], align=True)
SolverDesc.dtype = solver_desc_dtype


@struct
class SolverSettings(Value, Structure):
    """What a solver was created with and may change later. Fields as in SolverDesc. Frozen.

    Fields:
        gravity: m/s^2
        substeps: 1 .. 1000
        fixed_step: seconds, 1e-6 .. 0.5
        max_steps: >= 1
        sleep_speed: m/s, >= 0
        sleep_strain: >= 0
        sleep_time: seconds, >= 0
        max_strain: >= 0
        tolerance: m/s, >= 0
        max_substeps: 1 .. 1000
        max_work: most particles times substeps of a step; 0: no bound. If bodies need more, all take fewer
            substeps in proportion, at least one, and cloth at least one for each 25 ms. It bounds work, not time,
            so the bits are the same on every machine"""

    __slots__ = ()
    gravity: Field[Vec3]
    substeps: int
    fixed_step: float
    max_steps: int
    sleep_speed: float
    sleep_strain: float
    sleep_time: float
    max_strain: float
    tolerance: float
    max_substeps: int
    max_work: int
    _fields_ = [("gravity", Vec3), ("substeps", c_uint32), ("fixed_step", c_float), ("max_steps", c_uint32), ("sleep_speed", c_float), ("sleep_strain", c_float), ("sleep_time", c_float), ("max_strain", c_float), ("tolerance", c_float), ("max_substeps", c_uint32), ("max_work", c_uint32)]


solver_settings_dtype: dtype[Any] = dtype([("gravity", "<f4", (3,)), ("substeps", "<u4"), ("fixed_step", "<f4"), ("max_steps", "<u4"), ("sleep_speed", "<f4"), ("sleep_strain", "<f4"), ("sleep_time", "<f4"), ("max_strain", "<f4"), ("tolerance", "<f4"), ("max_substeps", "<u4"), ("max_work", "<u4")])
SolverSettings.dtype = solver_settings_dtype


@struct
class BodyDesc(Desc, Structure):
    """Settings shared by all kinds of bodies.

    Fields:
        mass: kg of the whole body, spread evenly; > 0; default 1
        radius: of each particle for collision, metres, >= 0; default 0.01
        damping: rate in 1/s: velocities decay as exp(-damping t); >= 0; default 0
        friction: Coulomb coefficient against models, >= 0; default 0.5
        restitution: speed kept in a bounce, 0 .. 1; default 0
        compliance: of stretch, metres per newton, >= 0; 0 is inextensible; default 0
        bend_compliance: of CLOTH_BEND constraints, m/N; default 0.001
        cloth_flags: cloth values; default SHEAR | BEND
        layers: mask of the models it collides with; 0: none; default all
        static_friction: of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
            friction, or 0: as friction; default 0
        self_collision: 1: its particles collide with one another, see below; default 0
        body_layers: two bodies collide with each other if their masks share a bit; 0: with none; default 0
        shear_compliance: of CLOTH_SHEAR constraints of a grid, m/N, >= 0; 0: as compliance; default 0
        breaking_force: of each constraint, newtons, >= 0; 0: none breaks; default 0; see Break
        bending_stiffness: of ropes, E I in N m^2, >= 0; 0: they bend freely; default 0; see below"""

    __slots__ = ()
    struct_size: int
    mass: float
    radius: float
    damping: float
    friction: float
    restitution: float
    compliance: float
    bend_compliance: float
    cloth_flags: int
    layers: int
    static_friction: float
    self_collision: int
    body_layers: int
    shear_compliance: float
    breaking_force: float
    bending_stiffness: float
    _fields_ = [("struct_size", c_uint32), ("mass", c_float), ("radius", c_float), ("damping", c_float), ("friction", c_float), ("restitution", c_float), ("compliance", c_float), ("bend_compliance", c_float), ("cloth_flags", c_uint32), ("layers", c_uint32), ("static_friction", c_float), ("self_collision", c_uint32), ("body_layers", c_uint32), ("shear_compliance", c_float), ("breaking_force", c_float), ("bending_stiffness", c_float)]

    def __init__(self, *, mass: float | None = None, radius: float | None = None, damping: float | None = None, friction: float | None = None, restitution: float | None = None, compliance: float | None = None, bend_compliance: float | None = None, cloth_flags: int | None = None, layers: int | None = None, static_friction: float | None = None, self_collision: int | None = None, body_layers: int | None = None, shear_compliance: float | None = None, breaking_force: float | None = None, bending_stiffness: float | None = None) -> None:
        self._start()
        if mass is not None:
            self.mass = mass
        if radius is not None:
            self.radius = radius
        if damping is not None:
            self.damping = damping
        if friction is not None:
            self.friction = friction
        if restitution is not None:
            self.restitution = restitution
        if compliance is not None:
            self.compliance = compliance
        if bend_compliance is not None:
            self.bend_compliance = bend_compliance
        if cloth_flags is not None:
            self.cloth_flags = cloth_flags
        if layers is not None:
            self.layers = layers
        if static_friction is not None:
            self.static_friction = static_friction
        if self_collision is not None:
            self.self_collision = self_collision
        if body_layers is not None:
            self.body_layers = body_layers
        if shear_compliance is not None:
            self.shear_compliance = shear_compliance
        if breaking_force is not None:
            self.breaking_force = breaking_force
        if bending_stiffness is not None:
            self.bending_stiffness = bending_stiffness


body_desc_dtype: dtype[Any] = dtype([("struct_size", "<u4"), ("mass", "<f4"), ("radius", "<f4"), ("damping", "<f4"), ("friction", "<f4"), ("restitution", "<f4"), ("compliance", "<f4"), ("bend_compliance", "<f4"), ("cloth_flags", "<u4"), ("layers", "<u4"), ("static_friction", "<f4"), ("self_collision", "<u4"), ("body_layers", "<u4"), ("shear_compliance", "<f4"), ("breaking_force", "<f4"), ("bending_stiffness", "<f4")])
BodyDesc.dtype = body_desc_dtype


@struct
class BodySettings(Value, Structure):
    """What all particles of a body share and may change later. Fields as in BodyDesc. Frozen.

    Fields:
        damping: 1/s, >= 0
        friction: >= 0
        static_friction: at least friction, or 0: as friction
        restitution: 0 .. 1
        layers: of models
        body_layers: of bodies
        self_collision: 0 or 1; particles nearer than their radii reach when it is set do not collide"""

    __slots__ = ()
    damping: float
    friction: float
    static_friction: float
    restitution: float
    layers: int
    body_layers: int
    self_collision: int
    _fields_ = [("damping", c_float), ("friction", c_float), ("static_friction", c_float), ("restitution", c_float), ("layers", c_uint32), ("body_layers", c_uint32), ("self_collision", c_uint32)]


body_settings_dtype: dtype[Any] = dtype([("damping", "<f4"), ("friction", "<f4"), ("static_friction", "<f4"), ("restitution", "<f4"), ("layers", "<u4"), ("body_layers", "<u4"), ("self_collision", "<u4")])
BodySettings.dtype = body_settings_dtype


@struct
class BodyInfo(Value, Structure):
    """Frozen.

    Fields:
        triangle_count: of cloth, for drawing"""

    __slots__ = ()
    kind: int
    method: int
    particle_count: int
    constraint_count: int
    triangle_count: int
    _fields_ = [("kind", c_int32), ("method", c_int32), ("particle_count", c_uint32), ("constraint_count", c_uint32), ("triangle_count", c_uint32)]


body_info_dtype: dtype[Any] = dtype([("kind", "<i4"), ("method", "<i4"), ("particle_count", "<u4"), ("constraint_count", "<u4"), ("triangle_count", "<u4")])
BodyInfo.dtype = body_info_dtype


@struct
class Wind(Value, Structure):
    """The air around a body. Frozen.

    Fields:
        velocity: of the air, m/s
        density: kg/m^3, >= 0; 1.2 is air at 20 degrees; 0: none
        drag: coefficient C_D, >= 0: a plate across has 1.2, a cylinder 1.2, a sphere 0.5
        lift: coefficient C_L of cloth, >= 0; a plate has as much lift as drag"""

    __slots__ = ()
    velocity: Field[Vec3]
    density: float
    drag: float
    lift: float
    _fields_ = [("velocity", Vec3), ("density", c_float), ("drag", c_float), ("lift", c_float)]


wind_dtype: dtype[Any] = dtype([("velocity", "<f4", (3,)), ("density", "<f4"), ("drag", "<f4"), ("lift", "<f4")])
Wind.dtype = wind_dtype


@struct
class AnimationTarget(Value, Structure):
    """Where an animation wants a particle, and how far from there the particle may be. Frozen.

    Fields:
        position: metres
        normal: of the animated surface, away from the character; any length but 0; not read without a backstop
        max_distance: metres from position, >= 0; INFINITY: any
        backstop: metres that the particle may go behind the plane through position across normal, >= 0; INFINITY:
            any"""

    __slots__ = ()
    position: Field[Vec3]
    normal: Field[Vec3]
    max_distance: float
    backstop: float
    _fields_ = [("position", Vec3), ("normal", Vec3), ("max_distance", c_float), ("backstop", c_float)]


animation_target_dtype: dtype[Any] = dtype([("position", "<f4", (3,)), ("normal", "<f4", (3,)), ("max_distance", "<f4"), ("backstop", "<f4")])
AnimationTarget.dtype = animation_target_dtype


@struct
class Attachment(Value, Structure):
    """A particle that is attached to a model. Frozen.  Since 1.1.

    Fields:
        local_point: in the model's coordinates, as for Solver.attach"""

    __slots__ = ()
    particle: int
    model: int
    local_point: Field[Vec3]
    _fields_ = [("particle", c_uint32), ("model", c_uint32), ("local_point", Vec3)]


attachment_dtype: dtype[Any] = dtype([("particle", "<u4"), ("model", "<u4"), ("local_point", "<f4", (3,))])
Attachment.dtype = attachment_dtype


@struct
class ConstraintInfo(Value, Structure):
    """One constraint. Frozen.

    Fields:
        rest_length: metres
        compliance: metres per newton"""

    __slots__ = ()
    id: int
    particle_a: int
    particle_b: int
    rest_length: float
    compliance: float
    _fields_ = [("id", c_uint32), ("particle_a", c_uint32), ("particle_b", c_uint32), ("rest_length", c_float), ("compliance", c_float)]


constraint_info_dtype: dtype[Any] = dtype([("id", "<u4"), ("particle_a", "<u4"), ("particle_b", "<u4"), ("rest_length", "<f4"), ("compliance", "<f4")])
ConstraintInfo.dtype = constraint_info_dtype


@struct
class ConstraintSettings(Value, Structure):
    """The settings of a constraint. Frozen.

    Fields:
        rest_length: metres, >= 0, below 1e-9 as 0; negative, when it is set: the present distance
        compliance: metres per newton, >= 0; 0 is rigid
        damping: N s/m, >= 0, of what has compliance; see Solver.set_constraint_damping"""

    __slots__ = ()
    rest_length: float
    compliance: float
    damping: float
    _fields_ = [("rest_length", c_float), ("compliance", c_float), ("damping", c_float)]


constraint_settings_dtype: dtype[Any] = dtype([("rest_length", "<f4"), ("compliance", "<f4"), ("damping", "<f4")])
ConstraintSettings.dtype = constraint_settings_dtype


@struct
class JointInfo(Value, Structure):
    """One joint. Frozen.

    Fields:
        rest_length: metres
        compliance: metres per newton
        force: newtons, in the last substep: > 0 pulls them together, < 0 keeps them apart; its magnitude for a
            rest length of 0"""

    __slots__ = ()
    id: int
    body_a: int
    particle_a: int
    body_b: int
    particle_b: int
    rest_length: float
    compliance: float
    force: float
    _fields_ = [("id", c_uint32), ("body_a", c_uint32), ("particle_a", c_uint32), ("body_b", c_uint32), ("particle_b", c_uint32), ("rest_length", c_float), ("compliance", c_float), ("force", c_float)]


joint_info_dtype: dtype[Any] = dtype([("id", "<u4"), ("body_a", "<u4"), ("particle_a", "<u4"), ("body_b", "<u4"), ("particle_b", "<u4"), ("rest_length", "<f4"), ("compliance", "<f4"), ("force", "<f4")])
JointInfo.dtype = joint_info_dtype


@struct
class Break(Value, Structure):
    """A constraint that broke, or that the caller has broken. Frozen.  Since 1.1.

    Fields:
        particle_a: its particles before
        particle_b: its particles before
        torn_particle: where cloth parted; NO_PARTICLE: nowhere, the constraint was removed
        new_particle: its copy, the last of the body; NO_PARTICLE: none
        load: newtons; 0 if the caller broke it"""

    __slots__ = ()
    body: int
    constraint: int
    particle_a: int
    particle_b: int
    torn_particle: int
    new_particle: int
    load: float
    _fields_ = [("body", c_uint32), ("constraint", c_uint32), ("particle_a", c_uint32), ("particle_b", c_uint32), ("torn_particle", c_uint32), ("new_particle", c_uint32), ("load", c_float)]


break_dtype: dtype[Any] = dtype([("body", "<u4"), ("constraint", "<u4"), ("particle_a", "<u4"), ("particle_b", "<u4"), ("torn_particle", "<u4"), ("new_particle", "<u4"), ("load", "<f4")])
Break.dtype = break_dtype


@struct
class SolverStats(Value, Structure):
    """Frozen.

    Fields:
        pinned_count: pinned or attached
        contact_count: particle and model pairs that touched in the last step, 4 a particle at most
        strain_max: largest |length / rest length - 1| of rigid constraints whose rest length is not 0
        strain_rms: root mean square of the same
        kinetic_energy: joules
        potential_energy: joules: of gravity, 0 at the solver's origin, of stretch, bending and held volumes"""

    __slots__ = ()
    particle_count: int
    pinned_count: int
    constraint_count: int
    contact_count: int
    strain_max: float
    strain_rms: float
    kinetic_energy: float
    potential_energy: float
    _fields_ = [("particle_count", c_uint32), ("pinned_count", c_uint32), ("constraint_count", c_uint32), ("contact_count", c_uint32), ("strain_max", c_float), ("strain_rms", c_float), ("kinetic_energy", c_float), ("potential_energy", c_float)]


solver_stats_dtype: dtype[Any] = dtype([("particle_count", "<u4"), ("pinned_count", "<u4"), ("constraint_count", "<u4"), ("contact_count", "<u4"), ("strain_max", "<f4"), ("strain_rms", "<f4"), ("kinetic_energy", "<f4"), ("potential_energy", "<f4")])
SolverStats.dtype = solver_stats_dtype


@struct
class Contact(Value, Structure):
    """A particle that touched a model in the last step. Frozen.

    Fields:
        tag: the model's
        point: on the model, world space
        normal: unit, from the model to the particle"""

    __slots__ = ()
    body: int
    particle: int
    model: int
    tag: int
    point: Field[Vec3]
    normal: Field[Vec3]
    _fields_ = [("body", c_uint32), ("particle", c_uint32), ("model", c_uint32), ("tag", c_uint32), ("point", Vec3), ("normal", Vec3)]


contact_dtype: dtype[Any] = dtype([("body", "<u4"), ("particle", "<u4"), ("model", "<u4"), ("tag", "<u4"), ("point", "<f4", (3,)), ("normal", "<f4", (3,))])
Contact.dtype = contact_dtype


@struct
class BodyContact(Value, Structure):
    """Two particles of different bodies that touched in the last step. Frozen.  Since 1.1.

    Fields:
        body_b: above body_a
        normal: unit, from a to b, when they touched last
        distance: metres between their surfaces as they are now; below 0: they overlap
        impulse: N s along normal, of the whole step: b got it, and a its opposite. The reactions of links and
            models are not in it"""

    __slots__ = ()
    body_a: int
    particle_a: int
    body_b: int
    particle_b: int
    normal: Field[Vec3]
    distance: float
    impulse: float
    _fields_ = [("body_a", c_uint32), ("particle_a", c_uint32), ("body_b", c_uint32), ("particle_b", c_uint32), ("normal", Vec3), ("distance", c_float), ("impulse", c_float)]


body_contact_dtype: dtype[Any] = dtype([("body_a", "<u4"), ("particle_a", "<u4"), ("body_b", "<u4"), ("particle_b", "<u4"), ("normal", "<f4", (3,)), ("distance", "<f4"), ("impulse", "<f4")])
BodyContact.dtype = body_contact_dtype


@struct
class Impulse(Value, Structure):
    """What bodies gave a model in the last step, by contacts and by attachments. Frozen.

    Fields:
        tag: the model's
        linear: N s: what to add to the momentum of the model if it is a body of yours
        angular: N m s, about the model's position in the world: likewise for its angular momentum"""

    __slots__ = ()
    model: int
    tag: int
    linear: Field[Vec3]
    angular: Field[Vec3]
    _fields_ = [("model", c_uint32), ("tag", c_uint32), ("linear", Vec3), ("angular", Vec3)]


impulse_dtype: dtype[Any] = dtype([("model", "<u4"), ("tag", "<u4"), ("linear", "<f4", (3,)), ("angular", "<f4", (3,))])
Impulse.dtype = impulse_dtype


gphys_version = function("gphys_version", c_uint32, [])
gphys_status_name = function("gphys_status_name", c_char_p, [c_int32])
gphys_last_error = function("gphys_last_error", c_char_p, [])
gphys_shape_validate = function("gphys_shape_validate", c_int32, [c_int32, c_void_p])
gphys_shape_bounds = function("gphys_shape_bounds", c_int32, [c_int32, c_void_p, c_void_p])
gphys_shape_transform = function("gphys_shape_transform", c_int32, [c_int32, c_void_p, POINTER(Transform), c_void_p])
gphys_shape_contains = function("gphys_shape_contains", c_int32, [c_int32, c_void_p, POINTER(Vec3), c_float, c_void_p])
gphys_shape_contains_batch = function("gphys_shape_contains_batch", c_int32, [c_int32, c_void_p, c_void_p, c_uint32, c_uint32, c_float, c_void_p, c_uint32])
gphys_shape_closest_point = function("gphys_shape_closest_point", c_int32, [c_int32, c_void_p, POINTER(Vec3), c_void_p])
gphys_shape_closest_point_batch = function("gphys_shape_closest_point_batch", c_int32, [c_int32, c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_segment_closest_points = function("gphys_segment_closest_points", c_int32, [POINTER(Segment), POINTER(Segment), c_void_p, c_void_p, c_void_p])
gphys_shape_overlaps = function("gphys_shape_overlaps", c_int32, [c_int32, c_void_p, c_int32, c_void_p, c_void_p])
gphys_shape_overlaps_batch = function("gphys_shape_overlaps_batch", c_int32, [c_int32, c_void_p, c_uint32, c_int32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_shape_classify_plane = function("gphys_shape_classify_plane", c_int32, [c_int32, c_void_p, POINTER(Plane), c_void_p, c_void_p])
gphys_shape_classify_frustum = function("gphys_shape_classify_frustum", c_int32, [c_int32, c_void_p, POINTER(Frustum), c_void_p])
gphys_shape_raycast = function("gphys_shape_raycast", c_int32, [c_int32, c_void_p, POINTER(Ray), c_void_p])
gphys_shape_raycast_batch = function("gphys_shape_raycast_batch", c_int32, [c_int32, c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_shape_segment_test = function("gphys_shape_segment_test", c_int32, [c_int32, c_void_p, POINTER(Segment), c_void_p])
gphys_shape_sweep_sphere = function("gphys_shape_sweep_sphere", c_int32, [c_int32, c_void_p, POINTER(Sphere), POINTER(Vec3), c_void_p])
gphys_shape_sweep = function("gphys_shape_sweep", c_int32, [c_int32, c_void_p, c_int32, c_void_p, POINTER(Vec3), c_void_p])
gphys_shape_sweep_batch = function("gphys_shape_sweep_batch", c_int32, [c_int32, c_void_p, c_uint32, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_shape_penetration = function("gphys_shape_penetration", c_int32, [c_int32, c_void_p, c_int32, c_void_p, c_void_p])
gphys_shape_penetration_batch = function("gphys_shape_penetration_batch", c_int32, [c_int32, c_void_p, c_uint32, c_int32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_frustum_corners = function("gphys_frustum_corners", c_int32, [POINTER(Frustum), c_void_p])
gphys_planes_intersection = function("gphys_planes_intersection", c_int32, [POINTER(Plane), POINTER(Plane), POINTER(Plane), c_void_p])
gphys_planes_intersection_batch = function("gphys_planes_intersection_batch", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_mat4_orthonormality = function("gphys_mat4_orthonormality", c_int32, [POINTER(Mat4), c_void_p])
gphys_frustum_from_matrix = function("gphys_frustum_from_matrix", c_int32, [POINTER(Mat4), c_int32, c_int32, c_void_p])
gphys_mesh_check = function("gphys_mesh_check", c_int32, [c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_mesh_desc_init = function("gphys_mesh_desc_init", c_int32, [c_void_p, c_uint32])
gphys_mesh_create = function("gphys_mesh_create", c_int32, [POINTER(MeshDesc), c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_mesh_create_hull = function("gphys_mesh_create_hull", c_int32, [POINTER(MeshDesc), c_void_p, c_uint32, c_uint32, c_void_p])
gphys_mesh_get_hull_planes = function("gphys_mesh_get_hull_planes", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_get_hull_faces = function("gphys_mesh_get_hull_faces", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_set_vertices = function("gphys_mesh_set_vertices", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32])
gphys_mesh_destroy = function("gphys_mesh_destroy", None, [c_void_p])
gphys_mesh_get_info = function("gphys_mesh_get_info", c_int32, [c_void_p, c_void_p])
gphys_mesh_get_report = function("gphys_mesh_get_report", c_int32, [c_void_p, c_void_p])
gphys_mesh_get_vertices = function("gphys_mesh_get_vertices", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_get_indices = function("gphys_mesh_get_indices", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_get_snapshot = function("gphys_mesh_get_snapshot", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_create_from_snapshot = function("gphys_mesh_create_from_snapshot", c_int32, [POINTER(MeshDesc), c_void_p, c_uint32, c_void_p])
gphys_mesh_raycast_all = function("gphys_mesh_raycast_all", c_int32, [c_void_p, POINTER(Ray), c_void_p, c_uint32, c_void_p])
gphys_mesh_raycast_any = function("gphys_mesh_raycast_any", c_int32, [c_void_p, POINTER(Ray), c_void_p])
gphys_mesh_raycast_any_batch = function("gphys_mesh_raycast_any_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_mesh_raycast_distance_batch = function("gphys_mesh_raycast_distance_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_mesh_overlap = function("gphys_mesh_overlap", c_int32, [c_void_p, c_int32, c_void_p, c_void_p, c_uint32, c_void_p])
gphys_mesh_get_octree_stats = function("gphys_mesh_get_octree_stats", c_int32, [c_void_p, c_void_p])
gphys_mesh_get_octree_boxes = function("gphys_mesh_get_octree_boxes", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_scene_desc_init = function("gphys_scene_desc_init", c_int32, [c_void_p, c_uint32])
gphys_scene_create = function("gphys_scene_create", c_int32, [POINTER(SceneDesc), c_void_p])
gphys_scene_destroy = function("gphys_scene_destroy", None, [c_void_p])
gphys_scene_set_worker_count = function("gphys_scene_set_worker_count", c_int32, [c_void_p, c_uint32])
gphys_scene_get_worker_count = function("gphys_scene_get_worker_count", c_int32, [c_void_p, c_void_p])
gphys_scene_set_origin = function("gphys_scene_set_origin", c_int32, [c_void_p, c_void_p])
gphys_scene_get_origin = function("gphys_scene_get_origin", c_int32, [c_void_p, c_void_p])
gphys_model_desc_init = function("gphys_model_desc_init", c_int32, [c_void_p, c_uint32])
gphys_scene_add = function("gphys_scene_add", c_int32, [c_void_p, c_int32, c_void_p, POINTER(Transform), POINTER(ModelDesc), c_void_p])
gphys_scene_add_batch = function("gphys_scene_add_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, POINTER(ModelDesc), c_void_p])
gphys_scene_add_described_batch = function("gphys_scene_add_described_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_void_p])
gphys_scene_remove = function("gphys_scene_remove", c_int32, [c_void_p, c_uint32])
gphys_scene_remove_batch = function("gphys_scene_remove_batch", c_int32, [c_void_p, c_void_p, c_uint32])
gphys_scene_remove_subtree = function("gphys_scene_remove_subtree", c_int32, [c_void_p, c_uint32])
gphys_scene_clear = function("gphys_scene_clear", c_int32, [c_void_p])
gphys_scene_has = function("gphys_scene_has", c_int32, [c_void_p, c_uint32])
gphys_scene_get_models = function("gphys_scene_get_models", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_scene_get_roots = function("gphys_scene_get_roots", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_scene_get_children = function("gphys_scene_get_children", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_get_info = function("gphys_scene_get_info", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_scene_get_shape = function("gphys_scene_get_shape", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_get_mesh = function("gphys_scene_get_mesh", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_scene_get_bounds = function("gphys_scene_get_bounds", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_scene_get_scene_bounds = function("gphys_scene_get_scene_bounds", c_int32, [c_void_p, c_void_p])
gphys_scene_set_shape = function("gphys_scene_set_shape", c_int32, [c_void_p, c_uint32, c_int32, c_void_p])
gphys_scene_set_scale = function("gphys_scene_set_scale", c_int32, [c_void_p, c_uint32, POINTER(Vec3)])
gphys_scene_get_scale = function("gphys_scene_get_scale", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_scene_set_layers = function("gphys_scene_set_layers", c_int32, [c_void_p, c_uint32, c_uint32])
gphys_scene_set_tag = function("gphys_scene_set_tag", c_int32, [c_void_p, c_uint32, c_uint32])
gphys_scene_set_parent = function("gphys_scene_set_parent", c_int32, [c_void_p, c_uint32, c_uint32, c_int32])
gphys_scene_set_transform = function("gphys_scene_set_transform", c_int32, [c_void_p, c_uint32, POINTER(Transform)])
gphys_scene_set_transforms = function("gphys_scene_set_transforms", c_int32, [c_void_p, c_void_p, c_void_p, c_uint32, c_uint32])
gphys_scene_get_transforms = function("gphys_scene_get_transforms", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_get_world_transforms = function("gphys_scene_get_world_transforms", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast = function("gphys_scene_raycast", c_int32, [c_void_p, POINTER(Ray), c_uint32, c_void_p])
gphys_scene_raycast_batch = function("gphys_scene_raycast_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_distance_batch = function("gphys_scene_raycast_distance_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_any = function("gphys_scene_raycast_any", c_int32, [c_void_p, POINTER(Ray), c_uint32, c_void_p])
gphys_scene_raycast_any_batch = function("gphys_scene_raycast_any_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_all = function("gphys_scene_raycast_all", c_int32, [c_void_p, POINTER(Ray), c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_raycast_all_batch = function("gphys_scene_raycast_all_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_segment_test = function("gphys_scene_segment_test", c_int32, [c_void_p, POINTER(Segment), c_uint32, c_void_p])
gphys_scene_segment_test_batch = function("gphys_scene_segment_test_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_overlap = function("gphys_scene_overlap", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_overlap_batch = function("gphys_scene_overlap_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_cull = function("gphys_scene_cull", c_int32, [c_void_p, POINTER(Frustum), c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_cull_batch = function("gphys_scene_cull_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_nearest = function("gphys_scene_nearest", c_int32, [c_void_p, POINTER(Vec3), c_float, c_uint32, c_void_p])
gphys_scene_nearest_batch = function("gphys_scene_nearest_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_float, c_uint32, c_void_p, c_uint32])
gphys_scene_sweep_sphere = function("gphys_scene_sweep_sphere", c_int32, [c_void_p, POINTER(Sphere), POINTER(Vec3), c_uint32, c_void_p])
gphys_scene_sweep_sphere_batch = function("gphys_scene_sweep_sphere_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_sweep = function("gphys_scene_sweep", c_int32, [c_void_p, c_int32, c_void_p, POINTER(Vec3), c_uint32, c_void_p])
gphys_scene_sweep_batch = function("gphys_scene_sweep_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_scene_penetration = function("gphys_scene_penetration", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_penetration_batch = function("gphys_scene_penetration_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_query_filter_desc_init = function("gphys_query_filter_desc_init", c_int32, [c_void_p, c_uint32])
gphys_scene_raycast_filtered = function("gphys_scene_raycast_filtered", c_int32, [c_void_p, POINTER(Ray), POINTER(QueryFilterDesc), c_void_p])
gphys_scene_raycast_filtered_batch = function("gphys_scene_raycast_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_distance_filtered_batch = function("gphys_scene_raycast_distance_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_any_filtered = function("gphys_scene_raycast_any_filtered", c_int32, [c_void_p, POINTER(Ray), POINTER(QueryFilterDesc), c_void_p])
gphys_scene_raycast_any_filtered_batch = function("gphys_scene_raycast_any_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_raycast_all_filtered = function("gphys_scene_raycast_all_filtered", c_int32, [c_void_p, POINTER(Ray), POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_scene_raycast_all_filtered_batch = function("gphys_scene_raycast_all_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_segment_test_filtered = function("gphys_scene_segment_test_filtered", c_int32, [c_void_p, POINTER(Segment), POINTER(QueryFilterDesc), c_void_p])
gphys_scene_segment_test_filtered_batch = function("gphys_scene_segment_test_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_overlap_filtered = function("gphys_scene_overlap_filtered", c_int32, [c_void_p, c_int32, c_void_p, POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_scene_overlap_filtered_batch = function("gphys_scene_overlap_filtered_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_cull_filtered = function("gphys_scene_cull_filtered", c_int32, [c_void_p, POINTER(Frustum), POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_scene_cull_filtered_batch = function("gphys_scene_cull_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_nearest_filtered = function("gphys_scene_nearest_filtered", c_int32, [c_void_p, POINTER(Vec3), c_float, POINTER(QueryFilterDesc), c_void_p])
gphys_scene_nearest_filtered_batch = function("gphys_scene_nearest_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_float, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_sweep_sphere_filtered = function("gphys_scene_sweep_sphere_filtered", c_int32, [c_void_p, POINTER(Sphere), POINTER(Vec3), POINTER(QueryFilterDesc), c_void_p])
gphys_scene_sweep_sphere_filtered_batch = function("gphys_scene_sweep_sphere_filtered_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_sweep_filtered = function("gphys_scene_sweep_filtered", c_int32, [c_void_p, c_int32, c_void_p, POINTER(Vec3), POINTER(QueryFilterDesc), c_void_p])
gphys_scene_sweep_filtered_batch = function("gphys_scene_sweep_filtered_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_scene_penetration_filtered = function("gphys_scene_penetration_filtered", c_int32, [c_void_p, c_int32, c_void_p, POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_scene_penetration_filtered_batch = function("gphys_scene_penetration_filtered_batch", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_scene_rebuild_octree = function("gphys_scene_rebuild_octree", c_int32, [c_void_p])
gphys_scene_maintain_octree = function("gphys_scene_maintain_octree", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_scene_get_octree_stats = function("gphys_scene_get_octree_stats", c_int32, [c_void_p, c_void_p])
gphys_scene_get_octree_boxes = function("gphys_scene_get_octree_boxes", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_scene_validate = function("gphys_scene_validate", c_int32, [c_void_p])
gphys_scene_get_snapshot = function("gphys_scene_get_snapshot", c_int32, [c_void_p, c_int32, c_void_p, c_uint32, c_void_p])
gphys_scene_restore = function("gphys_scene_restore", c_int32, [c_void_p, c_void_p, c_void_p, c_uint32])
gphys_scene_get_hash = function("gphys_scene_get_hash", c_int32, [c_void_p, c_void_p])
gphys_camera_desc_init = function("gphys_camera_desc_init", c_int32, [c_void_p, c_uint32])
gphys_camera_create = function("gphys_camera_create", c_int32, [POINTER(CameraDesc), c_void_p])
gphys_camera_destroy = function("gphys_camera_destroy", None, [c_void_p])
gphys_camera_set_origin = function("gphys_camera_set_origin", c_int32, [c_void_p, c_void_p])
gphys_camera_get_origin = function("gphys_camera_get_origin", c_int32, [c_void_p, c_void_p])
gphys_camera_set_perspective = function("gphys_camera_set_perspective", c_int32, [c_void_p, c_float, c_float, c_float])
gphys_camera_set_orthographic = function("gphys_camera_set_orthographic", c_int32, [c_void_p, c_float, c_float, c_float])
gphys_camera_set_projection = function("gphys_camera_set_projection", c_int32, [c_void_p, POINTER(Mat4)])
gphys_camera_set_perspective_aspect = function("gphys_camera_set_perspective_aspect", c_int32, [c_void_p, c_float, c_float, c_float, c_float])
gphys_camera_set_orthographic_size = function("gphys_camera_set_orthographic_size", c_int32, [c_void_p, c_float, c_float, c_float, c_float])
gphys_camera_set_viewport = function("gphys_camera_set_viewport", c_int32, [c_void_p, c_float, c_float])
gphys_camera_set_viewport_origin = function("gphys_camera_set_viewport_origin", c_int32, [c_void_p, c_float, c_float])
gphys_camera_set_pick_start = function("gphys_camera_set_pick_start", c_int32, [c_void_p, c_int32])
gphys_camera_get_projection = function("gphys_camera_get_projection", c_int32, [c_void_p, c_void_p, c_void_p, c_void_p, c_void_p])
gphys_camera_get_viewport = function("gphys_camera_get_viewport", c_int32, [c_void_p, c_void_p, c_void_p])
gphys_camera_get_viewport_origin = function("gphys_camera_get_viewport_origin", c_int32, [c_void_p, c_void_p, c_void_p])
gphys_camera_get_aspect = function("gphys_camera_get_aspect", c_int32, [c_void_p, c_void_p, c_void_p])
gphys_camera_get_image_size = function("gphys_camera_get_image_size", c_int32, [c_void_p, c_void_p, c_void_p])
gphys_camera_get_pick_start = function("gphys_camera_get_pick_start", c_int32, [c_void_p, c_void_p])
gphys_camera_get_conventions = function("gphys_camera_get_conventions", c_int32, [c_void_p, c_void_p, c_void_p, c_void_p])
gphys_camera_set_transform = function("gphys_camera_set_transform", c_int32, [c_void_p, POINTER(Vec3), POINTER(Quat)])
gphys_camera_set_world_matrix = function("gphys_camera_set_world_matrix", c_int32, [c_void_p, POINTER(Mat4)])
gphys_camera_set_view_matrix = function("gphys_camera_set_view_matrix", c_int32, [c_void_p, POINTER(Mat4)])
gphys_camera_look_at = function("gphys_camera_look_at", c_int32, [c_void_p, POINTER(Vec3), POINTER(Vec3), POINTER(Vec3)])
gphys_camera_get_transform = function("gphys_camera_get_transform", c_int32, [c_void_p, c_void_p, c_void_p])
gphys_camera_get_world_matrix = function("gphys_camera_get_world_matrix", c_int32, [c_void_p, c_void_p])
gphys_camera_get_view_matrix = function("gphys_camera_get_view_matrix", c_int32, [c_void_p, c_void_p])
gphys_camera_get_projection_matrix = function("gphys_camera_get_projection_matrix", c_int32, [c_void_p, c_void_p])
gphys_camera_get_view_projection_matrix = function("gphys_camera_get_view_projection_matrix", c_int32, [c_void_p, c_void_p])
gphys_orbit_init = function("gphys_orbit_init", c_int32, [c_void_p])
gphys_camera_set_orbit = function("gphys_camera_set_orbit", c_int32, [c_void_p, POINTER(Orbit)])
gphys_camera_get_orbit = function("gphys_camera_get_orbit", c_int32, [c_void_p, c_void_p])
gphys_camera_set_orbit_speeds = function("gphys_camera_set_orbit_speeds", c_int32, [c_void_p, POINTER(OrbitSpeeds)])
gphys_camera_get_orbit_speeds = function("gphys_camera_get_orbit_speeds", c_int32, [c_void_p, c_void_p])
gphys_camera_orbit_rotate = function("gphys_camera_orbit_rotate", c_int32, [c_void_p, c_float, c_float])
gphys_camera_orbit_zoom = function("gphys_camera_orbit_zoom", c_int32, [c_void_p, c_float])
gphys_camera_orbit_pan = function("gphys_camera_orbit_pan", c_int32, [c_void_p, c_float, c_float])
gphys_camera_orbit_update = function("gphys_camera_orbit_update", c_int32, [c_void_p])
gphys_camera_get_frustum = function("gphys_camera_get_frustum", c_int32, [c_void_p, c_void_p])
gphys_camera_get_corners = function("gphys_camera_get_corners", c_int32, [c_void_p, c_void_p])
gphys_camera_get_rectangle_frustum = function("gphys_camera_get_rectangle_frustum", c_int32, [c_void_p, c_float, c_float, c_float, c_float, c_void_p])
gphys_camera_get_rectangle_corners = function("gphys_camera_get_rectangle_corners", c_int32, [c_void_p, c_float, c_float, c_float, c_float, c_void_p])
gphys_camera_project = function("gphys_camera_project", c_int32, [c_void_p, POINTER(Vec3), c_void_p])
gphys_camera_project_batch = function("gphys_camera_project_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_camera_unproject = function("gphys_camera_unproject", c_int32, [c_void_p, POINTER(Vec3), c_void_p])
gphys_camera_unproject_batch = function("gphys_camera_unproject_batch", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_camera_pick_ray = function("gphys_camera_pick_ray", c_int32, [c_void_p, c_float, c_float, c_void_p])
gphys_camera_pick_rays = function("gphys_camera_pick_rays", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_camera_pick = function("gphys_camera_pick", c_int32, [c_void_p, c_void_p, c_float, c_float, c_uint32, c_void_p])
gphys_camera_pick_batch = function("gphys_camera_pick_batch", c_int32, [c_void_p, c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_camera_pick_rectangle = function("gphys_camera_pick_rectangle", c_int32, [c_void_p, c_void_p, c_float, c_float, c_float, c_float, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_camera_cull = function("gphys_camera_cull", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_camera_pick_filtered = function("gphys_camera_pick_filtered", c_int32, [c_void_p, c_void_p, c_float, c_float, POINTER(QueryFilterDesc), c_void_p])
gphys_camera_pick_filtered_batch = function("gphys_camera_pick_filtered_batch", c_int32, [c_void_p, c_void_p, c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_camera_pick_rectangle_filtered = function("gphys_camera_pick_rectangle_filtered", c_int32, [c_void_p, c_void_p, c_float, c_float, c_float, c_float, POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_camera_cull_filtered = function("gphys_camera_cull_filtered", c_int32, [c_void_p, c_void_p, POINTER(QueryFilterDesc), c_void_p, c_uint32, c_void_p])
gphys_solver_desc_init = function("gphys_solver_desc_init", c_int32, [c_void_p, c_uint32])
gphys_solver_create = function("gphys_solver_create", c_int32, [POINTER(SolverDesc), c_void_p])
gphys_solver_destroy = function("gphys_solver_destroy", None, [c_void_p])
gphys_solver_set_worker_count = function("gphys_solver_set_worker_count", c_int32, [c_void_p, c_uint32])
gphys_solver_get_worker_count = function("gphys_solver_get_worker_count", c_int32, [c_void_p, c_void_p])
gphys_solver_set_origin = function("gphys_solver_set_origin", c_int32, [c_void_p, c_void_p])
gphys_solver_get_origin = function("gphys_solver_get_origin", c_int32, [c_void_p, c_void_p])
gphys_solver_set_gravity = function("gphys_solver_set_gravity", c_int32, [c_void_p, POINTER(Vec3)])
gphys_solver_set_substeps = function("gphys_solver_set_substeps", c_int32, [c_void_p, c_uint32])
gphys_solver_get_settings = function("gphys_solver_get_settings", c_int32, [c_void_p, c_void_p])
gphys_solver_set_settings = function("gphys_solver_set_settings", c_int32, [c_void_p, POINTER(SolverSettings)])
gphys_body_desc_init = function("gphys_body_desc_init", c_int32, [c_void_p, c_uint32])
gphys_solver_add_particles = function("gphys_solver_add_particles", c_int32, [c_void_p, POINTER(BodyDesc), c_void_p, c_uint32, c_uint32, c_void_p])
gphys_solver_add_rope = function("gphys_solver_add_rope", c_int32, [c_void_p, POINTER(BodyDesc), c_void_p, c_uint32, c_uint32, c_float, c_void_p])
gphys_solver_add_cloth = function("gphys_solver_add_cloth", c_int32, [c_void_p, POINTER(BodyDesc), POINTER(Vec3), POINTER(Vec3), POINTER(Vec3), c_uint32, c_uint32, c_void_p])
gphys_solver_add_cloth_mesh = function("gphys_solver_add_cloth_mesh", c_int32, [c_void_p, POINTER(BodyDesc), c_void_p, POINTER(Transform), c_void_p])
gphys_solver_remove_body = function("gphys_solver_remove_body", c_int32, [c_void_p, c_uint32])
gphys_solver_get_bodies = function("gphys_solver_get_bodies", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_get_sleeping = function("gphys_solver_get_sleeping", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_wake = function("gphys_solver_wake", c_int32, [c_void_p, c_uint32])
gphys_solver_get_body_settings = function("gphys_solver_get_body_settings", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_solver_set_body_settings = function("gphys_solver_set_body_settings", c_int32, [c_void_p, c_uint32, POINTER(BodySettings)])
gphys_solver_get_body_info = function("gphys_solver_get_body_info", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_solver_get_triangles = function("gphys_solver_get_triangles", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_mesh_create_from_body = function("gphys_mesh_create_from_body", c_int32, [POINTER(MeshDesc), c_void_p, c_uint32, c_void_p])
gphys_solver_get_nearest_particle = function("gphys_solver_get_nearest_particle", c_int32, [c_void_p, c_uint32, c_uint32, POINTER(Vec3), c_void_p])
gphys_solver_get_positions = function("gphys_solver_get_positions", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_positions = function("gphys_solver_set_positions", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_velocities = function("gphys_solver_get_velocities", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_velocities = function("gphys_solver_set_velocities", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_masses = function("gphys_solver_get_masses", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_masses = function("gphys_solver_set_masses", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_radii = function("gphys_solver_get_radii", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_radii = function("gphys_solver_set_radii", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_friction_factors = function("gphys_solver_get_friction_factors", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_friction_factors = function("gphys_solver_set_friction_factors", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_forces = function("gphys_solver_get_forces", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_forces = function("gphys_solver_set_forces", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_pinned = function("gphys_solver_get_pinned", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_pinned = function("gphys_solver_set_pinned", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_int32])
gphys_solver_set_wind = function("gphys_solver_set_wind", c_int32, [c_void_p, c_uint32, POINTER(Wind)])
gphys_solver_get_wind = function("gphys_solver_get_wind", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_solver_set_air_velocities = function("gphys_solver_set_air_velocities", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_air_velocities = function("gphys_solver_get_air_velocities", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_set_animation_targets = function("gphys_solver_set_animation_targets", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_get_animation_targets = function("gphys_solver_get_animation_targets", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_void_p, c_uint32])
gphys_solver_attach = function("gphys_solver_attach", c_int32, [c_void_p, c_void_p, c_uint32, c_uint32, c_uint32, POINTER(Vec3)])
gphys_solver_detach = function("gphys_solver_detach", c_int32, [c_void_p, c_uint32, c_uint32])
gphys_solver_get_attachments = function("gphys_solver_get_attachments", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_add_distance = function("gphys_solver_add_distance", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_float, c_float, c_void_p])
gphys_solver_add_max_distance = function("gphys_solver_add_max_distance", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_float, c_float, c_void_p])
gphys_solver_set_constraint_damping = function("gphys_solver_set_constraint_damping", c_int32, [c_void_p, c_uint32, c_uint32, c_float])
gphys_solver_set_volume = function("gphys_solver_set_volume", c_int32, [c_void_p, c_uint32, c_float, c_float])
gphys_solver_get_volume = function("gphys_solver_get_volume", c_int32, [c_void_p, c_uint32, c_void_p, c_void_p])
gphys_solver_get_volume_settings = function("gphys_solver_get_volume_settings", c_int32, [c_void_p, c_uint32, c_void_p, c_void_p])
gphys_solver_remove_constraint = function("gphys_solver_remove_constraint", c_int32, [c_void_p, c_uint32, c_uint32])
gphys_solver_get_constraints = function("gphys_solver_get_constraints", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_get_constraint_kinds = function("gphys_solver_get_constraint_kinds", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_solver_get_constraint_settings = function("gphys_solver_get_constraint_settings", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_solver_set_constraint_settings = function("gphys_solver_set_constraint_settings", c_int32, [c_void_p, c_uint32, c_void_p, c_void_p, c_uint32, c_uint32])
gphys_solver_add_cluster = function("gphys_solver_add_cluster", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_remove_cluster = function("gphys_solver_remove_cluster", c_int32, [c_void_p, c_uint32, c_uint32])
gphys_solver_get_clusters = function("gphys_solver_get_clusters", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_get_cluster_particles = function("gphys_solver_get_cluster_particles", c_int32, [c_void_p, c_uint32, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_join = function("gphys_solver_join", c_int32, [c_void_p, c_uint32, c_uint32, c_uint32, c_uint32, c_float, c_float, c_void_p])
gphys_solver_unjoin = function("gphys_solver_unjoin", c_int32, [c_void_p, c_uint32])
gphys_solver_get_joints = function("gphys_solver_get_joints", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p])
gphys_solver_set_breaking_forces = function("gphys_solver_set_breaking_forces", c_int32, [c_void_p, c_uint32, c_void_p, c_void_p, c_uint32, c_uint32])
gphys_solver_get_breaking_forces = function("gphys_solver_get_breaking_forces", c_int32, [c_void_p, c_uint32, c_void_p, c_uint32, c_void_p, c_uint32])
gphys_solver_break_constraint = function("gphys_solver_break_constraint", c_int32, [c_void_p, c_uint32, c_uint32, c_void_p])
gphys_solver_get_breaks = function("gphys_solver_get_breaks", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_step = function("gphys_solver_step", c_int32, [c_void_p, c_void_p, c_float])
gphys_solver_advance = function("gphys_solver_advance", c_int32, [c_void_p, c_void_p, c_float, c_void_p, c_void_p])
gphys_solver_get_leftover = function("gphys_solver_get_leftover", c_int32, [c_void_p, c_void_p])
gphys_solver_get_substeps = function("gphys_solver_get_substeps", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_solver_get_stats = function("gphys_solver_get_stats", c_int32, [c_void_p, c_uint32, c_void_p])
gphys_solver_get_contacts = function("gphys_solver_get_contacts", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_get_body_contacts = function("gphys_solver_get_body_contacts", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_get_impulses = function("gphys_solver_get_impulses", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_get_snapshot = function("gphys_solver_get_snapshot", c_int32, [c_void_p, c_void_p, c_uint32, c_void_p])
gphys_solver_restore = function("gphys_solver_restore", c_int32, [c_void_p, c_void_p, c_uint32])
gphys_solver_get_hash = function("gphys_solver_get_hash", c_int32, [c_void_p, c_void_p])
MeshDesc._init = gphys_mesh_desc_init
SceneDesc._init = gphys_scene_desc_init
ModelDesc._init = gphys_model_desc_init
QueryFilterDesc._init = gphys_query_filter_desc_init
CameraDesc._init = gphys_camera_desc_init
SolverDesc._init = gphys_solver_desc_init
BodyDesc._init = gphys_body_desc_init

shape_types.update({Sphere: SHAPE_SPHERE, Capsule: SHAPE_CAPSULE, Aabb: SHAPE_AABB, Obb: SHAPE_OBB, Plane: SHAPE_PLANE, Triangle: SHAPE_TRIANGLE, Frustum: SHAPE_FRUSTUM, Ray: SHAPE_RAY, Segment: SHAPE_SEGMENT})

__all__ = [
    "OK", "NO_HIT", "INCOMPLETE", "UNBOUNDED", "ERROR_INVALID_ARGUMENT", "ERROR_INVALID_ID",
    "ERROR_STRUCT_SIZE", "ERROR_OUT_OF_MEMORY", "ERROR_CAPACITY", "ERROR_CYCLE", "ERROR_UNSUPPORTED",
    "ERROR_SINGULAR", "ERROR_INTERNAL", "FRUSTUM_NEAR", "FRUSTUM_FAR", "FRUSTUM_LEFT", "FRUSTUM_RIGHT",
    "FRUSTUM_BOTTOM", "FRUSTUM_TOP", "HIT_INSIDE", "HIT_BACK", "SHAPE_SPHERE", "SHAPE_CAPSULE", "SHAPE_AABB",
    "SHAPE_OBB", "SHAPE_PLANE", "SHAPE_TRIANGLE", "SHAPE_FRUSTUM", "SHAPE_MESH", "SHAPE_RAY", "SHAPE_SEGMENT",
    "SIDE_OUTSIDE", "SIDE_CROSSING", "SIDE_INSIDE", "DEPTH_ZERO_TO_ONE", "DEPTH_MINUS_ONE_TO_ONE",
    "MESH_SURFACE", "MESH_BODY_SURFACE", "MESH_BODY_LINKS", "MESH_HULL", "FILTER_SUBTREE",
    "FILTER_NO_BACK_FACES", "FILTER_NO_FRONT_FACES", "PROJECTION_PERSPECTIVE", "PROJECTION_ORTHOGRAPHIC",
    "PROJECTION_USER", "LEFT_HANDED", "RIGHT_HANDED", "PICK_FROM_NEAR_PLANE", "PICK_FROM_CENTRE",
    "CLOTH_SHEAR", "CLOTH_BEND", "BODY_PARTICLES", "BODY_ROPE", "BODY_CLOTH", "SOLVE_FREE", "SOLVE_DIRECT",
    "SOLVE_GRAPH", "CONSTRAINT_DISTANCE", "CONSTRAINT_MAX_DISTANCE", "VERSION_MAJOR", "VERSION_MINOR",
    "VERSION_PATCH", "MAX_COORDINATE", "NO_TRIANGLE", "NO_PARTICLE", "ALL_LAYERS", "Vec3", "vec3_dtype",
    "Quat", "quat_dtype", "Mat4", "mat4_dtype", "Transform", "transform_dtype", "Ray", "ray_dtype", "Segment",
    "segment_dtype", "Sphere", "sphere_dtype", "Capsule", "capsule_dtype", "Aabb", "aabb_dtype", "Obb",
    "obb_dtype", "Plane", "plane_dtype", "Triangle", "triangle_dtype", "Frustum", "frustum_dtype", "Hit",
    "hit_dtype", "Nearest", "nearest_dtype", "Distance", "distance_dtype", "Penetration", "penetration_dtype",
    "MeshReport", "mesh_report_dtype", "MeshDesc", "mesh_desc_dtype", "MeshInfo", "mesh_info_dtype",
    "OctreeStats", "octree_stats_dtype", "OctreeBox", "octree_box_dtype", "SceneDesc", "scene_desc_dtype",
    "ModelDesc", "model_desc_dtype", "ModelInfo", "model_info_dtype", "QueryFilterDesc",
    "query_filter_desc_dtype", "CameraDesc", "camera_desc_dtype", "Orbit", "orbit_dtype", "OrbitSpeeds",
    "orbit_speeds_dtype", "SolverDesc", "solver_desc_dtype", "SolverSettings", "solver_settings_dtype",
    "BodyDesc", "body_desc_dtype", "BodySettings", "body_settings_dtype", "BodyInfo", "body_info_dtype",
    "Wind", "wind_dtype", "AnimationTarget", "animation_target_dtype", "Attachment", "attachment_dtype",
    "ConstraintInfo", "constraint_info_dtype", "ConstraintSettings", "constraint_settings_dtype", "JointInfo",
    "joint_info_dtype", "Break", "break_dtype", "SolverStats", "solver_stats_dtype", "Contact",
    "contact_dtype", "BodyContact", "body_contact_dtype", "Impulse", "impulse_dtype",
]
