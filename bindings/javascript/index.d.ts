// Generated from gamephys_api.json by bindings/generate.py. Not for editing.

declare global {
    /** As newer libraries of TypeScript declare it, for those who have an older one. */
    interface SymbolConstructor { readonly dispose: unique symbol }
}

/** A vector or a quaternion: its numbers, or an object that has them by name, as in three.js. */
export type Vector = ArrayLike<number> | { readonly x: number; readonly y: number; readonly z: number; readonly w?: number };
/** Sixteen numbers column by column, or an object that has them, as in three.js. */
export type Matrix = ArrayLike<number> | { readonly elements: ArrayLike<number> } | Mat4;
/** What can be given for a struct: its fields by name, or in order as an array. */
export type Given<T> = T extends number ? number
    : T extends number[] ? Vector
    : T extends readonly (infer E)[] ? readonly Given<E>[]
    : T extends Transform ? { [K in keyof T]?: Given<T[K]> } | readonly unknown[] | ArrayLike<number>
    : T extends Ray ? Omit<{ [K in keyof T]: Given<T[K]> }, 't_max'> & { t_max?: number } | readonly unknown[] | ArrayLike<number>
    : { [K in keyof T]: Given<T[K]> } | readonly unknown[] | ArrayLike<number>;
/** Elements of a batch: rows of four-byte numbers, one after the other. */
export type Elements = Float32Array | Uint32Array | Int32Array | Uint8Array | Records;
/** The same, of floats only. */
export type Floats = Float32Array | Uint8Array | Records;
/** The same, of whole numbers only. Uint16Array is copied. */
export type Words = Uint32Array | Int32Array | Uint16Array | Uint8Array | Records;
/** A shape for a question about it. */
export type AnyShape = Shape | Mesh;

/** Rows of one kind of struct or number: views of all of them as numbers, and each as an object. */
export class Records<T = any> {
    private constructor();
    readonly kind: Kind;
    readonly length: number;
    /** Bytes from one to the next. */
    readonly stride: number;
    /** Views of the same memory. Take them afresh, and do not keep them, where it is the library's:
     *  a view of WebAssembly's memory has no elements any more once that has grown. */
    readonly f32: Float32Array;
    readonly u32: Uint32Array;
    readonly i32: Int32Array;
    /** Where the memory begins and ends on multiples of eight bytes. */
    readonly f64: Float64Array;
    get(index: number): T;
    set(index: number, value: Given<T>): void;
    [Symbol.iterator](): Iterator<T>;
    /** The elements, for JSON. Records are not cloned: post f32.slice() or u32.slice(). */
    toJSON(): T[];
    /** Gives the library's memory back at once. */
    close(): void;
    [Symbol.dispose](): void;
}
/** Memory that calls read and write in place, without a copy. All is 0, but rays have no end: their t_max is Infinity. */
export function records<K extends Kind>(kind: K, length: number): Records<Kinds[K]>;

export class Shape {
    private constructor();
    readonly kind: string;
    readonly type: number;
    readonly data: Float32Array;
    /** Its fields by name. */
    readonly value: any;
}
/** Many shapes of one kind. */
export class Shapes {
    private constructor();
    readonly kind: string;
    readonly type: number;
}
/** A call failed: the message is the library's, status its number. */
export class GamephysError extends Error { readonly status: number }
/** An object was used after close(). */
export class GamephysClosed extends Error {}

/** The library's version, such as "1.0.0". */
export function version(): string;
/** The name of a status, such as "GPHYS_NO_HIT". */
export function statusName(status: number): string;
/** The orbit settings that the library starts from. */
export function defaultOrbit(): Orbit;
/** A shape moved; that of a box along the axes is a turned box. */
export function transform(shape: Shape, by: Given<Transform>): Shape;

export interface Vec3 {
    x: number;
    y: number;
    z: number;
}
export interface Quat {
    /** rotation of angle a about unit axis n: (n sin(a/2), cos(a/2)) */
    x: number;
    /** rotation of angle a about unit axis n: (n sin(a/2), cos(a/2)) */
    y: number;
    /** rotation of angle a about unit axis n: (n sin(a/2), cos(a/2)) */
    z: number;
    /** rotation of angle a about unit axis n: (n sin(a/2), cos(a/2)) */
    w: number;
}
export interface Mat4 {
    /** element (row, column) is m[4 * column + row] */
    m: number[];
}
/** x -> position + rotation * (scale * x); scale > 0. */
export interface Transform {
    position: number[];
    rotation: number[];
    scale: number;
}
export interface Ray {
    origin: number[];
    /** any non-zero length */
    direction: number[];
    /** >= 0, in multiples of direction; INFINITY allowed */
    t_max: number;
}
export interface Segment {
    /** may coincide: a point */
    a: number[];
    /** may coincide: a point */
    b: number[];
}
export interface Sphere {
    center: number[];
    /** >= 0 */
    radius: number;
}
/** All points within radius of the segment a b. */
export interface Capsule {
    /** may coincide: a sphere */
    a: number[];
    /** may coincide: a sphere */
    b: number[];
    /** >= 0 */
    radius: number;
}
export interface Aabb {
    /** min <= max on each axis; equality gives a flat box */
    min: number[];
    /** min <= max on each axis; equality gives a flat box */
    max: number[];
}
export interface Obb {
    center: number[];
    /** >= 0, along the axes of rotation */
    half_extents: number[];
    rotation: number[];
}
/** The points x with dot(normal, x) = distance. The normal points to the front; it need not be
 * exactly unit: signed distances are divided by its length (for a unit normal, distance is the
 * plane's distance from the origin). distance divided by that length is within the range of
 * coordinates too. */
export interface Plane {
    /** not zero */
    normal: number[];
    distance: number;
}
/** May be degenerate: then it is the segment or point that its corners span. The normal is that
 * of cross(b - a, c - a). */
export interface Triangle {
    a: number[];
    b: number[];
    c: number[];
}
/** The points x with dot(planes[i].normal, x - origin) >= planes[i].distance for all six planes,
 * which look inward, in the order of FRUSTUM_NEAR, FAR and so on. Distances count from origin, so that a
 * frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1. */
export interface Frustum {
    origin: number[];
    planes: Plane[];
}
/** Where a ray, segment or swept sphere first meets something. */
export interface Hit {
    /** id of the model, 0 when the query was not of a scene */
    model: number;
    /** the model's tag, 0 likewise */
    tag: number;
    /** 0 .. t_max; along a segment or sweep 0 .. 1 */
    t: number;
    /** where the surfaces meet */
    point: number[];
    /** unit, against the motion: dot(normal, direction) <= 0, for rays up to rounding */
    normal: number[];
    /** index within a mesh, else NO_TRIANGLE */
    triangle: number;
    /** barycentric weights of b and c of a triangle, else 0 */
    u: number;
    /** barycentric weights of b and c of a triangle, else 0 */
    v: number;
    /** hit values */
    flags: number;
}
/** The closest point of something to a given point. */
export interface Nearest {
    /** as in Hit */
    model: number;
    tag: number;
    /** equal to the query point when that is inside a solid */
    point: number[];
    /** 0 inside a solid */
    distance: number;
    /** index within a mesh, else NO_TRIANGLE */
    triangle: number;
}
/** How far a ray goes and what it hits: fields of a Hit. Frozen.  Since 1.1. */
export interface Distance {
    /** in multiples of the direction, so metres where its length is 1; INFINITY: nothing is hit */
    t: number;
    /** as in Hit */
    model: number;
    triangle: number;
}
/** How a solid gets out of something that it overlaps. */
export interface Penetration {
    /** as in Hit */
    model: number;
    tag: number;
    /** on what is overlapped: where the two touch when the solid has gone depth along normal */
    point: number[];
    /** unit: the way out, from what is overlapped to the solid */
    normal: number[];
    /** metres along normal; 0 for shapes that touch */
    depth: number;
    /** index within a mesh, else NO_TRIANGLE */
    triangle: number;
}
/** What is in a triangle array. Frozen. */
export interface MeshReport {
    triangle_count: number;
    /** triangles of exactly zero area */
    degenerate_count: number;
    /** index of the first, or NO_TRIANGLE */
    first_degenerate: number;
    /** triangles with an index >= vertex_count */
    out_of_range_count: number;
    first_out_of_range: number;
    /** vertices that are not finite or beyond MAX_COORDINATE */
    bad_vertex_count: number;
    /** or 0xffffffff */
    first_bad_vertex: number;
    /** edges that do not join exactly two triangles; 0 for a closed mesh */
    open_edge_count: number;
}
export interface MeshDesc {
    /** 1: Mesh.setVertices will be called; 12 bytes a vertex more. Since 1.1 */
    deformable: number;
}
/** What a mesh is. Frozen.  Since 1.1. */
export interface MeshInfo {
    kind: number;
    vertex_count: number;
    triangle_count: number;
    /** 1: as MeshDesc.deformable, or in the form of a body */
    deformable: number;
    /** 1: its form comes from a body, not from Mesh.setVertices */
    follows_body: number;
}
/** How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
 * eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen. */
export interface OctreeStats {
    /** models or triangles in the tree */
    item_count: number;
    /** models of infinite extent, kept beside the tree */
    unbounded_count: number;
    node_count: number;
    leaf_count: number;
    /** levels; 0 when empty */
    depth: number;
    /** times it was rebuilt as a whole by one call since creation */
    rebuilds: number;
    /** expected node and item tests of a random ray that meets the root box */
    cost: number;
    /** of the tree; saturates at 2^32 - 1 */
    memory_bytes: number;
}
/** One box of an octree, for drawing. Frozen. */
export interface OctreeBox {
    bounds: Aabb;
    /** 0 is the root */
    depth: number;
    /** 0 for an inner node */
    item_count: number;
}
export interface SceneDesc {
    /** models to make room for at once; 0 */
    reserve_models: number;
    /** threads for one call, including the caller's, at most 1024; 0 and 1: that alone */
    worker_count: number;
}
export interface ModelDesc {
    /** 0: none */
    parent: number;
    /** a query with mask m sees the model if layers & m; default 1 */
    layers: number;
    /** any number of the caller's, returned with each hit; 0 */
    tag: number;
    /** as Scene.setScale sets it; 1 1 1, and 0 0 0 is the same. Since 1.1 */
    scale: number[];
}
/** What a model is. Frozen. */
export interface ModelInfo {
    type: number;
    /** 0: none */
    parent: number;
    layers: number;
    tag: number;
    /** direct children */
    child_count: number;
}
/** Which models a query sees. Ids that name no model leave out nothing and are not an error: the
 * model that asked may have been removed since. */
export interface QueryFilterDesc {
    /** a model is seen if its own mask shares a bit; default ALL_LAYERS */
    layers: number;
    /** left out; 0: none; default 0 */
    ignored_model: number;
    /** filter values; default 0 */
    flags: number;
    /** left out as well, in any order; read during the call; default null */
    ignored_models: readonly number[] | Words | null;
}
export interface CameraDesc {
    handedness: number;
    depth_range: number;
    /** 1: near has the high depth, for float depth buffers */
    reverse_z: number;
    /** pixels, 1e-3 .. 1e6 */
    viewport_width: number;
    viewport_height: number;
}
/** Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
 * nothing depends on the frame time or on how often update is called. Frozen. */
