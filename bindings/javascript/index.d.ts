// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
/** Elements of a batch: rows of 4-byte numbers, one after the other. */
export type Elements = Float32Array | Uint32Array | Int32Array | Records;
/** Results of a batch: one view for each type of number, and objects on demand. */
export interface Records {
    readonly length: number;
    readonly stride: number;
    readonly f32: Float32Array;
    readonly u32: Uint32Array;
    readonly i32: Int32Array;
    readonly f64?: Float64Array;
    get(index: number): any;
}
export interface Shape { readonly type: number }
export interface Shapes { readonly type: number; readonly data: Float32Array }
export class GamephysError extends Error { readonly status: number }
/** Memory functions for one object and everything in it. Both are called on the thread that calls
 * the library, possibly from several threads if the objects that share it are used so.
 * allocate returns NULL on failure (reported as GPHYS_ERROR_OUT_OF_MEMORY, nothing changed);
 * release gets the same size and alignment again. The struct is copied at creation. */
export interface Allocator {
    allocate: null;
    release: null;
    user: null;
}
/** The caller's own threads (a job system). run calls task(context, 0) .. task(context, count - 1),
 * each once, in any order, on any threads, several at a time or not, and returns when all have
 * returned. It is called on the thread that called the library, by several at the same time if
 * several ask. The struct is copied at creation. */
export interface TaskRunner {
    run: null;
    user: null;
}
export interface Vec3 {
    x: number;
    y: number;
    z: number;
}
export interface Quat {
    x: number;
    y: number;
    z: number;
    w: number;
}
export interface Mat4 {
    m: ArrayLike<number>;
}
/** x -> position + rotation * (scale * x); scale > 0. */
export interface Transform {
    position: ArrayLike<number>;
    rotation: ArrayLike<number>;
    scale: number;
}
export interface Ray {
    origin: ArrayLike<number>;
    direction: ArrayLike<number>;
    t_max: number;
}
export interface Segment {
    a: ArrayLike<number>;
    b: ArrayLike<number>;
}
export interface Sphere {
    center: ArrayLike<number>;
    radius: number;
}
/** All points within radius of the segment a b. */
export interface Capsule {
    a: ArrayLike<number>;
    b: ArrayLike<number>;
    radius: number;
}
export interface Aabb {
    min: ArrayLike<number>;
    max: ArrayLike<number>;
}
export interface Obb {
    center: ArrayLike<number>;
    half_extents: ArrayLike<number>;
    rotation: ArrayLike<number>;
}
/** The points x with dot(normal, x) = distance. The normal points to the front; it need not be
 * exactly unit: signed distances are divided by its length (for a unit normal, distance is the
 * plane's distance from the origin). distance divided by that length is within the range of
 * coordinates too. */
export interface Plane {
    normal: ArrayLike<number>;
    distance: number;
}
/** May be degenerate: then it is the segment or point that its corners span. The normal is that
 * of cross(b - a, c - a). */
export interface Triangle {
    a: ArrayLike<number>;
    b: ArrayLike<number>;
    c: ArrayLike<number>;
}
/** The points x with dot(planes[i].normal, x - origin) >= planes[i].distance for all six planes,
 * which look inward, in the order of gphys_frustum_plane. Distances count from origin, so that a
 * frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1. */
export interface Frustum {
    origin: ArrayLike<number>;
    planes: Plane[];
}
/** Where a ray, segment or swept sphere first meets something. */
export interface Hit {
    model: number;
    tag: number;
    t: number;
    point: ArrayLike<number>;
    normal: ArrayLike<number>;
    triangle: number;
    u: number;
    v: number;
    flags: number;
}
/** The closest point of something to a given point. */
export interface Nearest {
    model: number;
    tag: number;
    point: ArrayLike<number>;
    distance: number;
    triangle: number;
}
/** What is in a triangle array. Frozen. */
export interface MeshReport {
    triangle_count: number;
    degenerate_count: number;
    first_degenerate: number;
    out_of_range_count: number;
    first_out_of_range: number;
    bad_vertex_count: number;
    first_bad_vertex: number;
    open_edge_count: number;
}
export interface MeshDesc {
    struct_size: number;
    allocator: null;
}
/** How an octree is made up. Frozen. */
export interface OctreeStats {
    item_count: number;
    unbounded_count: number;
    node_count: number;
    leaf_count: number;
    depth: number;
    rebuilds: number;
    cost: number;
    memory_bytes: number;
}
/** One box of an octree, for drawing. Frozen. */
export interface OctreeBox {
    bounds: Aabb;
    depth: number;
    item_count: number;
}
export interface SceneDesc {
    struct_size: number;
    allocator: null;
    reserve_models: number;
    task_runner: null;
    worker_count: number;
}
export interface ModelDesc {
    struct_size: number;
    parent: number;
    layers: number;
    tag: number;
}
/** What a model is. Frozen. */
export interface ModelInfo {
    type: number;
    parent: number;
    layers: number;
    tag: number;
    child_count: number;
}
export interface CameraDesc {
    struct_size: number;
    allocator: null;
    handedness: number;
    depth_range: number;
    reverse_z: number;
    viewport_width: number;
    viewport_height: number;
}
/** Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
 * nothing depends on the frame time or on how often update is called. Frozen. */
