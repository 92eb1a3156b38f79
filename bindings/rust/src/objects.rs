// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
use crate::shapes::*;
use crate::support::*;
use crate::sys;
use crate::types::*;
use std::ffi::c_void;
use std::ptr::{null_mut, NonNull};

impl Vec3 {
    pub fn new(x: f32, y: f32, z: f32) -> Vec3 {
        Vec3 { x, y, z }
    }
}

impl Quat {
    pub fn new(x: f32, y: f32, z: f32, w: f32) -> Quat {
        Quat { x, y, z, w }
    }
}

impl Transform {
    pub fn new(position: impl Into<Vec3>, rotation: impl Into<Quat>, scale: f32) -> Transform {
        Transform { position: position.into(), rotation: rotation.into(), scale }
    }
}

impl Ray {
    pub fn new(origin: impl Into<Vec3>, direction: impl Into<Vec3>, t_max: f32) -> Ray {
        Ray { origin: origin.into(), direction: direction.into(), t_max }
    }
}

impl Segment {
    pub fn new(a: impl Into<Vec3>, b: impl Into<Vec3>) -> Segment {
        Segment { a: a.into(), b: b.into() }
    }
}

impl Sphere {
    pub fn new(center: impl Into<Vec3>, radius: f32) -> Sphere {
        Sphere { center: center.into(), radius }
    }
}

impl Capsule {
    pub fn new(a: impl Into<Vec3>, b: impl Into<Vec3>, radius: f32) -> Capsule {
        Capsule { a: a.into(), b: b.into(), radius }
    }
}

impl Aabb {
    pub fn new(min: impl Into<Vec3>, max: impl Into<Vec3>) -> Aabb {
        Aabb { min: min.into(), max: max.into() }
    }
}

impl Obb {
    pub fn new(center: impl Into<Vec3>, half_extents: impl Into<Vec3>, rotation: impl Into<Quat>) -> Obb {
        Obb { center: center.into(), half_extents: half_extents.into(), rotation: rotation.into() }
    }
}

impl Plane {
    pub fn new(normal: impl Into<Vec3>, distance: f32) -> Plane {
        Plane { normal: normal.into(), distance }
    }
}

impl Triangle {
    pub fn new(a: impl Into<Vec3>, b: impl Into<Vec3>, c: impl Into<Vec3>) -> Triangle {
        Triangle { a: a.into(), b: b.into(), c: c.into() }
    }
}

impl Default for MeshDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_mesh_desc_init(desc, std::mem::size_of::<MeshDesc>() as u32) })
    }
}

impl Default for SceneDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_scene_desc_init(desc, std::mem::size_of::<SceneDesc>() as u32) })
    }
}

impl Default for ModelDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_model_desc_init(desc, std::mem::size_of::<ModelDesc>() as u32) })
    }
}

impl Default for QueryFilterDesc<'_> {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_query_filter_desc_init(desc, std::mem::size_of::<QueryFilterDesc>() as u32) })
    }
}

impl Default for CameraDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_camera_desc_init(desc, std::mem::size_of::<CameraDesc>() as u32) })
    }
}

impl Default for SolverDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_solver_desc_init(desc, std::mem::size_of::<SolverDesc>() as u32) })
    }
}

impl Default for BodyDesc {
    /// The defaults of the loaded library.
    fn default() -> Self {
        initialized(|desc| unsafe { sys::gphys_body_desc_init(desc, std::mem::size_of::<BodyDesc>() as u32) })
    }
}

plain_shape!(Sphere, SPHERE, Sphere);
plain_shape!(Capsule, CAPSULE, Capsule);
plain_shape!(Aabb, AABB, Obb);
plain_shape!(Obb, OBB, Obb);
plain_shape!(Plane, PLANE, Plane);
plain_shape!(Triangle, TRIANGLE, Triangle);
plain_shape!(Frustum, FRUSTUM, Frustum);
plain_shape!(Ray, RAY, Ray);
plain_shape!(Segment, SEGMENT, Segment);

/// A shape of any kind.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum AnyShape {
    Sphere(Sphere),
    Capsule(Capsule),
    Aabb(Aabb),
    Obb(Obb),
    Plane(Plane),
    Triangle(Triangle),
    Frustum(Frustum),
    Ray(Ray),
    Segment(Segment),
}

impl AnyShape {
    pub(crate) fn read(kind: ShapeType, read: impl FnOnce(*mut c_void, u32) -> Result<()>) -> Result<AnyShape> {
        match kind {
            ShapeType::SPHERE => read_plain::<Sphere>(read),
            ShapeType::CAPSULE => read_plain::<Capsule>(read),
            ShapeType::AABB => read_plain::<Aabb>(read),
            ShapeType::OBB => read_plain::<Obb>(read),
            ShapeType::PLANE => read_plain::<Plane>(read),
            ShapeType::TRIANGLE => read_plain::<Triangle>(read),
            ShapeType::FRUSTUM => read_plain::<Frustum>(read),
            ShapeType::RAY => read_plain::<Ray>(read),
            ShapeType::SEGMENT => read_plain::<Segment>(read),
            _ => read_plain::<Sphere>(read),
        }
    }
}

/// Owns a `gphys_mesh` and frees it when dropped.
#[derive(Debug)]
pub struct Mesh {
    pub(crate) handle: NonNull<sys::gphys_mesh>,
}

// Functions that take a const object may run at the same time: they take &self here, all others &mut self.
unsafe impl Send for Mesh {}
unsafe impl Sync for Mesh {}

impl Drop for Mesh {
    fn drop(&mut self) {
        unsafe { sys::gphys_mesh_destroy(self.handle.as_ptr()) }
    }
}

impl Mesh {
    /// Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
    /// segments or points that they are, and the report counts them. 0 triangles are allowed.
    ///
    /// Cost: O(n log n), about 1 us per triangle.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for an index out of range, an index_count that is no multiple of
    ///   3 or a bad vertex; `mesh_check` tells which
    pub fn new<'a>(vertices: impl Into<Batch<'a, Vec3>>, indices: &[u32], desc: Option<&MeshDesc>) -> Result<Mesh> {
        let vertices = vertices.into();
        let indices = Batch::from(indices);
        let mut made = null_mut();
        check(unsafe { sys::gphys_mesh_create(pointer(desc), vertices.data, vertices.stride, vertices.count()?, indices.data, indices.count()?, &mut made) })?;
        Ok(Mesh { handle: NonNull::new(made).expect("a created object") })
    }

    /// Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
    /// wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
    /// stay outside and are pushed out. A ray that starts inside hits at t = 0 with `HIT_INSIDE`; one from
    /// outside hits the face through which it enters, `triangle` says where. Whether a ray hits and whether
    /// a point is inside is exact with respect to the points. Inside, the closest point is the point itself
    /// and triangle `NO_TRIANGLE`. `Mesh::overlap` lists the triangles of the surface; `Mesh::raycast_all`
    /// gives only the first hit. The vertices are the points that are corners of the hull, in their
    /// original order; of equal points the first. The triangles come face by face, all that lie in one
    /// plane being one face; seen from outside their corners go counterclockwise where axes are
    /// right-handed, and the normal cross(b - a, c - a) points out.
    ///
    /// Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
    /// Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.
    ///
    /// * `desc`: deformable must be 0
    /// * `points`: elements of 3 floats, metres; copied
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if a point is out of range or if all lie in a plane, which is
    ///   decided exactly
    /// * `Status::ERROR_CAPACITY`: if the hull has more than 256 faces
    /// * `Status::ERROR_UNSUPPORTED`: if desc asks for a deformable mesh
    pub fn hull<'a>(points: impl Into<Batch<'a, Vec3>>, desc: Option<&MeshDesc>) -> Result<Mesh> {
        let points = points.into();
        let mut made = null_mut();
        check(unsafe { sys::gphys_mesh_create_hull(pointer(desc), points.data, points.stride, points.count()?, &mut made) })?;
        Ok(Mesh { handle: NonNull::new(made).expect("a created object") })
    }

    /// Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
    /// snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
    /// checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
    /// any other; only the counts of its report (triangles of zero area, open edges) are taken from the
    /// words as they are.
    ///
    /// Cost: O(n), a small part of `Mesh`'s; allocates.
    ///
    /// * `desc`: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for words that are no snapshot of a mesh, damaged, of a later
    ///   format or of another byte order
    /// * `Status::ERROR_UNSUPPORTED`: for a deformable hull
    pub fn from_snapshot(words: &[u32], desc: Option<&MeshDesc>) -> Result<Mesh> {
        let words = Batch::from(words);
        let mut made = null_mut();
        check(unsafe { sys::gphys_mesh_create_from_snapshot(pointer(desc), words.data, words.count()?, &mut made) })?;
        Ok(Mesh { handle: NonNull::new(made).expect("a created object") })
    }

    /// A handle of a model's mesh: of the mesh itself, not of a copy, so that what `Mesh::set_vertices`
    /// does to it is seen by all its models. It gives the meshes of a restored scene, which are not
    /// deformable if they were embedded in its snapshot.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// Returns a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the model's shape is no mesh
    pub fn from_scene(scene: &Scene, model: ModelId) -> Result<Mesh> {
        let mut made = null_mut();
        check(unsafe { sys::gphys_scene_get_mesh(scene.handle.as_ptr(), model, &mut made) })?;
        Ok(Mesh { handle: NonNull::new(made).expect("a created object") })
    }

    /// Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
    /// be hit by rays, picked, overlapped and culled as models of scenes (`Scene::add` with
    /// `ShapeType::MESH`; without a transform the model is where the body is) or queried by shape_* and
    /// mesh_* functions. Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the
    /// order of `Solver::get_triangles`. A rope of n particles is solid. In a hit, `triangle` t below n - 1
    /// is the link from particle t to t + 1, a capsule with the smaller of their radii, present while a
    /// constraint holds them together; n - 1 + p is particle p, a sphere, present where no link beside it
    /// is as thick. Free particles are spheres, and `triangle` is the particle.
    /// `Solver::get_nearest_particle` finds the particle of a hit. The mesh has the new form when
    /// `Solver::step`, `Solver::advance`, `Solver::restore` or an edit of the body returns. When cloth
    /// tears (`Break`), its triangles keep their numbers, and the mesh gets vertices for the new particles.
    /// A model that would leave the range of the world, and a torn mesh or one of less than 2^-32 m for
    /// which there is no memory, keep their form until they can follow. `Solver::set_origin` moves the
    /// coordinates of the mesh, and the models back by as much: they stay where they are in the world,
    /// exactly if scenes have moved their origin before. Bodies neither collide with models of such meshes
    /// nor wake because of them: `BodyDesc`.body_layers sets which bodies collide. A restored body is
    /// followed if it has the same id and parts as before. Restore the solver before the scene. A mesh that
    /// is loaded from a snapshot, that of a scene included, is a copy that follows nothing;
    /// `Scene::set_shape` gives its model one that does. Mesh and solver are destroyed in any order. When
    /// the body is gone the mesh keeps the form that it had last and is deformable by `Mesh::set_vertices`,
    /// which returns `Status::ERROR_UNSUPPORTED` before. A mesh that neither its handle nor a model holds
    /// follows no more.
    ///
    /// Threads: the functions above become edits of the mesh and of each scene that has a model of it.
    ///
    /// Cost: as `Mesh`, and then that of `Mesh::set_vertices` for a body that has moved; one that rests is
    /// compared, O(particles). Since 1.1.
    ///
    /// * `desc`: the mesh is deformable whatever it says
    ///
    /// # Safety
    /// As long as the mesh follows the body, no other thread uses the mesh, nor a scene that has a model of
    /// it, while the solver steps, is restored or edits the body.
    pub unsafe fn from_body(solver: &mut Solver, body: BodyId, desc: Option<&MeshDesc>) -> Result<Mesh> {
        let mut made = null_mut();
        check(unsafe { sys::gphys_mesh_create_from_body(pointer(desc), solver.handle.as_ptr(), body, &mut made) })?;
        Ok(Mesh { handle: NonNull::new(made).expect("a created object") })
    }

    /// The planes of a hull's faces: normals are unit and point out, within float32 rounding.
    ///
    /// Cost: O(faces). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for a mesh that is no hull
    pub fn get_hull_planes(&self) -> Result<Vec<Plane>> {
        list(|out_planes, capacity, total| unsafe { sys::gphys_mesh_get_hull_planes(self.handle.as_ptr(), out_planes, capacity, total) })
    }

    /// For each triangle of a hull the index of its face in the list of `Mesh::get_hull_planes`, ascending
    /// from 0.
    ///
    /// Cost: O(triangles). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for a mesh that is no hull
    pub fn get_hull_faces(&self) -> Result<Vec<u32>> {
        list(|out_faces, capacity, total| unsafe { sys::gphys_mesh_get_hull_faces(self.handle.as_ptr(), out_faces, capacity, total) })
    }

    /// Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
    /// `Solver::get_positions` writes it. All models of the mesh take the new form at once, in every scene,
    /// and all answers have the same bits as those of a mesh created from the new vertices. A call that
    /// fails leaves the mesh and the scenes as they were. A solver sees the new form at its next step, as a
    /// surface that stands still.
    ///
    /// Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on
    /// these.
    ///
    /// Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
    /// refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far that
    /// the boxes of their groups of eight have twice the area, once as much as creating it. Allocates.
    /// Since 1.1.
    ///
    /// * `vertices`: elements of 3 floats, metres; copied
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the mesh is not deformable
    /// * `Status::ERROR_INVALID_ARGUMENT`: for a vertex that is not finite or too large, or if a model of
    ///   the mesh would reach beyond the range of coordinates
    ///
    /// # Safety
    /// No other thread uses the mesh, nor a scene that has a model of it, meanwhile.
    pub unsafe fn set_vertices<'a>(&mut self, vertices: impl Into<Batch<'a, Vec3>>) -> Result<()> {
        let vertices = vertices.into();
        check(unsafe { sys::gphys_mesh_set_vertices(self.handle.as_ptr(), vertices.data, vertices.stride, vertices.count()?) })
    }

    /// Kind and size of a mesh, and whether its vertices change.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_info(&self) -> Result<MeshInfo> {
        let mut out_info = MeshInfo::default();
        check(unsafe { sys::gphys_mesh_get_info(self.handle.as_ptr(), &mut out_info) })?;
        Ok(out_info)
    }

    /// What the mesh was built from: the report that `mesh_check` makes of its arrays.
    ///
    /// Cost: O(1); O(triangles) for a deformable mesh.
    pub fn get_report(&self) -> Result<MeshReport> {
        let mut out_report = MeshReport::default();
        check(unsafe { sys::gphys_mesh_get_report(self.handle.as_ptr(), &mut out_report) })?;
        Ok(out_report)
    }

    /// Copy the vertices out, in metres and in their original order.
    ///
    /// Cost: O(vertices).
    pub fn get_vertices(&self) -> Result<Vec<Vec3>> {
        list(|out_vertices, capacity, total| unsafe { sys::gphys_mesh_get_vertices(self.handle.as_ptr(), out_vertices, capacity, total) })
    }

    /// Copy the indices out, three for each triangle, in their original order.
    ///
    /// Cost: O(n).
    pub fn get_indices(&self) -> Result<Vec<u32>> {
        list(|out_indices, capacity, total| unsafe { sys::gphys_mesh_get_indices(self.handle.as_ptr(), out_indices, capacity, total) })
    }

    /// Copy a mesh out with its tree, from which `Mesh` makes it without building the tree.
    ///
    /// Threads: any.
    ///
    /// Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.
    ///
    /// Returns the snapshot. Words are in the machine's byte order. Every later release of the same major
    /// version reads it.
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^32 - 1 words
    pub fn get_snapshot(&self) -> Result<Vec<u32>> {
        list(|out_words, capacity, total| unsafe { sys::gphys_mesh_get_snapshot(self.handle.as_ptr(), out_words, capacity, total) })
    }

    /// All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
    ///
    /// Cost: O(log n + k) expected.
    pub fn raycast_all(&self, ray: &Ray) -> Result<Vec<Hit>> {
        list(|out_hits, capacity, total| unsafe { sys::gphys_mesh_raycast_all(self.handle.as_ptr(), ray, out_hits, capacity, total) })
    }

    /// Whether a ray hits anything; cheaper than the closest hit.
    ///
    /// Cost: O(log n) expected.
    pub fn raycast_any(&self, ray: &Ray) -> Result<bool> {
        let mut out_hit = i32::default();
        check(unsafe { sys::gphys_mesh_raycast_any(self.handle.as_ptr(), ray, &mut out_hit) })?;
        Ok(out_hit != 0)
    }

    /// Whether each of the rays hits anything, as `Mesh::raycast_any`.
    ///
    /// Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1.
    pub fn raycast_any_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, out_hits: impl Into<BatchMut<'a, i32>>) -> Result<()> {
        let rays = rays.into();
        let out_hits = out_hits.into();
        let count = common_length(&[rays.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_mesh_raycast_any_batch(self.handle.as_ptr(), rays.data, rays.stride, count, out_hits.data, out_hits.stride) })
    }

    /// How far each of the rays goes, and which triangle it hits: t and triangle of `raycast_batch` for the
    /// mesh, with the same bits, without the rest of a hit; model is 0.
    ///
    /// Cost: less than that of `raycast_batch`. Since 1.1.
    ///
    /// Returns a ray that hits nothing gets t = INFINITY and triangle = `NO_TRIANGLE`.
    pub fn raycast_distance_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, out_distances: impl Into<BatchMut<'a, Distance>>) -> Result<()> {
        let rays = rays.into();
        let out_distances = out_distances.into();
        let count = common_length(&[rays.length])?;
        out_distances.require(count.into())?;
        check(unsafe { sys::gphys_mesh_raycast_distance_batch(self.handle.as_ptr(), rays.data, rays.stride, count, out_distances.data, out_distances.stride) })
    }

    /// Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
    /// ascending.
    ///
    /// Cost: O(log n + k) expected.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types of shapes
    pub fn overlap(&self, shape: &dyn Shape) -> Result<Vec<u32>> {
        list(|out_triangles, capacity, total| unsafe { sys::gphys_mesh_overlap(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), out_triangles, capacity, total) })
    }

    /// How the mesh's octree is made up.
    ///
    /// Cost: O(nodes).
    pub fn get_octree_stats(&self) -> Result<OctreeStats> {
        let mut out_stats = OctreeStats::default();
        check(unsafe { sys::gphys_mesh_get_octree_stats(self.handle.as_ptr(), &mut out_stats) })?;
        Ok(out_stats)
    }

    /// Boxes of the mesh's octree, each parent before its children.
    ///
    /// Cost: O(nodes).
    pub fn get_octree_boxes(&self) -> Result<Vec<OctreeBox>> {
        list(|out_boxes, capacity, total| unsafe { sys::gphys_mesh_get_octree_boxes(self.handle.as_ptr(), out_boxes, capacity, total) })
    }

}