export interface Orbit {
    target: number[];
    /** any non-zero length; pitch is measured against it */
    up: number[];
    /** metres from target, > 0 */
    distance: number;
    /** radians; yaw 0 looks along the reference direction that is
     * perpendicular to up (+Z for up = +Y), yaw > 0 to the right of
     * it; pitch > 0 looks down */
    yaw: number;
    /** radians; yaw 0 looks along the reference direction that is
     * perpendicular to up (+Z for up = +Y), yaw > 0 to the right of
     * it; pitch > 0 looks down */
    pitch: number;
    /** of Camera.orbitRotate */
    radians_per_unit: number;
    /** of Camera.orbitZoom and _pan */
    metres_per_unit: number;
    /** 0 < min <= max; max INFINITY allowed */
    min_distance: number;
    /** 0 < min <= max; max INFINITY allowed */
    max_distance: number;
    /** within -pi/2 .. pi/2 */
    min_pitch: number;
    /** within -pi/2 .. pi/2 */
    max_pitch: number;
}
/** What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1. */
export interface OrbitSpeeds {
    /** radians a unit, of yaw and pitch */
    rotate_x: number;
    /** radians a unit, of yaw and pitch */
    rotate_y: number;
    /** metres a unit */
    zoom: number;
    /** metres a unit, to the right and up */
    pan_x: number;
    /** metres a unit, to the right and up */
    pan_y: number;
}
export interface SolverDesc {
    /** m/s^2; default (0, -9.81, 0) */
    gravity: number[];
    /** of one step, 1 .. 1000; default 8; with error targets: of the first step */
    substeps: number;
    /** seconds simulated by each step of Solver.advance; 1/60 */
    fixed_step: number;
    /** most steps of one advance; time beyond is dropped; 8 */
    max_steps: number;
    /** threads for one step, including the caller's, at most 1024; 0 and 1: that alone */
    worker_count: number;
    /** m/s, see Solver.getSleeping; 0: bodies never sleep; default 0 */
    sleep_speed: number;
    /** of rigid constraints, |length / rest length - 1|; those of rest length 0 are measured by
     * the mean rest length of the body's rigid constraints; default 0.01 */
    sleep_strain: number;
    /** seconds; default 0.5 */
    sleep_time: number;
    /** of rigid constraints, see Solver.getSubsteps; 0: none, for cloth 0.02; default 0 */
    max_strain: number;
    /** target of positions: metres of error that a second of motion adds; 0: none; default 0 */
    tolerance: number;
    /** the most that a target may ask for, 1 .. 1000; default 64 */
    max_substeps: number;
    /** see SolverSettings; 0: no bound; default 0 */
    max_work: number;
}
/** What a solver was created with and may change later. Fields as in SolverDesc. Frozen. */
export interface SolverSettings {
    /** m/s^2 */
    gravity: number[];
    /** 1 .. 1000 */
    substeps: number;
    /** seconds, 1e-6 .. 0.5 */
    fixed_step: number;
    /** >= 1 */
    max_steps: number;
    /** m/s, >= 0 */
    sleep_speed: number;
    /** >= 0 */
    sleep_strain: number;
    /** seconds, >= 0 */
    sleep_time: number;
    /** >= 0 */
    max_strain: number;
    /** m/s, >= 0 */
    tolerance: number;
    /** 1 .. 1000 */
    max_substeps: number;
    /** most particles times substeps of a step; 0: no bound. If bodies need more, all take fewer
     * substeps in proportion, at least one, and cloth at least one for each 25 ms. It bounds
     * work, not time, so the bits are the same on every machine */
    max_work: number;
}
/** Settings shared by all kinds of bodies. */
export interface BodyDesc {
    /** kg of the whole body, spread evenly; > 0; default 1 */
    mass: number;
    /** of each particle for collision, metres, >= 0; default 0.01 */
    radius: number;
    /** rate in 1/s: velocities decay as exp(-damping t); >= 0; default 0 */
    damping: number;
    /** Coulomb coefficient against models, >= 0; default 0.5 */
    friction: number;
    /** speed kept in a bounce, 0 .. 1; default 0 */
    restitution: number;
    /** of stretch, metres per newton, >= 0; 0 is inextensible; default 0 */
    compliance: number;
    /** of CLOTH_BEND constraints, m/N; default 0.001 */
    bend_compliance: number;
    /** cloth values; default SHEAR | BEND */
    cloth_flags: number;
    /** mask of the models it collides with; 0: none; default all */
    layers: number;
    /** of particles at rest on a model, slower than after a fall of 4e-4 radii; at least
     * friction, or 0: as friction; default 0 */
    static_friction: number;
    /** 1: its particles collide with one another, see below; default 0 */
    self_collision: number;
    /** two bodies collide with each other if their masks share a bit; 0: with none; default 0 */
    body_layers: number;
    /** of CLOTH_SHEAR constraints of a grid, m/N, >= 0; 0: as compliance; default 0 */
    shear_compliance: number;
    /** of each constraint, newtons, >= 0; 0: none breaks; default 0; see Break */
    breaking_force: number;
    /** of ropes, E I in N m^2, >= 0; 0: they bend freely; default 0; see below */
    bending_stiffness: number;
}
/** What all particles of a body share and may change later. Fields as in BodyDesc. Frozen. */
export interface BodySettings {
    /** 1/s, >= 0 */
    damping: number;
    /** >= 0 */
    friction: number;
    /** at least friction, or 0: as friction */
    static_friction: number;
    /** 0 .. 1 */
    restitution: number;
    /** of models */
    layers: number;
    /** of bodies */
    body_layers: number;
    /** 0 or 1; particles nearer than their radii reach when it is set do not collide */
    self_collision: number;
}
/** Frozen. */
export interface BodyInfo {
    kind: number;
    method: number;
    particle_count: number;
    constraint_count: number;
    /** of cloth, for drawing */
    triangle_count: number;
}
/** The air around a body. Frozen. */
export interface Wind {
    /** of the air, m/s */
    velocity: number[];
    /** kg/m^3, >= 0; 1.2 is air at 20 degrees; 0: none */
    density: number;
    /** coefficient C_D, >= 0: a plate across has 1.2, a cylinder 1.2, a sphere 0.5 */
    drag: number;
    /** coefficient C_L of cloth, >= 0; a plate has as much lift as drag */
    lift: number;
}
/** Where an animation wants a particle, and how far from there the particle may be. Frozen. */
export interface AnimationTarget {
    /** metres */
    position: number[];
    /** of the animated surface, away from the character; any length but 0; not read without
     * a backstop */
    normal: number[];
    /** metres from position, >= 0; INFINITY: any */
    max_distance: number;
    /** metres that the particle may go behind the plane through position across normal, >= 0;
     * INFINITY: any */
    backstop: number;
}
/** A particle that is attached to a model. Frozen.  Since 1.1. */
export interface Attachment {
    particle: number;
    model: number;
    /** in the model's coordinates, as for Solver.attach */
    local_point: number[];
}
/** One constraint. Frozen. */
export interface ConstraintInfo {
    id: number;
    particle_a: number;
    particle_b: number;
    /** metres */
    rest_length: number;
    /** metres per newton */
    compliance: number;
}
/** The settings of a constraint. Frozen. */
export interface ConstraintSettings {
    /** metres, >= 0, below 1e-9 as 0; negative, when it is set: the present distance */
    rest_length: number;
    /** metres per newton, >= 0; 0 is rigid */
    compliance: number;
    /** N s/m, >= 0, of what has compliance; see Solver.setConstraintDamping */
    damping: number;
}
/** One joint. Frozen. */
export interface JointInfo {
    id: number;
    body_a: number;
    particle_a: number;
    body_b: number;
    particle_b: number;
    /** metres */
    rest_length: number;
    /** metres per newton */
    compliance: number;
    /** newtons, in the last substep: > 0 pulls them together, < 0 keeps them apart; its
     * magnitude for a rest length of 0 */
    force: number;
}
/** A constraint that broke, or that the caller has broken. Frozen.  Since 1.1. */
export interface Break {
    body: number;
    constraint: number;
    /** its particles before */
    particle_a: number;
    /** its particles before */
    particle_b: number;
    /** where cloth parted; NO_PARTICLE: nowhere, the constraint was removed */
    torn_particle: number;
    /** its copy, the last of the body; NO_PARTICLE: none */
    new_particle: number;
    /** newtons; 0 if the caller broke it */
    load: number;
}
/** Frozen. */
export interface SolverStats {
    particle_count: number;
    /** pinned or attached */
    pinned_count: number;
    constraint_count: number;
    /** particle and model pairs that touched in the last step, 4 a particle at most */
    contact_count: number;
    /** largest |length / rest length - 1| of rigid constraints whose rest length is not 0 */
    strain_max: number;
    /** root mean square of the same */
    strain_rms: number;
    /** joules */
    kinetic_energy: number;
    /** joules: of gravity, 0 at the solver's origin, of stretch, bending and held volumes */
    potential_energy: number;
}
/** A particle that touched a model in the last step. Frozen. */
export interface Contact {
    body: number;
    particle: number;
    model: number;
    /** the model's */
    tag: number;
    /** on the model, world space */
    point: number[];
    /** unit, from the model to the particle */
    normal: number[];
}
/** Two particles of different bodies that touched in the last step. Frozen.  Since 1.1. */
export interface BodyContact {
    body_a: number;
    particle_a: number;
    /** above body_a */
    body_b: number;
    particle_b: number;
    /** unit, from a to b, when they touched last */
    normal: number[];
    /** metres between their surfaces as they are now; below 0: they overlap */
    distance: number;
    /** N s along normal, of the whole step: b got it, and a its opposite. The reactions of links and
     * models are not in it */
    impulse: number;
}
/** What bodies gave a model in the last step, by contacts and by attachments. Frozen. */
export interface Impulse {
    model: number;
    /** the model's */
    tag: number;
    /** N s: what to add to the momentum of the model if it is a body of yours */
    linear: number[];
    /** N m s, about the model's position in the world: likewise for its angular momentum */
    angular: number[];
}
/** The elements of Records, by the name of their kind. */
export interface Kinds {
    float: number;
    double: number;
    int32_t: number;
    uint32_t: number;
    vec3: number[];
    quat: number[];
    mat4: number[];
    transform: Transform;
    ray: Ray;
    segment: Segment;
    sphere: Sphere;
    capsule: Capsule;
    aabb: Aabb;
    obb: Obb;
    plane: Plane;
    triangle: Triangle;
    frustum: Frustum;
    hit: Hit;
    nearest: Nearest;
    distance: Distance;
    penetration: Penetration;
    mesh_report: MeshReport;
    mesh_info: MeshInfo;
    octree_stats: OctreeStats;
    octree_box: OctreeBox;
    model_info: ModelInfo;
    orbit: Orbit;
    orbit_speeds: OrbitSpeeds;
    solver_settings: SolverSettings;
    body_settings: BodySettings;
    body_info: BodyInfo;
    wind: Wind;
    animation_target: AnimationTarget;
    attachment: Attachment;
    constraint_info: ConstraintInfo;
    constraint_settings: ConstraintSettings;
    joint_info: JointInfo;
    break: Break;
    solver_stats: SolverStats;
    contact: Contact;
    body_contact: BodyContact;
    impulse: Impulse;
}
export type Kind = keyof Kinds;
export function sphere(center: Given<number[]>, radius: Given<number>): Shape;
export function capsule(a: Given<number[]>, b: Given<number[]>, radius: Given<number>): Shape;
export function aabb(min: Given<number[]>, max: Given<number[]>): Shape;
export function obb(center: Given<number[]>, half_extents: Given<number[]>, rotation: Given<number[]>): Shape;
export function plane(normal: Given<number[]>, distance: Given<number>): Shape;
export function triangle(a: Given<number[]>, b: Given<number[]>, c: Given<number[]>): Shape;
export function frustum(origin: Given<number[]>, planes: Given<Plane[]>): Shape;
export function ray(origin: Given<number[]>, direction: Given<number[]>, t_max: Given<number>): Shape;
export function segment(a: Given<number[]>, b: Given<number[]>): Shape;
export function shapes(kind: 'sphere' | 'capsule' | 'aabb' | 'obb' | 'plane' | 'triangle' | 'frustum' | 'ray' | 'segment', data: Float32Array | Records): Shapes;
/** Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
 * segments or points that they are, and the report counts them. 0 triangles are allowed.
 * Throws GamephysError with ERROR_INVALID_ARGUMENT for an index out of range, an index_count that is
 * no multiple of 3 or a bad vertex; meshCheck tells which.
 * Cost: O(n log n), about 1 us per triangle. */