export interface Orbit {
    target: ArrayLike<number>;
    up: ArrayLike<number>;
    distance: number;
    yaw: number;
    pitch: number;
    radians_per_unit: number;
    metres_per_unit: number;
    min_distance: number;
    max_distance: number;
    min_pitch: number;
    max_pitch: number;
}
export interface SolverDesc {
    struct_size: number;
    allocator: null;
    gravity: ArrayLike<number>;
    substeps: number;
    fixed_step: number;
    max_steps: number;
}
/** Settings shared by all kinds of bodies. */
export interface BodyDesc {
    struct_size: number;
    mass: number;
    radius: number;
    damping: number;
    friction: number;
    restitution: number;
    compliance: number;
    bend_compliance: number;
    cloth_flags: number;
    layers: number;
}
/** Frozen. */
export interface BodyInfo {
    kind: number;
    method: number;
    particle_count: number;
    constraint_count: number;
    triangle_count: number;
}
/** One constraint. Frozen. */
export interface ConstraintInfo {
    id: number;
    particle_a: number;
    particle_b: number;
    rest_length: number;
    compliance: number;
}
/** Frozen. */
export interface SolverStats {
    particle_count: number;
    pinned_count: number;
    constraint_count: number;
    contact_count: number;
    strain_max: number;
    strain_rms: number;
    kinetic_energy: number;
    potential_energy: number;
}
/** A particle that touched a model in the last step. Frozen. */
export interface Contact {
    body: number;
    particle: number;
    model: number;
    tag: number;
    point: ArrayLike<number>;
    normal: ArrayLike<number>;
}
export function sphere(center: ArrayLike<number>, radius: number): Shape;
export function capsule(a: ArrayLike<number>, b: ArrayLike<number>, radius: number): Shape;
export function aabb(min: ArrayLike<number>, max: ArrayLike<number>): Shape;
export function obb(center: ArrayLike<number>, half_extents: ArrayLike<number>, rotation: ArrayLike<number>): Shape;
export function plane(normal: ArrayLike<number>, distance: number): Shape;
export function triangle(a: ArrayLike<number>, b: ArrayLike<number>, c: ArrayLike<number>): Shape;
export function frustum(origin: ArrayLike<number>, planes: Plane[]): Shape;
export function ray(origin: ArrayLike<number>, direction: ArrayLike<number>, t_max: number): Shape;
export function segment(a: ArrayLike<number>, b: ArrayLike<number>): Shape;
export function shapes(kind: string, data: Float32Array): Shapes;
export function defaultOrbit(): Orbit;
/** Build a mesh from copies of the arrays. Triangles of zero area are kept: they are met like the
 * segments or points that they are, and counted in the report. 0 triangles are allowed.
 * @param desc  may be NULL
 * @return GPHYS_ERROR_INVALID_ARGUMENT for an index out of range, an index_count that is no
 *         multiple of 3 or a bad vertex; gphys_mesh_check tells which.
 * Cost: O(n log n), about 1 us per triangle. */
export class Mesh {
    constructor(vertices: Elements, indices: Elements, desc?: Partial<MeshDesc> | null);
    /** Frees the object at once. */
    close(): void;
    /** What the mesh was built from. */
    getReport(): MeshReport;
    /** Copy the vertices out; in their original order. */
    getVertices(): Records;
    /** Copy the indices out; in their original order. */
    getIndices(): Records;
    /** All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
     * Kept when the array is too small: the first ones.  @return GPHYS_OK (also for 0 hits) */
    raycastAll(ray: Ray): Records;
    /** Whether a ray hits anything; cheaper than the closest hit. */
    raycastAny(ray: Ray): boolean;
    /** Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
     * ascending. Kept when the array is too small: the lowest. */
    overlap(shape: Shape): Records;
    /** Cost: O(nodes). */
    getOctreeStats(): OctreeStats;
    /** Boxes of the tree, each parent before its children. Kept when too many: the first. */
    getOctreeBoxes(): Records;
}
/** With a worker_count of n, all batch queries of the scene (gphys_camera_pick_batch too), and
 * adding and moving many models, share their work among n threads; the results have the same bits
 * for every n. Without a task_runner n - 1 threads are started here and joined by
 * gphys_scene_destroy. They serve one call at a time: others that come meanwhile do their own
 * work. They take no signals but faults, and the floating-point settings of the thread that
 * created them. In a child of fork they are gone: calls there run on one thread.
 * @param desc  may be NULL
 * @return GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started */