/// Owns a `gphys_scene` and frees it when dropped.
#[derive(Debug)]
pub struct Scene {
    pub(crate) handle: NonNull<sys::gphys_scene>,
}

// Functions that take a const object may run at the same time: they take &self here, all others &mut self.
unsafe impl Send for Scene {}
unsafe impl Sync for Scene {}

impl Drop for Scene {
    fn drop(&mut self) {
        unsafe { sys::gphys_scene_destroy(self.handle.as_ptr()) }
    }
}

impl Scene {
    /// Create a scene without models. With a worker_count of n, all batch queries of the scene
    /// (`Camera::pick_batch` too), and adding and moving many models, share their work among n threads; the
    /// results have the same bits for every n. Without a task_runner n - 1 threads are started here and
    /// joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
    /// own thread alone. They take no signals but faults, and have the standard floating-point settings. In
    /// a child of fork they are gone: calls there run on one thread, as they do on a platform without
    /// threads (WebAssembly, unless built for shared memory), whatever is asked for.
    ///
    /// Cost: O(reserve_models), and that of starting the threads.
    ///
    /// * `desc`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: also if the threads cannot be started
    /// * `Status::ERROR_CAPACITY`: if reserve_models is above 2^24 - 1
    pub fn new(desc: Option<&SceneDesc>) -> Result<Scene> {
        let mut made = null_mut();
        check(unsafe { sys::gphys_scene_create(pointer(desc), &mut made) })?;
        Ok(Scene { handle: NonNull::new(made).expect("a created object") })
    }