export class Mesh {
    constructor(vertices: Floats, indices?: Words | null, desc?: Partial<MeshDesc> | null);
    /** Frees the object at once. */
    close(): void;
    [Symbol.dispose](): void;
    /** Throws: an object is not data, and is not cloned. */
    toJSON(): never;
    /** Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
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
     * Throws GamephysError with ERROR_INVALID_ARGUMENT if a point is out of range or if all lie in a
     * plane, which is decided exactly.
     * Throws GamephysError with ERROR_CAPACITY if the hull has more than 256 faces.
     * Throws GamephysError with ERROR_UNSUPPORTED if desc asks for a deformable mesh.
     * Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
     * Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1. */
    static hull(points: Floats, desc?: Partial<MeshDesc> | null): Mesh;
    /** Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
     * snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
     * checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
     * any other; only the counts of its report (triangles of zero area, open edges) are taken from the
     * words as they are.
     *   - desc: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
     * Throws GamephysError with ERROR_INVALID_ARGUMENT for words that are no snapshot of a mesh, damaged,
     * of a later format or of another byte order.
     * Throws GamephysError with ERROR_UNSUPPORTED for a deformable hull.
     * Cost: O(n), a small part of Mesh's; allocates. */
    static fromSnapshot(words: Words, desc?: Partial<MeshDesc> | null): Mesh;
    /** A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh.setVertices does to
     * it is seen by all its models. It gives the meshes of a restored scene, which are not deformable if
     * they were embedded in its snapshot.
     * Result: a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.
     * Throws GamephysError with ERROR_UNSUPPORTED if the model's shape is no mesh.
     * Cost: O(1). Since 1.1. */
    static fromScene(scene: Scene, model: number): Mesh;
    /** Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
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
     * compared, O(particles). Since 1.1. */
    static fromBody(solver: Solver, body: number, desc?: Partial<MeshDesc> | null): Mesh;
    /** The planes of a hull's faces: normals are unit and point out, within float32 rounding.
     * Cost: O(faces). Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for a mesh that is no hull */
    getHullPlanes(): Records<Plane>;
    /** For each triangle of a hull the index of its face in the list of Mesh.getHullPlanes, ascending from
     * 0.
     * Cost: O(triangles). Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for a mesh that is no hull */
    getHullFaces(): Records<number>;
    /** Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
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
     * @param vertices - elements of 3 floats, metres; copied
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the mesh is not deformable
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for a vertex that is not finite or too large, or if
     *     a model of the mesh would reach beyond the range of coordinates */
    setVertices(vertices: Floats): void;
    /** Kind and size of a mesh, and whether its vertices change.
     * Cost: O(1). Since 1.1. */
    getInfo(): MeshInfo;
    /** What the mesh was built from: the report that meshCheck makes of its arrays.
     * Cost: O(1); O(triangles) for a deformable mesh. */
    getReport(): MeshReport;
    /** Copy the vertices out, in metres and in their original order.
     * Cost: O(vertices). */
    getVertices(): Records<number[]>;
    /** Copy the indices out, three for each triangle, in their original order.
     * Cost: O(n). */
    getIndices(): Records<number>;
    /** Copy a mesh out with its tree, from which Mesh makes it without building the tree.
     * Threads: any.
     * Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.
     * @returns the snapshot. Words are in the machine's byte order. Every later release of the same major
     *     version reads it.
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^32 - 1 words */
    getSnapshot(): Records<number>;
    /** All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
     * Cost: O(log n + k) expected. */
    raycastAll(ray: Given<Ray>): Records<Hit>;
    /** Whether a ray hits anything; cheaper than the closest hit.
     * Cost: O(log n) expected. */
    raycastAny(ray: Given<Ray>): boolean;
    /** Whether each of the rays hits anything, as Mesh.raycastAny.
     * Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1. */
    raycastAnyBatch(rays: Floats, out?: Elements): Records<number>;
    /** How far each of the rays goes, and which triangle it hits: t and triangle of raycastBatch for the
     * mesh, with the same bits, without the rest of a hit; model is 0.
     * Cost: less than that of raycastBatch. Since 1.1.
     * @returns a ray that hits nothing gets t = INFINITY and triangle = NO_TRIANGLE. */
    raycastDistanceBatch(rays: Floats, out?: Elements): Records<Distance>;
    /** Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
     * ascending.
     * Cost: O(log n + k) expected.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types of shapes */
    overlap(shape: AnyShape): Records<number>;
    /** How the mesh's octree is made up.
     * Cost: O(nodes). */
    getOctreeStats(): OctreeStats;
    /** Boxes of the mesh's octree, each parent before its children.
     * Cost: O(nodes). */
    getOctreeBoxes(): Records<OctreeBox>;
}
/** Create a scene without models. With a worker_count of n, all batch queries of the scene
 * (Camera.pickBatch too), and adding and moving many models, share their work among n threads; the
 * results have the same bits for every n. Without a task_runner n - 1 threads are started here and
 * joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
 * own thread alone. They take no signals but faults, and have the standard floating-point settings. In
 * a child of fork they are gone: calls there run on one thread, as they do on a platform without
 * threads (WebAssembly, unless built for shared memory), whatever is asked for.
 *   - desc: null: the defaults
 * Throws GamephysError with ERROR_OUT_OF_MEMORY also if the threads cannot be started.
 * Throws GamephysError with ERROR_CAPACITY if reserve_models is above 2^24 - 1.
 * Cost: O(reserve_models), and that of starting the threads. */