export class Scene {
    constructor(desc?: Partial<SceneDesc> | null);
    /** Frees the object at once. */
    close(): void;
    /** Move the point of the world that all coordinates of the scene count from, those that it is given
     * and those that it returns. Models stay where they are in the world: the positions of those without
     * a parent become what they are from there, kept in double precision and rounded to float32 once,
     * however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
     * and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
     * @param origin  x, y, z in the world, within GPHYS_MAX_COORDINATE; before the first call 0 0 0
     * @return GPHYS_ERROR_INVALID_ARGUMENT also if a model would leave the range of coordinates
     * Cost: that of gphys_scene_set_transforms of all models, and 24 bytes a model from the first call
     * on. Queries cost nothing more. */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the scene's coordinates count from. */
    getOrigin(): Records;
    /** Add a model.
     * @param type       sphere, capsule, AABB, OBB, plane, triangle or mesh
     * @param shape      in the model's own coordinates
     * @param transform  local; NULL is the identity
     * @param desc       NULL: no parent, layer 1, tag 0
     * @return GPHYS_ERROR_UNSUPPORTED for another type, GPHYS_ERROR_INVALID_ID for a stale parent,
     *         GPHYS_ERROR_CAPACITY
     * Cost: O(log n) amortised. */
    add(shape: Shape, transform?: Transform | null, desc?: Partial<ModelDesc> | null): number;
    /** Add count models of one type, all or none. A stride of 0 shares one shape or transform (a mesh
     * needs shape_stride 0). transforms may be NULL. out_models has count elements. */
    addBatch(shapes: Shapes | Shape, transforms?: Elements | null, desc?: Partial<ModelDesc> | null, out?: ArrayBufferView): Records;
    /** Remove a model. Its children stay where they are in the world and lose their parent. */
    remove(model: number): void;
    /** Remove models, all or none. An id that stands twice is GPHYS_ERROR_INVALID_ID. */
    removeBatch(models: Elements): void;
    /** Remove a model and all its descendants. */
    removeSubtree(model: number): void;
    /** Remove all. Ids given out before stay invalid. */
    clear(): void;
    /** GPHYS_OK if the id names a model of this scene, else GPHYS_ERROR_INVALID_ID. */
    has(model: number): void;
    /** Ids of all models, ascending. Kept when too many: the lowest. */
    getModels(): Records;
    /** Kind, parent, layers, tag and number of children of a model. */
    getInfo(model: number): ModelInfo;
    /** World box of a model; GPHYS_UNBOUNDED for a plane. That of an empty mesh is its position. */
    getBounds(model: number): Aabb | null;
    /** World box of all bounded models; GPHYS_NO_HIT if there are none. Planes are left out. */
    getSceneBounds(): Aabb | null;
    /** Change which queries see a model, or what its hits report. Children are not affected. */
    setLayers(model: number, layers?: number): void;
    /** Change which queries see a model, or what its hits report. Children are not affected. */
    setTag(model: number, tag: number): void;
    /** Hang a model below another one, or below none (0).
     * @param keep_world  0: the local transform is kept, the model jumps; 1: the local transform is
     *                    changed so that the world transform stays (within float32 rounding)
     * @return GPHYS_ERROR_CYCLE if parent is the model or one of its descendants */
    setParent(model: number, parent: number, keep_world: number): void;
    /** Set one local transform. Descendants follow. Cost: O(log n) for each model that moves. */
    setTransform(model: number, transform: Transform): void;
    /** Set many, all or none; a model that stands twice gets the last. Cost: O(log n) for each model
     * that moves when few move, O(n) when many do. */
    setTransforms(models: Elements, transforms: Elements): void;
    /** Set many, all or none; a model that stands twice gets the last. Cost: O(log n) for each model
     * that moves when few move, O(n) when many do. */
    getTransforms(models: Elements, out?: ArrayBufferView): Records;
    /** Set many, all or none; a model that stands twice gets the last. Cost: O(log n) for each model
     * that moves when few move, O(n) when many do. */
    getWorldTransforms(models: Elements, out?: ArrayBufferView): Records;
    /** Closest model on a ray; the fields are exact as in gphys_shape_raycast.
     * @return GPHYS_OK or GPHYS_NO_HIT */
    raycast(ray: Ray, layers?: number): Hit | null;
    /** Closest model on a ray; the fields are exact as in gphys_shape_raycast.
     * @return GPHYS_OK or GPHYS_NO_HIT */
    raycastBatch(rays: Elements, layers?: number, out?: ArrayBufferView): Records;
    /** Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit. */
    raycastAny(ray: Ray, layers?: number): boolean;
    /** Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit. */
    raycastAnyBatch(rays: Elements, layers?: number, out?: ArrayBufferView): Records;
    /** Every model that a ray meets, each once with its first hit, by t, then id. Kept when too many:
     * the first. */
    raycastAll(ray: Ray, layers?: number): Records;
    /** The hits of ray i stand at out_hits[out_offsets[i]] up to out_offsets[i + 1].
     * @param out_offsets  count + 1 numbers, always complete, so that a second call can have enough
     *                     room. Where a ray's range crosses capacity, its first hits are written.
     * What stands in out_hits behind the last hit afterwards is unspecified.
     * @return GPHYS_OK, or GPHYS_INCOMPLETE if out_offsets[count] > capacity */
    raycastAllBatch(rays: Elements, layers?: number): { values: Records; offsets: Uint32Array };
    /** Closest model along a segment from a to b, both included; t in 0..1. */
    segmentTest(segment: Segment, layers?: number): Hit | null;
    /** Closest model along a segment from a to b, both included; t in 0..1. */
    segmentTestBatch(segments: Elements, layers?: number, out?: ArrayBufferView): Records;
    /** Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
     * ascending. Kept when too many: the lowest. */
    overlap(shape: Shape, layers?: number): Records;
    /** Offsets as in gphys_scene_raycast_all_batch. */
    overlapBatch(shapes: Shapes | Shape, layers?: number): { values: Records; offsets: Uint32Array };
    /** Ids of all models whose world box is not wholly outside one of a frustum's six planes or of its
     * own box, ascending: for drawing. None that is seen is missed; near the frustum's edges a few
     * per cent more are listed, which gphys_scene_overlap sorts out by testing the shapes. Kept when
     * too many: the lowest. Room for all models is best: what out_models has beyond the ids is used
     * as scratch memory to order them. */
    cull(frustum: Frustum, layers?: number): Records;
    /** The model nearest to a point, and its closest point.
     * @param max_distance  >= 0, INFINITY allowed; a model at exactly this distance counts
     * @return GPHYS_OK or GPHYS_NO_HIT */
    nearest(point: ArrayLike<number>, max_distance: number, layers?: number): Nearest | null;
    /** The model nearest to a point, and its closest point.
     * @param max_distance  >= 0, INFINITY allowed; a model at exactly this distance counts
     * @return GPHYS_OK or GPHYS_NO_HIT */
    nearestBatch(points: Elements, max_distance: number, layers?: number, out?: ArrayBufferView): Records;
    /** First model that a sphere touches while it moves by displacement; t in 0..1.
     * Fields as in gphys_shape_sweep_sphere. */
    sweepSphere(sphere: Sphere, displacement: ArrayLike<number>, layers?: number): Hit | null;
    /** First model that a sphere touches while it moves by displacement; t in 0..1.
     * Fields as in gphys_shape_sweep_sphere. */
    sweepSphereBatch(spheres: Elements, displacements: Elements, layers?: number, out?: ArrayBufferView): Records;
    /** Cost: O(nodes). */
    getOctreeStats(): OctreeStats;
    /** Boxes of the tree, each parent before its children. Kept when too many: the first. */
    getOctreeBoxes(): Records;
    /** Check the scene's own structure: every model once in the tree, every box around its content,
     * parents and children in agreement, free slots free. For tests; O(n).
     * @return GPHYS_OK, or GPHYS_ERROR_INTERNAL and gphys_last_error() says what is wrong */
    validate(): void;
}
/** @param desc  may be NULL */
export class Camera {
    constructor(desc?: Partial<CameraDesc> | null);
    /** Frees the object at once. */
    close(): void;
    /** Move the point of the world that the camera's coordinates count from; see gphys_scene_set_origin.
     * The camera and the target of its orbit stay where they are in the world. Picking and culling need a
     * scene of the same origin, else they return GPHYS_ERROR_INVALID_ARGUMENT. */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the camera's coordinates count from. */
    getOrigin(): Records;
    /** @param fov_y  full vertical angle, 1e-6 <= fov_y < pi
     * @param near_distance  > 0
     * @param far_distance   > near_distance; INFINITY allowed */
    setPerspective(fov_y: number, near_distance: number, far_distance: number): void;
    /** @param height  metres seen from top to bottom, >= 1e-6; the width follows from the viewport
     * @param near_distance, far_distance  far at least 1e-6 above near, which may be negative */
    setOrthographic(height: number, near_distance: number, far_distance: number): void;
    /** Any projection matrix of the camera's depth range and direction (off-centre, oblique, another
     * library's). It is not changed by gphys_camera_set_viewport.
     * @return GPHYS_ERROR_SINGULAR if it has no inverse, or is too close to such a matrix to tell;
     *         GPHYS_ERROR_INVALID_ARGUMENT if a plane other than far lies at infinity, as it does when
     *         the matrix is for another depth range */
    setProjection(projection: ArrayLike<number>): void;
    /** The viewport was resized: pixels, 1e-3 .. 1e6. Perspective keeps fov_y, orthographic its height. */
    setViewport(width: number, height: number): void;
    /** Place the camera. */
    setTransform(position: ArrayLike<number>, rotation: ArrayLike<number>): void;
    /** Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
     * kept, then up), so that a matrix which drifted is mended.
     * @return GPHYS_ERROR_SINGULAR if the axes do not span space, GPHYS_ERROR_INVALID_ARGUMENT if
     *         they mirror or the last row is not 0 0 0 1 */
    setWorldMatrix(world: ArrayLike<number>): void;
    /** Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
     * chosen in its place, always the same for the same input.
     * @return GPHYS_ERROR_INVALID_ARGUMENT if eye equals target or up is zero */
    lookAt(eye: ArrayLike<number>, target: ArrayLike<number>, up: ArrayLike<number>): void;
    /** Where the camera stands and how it is turned. */
    getTransform(): [ArrayLike<number>, ArrayLike<number>];
    /** Camera to world. */
    getWorldMatrix(): ArrayLike<number>;
    /** World to camera: the transpose of the orthonormal world axes, and the position through them. */
    getViewMatrix(): ArrayLike<number>;
    /** Camera to clip space. */
    getProjectionMatrix(): ArrayLike<number>;
    /** Projection * view, multiplied in double precision and rounded once. */
    getViewProjectionMatrix(): ArrayLike<number>;
    /** Start orbiting with these settings; places the camera at once and drops pending input. An angle
     * or a distance outside its limits is brought inside. */
    setOrbit(orbit: Orbit): void;
    /** The present settings, angles and distance.
     * @return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit */
    getOrbit(): Orbit;
    /** Add input: yaw by units_x, pitch by units_y, times radians_per_unit. Finite, any size. */
    orbitRotate(units_x: number, units_y: number): void;
    /** Add input: come closer by units times metres_per_unit (go back if negative). */
    orbitZoom(units: number): void;
    /** Add input: move the target to the camera's right and up, as the last update left them, by units
     * times metres_per_unit. */
    orbitPan(units_right: number, units_up: number): void;
    /** Apply the input since the last update, within the limits, and place the camera. Angles are
     * wrapped to -pi .. pi in constant time. The orbit's settings must have been set. */
    orbitUpdate(): void;
    /** The seen volume, with origin at the camera's position and planes from its parameters: each
     * number within 2 ulp. A user projection gives its planes by Gribb-Hartmann in double. */
    getFrustum(): Frustum;
    /** World positions of its corners, in the order of gphys_frustum_corners.
     * @return GPHYS_UNBOUNDED with an infinite far plane */
    getCorners(): Records | null;
    /** World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the viewport; z is the
     * depth in the camera's range.
     * @return GPHYS_NO_HIT if the point is not in front of the camera's centre (no image), or its
     *         image lies beyond the range of coordinates */
    project(point: ArrayLike<number>): ArrayLike<number> | null;
    /** The same for count points; a point without an image gets x = y = z = INFINITY. */
    projectBatch(points: Elements, out?: ArrayBufferView): Records;
    /** Pixel and depth to world point: the inverse of gphys_camera_project.
     * @return GPHYS_UNBOUNDED for the depth of an infinite far plane, and for points beyond that or
     *         beyond the range of coordinates */
    unproject(pixel: ArrayLike<number>): ArrayLike<number> | null;
    /** The same for count pixels; one at infinity gets x = y = z = INFINITY. */
    unprojectBatch(pixels: Elements, out?: ArrayBufferView): Records;
    /** The ray through a pixel, of unit direction. It starts at the camera's position (perspective) or
     * on the near plane (orthographic, user) and t_max ends on the far plane (INFINITY without one).
     * Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, as
     * near as half an ulp of a direction can be; gphys_camera_pick is not so limited.
     * For perspective the stretch before the near plane is part of the ray. Pixels outside the
     * viewport are allowed.
     * @return GPHYS_UNBOUNDED if the line of sight does not meet the near plane (user projections) */
    pickRay(pixel_x: number, pixel_y: number): Ray | null;
    /** Rays for a rectangle of pixel centres, row by row: width * height rays, fewer than 2^32. */
    pickRays(x: number, y: number, width: number, height: number, out?: ArrayBufferView): Records;
    /** The model under a pixel: the first hit of gphys_camera_pick_ray, before that is rounded to
     * float32; t is in metres.
     * @return GPHYS_OK or GPHYS_NO_HIT */
    pick(scene: Scene, pixel_x: number, pixel_y: number, layers?: number): Hit | null;
    /** The same for count pixels, given as x, y pairs of floats. Misses as in the scene's batches. */
    pickBatch(scene: Scene, pixels: Elements, layers?: number, out?: ArrayBufferView): Records;
    /** Marquee: ids of all models that show or would show, were nothing in front of them, in the pixel
     * rectangle, between near and far plane; exact shapes, ascending. Corners in any order.
     * @return GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area */
    pickRectangle(scene: Scene, x0: number, y0: number, x1: number, y1: number, layers?: number): Records;
    /** gphys_scene_cull with the camera's frustum. */
    cull(scene: Scene, layers?: number): Records;
}
/** @param desc  may be NULL */
export class Solver {
    constructor(desc?: Partial<SolverDesc> | null);
    /** Frees the object at once. */
    close(): void;
    /** Move the point of the world that the coordinates of all particles count from; see
     * gphys_scene_set_origin. Particles stay where they are in the world and keep moving as they do. A
     * step and an attachment need a scene of the same origin, else they return
     * GPHYS_ERROR_INVALID_ARGUMENT. Cost: O(particles). */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the particles' coordinates count from. */
    getOrigin(): Records;
    /** m/s^2, from the next step on. */
    setGravity(gravity: ArrayLike<number>): void;
    /** 1 .. 1000. More substeps: smaller errors, proportionally more time. */
    setSubsteps(substeps: number): void;
    /** Add particles without constraints.
     * @param desc  may be NULL
     * @param positions  count elements, count >= 1 */
    addParticles(positions: Elements, desc?: Partial<BodyDesc> | null): number;
    /** Add a rope through the given points, one particle at each.
     * @param count  >= 2
     * @param link_length  rest length of each link in metres; 0: as placed */
    addRope(positions: Elements, link_length: number, desc?: Partial<BodyDesc> | null): number;
    /** Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
     * corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v.
     * @param columns, rows  >= 2 */
    addCloth(corner: ArrayLike<number>, edge_u: ArrayLike<number>, edge_v: ArrayLike<number>, columns: number, rows: number, desc?: Partial<BodyDesc> | null): number;
    /** Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and
     * with GPHYS_CLOTH_BEND one across each inner edge. Vertices at the same place stay separate.
     * @param transform  places the mesh; may be NULL */
    addClothMesh(mesh: Mesh, transform?: Transform | null, desc?: Partial<BodyDesc> | null): number;
    /** Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and
     * with GPHYS_CLOTH_BEND one across each inner edge. Vertices at the same place stay separate.
     * @param transform  places the mesh; may be NULL */
    removeBody(body: number): void;
    /** Ids of all bodies, ascending. Kept when too many: the lowest. */
    getBodies(): Records;
    /** What a body is made of and how it is solved. */
    getBodyInfo(body: number): BodyInfo;
    /** Particle numbers of a cloth's triangles, three each; total counts numbers, not triangles. */
    getTriangles(body: number): Records;
    /** Metres. */
    getPositions(body: number, first: number, count: number, out?: ArrayBufferView): Records;
    /** Moves particles there at once and without collision on the way; velocities stay as they are. */
    setPositions(body: number, first: number, positions: Elements): void;
    /** m/s */
    getVelocities(body: number, first: number, count: number, out?: ArrayBufferView): Records;
    /** m/s */
    setVelocities(body: number, first: number, velocities: Elements): void;
    /** kg, > 0. A pinned particle keeps its mass for the time when it is released. */
    getMasses(body: number, first: number, count: number, out?: ArrayBufferView): Records;
    /** kg, > 0. A pinned particle keeps its mass for the time when it is released. */
    setMasses(body: number, first: number, masses: Elements): void;
    /** Collision radius, metres, >= 0. */
    setRadii(body: number, first: number, radii: Elements): void;
    /** Forces in newtons that act beside gravity, from now on until set again. */
    setForces(body: number, first: number, forces: Elements): void;
    /** Pin (1) or release (0) a range. A pinned particle stays where it is put and moves only by
     * gphys_solver_set_positions; its speed is 0. Both pinning and releasing end an attachment. */
    setPinned(body: number, first: number, count: number, pinned: number): void;
    /** Fix a particle to a model: it follows the model's transform in each step, and is released when
     * the model is gone. Steps must then be given this scene.
     * @param local_point  in the model's coordinates; NULL: where the particle is now */
    attach(scene: Scene, body: number, particle: number, model: number, local_point?: ArrayLike<number> | null): void;
    /** Release an attached particle.
     * @return GPHYS_ERROR_INVALID_ARGUMENT if it is not attached */
    detach(body: number, particle: number): void;
    /** Hold two different particles of a body at a distance.
     * @param rest_length  metres, >= 0; negative: the present distance
     * @param compliance   metres per newton, >= 0; 0 is rigid
     * @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same one */
    addDistance(body: number, particle_a: number, particle_b: number, rest_length: number, compliance: number): number;
    /** Hold two different particles of a body at a distance.
     * @param rest_length  metres, >= 0; negative: the present distance
     * @param compliance   metres per newton, >= 0; 0 is rigid
     * @return GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same one */
    removeConstraint(body: number, constraint: number): void;
    /** All constraints of a body, those of its builder included, by id. Kept when too many: the lowest. */
    getConstraints(body: number): Records;
    /** Simulate dt seconds in the set number of substeps; cloth takes more where they would be longer
     * than 25 ms.
     * @param scene  to collide with and to follow attachments; NULL: none. Not modified.
     * @param dt     1e-6 .. 0.5
     * Particles do not pass through models, whatever their speed. Cost: O(particles + constraints)
     * substeps, and a scene query for particles near models. */
    step(scene: Scene | null, dt: number): void;
    /** Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next
     * frame, so the motion does not depend on the frame rate.
     * @param frame_time    seconds, >= 0
     * @param out_steps     steps made; may be NULL
     * @param out_leftover  0 <= fraction of a step still owed < 1, to blend drawings; may be NULL */
    advance(scene: Scene | null, frame_time: number): [number, number];
    /** @param body  0: all bodies together.  Cost: O(particles + constraints). */
    getStats(body: number): SolverStats;
    /** Contacts of the last step by body, particle, model. Kept when too many: the first. */
    getContacts(): Records;
    /** Copy the whole state out: settings, origin, bodies with their ids, constraints and contacts, time
     * that gphys_solver_advance still owes. The scene, workers and allocator are not in it.
     * @param out_words  the snapshot; written as a whole, or not at all when capacity is too small. It is
     *                   for the same release of the library and machines of the same byte order; it may
     *                   be stored, but not changed.
     * @return GPHYS_INCOMPLETE when *out_total > capacity; GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words
     * Cost: O(particles + constraints), some 50 words for each. */
    getSnapshot(): Records;
    /** Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
     * time of the snapshot. Steps go on with the same bits as they did then, provided that the scene,
     * too, is as it was.
     * @return GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot, damaged, of another version or
     *         byte order; GPHYS_ERROR_OUT_OF_MEMORY. Either way the solver is as before.
     * Cost: as gphys_solver_get_snapshot; allocates. */
    restore(words: Elements): void;
    /** A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
     * different ones differ with near certainty (not against an adversary). Compare it between machines
     * that simulate the same, to see when they part. Cost: O(particles + constraints). */
    getHash(): Records;
}
/** Whether the shape fulfils the ranges beside its struct.
 * @return GPHYS_OK, or GPHYS_ERROR_INVALID_ARGUMENT and gphys_last_error() names the field. */