    /// Change the number of threads that share the calls of a scene, for example when the user changes a
    /// setting. They are those of its task_runner if it was created with one. In a child of fork they are
    /// started again. Answers keep their bits.
    ///
    /// Cost: that of joining the former threads and starting others; allocates. Since 1.1.
    ///
    /// * `workers`: as `SceneDesc`.worker_count
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: also if the threads cannot be started; the former ones are kept
    pub fn set_worker_count(&mut self, workers: u32) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_worker_count(self.handle.as_ptr(), workers) })
    }

    /// How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
    /// of fork it is still the number that was set, though calls run on one thread.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_worker_count(&self) -> Result<u32> {
        let mut out_workers = u32::default();
        check(unsafe { sys::gphys_scene_get_worker_count(self.handle.as_ptr(), &mut out_workers) })?;
        Ok(out_workers)
    }

    /// Move the point of the world that all coordinates of the scene are relative to, those passed to it
    /// and those that it returns. Models stay where they are in the world: the positions of those without a
    /// parent become what they are from there, kept in double precision and rounded to float32 once,
    /// however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
    /// and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
    ///
    /// Cost: that of `Scene::set_transforms` of all models, and 24 bytes a model from the first call on.
    /// Queries cost nothing more. Allocates.
    ///
    /// * `origin`: x, y, z in the world, within `MAX_COORDINATE`; before the first call 0 0 0
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if a model would leave the range of coordinates
    pub fn set_origin(&mut self, origin: &[f64; 3]) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_origin(self.handle.as_ptr(), origin.as_ptr()) })
    }

    /// Where in the world the scene's coordinates count from.
    ///
    /// Cost: O(1).
    pub fn get_origin(&self) -> Result<[f64; 3]> {
        let mut out_origin = [f64::default(); 3];
        check(unsafe { sys::gphys_scene_get_origin(self.handle.as_ptr(), out_origin.as_mut_ptr()) })?;
        Ok(out_origin)
    }

    /// Add a model.
    ///
    /// Cost: O(log n) amortised.
    ///
    /// * `shape`: sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
    /// * `shape`: in the model's own coordinates
    /// * `transform`: local; None is the identity
    /// * `desc`: None: no parent, layer 1, tag 0
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for another type, or a scale that the shape cannot have
    ///   (`Scene::set_scale`)
    /// * `Status::ERROR_INVALID_ID`: for a stale parent
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 models
    pub fn add(&mut self, shape: &dyn Shape, transform: Option<&Transform>, desc: Option<&ModelDesc>) -> Result<ModelId> {
        let mut out_model = ModelId::default();
        check(unsafe { sys::gphys_scene_add(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), pointer(transform), pointer(desc), &mut out_model) })?;
        Ok(out_model)
    }

    /// Add the models of one type, all or none, as `Scene::add` does one.
    /// Fails as `Scene::add`.
    ///
    /// Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
    /// is of the order of n.
    ///
    /// * `shapes`: in the models' own coordinates
    /// * `transforms`: local; None is the identity
    /// * `desc`: for all; None: no parent, layer 1, tag 0
    pub fn add_batch<'a>(&mut self, shapes: impl Into<Shapes<'a>>, transforms: impl Into<Batch<'a, Transform>>, desc: Option<&ModelDesc>, out_models: &mut [ModelId]) -> Result<()> {
        let shapes = shapes.into();
        let transforms = transforms.into();
        let out_models = BatchMut::from(out_models);
        let count = common_length(&[shapes.length, transforms.length])?;
        out_models.require(count.into())?;
        check(unsafe { sys::gphys_scene_add_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, transforms.data, transforms.stride, count, pointer(desc), out_models.data) })
    }

    /// Add the models of one type, all or none, each with a desc of its own.
    /// Fails as `Scene::add`; `Status::ERROR_STRUCT_SIZE` as for a single desc.
    ///
    /// Cost: as `Scene::add_batch`.
    ///
    /// * `shapes`: in the models' own coordinates
    /// * `transforms`: local; None is the identity
    /// * `descs`: one for each; None: no parent, layer 1, tag 0. Parents are models that the scene has
    ///   before the call
    pub fn add_described_batch<'a>(&mut self, shapes: impl Into<Shapes<'a>>, transforms: impl Into<Batch<'a, Transform>>, descs: impl Into<Batch<'a, ModelDesc>>, out_models: &mut [ModelId]) -> Result<()> {
        let shapes = shapes.into();
        let transforms = transforms.into();
        let descs = descs.into();
        let out_models = BatchMut::from(out_models);
        let count = common_length(&[shapes.length, transforms.length, descs.length])?;
        out_models.require(count.into())?;
        check(unsafe { sys::gphys_scene_add_described_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, transforms.data, transforms.stride, descs.data, descs.stride, count, out_models.data) })
    }

    /// Remove a model. Its children stay where they are in the world and lose their parent.
    ///
    /// Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory.
    pub fn remove(&mut self, model: ModelId) -> Result<()> {
        check(unsafe { sys::gphys_scene_remove(self.handle.as_ptr(), model) })
    }

    /// Remove models, all or none.
    ///
    /// Cost: that of as many calls of `Scene::remove`. Renews the octree as far as there is memory.
    ///
    /// * `models`: the ids; an id that appears twice is `Status::ERROR_INVALID_ID`
    pub fn remove_batch(&mut self, models: &[ModelId]) -> Result<()> {
        let models = Batch::from(models);
        let count = common_length(&[models.length])?;
        check(unsafe { sys::gphys_scene_remove_batch(self.handle.as_ptr(), models.data, count) })
    }

    /// Remove a model and all its descendants.
    ///
    /// Cost: O(log n) amortised for each. Renews the octree as far as there is memory.
    pub fn remove_subtree(&mut self, model: ModelId) -> Result<()> {
        check(unsafe { sys::gphys_scene_remove_subtree(self.handle.as_ptr(), model) })
    }

    /// Remove all models. Ids given out before stay invalid.
    ///
    /// Cost: O(n).
    pub fn clear(&mut self) -> Result<()> {
        check(unsafe { sys::gphys_scene_clear(self.handle.as_ptr()) })
    }

    /// Ids of all models, ascending.
    ///
    /// Cost: O(n).
    pub fn get_models(&self) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_get_models(self.handle.as_ptr(), out_models, capacity, total) })
    }

    /// Ids of all models without a parent, ascending.
    ///
    /// Cost: O(n).
    pub fn get_roots(&self) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_get_roots(self.handle.as_ptr(), out_models, capacity, total) })
    }

    /// Ids of the direct children of a model, ascending.
    ///
    /// Cost: O(k log k).
    pub fn get_children(&self, model: ModelId) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_get_children(self.handle.as_ptr(), model, out_models, capacity, total) })
    }

    /// Kind, parent, layers, tag and number of children of a model.
    ///
    /// Cost: O(1).
    pub fn get_info(&self, model: ModelId) -> Result<ModelInfo> {
        let mut out_info = ModelInfo::default();
        check(unsafe { sys::gphys_scene_get_info(self.handle.as_ptr(), model, &mut out_info) })?;
        Ok(out_info)
    }

    /// World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
    /// and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
    ///
    /// Cost: O(1).
    ///
    /// Returns `None` for a plane.
    pub fn get_bounds(&self, model: ModelId) -> Result<Option<Aabb>> {
        let mut out_bounds = Aabb::default();
        Ok(found(unsafe { sys::gphys_scene_get_bounds(self.handle.as_ptr(), model, &mut out_bounds) })?.then_some(out_bounds))
    }

    /// World box of all bounded models. Planes are left out.
    ///
    /// Cost: O(1).
    ///
    /// Returns `None` if there are none.
    pub fn get_scene_bounds(&self) -> Result<Option<Aabb>> {
        let mut out_bounds = Aabb::default();
        Ok(found(unsafe { sys::gphys_scene_get_scene_bounds(self.handle.as_ptr(), &mut out_bounds) })?.then_some(out_bounds))
    }

    /// Give a model another shape, or another mesh, of any type that `Scene::add` takes: a character
    /// crouches, a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
    /// transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
    /// do of any solid.
    ///
    /// Cost: as `Scene::set_transform` of a model without children, whatever the size of a mesh.
    ///
    /// * `shape`: as in `Scene::add`: a struct, copied, or a mesh with `ShapeType::MESH`. The scene holds
    ///   the new mesh and no longer the old one, which may be the same.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for a frustum, ray or segment, and for a shape that cannot have the
    ///   model's scale (`Scene::set_scale`)
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if the model would leave the range of the world
    /// * `Status::ERROR_OUT_OF_MEMORY`:
    pub fn set_shape(&mut self, model: ModelId, shape: &dyn Shape) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_shape(self.handle.as_ptr(), model, shape.shape_type(), shape.pointer()) })
    }

    /// Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
    /// unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
    /// normals are those of its surface. Children and attached particles (`Solver::attach`) are not
    /// affected: they follow the transform, whose scale is one number. A new scale replaces the old one. No
    /// scale mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners of each
    /// triangle. There is no form for many models: three equal numbers belong in their transforms
    /// (`Scene::set_transforms`), and `Scene::add_described_batch` takes a scale for each model that it
    /// adds. A mesh or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled
    /// vertices. Of a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule
    /// or plane, and an OBB whose own rotation is not the identity, take three equal numbers only.
    ///
    /// Cost: as `Scene::set_transform` of a model without children. Models that have a scale take 16 bytes
    /// more if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to
    /// 11 % more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of the
    /// scaled vertices, whose tree is made for that form.
    ///
    /// * `scale`: x, y, z, each from 1e-15 to 1e15
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for numbers that are not equal where they have to be, and for the
    ///   mesh of a rope or of particles (`Mesh`) unless it is 1 1 1
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if a coordinate of the scaled shape would exceed
    ///   `MAX_COORDINATE`, if a number times that of a mesh's world transform is not from 1e-15 to 1e15, or
    ///   if the model would leave the range of the world
    /// * `Status::ERROR_OUT_OF_MEMORY`:
    pub fn set_scale(&mut self, model: ModelId, scale: impl Into<Vec3>) -> Result<()> {
        let scale = &scale.into();
        check(unsafe { sys::gphys_scene_set_scale(self.handle.as_ptr(), model, scale) })
    }

    /// The scale of a model's own shape, 1 1 1 unless another was set.
    ///
    /// Cost: O(1).
    pub fn get_scale(&self, model: ModelId) -> Result<Vec3> {
        let mut out_scale = Vec3::default();
        check(unsafe { sys::gphys_scene_get_scale(self.handle.as_ptr(), model, &mut out_scale) })?;
        Ok(out_scale)
    }

    /// Change which queries see a model: those with a mask m of which layers & m is not 0. Children are not
    /// affected.
    ///
    /// Cost: O(1).
    ///
    /// * `layers`: any mask; 0: no query sees it
    pub fn set_layers(&mut self, model: ModelId, layers: u32) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_layers(self.handle.as_ptr(), model, layers) })
    }

    /// Change the number that a model's hits report beside its id. Children are not affected.
    ///
    /// Cost: O(1).
    ///
    /// * `tag`: any number of the caller's
    pub fn set_tag(&mut self, model: ModelId, tag: u32) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_tag(self.handle.as_ptr(), model, tag) })
    }

    /// Make a model the child of another one, or of none (0).
    ///
    /// Cost: O(depth of the tree of models), and as `Scene::set_transform` for what moves. Renews the
    /// octree as far as there is memory.
    ///
    /// * `keep_world`: false: the local transform is kept, the model jumps; true: the local transform is
    ///   changed so that the world transform stays (within float32 rounding)
    ///
    /// # Errors
    /// * `Status::ERROR_CYCLE`: if parent is the model or one of its descendants
    pub fn set_parent(&mut self, model: ModelId, parent: ModelId, keep_world: bool) -> Result<()> {
        let keep_world = i32::from(keep_world);
        check(unsafe { sys::gphys_scene_set_parent(self.handle.as_ptr(), model, parent, keep_world) })
    }

    /// Set a model's local transform. Descendants follow.
    ///
    /// Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.
    ///
    /// * `transform`: relative to the parent; scale > 0
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if it, or a descendant, would leave the range of the world
    pub fn set_transform(&mut self, model: ModelId, transform: &Transform) -> Result<()> {
        check(unsafe { sys::gphys_scene_set_transform(self.handle.as_ptr(), model, transform) })
    }

    /// Set the local transforms of many models, all or none; a model that appears twice gets the last.
    /// Descendants follow.
    ///
    /// Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
    /// the octree as far as there is memory.
    ///
    /// * `models`: the ids
    /// * `transforms`: as in `Scene::set_transform`
    pub fn set_transforms<'a>(&mut self, models: &[ModelId], transforms: impl Into<Batch<'a, Transform>>) -> Result<()> {
        let models = Batch::from(models);
        let transforms = transforms.into();
        let count = common_length(&[models.length, transforms.length])?;
        check(unsafe { sys::gphys_scene_set_transforms(self.handle.as_ptr(), models.data, transforms.data, transforms.stride, count) })
    }

    /// Local transforms of the models, as they were set: relative to the parent.
    ///
    /// Cost: O(elements).
    ///
    /// * `models`: the ids; an id may appear twice
    pub fn get_transforms<'a>(&self, models: &[ModelId], out_transforms: impl Into<BatchMut<'a, Transform>>) -> Result<()> {
        let models = Batch::from(models);
        let out_transforms = out_transforms.into();
        let count = common_length(&[models.length])?;
        out_transforms.require(count.into())?;
        check(unsafe { sys::gphys_scene_get_transforms(self.handle.as_ptr(), models.data, count, out_transforms.data, out_transforms.stride) })
    }

    /// World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
    /// queries are exact with respect to these.
    ///
    /// Cost: O(elements).
    ///
    /// * `models`: the ids; an id may appear twice
    pub fn get_world_transforms<'a>(&self, models: &[ModelId], out_transforms: impl Into<BatchMut<'a, Transform>>) -> Result<()> {
        let models = Batch::from(models);
        let out_transforms = out_transforms.into();
        let count = common_length(&[models.length])?;
        out_transforms.require(count.into())?;
        check(unsafe { sys::gphys_scene_get_world_transforms(self.handle.as_ptr(), models.data, count, out_transforms.data, out_transforms.stride) })
    }

    /// Closest model on a ray; the fields are exact as in `raycast`.
    ///
    /// Cost: O(log n) expected; no allocation.
    ///
    /// Returns `None` if nothing is found.
    pub fn raycast(&self, ray: &Ray, layers: u32) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_raycast(self.handle.as_ptr(), ray, layers, &mut out_hit) })?.then_some(out_hit))
    }

    /// Closest models on the rays, as `Scene::raycast`; a ray that hits nothing gets model = 0 and t =
    /// INFINITY.
    ///
    /// Cost: at most that of as many single calls; shared among workers.
    pub fn raycast_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, layers: u32, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let rays = rays.into();
        let out_hits = out_hits.into();
        let count = common_length(&[rays.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_batch(self.handle.as_ptr(), rays.data, rays.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// How far each of the rays goes, and what it hits: t, model and triangle of `Scene::raycast_batch`,
    /// with the same bits, without the rest of a hit. For lidars and depth images.
    ///
    /// Cost: less than that of `Scene::raycast_batch`; shared among workers. Since 1.1.
    ///
    /// Returns a ray that hits nothing gets t = INFINITY, model = 0 and triangle = `NO_TRIANGLE`.
    pub fn raycast_distance_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, layers: u32, out_distances: impl Into<BatchMut<'a, Distance>>) -> Result<()> {
        let rays = rays.into();
        let out_distances = out_distances.into();
        let count = common_length(&[rays.length])?;
        out_distances.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_distance_batch(self.handle.as_ptr(), rays.data, rays.stride, count, layers, out_distances.data, out_distances.stride) })
    }

    /// Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
    ///
    /// Cost: O(log n) expected.
    pub fn raycast_any(&self, ray: &Ray, layers: u32) -> Result<bool> {
        let mut out_hit = i32::default();
        check(unsafe { sys::gphys_scene_raycast_any(self.handle.as_ptr(), ray, layers, &mut out_hit) })?;
        Ok(out_hit != 0)
    }

    /// Whether each of the rays meets anything, as `Scene::raycast_any`.
    ///
    /// Cost: at most that of as many single calls; shared among workers.
    pub fn raycast_any_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, layers: u32, out_hits: impl Into<BatchMut<'a, i32>>) -> Result<()> {
        let rays = rays.into();
        let out_hits = out_hits.into();
        let count = common_length(&[rays.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_any_batch(self.handle.as_ptr(), rays.data, rays.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// Every model that a ray meets, each once with its first hit, by t, then id.
    ///
    /// Cost: O(log n + k log k) expected.
    pub fn raycast_all(&self, ray: &Ray, layers: u32) -> Result<Vec<Hit>> {
        list(|out_hits, capacity, total| unsafe { sys::gphys_scene_raycast_all(self.handle.as_ptr(), ray, layers, out_hits, capacity, total) })
    }

    /// Every model that each of the rays meets, as `Scene::raycast_all`: the hits of ray i are at
    /// `hits[offsets[i]]` up to offsets[i + 1].
    /// The contents of hits behind the last hit are unspecified.
    ///
    /// Cost: that of as many single calls; shared among workers.
    pub fn raycast_all_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, layers: u32) -> Result<Ragged<Hit>> {
        let rays = rays.into();
        let count = common_length(&[rays.length])?;
        ragged(count, |out_hits, capacity, offsets| unsafe { sys::gphys_scene_raycast_all_batch(self.handle.as_ptr(), rays.data, rays.stride, count, layers, out_hits, capacity, offsets) })
    }

    /// Closest model along a segment from a to b, both included; t in 0..1. Fields as in `segment_test`.
    ///
    /// Cost: O(log n) expected.
    ///
    /// Returns `None` if nothing is found.
    pub fn segment_test(&self, segment: &Segment, layers: u32) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_segment_test(self.handle.as_ptr(), segment, layers, &mut out_hit) })?.then_some(out_hit))
    }

    /// Closest models along the segments, as `Scene::segment_test`; one that hits nothing gets model = 0
    /// and t = INFINITY.
    ///
    /// Cost: that of as many single calls; shared among workers.
    pub fn segment_test_batch<'a>(&self, segments: impl Into<Batch<'a, Segment>>, layers: u32, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let segments = segments.into();
        let out_hits = out_hits.into();
        let count = common_length(&[segments.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_segment_test_batch(self.handle.as_ptr(), segments.data, segments.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
    /// `overlaps`, ascending.
    ///
    /// Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
    /// more saves most of that, unless many models have replaced removed ones.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types of shapes
    pub fn overlap(&self, shape: &dyn Shape, layers: u32) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_overlap(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), layers, out_models, capacity, total) })
    }

    /// Ids of all models that each of the shapes of one type overlaps, as `Scene::overlap`: those of shape
    /// i are at `models[offsets[i]]` up to offsets[i + 1], as in `Scene::raycast_all_batch`.
    ///
    /// Cost: at most that of as many single calls; shared among workers.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as there
    pub fn overlap_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, layers: u32) -> Result<Ragged<ModelId>> {
        let shapes = shapes.into();
        let count = common_length(&[shapes.length])?;
        ragged(count, |out_models, capacity, offsets| unsafe { sys::gphys_scene_overlap_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, count, layers, out_models, capacity, offsets) })
    }

    /// Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
    /// box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
    /// edges are listed, too: a few per cent more where models are compact or not rotated; about a third
    /// more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
    /// many again as are visible where they are as long as the view is wide. `Scene::overlap` leaves these
    /// out by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
    /// listed is best: it is used to order them.
    ///
    /// Cost: O(log n + k) expected.
    pub fn cull(&self, frustum: &Frustum, layers: u32) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_cull(self.handle.as_ptr(), frustum, layers, out_models, capacity, total) })
    }

    /// Ids of the models in each of count frusta, as `Scene::cull`: for split screens, cascades of shadow
    /// maps, faces of a cube map, many sensors. Those of frustum i are at `models[offsets[i]]` up to
    /// offsets[i + 1], as in `Scene::raycast_all_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers. Since 1.1.
    pub fn cull_batch<'a>(&self, frusta: impl Into<Batch<'a, Frustum>>, layers: u32) -> Result<Ragged<ModelId>> {
        let frusta = frusta.into();
        let count = common_length(&[frusta.length])?;
        ragged(count, |out_models, capacity, offsets| unsafe { sys::gphys_scene_cull_batch(self.handle.as_ptr(), frusta.data, frusta.stride, count, layers, out_models, capacity, offsets) })
    }

    /// The model nearest to a point, and its closest point.
    ///
    /// Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
    /// nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
    /// That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
    /// in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
    /// 15 us.
    ///
    /// * `max_distance`: metres, >= 0, INFINITY allowed; a model at exactly this distance counts
    ///
    /// Returns `None` if nothing is found.
    pub fn nearest(&self, point: impl Into<Vec3>, max_distance: f32, layers: u32) -> Result<Option<Nearest>> {
        let point = &point.into();
        let mut out_nearest = Nearest::default();
        Ok(found(unsafe { sys::gphys_scene_nearest(self.handle.as_ptr(), point, max_distance, layers, &mut out_nearest) })?.then_some(out_nearest))
    }

    /// The models nearest to the points, as `Scene::nearest`; a point with none gets model = 0 and distance
    /// = INFINITY.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `max_distance`: metres, >= 0, INFINITY allowed, for all points
    pub fn nearest_batch<'a>(&self, points: impl Into<Batch<'a, Vec3>>, max_distance: f32, layers: u32, out_nearest: impl Into<BatchMut<'a, Nearest>>) -> Result<()> {
        let points = points.into();
        let out_nearest = out_nearest.into();
        let count = common_length(&[points.length])?;
        out_nearest.require(count.into())?;
        check(unsafe { sys::gphys_scene_nearest_batch(self.handle.as_ptr(), points.data, points.stride, count, max_distance, layers, out_nearest.data, out_nearest.stride) })
    }

    /// First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
    /// `sweep_sphere`.
    ///
    /// Cost: O(log n + k) expected, k the models that the swept box touches.
    ///
    /// * `displacement`: metres; may be zero
    ///
    /// Returns `None` if nothing is found.
    pub fn sweep_sphere(&self, sphere: &Sphere, displacement: impl Into<Vec3>, layers: u32) -> Result<Option<Hit>> {
        let displacement = &displacement.into();
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_sweep_sphere(self.handle.as_ptr(), sphere, displacement, layers, &mut out_hit) })?.then_some(out_hit))
    }

    /// First models that the spheres touch while each moves by its displacement, as `Scene::sweep_sphere`;
    /// one that touches nothing gets model = 0 and t = INFINITY.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `displacements`: metres
    pub fn sweep_sphere_batch<'a>(&self, spheres: impl Into<Batch<'a, Sphere>>, displacements: impl Into<Batch<'a, Vec3>>, layers: u32, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let spheres = spheres.into();
        let displacements = displacements.into();
        let out_hits = out_hits.into();
        let count = common_length(&[spheres.length, displacements.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_sweep_sphere_batch(self.handle.as_ptr(), spheres.data, spheres.stride, displacements.data, displacements.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
    /// turning; t in 0..1. Fields as in `sweep`.
    ///
    /// Cost: O(log n + k) expected, k the models that the swept box touches.
    ///
    /// * `displacement`: metres; may be zero
    ///
    /// Returns `None` if nothing is found.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types
    pub fn sweep(&self, shape: &dyn Shape, displacement: impl Into<Vec3>, layers: u32) -> Result<Option<Hit>> {
        let displacement = &displacement.into();
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_sweep(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), displacement, layers, &mut out_hit) })?.then_some(out_hit))
    }

    /// First models that the shapes of one type touch while each moves by its displacement, as
    /// `Scene::sweep`; one that touches nothing gets model = 0 and t = INFINITY.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `displacements`: metres
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as `Scene::sweep`
    pub fn sweep_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, displacements: impl Into<Batch<'a, Vec3>>, layers: u32, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let shapes = shapes.into();
        let displacements = displacements.into();
        let out_hits = out_hits.into();
        let count = common_length(&[shapes.length, displacements.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_sweep_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, displacements.data, displacements.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
    /// a mesh one for each triangle, as `penetration`. Deepest first; equal depths by model, then triangle.
    /// Each is the way out of that one alone. The models are those of `Scene::overlap`.
    ///
    /// Cost: O(log n + k log k) expected.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types
    pub fn penetration(&self, shape: &dyn Shape, layers: u32) -> Result<Vec<Penetration>> {
        list(|out_penetrations, capacity, total| unsafe { sys::gphys_scene_penetration(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), layers, out_penetrations, capacity, total) })
    }

    /// What each of the shapes of one type overlaps, and how it gets out, as `Scene::penetration`: the ways
    /// out of shape i are at `penetrations[offsets[i]]` up to offsets[i + 1], as in
    /// `Scene::raycast_all_batch`. So a crowd of characters is pushed out in one call.
    ///
    /// Cost: that of as many single calls; shared among workers. Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as `Scene::penetration`
    pub fn penetration_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, layers: u32) -> Result<Ragged<Penetration>> {
        let shapes = shapes.into();
        let count = common_length(&[shapes.length])?;
        ragged(count, |out_penetrations, capacity, offsets| unsafe { sys::gphys_scene_penetration_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, count, layers, out_penetrations, capacity, offsets) })
    }

    /// Closest model on a ray that the filter sees, as `Scene::raycast`.
    ///
    /// Cost: that of `Scene::raycast` for one ignored model. For each model that is met within the ray's
    /// reach, besides: O(its depth below its root) with `FILTER_SUBTREE` if ignored_model has children; of
    /// m ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
    /// they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time.
    ///
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for unknown flags, or ignored_models None with an ignored_count
    ///   above 0
    pub fn raycast_filtered(&self, ray: &Ray, filter: Option<&QueryFilterDesc>) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_raycast_filtered(self.handle.as_ptr(), ray, pointer(filter), &mut out_hit) })?.then_some(out_hit))
    }

    /// Closest models on the rays that the filters see, as `Scene::raycast_batch`.
    ///
    /// Cost: at most that of as many calls of `Scene::raycast_filtered`; shared among workers.
    ///
    /// * `filters`: None: the defaults
    pub fn raycast_filtered_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let rays = rays.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[rays.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_filtered_batch(self.handle.as_ptr(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// How far each of the rays goes among the models that its filter sees, as
    /// `Scene::raycast_distance_batch`: a lidar leaves out the robot that carries it.
    ///
    /// Cost: less than that of `Scene::raycast_filtered_batch`; shared among workers. Since 1.1.
    ///
    /// * `filters`: None: the defaults
    pub fn raycast_distance_filtered_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_distances: impl Into<BatchMut<'a, Distance>>) -> Result<()> {
        let rays = rays.into();
        let filters = filters.into();
        let out_distances = out_distances.into();
        let count = common_length(&[rays.length, filters.length])?;
        out_distances.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_distance_filtered_batch(self.handle.as_ptr(), rays.data, rays.stride, count, filters.data, filters.stride, out_distances.data, out_distances.stride) })
    }

    /// Whether a ray meets anything that the filter sees, as `Scene::raycast_any`: line of sight between
    /// two models that both are left out.
    ///
    /// Cost: as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    pub fn raycast_any_filtered(&self, ray: &Ray, filter: Option<&QueryFilterDesc>) -> Result<bool> {
        let mut out_hit = i32::default();
        check(unsafe { sys::gphys_scene_raycast_any_filtered(self.handle.as_ptr(), ray, pointer(filter), &mut out_hit) })?;
        Ok(out_hit != 0)
    }

    /// Whether each of the rays meets anything that its filter sees, as `Scene::raycast_any_batch`.
    ///
    /// Cost: at most that of as many single calls; shared among workers.
    ///
    /// * `filters`: None: the defaults
    pub fn raycast_any_filtered_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, i32>>) -> Result<()> {
        let rays = rays.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[rays.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_raycast_any_filtered_batch(self.handle.as_ptr(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// Every model that a ray meets and the filter sees, as `Scene::raycast_all`.
    ///
    /// Cost: that of `Scene::raycast_all`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    pub fn raycast_all_filtered(&self, ray: &Ray, filter: Option<&QueryFilterDesc>) -> Result<Vec<Hit>> {
        list(|out_hits, capacity, total| unsafe { sys::gphys_scene_raycast_all_filtered(self.handle.as_ptr(), ray, pointer(filter), out_hits, capacity, total) })
    }

    /// Every model that each of the rays meets and its filter sees, as `Scene::raycast_all_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `filters`: None: the defaults
    pub fn raycast_all_filtered_batch<'a>(&self, rays: impl Into<Batch<'a, Ray>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>) -> Result<Ragged<Hit>> {
        let rays = rays.into();
        let filters = filters.into();
        let count = common_length(&[rays.length, filters.length])?;
        ragged(count, |out_hits, capacity, offsets| unsafe { sys::gphys_scene_raycast_all_filtered_batch(self.handle.as_ptr(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits, capacity, offsets) })
    }

    /// Closest model along a segment that the filter sees, as `Scene::segment_test`.
    ///
    /// Cost: as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    pub fn segment_test_filtered(&self, segment: &Segment, filter: Option<&QueryFilterDesc>) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_segment_test_filtered(self.handle.as_ptr(), segment, pointer(filter), &mut out_hit) })?.then_some(out_hit))
    }

    /// Closest models along the segments that the filters see, as `Scene::segment_test_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `filters`: None: the defaults
    pub fn segment_test_filtered_batch<'a>(&self, segments: impl Into<Batch<'a, Segment>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let segments = segments.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[segments.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_segment_test_filtered_batch(self.handle.as_ptr(), segments.data, segments.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// Ids of all models that overlap a shape and that the filter sees, as `Scene::overlap`.
    ///
    /// Cost: that of `Scene::overlap`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for types of shapes that `Scene::overlap` does not take
    pub fn overlap_filtered(&self, shape: &dyn Shape, filter: Option<&QueryFilterDesc>) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_overlap_filtered(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), pointer(filter), out_models, capacity, total) })
    }

    /// Ids of all models that each of the shapes of one type overlaps and its filter sees, as
    /// `Scene::overlap_batch`.
    ///
    /// Cost: at most that of as many single calls; shared among workers.
    ///
    /// * `filters`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as there
    pub fn overlap_filtered_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>) -> Result<Ragged<ModelId>> {
        let shapes = shapes.into();
        let filters = filters.into();
        let count = common_length(&[shapes.length, filters.length])?;
        ragged(count, |out_models, capacity, offsets| unsafe { sys::gphys_scene_overlap_filtered_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, count, filters.data, filters.stride, out_models, capacity, offsets) })
    }

    /// Ids of all models in a frustum, by their world boxes, that the filter sees, as `Scene::cull`: a
    /// player's own head, say, is not drawn.
    ///
    /// Cost: that of `Scene::cull`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    pub fn cull_filtered(&self, frustum: &Frustum, filter: Option<&QueryFilterDesc>) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_scene_cull_filtered(self.handle.as_ptr(), frustum, pointer(filter), out_models, capacity, total) })
    }

    /// Ids of the models in each of count frusta that its filter sees, as `Scene::cull_batch`: each
    /// player's view leaves out the player's own head.
    ///
    /// Cost: that of as many single calls; shared among workers. Since 1.1.
    ///
    /// * `filters`: None: the defaults
    pub fn cull_filtered_batch<'a>(&self, frusta: impl Into<Batch<'a, Frustum>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>) -> Result<Ragged<ModelId>> {
        let frusta = frusta.into();
        let filters = filters.into();
        let count = common_length(&[frusta.length, filters.length])?;
        ragged(count, |out_models, capacity, offsets| unsafe { sys::gphys_scene_cull_filtered_batch(self.handle.as_ptr(), frusta.data, frusta.stride, count, filters.data, filters.stride, out_models, capacity, offsets) })
    }

    /// The model nearest to a point that the filter sees, as `Scene::nearest`: the nearest other model, if
    /// the one at the point is left out.
    ///
    /// Cost: that of `Scene::nearest`, and for each model as `Scene::raycast_filtered`; each ignored model
    /// that is nearer than the answer is visited.
    ///
    /// * `max_distance`: metres, >= 0, INFINITY allowed; a model at exactly this distance counts
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    pub fn nearest_filtered(&self, point: impl Into<Vec3>, max_distance: f32, filter: Option<&QueryFilterDesc>) -> Result<Option<Nearest>> {
        let point = &point.into();
        let mut out_nearest = Nearest::default();
        Ok(found(unsafe { sys::gphys_scene_nearest_filtered(self.handle.as_ptr(), point, max_distance, pointer(filter), &mut out_nearest) })?.then_some(out_nearest))
    }

    /// The models nearest to the points that the filters see, as `Scene::nearest_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `max_distance`: metres, >= 0, INFINITY allowed, for all points
    /// * `filters`: None: the defaults
    pub fn nearest_filtered_batch<'a>(&self, points: impl Into<Batch<'a, Vec3>>, max_distance: f32, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_nearest: impl Into<BatchMut<'a, Nearest>>) -> Result<()> {
        let points = points.into();
        let filters = filters.into();
        let out_nearest = out_nearest.into();
        let count = common_length(&[points.length, filters.length])?;
        out_nearest.require(count.into())?;
        check(unsafe { sys::gphys_scene_nearest_filtered_batch(self.handle.as_ptr(), points.data, points.stride, count, max_distance, filters.data, filters.stride, out_nearest.data, out_nearest.stride) })
    }

    /// First model that a moving sphere touches and the filter sees, as `Scene::sweep_sphere`: the sphere
    /// may be the bounding sphere of the ignored model.
    ///
    /// Cost: that of `Scene::sweep_sphere`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `displacement`: metres; may be zero
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    pub fn sweep_sphere_filtered(&self, sphere: &Sphere, displacement: impl Into<Vec3>, filter: Option<&QueryFilterDesc>) -> Result<Option<Hit>> {
        let displacement = &displacement.into();
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_sweep_sphere_filtered(self.handle.as_ptr(), sphere, displacement, pointer(filter), &mut out_hit) })?.then_some(out_hit))
    }

    /// First models that count moving spheres touch and the filters see, as `Scene::sweep_sphere_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `displacements`: metres
    /// * `filters`: None: the defaults
    pub fn sweep_sphere_filtered_batch<'a>(&self, spheres: impl Into<Batch<'a, Sphere>>, displacements: impl Into<Batch<'a, Vec3>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let spheres = spheres.into();
        let displacements = displacements.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[spheres.length, displacements.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_sweep_sphere_filtered_batch(self.handle.as_ptr(), spheres.data, spheres.stride, displacements.data, displacements.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as
    /// `Scene::sweep`: a character leaves out its own model.
    ///
    /// Cost: that of `Scene::sweep`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `displacement`: metres; may be zero
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types
    pub fn sweep_filtered(&self, shape: &dyn Shape, displacement: impl Into<Vec3>, filter: Option<&QueryFilterDesc>) -> Result<Option<Hit>> {
        let displacement = &displacement.into();
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_scene_sweep_filtered(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), displacement, pointer(filter), &mut out_hit) })?.then_some(out_hit))
    }

    /// First models that count moving shapes of one type touch and the filters see, as
    /// `Scene::sweep_batch`.
    ///
    /// Cost: that of as many single calls; shared among workers.
    ///
    /// * `displacements`: metres
    /// * `filters`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as `Scene::sweep`
    pub fn sweep_filtered_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, displacements: impl Into<Batch<'a, Vec3>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let shapes = shapes.into();
        let displacements = displacements.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[shapes.length, displacements.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_scene_sweep_filtered_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, displacements.data, displacements.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
    /// `Scene::penetration`.
    ///
    /// Cost: that of `Scene::penetration`, and for each model as `Scene::raycast_filtered`.
    ///
    /// * `filter`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: for other types
    pub fn penetration_filtered(&self, shape: &dyn Shape, filter: Option<&QueryFilterDesc>) -> Result<Vec<Penetration>> {
        list(|out_penetrations, capacity, total| unsafe { sys::gphys_scene_penetration_filtered(self.handle.as_ptr(), shape.shape_type(), shape.pointer(), pointer(filter), out_penetrations, capacity, total) })
    }

    /// What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
    /// `Scene::penetration_batch`: each character leaves out its own model.
    ///
    /// Cost: that of as many single calls; shared among workers. Since 1.1.
    ///
    /// * `filters`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: as `Scene::penetration`
    pub fn penetration_filtered_batch<'a>(&self, shapes: impl Into<Shapes<'a>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>) -> Result<Ragged<Penetration>> {
        let shapes = shapes.into();
        let filters = filters.into();
        let count = common_length(&[shapes.length, filters.length])?;
        ragged(count, |out_penetrations, capacity, offsets| unsafe { sys::gphys_scene_penetration_filtered_batch(self.handle.as_ptr(), shapes.shape_type(), shapes.data, shapes.stride, count, filters.data, filters.stride, out_penetrations, capacity, offsets) })
    }

    /// Rebuild the scene's octree, as good as that of one `Scene::add_batch`. Never required: ids, answers
    /// and their bits do not change. Where many models were added one by one, such as a level that was
    /// streamed in, rays then take 0.6 to 0.95 of the time.
    ///
    /// Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: with nothing changed
    pub fn rebuild_octree(&mut self) -> Result<()> {
        check(unsafe { sys::gphys_scene_rebuild_octree(self.handle.as_ptr()) })
    }

    /// Rebuild the octree in parts, one in each call, until it is as good as after `Scene::rebuild_octree`:
    /// for levels that are streamed in while frames go on. Each `Scene::add` and `Scene::remove` does a
    /// part by itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are.
    /// Models may be added, moved and removed between the calls. A call that updates an eighth of them or
    /// more restarts it.
    ///
    /// Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.
    ///
    /// * `budget`: how much work to do, as a number of models, of 0.3 to 3 us each. The work is the same on
    ///   every machine and does not depend on time.
    ///
    /// Returns 1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
    /// again.
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: : the octree is as before, and the next call begins again
    pub fn maintain_octree(&mut self, budget: u32) -> Result<bool> {
        let mut out_done = i32::default();
        check(unsafe { sys::gphys_scene_maintain_octree(self.handle.as_ptr(), budget, &mut out_done) })?;
        Ok(out_done != 0)
    }

    /// How the scene's octree is made up.
    ///
    /// Cost: O(nodes).
    pub fn get_octree_stats(&self) -> Result<OctreeStats> {
        let mut out_stats = OctreeStats::default();
        check(unsafe { sys::gphys_scene_get_octree_stats(self.handle.as_ptr(), &mut out_stats) })?;
        Ok(out_stats)
    }

    /// Boxes of the scene's octree, each parent before its children.
    ///
    /// Cost: O(nodes).
    pub fn get_octree_boxes(&self) -> Result<Vec<OctreeBox>> {
        list(|out_boxes, capacity, total| unsafe { sys::gphys_scene_get_octree_boxes(self.handle.as_ptr(), out_boxes, capacity, total) })
    }

    /// Check the scene's own structure: every model once in the tree, every box around its content, parents
    /// and children in agreement, free slots free. For tests.
    ///
    /// Cost: O(n).
    ///
    /// # Errors
    /// * `Status::ERROR_INTERNAL`: and the error's message says what is wrong
    pub fn validate(&self) -> Result<()> {
        check(unsafe { sys::gphys_scene_validate(self.handle.as_ptr()) })
    }

    /// Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
    /// shapes, the order of future ids, and the octree. Workers and allocator are not in it.
    ///
    /// Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (`Mesh::get_snapshot`).
    /// Allocates a few words for each different mesh.
    ///
    /// * `embed_meshes`: true: meshes are in the snapshot, each once, so it is complete in itself: for
    ///   saved games and for other machines. false: they are identified by their content, and
    ///   `Scene::restore` looks for them: for undo, and rollback each frame.
    ///
    /// Returns the snapshot. Words are in the machine's byte order. Every later release of the same major
    /// version reads it.
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^32 - 1 words
    pub fn get_snapshot(&self, embed_meshes: bool) -> Result<Vec<u32>> {
        let embed_meshes = i32::from(embed_meshes);
        list(|out_words, capacity, total| unsafe { sys::gphys_scene_get_snapshot(self.handle.as_ptr(), embed_meshes, out_words, capacity, total) })
    }

    /// Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
    /// time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
    /// that is restored with its scene continues with the same bits. On an error the scene is as before.
    /// Any words are safe, also from an untrusted source: all that is used as a number or an index is
    /// checked first. Forged words are refused, or taken as a scene like any other.
    ///
    /// Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (`Mesh`). Allocates.
    ///
    /// * `library`: meshes that are not embedded are looked for among those that models of this scene use,
    ///   by their content: vertices and indices. A mesh deformed since must get its old form back first.
    ///   None: among those that models of `scene` itself use, before it is restored.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for words that are no snapshot of a scene, damaged, of a later
    ///   format or of another byte order, and if a mesh is missing
    /// * `Status::ERROR_OUT_OF_MEMORY`: if there is no room for it
    pub fn restore(&mut self, library: Option<&Scene>, words: &[u32]) -> Result<()> {
        let words = Batch::from(words);
        let count = common_length(&[words.length])?;
        check(unsafe { sys::gphys_scene_restore(self.handle.as_ptr(), library.map_or(null_mut(), |o| o.handle.as_ptr()), words.data, count) })
    }

    /// A hash of the whole state except the octree, the low half first; meshes count by their content.
    /// Equal states have equal hashes on every machine; different ones differ with near certainty (not
    /// against an adversary). Compare it between machines that run the same simulation, to detect when they
    /// diverge.
    ///
    /// Cost: O(n), some 50 ns for each model.
    pub fn get_hash(&self) -> Result<[u32; 2]> {
        let mut out_hash = [u32::default(); 2];
        check(unsafe { sys::gphys_scene_get_hash(self.handle.as_ptr(), out_hash.as_mut_ptr()) })?;
        Ok(out_hash)
    }

}