export class Scene {
    constructor(desc?: Partial<SceneDesc> | null);
    /** Frees the object at once. */
    close(): void;
    [Symbol.dispose](): void;
    /** Throws: an object is not data, and is not cloned. */
    toJSON(): never;
    /** Change the number of threads that share the calls of a scene, for example when the user changes a
     * setting. They are those of its task_runner if it was created with one. In a child of fork they are
     * started again. Answers keep their bits.
     * Cost: that of joining the former threads and starting others; allocates. Since 1.1.
     * @param workers - as SceneDesc.worker_count
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the former ones
     *     are kept */
    setWorkerCount(workers: number): void;
    /** How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
     * of fork it is still the number that was set, though calls run on one thread.
     * Cost: O(1). Since 1.1. */
    getWorkerCount(): number;
    /** Move the point of the world that all coordinates of the scene are relative to, those passed to it
     * and those that it returns. Models stay where they are in the world: the positions of those without a
     * parent become what they are from there, kept in double precision and rounded to float32 once,
     * however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
     * and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
     * Cost: that of Scene.setTransforms of all models, and 24 bytes a model from the first call on.
     * Queries cost nothing more. Allocates.
     * @param origin - x, y, z in the world, within MAX_COORDINATE; before the first call 0 0 0
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if a model would leave the range of coordinates */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the scene's coordinates count from.
     * Cost: O(1). */
    getOrigin(): number[];
    /** Add a model.
     * Cost: O(log n) amortised.
     * @param shape - sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
     * @param shape - in the model's own coordinates
     * @param transform - local; null is the identity
     * @param desc - null: no parent, layer 1, tag 0
     * @throws {GamephysError} ERROR_UNSUPPORTED: for another type, or a scale that the shape cannot have
     *     (Scene.setScale)
     * @throws {GamephysError} ERROR_INVALID_ID: for a stale parent
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 models */
    add(shape: AnyShape, transform?: Given<Transform> | null, desc?: Partial<ModelDesc> | null): number;
    /** Add the models of one type, all or none, as Scene.add does one.
     * Fails as Scene.add.
     * Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
     * is of the order of n.
     * @param shapes - in the models' own coordinates
     * @param transforms - local; null is the identity
     * @param desc - for all; null: no parent, layer 1, tag 0 */
    addBatch(shapes: Shapes | AnyShape, transforms?: Floats | null, desc?: Partial<ModelDesc> | null, out?: Elements): Records<number>;
    /** Add the models of one type, all or none, each with a desc of its own.
     * Fails as Scene.add; ERROR_STRUCT_SIZE as for a single desc.
     * Cost: as Scene.addBatch.
     * @param shapes - in the models' own coordinates
     * @param transforms - local; null is the identity
     * @param descs - one for each; null: no parent, layer 1, tag 0. Parents are models that the scene has
     *     before the call */
    addDescribedBatch(shapes: Shapes | AnyShape, transforms?: Floats | null, descs?: readonly Partial<ModelDesc>[] | Partial<ModelDesc> | null, out?: Elements): Records<number>;
    /** Remove a model. Its children stay where they are in the world and lose their parent.
     * Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory. */
    remove(model: number): void;
    /** Remove models, all or none.
     * Cost: that of as many calls of Scene.remove. Renews the octree as far as there is memory.
     * @param models - the ids; an id that appears twice is ERROR_INVALID_ID */
    removeBatch(models: Words): void;
    /** Remove a model and all its descendants.
     * Cost: O(log n) amortised for each. Renews the octree as far as there is memory. */
    removeSubtree(model: number): void;
    /** Remove all models. Ids given out before stay invalid.
     * Cost: O(n). */
    clear(): void;
    /** Whether an id names a model of this scene.
     * Cost: O(1). */
    has(model: number): boolean;
    /** Ids of all models, ascending.
     * Cost: O(n). */
    getModels(): Records<number>;
    /** Ids of all models without a parent, ascending.
     * Cost: O(n). */
    getRoots(): Records<number>;
    /** Ids of the direct children of a model, ascending.
     * Cost: O(k log k). */
    getChildren(model: number): Records<number>;
    /** Kind, parent, layers, tag and number of children of a model.
     * Cost: O(1). */
    getInfo(model: number): ModelInfo;
    /** World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
     * and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
     * Cost: O(1).
     * @returns null for a plane. */
    getBounds(model: number): Aabb | null;
    /** World box of all bounded models. Planes are left out.
     * Cost: O(1).
     * @returns null if there are none. */
    getSceneBounds(): Aabb | null;
    /** Give a model another shape, or another mesh, of any type that Scene.add takes: a character crouches,
     * a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
     * transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
     * do of any solid.
     * Cost: as Scene.setTransform of a model without children, whatever the size of a mesh.
     * @param shape - as in Scene.add: a struct, copied, or a mesh with SHAPE_MESH. The scene holds the new
     *     mesh and no longer the old one, which may be the same.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for a frustum, ray or segment, and for a shape that
     *     cannot have the model's scale (Scene.setScale)
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if the model would leave the range of the world
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: */
    setShape(model: number, shape: AnyShape): void;
    /** Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
     * unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
     * normals are those of its surface. Children and attached particles (Solver.attach) are not affected:
     * they follow the transform, whose scale is one number. A new scale replaces the old one. No scale
     * mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners of each triangle.
     * There is no form for many models: three equal numbers belong in their transforms
     * (Scene.setTransforms), and Scene.addDescribedBatch takes a scale for each model that it adds. A mesh
     * or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled vertices. Of
     * a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule or plane,
     * and an OBB whose own rotation is not the identity, take three equal numbers only.
     * Cost: as Scene.setTransform of a model without children. Models that have a scale take 16 bytes more
     * if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to 11 %
     * more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of the scaled
     * vertices, whose tree is made for that form.
     * @param scale - x, y, z, each from 1e-15 to 1e15
     * @throws {GamephysError} ERROR_UNSUPPORTED: for numbers that are not equal where they have to be, and
     *     for the mesh of a rope or of particles (Mesh) unless it is 1 1 1
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if a coordinate of the scaled shape would
     *     exceed MAX_COORDINATE, if a number times that of a mesh's world transform is not from 1e-15 to
     *     1e15, or if the model would leave the range of the world
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: */
    setScale(model: number, scale: Given<number[]>): void;
    /** The scale of a model's own shape, 1 1 1 unless another was set.
     * Cost: O(1). */
    getScale(model: number): number[];
    /** Change which queries see a model: those with a mask m of which layers & m is not 0. Children are not
     * affected.
     * Cost: O(1).
     * @param layers - any mask; 0: no query sees it */
    setLayers(model: number, layers: number): void;
    /** Change the number that a model's hits report beside its id. Children are not affected.
     * Cost: O(1).
     * @param tag - any number of the caller's */
    setTag(model: number, tag: number): void;
    /** Make a model the child of another one, or of none (0).
     * Cost: O(depth of the tree of models), and as Scene.setTransform for what moves. Renews the octree as
     * far as there is memory.
     * @param keep_world - false: the local transform is kept, the model jumps; true: the local transform
     *     is changed so that the world transform stays (within float32 rounding)
     * @throws {GamephysError} ERROR_CYCLE: if parent is the model or one of its descendants */
    setParent(model: number, parent: number, keep_world: boolean | number): void;
    /** Set a model's local transform. Descendants follow.
     * Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.
     * @param transform - relative to the parent; scale > 0
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if it, or a descendant, would leave the range
     *     of the world */
    setTransform(model: number, transform: Given<Transform>): void;
    /** Set the local transforms of many models, all or none; a model that appears twice gets the last.
     * Descendants follow.
     * Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
     * the octree as far as there is memory.
     * @param models - the ids
     * @param transforms - as in Scene.setTransform */
    setTransforms(models: Words, transforms: Floats): void;
    /** Local transforms of the models, as they were set: relative to the parent.
     * Cost: O(elements).
     * @param models - the ids; an id may appear twice */
    getTransforms(models: Words, out?: Elements): Records<Transform>;
    /** World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
     * queries are exact with respect to these.
     * Cost: O(elements).
     * @param models - the ids; an id may appear twice */
    getWorldTransforms(models: Words, out?: Elements): Records<Transform>;
    /** Closest model on a ray; the fields are exact as in raycast.
     * Cost: O(log n) expected; no allocation.
     * @returns null if nothing is found. */
    raycast(ray: Given<Ray>, layers?: number): Hit | null;
    /** Closest models on the rays, as Scene.raycast; a ray that hits nothing gets model = 0 and t =
     * INFINITY.
     * Cost: at most that of as many single calls; shared among workers. */
    raycastBatch(rays: Floats, layers?: number, out?: Elements): Records<Hit>;
    /** How far each of the rays goes, and what it hits: t, model and triangle of Scene.raycastBatch, with
     * the same bits, without the rest of a hit. For lidars and depth images.
     * Cost: less than that of Scene.raycastBatch; shared among workers. Since 1.1.
     * @returns a ray that hits nothing gets t = INFINITY, model = 0 and triangle = NO_TRIANGLE. */
    raycastDistanceBatch(rays: Floats, layers?: number, out?: Elements): Records<Distance>;
    /** Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
     * Cost: O(log n) expected. */
    raycastAny(ray: Given<Ray>, layers?: number): boolean;
    /** Whether each of the rays meets anything, as Scene.raycastAny.
     * Cost: at most that of as many single calls; shared among workers. */
    raycastAnyBatch(rays: Floats, layers?: number, out?: Elements): Records<number>;
    /** Every model that a ray meets, each once with its first hit, by t, then id.
     * Cost: O(log n + k log k) expected. */
    raycastAll(ray: Given<Ray>, layers?: number): Records<Hit>;
    /** Every model that each of the rays meets, as Scene.raycastAll: the hits of ray i are at
     * hits[offsets[i]] up to offsets[i + 1].
     * The contents of hits behind the last hit are unspecified.
     * Cost: that of as many single calls; shared among workers. */
    raycastAllBatch(rays: Floats, layers?: number): { values: Records<Hit>; offsets: Uint32Array };
    /** Closest model along a segment from a to b, both included; t in 0..1. Fields as in segmentTest.
     * Cost: O(log n) expected.
     * @returns null if nothing is found. */
    segmentTest(segment: Given<Segment>, layers?: number): Hit | null;
    /** Closest models along the segments, as Scene.segmentTest; one that hits nothing gets model = 0 and t
     * = INFINITY.
     * Cost: that of as many single calls; shared among workers. */
    segmentTestBatch(segments: Floats, layers?: number, out?: Elements): Records<Hit>;
    /** Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
     * overlaps, ascending.
     * Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
     * more saves most of that, unless many models have replaced removed ones.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types of shapes */
    overlap(shape: AnyShape, layers?: number): Records<number>;
    /** Ids of all models that each of the shapes of one type overlaps, as Scene.overlap: those of shape i
     * are at models[offsets[i]] up to offsets[i + 1], as in Scene.raycastAllBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @throws {GamephysError} ERROR_UNSUPPORTED: as there */
    overlapBatch(shapes: Shapes | AnyShape, layers?: number): { values: Records<number>; offsets: Uint32Array };
    /** Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
     * box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
     * edges are listed, too: a few per cent more where models are compact or not rotated; about a third
     * more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
     * many again as are visible where they are as long as the view is wide. Scene.overlap leaves these out
     * by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
     * listed is best: it is used to order them.
     * Cost: O(log n + k) expected. */
    cull(frustum: Given<Frustum>, layers?: number): Records<number>;
    /** Ids of the models in each of count frusta, as Scene.cull: for split screens, cascades of shadow
     * maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
     * offsets[i + 1], as in Scene.raycastAllBatch.
     * Cost: that of as many single calls; shared among workers. Since 1.1. */
    cullBatch(frusta: Floats, layers?: number): { values: Records<number>; offsets: Uint32Array };
    /** The model nearest to a point, and its closest point.
     * Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
     * nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
     * That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
     * in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
     * 15 us.
     * @param max_distance - metres, >= 0, INFINITY allowed; a model at exactly this distance counts
     * @returns null if nothing is found. */
    nearest(point: Given<number[]>, max_distance?: number, layers?: number): Nearest | null;
    /** The models nearest to the points, as Scene.nearest; a point with none gets model = 0 and distance =
     * INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param max_distance - metres, >= 0, INFINITY allowed, for all points */
    nearestBatch(points: Floats, max_distance?: number, layers?: number, out?: Elements): Records<Nearest>;
    /** First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
     * sweepSphere.
     * Cost: O(log n + k) expected, k the models that the swept box touches.
     * @param displacement - metres; may be zero
     * @returns null if nothing is found. */
    sweepSphere(sphere: Given<Sphere>, displacement: Given<number[]>, layers?: number): Hit | null;
    /** First models that the spheres touch while each moves by its displacement, as Scene.sweepSphere; one
     * that touches nothing gets model = 0 and t = INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements - metres */
    sweepSphereBatch(spheres: Floats, displacements: Floats, layers?: number, out?: Elements): Records<Hit>;
    /** First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
     * turning; t in 0..1. Fields as in sweep.
     * Cost: O(log n + k) expected, k the models that the swept box touches.
     * @param displacement - metres; may be zero
     * @returns null if nothing is found.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types */
    sweep(shape: AnyShape, displacement: Given<number[]>, layers?: number): Hit | null;
    /** First models that the shapes of one type touch while each moves by its displacement, as Scene.sweep;
     * one that touches nothing gets model = 0 and t = INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements - metres
     * @throws {GamephysError} ERROR_UNSUPPORTED: as Scene.sweep */
    sweepBatch(shapes: Shapes | AnyShape, displacements: Floats, layers?: number, out?: Elements): Records<Hit>;
    /** What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
     * a mesh one for each triangle, as penetration. Deepest first; equal depths by model, then triangle.
     * Each is the way out of that one alone. The models are those of Scene.overlap.
     * Cost: O(log n + k log k) expected.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types */
    penetration(shape: AnyShape, layers?: number): Records<Penetration>;
    /** What each of the shapes of one type overlaps, and how it gets out, as Scene.penetration: the ways
     * out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in Scene.raycastAllBatch. So
     * a crowd of characters is pushed out in one call.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: as Scene.penetration */
    penetrationBatch(shapes: Shapes | AnyShape, layers?: number): { values: Records<Penetration>; offsets: Uint32Array };
    /** Closest model on a ray that the filter sees, as Scene.raycast.
     * Cost: that of Scene.raycast for one ignored model. For each model that is met within the ray's
     * reach, besides: O(its depth below its root) with FILTER_SUBTREE if ignored_model has children; of m
     * ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
     * they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time.
     * @param filter - null: the defaults
     * @returns null if nothing is found.
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for unknown flags, or ignored_models null with an
     *     ignored_count above 0 */
    raycastFiltered(ray: Given<Ray>, filter?: Partial<QueryFilterDesc> | null): Hit | null;
    /** Closest models on the rays that the filters see, as Scene.raycastBatch.
     * Cost: at most that of as many calls of Scene.raycastFiltered; shared among workers.
     * @param filters - null: the defaults */
    raycastFilteredBatch(rays: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Hit>;
    /** How far each of the rays goes among the models that its filter sees, as Scene.raycastDistanceBatch:
     * a lidar leaves out the robot that carries it.
     * Cost: less than that of Scene.raycastFilteredBatch; shared among workers. Since 1.1.
     * @param filters - null: the defaults */
    raycastDistanceFilteredBatch(rays: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Distance>;
    /** Whether a ray meets anything that the filter sees, as Scene.raycastAny: line of sight between two
     * models that both are left out.
     * Cost: as Scene.raycastFiltered.
     * @param filter - null: the defaults */
    raycastAnyFiltered(ray: Given<Ray>, filter?: Partial<QueryFilterDesc> | null): boolean;
    /** Whether each of the rays meets anything that its filter sees, as Scene.raycastAnyBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @param filters - null: the defaults */
    raycastAnyFilteredBatch(rays: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<number>;
    /** Every model that a ray meets and the filter sees, as Scene.raycastAll.
     * Cost: that of Scene.raycastAll, and for each model as Scene.raycastFiltered.
     * @param filter - null: the defaults */
    raycastAllFiltered(ray: Given<Ray>, filter?: Partial<QueryFilterDesc> | null): Records<Hit>;
    /** Every model that each of the rays meets and its filter sees, as Scene.raycastAllBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param filters - null: the defaults */
    raycastAllFilteredBatch(rays: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null): { values: Records<Hit>; offsets: Uint32Array };
    /** Closest model along a segment that the filter sees, as Scene.segmentTest.
     * Cost: as Scene.raycastFiltered.
     * @param filter - null: the defaults
     * @returns null if nothing is found. */
    segmentTestFiltered(segment: Given<Segment>, filter?: Partial<QueryFilterDesc> | null): Hit | null;
    /** Closest models along the segments that the filters see, as Scene.segmentTestBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param filters - null: the defaults */
    segmentTestFilteredBatch(segments: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Hit>;
    /** Ids of all models that overlap a shape and that the filter sees, as Scene.overlap.
     * Cost: that of Scene.overlap, and for each model as Scene.raycastFiltered.
     * @param filter - null: the defaults
     * @throws {GamephysError} ERROR_UNSUPPORTED: for types of shapes that Scene.overlap does not take */
    overlapFiltered(shape: AnyShape, filter?: Partial<QueryFilterDesc> | null): Records<number>;
    /** Ids of all models that each of the shapes of one type overlaps and its filter sees, as
     * Scene.overlapBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @param filters - null: the defaults
     * @throws {GamephysError} ERROR_UNSUPPORTED: as there */
    overlapFilteredBatch(shapes: Shapes | AnyShape, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null): { values: Records<number>; offsets: Uint32Array };
    /** Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene.cull: a
     * player's own head, say, is not drawn.
     * Cost: that of Scene.cull, and for each model as Scene.raycastFiltered.
     * @param filter - null: the defaults */
    cullFiltered(frustum: Given<Frustum>, filter?: Partial<QueryFilterDesc> | null): Records<number>;
    /** Ids of the models in each of count frusta that its filter sees, as Scene.cullBatch: each player's
     * view leaves out the player's own head.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @param filters - null: the defaults */
    cullFilteredBatch(frusta: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null): { values: Records<number>; offsets: Uint32Array };
    /** The model nearest to a point that the filter sees, as Scene.nearest: the nearest other model, if the
     * one at the point is left out.
     * Cost: that of Scene.nearest, and for each model as Scene.raycastFiltered; each ignored model that is
     * nearer than the answer is visited.
     * @param max_distance - metres, >= 0, INFINITY allowed; a model at exactly this distance counts
     * @param filter - null: the defaults
     * @returns null if nothing is found. */
    nearestFiltered(point: Given<number[]>, max_distance?: number, filter?: Partial<QueryFilterDesc> | null): Nearest | null;
    /** The models nearest to the points that the filters see, as Scene.nearestBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param max_distance - metres, >= 0, INFINITY allowed, for all points
     * @param filters - null: the defaults */
    nearestFilteredBatch(points: Floats, max_distance?: number, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Nearest>;
    /** First model that a moving sphere touches and the filter sees, as Scene.sweepSphere: the sphere may
     * be the bounding sphere of the ignored model.
     * Cost: that of Scene.sweepSphere, and for each model as Scene.raycastFiltered.
     * @param displacement - metres; may be zero
     * @param filter - null: the defaults
     * @returns null if nothing is found. */
    sweepSphereFiltered(sphere: Given<Sphere>, displacement: Given<number[]>, filter?: Partial<QueryFilterDesc> | null): Hit | null;
    /** First models that count moving spheres touch and the filters see, as Scene.sweepSphereBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements - metres
     * @param filters - null: the defaults */
    sweepSphereFilteredBatch(spheres: Floats, displacements: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Hit>;
    /** First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as Scene.sweep:
     * a character leaves out its own model.
     * Cost: that of Scene.sweep, and for each model as Scene.raycastFiltered.
     * @param displacement - metres; may be zero
     * @param filter - null: the defaults
     * @returns null if nothing is found.
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types */
    sweepFiltered(shape: AnyShape, displacement: Given<number[]>, filter?: Partial<QueryFilterDesc> | null): Hit | null;
    /** First models that count moving shapes of one type touch and the filters see, as Scene.sweepBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements - metres
     * @param filters - null: the defaults
     * @throws {GamephysError} ERROR_UNSUPPORTED: as Scene.sweep */
    sweepFilteredBatch(shapes: Shapes | AnyShape, displacements: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Hit>;
    /** What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
     * Scene.penetration.
     * Cost: that of Scene.penetration, and for each model as Scene.raycastFiltered.
     * @param filter - null: the defaults
     * @throws {GamephysError} ERROR_UNSUPPORTED: for other types */
    penetrationFiltered(shape: AnyShape, filter?: Partial<QueryFilterDesc> | null): Records<Penetration>;
    /** What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
     * Scene.penetrationBatch: each character leaves out its own model.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @param filters - null: the defaults
     * @throws {GamephysError} ERROR_UNSUPPORTED: as Scene.penetration */
    penetrationFilteredBatch(shapes: Shapes | AnyShape, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null): { values: Records<Penetration>; offsets: Uint32Array };
    /** Rebuild the scene's octree, as good as that of one Scene.addBatch. Never required: ids, answers and
     * their bits do not change. Where many models were added one by one, such as a level that was streamed
     * in, rays then take 0.6 to 0.95 of the time.
     * Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: with nothing changed */
    rebuildOctree(): void;
    /** Rebuild the octree in parts, one in each call, until it is as good as after Scene.rebuildOctree: for
     * levels that are streamed in while frames go on. Each Scene.add and Scene.remove does a part by
     * itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are. Models
     * may be added, moved and removed between the calls. A call that updates an eighth of them or more
     * restarts it.
     * Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.
     * @param budget - how much work to do, as a number of models, of 0.3 to 3 us each. The work is the
     *     same on every machine and does not depend on time.
     * @returns 1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
     *     again.
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: : the octree is as before, and the next call begins
     *     again */
    maintainOctree(budget: number): boolean;
    /** How the scene's octree is made up.
     * Cost: O(nodes). */
    getOctreeStats(): OctreeStats;
    /** Boxes of the scene's octree, each parent before its children.
     * Cost: O(nodes). */
    getOctreeBoxes(): Records<OctreeBox>;
    /** Check the scene's own structure: every model once in the tree, every box around its content, parents
     * and children in agreement, free slots free. For tests.
     * Cost: O(n).
     * @throws {GamephysError} ERROR_INTERNAL: and the error's message says what is wrong */
    validate(): void;
    /** Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
     * shapes, the order of future ids, and the octree. Workers and allocator are not in it.
     * Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (Mesh.getSnapshot).
     * Allocates a few words for each different mesh.
     * @param embed_meshes - true: meshes are in the snapshot, each once, so it is complete in itself: for
     *     saved games and for other machines. false: they are identified by their content, and
     *     Scene.restore looks for them: for undo, and rollback each frame.
     * @returns the snapshot. Words are in the machine's byte order. Every later release of the same major
     *     version reads it.
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^32 - 1 words */
    getSnapshot(embed_meshes: boolean | number): Records<number>;
    /** Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
     * time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
     * that is restored with its scene continues with the same bits. On an error the scene is as before.
     * Any words are safe, also from an untrusted source: all that is used as a number or an index is
     * checked first. Forged words are refused, or taken as a scene like any other.
     * Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.
     * @param library - meshes that are not embedded are looked for among those that models of this scene
     *     use, by their content: vertices and indices. A mesh deformed since must get its old form back
     *     first. null: among those that models of `scene` itself use, before it is restored.
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for words that are no snapshot of a scene, damaged,
     *     of a later format or of another byte order, and if a mesh is missing
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: if there is no room for it */
    restore(library: Scene | null, words: Words): void;
    /** A hash of the whole state except the octree, the low half first; meshes count by their content.
     * Equal states have equal hashes on every machine; different ones differ with near certainty (not
     * against an adversary). Compare it between machines that run the same simulation, to detect when they
     * diverge.
     * Cost: O(n), some 50 ns for each model. */
    getHash(): number[];
    /** The shape of a model, in its own coordinates; not of a mesh, which Mesh.fromScene gives. */
    getShape(model: number): Shape;
}
/** Create a camera at the origin, with the projection and the viewport of its desc.
 *   - desc: null: the defaults
 * Cost: O(1). */
export class Camera {
    constructor(desc?: Partial<CameraDesc> | null);
    /** Frees the object at once. */
    close(): void;
    [Symbol.dispose](): void;
    /** Throws: an object is not data, and is not cloned. */
    toJSON(): never;
    /** Move the point of the world that the camera's coordinates count from; see Scene.setOrigin. The
     * camera and the target of its orbit stay where they are in the world. Picking and culling need a
     * scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
     * Cost: O(1).
     * @param origin - x, y, z in the world, metres, within MAX_COORDINATE */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the camera's coordinates count from, metres.
     * Cost: O(1). */
    getOrigin(): number[];
    /** Use a perspective projection: distant objects appear smaller.
     * Cost: O(1).
     * @param fov_y - full vertical angle in radians, 1e-6 <= fov_y < pi
     * @param near_distance - metres, > 0
     * @param far_distance - metres, > near_distance; INFINITY allowed */
    setPerspective(fov_y: number, near_distance: number, far_distance: number): void;
    /** Use an orthographic projection: the distance does not change apparent size.
     * Cost: O(1).
     * @param height - metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is
     *     at most twice MAX_COORDINATE
     * @param near_distance - metres, may be negative
     * @param far_distance - metres, at least 1e-6 above near_distance */
    setOrthographic(height: number, near_distance: number, far_distance: number): void;
    /** Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
     * library's). It is not changed by Camera.setViewport.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_SINGULAR: if it has no inverse, or is too close to such a matrix to
     *     tell
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if a plane other than far lies at infinity, as it
     *     does when the matrix is for another depth range, or one lies beyond MAX_COORDINATE */
    setProjection(projection: Matrix): void;
    /** As Camera.setPerspective, with a fixed aspect ratio: the image is stretched to the viewport, as with
     * pixels that are not square, and the viewport does not change what is seen.
     * Cost: O(1). Since 1.1.
     * @param fov_y - full vertical angle in radians, 1e-6 <= fov_y < pi
     * @param aspect - width over height of what is seen, 1e-6 .. 1e6
     * @param near_distance - metres, > 0
     * @param far_distance - metres, > near_distance; INFINITY allowed */
    setPerspectiveAspect(fov_y: number, aspect: number, near_distance: number, far_distance: number): void;
    /** As Camera.setOrthographic, with a width of its own, which the viewport does not change.
     * Cost: O(1). Since 1.1.
     * @param width - metres seen from left to right, >= 1e-6
     * @param height - metres seen from top to bottom, >= 1e-6
     * @param near_distance - metres, may be negative
     * @param far_distance - metres, at least 1e-6 above near_distance */
    setOrthographicSize(width: number, height: number, near_distance: number, far_distance: number): void;
    /** Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height; the
     * call is refused if that makes the width more than twice MAX_COORDINATE.
     * Cost: O(1).
     * @param width - pixels, 1e-3 .. 1e6
     * @param height - pixels, 1e-3 .. 1e6 */
    setViewport(width: number, height: number): void;
    /** Where the viewport is in its window, as one of several of a split screen: pixels of all functions
     * count from the window's top left corner. (0, 0) at creation.
     * Cost: O(1). Since 1.1.
     * @param x - pixels from the window's left edge to the viewport's
     * @param y - pixels from the window's top edge to the viewport's */
    setViewportOrigin(x: number, y: number): void;
    /** Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
     * rays of other projections always begin there.
     * Cost: O(1). Since 1.1. */
    setPickStart(start: number): void;
    /** How the camera projects, as it was set.
     * Cost: O(1).
     * @returns what of the following was called last: Camera.setPerspective, as at creation,
     *     Camera.setOrthographic (or those with a width of their own), or Camera.setProjection. the
     *     vertical field of view in radians of a perspective, the height in metres of an orthographic
     *     projection, 0 of a matrix. the distance of the near plane, metres; 0 of a matrix. that of the
     *     far plane; INFINITY without one; 0 of a matrix. */
    getProjection(): [number, number, number, number];
    /** The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
     * image.
     * Cost: O(1). */
    getViewport(): [number, number];
    /** Where the viewport is in its window, in pixels, as it was set.
     * Cost: O(1). Since 1.1. */
    getViewportOrigin(): [number, number];
    /** Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
     * viewport.
     * Cost: O(1). Since 1.1.
     * @returns 1 if Camera.setPerspectiveAspect or Camera.setOrthographicSize was the last to set the
     *     projection; 0 if it follows the viewport. */
    getAspect(): [number, boolean];
    /** Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
     * the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
     * distance by an orthographic projection, in metres as they were set; 0 by a matrix.
     * Cost: O(1). Since 1.1. */
    getImageSize(): [number, number];
    /** Where the rays of a perspective begin, as it was set.
     * Cost: O(1). Since 1.1. */
    getPickStart(): number;
    /** What the camera was created with, as in CameraDesc.
     * Cost: O(1). Since 1.1. */
    getConventions(): [number, number, boolean];
    /** Place the camera.
     * Cost: O(1).
     * @param position - metres, of its centre
     * @param rotation - from its own axes to those of the world */
    setTransform(position: Given<number[]>, rotation: Given<number[]>): void;
    /** Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
     * kept, then up), so that a matrix which drifted is corrected.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_SINGULAR: if the axes do not span space
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if they mirror or the last row is not 0 0 0 1 */
    setWorldMatrix(world: Matrix): void;
    /** Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
     * Camera.setWorldMatrix. That of Camera.getViewMatrix puts a camera back within 2^-22 of its distance
     * from the origin and 2^-22 rad.
     * Cost: O(1). Since 1.1.
     * @throws {GamephysError} ERROR_SINGULAR: if the axes do not span space
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if they mirror, the last row is not 0 0 0 1, or the
     *     camera would be beyond MAX_COORDINATE */
    setViewMatrix(view: Matrix): void;
    /** Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
     * chosen in its place, always the same for the same input.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if eye equals target or up is zero */
    lookAt(eye: Given<number[]>, target: Given<number[]>, up: Given<number[]>): void;
    /** The camera's position, in metres, and its rotation, rounded to float32.
     * Cost: O(1). */
    getTransform(): [number[], number[]];
    /** The matrix from camera to world.
     * Cost: O(1). */
    getWorldMatrix(): number[];
    /** The matrix from world to camera: the transpose of the orthonormal world axes, and the position
     * transformed by it.
     * Cost: O(1). */
    getViewMatrix(): number[];
    /** The matrix from camera to clip space.
     * Cost: O(1). */
    getProjectionMatrix(): number[];
    /** Projection * view, multiplied in double precision and rounded once.
     * Cost: O(1). */
    getViewProjectionMatrix(): number[];
    /** Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
     * distance outside its limits is brought inside.
     * Cost: O(1). */
    setOrbit(orbit: Given<Orbit>): void;
    /** The present settings, angles and distance of the orbit.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    getOrbit(): Orbit;
    /** Set a speed for each input of the orbit, in place of the two of Orbit, which Camera.setOrbit starts
     * from. Input since the last update uses the new speeds.
     * Cost: O(1). Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    setOrbitSpeeds(speeds: Given<OrbitSpeeds>): void;
    /** The present speeds of the orbit's inputs.
     * Cost: O(1). Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    getOrbitSpeeds(): OrbitSpeeds;
    /** Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds that
     * were set.
     * Cost: O(1).
     * @param units_x - finite, any size
     * @param units_y - finite, any size
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    orbitRotate(units_x: number, units_y: number): void;
    /** Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
     * away if negative.
     * Cost: O(1).
     * @param units - finite, any size
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    orbitZoom(units: number): void;
    /** Add input to the orbit: move the target to the camera's right and up, as the last update left them,
     * by units times metres_per_unit or the speeds that were set.
     * Cost: O(1).
     * @param units_right - finite, any size
     * @param units_up - finite, any size
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    orbitPan(units_right: number, units_up: number): void;
    /** Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
     * to -pi .. pi in constant time.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the camera was never set to orbit */
    orbitUpdate(): void;
    /** The view frustum, with origin at the camera's position and planes from its parameters: each number
     * within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
     * Gribb-Hartmann in double precision.
     * Cost: O(1). */
    getFrustum(): Frustum;
    /** World positions of the corners of the view frustum, in the order of frustumCorners.
     * Cost: O(1).
     * @returns null with an infinite far plane, or a corner beyond the largest float. */
    getCorners(): number[][] | null;
    /** What is seen in a rectangle of pixels, as Camera.getFrustum: of a tile, a marquee, a portal.
     * Cost: O(1). Since 1.1.
     * @param x0 - pixels, a corner of the rectangle; may lie outside the viewport
     * @param y0 - pixels, a corner of the rectangle; may lie outside the viewport
     * @param x1 - pixels, the opposite corner, in any order; may lie outside the viewport
     * @param y1 - pixels, the opposite corner, in any order; may lie outside the viewport
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if the rectangle has no area, or a side of what a
     *     matrix shows in it lies at infinity or beyond MAX_COORDINATE */
    getRectangleFrustum(x0: number, y0: number, x1: number, y1: number): Frustum;
    /** World positions of the corners of what is seen in a rectangle of pixels, as Camera.getCorners.
     * Cost: O(1). Since 1.1.
     * @param x0 - as Camera.getRectangleFrustum
     * @param y0 - as Camera.getRectangleFrustum
     * @param x1 - as Camera.getRectangleFrustum
     * @param y1 - as Camera.getRectangleFrustum
     * @returns null as Camera.getCorners. */
    getRectangleCorners(x0: number, y0: number, x1: number, y1: number): number[][] | null;
    /** World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
     * viewport; z is the depth in the camera's range.
     * Cost: O(1).
     * @returns null if the point is not in front of the camera's centre (no image), or its image lies
     *     beyond the range of coordinates. */
    project(point: Given<number[]>): number[] | null;
    /** Pixels of count world points, as Camera.project; a point without an image gets x = y = z = INFINITY.
     * Cost: O(elements).
     * @param points - metres */
    projectBatch(points: Floats, out?: Elements): Records<number[]>;
    /** Pixel and depth to world point: the inverse of Camera.project.
     * Cost: O(1).
     * @returns null for the depth of an infinite far plane, and for points beyond that or beyond the range
     *     of coordinates. */
    unproject(pixel: Given<number[]>): number[] | null;
    /** World points of the pixels with depth, as Camera.unproject; one at infinity gets x = y = z =
     * INFINITY.
     * Cost: O(elements).
     * @param pixels - x, y in pixels, z the depth */
    unprojectBatch(pixels: Floats, out?: Elements): Records<number[]>;
    /** The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
     * (INFINITY without one). With PICK_FROM_CENTRE that of a perspective starts at the camera's position.
     * Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, within
     * half an ulp of its direction. Its start is rounded to float32, too, which moves the ray by half an
     * ulp of the coordinates (but not from the camera's position, which has float coordinates);
     * Camera.pick is not limited in this way.
     * Cost: O(1).
     * @param pixel_x - pixels; may lie outside the viewport
     * @param pixel_y - pixels; may lie outside the viewport
     * @returns null if the line of sight does not meet the near plane (user projections), or would begin
     *     beyond MAX_COORDINATE. */
    pickRay(pixel_x: number, pixel_y: number): Ray | null;
    /** Rays for a rectangle of pixel centres, as Camera.pickRay, row by row.
     * Cost: O(width * height).
     * @param x - the left column of the rectangle
     * @param y - its top row
     * @param width - its columns
     * @param height - its rows; width * height fewer than 2^32 */
    pickRays(x: number, y: number, width: number, height: number, out?: Elements): Records<Ray>;
    /** The model under a pixel: the first hit of Camera.pickRay, before that is rounded to float32; t is in
     * metres from where it starts.
     * Cost: O(log n) expected.
     * @param pixel_x - pixels; may lie outside the viewport
     * @param pixel_y - pixels; may lie outside the viewport
     * @returns null if nothing is found. */
    pick(scene: Scene, pixel_x: number, pixel_y: number, layers?: number): Hit | null;
    /** The models under the pixels, as Camera.pick; a pixel without one gets model = 0 and t = INFINITY.
     * Cost: at most that of as many single calls; shared among the scene's workers.
     * @param pixels - x, y pairs of floats */
    pickBatch(scene: Scene, pixels: Floats, layers?: number, out?: Elements): Records<Hit>;
    /** Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
     * tested by their exact shapes, ascending.
     * Cost: that of Scene.overlap.
     * @param x0 - pixels, a corner of the rectangle; may lie outside the viewport
     * @param y0 - pixels, a corner of the rectangle; may lie outside the viewport
     * @param x1 - pixels, the opposite corner, in any order; may lie outside the viewport
     * @param y1 - pixels, the opposite corner, in any order; may lie outside the viewport
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if the rectangle has no area */
    pickRectangle(scene: Scene, x0: number, y0: number, x1: number, y1: number, layers?: number): Records<number>;
    /** Ids of the models to draw: Scene.cull with the camera's frustum.
     * Cost: O(log n + k) expected. */
    cull(scene: Scene, layers?: number): Records<number>;
    /** The model under a pixel that the filter sees, as Camera.pick: what lies behind a selection.
     * Cost: as Scene.raycastFiltered.
     * @param pixel_x - pixels; may lie outside the viewport
     * @param pixel_y - pixels; may lie outside the viewport
     * @param filter - null: the defaults
     * @returns null if nothing is found. */
    pickFiltered(scene: Scene, pixel_x: number, pixel_y: number, filter?: Partial<QueryFilterDesc> | null): Hit | null;
    /** The models under the pixels that the filters see, as Camera.pickBatch.
     * Cost: at most that of as many single calls; shared among the scene's workers.
     * @param pixels - x, y pairs of floats
     * @param filters - null: the defaults */
    pickFilteredBatch(scene: Scene, pixels: Floats, filters?: readonly Partial<QueryFilterDesc>[] | Partial<QueryFilterDesc> | null, out?: Elements): Records<Hit>;
    /** Marquee: ids of all models in the pixel rectangle that the filter sees, as Camera.pickRectangle.
     * Cost: as Scene.overlapFiltered.
     * @param x0 - pixels, a corner of the rectangle
     * @param y0 - pixels, a corner of the rectangle
     * @param x1 - pixels, the opposite corner, in any order
     * @param y1 - pixels, the opposite corner, in any order
     * @param filter - null: the defaults */
    pickRectangleFiltered(scene: Scene, x0: number, y0: number, x1: number, y1: number, filter?: Partial<QueryFilterDesc> | null): Records<number>;
    /** Ids of the models to draw that the filter sees: Scene.cullFiltered with the camera's frustum.
     * Cost: as Scene.cullFiltered.
     * @param filter - null: the defaults */
    cullFiltered(scene: Scene, filter?: Partial<QueryFilterDesc> | null): Records<number>;
}
/** Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
 * results have the same bits for every n. Threads are started, joined and lost as those of Scene.
 *   - desc: null: the defaults
 * Throws GamephysError with ERROR_OUT_OF_MEMORY also if the threads cannot be started.
 * Cost: O(1), and that of starting the threads. */
export class Solver {
    constructor(desc?: Partial<SolverDesc> | null);
    /** Frees the object at once. */
    close(): void;
    [Symbol.dispose](): void;
    /** Throws: an object is not data, and is not cloned. */
    toJSON(): never;
    /** Change the number of threads that share the steps of a solver, as Scene.setWorkerCount. The bits of
     * the motion stay the same.
     * Cost: as Scene.setWorkerCount; allocates. Since 1.1.
     * @param workers - as SolverDesc.worker_count
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the former ones
     *     are kept */
    setWorkerCount(workers: number): void;
    /** How many threads share the steps of a solver, as Scene.getWorkerCount.
     * Cost: O(1). Since 1.1. */
    getWorkerCount(): number;
    /** Move the point of the world that the coordinates of all particles count from; see Scene.setOrigin.
     * Particles stay where they are in the world and keep moving as they do. A step and an attachment need
     * a scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
     * Cost: O(particles).
     * @param origin - x, y, z in the world, metres, within MAX_COORDINATE
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if a particle or an animation target would
     *     leave the range of coordinates */
    setOrigin(origin: ArrayLike<number>): void;
    /** Where in the world the particles' coordinates count from, metres.
     * Cost: O(1). */
    getOrigin(): number[];
    /** Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
     * Cost: O(bodies).
     * @param gravity - m/s^2; may be zero */
    setGravity(gravity: Given<number[]>): void;
    /** Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
     * The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
     * link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
     * (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
     * Cost: O(1).
     * @param substeps - 1 .. 1000 */
    setSubsteps(substeps: number): void;
    /** The settings of a solver as they are.
     * Cost: O(1). */
    getSettings(): SolverSettings;
    /** Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
     * if gravity or the settings of sleep change. Time that Solver.advance owes beyond the new fixed_step
     * is dropped.
     * Cost: O(bodies). */
    setSettings(settings: Given<SolverSettings>): void;
    /** Add a body of particles without constraints.
     * Cost: O(elements).
     * @param desc - null: the defaults
     * @param positions - metres
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies */
    addParticles(positions: Floats, desc?: Partial<BodyDesc> | null): number;
    /** Add a rope through the given points, one particle at each.
     * Cost: O(elements).
     * @param desc - null: the defaults
     * @param positions - metres
     * @param link_length - rest length of each link in metres; 0: as placed. A length below 1e-9 m counts
     *     as 0. Rigid links get their lengths in the first step, and the particles no speed by it.
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies */
    addRope(positions: Floats, link_length?: number, desc?: Partial<BodyDesc> | null): number;
    /** Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
     * corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the order
     * of their ids, are those from row to row, those from column to column, both diagonals (CLOTH_SHEAR),
     * and those that resist folding (CLOTH_BEND); Solver.setConstraintSettings makes them softer or
     * stiffer later.
     * Cost: O(columns * rows).
     * @param desc - null: the defaults
     * @param corner - metres
     * @param edge_u - metres, from the corner along a row
     * @param edge_v - metres, from the corner along a column
     * @param columns - >= 2
     * @param rows - >= 2
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if the edges are parallel or zero
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 particles, links or bodies */
    addCloth(corner: Given<number[]>, edge_u: Given<number[]>, edge_v: Given<number[]>, columns: number, rows: number, desc?: Partial<BodyDesc> | null): number;
    /** Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
     * CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at the same
     * place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a rest
     * length of 0.
     * Cost: O(n log n).
     * @param desc - null: the defaults
     * @param transform - places the mesh; null is the identity
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
     * @throws {GamephysError} ERROR_UNSUPPORTED: for a mesh made from a rope or from particles, which has
     *     no triangles */
    addClothMesh(mesh: Mesh, transform?: Given<Transform> | null, desc?: Partial<BodyDesc> | null): number;
    /** Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
     * the last step are no longer listed.
     * Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
     * impulses to the same models). */
    removeBody(body: number): void;
    /** Ids of all bodies, ascending.
     * Cost: O(bodies). */
    getBodies(): Records<number>;
    /** Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
     * sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by more
     * than sleep_strain; cloth, when its root mean square speed from step to step was no higher, no
     * particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of
     * cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it
     * keeps its contacts, and a step costs it one query for models nearby. It wakes in the next step after
     * a model within reach (as far as one could move in a step at 50 m/s) was added, removed or moved, or
     * a model that it is attached to, or after the scene was replaced; and at once by any change of its
     * state, of gravity or of the origin. Cloth is brought to rest, whatever sleep_speed is, once friction
     * holds it on models that stand still and it moves by centimetres a second without sagging further:
     * within a second it is slowed down to 0. It moves again when one of these models or the body changes.
     * Not in wind, with joints, animation targets, clusters or a volume, or near other bodies.
     * Cost: O(bodies). */
    getSleeping(): Records<number>;
    /** Wake a body; its time of rest begins again.
     * Cost: O(1) a body.
     * @param body - 0: all */
    wake(body: number): void;
    /** The present settings of a body; static_friction as it acts, at least friction.
     * Cost: O(1). */
    getBodySettings(body: number): BodySettings;
    /** Change all settings of a body, from the next step on: read them, change some, and give them back.
     * Wakes the body.
     * Cost: O(1); O(particles) when self_collision changes, and it allocates. */
    setBodySettings(body: number, settings: Given<BodySettings>): void;
    /** What a body is made of and how it is solved.
     * Cost: O(1); after a change of constraints O(particles), and it allocates. */
    getBodyInfo(body: number): BodyInfo;
    /** Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
     * change, and their number does not.
     * Cost: O(triangles). */
    getTriangles(body: number): Records<number>;
    /** The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
     * Cost: O(1); O(particles) for NO_TRIANGLE. Since 1.1.
     * @param triangle - as in a hit, nearest or penetration of the body's mesh: its corners are compared,
     *     of a rope the ends of the link, or the particle; NO_TRIANGLE: all particles
     * @param point - metres, in the solver's coordinates: that of the hit
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: also if the mesh has no such triangle */
    getNearestParticle(body: number, triangle: number, point: Given<number[]>): number;
    /** Where the particles are, metres.
     * Cost: O(count).
     * @param first - the first particle
     * @param count - how many from there on; a range beyond the body is ERROR_INVALID_ARGUMENT */
    getPositions(body: number, first?: number, count?: number, out?: Elements): Records<number[]>;
    /** Move particles at once and without collision on the way; velocities stay as they are. Wakes the
     * body. Rigid links that are too long or too short then get their lengths in the next step, and the
     * particles no speed by it. Pinned particles that are moved alone pull the others: during the next
     * step they go evenly from where they were to their new places, as attached ones do. They are placed
     * at once before the body's first step, or if a free particle of the body is placed as well.
     * Cost: O(elements).
     * @param first - as in Solver.getPositions */
    setPositions(body: number, first: number, positions: Floats): void;
    /** How fast the particles are, m/s.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions
     * @returns 0 of what is pinned and stands still. */
    getVelocities(body: number, first?: number, count?: number, out?: Elements): Records<number[]>;
    /** Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
     * Cost: O(elements).
     * @param first - as in Solver.getPositions
     * @param velocities - m/s */
    setVelocities(body: number, first: number, velocities: Floats): void;
    /** Masses of particles, kg. That of a pinned particle is what it has when it is released.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getMasses(body: number, first?: number, count?: number, out?: Elements): Records<number>;
    /** Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
     * Wakes the body.
     * Cost: O(elements).
     * @param first - as in Solver.getPositions
     * @param masses - kg, > 0 */
    setMasses(body: number, first: number, masses: Floats): void;
    /** Collision radii of particles, metres.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getRadii(body: number, first?: number, count?: number, out?: Elements): Records<number>;
    /** Change the collision radii of particles. Wakes the body.
     * Cost: O(elements).
     * @param first - as in Solver.getPositions
     * @param radii - metres, >= 0 */
    setRadii(body: number, first: number, radii: Floats): void;
    /** Friction factors of particles; 1 until they are set.
     * Cost: O(count). Since 1.1.
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getFrictionFactors(body: number, first?: number, count?: number, out?: Elements): Records<number>;
    /** Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
     * contact, with models and with particles, the coefficients of a particle are the friction and the
     * static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
     * coefficients; Solver.setBodySettings scales them all and keeps the factors. Wakes the body.
     * Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.
     * @param first - as in Solver.getPositions
     * @param factors - >= 0 */
    setFrictionFactors(body: number, first: number, factors: Floats): void;
    /** The forces that were set for particles, newtons.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getForces(body: number, first?: number, count?: number, out?: Elements): Records<number[]>;
    /** Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
     * Cost: O(elements).
     * @param first - as in Solver.getPositions
     * @param forces - newtons */
    setForces(body: number, first: number, forces: Floats): void;
    /** Which particles are pinned or attached.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getPinned(body: number, first?: number, count?: number, out?: Elements): Records<number>;
    /** Pin or release particles. A pinned particle stays where it is put and moves only by
     * Solver.setPositions, or with an animation target of max_distance 0; else its speed is 0. Both
     * pinning and releasing end an attachment.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions
     * @param pinned - true: pin; false: release */
    setPinned(body: number, first?: number, count?: number, pinned?: boolean | number): void;
    /** Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
     * relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
     * C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
     * the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
     * effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
     * along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
     * cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
     * u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
     * reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
     * at the beginning of the step.
     * Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
     * as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.
     * @param body - 0: all bodies there are
     * @param wind - of density 0: no air */
    setWind(body: number, wind: Given<Wind>): void;
    /** The air around a body as it was set; zeros if it was not.
     * Cost: O(1). */
    getWind(body: number): Wind;
    /** Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
     * eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
     * Cost: O(elements); the first time O(particles), and it allocates.
     * @param first - as in Solver.getPositions
     * @param velocities - m/s */
    setAirVelocities(body: number, first: number, velocities: Floats): void;
    /** Velocities of the air at particles, m/s, beside that of Wind.
     * Cost: O(count).
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getAirVelocities(body: number, first?: number, count?: number, out?: Elements): Records<number[]>;
    /** Give particles animation targets, before each step that is to follow an animation: a cape or skirt
     * that is skinned to its character stays within max_distance of the skinned vertices and does not sink
     * into the body behind them. In the next step position and normal go evenly from the old target to the
     * new one, substep by substep; distances act at once. A target that is not set again stands still. A
     * first target, and that of a particle which Solver.setPositions has moved since the last step, takes
     * effect at its new place at once: to teleport, make that call and this one. If the body is attached
     * to a model that jumps (Solver.step), this call alone is enough. max_distance 0 carries a particle:
     * it is at its target, as if attached there, and moves links with infinite mass; this also moves a
     * pinned particle, which stays pinned, at constant speed during a step. Otherwise particles that are
     * pinned or attached are not moved. A particle that is out of its bounds at the end of a substep is
     * put on the nearest place within both, without friction; its velocity across them is then that of the
     * target. What lies within its bounds is not touched. Bounds act after constraints and before models:
     * where a target is inside a model, or behind one, the particle stays outside. Links yield to bounds
     * that contradict them. What hangs from a particle at its bounds is carried, in cloth and in ropes
     * that are moved alone; ropes and free particles that are joined, or collide with bodies, are put back
     * particle by particle, and links beside these may be strained by the motion of a substep. Wakes the
     * body if a target changes.
     * Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
     * particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.
     * @param first - as in Solver.getPositions
     * @param targets - max_distance and backstop INFINITY: no target any more */
    setAnimationTargets(body: number, first: number, targets: Floats): void;
    /** Animation targets of particles as they were set; 0 and INFINITY of what has none.
     * Cost: O(count). Since 1.1.
     * @param first - as in Solver.getPositions
     * @param count - as in Solver.getPositions */
    getAnimationTargets(body: number, first?: number, count?: number, out?: Elements): Records<AnimationTarget>;
    /** Fix a particle to a model: it follows the model's transform in each step, and is released when the
     * model is gone. Steps must then be given this scene; in a step without one the particle stays where
     * it is. If the model jumps (Solver.step), the whole body goes with it as if it were rigid, and its
     * velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
     * particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
     * constraints.
     * Cost: O(1); allocates.
     * @param scene - of the same origin as the solver; not modified
     * @param local_point - in the model's coordinates, to which its transform applies, with the
     *     transform's scale, and not Scene.setScale; null: where the particle is now
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for a particle that does not exist */
    attach(scene: Scene, body: number, particle: number, model: number, local_point?: Given<number[]> | null): void;
    /** Release an attached particle.
     * Cost: O(1).
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: if it is not attached, or does not exist */
    detach(body: number, particle: number): void;
    /** The attachments of a body, by particle. One to a model that is gone is listed until the next step.
     * Cost: O(attachments). Since 1.1. */
    getAttachments(body: number): Records<Attachment>;
    /** Hold two different particles of a body at a distance.
     * Cost: O(1); the next step plans the body again, O(constraints).
     * @param rest_length - metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
     * @param compliance - metres per newton, >= 0; 0 is rigid
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice the same
     *     one
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 constraints of a body */
    addDistance(body: number, particle_a: number, particle_b: number, rest_length: number, compliance?: number): number;
    /** Keep two different particles of a body from being further apart than a length, like a string between
     * them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
     * rigid, only the speed at which the particles separate is lost.
     * Fails as Solver.addDistance.
     * It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
     * strained only when it is too long.
     * Cost: as Solver.addDistance.
     * @param max_length - metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
     * @param compliance - metres per newton, >= 0, of what it yields beyond that; 0 is rigid */
    addMaxDistance(body: number, particle_a: number, particle_b: number, max_length: number, compliance?: number): number;
    /** Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
     * in addition to its tension; one of Solver.addMaxDistance never pushes. The decay depends on time,
     * not on steps. Rigid constraints have nothing to damp.
     * Cost: as Solver.addDistance.
     * @param damping - N s/m, >= 0; 0, which every constraint begins with: none
     * @throws {GamephysError} ERROR_INVALID_ID: for a body or constraint that does not exist */
    setConstraintDamping(body: number, constraint: number, damping: number): void;
    /** Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
     * setting it again changes it, which inflates a body.
     * Cost: O(triangles) in each substep, twice. Allocates.
     * @param rest_volume - m^3, > 0; negative: the present volume
     * @param compliance - m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as
     *     water, which keeps its volume; INFINITY: none, which ends the constraint
     * @throws {GamephysError} ERROR_UNSUPPORTED: if the triangles do not close (each side is that of two
     *     triangles), are not oriented consistently, or face inward when the present volume is asked for */
    setVolume(body: number, rest_volume: number, compliance?: number): void;
    /** The volume held by Solver.setVolume, m^3, as it is, and the pressure in pascals with which it was
     * held at the end of the last step: above 0 it pushes outward.
     * Cost: O(triangles).
     * @throws {GamephysError} ERROR_UNSUPPORTED: if none is held */
    getVolume(body: number): [number, number];
    /** What was given to Solver.setVolume: m^3 (for a negative volume the one at that time), and m^3 per
     * pascal.
     * Cost: O(1). Since 1.1.
     * @throws {GamephysError} ERROR_UNSUPPORTED: if none is held */
    getVolumeSettings(body: number): [number, number];
    /** Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
     * triangles of cloth stay together: Solver.breakConstraint tears them apart.
     * Cost: as Solver.addDistance; allocates.
     * @throws {GamephysError} ERROR_INVALID_ID: for a body or constraint that does not exist, or no longer */
    removeConstraint(body: number, constraint: number): void;
    /** All constraints of a body, including those created with the body, by id.
     * Cost: O(constraints). */
    getConstraints(body: number): Records<ConstraintInfo>;
    /** Which constraints keep a length, and which a maximum.
     * Cost: O(elements). Since 1.1.
     * @param constraints - the ids; one may appear twice */
    getConstraintKinds(body: number, constraints: Words, out?: Elements): Records<number>;
    /** The present settings of constraints.
     * Cost: O(elements).
     * @param constraints - the ids; one may appear twice */
    getConstraintSettings(body: number, constraints: Words, out?: Elements): Records<ConstraintSettings>;
    /** Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
     * the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
     * that is v dt shorter before each step of dt. Wakes the body.
     * Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
     * gets longer links O(n log n). Chains are not planned again. Allocates.
     * @param constraints - the ids; one that appears twice gets the last */
    setConstraintSettings(body: number, constraints: Words, settings: Floats): void;
    /** Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
     * turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links between
     * them are not needed. A particle may be in several clusters: planks with two particles in common are
     * hinged there, with one they are jointed. The mass of a cluster is that of its particles; hollow
     * shapes are light in the middle. Particles that are pinned or attached stay where they are held: with
     * one the cluster swings about it, with two about the line through them, and with three that are not
     * on a line it does not move. Models that particles are attached to get the impulses. Contacts with
     * models move the cluster as a whole, with friction; only particles touch, not the faces between them,
     * so they should be no further apart than the thickness of the thinnest thing that a cluster meets. It
     * bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its
     * restitution that its particles in contact have of its mass. A shape is matched once in each substep,
     * after the links: then what hangs from it by links may be strained a little, and clusters that share
     * particles approach their shapes in eight passes. What is joined to it by Solver.join is solved
     * together with it, unless one of its particles is attached, or another cluster has it, too: hang
     * heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
     * cloth (SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed by a
     * cluster.
     * Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
     * us one that touches a model, and up to eight times that if clusters of the body share particles; the
     * first and the last cluster plan the body again, O(constraints). Since 1.1.
     * @param particles - count different particles, at least 2
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for a particle that does not exist or appears twice
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 clusters of a body, or that many particles
     *     in them */
    addCluster(body: number, particles: Words): number;
    /** End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
     * Cost: O(particles in clusters of the body). Since 1.1.
     * @throws {GamephysError} ERROR_INVALID_ID: for a body or cluster that does not exist, or no longer */
    removeCluster(body: number, cluster: number): void;
    /** All clusters of a body, by id.
     * Cost: O(clusters). Since 1.1. */
    getClusters(body: number): Records<number>;
    /** The particles of a cluster, in the order in which they were given.
     * Cost: O(particles of the cluster). Since 1.1.
     * @throws {GamephysError} ERROR_INVALID_ID: for a body or cluster that does not exist, or no longer */
    getClusterParticles(body: number, cluster: number): Records<number>;
    /** Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
     * are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
     * clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
     * of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
     * longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
     * removed with either body. Particles of the two that are linked to a joint within touch of each other
     * do not collide there.
     * Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
     * of a rope that is not joined. Allocates.
     * @param rest_length - metres; 0: at the same place, as below 1e-9; negative: the present distance.
     *     Particles at another distance are moved to it in the next step; by a rigid joint without speed.
     * @param compliance - metres per newton, >= 0; 0 is rigid
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for a particle that does not exist or twice the same
     *     body (see Solver.addDistance)
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 joints */
    join(body_a: number, particle_a: number, body_b: number, particle_b: number, rest_length: number, compliance?: number): number;
    /** End a joint. Wakes both bodies.
     * Cost: as Solver.join.
     * @throws {GamephysError} ERROR_INVALID_ID: for a joint that does not exist, or no longer */
    unjoin(joint: number): void;
    /** Joints of a body, by id.
     * Cost: O(joints of the solver).
     * @param body - 0: of all bodies */
    getJoints(body: number): Records<JointInfo>;
    /** Breaking forces of constraints. Wakes the body.
     * Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
     * pin. Allocates. Since 1.1.
     * @param constraints - the ids; one that appears twice gets the last
     * @param forces - newtons, >= 0; 0: never breaks, as all that are added to a body later */
    setBreakingForces(body: number, constraints: Words, forces: Floats): void;
    /** What Solver.setBreakingForces or BodyDesc.breaking_force has set; 0: never breaks.
     * Cost: O(elements). Since 1.1.
     * @param constraints - the ids; one may appear twice
     * @returns newtons. */
    getBreakingForces(body: number, constraints: Words, out?: Elements): Records<number>;
    /** Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
     * Cost: O(particles + constraints); allocates. Since 1.1.
     * @returns what came of it.
     * @throws {GamephysError} ERROR_UNSUPPORTED: and nothing has changed, for an edge where the cloth
     *     cannot part: of a triangle that is connected to no other
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^24 - 1 particles or constraints */
    breakConstraint(body: number, constraint: number): Break;
    /** Constraints that broke in the last Solver.step or Solver.advance, in its order: for sounds, dust,
     * and to know that a body has more particles. Not those that the caller broke. They are not part of
     * snapshots: after Solver.restore there are none.
     * Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1. */
    getBreaks(): Records<Break>;
    /** Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
     * takes more where they would be longer than 25 ms.
     * Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
     * through particles. A model moves evenly from its place at the last step to its present one, unless
     * it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
     * that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
     * is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
     * Allocates when what it steps has changed.
     * Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
     * scene query for a body that the last step, of the same dt, left exactly as it was.
     * @param scene - to collide with and to follow attachments; null: none. Not modified.
     * @param dt - seconds, 1e-6 .. 0.5 */
    step(scene: Scene | null, dt: number): void;
    /** Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
     * so the motion does not depend on the frame rate. Models, pins and animation targets are given the
     * places of the end of the frame. They move there evenly in the time since the last step: attached
     * particles, pins and what lies on models are at their places of the time that the solver has reached,
     * leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
     * step.
     * Cost: that of the steps made.
     * @param frame_time - seconds, >= 0
     * @returns steps made. 0 <= fraction of a step still owed < 1, to interpolate when drawing.
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: if there is none for the first step: nothing has
     *     changed. If there is none for a later one */
    advance(scene: Scene | null, frame_time: number): [number, number];
    /** The fraction of a step that Solver.advance still owes: what it gave last as leftover, unless the
     * solver was restored or given another fixed_step since.
     * Cost: O(1). Since 1.1.
     * @returns from 0 to below 1. */
    getLeftover(): number;
    /** The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain or
     * tolerance set, each body takes as many as its own motion needs: their length follows from what the
     * last step measured, the largest strain of its rigid constraints and the local error of the time
     * scheme, both proportional to the square of that length. It is at most quartered and grows by at most
     * an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
     * strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
     * max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
     * by contacts, the error is that of the jump. What may meet others takes at least the set number.
     * Cost: O(1). */
    getSubsteps(body: number): number;
    /** Counts, strain and energy of a body at present.
     * Cost: O(particles + constraints).
     * @param body - 0: all bodies together */
    getStats(body: number): SolverStats;
    /** Contacts of the last step by body, particle, model.
     * Cost: O(contacts). */
    getContacts(): Records<Contact>;
    /** Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b, particle_b:
     * for sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep.
     * Contacts with a body that was removed are no longer listed. They are not part of snapshots: after
     * Solver.restore there are none until the next step. Contacts within a body (BodyDesc.self_collision)
     * are not listed. where particles have more than 12 contacts on average, not all are known.
     * Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1. */
    getBodyContacts(): Records<BodyContact>;
    /** Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
     * which they fell asleep. After Solver.advance, times the steps that it made, they are those of the
     * frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
     * particle of cloth that touches several models at once gives its impulse to the one that it touches
     * most. Models have no mass here: the step does as if they went where you put them, whatever the
     * force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
     * well below the mass of the body, which needs some damping; a body of yours much lighter than what
     * hangs from it should be moved in small steps.
     * Cost: O(models touched); no allocation. The same bits for any number of workers. */
    getImpulses(): Records<Impulse>;
    /** Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
     * impulses, time that Solver.advance still owes. The scene, workers and allocator are not in it.
     * Cost: O(particles + constraints), some 50 words for each.
     * @returns the snapshot. It is for the same release of the library and machines of the same byte
     *     order; it may be stored, but not changed.
     * @throws {GamephysError} ERROR_CAPACITY: beyond 2^32 - 1 words */
    getSnapshot(): Records<number>;
    /** Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
     * time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
     * too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
     * source: all that is used as a number or an index is checked first. Forged words are refused, or
     * taken as a state whose numbers are in range.
     * Cost: as Solver.getSnapshot; allocates.
     * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for words that are no snapshot, damaged, of another
     *     version or byte order
     * @throws {GamephysError} ERROR_OUT_OF_MEMORY: if there is no room for it */
    restore(words: Words): void;
    /** A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
     * different ones differ with near certainty (not against an adversary). Compare it between machines
     * that run the same simulation, to detect when they diverge.
     * Cost: O(particles + constraints). */
    getHash(): number[];
}
/** Whether the fields of the shape are in the ranges stated beside its struct.
 * Cost: O(1).
 * @throws {GamephysError} ERROR_INVALID_ARGUMENT: and the error's message names the field */
export function validate(shape: AnyShape): void;
/** The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
 * Cost: O(1), for a mesh too.
 * @returns null for a plane, a ray without end (or with one beyond all floats) and a frustum that
 *     extends to infinity; for an empty mesh or frustum. */
export function bounds(shape: AnyShape): Aabb | null;
/** Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
 * answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
 * rotation in double precision). Others are as overlaps with a sphere.
 * Cost: O(1); O(log n) expected for a mesh.
 * @param tolerance - metres, >= 0 */
export function contains(shape: AnyShape, point: Given<number[]>, tolerance?: number): boolean;
/** Whether each of the points is within tolerance metres of one shape, as contains.
 * Cost: that of as many single calls.
 * @param tolerance - metres, >= 0, for all points */
export function containsBatch(shape: AnyShape, points: Floats, tolerance?: number, out?: Elements): Records<number>;
/** The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
 * ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
 * difference. If several are equally close, one of them, always the same. For a ray, t is limited by
 * t_max.
 * Cost: O(1); O(log n) expected for a mesh.
 * @returns null only for an empty mesh or an empty frustum. */
export function closestPoint(shape: AnyShape, point: Given<number[]>): Nearest | null;
/** The points of one shape that are closest to each of the points, as closestPoint. An element for
 * which there is none gets distance INFINITY.
 * Cost: that of as many single calls. */
export function closestPointBatch(shape: AnyShape, points: Floats, out?: Elements): Records<Nearest>;
/** The closest points of two segments and their distance. Parallel segments have many: the first along
 * a, always the same.
 * Cost: O(1).
 * @returns metres. */
export function segmentClosestPoints(a: Given<Segment>, b: Given<Segment>): [number[], number[], number];
/** Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
 * frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
 * not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes, triangles, meshes and
 * frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
 * the largest coordinate difference.
 * Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or segment (see segmentTest) */
export function overlaps(a: AnyShape, b: AnyShape): boolean;
/** Whether the shapes of each of the pairs overlap, as overlaps: pair i is a[i] against b[i].
 * Cost: that of as many single calls.
 * @param a - shapes of one type
 * @param b - shapes of one type
 * @throws {GamephysError} ERROR_UNSUPPORTED: for rays and segments */
export function overlapsBatch(a: Shapes | AnyShape, b: Shapes | AnyShape, out?: Elements): Records<number>;
/** Classify a sphere, capsule, AABB, OBB or triangle against a plane.
 * Cost: O(1).
 * @returns metres, of the shape's nearest point to the plane: > 0 in front, < 0 behind, 0 when
 *     crossing.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for other types of shapes */
export function classifyPlane(shape: AnyShape, plane: Given<Plane>): [number, number];
/** Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
 * point is shared, inside that the frustum holds the whole shape.
 * Cost: O(1).
 * @throws {GamephysError} ERROR_UNSUPPORTED: for other types of shapes */
export function classifyFrustum(shape: AnyShape, frustum: Given<Frustum>): number;
/** First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
 * and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
 * always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
 * all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
 * distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
 * docs/accuracy.md has the bounds of all functions.
 * Cost: O(1); O(log n) expected for a mesh.
 * @returns null if nothing is found.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or a segment as the shape */
export function raycast(shape: AnyShape, ray: Given<Ray>): Hit | null;
/** First hits of the rays with one shape, as raycast. A ray that hits nothing gets t = INFINITY,
 * triangle = NO_TRIANGLE and zeros in its hits element.
 * Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or a segment as the shape */
export function raycastBatch(shape: AnyShape, rays: Floats, out?: Elements): Records<Hit>;
/** First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
 * segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
 * direction, the normal is zero.
 * Cost: as raycast.
 * @returns null if nothing is found.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or a segment as the shape */
export function segmentTest(shape: AnyShape, segment: Given<Segment>): Hit | null;
/** First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
 * triangle, frustum or mesh.
 * Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
 * Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
 * mesh.
 * @param displacement - metres; may be zero
 * @returns t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
 *     the sphere's centre; in double precision its dot with the displacement is never above 0. Already
 *     overlapping: t = 0, HIT_INSIDE, and the normal may be along the displacement too; where the
 *     centre itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere
 *     of radius 0 gets the hit of the ray along its path. null if nothing is found.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or a segment as the shape */
export function sweepSphere(shape: AnyShape, sphere: Given<Sphere>, displacement: Given<number[]>): Hit | null;
/** First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
 * sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
 * be the hull of its corners (frustumCorners).
 * Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
 * ulp of t. Point and normal are those of that contact.
 * Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.
 * @param displacement - metres; may be zero
 * @returns t, point and normal as in sweepSphere, which gives the answer for a sphere. The point is
 *     one of those where the two touch, always the same. Already overlapping, except for a sphere: t =
 *     0, HIT_INSIDE, and point and normal of penetration; for a mesh that is not a hull, those of its
 *     first triangle. null if nothing is found.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for a ray or a segment as the shape, for a frustum that
 *     is not the hull of its corners, unless a sphere moves, and for other types that move */
export function sweep(shape: AnyShape, moving: AnyShape, displacement: Given<number[]>): Hit | null;
/** First contacts of count moving shapes of one type with the shapes of another, as sweep: moving[i]
 * with shapes[i]. One that touches nothing gets t = INFINITY, triangle = NO_TRIANGLE and zeros.
 * Cost: that of as many single calls. Since 1.1.
 * @param shapes - shapes of one type
 * @param moving - shapes of one type
 * @param displacements - metres
 * @throws {GamephysError} ERROR_UNSUPPORTED: as sweep */
export function sweepBatch(shapes: Shapes | AnyShape, moving: Shapes | AnyShape, displacements: Floats, out?: Elements): Records<Hit>;
/** The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
 * OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
 * that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
 * translations of their own. Of a hull: out of all of it, and triangle is NO_TRIANGLE. A frustum must
 * be the hull of its corners (frustumCorners).
 * Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
 * ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
 * shape. Added to float positions, the translation may leave an overlap as large as the spacing of
 * floats there.
 * Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
 * separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
 * Keerthi 1988).
 * @returns depth and normal of the translation, which is their product; of several equally short ones
 *     always the same one. The deepest point of the solid is point - depth * normal. null if nothing
 *     is found.
 * @throws {GamephysError} ERROR_UNSUPPORTED: for rays, segments, frusta that are not the hull of their
 *     corners, and for other types that move */
export function penetration(shape: AnyShape, moving: AnyShape): Penetration | null;
/** The shortest translations that take the shapes of one type out of the shapes of another, as
 * penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY, triangle
 * = NO_TRIANGLE and zeros.
 * Cost: that of as many single calls. Since 1.1.
 * @param shapes - shapes of one type
 * @param moving - shapes of one type
 * @throws {GamephysError} ERROR_UNSUPPORTED: as penetration */
export function penetrationBatch(shapes: Shapes | AnyShape, moving: Shapes | AnyShape, out?: Elements): Records<Penetration>;
/** The eight corners, each the intersection of three planes: near then far, each in the order
 * left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
 * intersections themselves, not rounded to floats) if each is within MAX_COORDINATE and in front of
 * the three planes that do not meet there, by more than 2^-39 of its distance from origin; that is,
 * unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and
 * pushed out of it; for the bounds of their errors, origin counts as a corner.
 * Cost: O(1).
 * @returns null if three planes do not meet in a point (infinite far plane), or meet beyond the
 *     largest float. */
export function frustumCorners(frustum: Given<Frustum>): number[][] | null;
/** The point that three planes have in common, within an ulp of each coordinate.
 * Cost: O(1). Source: Cramer's rule. Since 1.1.
 * @returns null if the planes have no single point in common, which is decided exactly, or one beyond
 *     MAX_COORDINATE. */
export function planesIntersection(a: Given<Plane>, b: Given<Plane>, c: Given<Plane>): number[] | null;
/** The points of the triples of planes, as planesIntersection; one without gets x = y = z = INFINITY.
 * Cost: that of as many single calls. Since 1.1.
 * @param a - the planes
 * @param b - the planes
 * @param c - the planes */
export function planesIntersectionBatch(a: Floats, b: Floats, c: Floats, out?: Elements): Records<number[]>;
/** How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
 * the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
 * for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
 * Cost: O(1). Since 1.1.
 * @param matrix - elements within MAX_COORDINATE */
export function mat4Orthonormality(matrix: Matrix): number;
/** The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
 * origin (0, 0, 0). For a camera, Camera.getFrustum is more precise.
 * Cost: O(1).
 * @param reverse_z - false: near has the low depth; true: near has the high depth
 * @throws {GamephysError} ERROR_SINGULAR: if the matrix has no inverse, or what it shows has no
 *     volume: its four near corners are not all finite points in front of the viewer */
export function frustumFromMatrix(view_projection: Matrix, depth_range: number, reverse_z: boolean | number): Frustum;
/** Examine arrays without building anything. Allocates while it runs.
 * Cost: O(n log n).
 * @param vertices - elements of 3 floats, metres
 * @param indices - numbers, three for each triangle
 * @returns what was found; indices out of range and bad vertices are counted, not refused.
 * @throws {GamephysError} ERROR_INVALID_ARGUMENT: for an index_count that is no multiple of 3 */
export function meshCheck(vertices: Floats, indices?: Words | null): MeshReport;
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
export const MESH_SURFACE: 0;
export const MESH_BODY_SURFACE: 1;
export const MESH_BODY_LINKS: 2;
export const MESH_HULL: 3;
export const FILTER_SUBTREE: 1;
export const FILTER_NO_BACK_FACES: 2;
export const FILTER_NO_FRONT_FACES: 4;
export const PROJECTION_PERSPECTIVE: 0;
export const PROJECTION_ORTHOGRAPHIC: 1;
export const PROJECTION_USER: 2;
export const LEFT_HANDED: 0;
export const RIGHT_HANDED: 1;
export const PICK_FROM_NEAR_PLANE: 0;
export const PICK_FROM_CENTRE: 1;
export const CLOTH_SHEAR: 1;
export const CLOTH_BEND: 2;
export const BODY_PARTICLES: 1;
export const BODY_ROPE: 2;
export const BODY_CLOTH: 3;
export const SOLVE_FREE: 0;
export const SOLVE_DIRECT: 1;
export const SOLVE_GRAPH: 2;
export const CONSTRAINT_DISTANCE: 0;
export const CONSTRAINT_MAX_DISTANCE: 1;
export const VERSION_MAJOR: number;
export const VERSION_MINOR: number;
export const VERSION_PATCH: number;
export const MAX_COORDINATE: number;
export const NO_TRIANGLE: number;
export const NO_PARTICLE: number;
export const ALL_LAYERS: number;