export function validate(shape: Shape): void;
/** The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
 * @return GPHYS_OK; GPHYS_UNBOUNDED for a plane, a ray without end (or with one beyond all floats)
 *         and a frustum that extends to infinity; GPHYS_NO_HIT for an empty mesh or frustum */
export function bounds(shape: Shape): Aabb | null;
/** Whether the point is within tolerance metres of the shape (solid or surface).
 * With tolerance 0 the answer is exact: on the plane, on the segment, inside the box (an OBB's
 * axes are those of its rotation in double precision).
 * @param tolerance  >= 0
 * @param out_contains  0 or 1 */
export function contains(shape: Shape, point: ArrayLike<number>, tolerance: number): boolean;
/** Whether the point is within tolerance metres of the shape (solid or surface).
 * With tolerance 0 the answer is exact: on the plane, on the segment, inside the box (an OBB's
 * axes are those of its rotation in double precision).
 * @param tolerance  >= 0
 * @param out_contains  0 or 1 */
export function containsBatch(shape: Shape, points: Elements, tolerance: number, out?: ArrayBufferView): Records;
/** The point of the shape that is closest to the given point: the point itself inside a solid.
 * Error: 1 ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest
 * coordinate difference. If several are equally close, one of them,
 * always the same. For a ray, t is limited by t_max.
 * @return GPHYS_NO_HIT only for an empty mesh or an empty frustum. */