/// Owns a `gphys_camera` and frees it when dropped.
#[derive(Debug)]
pub struct Camera {
    pub(crate) handle: NonNull<sys::gphys_camera>,
}

// Functions that take a const object may run at the same time: they take &self here, all others &mut self.
unsafe impl Send for Camera {}
unsafe impl Sync for Camera {}

impl Drop for Camera {
    fn drop(&mut self) {
        unsafe { sys::gphys_camera_destroy(self.handle.as_ptr()) }
    }
}

impl Camera {
    /// Create a camera at the origin, with the projection and the viewport of its desc.
    ///
    /// Cost: O(1).
    ///
    /// * `desc`: None: the defaults
    pub fn new(desc: Option<&CameraDesc>) -> Result<Camera> {
        let mut made = null_mut();
        check(unsafe { sys::gphys_camera_create(pointer(desc), &mut made) })?;
        Ok(Camera { handle: NonNull::new(made).expect("a created object") })
    }

    /// Move the point of the world that the camera's coordinates count from; see `Scene::set_origin`. The
    /// camera and the target of its orbit stay where they are in the world. Picking and culling need a
    /// scene of the same origin, else they fail with `Status::ERROR_INVALID_ARGUMENT`.
    ///
    /// Cost: O(1).
    ///
    /// * `origin`: x, y, z in the world, metres, within `MAX_COORDINATE`
    pub fn set_origin(&mut self, origin: &[f64; 3]) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_origin(self.handle.as_ptr(), origin.as_ptr()) })
    }

    /// Where in the world the camera's coordinates count from, metres.
    ///
    /// Cost: O(1).
    pub fn get_origin(&self) -> Result<[f64; 3]> {
        let mut out_origin = [f64::default(); 3];
        check(unsafe { sys::gphys_camera_get_origin(self.handle.as_ptr(), out_origin.as_mut_ptr()) })?;
        Ok(out_origin)
    }

    /// Use a perspective projection: distant objects appear smaller.
    ///
    /// Cost: O(1).
    ///
    /// * `fov_y`: full vertical angle in radians, 1e-6 <= fov_y < pi
    /// * `near_distance`: metres, > 0
    /// * `far_distance`: metres, > near_distance; INFINITY allowed
    pub fn set_perspective(&mut self, fov_y: f32, near_distance: f32, far_distance: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_perspective(self.handle.as_ptr(), fov_y, near_distance, far_distance) })
    }

    /// Use an orthographic projection: the distance does not change apparent size.
    ///
    /// Cost: O(1).
    ///
    /// * `height`: metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is at
    ///   most twice `MAX_COORDINATE`
    /// * `near_distance`: metres, may be negative
    /// * `far_distance`: metres, at least 1e-6 above near_distance
    pub fn set_orthographic(&mut self, height: f32, near_distance: f32, far_distance: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_orthographic(self.handle.as_ptr(), height, near_distance, far_distance) })
    }

    /// Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
    /// library's). It is not changed by `Camera::set_viewport`.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_SINGULAR`: if it has no inverse, or is too close to such a matrix to tell
    /// * `Status::ERROR_INVALID_ARGUMENT`: if a plane other than far lies at infinity, as it does when the
    ///   matrix is for another depth range, or one lies beyond `MAX_COORDINATE`
    pub fn set_projection(&mut self, projection: &Mat4) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_projection(self.handle.as_ptr(), projection) })
    }

    /// As `Camera::set_perspective`, with a fixed aspect ratio: the image is stretched to the viewport, as
    /// with pixels that are not square, and the viewport does not change what is seen.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// * `fov_y`: full vertical angle in radians, 1e-6 <= fov_y < pi
    /// * `aspect`: width over height of what is seen, 1e-6 .. 1e6
    /// * `near_distance`: metres, > 0
    /// * `far_distance`: metres, > near_distance; INFINITY allowed
    pub fn set_perspective_aspect(&mut self, fov_y: f32, aspect: f32, near_distance: f32, far_distance: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_perspective_aspect(self.handle.as_ptr(), fov_y, aspect, near_distance, far_distance) })
    }

    /// As `Camera::set_orthographic`, with a width of its own, which the viewport does not change.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// * `width`: metres seen from left to right, >= 1e-6
    /// * `height`: metres seen from top to bottom, >= 1e-6
    /// * `near_distance`: metres, may be negative
    /// * `far_distance`: metres, at least 1e-6 above near_distance
    pub fn set_orthographic_size(&mut self, width: f32, height: f32, near_distance: f32, far_distance: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_orthographic_size(self.handle.as_ptr(), width, height, near_distance, far_distance) })
    }

    /// Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height; the
    /// call is refused if that makes the width more than twice `MAX_COORDINATE`.
    ///
    /// Cost: O(1).
    ///
    /// * `width`, `height`: pixels, 1e-3 .. 1e6
    pub fn set_viewport(&mut self, width: f32, height: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_viewport(self.handle.as_ptr(), width, height) })
    }

    /// Where the viewport is in its window, as one of several of a split screen: pixels of all functions
    /// count from the window's top left corner. (0, 0) at creation.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// * `x`: pixels from the window's left edge to the viewport's
    /// * `y`: pixels from the window's top edge to the viewport's
    pub fn set_viewport_origin(&mut self, x: f32, y: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_viewport_origin(self.handle.as_ptr(), x, y) })
    }

    /// Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
    /// rays of other projections always begin there.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn set_pick_start(&mut self, start: PickStart) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_pick_start(self.handle.as_ptr(), start) })
    }

    /// How the camera projects, as it was set.
    ///
    /// Cost: O(1).
    ///
    /// Returns what of the following was called last: `Camera::set_perspective`, as at creation,
    /// `Camera::set_orthographic` (or those with a width of their own), or `Camera::set_projection`. the
    /// vertical field of view in radians of a perspective, the height in metres of an orthographic
    /// projection, 0 of a matrix. the distance of the near plane, metres; 0 of a matrix. that of the far
    /// plane; INFINITY without one; 0 of a matrix.
    pub fn get_projection(&self) -> Result<(Projection, f32, f32, f32)> {
        let mut out_kind = Projection::default();
        let mut out_size = f32::default();
        let mut out_near = f32::default();
        let mut out_far = f32::default();
        check(unsafe { sys::gphys_camera_get_projection(self.handle.as_ptr(), &mut out_kind, &mut out_size, &mut out_near, &mut out_far) })?;
        Ok((out_kind, out_size, out_near, out_far))
    }

    /// The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
    /// image.
    ///
    /// Cost: O(1).
    pub fn get_viewport(&self) -> Result<(f32, f32)> {
        let mut out_width = f32::default();
        let mut out_height = f32::default();
        check(unsafe { sys::gphys_camera_get_viewport(self.handle.as_ptr(), &mut out_width, &mut out_height) })?;
        Ok((out_width, out_height))
    }

    /// Where the viewport is in its window, in pixels, as it was set.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_viewport_origin(&self) -> Result<(f32, f32)> {
        let mut out_x = f32::default();
        let mut out_y = f32::default();
        check(unsafe { sys::gphys_camera_get_viewport_origin(self.handle.as_ptr(), &mut out_x, &mut out_y) })?;
        Ok((out_x, out_y))
    }

    /// Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
    /// viewport.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// Returns 1 if `Camera::set_perspective_aspect` or `Camera::set_orthographic_size` was the last to set
    /// the projection; 0 if it follows the viewport.
    pub fn get_aspect(&self) -> Result<(f32, bool)> {
        let mut out_aspect = f32::default();
        let mut out_is_fixed = i32::default();
        check(unsafe { sys::gphys_camera_get_aspect(self.handle.as_ptr(), &mut out_aspect, &mut out_is_fixed) })?;
        Ok((out_aspect, out_is_fixed != 0))
    }

    /// Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
    /// the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
    /// distance by an orthographic projection, in metres as they were set; 0 by a matrix.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_image_size(&self) -> Result<(f32, f32)> {
        let mut out_width = f32::default();
        let mut out_height = f32::default();
        check(unsafe { sys::gphys_camera_get_image_size(self.handle.as_ptr(), &mut out_width, &mut out_height) })?;
        Ok((out_width, out_height))
    }

    /// Where the rays of a perspective begin, as it was set.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_pick_start(&self) -> Result<PickStart> {
        let mut out_start = PickStart::default();
        check(unsafe { sys::gphys_camera_get_pick_start(self.handle.as_ptr(), &mut out_start) })?;
        Ok(out_start)
    }

    /// What the camera was created with, as in `CameraDesc`.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_conventions(&self) -> Result<(Handedness, DepthRange, bool)> {
        let mut out_handedness = Handedness::default();
        let mut out_depth_range = DepthRange::default();
        let mut out_reverse_z = i32::default();
        check(unsafe { sys::gphys_camera_get_conventions(self.handle.as_ptr(), &mut out_handedness, &mut out_depth_range, &mut out_reverse_z) })?;
        Ok((out_handedness, out_depth_range, out_reverse_z != 0))
    }

    /// Place the camera.
    ///
    /// Cost: O(1).
    ///
    /// * `position`: metres, of its centre
    /// * `rotation`: from its own axes to those of the world
    pub fn set_transform(&mut self, position: impl Into<Vec3>, rotation: impl Into<Quat>) -> Result<()> {
        let position = &position.into();
        let rotation = &rotation.into();
        check(unsafe { sys::gphys_camera_set_transform(self.handle.as_ptr(), position, rotation) })
    }

    /// Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
    /// kept, then up), so that a matrix which drifted is corrected.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_SINGULAR`: if the axes do not span space
    /// * `Status::ERROR_INVALID_ARGUMENT`: if they mirror or the last row is not 0 0 0 1
    pub fn set_world_matrix(&mut self, world: &Mat4) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_world_matrix(self.handle.as_ptr(), world) })
    }

    /// Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
    /// `Camera::set_world_matrix`. That of `Camera::get_view_matrix` puts a camera back within 2^-22 of its
    /// distance from the origin and 2^-22 rad.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_SINGULAR`: if the axes do not span space
    /// * `Status::ERROR_INVALID_ARGUMENT`: if they mirror, the last row is not 0 0 0 1, or the camera would
    ///   be beyond `MAX_COORDINATE`
    pub fn set_view_matrix(&mut self, view: &Mat4) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_view_matrix(self.handle.as_ptr(), view) })
    }

    /// Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
    /// chosen in its place, always the same for the same input.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if eye equals target or up is zero
    pub fn look_at(&mut self, eye: impl Into<Vec3>, target: impl Into<Vec3>, up: impl Into<Vec3>) -> Result<()> {
        let eye = &eye.into();
        let target = &target.into();
        let up = &up.into();
        check(unsafe { sys::gphys_camera_look_at(self.handle.as_ptr(), eye, target, up) })
    }

    /// The camera's position, in metres, and its rotation, rounded to float32.
    ///
    /// Cost: O(1).
    pub fn get_transform(&self) -> Result<(Vec3, Quat)> {
        let mut out_position = Vec3::default();
        let mut out_rotation = Quat::default();
        check(unsafe { sys::gphys_camera_get_transform(self.handle.as_ptr(), &mut out_position, &mut out_rotation) })?;
        Ok((out_position, out_rotation))
    }

    /// The matrix from camera to world.
    ///
    /// Cost: O(1).
    pub fn get_world_matrix(&self) -> Result<Mat4> {
        let mut out_world = Mat4::default();
        check(unsafe { sys::gphys_camera_get_world_matrix(self.handle.as_ptr(), &mut out_world) })?;
        Ok(out_world)
    }

    /// The matrix from world to camera: the transpose of the orthonormal world axes, and the position
    /// transformed by it.
    ///
    /// Cost: O(1).
    pub fn get_view_matrix(&self) -> Result<Mat4> {
        let mut out_view = Mat4::default();
        check(unsafe { sys::gphys_camera_get_view_matrix(self.handle.as_ptr(), &mut out_view) })?;
        Ok(out_view)
    }

    /// The matrix from camera to clip space.
    ///
    /// Cost: O(1).
    pub fn get_projection_matrix(&self) -> Result<Mat4> {
        let mut out_projection = Mat4::default();
        check(unsafe { sys::gphys_camera_get_projection_matrix(self.handle.as_ptr(), &mut out_projection) })?;
        Ok(out_projection)
    }

    /// Projection * view, multiplied in double precision and rounded once.
    ///
    /// Cost: O(1).
    pub fn get_view_projection_matrix(&self) -> Result<Mat4> {
        let mut out_view_projection = Mat4::default();
        check(unsafe { sys::gphys_camera_get_view_projection_matrix(self.handle.as_ptr(), &mut out_view_projection) })?;
        Ok(out_view_projection)
    }

    /// Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
    /// distance outside its limits is brought inside.
    ///
    /// Cost: O(1).
    pub fn set_orbit(&mut self, orbit: &Orbit) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_orbit(self.handle.as_ptr(), orbit) })
    }

    /// The present settings, angles and distance of the orbit.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn get_orbit(&self) -> Result<Orbit> {
        let mut out_orbit = Orbit::default();
        check(unsafe { sys::gphys_camera_get_orbit(self.handle.as_ptr(), &mut out_orbit) })?;
        Ok(out_orbit)
    }

    /// Set a speed for each input of the orbit, in place of the two of `Orbit`, which `Camera::set_orbit`
    /// starts from. Input since the last update uses the new speeds.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn set_orbit_speeds(&mut self, speeds: &OrbitSpeeds) -> Result<()> {
        check(unsafe { sys::gphys_camera_set_orbit_speeds(self.handle.as_ptr(), speeds) })
    }

    /// The present speeds of the orbit's inputs.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn get_orbit_speeds(&self) -> Result<OrbitSpeeds> {
        let mut out_speeds = OrbitSpeeds::default();
        check(unsafe { sys::gphys_camera_get_orbit_speeds(self.handle.as_ptr(), &mut out_speeds) })?;
        Ok(out_speeds)
    }

    /// Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds that
    /// were set.
    ///
    /// Cost: O(1).
    ///
    /// * `units_x`, `units_y`: finite, any size
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn orbit_rotate(&mut self, units_x: f32, units_y: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_orbit_rotate(self.handle.as_ptr(), units_x, units_y) })
    }

    /// Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
    /// away if negative.
    ///
    /// Cost: O(1).
    ///
    /// * `units`: finite, any size
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn orbit_zoom(&mut self, units: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_orbit_zoom(self.handle.as_ptr(), units) })
    }

    /// Add input to the orbit: move the target to the camera's right and up, as the last update left them,
    /// by units times metres_per_unit or the speeds that were set.
    ///
    /// Cost: O(1).
    ///
    /// * `units_right`, `units_up`: finite, any size
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn orbit_pan(&mut self, units_right: f32, units_up: f32) -> Result<()> {
        check(unsafe { sys::gphys_camera_orbit_pan(self.handle.as_ptr(), units_right, units_up) })
    }

    /// Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
    /// to -pi .. pi in constant time.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the camera was never set to orbit
    pub fn orbit_update(&mut self) -> Result<()> {
        check(unsafe { sys::gphys_camera_orbit_update(self.handle.as_ptr()) })
    }

    /// The view frustum, with origin at the camera's position and planes from its parameters: each number
    /// within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
    /// Gribb-Hartmann in double precision.
    ///
    /// Cost: O(1).
    pub fn get_frustum(&self) -> Result<Frustum> {
        let mut out_frustum = Frustum::default();
        check(unsafe { sys::gphys_camera_get_frustum(self.handle.as_ptr(), &mut out_frustum) })?;
        Ok(out_frustum)
    }

    /// World positions of the corners of the view frustum, in the order of `frustum_corners`.
    ///
    /// Cost: O(1).
    ///
    /// Returns `None` with an infinite far plane, or a corner beyond the largest float.
    pub fn get_corners(&self) -> Result<Option<[Vec3; 8]>> {
        let mut out_corners = [Vec3::default(); 8];
        Ok(found(unsafe { sys::gphys_camera_get_corners(self.handle.as_ptr(), out_corners.as_mut_ptr()) })?.then_some(out_corners))
    }

    /// What is seen in a rectangle of pixels, as `Camera::get_frustum`: of a tile, a marquee, a portal.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// * `x0`, `y0`: pixels, a corner of the rectangle; may lie outside the viewport
    /// * `x1`, `y1`: pixels, the opposite corner, in any order; may lie outside the viewport
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if the rectangle has no area, or a side of what a matrix shows
    ///   in it lies at infinity or beyond `MAX_COORDINATE`
    pub fn get_rectangle_frustum(&self, x0: f32, y0: f32, x1: f32, y1: f32) -> Result<Frustum> {
        let mut out_frustum = Frustum::default();
        check(unsafe { sys::gphys_camera_get_rectangle_frustum(self.handle.as_ptr(), x0, y0, x1, y1, &mut out_frustum) })?;
        Ok(out_frustum)
    }

    /// World positions of the corners of what is seen in a rectangle of pixels, as `Camera::get_corners`.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// * `x0`, `y0`, `x1`, `y1`: as `Camera::get_rectangle_frustum`
    ///
    /// Returns `None` as `Camera::get_corners`.
    pub fn get_rectangle_corners(&self, x0: f32, y0: f32, x1: f32, y1: f32) -> Result<Option<[Vec3; 8]>> {
        let mut out_corners = [Vec3::default(); 8];
        Ok(found(unsafe { sys::gphys_camera_get_rectangle_corners(self.handle.as_ptr(), x0, y0, x1, y1, out_corners.as_mut_ptr()) })?.then_some(out_corners))
    }

    /// World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
    /// viewport; z is the depth in the camera's range.
    ///
    /// Cost: O(1).
    ///
    /// Returns `None` if the point is not in front of the camera's centre (no image), or its image lies
    /// beyond the range of coordinates.
    pub fn project(&self, point: impl Into<Vec3>) -> Result<Option<Vec3>> {
        let point = &point.into();
        let mut out_pixel = Vec3::default();
        Ok(found(unsafe { sys::gphys_camera_project(self.handle.as_ptr(), point, &mut out_pixel) })?.then_some(out_pixel))
    }

    /// Pixels of count world points, as `Camera::project`; a point without an image gets x = y = z =
    /// INFINITY.
    ///
    /// Cost: O(elements).
    ///
    /// * `points`: metres
    pub fn project_batch<'a>(&self, points: impl Into<Batch<'a, Vec3>>, out_pixels: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let points = points.into();
        let out_pixels = out_pixels.into();
        let count = common_length(&[points.length])?;
        out_pixels.require(count.into())?;
        check(unsafe { sys::gphys_camera_project_batch(self.handle.as_ptr(), points.data, points.stride, count, out_pixels.data, out_pixels.stride) })
    }

    /// Pixel and depth to world point: the inverse of `Camera::project`.
    ///
    /// Cost: O(1).
    ///
    /// Returns `None` for the depth of an infinite far plane, and for points beyond that or beyond the
    /// range of coordinates.
    pub fn unproject(&self, pixel: impl Into<Vec3>) -> Result<Option<Vec3>> {
        let pixel = &pixel.into();
        let mut out_point = Vec3::default();
        Ok(found(unsafe { sys::gphys_camera_unproject(self.handle.as_ptr(), pixel, &mut out_point) })?.then_some(out_point))
    }

    /// World points of the pixels with depth, as `Camera::unproject`; one at infinity gets x = y = z =
    /// INFINITY.
    ///
    /// Cost: O(elements).
    ///
    /// * `pixels`: x, y in pixels, z the depth
    pub fn unproject_batch<'a>(&self, pixels: impl Into<Batch<'a, Vec3>>, out_points: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let pixels = pixels.into();
        let out_points = out_points.into();
        let count = common_length(&[pixels.length])?;
        out_points.require(count.into())?;
        check(unsafe { sys::gphys_camera_unproject_batch(self.handle.as_ptr(), pixels.data, pixels.stride, count, out_points.data, out_points.stride) })
    }

    /// The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
    /// (INFINITY without one). With `PickStart::CENTRE` that of a perspective starts at the camera's
    /// position. Its image is within 1e-3 pixel of the given one or, for fields of view below about 3
    /// degrees, within half an ulp of its direction. Its start is rounded to float32, too, which moves the
    /// ray by half an ulp of the coordinates (but not from the camera's position, which has float
    /// coordinates); `Camera::pick` is not limited in this way.
    ///
    /// Cost: O(1).
    ///
    /// * `pixel_x`, `pixel_y`: pixels; may lie outside the viewport
    ///
    /// Returns `None` if the line of sight does not meet the near plane (user projections), or would begin
    /// beyond `MAX_COORDINATE`.
    pub fn pick_ray(&self, pixel_x: f32, pixel_y: f32) -> Result<Option<Ray>> {
        let mut out_ray = Ray::default();
        Ok(found(unsafe { sys::gphys_camera_pick_ray(self.handle.as_ptr(), pixel_x, pixel_y, &mut out_ray) })?.then_some(out_ray))
    }

    /// Rays for a rectangle of pixel centres, as `Camera::pick_ray`, row by row.
    ///
    /// Cost: O(width * height).
    ///
    /// * `x`: the left column of the rectangle
    /// * `y`: its top row
    /// * `width`: its columns
    /// * `height`: its rows; width * height fewer than 2^32
    pub fn pick_rays<'a>(&self, x: u32, y: u32, width: u32, height: u32, out_rays: impl Into<BatchMut<'a, Ray>>) -> Result<()> {
        let out_rays = out_rays.into();
        out_rays.require(u64::from(width) * u64::from(height))?;
        check(unsafe { sys::gphys_camera_pick_rays(self.handle.as_ptr(), x, y, width, height, out_rays.data, out_rays.stride) })
    }

    /// The model under a pixel: the first hit of `Camera::pick_ray`, before that is rounded to float32; t
    /// is in metres from where it starts.
    ///
    /// Cost: O(log n) expected.
    ///
    /// * `pixel_x`, `pixel_y`: pixels; may lie outside the viewport
    ///
    /// Returns `None` if nothing is found.
    pub fn pick(&self, scene: &Scene, pixel_x: f32, pixel_y: f32, layers: u32) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_camera_pick(self.handle.as_ptr(), scene.handle.as_ptr(), pixel_x, pixel_y, layers, &mut out_hit) })?.then_some(out_hit))
    }

    /// The models under the pixels, as `Camera::pick`; a pixel without one gets model = 0 and t = INFINITY.
    ///
    /// Cost: at most that of as many single calls; shared among the scene's workers.
    ///
    /// * `pixels`: x, y pairs of floats
    pub fn pick_batch<'a>(&self, scene: &Scene, pixels: impl Into<Batch<'a, [f32; 2]>>, layers: u32, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let pixels = pixels.into();
        let out_hits = out_hits.into();
        let count = common_length(&[pixels.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_camera_pick_batch(self.handle.as_ptr(), scene.handle.as_ptr(), pixels.data, pixels.stride, count, layers, out_hits.data, out_hits.stride) })
    }

    /// Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
    /// tested by their exact shapes, ascending.
    ///
    /// Cost: that of `Scene::overlap`.
    ///
    /// * `x0`, `y0`: pixels, a corner of the rectangle; may lie outside the viewport
    /// * `x1`, `y1`: pixels, the opposite corner, in any order; may lie outside the viewport
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if the rectangle has no area
    pub fn pick_rectangle(&self, scene: &Scene, x0: f32, y0: f32, x1: f32, y1: f32, layers: u32) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_camera_pick_rectangle(self.handle.as_ptr(), scene.handle.as_ptr(), x0, y0, x1, y1, layers, out_models, capacity, total) })
    }

    /// Ids of the models to draw: `Scene::cull` with the camera's frustum.
    ///
    /// Cost: O(log n + k) expected.
    pub fn cull(&self, scene: &Scene, layers: u32) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_camera_cull(self.handle.as_ptr(), scene.handle.as_ptr(), layers, out_models, capacity, total) })
    }

    /// The model under a pixel that the filter sees, as `Camera::pick`: what lies behind a selection.
    ///
    /// Cost: as `Scene::raycast_filtered`.
    ///
    /// * `pixel_x`, `pixel_y`: pixels; may lie outside the viewport
    /// * `filter`: None: the defaults
    ///
    /// Returns `None` if nothing is found.
    pub fn pick_filtered(&self, scene: &Scene, pixel_x: f32, pixel_y: f32, filter: Option<&QueryFilterDesc>) -> Result<Option<Hit>> {
        let mut out_hit = Hit::default();
        Ok(found(unsafe { sys::gphys_camera_pick_filtered(self.handle.as_ptr(), scene.handle.as_ptr(), pixel_x, pixel_y, pointer(filter), &mut out_hit) })?.then_some(out_hit))
    }

    /// The models under the pixels that the filters see, as `Camera::pick_batch`.
    ///
    /// Cost: at most that of as many single calls; shared among the scene's workers.
    ///
    /// * `pixels`: x, y pairs of floats
    /// * `filters`: None: the defaults
    pub fn pick_filtered_batch<'a>(&self, scene: &Scene, pixels: impl Into<Batch<'a, [f32; 2]>>, filters: impl Into<Batch<'a, QueryFilterDesc<'a>>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
        let pixels = pixels.into();
        let filters = filters.into();
        let out_hits = out_hits.into();
        let count = common_length(&[pixels.length, filters.length])?;
        out_hits.require(count.into())?;
        check(unsafe { sys::gphys_camera_pick_filtered_batch(self.handle.as_ptr(), scene.handle.as_ptr(), pixels.data, pixels.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride) })
    }

    /// Marquee: ids of all models in the pixel rectangle that the filter sees, as `Camera::pick_rectangle`.
    ///
    /// Cost: as `Scene::overlap_filtered`.
    ///
    /// * `x0`, `y0`: pixels, a corner of the rectangle
    /// * `x1`, `y1`: pixels, the opposite corner, in any order
    /// * `filter`: None: the defaults
    pub fn pick_rectangle_filtered(&self, scene: &Scene, x0: f32, y0: f32, x1: f32, y1: f32, filter: Option<&QueryFilterDesc>) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_camera_pick_rectangle_filtered(self.handle.as_ptr(), scene.handle.as_ptr(), x0, y0, x1, y1, pointer(filter), out_models, capacity, total) })
    }

    /// Ids of the models to draw that the filter sees: `Scene::cull_filtered` with the camera's frustum.
    ///
    /// Cost: as `Scene::cull_filtered`.
    ///
    /// * `filter`: None: the defaults
    pub fn cull_filtered(&self, scene: &Scene, filter: Option<&QueryFilterDesc>) -> Result<Vec<ModelId>> {
        list(|out_models, capacity, total| unsafe { sys::gphys_camera_cull_filtered(self.handle.as_ptr(), scene.handle.as_ptr(), pointer(filter), out_models, capacity, total) })
    }

}

/// Owns a `gphys_solver` and frees it when dropped.
#[derive(Debug)]
pub struct Solver {
    pub(crate) handle: NonNull<sys::gphys_solver>,
}

// Functions that take a const object may run at the same time: they take &self here, all others &mut self.
unsafe impl Send for Solver {}
unsafe impl Sync for Solver {}

impl Drop for Solver {
    fn drop(&mut self) {
        unsafe { sys::gphys_solver_destroy(self.handle.as_ptr()) }
    }
}

impl Solver {
    /// Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
    /// results have the same bits for every n. Threads are started, joined and lost as those of `Scene`.
    ///
    /// Cost: O(1), and that of starting the threads.
    ///
    /// * `desc`: None: the defaults
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: also if the threads cannot be started
    pub fn new(desc: Option<&SolverDesc>) -> Result<Solver> {
        let mut made = null_mut();
        check(unsafe { sys::gphys_solver_create(pointer(desc), &mut made) })?;
        Ok(Solver { handle: NonNull::new(made).expect("a created object") })
    }

    /// Change the number of threads that share the steps of a solver, as `Scene::set_worker_count`. The
    /// bits of the motion stay the same.
    ///
    /// Cost: as `Scene::set_worker_count`; allocates. Since 1.1.
    ///
    /// * `workers`: as `SolverDesc`.worker_count
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: also if the threads cannot be started; the former ones are kept
    pub fn set_worker_count(&mut self, workers: u32) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_worker_count(self.handle.as_ptr(), workers) })
    }

    /// How many threads share the steps of a solver, as `Scene::get_worker_count`.
    ///
    /// Cost: O(1). Since 1.1.
    pub fn get_worker_count(&self) -> Result<u32> {
        let mut out_workers = u32::default();
        check(unsafe { sys::gphys_solver_get_worker_count(self.handle.as_ptr(), &mut out_workers) })?;
        Ok(out_workers)
    }

    /// Move the point of the world that the coordinates of all particles count from; see
    /// `Scene::set_origin`. Particles stay where they are in the world and keep moving as they do. A step
    /// and an attachment need a scene of the same origin, else they fail with
    /// `Status::ERROR_INVALID_ARGUMENT`.
    ///
    /// Cost: O(particles).
    ///
    /// * `origin`: x, y, z in the world, metres, within `MAX_COORDINATE`
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if a particle or an animation target would leave the range
    ///   of coordinates
    pub fn set_origin(&mut self, origin: &[f64; 3]) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_origin(self.handle.as_ptr(), origin.as_ptr()) })
    }

    /// Where in the world the particles' coordinates count from, metres.
    ///
    /// Cost: O(1).
    pub fn get_origin(&self) -> Result<[f64; 3]> {
        let mut out_origin = [f64::default(); 3];
        check(unsafe { sys::gphys_solver_get_origin(self.handle.as_ptr(), out_origin.as_mut_ptr()) })?;
        Ok(out_origin)
    }

    /// Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
    ///
    /// Cost: O(bodies).
    ///
    /// * `gravity`: m/s^2; may be zero
    pub fn set_gravity(&mut self, gravity: impl Into<Vec3>) -> Result<()> {
        let gravity = &gravity.into();
        check(unsafe { sys::gphys_solver_set_gravity(self.handle.as_ptr(), gravity) })
    }

    /// Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
    /// The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
    /// link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
    /// (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
    ///
    /// Cost: O(1).
    ///
    /// * `substeps`: 1 .. 1000
    pub fn set_substeps(&mut self, substeps: u32) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_substeps(self.handle.as_ptr(), substeps) })
    }

    /// The settings of a solver as they are.
    ///
    /// Cost: O(1).
    pub fn get_settings(&self) -> Result<SolverSettings> {
        let mut out_settings = SolverSettings::default();
        check(unsafe { sys::gphys_solver_get_settings(self.handle.as_ptr(), &mut out_settings) })?;
        Ok(out_settings)
    }

    /// Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
    /// if gravity or the settings of sleep change. Time that `Solver::advance` owes beyond the new
    /// fixed_step is dropped.
    ///
    /// Cost: O(bodies).
    pub fn set_settings(&mut self, settings: &SolverSettings) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_settings(self.handle.as_ptr(), settings) })
    }

    /// Add a body of particles without constraints.
    ///
    /// Cost: O(elements).
    ///
    /// * `desc`: None: the defaults
    /// * `positions`: metres
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 particles or bodies
    pub fn add_particles<'a>(&mut self, positions: impl Into<Batch<'a, Vec3>>, desc: Option<&BodyDesc>) -> Result<BodyId> {
        let positions = positions.into();
        let count = common_length(&[positions.length])?;
        let mut out_body = BodyId::default();
        check(unsafe { sys::gphys_solver_add_particles(self.handle.as_ptr(), pointer(desc), positions.data, positions.stride, count, &mut out_body) })?;
        Ok(out_body)
    }

    /// Add a rope through the given points, one particle at each.
    ///
    /// Cost: O(elements).
    ///
    /// * `desc`: None: the defaults
    /// * `positions`: metres
    /// * `link_length`: rest length of each link in metres; 0: as placed. A length below 1e-9 m counts as
    ///   0. Rigid links get their lengths in the first step, and the particles no speed by it.
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 particles or bodies
    pub fn add_rope<'a>(&mut self, positions: impl Into<Batch<'a, Vec3>>, link_length: f32, desc: Option<&BodyDesc>) -> Result<BodyId> {
        let positions = positions.into();
        let count = common_length(&[positions.length])?;
        let mut out_body = BodyId::default();
        check(unsafe { sys::gphys_solver_add_rope(self.handle.as_ptr(), pointer(desc), positions.data, positions.stride, count, link_length, &mut out_body) })?;
        Ok(out_body)
    }

    /// Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
    /// corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the order
    /// of their ids, are those from row to row, those from column to column, both diagonals
    /// (`CLOTH_SHEAR`), and those that resist folding (`CLOTH_BEND`); `Solver::set_constraint_settings`
    /// makes them softer or stiffer later.
    ///
    /// Cost: O(columns * rows).
    ///
    /// * `desc`: None: the defaults
    /// * `corner`: metres
    /// * `edge_u`: metres, from the corner along a row
    /// * `edge_v`: metres, from the corner along a column
    /// * `columns`, `rows`: >= 2
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if the edges are parallel or zero
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 particles, links or bodies
    pub fn add_cloth(&mut self, corner: impl Into<Vec3>, edge_u: impl Into<Vec3>, edge_v: impl Into<Vec3>, columns: u32, rows: u32, desc: Option<&BodyDesc>) -> Result<BodyId> {
        let corner = &corner.into();
        let edge_u = &edge_u.into();
        let edge_v = &edge_v.into();
        let mut out_body = BodyId::default();
        check(unsafe { sys::gphys_solver_add_cloth(self.handle.as_ptr(), pointer(desc), corner, edge_u, edge_v, columns, rows, &mut out_body) })?;
        Ok(out_body)
    }

    /// Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
    /// `CLOTH_BEND` one across each inner edge, whose ids come after those of the edges. Vertices at the
    /// same place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls, has a
    /// rest length of 0.
    ///
    /// Cost: O(n log n).
    ///
    /// * `desc`: None: the defaults
    /// * `transform`: places the mesh; None is the identity
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 particles or bodies
    /// * `Status::ERROR_UNSUPPORTED`: for a mesh made from a rope or from particles, which has no triangles
    pub fn add_cloth_mesh(&mut self, mesh: &Mesh, transform: Option<&Transform>, desc: Option<&BodyDesc>) -> Result<BodyId> {
        let mut out_body = BodyId::default();
        check(unsafe { sys::gphys_solver_add_cloth_mesh(self.handle.as_ptr(), pointer(desc), mesh.handle.as_ptr(), pointer(transform), &mut out_body) })?;
        Ok(out_body)
    }

    /// Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
    /// the last step are no longer listed.
    ///
    /// Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
    /// impulses to the same models).
    pub fn remove_body(&mut self, body: BodyId) -> Result<()> {
        check(unsafe { sys::gphys_solver_remove_body(self.handle.as_ptr(), body) })
    }

    /// Ids of all bodies, ascending.
    ///
    /// Cost: O(bodies).
    pub fn get_bodies(&self) -> Result<Vec<BodyId>> {
        list(|out_bodies, capacity, total| unsafe { sys::gphys_solver_get_bodies(self.handle.as_ptr(), out_bodies, capacity, total) })
    }

    /// Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
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
    ///
    /// Cost: O(bodies).
    pub fn get_sleeping(&self) -> Result<Vec<BodyId>> {
        list(|out_bodies, capacity, total| unsafe { sys::gphys_solver_get_sleeping(self.handle.as_ptr(), out_bodies, capacity, total) })
    }

    /// Wake a body; its time of rest begins again.
    ///
    /// Cost: O(1) a body.
    ///
    /// * `body`: 0: all
    pub fn wake(&mut self, body: BodyId) -> Result<()> {
        check(unsafe { sys::gphys_solver_wake(self.handle.as_ptr(), body) })
    }

    /// The present settings of a body; static_friction as it acts, at least friction.
    ///
    /// Cost: O(1).
    pub fn get_body_settings(&self, body: BodyId) -> Result<BodySettings> {
        let mut out_settings = BodySettings::default();
        check(unsafe { sys::gphys_solver_get_body_settings(self.handle.as_ptr(), body, &mut out_settings) })?;
        Ok(out_settings)
    }

    /// Change all settings of a body, from the next step on: read them, change some, and give them back.
    /// Wakes the body.
    ///
    /// Cost: O(1); O(particles) when self_collision changes, and it allocates.
    pub fn set_body_settings(&mut self, body: BodyId, settings: &BodySettings) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_body_settings(self.handle.as_ptr(), body, settings) })
    }

    /// What a body is made of and how it is solved.
    ///
    /// Cost: O(1); after a change of constraints O(particles), and it allocates.
    pub fn get_body_info(&self, body: BodyId) -> Result<BodyInfo> {
        let mut out_info = BodyInfo::default();
        check(unsafe { sys::gphys_solver_get_body_info(self.handle.as_ptr(), body, &mut out_info) })?;
        Ok(out_info)
    }

    /// Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (`Break`) they
    /// change, and their number does not.
    ///
    /// Cost: O(triangles).
    pub fn get_triangles(&self, body: BodyId) -> Result<Vec<u32>> {
        list(|out_indices, capacity, total| unsafe { sys::gphys_solver_get_triangles(self.handle.as_ptr(), body, out_indices, capacity, total) })
    }

    /// The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
    ///
    /// Cost: O(1); O(particles) for `NO_TRIANGLE`. Since 1.1.
    ///
    /// * `triangle`: as in a hit, nearest or penetration of the body's mesh: its corners are compared, of a
    ///   rope the ends of the link, or the particle; `NO_TRIANGLE`: all particles
    /// * `point`: metres, in the solver's coordinates: that of the hit
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: also if the mesh has no such triangle
    pub fn get_nearest_particle(&self, body: BodyId, triangle: u32, point: impl Into<Vec3>) -> Result<u32> {
        let point = &point.into();
        let mut out_particle = u32::default();
        check(unsafe { sys::gphys_solver_get_nearest_particle(self.handle.as_ptr(), body, triangle, point, &mut out_particle) })?;
        Ok(out_particle)
    }

    /// Where the particles are, metres.
    ///
    /// Cost: O(count).
    ///
    /// * `first`: the first particle
    /// * `count`: how many from there on; a range beyond the body is `Status::ERROR_INVALID_ARGUMENT`
    pub fn get_positions<'a>(&self, body: BodyId, first: u32, out_positions: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let out_positions = out_positions.into();
        let count = out_positions.count()?;
        check(unsafe { sys::gphys_solver_get_positions(self.handle.as_ptr(), body, first, count, out_positions.data, out_positions.stride) })
    }

    /// Move particles at once and without collision on the way; velocities stay as they are. Wakes the
    /// body. Rigid links that are too long or too short then get their lengths in the next step, and the
    /// particles no speed by it. Pinned particles that are moved alone pull the others: during the next
    /// step they go evenly from where they were to their new places, as attached ones do. They are placed
    /// at once before the body's first step, or if a free particle of the body is placed as well.
    ///
    /// Cost: O(elements).
    ///
    /// * `first`: as in `Solver::get_positions`
    pub fn set_positions<'a>(&mut self, body: BodyId, first: u32, positions: impl Into<Batch<'a, Vec3>>) -> Result<()> {
        let positions = positions.into();
        let count = common_length(&[positions.length])?;
        check(unsafe { sys::gphys_solver_set_positions(self.handle.as_ptr(), body, first, count, positions.data, positions.stride) })
    }

    /// How fast the particles are, m/s.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    ///
    /// Returns 0 of what is pinned and stands still.
    pub fn get_velocities<'a>(&self, body: BodyId, first: u32, out_velocities: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let out_velocities = out_velocities.into();
        let count = out_velocities.count()?;
        check(unsafe { sys::gphys_solver_get_velocities(self.handle.as_ptr(), body, first, count, out_velocities.data, out_velocities.stride) })
    }

    /// Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
    ///
    /// Cost: O(elements).
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `velocities`: m/s
    pub fn set_velocities<'a>(&mut self, body: BodyId, first: u32, velocities: impl Into<Batch<'a, Vec3>>) -> Result<()> {
        let velocities = velocities.into();
        let count = common_length(&[velocities.length])?;
        check(unsafe { sys::gphys_solver_set_velocities(self.handle.as_ptr(), body, first, count, velocities.data, velocities.stride) })
    }

    /// Masses of particles, kg. That of a pinned particle is what it has when it is released.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_masses<'a>(&self, body: BodyId, first: u32, out_masses: impl Into<BatchMut<'a, f32>>) -> Result<()> {
        let out_masses = out_masses.into();
        let count = out_masses.count()?;
        check(unsafe { sys::gphys_solver_get_masses(self.handle.as_ptr(), body, first, count, out_masses.data, out_masses.stride) })
    }

    /// Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
    /// Wakes the body.
    ///
    /// Cost: O(elements).
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `masses`: kg, > 0
    pub fn set_masses<'a>(&mut self, body: BodyId, first: u32, masses: impl Into<Batch<'a, f32>>) -> Result<()> {
        let masses = masses.into();
        let count = common_length(&[masses.length])?;
        check(unsafe { sys::gphys_solver_set_masses(self.handle.as_ptr(), body, first, count, masses.data, masses.stride) })
    }

    /// Collision radii of particles, metres.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_radii<'a>(&self, body: BodyId, first: u32, out_radii: impl Into<BatchMut<'a, f32>>) -> Result<()> {
        let out_radii = out_radii.into();
        let count = out_radii.count()?;
        check(unsafe { sys::gphys_solver_get_radii(self.handle.as_ptr(), body, first, count, out_radii.data, out_radii.stride) })
    }

    /// Change the collision radii of particles. Wakes the body.
    ///
    /// Cost: O(elements).
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `radii`: metres, >= 0
    pub fn set_radii<'a>(&mut self, body: BodyId, first: u32, radii: impl Into<Batch<'a, f32>>) -> Result<()> {
        let radii = radii.into();
        let count = common_length(&[radii.length])?;
        check(unsafe { sys::gphys_solver_set_radii(self.handle.as_ptr(), body, first, count, radii.data, radii.stride) })
    }

    /// Friction factors of particles; 1 until they are set.
    ///
    /// Cost: O(count). Since 1.1.
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_friction_factors<'a>(&self, body: BodyId, first: u32, out_factors: impl Into<BatchMut<'a, f32>>) -> Result<()> {
        let out_factors = out_factors.into();
        let count = out_factors.count()?;
        check(unsafe { sys::gphys_solver_get_friction_factors(self.handle.as_ptr(), body, first, count, out_factors.data, out_factors.stride) })
    }

    /// Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
    /// contact, with models and with particles, the coefficients of a particle are the friction and the
    /// static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
    /// coefficients; `Solver::set_body_settings` scales them all and keeps the factors. Wakes the body.
    ///
    /// Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `factors`: >= 0
    pub fn set_friction_factors<'a>(&mut self, body: BodyId, first: u32, factors: impl Into<Batch<'a, f32>>) -> Result<()> {
        let factors = factors.into();
        let count = common_length(&[factors.length])?;
        check(unsafe { sys::gphys_solver_set_friction_factors(self.handle.as_ptr(), body, first, count, factors.data, factors.stride) })
    }

    /// The forces that were set for particles, newtons.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_forces<'a>(&self, body: BodyId, first: u32, out_forces: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let out_forces = out_forces.into();
        let count = out_forces.count()?;
        check(unsafe { sys::gphys_solver_get_forces(self.handle.as_ptr(), body, first, count, out_forces.data, out_forces.stride) })
    }

    /// Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
    ///
    /// Cost: O(elements).
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `forces`: newtons
    pub fn set_forces<'a>(&mut self, body: BodyId, first: u32, forces: impl Into<Batch<'a, Vec3>>) -> Result<()> {
        let forces = forces.into();
        let count = common_length(&[forces.length])?;
        check(unsafe { sys::gphys_solver_set_forces(self.handle.as_ptr(), body, first, count, forces.data, forces.stride) })
    }

    /// Which particles are pinned or attached.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_pinned<'a>(&self, body: BodyId, first: u32, out_pinned: impl Into<BatchMut<'a, i32>>) -> Result<()> {
        let out_pinned = out_pinned.into();
        let count = out_pinned.count()?;
        check(unsafe { sys::gphys_solver_get_pinned(self.handle.as_ptr(), body, first, count, out_pinned.data, out_pinned.stride) })
    }

    /// Pin or release particles. A pinned particle stays where it is put and moves only by
    /// `Solver::set_positions`, or with an animation target of max_distance 0; else its speed is 0. Both
    /// pinning and releasing end an attachment.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    /// * `pinned`: true: pin; false: release
    pub fn set_pinned(&mut self, body: BodyId, first: u32, count: u32, pinned: bool) -> Result<()> {
        let pinned = i32::from(pinned);
        check(unsafe { sys::gphys_solver_set_pinned(self.handle.as_ptr(), body, first, count, pinned) })
    }

    /// Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
    /// relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
    /// C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
    /// the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
    /// effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
    /// along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
    /// cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
    /// u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
    /// reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
    /// at the beginning of the step.
    ///
    /// Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
    /// as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.
    ///
    /// * `body`: 0: all bodies there are
    /// * `wind`: of density 0: no air
    pub fn set_wind(&mut self, body: BodyId, wind: &Wind) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_wind(self.handle.as_ptr(), body, wind) })
    }

    /// The air around a body as it was set; zeros if it was not.
    ///
    /// Cost: O(1).
    pub fn get_wind(&self, body: BodyId) -> Result<Wind> {
        let mut out_wind = Wind::default();
        check(unsafe { sys::gphys_solver_get_wind(self.handle.as_ptr(), body, &mut out_wind) })?;
        Ok(out_wind)
    }

    /// Give the air at particles a velocity beside that of `Wind`, from now on until set again: gusts,
    /// eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
    ///
    /// Cost: O(elements); the first time O(particles), and it allocates.
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `velocities`: m/s
    pub fn set_air_velocities<'a>(&mut self, body: BodyId, first: u32, velocities: impl Into<Batch<'a, Vec3>>) -> Result<()> {
        let velocities = velocities.into();
        let count = common_length(&[velocities.length])?;
        check(unsafe { sys::gphys_solver_set_air_velocities(self.handle.as_ptr(), body, first, count, velocities.data, velocities.stride) })
    }

    /// Velocities of the air at particles, m/s, beside that of `Wind`.
    ///
    /// Cost: O(count).
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_air_velocities<'a>(&self, body: BodyId, first: u32, out_velocities: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
        let out_velocities = out_velocities.into();
        let count = out_velocities.count()?;
        check(unsafe { sys::gphys_solver_get_air_velocities(self.handle.as_ptr(), body, first, count, out_velocities.data, out_velocities.stride) })
    }

    /// Give particles animation targets, before each step that is to follow an animation: a cape or skirt
    /// that is skinned to its character stays within max_distance of the skinned vertices and does not sink
    /// into the body behind them. In the next step position and normal go evenly from the old target to the
    /// new one, substep by substep; distances act at once. A target that is not set again stands still. A
    /// first target, and that of a particle which `Solver::set_positions` has moved since the last step,
    /// takes effect at its new place at once: to teleport, make that call and this one. If the body is
    /// attached to a model that jumps (`Solver::step`), this call alone is enough. max_distance 0 carries a
    /// particle: it is at its target, as if attached there, and moves links with infinite mass; this also
    /// moves a pinned particle, which stays pinned, at constant speed during a step. Otherwise particles
    /// that are pinned or attached are not moved. A particle that is out of its bounds at the end of a
    /// substep is put on the nearest place within both, without friction; its velocity across them is then
    /// that of the target. What lies within its bounds is not touched. Bounds act after constraints and
    /// before models: where a target is inside a model, or behind one, the particle stays outside. Links
    /// yield to bounds that contradict them. What hangs from a particle at its bounds is carried, in cloth
    /// and in ropes that are moved alone; ropes and free particles that are joined, or collide with bodies,
    /// are put back particle by particle, and links beside these may be strained by the motion of a
    /// substep. Wakes the body if a target changes.
    ///
    /// Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
    /// particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.
    ///
    /// * `first`: as in `Solver::get_positions`
    /// * `targets`: max_distance and backstop INFINITY: no target any more
    pub fn set_animation_targets<'a>(&mut self, body: BodyId, first: u32, targets: impl Into<Batch<'a, AnimationTarget>>) -> Result<()> {
        let targets = targets.into();
        let count = common_length(&[targets.length])?;
        check(unsafe { sys::gphys_solver_set_animation_targets(self.handle.as_ptr(), body, first, count, targets.data, targets.stride) })
    }

    /// Animation targets of particles as they were set; 0 and INFINITY of what has none.
    ///
    /// Cost: O(count). Since 1.1.
    ///
    /// * `first`, `count`: as in `Solver::get_positions`
    pub fn get_animation_targets<'a>(&self, body: BodyId, first: u32, out_targets: impl Into<BatchMut<'a, AnimationTarget>>) -> Result<()> {
        let out_targets = out_targets.into();
        let count = out_targets.count()?;
        check(unsafe { sys::gphys_solver_get_animation_targets(self.handle.as_ptr(), body, first, count, out_targets.data, out_targets.stride) })
    }

    /// Fix a particle to a model: it follows the model's transform in each step, and is released when the
    /// model is gone. Steps must then be given this scene; in a step without one the particle stays where
    /// it is. If the model jumps (`Solver::step`), the whole body goes with it as if it were rigid, and its
    /// velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
    /// particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
    /// constraints.
    ///
    /// Cost: O(1); allocates.
    ///
    /// * `scene`: of the same origin as the solver; not modified
    /// * `local_point`: in the model's coordinates, to which its transform applies, with the transform's
    ///   scale, and not `Scene::set_scale`; None: where the particle is now
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for a particle that does not exist
    pub fn attach(&mut self, scene: &Scene, body: BodyId, particle: u32, model: ModelId, local_point: Option<&Vec3>) -> Result<()> {
        check(unsafe { sys::gphys_solver_attach(self.handle.as_ptr(), scene.handle.as_ptr(), body, particle, model, pointer(local_point)) })
    }

    /// Release an attached particle.
    ///
    /// Cost: O(1).
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: if it is not attached, or does not exist
    pub fn detach(&mut self, body: BodyId, particle: u32) -> Result<()> {
        check(unsafe { sys::gphys_solver_detach(self.handle.as_ptr(), body, particle) })
    }

    /// The attachments of a body, by particle. One to a model that is gone is listed until the next step.
    ///
    /// Cost: O(attachments). Since 1.1.
    pub fn get_attachments(&self, body: BodyId) -> Result<Vec<Attachment>> {
        list(|out_attachments, capacity, total| unsafe { sys::gphys_solver_get_attachments(self.handle.as_ptr(), body, out_attachments, capacity, total) })
    }

    /// Hold two different particles of a body at a distance.
    ///
    /// Cost: O(1); the next step plans the body again, O(constraints).
    ///
    /// * `rest_length`: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    /// * `compliance`: metres per newton, >= 0; 0 is rigid
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for a particle that does not exist or twice the same one
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 constraints of a body
    pub fn add_distance(&mut self, body: BodyId, particle_a: u32, particle_b: u32, rest_length: f32, compliance: f32) -> Result<ConstraintId> {
        let mut out_constraint = ConstraintId::default();
        check(unsafe { sys::gphys_solver_add_distance(self.handle.as_ptr(), body, particle_a, particle_b, rest_length, compliance, &mut out_constraint) })?;
        Ok(out_constraint)
    }

    /// Keep two different particles of a body from being further apart than a length, like a string between
    /// them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
    /// rigid, only the speed at which the particles separate is lost.
    /// Fails as `Solver::add_distance`.
    /// It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
    /// strained only when it is too long.
    ///
    /// Cost: as `Solver::add_distance`.
    ///
    /// * `max_length`: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    /// * `compliance`: metres per newton, >= 0, of what it yields beyond that; 0 is rigid
    pub fn add_max_distance(&mut self, body: BodyId, particle_a: u32, particle_b: u32, max_length: f32, compliance: f32) -> Result<ConstraintId> {
        let mut out_constraint = ConstraintId::default();
        check(unsafe { sys::gphys_solver_add_max_distance(self.handle.as_ptr(), body, particle_a, particle_b, max_length, compliance, &mut out_constraint) })?;
        Ok(out_constraint)
    }

    /// Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
    /// in addition to its tension; one of `Solver::add_max_distance` never pushes. The decay depends on
    /// time, not on steps. Rigid constraints have nothing to damp.
    ///
    /// Cost: as `Solver::add_distance`.
    ///
    /// * `damping`: N s/m, >= 0; 0, which every constraint begins with: none
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ID`: for a body or constraint that does not exist
    pub fn set_constraint_damping(&mut self, body: BodyId, constraint: ConstraintId, damping: f32) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_constraint_damping(self.handle.as_ptr(), body, constraint, damping) })
    }

    /// Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
    /// setting it again changes it, which inflates a body.
    ///
    /// Cost: O(triangles) in each substep, twice. Allocates.
    ///
    /// * `rest_volume`: m^3, > 0; negative: the present volume
    /// * `compliance`: m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as water,
    ///   which keeps its volume; INFINITY: none, which ends the constraint
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if the triangles do not close (each side is that of two triangles),
    ///   are not oriented consistently, or face inward when the present volume is asked for
    pub fn set_volume(&mut self, body: BodyId, rest_volume: f32, compliance: f32) -> Result<()> {
        check(unsafe { sys::gphys_solver_set_volume(self.handle.as_ptr(), body, rest_volume, compliance) })
    }

    /// The volume held by `Solver::set_volume`, m^3, as it is, and the pressure in pascals with which it
    /// was held at the end of the last step: above 0 it pushes outward.
    ///
    /// Cost: O(triangles).
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if none is held
    pub fn get_volume(&self, body: BodyId) -> Result<(f32, f32)> {
        let mut out_volume = f32::default();
        let mut out_pressure = f32::default();
        check(unsafe { sys::gphys_solver_get_volume(self.handle.as_ptr(), body, &mut out_volume, &mut out_pressure) })?;
        Ok((out_volume, out_pressure))
    }

    /// What was given to `Solver::set_volume`: m^3 (for a negative volume the one at that time), and m^3
    /// per pascal.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: if none is held
    pub fn get_volume_settings(&self, body: BodyId) -> Result<(f32, f32)> {
        let mut out_rest_volume = f32::default();
        let mut out_compliance = f32::default();
        check(unsafe { sys::gphys_solver_get_volume_settings(self.handle.as_ptr(), body, &mut out_rest_volume, &mut out_compliance) })?;
        Ok((out_rest_volume, out_compliance))
    }

    /// Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
    /// triangles of cloth stay together: `Solver::break_constraint` tears them apart.
    ///
    /// Cost: as `Solver::add_distance`; allocates.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ID`: for a body or constraint that does not exist, or no longer
    pub fn remove_constraint(&mut self, body: BodyId, constraint: ConstraintId) -> Result<()> {
        check(unsafe { sys::gphys_solver_remove_constraint(self.handle.as_ptr(), body, constraint) })
    }

    /// All constraints of a body, including those created with the body, by id.
    ///
    /// Cost: O(constraints).
    pub fn get_constraints(&self, body: BodyId) -> Result<Vec<ConstraintInfo>> {
        list(|out_constraints, capacity, total| unsafe { sys::gphys_solver_get_constraints(self.handle.as_ptr(), body, out_constraints, capacity, total) })
    }

    /// Which constraints keep a length, and which a maximum.
    ///
    /// Cost: O(elements). Since 1.1.
    ///
    /// * `constraints`: the ids; one may appear twice
    pub fn get_constraint_kinds<'a>(&self, body: BodyId, constraints: &[ConstraintId], out_kinds: impl Into<BatchMut<'a, ConstraintKind>>) -> Result<()> {
        let constraints = Batch::from(constraints);
        let out_kinds = out_kinds.into();
        let count = common_length(&[constraints.length])?;
        out_kinds.require(count.into())?;
        check(unsafe { sys::gphys_solver_get_constraint_kinds(self.handle.as_ptr(), body, constraints.data, count, out_kinds.data, out_kinds.stride) })
    }

    /// The present settings of constraints.
    ///
    /// Cost: O(elements).
    ///
    /// * `constraints`: the ids; one may appear twice
    pub fn get_constraint_settings<'a>(&self, body: BodyId, constraints: &[ConstraintId], out_settings: impl Into<BatchMut<'a, ConstraintSettings>>) -> Result<()> {
        let constraints = Batch::from(constraints);
        let out_settings = out_settings.into();
        let count = common_length(&[constraints.length])?;
        out_settings.require(count.into())?;
        check(unsafe { sys::gphys_solver_get_constraint_settings(self.handle.as_ptr(), body, constraints.data, count, out_settings.data, out_settings.stride) })
    }

    /// Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
    /// the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
    /// that is v dt shorter before each step of dt. Wakes the body.
    ///
    /// Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
    /// gets longer links O(n log n). Chains are not planned again. Allocates.
    ///
    /// * `constraints`: the ids; one that appears twice gets the last
    pub fn set_constraint_settings<'a>(&mut self, body: BodyId, constraints: &[ConstraintId], settings: impl Into<Batch<'a, ConstraintSettings>>) -> Result<()> {
        let constraints = Batch::from(constraints);
        let settings = settings.into();
        let count = common_length(&[constraints.length, settings.length])?;
        check(unsafe { sys::gphys_solver_set_constraint_settings(self.handle.as_ptr(), body, constraints.data, settings.data, settings.stride, count) })
    }

    /// Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
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
    /// particles approach their shapes in eight passes. What is joined to it by `Solver::join` is solved
    /// together with it, unless one of its particles is attached, or another cluster has it, too: hang
    /// heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
    /// cloth (`SolveMethod::GRAPH`), ropes and free particles too. The rest positions of cloth are not
    /// changed by a cluster.
    ///
    /// Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
    /// us one that touches a model, and up to eight times that if clusters of the body share particles; the
    /// first and the last cluster plan the body again, O(constraints). Since 1.1.
    ///
    /// * `particles`: count different particles, at least 2
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for a particle that does not exist or appears twice
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 clusters of a body, or that many particles in them
    pub fn add_cluster(&mut self, body: BodyId, particles: &[u32]) -> Result<ClusterId> {
        let particles = Batch::from(particles);
        let count = common_length(&[particles.length])?;
        let mut out_cluster = ClusterId::default();
        check(unsafe { sys::gphys_solver_add_cluster(self.handle.as_ptr(), body, particles.data, count, &mut out_cluster) })?;
        Ok(out_cluster)
    }

    /// End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
    ///
    /// Cost: O(particles in clusters of the body). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ID`: for a body or cluster that does not exist, or no longer
    pub fn remove_cluster(&mut self, body: BodyId, cluster: ClusterId) -> Result<()> {
        check(unsafe { sys::gphys_solver_remove_cluster(self.handle.as_ptr(), body, cluster) })
    }

    /// All clusters of a body, by id.
    ///
    /// Cost: O(clusters). Since 1.1.
    pub fn get_clusters(&self, body: BodyId) -> Result<Vec<ClusterId>> {
        list(|out_clusters, capacity, total| unsafe { sys::gphys_solver_get_clusters(self.handle.as_ptr(), body, out_clusters, capacity, total) })
    }

    /// The particles of a cluster, in the order in which they were given.
    ///
    /// Cost: O(particles of the cluster). Since 1.1.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ID`: for a body or cluster that does not exist, or no longer
    pub fn get_cluster_particles(&self, body: BodyId, cluster: ClusterId) -> Result<Vec<u32>> {
        list(|out_particles, capacity, total| unsafe { sys::gphys_solver_get_cluster_particles(self.handle.as_ptr(), body, cluster, out_particles, capacity, total) })
    }

    /// Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
    /// are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
    /// clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
    /// of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
    /// longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
    /// removed with either body. Particles of the two that are linked to a joint within touch of each other
    /// do not collide there.
    ///
    /// Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
    /// of a rope that is not joined. Allocates.
    ///
    /// * `rest_length`: metres; 0: at the same place, as below 1e-9; negative: the present distance.
    ///   Particles at another distance are moved to it in the next step; by a rigid joint without speed.
    /// * `compliance`: metres per newton, >= 0; 0 is rigid
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for a particle that does not exist or twice the same body (see
    ///   `Solver::add_distance`)
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 joints
    pub fn join(&mut self, body_a: BodyId, particle_a: u32, body_b: BodyId, particle_b: u32, rest_length: f32, compliance: f32) -> Result<JointId> {
        let mut out_joint = JointId::default();
        check(unsafe { sys::gphys_solver_join(self.handle.as_ptr(), body_a, particle_a, body_b, particle_b, rest_length, compliance, &mut out_joint) })?;
        Ok(out_joint)
    }

    /// End a joint. Wakes both bodies.
    ///
    /// Cost: as `Solver::join`.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ID`: for a joint that does not exist, or no longer
    pub fn unjoin(&mut self, joint: JointId) -> Result<()> {
        check(unsafe { sys::gphys_solver_unjoin(self.handle.as_ptr(), joint) })
    }

    /// Joints of a body, by id.
    ///
    /// Cost: O(joints of the solver).
    ///
    /// * `body`: 0: of all bodies
    pub fn get_joints(&self, body: BodyId) -> Result<Vec<JointInfo>> {
        list(|out_joints, capacity, total| unsafe { sys::gphys_solver_get_joints(self.handle.as_ptr(), body, out_joints, capacity, total) })
    }

    /// Breaking forces of constraints. Wakes the body.
    ///
    /// Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
    /// pin. Allocates. Since 1.1.
    ///
    /// * `constraints`: the ids; one that appears twice gets the last
    /// * `forces`: newtons, >= 0; 0: never breaks, as all that are added to a body later
    pub fn set_breaking_forces<'a>(&mut self, body: BodyId, constraints: &[ConstraintId], forces: impl Into<Batch<'a, f32>>) -> Result<()> {
        let constraints = Batch::from(constraints);
        let forces = forces.into();
        let count = common_length(&[constraints.length, forces.length])?;
        check(unsafe { sys::gphys_solver_set_breaking_forces(self.handle.as_ptr(), body, constraints.data, forces.data, forces.stride, count) })
    }

    /// What `Solver::set_breaking_forces` or `BodyDesc`.breaking_force has set; 0: never breaks.
    ///
    /// Cost: O(elements). Since 1.1.
    ///
    /// * `constraints`: the ids; one may appear twice
    ///
    /// Returns newtons.
    pub fn get_breaking_forces<'a>(&self, body: BodyId, constraints: &[ConstraintId], out_forces: impl Into<BatchMut<'a, f32>>) -> Result<()> {
        let constraints = Batch::from(constraints);
        let out_forces = out_forces.into();
        let count = common_length(&[constraints.length])?;
        out_forces.require(count.into())?;
        check(unsafe { sys::gphys_solver_get_breaking_forces(self.handle.as_ptr(), body, constraints.data, count, out_forces.data, out_forces.stride) })
    }

    /// Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
    ///
    /// Cost: O(particles + constraints); allocates. Since 1.1.
    ///
    /// Returns what came of it.
    ///
    /// # Errors
    /// * `Status::ERROR_UNSUPPORTED`: and nothing has changed, for an edge where the cloth cannot part: of
    ///   a triangle that is connected to no other
    /// * `Status::ERROR_CAPACITY`: beyond 2^24 - 1 particles or constraints
    pub fn break_constraint(&mut self, body: BodyId, constraint: ConstraintId) -> Result<Break> {
        let mut out_result = Break::default();
        check(unsafe { sys::gphys_solver_break_constraint(self.handle.as_ptr(), body, constraint, &mut out_result) })?;
        Ok(out_result)
    }

    /// Constraints that broke in the last `Solver::step` or `Solver::advance`, in its order: for sounds,
    /// dust, and to know that a body has more particles. Not those that the caller broke. They are not part
    /// of snapshots: after `Solver::restore` there are none.
    ///
    /// Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1.
    pub fn get_breaks(&self) -> Result<Vec<Break>> {
        list(|out_breaks, capacity, total| unsafe { sys::gphys_solver_get_breaks(self.handle.as_ptr(), out_breaks, capacity, total) })
    }

    /// Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
    /// takes more where they would be longer than 25 ms.
    /// Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
    /// through particles. A model moves evenly from its place at the last step to its present one, unless
    /// it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
    /// that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
    /// is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
    /// Allocates when what it steps has changed.
    ///
    /// Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
    /// scene query for a body that the last step, of the same dt, left exactly as it was.
    ///
    /// * `scene`: to collide with and to follow attachments; None: none. Not modified.
    /// * `dt`: seconds, 1e-6 .. 0.5
    pub fn step(&mut self, scene: Option<&Scene>, dt: f32) -> Result<()> {
        check(unsafe { sys::gphys_solver_step(self.handle.as_ptr(), scene.map_or(null_mut(), |o| o.handle.as_ptr()), dt) })
    }

    /// Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
    /// so the motion does not depend on the frame rate. Models, pins and animation targets are given the
    /// places of the end of the frame. They move there evenly in the time since the last step: attached
    /// particles, pins and what lies on models are at their places of the time that the solver has reached,
    /// leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
    /// step.
    ///
    /// Cost: that of the steps made.
    ///
    /// * `frame_time`: seconds, >= 0
    ///
    /// Returns steps made. 0 <= fraction of a step still owed < 1, to interpolate when drawing.
    ///
    /// # Errors
    /// * `Status::ERROR_OUT_OF_MEMORY`: if there is none for the first step: nothing has changed. If there
    ///   is none for a later one
    pub fn advance(&mut self, scene: Option<&Scene>, frame_time: f32) -> Result<(u32, f32)> {
        let mut out_steps = u32::default();
        let mut out_leftover = f32::default();
        check(unsafe { sys::gphys_solver_advance(self.handle.as_ptr(), scene.map_or(null_mut(), |o| o.handle.as_ptr()), frame_time, &mut out_steps, &mut out_leftover) })?;
        Ok((out_steps, out_leftover))
    }

    /// The fraction of a step that `Solver::advance` still owes: what it gave last as leftover, unless the
    /// solver was restored or given another fixed_step since.
    ///
    /// Cost: O(1). Since 1.1.
    ///
    /// Returns from 0 to below 1.
    pub fn get_leftover(&self) -> Result<f32> {
        let mut out_leftover = f32::default();
        check(unsafe { sys::gphys_solver_get_leftover(self.handle.as_ptr(), &mut out_leftover) })?;
        Ok(out_leftover)
    }

    /// The substeps that a body took in the last step; 0 before its first. With `SolverDesc`.max_strain or
    /// tolerance set, each body takes as many as its own motion needs: their length follows from what the
    /// last step measured, the largest strain of its rigid constraints and the local error of the time
    /// scheme, both proportional to the square of that length. It is at most quartered and grows by at most
    /// an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
    /// strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
    /// max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
    /// by contacts, the error is that of the jump. What may meet others takes at least the set number.
    ///
    /// Cost: O(1).
    pub fn get_substeps(&self, body: BodyId) -> Result<u32> {
        let mut out_substeps = u32::default();
        check(unsafe { sys::gphys_solver_get_substeps(self.handle.as_ptr(), body, &mut out_substeps) })?;
        Ok(out_substeps)
    }

    /// Counts, strain and energy of a body at present.
    ///
    /// Cost: O(particles + constraints).
    ///
    /// * `body`: 0: all bodies together
    pub fn get_stats(&self, body: BodyId) -> Result<SolverStats> {
        let mut out_stats = SolverStats::default();
        check(unsafe { sys::gphys_solver_get_stats(self.handle.as_ptr(), body, &mut out_stats) })?;
        Ok(out_stats)
    }

    /// Contacts of the last step by body, particle, model.
    ///
    /// Cost: O(contacts).
    pub fn get_contacts(&self) -> Result<Vec<Contact>> {
        list(|out_contacts, capacity, total| unsafe { sys::gphys_solver_get_contacts(self.handle.as_ptr(), out_contacts, capacity, total) })
    }

    /// Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b, particle_b:
    /// for sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep.
    /// Contacts with a body that was removed are no longer listed. They are not part of snapshots: after
    /// `Solver::restore` there are none until the next step. Contacts within a body
    /// (`BodyDesc`.self_collision) are not listed. where particles have more than 12 contacts on average,
    /// not all are known.
    ///
    /// Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1.
    pub fn get_body_contacts(&self) -> Result<Vec<BodyContact>> {
        list(|out_contacts, capacity, total| unsafe { sys::gphys_solver_get_body_contacts(self.handle.as_ptr(), out_contacts, capacity, total) })
    }

    /// Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
    /// which they fell asleep. After `Solver::advance`, times the steps that it made, they are those of the
    /// frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
    /// particle of cloth that touches several models at once gives its impulse to the one that it touches
    /// most. Models have no mass here: the step does as if they went where you put them, whatever the
    /// force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
    /// well below the mass of the body, which needs some damping; a body of yours much lighter than what
    /// hangs from it should be moved in small steps.
    ///
    /// Cost: O(models touched); no allocation. The same bits for any number of workers.
    pub fn get_impulses(&self) -> Result<Vec<Impulse>> {
        list(|out_impulses, capacity, total| unsafe { sys::gphys_solver_get_impulses(self.handle.as_ptr(), out_impulses, capacity, total) })
    }

    /// Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
    /// impulses, time that `Solver::advance` still owes. The scene, workers and allocator are not in it.
    ///
    /// Cost: O(particles + constraints), some 50 words for each.
    ///
    /// Returns the snapshot. It is for the same release of the library and machines of the same byte order;
    /// it may be stored, but not changed.
    ///
    /// # Errors
    /// * `Status::ERROR_CAPACITY`: beyond 2^32 - 1 words
    pub fn get_snapshot(&self) -> Result<Vec<u32>> {
        list(|out_words, capacity, total| unsafe { sys::gphys_solver_get_snapshot(self.handle.as_ptr(), out_words, capacity, total) })
    }

    /// Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
    /// time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
    /// too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
    /// source: all that is used as a number or an index is checked first. Forged words are refused, or
    /// taken as a state whose numbers are in range.
    ///
    /// Cost: as `Solver::get_snapshot`; allocates.
    ///
    /// # Errors
    /// * `Status::ERROR_INVALID_ARGUMENT`: for words that are no snapshot, damaged, of another version or
    ///   byte order
    /// * `Status::ERROR_OUT_OF_MEMORY`: if there is no room for it
    pub fn restore(&mut self, words: &[u32]) -> Result<()> {
        let words = Batch::from(words);
        let count = common_length(&[words.length])?;
        check(unsafe { sys::gphys_solver_restore(self.handle.as_ptr(), words.data, count) })
    }

    /// A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
    /// different ones differ with near certainty (not against an adversary). Compare it between machines
    /// that run the same simulation, to detect when they diverge.
    ///
    /// Cost: O(particles + constraints).
    pub fn get_hash(&self) -> Result<[u32; 2]> {
        let mut out_hash = [u32::default(); 2];
        check(unsafe { sys::gphys_solver_get_hash(self.handle.as_ptr(), out_hash.as_mut_ptr()) })?;
        Ok(out_hash)
    }

}