export function closestPoint(shape: Shape, point: ArrayLike<number>): Nearest | null;
/** The same for count points. An element for which there is none gets distance INFINITY. */
export function closestPointBatch(shape: Shape, points: Elements, out?: ArrayBufferView): Records;
/** The closest points of two segments and their distance. Parallel segments have many: the first
 * along a, always the same. out_a, out_b, out_distance may each be NULL. */
export function segmentClosestPoints(a: Segment, b: Segment): [ArrayLike<number>, ArrayLike<number>, number];
/** Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane,
 * triangle, frustum and mesh, in either order.
 * A mesh is its surface: a sphere deep inside a closed mesh does not overlap it.
 * Exact between AABBs, planes, triangles, meshes and frusta; other pairs are decided in double
 * precision and may err only where the gap is below 2^-40 of the largest coordinate difference.
 * @return GPHYS_ERROR_UNSUPPORTED for a ray or segment (see gphys_shape_segment_test). */
export function overlaps(a: Shape, b: Shape): boolean;
/** Pair i is a[i] against b[i]; a stride of 0 tests one shape against many. A mesh needs 0. */
export function overlapsBatch(a: Shapes | Shape, b: Shapes | Shape, out?: ArrayBufferView): Records;
/** Classify a sphere, capsule, AABB, OBB or triangle against a plane.
 * @param out_signed_distance  of the shape's nearest point to the plane: > 0 in front, < 0
 *                             behind, 0 when crossing; may be NULL */