/// Whether the fields of the shape are in the ranges stated beside its struct.
///
/// Cost: O(1).
///
/// # Errors
/// * `Status::ERROR_INVALID_ARGUMENT`: and the error's message names the field
pub fn validate(shape: &dyn Shape) -> Result<()> {
    check(unsafe { sys::gphys_shape_validate(shape.shape_type(), shape.pointer()) })
}

/// The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
///
/// Cost: O(1), for a mesh too.
///
/// Returns `None` for a plane, a ray without end (or with one beyond all floats) and a frustum that
/// extends to infinity; for an empty mesh or frustum.
pub fn bounds(shape: &dyn Shape) -> Result<Option<Aabb>> {
    let mut out_bounds = Aabb::default();
    Ok(found(unsafe { sys::gphys_shape_bounds(shape.shape_type(), shape.pointer(), &mut out_bounds) })?.then_some(out_bounds))
}

/// Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
/// answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
/// rotation in double precision). Others are as `overlaps` with a sphere.
///
/// Cost: O(1); O(log n) expected for a mesh.
///
/// * `tolerance`: metres, >= 0
pub fn contains(shape: &dyn Shape, point: impl Into<Vec3>, tolerance: f32) -> Result<bool> {
    let point = &point.into();
    let mut out_contains = i32::default();
    check(unsafe { sys::gphys_shape_contains(shape.shape_type(), shape.pointer(), point, tolerance, &mut out_contains) })?;
    Ok(out_contains != 0)
}

/// Whether each of the points is within tolerance metres of one shape, as `contains`.
///
/// Cost: that of as many single calls.
///
/// * `tolerance`: metres, >= 0, for all points
pub fn contains_batch<'a>(shape: &dyn Shape, points: impl Into<Batch<'a, Vec3>>, tolerance: f32, out_contains: impl Into<BatchMut<'a, i32>>) -> Result<()> {
    let points = points.into();
    let out_contains = out_contains.into();
    let count = common_length(&[points.length])?;
    out_contains.require(count.into())?;
    check(unsafe { sys::gphys_shape_contains_batch(shape.shape_type(), shape.pointer(), points.data, points.stride, count, tolerance, out_contains.data, out_contains.stride) })
}

/// The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
/// ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
/// difference. If several are equally close, one of them, always the same. For a ray, t is limited by
/// t_max.
///
/// Cost: O(1); O(log n) expected for a mesh.
///
/// Returns `None` only for an empty mesh or an empty frustum.
pub fn closest_point(shape: &dyn Shape, point: impl Into<Vec3>) -> Result<Option<Nearest>> {
    let point = &point.into();
    let mut out_nearest = Nearest::default();
    Ok(found(unsafe { sys::gphys_shape_closest_point(shape.shape_type(), shape.pointer(), point, &mut out_nearest) })?.then_some(out_nearest))
}