export function classifyPlane(shape: Shape, plane: Plane): [number, number];
/** Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means
 * that no point is shared, inside that the frustum holds the whole shape. */
export function classifyFrustum(shape: Shape, frustum: Frustum): number;
/** First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh.
 * Triangles and meshes are hit from both sides, and meshes are watertight: a ray through a
 * shared edge or vertex always meets one of the triangles there.
 * Error: t within 1 ulp. No false miss and no false hit at all for spheres, triangles, meshes, AABBs
 * and planes; for capsules none but within 2^-48 of the distance. An OBB is met where one larger or
 * smaller by 2^-40 of the distance would be. docs/accuracy.md has the bounds of all functions.
 * @return GPHYS_OK or GPHYS_NO_HIT */
export function raycast(shape: Shape, ray: Ray): Hit | null;
/** The same for count rays. A ray that hits nothing gets t = INFINITY and zeros in its out_hits
 * element.  @return GPHYS_OK */
export function raycastBatch(shape: Shape, rays: Elements, out?: ArrayBufferView): Records;
/** First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly.
 * A segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, which
 * then is met from no direction, the normal is zero.
 * @return GPHYS_OK or GPHYS_NO_HIT */
export function segmentTest(shape: Shape, segment: Segment): Hit | null;
/** First contact of a sphere that moves by displacement (which may be zero) with a sphere,
 * capsule, AABB, OBB, plane, triangle, frustum or mesh.
 * @param out_hit  t in 0..1 of the displacement; point: of contact, on the shape; normal: from
 *                 the point to the sphere's centre. Already overlapping: t = 0, GPHYS_HIT_INSIDE,
 *                 and where the centre itself is in a solid, the normal is opposite to the
 *                 displacement (zero if that is zero).
 * Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
 * Cost: a frustum, approached step by step, takes about 10 us.
 * @return GPHYS_OK or GPHYS_NO_HIT */