/// The points of one shape that are closest to each of the points, as `closest_point`. An element for
/// which there is none gets distance INFINITY.
///
/// Cost: that of as many single calls.
pub fn closest_point_batch<'a>(shape: &dyn Shape, points: impl Into<Batch<'a, Vec3>>, out_nearest: impl Into<BatchMut<'a, Nearest>>) -> Result<()> {
    let points = points.into();
    let out_nearest = out_nearest.into();
    let count = common_length(&[points.length])?;
    out_nearest.require(count.into())?;
    check(unsafe { sys::gphys_shape_closest_point_batch(shape.shape_type(), shape.pointer(), points.data, points.stride, count, out_nearest.data, out_nearest.stride) })
}

/// The closest points of two segments and their distance. Parallel segments have many: the first along
/// a, always the same.
///
/// Cost: O(1).
///
/// Returns metres.
pub fn segment_closest_points(a: &Segment, b: &Segment) -> Result<(Vec3, Vec3, f32)> {
    let mut out_a = Vec3::default();
    let mut out_b = Vec3::default();
    let mut out_distance = f32::default();
    check(unsafe { sys::gphys_segment_closest_points(a, b, &mut out_a, &mut out_b, &mut out_distance) })?;
    Ok((out_a, out_b, out_distance))
}

/// Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
/// frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
/// not overlap it. A convex hull (`Mesh`) is solid. Exact between AABBs, planes, triangles, meshes and
/// frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
/// the largest coordinate difference.
///
/// Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or segment (see `segment_test`)
pub fn overlaps(a: &dyn Shape, b: &dyn Shape) -> Result<bool> {
    let mut out_overlaps = i32::default();
    check(unsafe { sys::gphys_shape_overlaps(a.shape_type(), a.pointer(), b.shape_type(), b.pointer(), &mut out_overlaps) })?;
    Ok(out_overlaps != 0)
}

/// Whether the shapes of each of the pairs overlap, as `overlaps`: pair i is `a[i]` against `b[i]`.
///
/// Cost: that of as many single calls.
///
/// * `a`, `b`: shapes of one type
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for rays and segments
pub fn overlaps_batch<'a>(a: impl Into<Shapes<'a>>, b: impl Into<Shapes<'a>>, out_overlaps: impl Into<BatchMut<'a, i32>>) -> Result<()> {
    let a = a.into();
    let b = b.into();
    let out_overlaps = out_overlaps.into();
    let count = common_length(&[a.length, b.length])?;
    out_overlaps.require(count.into())?;
    check(unsafe { sys::gphys_shape_overlaps_batch(a.shape_type(), a.data, a.stride, b.shape_type(), b.data, b.stride, count, out_overlaps.data, out_overlaps.stride) })
}

/// Classify a sphere, capsule, AABB, OBB or triangle against a plane.
///
/// Cost: O(1).
///
/// Returns metres, of the shape's nearest point to the plane: > 0 in front, < 0 behind, 0 when
/// crossing.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for other types of shapes
pub fn classify_plane(shape: &dyn Shape, plane: &Plane) -> Result<(Side, f32)> {
    let mut out_side = Side::default();
    let mut out_signed_distance = f32::default();
    check(unsafe { sys::gphys_shape_classify_plane(shape.shape_type(), shape.pointer(), plane, &mut out_side, &mut out_signed_distance) })?;
    Ok((out_side, out_signed_distance))
}

/// Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
/// point is shared, inside that the frustum holds the whole shape.
///
/// Cost: O(1).
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for other types of shapes
pub fn classify_frustum(shape: &dyn Shape, frustum: &Frustum) -> Result<Side> {
    let mut out_side = Side::default();
    check(unsafe { sys::gphys_shape_classify_frustum(shape.shape_type(), shape.pointer(), frustum, &mut out_side) })?;
    Ok(out_side)
}

/// First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
/// and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
/// always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
/// all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
/// distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
/// docs/accuracy.md has the bounds of all functions.
///
/// Cost: O(1); O(log n) expected for a mesh.
///
/// Returns `None` if nothing is found.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or a segment as the shape
pub fn raycast(shape: &dyn Shape, ray: &Ray) -> Result<Option<Hit>> {
    let mut out_hit = Hit::default();
    Ok(found(unsafe { sys::gphys_shape_raycast(shape.shape_type(), shape.pointer(), ray, &mut out_hit) })?.then_some(out_hit))
}

/// First hits of the rays with one shape, as `raycast`. A ray that hits nothing gets t = INFINITY,
/// triangle = `NO_TRIANGLE` and zeros in its hits element.
///
/// Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or a segment as the shape
pub fn raycast_batch<'a>(shape: &dyn Shape, rays: impl Into<Batch<'a, Ray>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
    let rays = rays.into();
    let out_hits = out_hits.into();
    let count = common_length(&[rays.length])?;
    out_hits.require(count.into())?;
    check(unsafe { sys::gphys_shape_raycast_batch(shape.shape_type(), shape.pointer(), rays.data, rays.stride, count, out_hits.data, out_hits.stride) })
}

/// First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
/// segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
/// direction, the normal is zero.
///
/// Cost: as `raycast`.
///
/// Returns `None` if nothing is found.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or a segment as the shape
pub fn segment_test(shape: &dyn Shape, segment: &Segment) -> Result<Option<Hit>> {
    let mut out_hit = Hit::default();
    Ok(found(unsafe { sys::gphys_shape_segment_test(shape.shape_type(), shape.pointer(), segment, &mut out_hit) })?.then_some(out_hit))
}

/// First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
/// triangle, frustum or mesh.
///
/// Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
///
/// Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
/// mesh.
///
/// * `displacement`: metres; may be zero
///
/// Returns t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
/// the sphere's centre; in double precision its dot with the displacement is never above 0. Already
/// overlapping: t = 0, `HIT_INSIDE`, and the normal may be along the displacement too; where the centre
/// itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere of radius
/// 0 gets the hit of the ray along its path. `None` if nothing is found.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or a segment as the shape
pub fn sweep_sphere(shape: &dyn Shape, sphere: &Sphere, displacement: impl Into<Vec3>) -> Result<Option<Hit>> {
    let displacement = &displacement.into();
    let mut out_hit = Hit::default();
    Ok(found(unsafe { sys::gphys_shape_sweep_sphere(shape.shape_type(), shape.pointer(), sphere, displacement, &mut out_hit) })?.then_some(out_hit))
}

/// First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
/// sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
/// be the hull of its corners (`frustum_corners`).
///
/// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
/// ulp of t. Point and normal are those of that contact.
///
/// Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.
///
/// * `displacement`: metres; may be zero
///
/// Returns t, point and normal as in `sweep_sphere`, which gives the answer for a sphere. The point is
/// one of those where the two touch, always the same. Already overlapping, except for a sphere: t = 0,
/// `HIT_INSIDE`, and point and normal of `penetration`; for a mesh that is not a hull, those of its
/// first triangle. `None` if nothing is found.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for a ray or a segment as the shape, for a frustum that is not the
///   hull of its corners, unless a sphere moves, and for other types that move
pub fn sweep(shape: &dyn Shape, moving: &dyn Shape, displacement: impl Into<Vec3>) -> Result<Option<Hit>> {
    let displacement = &displacement.into();
    let mut out_hit = Hit::default();
    Ok(found(unsafe { sys::gphys_shape_sweep(shape.shape_type(), shape.pointer(), moving.shape_type(), moving.pointer(), displacement, &mut out_hit) })?.then_some(out_hit))
}

/// First contacts of count moving shapes of one type with the shapes of another, as `sweep`: `moving[i]`
/// with `shapes[i]`. One that touches nothing gets t = INFINITY, triangle = `NO_TRIANGLE` and zeros.
///
/// Cost: that of as many single calls. Since 1.1.
///
/// * `shapes`, `moving`: shapes of one type
/// * `displacements`: metres
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: as `sweep`
pub fn sweep_batch<'a>(shapes: impl Into<Shapes<'a>>, moving: impl Into<Shapes<'a>>, displacements: impl Into<Batch<'a, Vec3>>, out_hits: impl Into<BatchMut<'a, Hit>>) -> Result<()> {
    let shapes = shapes.into();
    let moving = moving.into();
    let displacements = displacements.into();
    let out_hits = out_hits.into();
    let count = common_length(&[shapes.length, moving.length, displacements.length])?;
    out_hits.require(count.into())?;
    check(unsafe { sys::gphys_shape_sweep_batch(shapes.shape_type(), shapes.data, shapes.stride, moving.shape_type(), moving.data, moving.stride, displacements.data, displacements.stride, count, out_hits.data, out_hits.stride) })
}

/// The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
/// OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
/// that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
/// translations of their own. Of a hull: out of all of it, and triangle is `NO_TRIANGLE`. A frustum
/// must be the hull of its corners (`frustum_corners`).
///
/// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
/// ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
/// shape. Added to float positions, the translation may leave an overlap as large as the spacing of
/// floats there.
///
/// Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
/// separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
/// Keerthi 1988).
///
/// Returns depth and normal of the translation, which is their product; of several equally short ones
/// always the same one. The deepest point of the solid is point - depth * normal. `None` if nothing is
/// found.
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: for rays, segments, frusta that are not the hull of their corners,
///   and for other types that move
pub fn penetration(shape: &dyn Shape, moving: &dyn Shape) -> Result<Option<Penetration>> {
    let mut out_penetration = Penetration::default();
    Ok(found(unsafe { sys::gphys_shape_penetration(shape.shape_type(), shape.pointer(), moving.shape_type(), moving.pointer(), &mut out_penetration) })?.then_some(out_penetration))
}

/// The shortest translations that take the shapes of one type out of the shapes of another, as
/// `penetration`: `moving[i]` out of `shapes[i]`. One that overlaps nothing gets depth = -INFINITY,
/// triangle = `NO_TRIANGLE` and zeros.
///
/// Cost: that of as many single calls. Since 1.1.
///
/// * `shapes`, `moving`: shapes of one type
///
/// # Errors
/// * `Status::ERROR_UNSUPPORTED`: as `penetration`
pub fn penetration_batch<'a>(shapes: impl Into<Shapes<'a>>, moving: impl Into<Shapes<'a>>, out_penetrations: impl Into<BatchMut<'a, Penetration>>) -> Result<()> {
    let shapes = shapes.into();
    let moving = moving.into();
    let out_penetrations = out_penetrations.into();
    let count = common_length(&[shapes.length, moving.length])?;
    out_penetrations.require(count.into())?;
    check(unsafe { sys::gphys_shape_penetration_batch(shapes.shape_type(), shapes.data, shapes.stride, moving.shape_type(), moving.data, moving.stride, count, out_penetrations.data, out_penetrations.stride) })
}

/// The eight corners, each the intersection of three planes: near then far, each in the order
/// left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
/// intersections themselves, not rounded to floats) if each is within `MAX_COORDINATE` and in front of
/// the three planes that do not meet there, by more than 2^-39 of its distance from origin; that is,
/// unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and
/// pushed out of it; for the bounds of their errors, origin counts as a corner.
///
/// Cost: O(1).
///
/// Returns `None` if three planes do not meet in a point (infinite far plane), or meet beyond the
/// largest float.
pub fn frustum_corners(frustum: &Frustum) -> Result<Option<[Vec3; 8]>> {
    let mut out_corners = [Vec3::default(); 8];
    Ok(found(unsafe { sys::gphys_frustum_corners(frustum, out_corners.as_mut_ptr()) })?.then_some(out_corners))
}

/// The point that three planes have in common, within an ulp of each coordinate.
///
/// Cost: O(1). Source: Cramer's rule. Since 1.1.
///
/// Returns `None` if the planes have no single point in common, which is decided exactly, or one beyond
/// `MAX_COORDINATE`.
pub fn planes_intersection(a: &Plane, b: &Plane, c: &Plane) -> Result<Option<Vec3>> {
    let mut out_point = Vec3::default();
    Ok(found(unsafe { sys::gphys_planes_intersection(a, b, c, &mut out_point) })?.then_some(out_point))
}

/// The points of the triples of planes, as `planes_intersection`; one without gets x = y = z =
/// INFINITY.
///
/// Cost: that of as many single calls. Since 1.1.
///
/// * `a`, `b`, `c`: the planes
pub fn planes_intersection_batch<'a>(a: impl Into<Batch<'a, Plane>>, b: impl Into<Batch<'a, Plane>>, c: impl Into<Batch<'a, Plane>>, out_points: impl Into<BatchMut<'a, Vec3>>) -> Result<()> {
    let a = a.into();
    let b = b.into();
    let c = c.into();
    let out_points = out_points.into();
    let count = common_length(&[a.length, b.length, c.length])?;
    out_points.require(count.into())?;
    check(unsafe { sys::gphys_planes_intersection_batch(a.data, a.stride, b.data, b.stride, c.data, c.stride, count, out_points.data, out_points.stride) })
}

/// How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
/// the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
/// for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
///
/// Cost: O(1). Since 1.1.
///
/// * `matrix`: elements within `MAX_COORDINATE`
pub fn mat4_orthonormality(matrix: &Mat4) -> Result<f32> {
    let mut out_deviation = f32::default();
    check(unsafe { sys::gphys_mat4_orthonormality(matrix, &mut out_deviation) })?;
    Ok(out_deviation)
}

/// The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
/// origin (0, 0, 0). For a camera, `Camera::get_frustum` is more precise.
///
/// Cost: O(1).
///
/// * `reverse_z`: false: near has the low depth; true: near has the high depth
///
/// # Errors
/// * `Status::ERROR_SINGULAR`: if the matrix has no inverse, or what it shows has no volume: its four
///   near corners are not all finite points in front of the viewer
pub fn frustum_from_matrix(view_projection: &Mat4, depth_range: DepthRange, reverse_z: bool) -> Result<Frustum> {
    let reverse_z = i32::from(reverse_z);
    let mut out_frustum = Frustum::default();
    check(unsafe { sys::gphys_frustum_from_matrix(view_projection, depth_range, reverse_z, &mut out_frustum) })?;
    Ok(out_frustum)
}

/// Examine arrays without building anything. Allocates while it runs.
///
/// Cost: O(n log n).
///
/// * `vertices`: elements of 3 floats, metres
/// * `indices`: numbers, three for each triangle
///
/// Returns what was found; indices out of range and bad vertices are counted, not refused.
///
/// # Errors
/// * `Status::ERROR_INVALID_ARGUMENT`: for an index_count that is no multiple of 3
pub fn mesh_check<'a>(vertices: impl Into<Batch<'a, Vec3>>, indices: &[u32]) -> Result<MeshReport> {
    let vertices = vertices.into();
    let indices = Batch::from(indices);
    let mut out_report = MeshReport::default();
    check(unsafe { sys::gphys_mesh_check(vertices.data, vertices.stride, vertices.count()?, indices.data, indices.count()?, &mut out_report) })?;
    Ok(out_report)
}