export function sweepSphere(shape: Shape, sphere: Sphere, displacement: ArrayLike<number>): Hit | null;
/** The eight corners, each the intersection of three planes: near then far, each in the order
 * left-bottom, right-bottom, right-top, left-top.
 * @return GPHYS_UNBOUNDED if three planes do not meet in a point (infinite far plane) */
export function frustumCorners(frustum: Frustum): Records | null;
/** The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
 * origin (0, 0, 0). A camera knows its frustum better: gphys_camera_get_frustum.
 * @param reverse_z  0: near has the low depth; 1: near has the high depth
 * @return GPHYS_ERROR_SINGULAR if the matrix has no volume */
export function frustumFromMatrix(view_projection: ArrayLike<number>, depth_range: number, reverse_z: number): Frustum;
/** Examine arrays without building anything. Allocates while it runs. Cost: O(n log n).
 * @param vertices       vertex_count elements of 3 floats
 * @param vertex_stride  bytes between vertices, at least 12
 * @param indices        index_count numbers, three for each triangle */
export function meshCheck(vertices: Elements, indices: Elements): MeshReport;
export const OK: 0;
export const NO_HIT: 1;
export const INCOMPLETE: 2;
export const UNBOUNDED: 3;
export const ERROR_INVALID_ARGUMENT: -1;
export const ERROR_INVALID_ID: -2;
export const ERROR_STRUCT_SIZE: -3;
export const ERROR_OUT_OF_MEMORY: -4;
export const ERROR_CAPACITY: -5;
export const ERROR_CYCLE: -6;
export const ERROR_UNSUPPORTED: -7;
export const ERROR_SINGULAR: -8;
export const ERROR_INTERNAL: -100;
export const FRUSTUM_NEAR: 0;
export const FRUSTUM_FAR: 1;
export const FRUSTUM_LEFT: 2;
export const FRUSTUM_RIGHT: 3;
export const FRUSTUM_BOTTOM: 4;
export const FRUSTUM_TOP: 5;
export const HIT_INSIDE: 1;
export const HIT_BACK: 2;
export const SHAPE_SPHERE: 1;
export const SHAPE_CAPSULE: 2;
export const SHAPE_AABB: 3;
export const SHAPE_OBB: 4;
export const SHAPE_PLANE: 5;
export const SHAPE_TRIANGLE: 6;
export const SHAPE_FRUSTUM: 7;
export const SHAPE_MESH: 8;
export const SHAPE_RAY: 16;
export const SHAPE_SEGMENT: 17;
export const SIDE_OUTSIDE: -1;
export const SIDE_CROSSING: 0;
export const SIDE_INSIDE: 1;
export const DEPTH_ZERO_TO_ONE: 0;
export const DEPTH_MINUS_ONE_TO_ONE: 1;
export const PROJECTION_PERSPECTIVE: 0;
export const PROJECTION_ORTHOGRAPHIC: 1;
export const PROJECTION_USER: 2;
export const LEFT_HANDED: 0;
export const RIGHT_HANDED: 1;
export const CLOTH_SHEAR: 1;
export const CLOTH_BEND: 2;
export const BODY_PARTICLES: 1;
export const BODY_ROPE: 2;
export const BODY_CLOTH: 3;
export const SOLVE_FREE: 0;
export const SOLVE_DIRECT: 1;
export const SOLVE_GRAPH: 2;
export const VERSION_MAJOR: number;
export const VERSION_MINOR: number;
export const VERSION_PATCH: number;
export const MAX_COORDINATE: number;
export const NO_TRIANGLE: number;
export const ALL_LAYERS: number;
