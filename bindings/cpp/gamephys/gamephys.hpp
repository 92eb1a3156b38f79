// SPDX-FileCopyrightText: 2026 The gamephys authors
// SPDX-License-Identifier: MIT
// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
#ifndef GAMEPHYS_HPP
#define GAMEPHYS_HPP

#include "gamephys_support.hpp"

namespace gamephys {

using Allocator = gphys_allocator;
using TaskRunner = gphys_task_runner;
using Vec3 = gphys_vec3;
using Quat = gphys_quat;
using Mat4 = gphys_mat4;
using Transform = gphys_transform;
using Ray = gphys_ray;
using Segment = gphys_segment;
using Sphere = gphys_sphere;
using Capsule = gphys_capsule;
using Aabb = gphys_aabb;
using Obb = gphys_obb;
using Plane = gphys_plane;
using Triangle = gphys_triangle;
using Frustum = gphys_frustum;
using Hit = gphys_hit;
using Nearest = gphys_nearest;
using Distance = gphys_distance;
using Penetration = gphys_penetration;
using MeshReport = gphys_mesh_report;
using MeshDesc = gphys_mesh_desc;
using MeshInfo = gphys_mesh_info;
using OctreeStats = gphys_octree_stats;
using OctreeBox = gphys_octree_box;
using SceneDesc = gphys_scene_desc;
using ModelDesc = gphys_model_desc;
using ModelInfo = gphys_model_info;
using QueryFilterDesc = gphys_query_filter_desc;
using CameraDesc = gphys_camera_desc;
using Orbit = gphys_orbit;
using OrbitSpeeds = gphys_orbit_speeds;
using SolverDesc = gphys_solver_desc;
using SolverSettings = gphys_solver_settings;
using BodyDesc = gphys_body_desc;
using BodySettings = gphys_body_settings;
using BodyInfo = gphys_body_info;
using Wind = gphys_wind;
using AnimationTarget = gphys_animation_target;
using Attachment = gphys_attachment;
using ConstraintInfo = gphys_constraint_info;
using ConstraintSettings = gphys_constraint_settings;
using JointInfo = gphys_joint_info;
using Break = gphys_break;
using SolverStats = gphys_solver_stats;
using Contact = gphys_contact;
using BodyContact = gphys_body_contact;
using Impulse = gphys_impulse;

inline MeshDesc mesh_desc() {
    MeshDesc desc;
    check(gphys_mesh_desc_init(&desc, sizeof desc));
    return desc;
}
inline SceneDesc scene_desc() {
    SceneDesc desc;
    check(gphys_scene_desc_init(&desc, sizeof desc));
    return desc;
}
inline ModelDesc model_desc() {
    ModelDesc desc;
    check(gphys_model_desc_init(&desc, sizeof desc));
    return desc;
}
inline QueryFilterDesc query_filter_desc() {
    QueryFilterDesc desc;
    check(gphys_query_filter_desc_init(&desc, sizeof desc));
    return desc;
}
// The same with ignored_models, to which the result points: they have to stay as long as it is used.
inline QueryFilterDesc query_filter_desc(Span<const gphys_model_id> ignored_models) {
    QueryFilterDesc desc = query_filter_desc();
    desc.ignored_models = ignored_models.contiguous("ignored_models");
    desc.ignored_count = ignored_models.size;
    return desc;
}
inline QueryFilterDesc query_filter_desc(std::vector<gphys_model_id>&& ignored_models) = delete;
inline CameraDesc camera_desc() {
    CameraDesc desc;
    check(gphys_camera_desc_init(&desc, sizeof desc));
    return desc;
}
inline SolverDesc solver_desc() {
    SolverDesc desc;
    check(gphys_solver_desc_init(&desc, sizeof desc));
    return desc;
}
inline BodyDesc body_desc() {
    BodyDesc desc;
    check(gphys_body_desc_init(&desc, sizeof desc));
    return desc;
}

struct ShapeRef;
struct ShapeSpan;

class Mesh;
class Scene;
class Camera;
class Solver;

// A shape of any kind, for the time of a call.
struct ShapeRef {
    gphys_shape_type type;
    const void* pointer;
    ShapeRef(const gphys_sphere& shape) : type(GPHYS_SHAPE_SPHERE), pointer(&shape) {}
    ShapeRef(const gphys_capsule& shape) : type(GPHYS_SHAPE_CAPSULE), pointer(&shape) {}
    ShapeRef(const gphys_aabb& shape) : type(GPHYS_SHAPE_AABB), pointer(&shape) {}
    ShapeRef(const gphys_obb& shape) : type(GPHYS_SHAPE_OBB), pointer(&shape) {}
    ShapeRef(const gphys_plane& shape) : type(GPHYS_SHAPE_PLANE), pointer(&shape) {}
    ShapeRef(const gphys_triangle& shape) : type(GPHYS_SHAPE_TRIANGLE), pointer(&shape) {}
    ShapeRef(const gphys_frustum& shape) : type(GPHYS_SHAPE_FRUSTUM), pointer(&shape) {}
    ShapeRef(const gphys_ray& shape) : type(GPHYS_SHAPE_RAY), pointer(&shape) {}
    ShapeRef(const gphys_segment& shape) : type(GPHYS_SHAPE_SEGMENT), pointer(&shape) {}
    ShapeRef(const Mesh& mesh);
};

// An array of shapes of one kind, or one shape that stands for each of them.
struct ShapeSpan {
    gphys_shape_type type;
    const void* data;
    uint32_t stride = 0;
    uint32_t size = 1;
    uint32_t sizes() const { return stride ? size : ANY_SIZE; }
    ShapeSpan(Span<const gphys_sphere> shapes) : type(GPHYS_SHAPE_SPHERE), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_capsule> shapes) : type(GPHYS_SHAPE_CAPSULE), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_aabb> shapes) : type(GPHYS_SHAPE_AABB), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_obb> shapes) : type(GPHYS_SHAPE_OBB), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_plane> shapes) : type(GPHYS_SHAPE_PLANE), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_triangle> shapes) : type(GPHYS_SHAPE_TRIANGLE), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_frustum> shapes) : type(GPHYS_SHAPE_FRUSTUM), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_ray> shapes) : type(GPHYS_SHAPE_RAY), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(Span<const gphys_segment> shapes) : type(GPHYS_SHAPE_SEGMENT), data(shapes.data), stride(shapes.stride), size(shapes.size) {}
    ShapeSpan(const gphys_sphere& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_capsule& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_aabb& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_obb& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_plane& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_triangle& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_frustum& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_ray& shape) : ShapeSpan(ShapeRef(shape)) {}
    ShapeSpan(const gphys_segment& shape) : ShapeSpan(ShapeRef(shape)) {}
    template <class C, class T = ElementOf<C>>
    ShapeSpan(const C& shapes) : ShapeSpan(Span<const T>(shapes)) {}
    ShapeSpan(ShapeRef shape) : type(shape.type), data(shape.pointer) {}
    ShapeSpan(const Mesh& mesh) : ShapeSpan(ShapeRef(mesh)) {}
};

class Mesh : public Object<gphys_mesh, gphys_mesh_destroy> {
public:
    // Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as the
    // segments or points that they are, and the report counts them. 0 triangles are allowed.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for an index out of range, an index_count that is no
    // multiple of 3 or a bad vertex; gamephys::mesh_check tells which.
    // Cost: O(n log n), about 1 us per triangle.
    explicit Mesh(Span<const float> vertices, Span<const uint32_t> indices, const MeshDesc* desc = nullptr) {
        gphys_mesh* made = nullptr;
        check(gphys_mesh_create(desc, vertices.data, vertices.stride, vertices.size, indices.contiguous("indices"), indices.size, &made));
        own(made);
    }

    // Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
    // wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose particles
    // stay outside and are pushed out. A ray that starts inside hits at t = 0 with GPHYS_HIT_INSIDE; one
    // from outside hits the face through which it enters, `triangle` says where. Whether a ray hits and
    // whether a point is inside is exact with respect to the points. Inside, the closest point is the
    // point itself and triangle GPHYS_NO_TRIANGLE. Mesh::overlap lists the triangles of the surface;
    // Mesh::raycast_all gives only the first hit. The vertices are the points that are corners of the
    // hull, in their original order; of equal points the first. The triangles come face by face, all that
    // lie in one plane being one face; seen from outside their corners go counterclockwise where axes are
    // right-handed, and the normal cross(b - a, c - a) points out.
    //   - desc: deformable must be 0
    //   - points: elements of 3 floats, metres; copied
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if a point is out of range or if all lie in a plane,
    // which is decided exactly.
    // Throws Error with GPHYS_ERROR_CAPACITY if the hull has more than 256 faces.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if desc asks for a deformable mesh.
    // Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
    // Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.
    explicit Mesh(Span<const float> points, const MeshDesc* desc = nullptr) {
        gphys_mesh* made = nullptr;
        check(gphys_mesh_create_hull(desc, points.data, points.stride, points.size, &made));
        own(made);
    }

    // Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
    // snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
    // checked, and what follows from them is computed. Forged words are refused, or taken as a mesh like
    // any other; only the counts of its report (triangles of zero area, open edges) are taken from the
    // words as they are.
    //   - desc: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot of a mesh, damaged, of
    // a later format or of another byte order.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for a deformable hull.
    // Cost: O(n), a small part of Mesh's; allocates.
    explicit Mesh(Span<const uint32_t> words, const MeshDesc* desc = nullptr) {
        gphys_mesh* made = nullptr;
        check(gphys_mesh_create_from_snapshot(desc, words.contiguous("words"), words.size, &made));
        own(made);
    }

    // A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh::set_vertices does
    // to it is seen by all its models. It gives the meshes of a restored scene, which are not deformable
    // if they were embedded in its snapshot.
    // Result: a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the model's shape is no mesh.
    // Cost: O(1). Since 1.1.
    explicit Mesh(const Scene& scene, gphys_model_id model);

    // Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles can
    // be hit by rays, picked, overlapped and culled as models of scenes (Scene::add with GPHYS_SHAPE_MESH;
    // without a transform the model is where the body is) or queried by shape_* and mesh_* functions.
    // Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the order of
    // Solver::get_triangles. A rope of n particles is solid. In a hit, `triangle` t below n - 1 is the
    // link from particle t to t + 1, a capsule with the smaller of their radii, present while a constraint
    // holds them together; n - 1 + p is particle p, a sphere, present where no link beside it is as thick.
    // Free particles are spheres, and `triangle` is the particle. Solver::get_nearest_particle finds the
    // particle of a hit. The mesh has the new form when Solver::step, Solver::advance, Solver::restore or
    // an edit of the body returns. When cloth tears (Break), its triangles keep their numbers, and the
    // mesh gets vertices for the new particles. A model that would leave the range of the world, and a
    // torn mesh or one of less than 2^-32 m for which there is no memory, keep their form until they can
    // follow. Solver::set_origin moves the coordinates of the mesh, and the models back by as much: they
    // stay where they are in the world, exactly if scenes have moved their origin before. Bodies neither
    // collide with models of such meshes nor wake because of them: BodyDesc.body_layers sets which bodies
    // collide. A restored body is followed if it has the same id and parts as before. Restore the solver
    // before the scene. A mesh that is loaded from a snapshot, that of a scene included, is a copy that
    // follows nothing; Scene::set_shape gives its model one that does. Mesh and solver are destroyed in
    // any order. When the body is gone the mesh keeps the form that it had last and is deformable by
    // Mesh::set_vertices, which returns GPHYS_ERROR_UNSUPPORTED before. A mesh that neither its handle nor
    // a model holds follows no more.
    // Threads: the functions above become edits of the mesh and of each scene that has a model of it.
    //   - desc: the mesh is deformable whatever it says
    // Cost: as Mesh, and then that of Mesh::set_vertices for a body that has moved; one that rests is
    // compared, O(particles). Since 1.1.
    explicit Mesh(Solver& solver, gphys_body_id body, const MeshDesc* desc = nullptr);

    // The planes of a hull's faces: normals are unit and point out, within float32 rounding.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for a mesh that is no hull.
    // Cost: O(faces). Since 1.1.
    std::vector<Plane> get_hull_planes() const {
        return list<Plane>([&](Plane* out_planes, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_hull_planes(handle(), out_planes, capacity, total); });
    }

    // For each triangle of a hull the index of its face in the list of Mesh::get_hull_planes, ascending
    // from 0.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for a mesh that is no hull.
    // Cost: O(triangles). Since 1.1.
    std::vector<uint32_t> get_hull_faces() const {
        return list<uint32_t>([&](uint32_t* out_faces, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_hull_faces(handle(), out_faces, capacity, total); });
    }

    // Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
    // Solver::get_positions writes it. All models of the mesh take the new form at once, in every scene,
    // and all answers have the same bits as those of a mesh created from the new vertices. A call that
    // fails leaves the mesh and the scenes as they were. A solver sees the new form at its next step, as a
    // surface that stands still.
    // Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls on
    // these.
    //   - vertices: elements of 3 floats, metres; copied
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the mesh is not deformable.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for a vertex that is not finite or too large, or if a
    // model of the mesh would reach beyond the range of coordinates.
    // Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
    // refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far that
    // the boxes of their groups of eight have twice the area, once as much as creating it. Allocates.
    // Since 1.1.
    void set_vertices(Span<const float> vertices) {
        check(gphys_mesh_set_vertices(handle(), vertices.data, vertices.stride, vertices.size));
    }

    // Kind and size of a mesh, and whether its vertices change.
    // Cost: O(1). Since 1.1.
    MeshInfo get_info() const {
        MeshInfo out_info{};
        check(gphys_mesh_get_info(handle(), &out_info));
        return out_info;
    }

    // What the mesh was built from: the report that gamephys::mesh_check makes of its arrays.
    // Cost: O(1); O(triangles) for a deformable mesh.
    MeshReport get_report() const {
        MeshReport out_report{};
        check(gphys_mesh_get_report(handle(), &out_report));
        return out_report;
    }

    // Copy the vertices out, in metres and in their original order.
    // Cost: O(vertices).
    std::vector<Vec3> get_vertices() const {
        return list<Vec3>([&](Vec3* out_vertices, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_vertices(handle(), out_vertices, capacity, total); });
    }

    // Copy the indices out, three for each triangle, in their original order.
    // Cost: O(n).
    std::vector<uint32_t> get_indices() const {
        return list<uint32_t>([&](uint32_t* out_indices, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_indices(handle(), out_indices, capacity, total); });
    }

    // Copy a mesh out with its tree, from which Mesh makes it without building the tree.
    // Threads: any.
    // Result: the snapshot. Words are in the machine's byte order. Every later release of the same major
    // version reads it.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words.
    // Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.
    std::vector<uint32_t> get_snapshot() const {
        return list<uint32_t>([&](uint32_t* out_words, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_snapshot(handle(), out_words, capacity, total); });
    }

    // All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
    // Cost: O(log n + k) expected.
    std::vector<Hit> raycast_all(const Ray& ray) const {
        return list<Hit>([&](Hit* out_hits, uint32_t capacity, uint32_t* total) { return gphys_mesh_raycast_all(handle(), &ray, out_hits, capacity, total); });
    }

    // Whether a ray hits anything; cheaper than the closest hit.
    // Cost: O(log n) expected.
    bool raycast_any(const Ray& ray) const {
        int32_t out_hit{};
        check(gphys_mesh_raycast_any(handle(), &ray, &out_hit));
        return out_hit != 0;
    }

    // Whether each of the rays hits anything, as Mesh::raycast_any.
    // Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1.
    void raycast_any_batch(Span<const Ray> rays, Span<int32_t> out_hits) const {
        const uint32_t count = common_size({rays.sizes()});
        require_size(out_hits.size, count);
        check(gphys_mesh_raycast_any_batch(handle(), rays.data, rays.stride, count, out_hits.data, out_hits.stride));
    }

    // How far each of the rays goes, and which triangle it hits: t and triangle of gamephys::raycast_batch
    // for the mesh, with the same bits, without the rest of a hit; model is 0.
    // Result: a ray that hits nothing gets t = INFINITY and triangle = GPHYS_NO_TRIANGLE.
    // Cost: less than that of gamephys::raycast_batch. Since 1.1.
    void raycast_distance_batch(Span<const Ray> rays, Span<Distance> out_distances) const {
        const uint32_t count = common_size({rays.sizes()});
        require_size(out_distances.size, count);
        check(gphys_mesh_raycast_distance_batch(handle(), rays.data, rays.stride, count, out_distances.data, out_distances.stride));
    }

    // Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
    // ascending.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types of shapes.
    // Cost: O(log n + k) expected.
    std::vector<uint32_t> overlap(ShapeRef shape) const {
        return list<uint32_t>([&](uint32_t* out_triangles, uint32_t capacity, uint32_t* total) { return gphys_mesh_overlap(handle(), shape.type, shape.pointer, out_triangles, capacity, total); });
    }

    // How the mesh's octree is made up.
    // Cost: O(nodes).
    OctreeStats get_octree_stats() const {
        OctreeStats out_stats{};
        check(gphys_mesh_get_octree_stats(handle(), &out_stats));
        return out_stats;
    }

    // Boxes of the mesh's octree, each parent before its children.
    // Cost: O(nodes).
    std::vector<OctreeBox> get_octree_boxes() const {
        return list<OctreeBox>([&](OctreeBox* out_boxes, uint32_t capacity, uint32_t* total) { return gphys_mesh_get_octree_boxes(handle(), out_boxes, capacity, total); });
    }

};

inline ShapeRef::ShapeRef(const Mesh& mesh) : type(GPHYS_SHAPE_MESH), pointer(mesh.handle()) {}

class Scene : public Object<gphys_scene, gphys_scene_destroy> {
public:
    // Create a scene without models. With a worker_count of n, all batch queries of the scene
    // (Camera::pick_batch too), and adding and moving many models, share their work among n threads; the
    // results have the same bits for every n. Without a task_runner n - 1 threads are started here and
    // joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
    // own thread alone. They take no signals but faults, and have the standard floating-point settings. In
    // a child of fork they are gone: calls there run on one thread, as they do on a platform without
    // threads (WebAssembly, unless built for shared memory), whatever is asked for.
    //   - desc: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started.
    // Throws Error with GPHYS_ERROR_CAPACITY if reserve_models is above 2^24 - 1.
    // Cost: O(reserve_models), and that of starting the threads.
    explicit Scene(const SceneDesc* desc = nullptr) {
        gphys_scene* made = nullptr;
        check(gphys_scene_create(desc, &made));
        own(made);
    }

    // Change the number of threads that share the calls of a scene, for example when the user changes a
    // setting. They are those of its task_runner if it was created with one. In a child of fork they are
    // started again. Answers keep their bits.
    //   - workers: as SceneDesc.worker_count
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started; the former ones
    // are kept.
    // Cost: that of joining the former threads and starting others; allocates. Since 1.1.
    void set_worker_count(uint32_t workers) {
        check(gphys_scene_set_worker_count(handle(), workers));
    }

    // How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
    // of fork it is still the number that was set, though calls run on one thread.
    // Cost: O(1). Since 1.1.
    uint32_t get_worker_count() const {
        uint32_t out_workers{};
        check(gphys_scene_get_worker_count(handle(), &out_workers));
        return out_workers;
    }

    // Move the point of the world that all coordinates of the scene are relative to, those passed to it
    // and those that it returns. Models stay where they are in the world: the positions of those without a
    // parent become what they are from there, kept in double precision and rounded to float32 once,
    // however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
    // and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
    //   - origin: x, y, z in the world, within GPHYS_MAX_COORDINATE; before the first call 0 0 0
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if a model would leave the range of coordinates.
    // Cost: that of Scene::set_transforms of all models, and 24 bytes a model from the first call on.
    // Queries cost nothing more. Allocates.
    void set_origin(const std::array<double, 3>& origin) {
        check(gphys_scene_set_origin(handle(), origin.data()));
    }

    // Where in the world the scene's coordinates count from.
    // Cost: O(1).
    std::array<double, 3> get_origin() const {
        std::array<double, 3> out_origin{};
        check(gphys_scene_get_origin(handle(), out_origin.data()));
        return out_origin;
    }

    // Add a model.
    //   - shape: sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
    //   - shape: in the model's own coordinates
    //   - transform: local; nullptr is the identity
    //   - desc: nullptr: no parent, layer 1, tag 0
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for another type, or a scale that the shape cannot have
    // (Scene::set_scale).
    // Throws Error with GPHYS_ERROR_INVALID_ID for a stale parent.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 models.
    // Cost: O(log n) amortised.
    gphys_model_id add(ShapeRef shape, const Transform* transform = nullptr, const ModelDesc* desc = nullptr) {
        gphys_model_id out_model{};
        check(gphys_scene_add(handle(), shape.type, shape.pointer, transform, desc, &out_model));
        return out_model;
    }

    // Add the models of one type, all or none, as Scene::add does one.
    // Fails as Scene::add.
    //   - shapes: in the models' own coordinates
    //   - transforms: local; nullptr is the identity
    //   - desc: for all; nullptr: no parent, layer 1, tag 0
    // Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
    // is of the order of n.
    void add_batch(ShapeSpan shapes, Span<const Transform> transforms, const ModelDesc* desc, Span<gphys_model_id> out_models) {
        const uint32_t count = common_size({shapes.sizes(), transforms.sizes()});
        require_size(out_models.size, count);
        check(gphys_scene_add_batch(handle(), shapes.type, shapes.data, shapes.stride, transforms.data, transforms.stride, count, desc, out_models.contiguous("out_models")));
    }

    // Add the models of one type, all or none, each with a desc of its own.
    // Fails as Scene::add; GPHYS_ERROR_STRUCT_SIZE as for a single desc.
    //   - shapes: in the models' own coordinates
    //   - transforms: local; nullptr is the identity
    //   - descs: one for each; nullptr: no parent, layer 1, tag 0. Parents are models that the scene has
    //     before the call
    // Cost: as Scene::add_batch.
    void add_described_batch(ShapeSpan shapes, Span<const Transform> transforms, Span<const ModelDesc> descs, Span<gphys_model_id> out_models) {
        const uint32_t count = common_size({shapes.sizes(), transforms.sizes(), descs.sizes()});
        require_size(out_models.size, count);
        check(gphys_scene_add_described_batch(handle(), shapes.type, shapes.data, shapes.stride, transforms.data, transforms.stride, descs.data, descs.stride, count, out_models.contiguous("out_models")));
    }

    // Remove a model. Its children stay where they are in the world and lose their parent.
    // Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory.
    void remove(gphys_model_id model) {
        check(gphys_scene_remove(handle(), model));
    }

    // Remove models, all or none.
    //   - models: the ids; an id that appears twice is GPHYS_ERROR_INVALID_ID
    // Cost: that of as many calls of Scene::remove. Renews the octree as far as there is memory.
    void remove_batch(Span<const gphys_model_id> models) {
        const uint32_t count = common_size({models.sizes()});
        check(gphys_scene_remove_batch(handle(), models.contiguous("models"), count));
    }

    // Remove a model and all its descendants.
    // Cost: O(log n) amortised for each. Renews the octree as far as there is memory.
    void remove_subtree(gphys_model_id model) {
        check(gphys_scene_remove_subtree(handle(), model));
    }

    // Remove all models. Ids given out before stay invalid.
    // Cost: O(n).
    void clear() {
        check(gphys_scene_clear(handle()));
    }

    // Whether an id names a model of this scene.
    // Cost: O(1).
    bool has(gphys_model_id model) const {
        const gphys_status status = gphys_scene_has(handle(), model);
        return status != GPHYS_ERROR_INVALID_ID && found(status);
    }

    // Ids of all models, ascending.
    // Cost: O(n).
    std::vector<gphys_model_id> get_models() const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_get_models(handle(), out_models, capacity, total); });
    }

    // Ids of all models without a parent, ascending.
    // Cost: O(n).
    std::vector<gphys_model_id> get_roots() const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_get_roots(handle(), out_models, capacity, total); });
    }

    // Ids of the direct children of a model, ascending.
    // Cost: O(k log k).
    std::vector<gphys_model_id> get_children(gphys_model_id model) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_get_children(handle(), model, out_models, capacity, total); });
    }

    // Kind, parent, layers, tag and number of children of a model.
    // Cost: O(1).
    ModelInfo get_info(gphys_model_id model) const {
        ModelInfo out_info{};
        check(gphys_scene_get_info(handle(), model, &out_info));
        return out_info;
    }

    // World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
    // and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
    // Result: std::nullopt for a plane.
    // Cost: O(1).
    std::optional<Aabb> get_bounds(gphys_model_id model) const {
        Aabb out_bounds{};
        if (!found(gphys_scene_get_bounds(handle(), model, &out_bounds))) return std::nullopt;
        return out_bounds;
    }

    // World box of all bounded models. Planes are left out.
    // Result: std::nullopt if there are none.
    // Cost: O(1).
    std::optional<Aabb> get_scene_bounds() const {
        Aabb out_bounds{};
        if (!found(gphys_scene_get_scene_bounds(handle(), &out_bounds))) return std::nullopt;
        return out_bounds;
    }

    // Give a model another shape, or another mesh, of any type that Scene::add takes: a character
    // crouches, a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
    // transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
    // do of any solid.
    //   - shape: as in Scene::add: a struct, copied, or a mesh with GPHYS_SHAPE_MESH. The scene holds the
    //     new mesh and no longer the old one, which may be the same.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for a frustum, ray or segment, and for a shape that cannot
    // have the model's scale (Scene::set_scale).
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if the model would leave the range of the world.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY .
    // Cost: as Scene::set_transform of a model without children, whatever the size of a mesh.
    void set_shape(gphys_model_id model, ShapeRef shape) {
        check(gphys_scene_set_shape(handle(), model, shape.type, shape.pointer));
    }

    // Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
    // unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
    // normals are those of its surface. Children and attached particles (Solver::attach) are not affected:
    // they follow the transform, whose scale is one number. A new scale replaces the old one. No scale
    // mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners of each triangle.
    // There is no form for many models: three equal numbers belong in their transforms
    // (Scene::set_transforms), and Scene::add_described_batch takes a scale for each model that it adds. A
    // mesh or a hull is scaled exactly, without a copy: answers are those of a mesh of the scaled
    // vertices. Of a box or a triangle each number is multiplied and rounded to float32. A sphere, capsule
    // or plane, and an OBB whose own rotation is not the identity, take three equal numbers only.
    //   - scale: x, y, z, each from 1e-15 to 1e15
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for numbers that are not equal where they have to be, and
    // for the mesh of a rope or of particles (Mesh) unless it is 1 1 1.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if a coordinate of the scaled shape would exceed
    // GPHYS_MAX_COORDINATE, if a number times that of a mesh's world transform is not from 1e-15 to 1e15,
    // or if the model would leave the range of the world.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY .
    // Cost: as Scene::set_transform of a model without children. Models that have a scale take 16 bytes
    // more if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1 to
    // 11 % more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of the
    // scaled vertices, whose tree is made for that form.
    void set_scale(gphys_model_id model, const Vec3& scale) {
        check(gphys_scene_set_scale(handle(), model, &scale));
    }

    // The scale of a model's own shape, 1 1 1 unless another was set.
    // Cost: O(1).
    Vec3 get_scale(gphys_model_id model) const {
        Vec3 out_scale{};
        check(gphys_scene_get_scale(handle(), model, &out_scale));
        return out_scale;
    }

    // Change which queries see a model: those with a mask m of which layers & m is not 0. Children are not
    // affected.
    //   - layers: any mask; 0: no query sees it
    // Cost: O(1).
    void set_layers(gphys_model_id model, uint32_t layers = GPHYS_ALL_LAYERS) {
        check(gphys_scene_set_layers(handle(), model, layers));
    }

    // Change the number that a model's hits report beside its id. Children are not affected.
    //   - tag: any number of the caller's
    // Cost: O(1).
    void set_tag(gphys_model_id model, uint32_t tag) {
        check(gphys_scene_set_tag(handle(), model, tag));
    }

    // Make a model the child of another one, or of none (0).
    //   - keep_world: 0: the local transform is kept, the model jumps; 1: the local transform is changed
    //     so that the world transform stays (within float32 rounding)
    // Throws Error with GPHYS_ERROR_CYCLE if parent is the model or one of its descendants.
    // Cost: O(depth of the tree of models), and as Scene::set_transform for what moves. Renews the octree
    // as far as there is memory.
    void set_parent(gphys_model_id model, gphys_model_id parent, int32_t keep_world) {
        check(gphys_scene_set_parent(handle(), model, parent, keep_world));
    }

    // Set a model's local transform. Descendants follow.
    //   - transform: relative to the parent; scale > 0
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if it, or a descendant, would leave the range of
    // the world.
    // Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.
    void set_transform(gphys_model_id model, const Transform& transform) {
        check(gphys_scene_set_transform(handle(), model, &transform));
    }

    // Set the local transforms of many models, all or none; a model that appears twice gets the last.
    // Descendants follow.
    //   - models: the ids
    //   - transforms: as in Scene::set_transform
    // Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
    // the octree as far as there is memory.
    void set_transforms(Span<const gphys_model_id> models, Span<const Transform> transforms) {
        const uint32_t count = common_size({models.sizes(), transforms.sizes()});
        check(gphys_scene_set_transforms(handle(), models.contiguous("models"), transforms.data, transforms.stride, count));
    }

    // Local transforms of the models, as they were set: relative to the parent.
    //   - models: the ids; an id may appear twice
    // Cost: O(elements).
    void get_transforms(Span<const gphys_model_id> models, Span<Transform> out_transforms) const {
        const uint32_t count = common_size({models.sizes()});
        require_size(out_transforms.size, count);
        check(gphys_scene_get_transforms(handle(), models.contiguous("models"), count, out_transforms.data, out_transforms.stride));
    }

    // World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
    // queries are exact with respect to these.
    //   - models: the ids; an id may appear twice
    // Cost: O(elements).
    void get_world_transforms(Span<const gphys_model_id> models, Span<Transform> out_transforms) const {
        const uint32_t count = common_size({models.sizes()});
        require_size(out_transforms.size, count);
        check(gphys_scene_get_world_transforms(handle(), models.contiguous("models"), count, out_transforms.data, out_transforms.stride));
    }

    // Closest model on a ray; the fields are exact as in gamephys::raycast.
    // Result: std::nullopt if nothing is found.
    // Cost: O(log n) expected; no allocation.
    std::optional<Hit> raycast(const Ray& ray, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Hit out_hit{};
        if (!found(gphys_scene_raycast(handle(), &ray, layers, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // Closest models on the rays, as Scene::raycast; a ray that hits nothing gets model = 0 and t =
    // INFINITY.
    // Cost: at most that of as many single calls; shared among workers.
    void raycast_batch(Span<const Ray> rays, uint32_t layers, Span<Hit> out_hits) const {
        const uint32_t count = common_size({rays.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_raycast_batch(handle(), rays.data, rays.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // How far each of the rays goes, and what it hits: t, model and triangle of Scene::raycast_batch, with
    // the same bits, without the rest of a hit. For lidars and depth images.
    // Result: a ray that hits nothing gets t = INFINITY, model = 0 and triangle = GPHYS_NO_TRIANGLE.
    // Cost: less than that of Scene::raycast_batch; shared among workers. Since 1.1.
    void raycast_distance_batch(Span<const Ray> rays, uint32_t layers, Span<Distance> out_distances) const {
        const uint32_t count = common_size({rays.sizes()});
        require_size(out_distances.size, count);
        check(gphys_scene_raycast_distance_batch(handle(), rays.data, rays.stride, count, layers, out_distances.data, out_distances.stride));
    }

    // Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
    // Cost: O(log n) expected.
    bool raycast_any(const Ray& ray, uint32_t layers = GPHYS_ALL_LAYERS) const {
        int32_t out_hit{};
        check(gphys_scene_raycast_any(handle(), &ray, layers, &out_hit));
        return out_hit != 0;
    }

    // Whether each of the rays meets anything, as Scene::raycast_any.
    // Cost: at most that of as many single calls; shared among workers.
    void raycast_any_batch(Span<const Ray> rays, uint32_t layers, Span<int32_t> out_hits) const {
        const uint32_t count = common_size({rays.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_raycast_any_batch(handle(), rays.data, rays.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // Every model that a ray meets, each once with its first hit, by t, then id.
    // Cost: O(log n + k log k) expected.
    std::vector<Hit> raycast_all(const Ray& ray, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<Hit>([&](Hit* out_hits, uint32_t capacity, uint32_t* total) { return gphys_scene_raycast_all(handle(), &ray, layers, out_hits, capacity, total); });
    }

    // Every model that each of the rays meets, as Scene::raycast_all: the hits of ray i are at
    // hits[offsets[i]] up to offsets[i + 1].
    // The contents of hits behind the last hit are unspecified.
    // Cost: that of as many single calls; shared among workers.
    Ragged<Hit> raycast_all_batch(Span<const Ray> rays, uint32_t layers = GPHYS_ALL_LAYERS) const {
        const uint32_t count = common_size({rays.sizes()});
        return ragged<Hit>([&](Hit* out_hits, uint32_t capacity, uint32_t* offsets) { return gphys_scene_raycast_all_batch(handle(), rays.data, rays.stride, count, layers, out_hits, capacity, offsets); }, count);
    }

    // Closest model along a segment from a to b, both included; t in 0..1. Fields as in
    // gamephys::segment_test.
    // Result: std::nullopt if nothing is found.
    // Cost: O(log n) expected.
    std::optional<Hit> segment_test(const Segment& segment, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Hit out_hit{};
        if (!found(gphys_scene_segment_test(handle(), &segment, layers, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // Closest models along the segments, as Scene::segment_test; one that hits nothing gets model = 0 and
    // t = INFINITY.
    // Cost: that of as many single calls; shared among workers.
    void segment_test_batch(Span<const Segment> segments, uint32_t layers, Span<Hit> out_hits) const {
        const uint32_t count = common_size({segments.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_segment_test_batch(handle(), segments.data, segments.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
    // gamephys::overlaps, ascending.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types of shapes.
    // Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
    // more saves most of that, unless many models have replaced removed ones.
    std::vector<gphys_model_id> overlap(ShapeRef shape, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_overlap(handle(), shape.type, shape.pointer, layers, out_models, capacity, total); });
    }

    // Ids of all models that each of the shapes of one type overlaps, as Scene::overlap: those of shape i
    // are at models[offsets[i]] up to offsets[i + 1], as in Scene::raycast_all_batch.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as there.
    // Cost: at most that of as many single calls; shared among workers.
    Ragged<gphys_model_id> overlap_batch(ShapeSpan shapes, uint32_t layers = GPHYS_ALL_LAYERS) const {
        const uint32_t count = common_size({shapes.sizes()});
        return ragged<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* offsets) { return gphys_scene_overlap_batch(handle(), shapes.type, shapes.data, shapes.stride, count, layers, out_models, capacity, offsets); }, count);
    }

    // Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
    // box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
    // edges are listed, too: a few per cent more where models are compact or not rotated; about a third
    // more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
    // many again as are visible where they are as long as the view is wide. Scene::overlap leaves these
    // out by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
    // listed is best: it is used to order them.
    // Cost: O(log n + k) expected.
    std::vector<gphys_model_id> cull(const Frustum& frustum, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_cull(handle(), &frustum, layers, out_models, capacity, total); });
    }

    // Ids of the models in each of count frusta, as Scene::cull: for split screens, cascades of shadow
    // maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
    // offsets[i + 1], as in Scene::raycast_all_batch.
    // Cost: that of as many single calls; shared among workers. Since 1.1.
    Ragged<gphys_model_id> cull_batch(Span<const Frustum> frusta, uint32_t layers = GPHYS_ALL_LAYERS) const {
        const uint32_t count = common_size({frusta.sizes()});
        return ragged<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* offsets) { return gphys_scene_cull_batch(handle(), frusta.data, frusta.stride, count, layers, out_models, capacity, offsets); }, count);
    }

    // The model nearest to a point, and its closest point.
    //   - max_distance: metres, >= 0, INFINITY allowed; a model at exactly this distance counts
    // Result: std::nullopt if nothing is found.
    // Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
    // nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
    // That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
    // in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
    // 15 us.
    std::optional<Nearest> nearest(const Vec3& point, float max_distance, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Nearest out_nearest{};
        if (!found(gphys_scene_nearest(handle(), &point, max_distance, layers, &out_nearest))) return std::nullopt;
        return out_nearest;
    }

    // The models nearest to the points, as Scene::nearest; a point with none gets model = 0 and distance =
    // INFINITY.
    //   - max_distance: metres, >= 0, INFINITY allowed, for all points
    // Cost: that of as many single calls; shared among workers.
    void nearest_batch(Span<const Vec3> points, float max_distance, uint32_t layers, Span<Nearest> out_nearest) const {
        const uint32_t count = common_size({points.sizes()});
        require_size(out_nearest.size, count);
        check(gphys_scene_nearest_batch(handle(), points.data, points.stride, count, max_distance, layers, out_nearest.data, out_nearest.stride));
    }

    // First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
    // gamephys::sweep_sphere.
    //   - displacement: metres; may be zero
    // Result: std::nullopt if nothing is found.
    // Cost: O(log n + k) expected, k the models that the swept box touches.
    std::optional<Hit> sweep_sphere(const Sphere& sphere, const Vec3& displacement, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Hit out_hit{};
        if (!found(gphys_scene_sweep_sphere(handle(), &sphere, &displacement, layers, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // First models that the spheres touch while each moves by its displacement, as Scene::sweep_sphere;
    // one that touches nothing gets model = 0 and t = INFINITY.
    //   - displacements: metres
    // Cost: that of as many single calls; shared among workers.
    void sweep_sphere_batch(Span<const Sphere> spheres, Span<const Vec3> displacements, uint32_t layers, Span<Hit> out_hits) const {
        const uint32_t count = common_size({spheres.sizes(), displacements.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_sweep_sphere_batch(handle(), spheres.data, spheres.stride, displacements.data, displacements.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
    // turning; t in 0..1. Fields as in gamephys::sweep.
    //   - displacement: metres; may be zero
    // Result: std::nullopt if nothing is found.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types.
    // Cost: O(log n + k) expected, k the models that the swept box touches.
    std::optional<Hit> sweep(ShapeRef shape, const Vec3& displacement, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Hit out_hit{};
        if (!found(gphys_scene_sweep(handle(), shape.type, shape.pointer, &displacement, layers, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // First models that the shapes of one type touch while each moves by its displacement, as
    // Scene::sweep; one that touches nothing gets model = 0 and t = INFINITY.
    //   - displacements: metres
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as Scene::sweep.
    // Cost: that of as many single calls; shared among workers.
    void sweep_batch(ShapeSpan shapes, Span<const Vec3> displacements, uint32_t layers, Span<Hit> out_hits) const {
        const uint32_t count = common_size({shapes.sizes(), displacements.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_sweep_batch(handle(), shapes.type, shapes.data, shapes.stride, displacements.data, displacements.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
    // a mesh one for each triangle, as gamephys::penetration. Deepest first; equal depths by model, then
    // triangle. Each is the way out of that one alone. The models are those of Scene::overlap.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types.
    // Cost: O(log n + k log k) expected.
    std::vector<Penetration> penetration(ShapeRef shape, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<Penetration>([&](Penetration* out_penetrations, uint32_t capacity, uint32_t* total) { return gphys_scene_penetration(handle(), shape.type, shape.pointer, layers, out_penetrations, capacity, total); });
    }

    // What each of the shapes of one type overlaps, and how it gets out, as Scene::penetration: the ways
    // out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in Scene::raycast_all_batch.
    // So a crowd of characters is pushed out in one call.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as Scene::penetration.
    // Cost: that of as many single calls; shared among workers. Since 1.1.
    Ragged<Penetration> penetration_batch(ShapeSpan shapes, uint32_t layers = GPHYS_ALL_LAYERS) const {
        const uint32_t count = common_size({shapes.sizes()});
        return ragged<Penetration>([&](Penetration* out_penetrations, uint32_t capacity, uint32_t* offsets) { return gphys_scene_penetration_batch(handle(), shapes.type, shapes.data, shapes.stride, count, layers, out_penetrations, capacity, offsets); }, count);
    }

    // Closest model on a ray that the filter sees, as Scene::raycast.
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for unknown flags, or ignored_models nullptr with an
    // ignored_count above 0.
    // Cost: that of Scene::raycast for one ignored model. For each model that is met within the ray's
    // reach, besides: O(its depth below its root) with GPHYS_FILTER_SUBTREE if ignored_model has children;
    // of m ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m).
    // Whether they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a
    // time.
    std::optional<Hit> raycast_filtered(const Ray& ray, const QueryFilterDesc* filter = nullptr) const {
        Hit out_hit{};
        if (!found(gphys_scene_raycast_filtered(handle(), &ray, filter, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // Closest models on the rays that the filters see, as Scene::raycast_batch.
    //   - filters: nullptr: the defaults
    // Cost: at most that of as many calls of Scene::raycast_filtered; shared among workers.
    void raycast_filtered_batch(Span<const Ray> rays, Span<const QueryFilterDesc> filters, Span<Hit> out_hits) const {
        const uint32_t count = common_size({rays.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_raycast_filtered_batch(handle(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // How far each of the rays goes among the models that its filter sees, as
    // Scene::raycast_distance_batch: a lidar leaves out the robot that carries it.
    //   - filters: nullptr: the defaults
    // Cost: less than that of Scene::raycast_filtered_batch; shared among workers. Since 1.1.
    void raycast_distance_filtered_batch(Span<const Ray> rays, Span<const QueryFilterDesc> filters, Span<Distance> out_distances) const {
        const uint32_t count = common_size({rays.sizes(), filters.sizes()});
        require_size(out_distances.size, count);
        check(gphys_scene_raycast_distance_filtered_batch(handle(), rays.data, rays.stride, count, filters.data, filters.stride, out_distances.data, out_distances.stride));
    }

    // Whether a ray meets anything that the filter sees, as Scene::raycast_any: line of sight between two
    // models that both are left out.
    //   - filter: nullptr: the defaults
    // Cost: as Scene::raycast_filtered.
    bool raycast_any_filtered(const Ray& ray, const QueryFilterDesc* filter = nullptr) const {
        int32_t out_hit{};
        check(gphys_scene_raycast_any_filtered(handle(), &ray, filter, &out_hit));
        return out_hit != 0;
    }

    // Whether each of the rays meets anything that its filter sees, as Scene::raycast_any_batch.
    //   - filters: nullptr: the defaults
    // Cost: at most that of as many single calls; shared among workers.
    void raycast_any_filtered_batch(Span<const Ray> rays, Span<const QueryFilterDesc> filters, Span<int32_t> out_hits) const {
        const uint32_t count = common_size({rays.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_raycast_any_filtered_batch(handle(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // Every model that a ray meets and the filter sees, as Scene::raycast_all.
    //   - filter: nullptr: the defaults
    // Cost: that of Scene::raycast_all, and for each model as Scene::raycast_filtered.
    std::vector<Hit> raycast_all_filtered(const Ray& ray, const QueryFilterDesc* filter = nullptr) const {
        return list<Hit>([&](Hit* out_hits, uint32_t capacity, uint32_t* total) { return gphys_scene_raycast_all_filtered(handle(), &ray, filter, out_hits, capacity, total); });
    }

    // Every model that each of the rays meets and its filter sees, as Scene::raycast_all_batch.
    //   - filters: nullptr: the defaults
    // Cost: that of as many single calls; shared among workers.
    Ragged<Hit> raycast_all_filtered_batch(Span<const Ray> rays, Span<const QueryFilterDesc> filters = {}) const {
        const uint32_t count = common_size({rays.sizes(), filters.sizes()});
        return ragged<Hit>([&](Hit* out_hits, uint32_t capacity, uint32_t* offsets) { return gphys_scene_raycast_all_filtered_batch(handle(), rays.data, rays.stride, count, filters.data, filters.stride, out_hits, capacity, offsets); }, count);
    }

    // Closest model along a segment that the filter sees, as Scene::segment_test.
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Cost: as Scene::raycast_filtered.
    std::optional<Hit> segment_test_filtered(const Segment& segment, const QueryFilterDesc* filter = nullptr) const {
        Hit out_hit{};
        if (!found(gphys_scene_segment_test_filtered(handle(), &segment, filter, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // Closest models along the segments that the filters see, as Scene::segment_test_batch.
    //   - filters: nullptr: the defaults
    // Cost: that of as many single calls; shared among workers.
    void segment_test_filtered_batch(Span<const Segment> segments, Span<const QueryFilterDesc> filters, Span<Hit> out_hits) const {
        const uint32_t count = common_size({segments.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_segment_test_filtered_batch(handle(), segments.data, segments.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // Ids of all models that overlap a shape and that the filter sees, as Scene::overlap.
    //   - filter: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for types of shapes that Scene::overlap does not take.
    // Cost: that of Scene::overlap, and for each model as Scene::raycast_filtered.
    std::vector<gphys_model_id> overlap_filtered(ShapeRef shape, const QueryFilterDesc* filter = nullptr) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_overlap_filtered(handle(), shape.type, shape.pointer, filter, out_models, capacity, total); });
    }

    // Ids of all models that each of the shapes of one type overlaps and its filter sees, as
    // Scene::overlap_batch.
    //   - filters: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as there.
    // Cost: at most that of as many single calls; shared among workers.
    Ragged<gphys_model_id> overlap_filtered_batch(ShapeSpan shapes, Span<const QueryFilterDesc> filters = {}) const {
        const uint32_t count = common_size({shapes.sizes(), filters.sizes()});
        return ragged<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* offsets) { return gphys_scene_overlap_filtered_batch(handle(), shapes.type, shapes.data, shapes.stride, count, filters.data, filters.stride, out_models, capacity, offsets); }, count);
    }

    // Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene::cull: a
    // player's own head, say, is not drawn.
    //   - filter: nullptr: the defaults
    // Cost: that of Scene::cull, and for each model as Scene::raycast_filtered.
    std::vector<gphys_model_id> cull_filtered(const Frustum& frustum, const QueryFilterDesc* filter = nullptr) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_scene_cull_filtered(handle(), &frustum, filter, out_models, capacity, total); });
    }

    // Ids of the models in each of count frusta that its filter sees, as Scene::cull_batch: each player's
    // view leaves out the player's own head.
    //   - filters: nullptr: the defaults
    // Cost: that of as many single calls; shared among workers. Since 1.1.
    Ragged<gphys_model_id> cull_filtered_batch(Span<const Frustum> frusta, Span<const QueryFilterDesc> filters = {}) const {
        const uint32_t count = common_size({frusta.sizes(), filters.sizes()});
        return ragged<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* offsets) { return gphys_scene_cull_filtered_batch(handle(), frusta.data, frusta.stride, count, filters.data, filters.stride, out_models, capacity, offsets); }, count);
    }

    // The model nearest to a point that the filter sees, as Scene::nearest: the nearest other model, if
    // the one at the point is left out.
    //   - max_distance: metres, >= 0, INFINITY allowed; a model at exactly this distance counts
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Cost: that of Scene::nearest, and for each model as Scene::raycast_filtered; each ignored model that
    // is nearer than the answer is visited.
    std::optional<Nearest> nearest_filtered(const Vec3& point, float max_distance, const QueryFilterDesc* filter = nullptr) const {
        Nearest out_nearest{};
        if (!found(gphys_scene_nearest_filtered(handle(), &point, max_distance, filter, &out_nearest))) return std::nullopt;
        return out_nearest;
    }

    // The models nearest to the points that the filters see, as Scene::nearest_batch.
    //   - max_distance: metres, >= 0, INFINITY allowed, for all points
    //   - filters: nullptr: the defaults
    // Cost: that of as many single calls; shared among workers.
    void nearest_filtered_batch(Span<const Vec3> points, float max_distance, Span<const QueryFilterDesc> filters, Span<Nearest> out_nearest) const {
        const uint32_t count = common_size({points.sizes(), filters.sizes()});
        require_size(out_nearest.size, count);
        check(gphys_scene_nearest_filtered_batch(handle(), points.data, points.stride, count, max_distance, filters.data, filters.stride, out_nearest.data, out_nearest.stride));
    }

    // First model that a moving sphere touches and the filter sees, as Scene::sweep_sphere: the sphere may
    // be the bounding sphere of the ignored model.
    //   - displacement: metres; may be zero
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Cost: that of Scene::sweep_sphere, and for each model as Scene::raycast_filtered.
    std::optional<Hit> sweep_sphere_filtered(const Sphere& sphere, const Vec3& displacement, const QueryFilterDesc* filter = nullptr) const {
        Hit out_hit{};
        if (!found(gphys_scene_sweep_sphere_filtered(handle(), &sphere, &displacement, filter, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // First models that count moving spheres touch and the filters see, as Scene::sweep_sphere_batch.
    //   - displacements: metres
    //   - filters: nullptr: the defaults
    // Cost: that of as many single calls; shared among workers.
    void sweep_sphere_filtered_batch(Span<const Sphere> spheres, Span<const Vec3> displacements, Span<const QueryFilterDesc> filters, Span<Hit> out_hits) const {
        const uint32_t count = common_size({spheres.sizes(), displacements.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_sweep_sphere_filtered_batch(handle(), spheres.data, spheres.stride, displacements.data, displacements.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as Scene::sweep:
    // a character leaves out its own model.
    //   - displacement: metres; may be zero
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types.
    // Cost: that of Scene::sweep, and for each model as Scene::raycast_filtered.
    std::optional<Hit> sweep_filtered(ShapeRef shape, const Vec3& displacement, const QueryFilterDesc* filter = nullptr) const {
        Hit out_hit{};
        if (!found(gphys_scene_sweep_filtered(handle(), shape.type, shape.pointer, &displacement, filter, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // First models that count moving shapes of one type touch and the filters see, as Scene::sweep_batch.
    //   - displacements: metres
    //   - filters: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as Scene::sweep.
    // Cost: that of as many single calls; shared among workers.
    void sweep_filtered_batch(ShapeSpan shapes, Span<const Vec3> displacements, Span<const QueryFilterDesc> filters, Span<Hit> out_hits) const {
        const uint32_t count = common_size({shapes.sizes(), displacements.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_scene_sweep_filtered_batch(handle(), shapes.type, shapes.data, shapes.stride, displacements.data, displacements.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
    // Scene::penetration.
    //   - filter: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for other types.
    // Cost: that of Scene::penetration, and for each model as Scene::raycast_filtered.
    std::vector<Penetration> penetration_filtered(ShapeRef shape, const QueryFilterDesc* filter = nullptr) const {
        return list<Penetration>([&](Penetration* out_penetrations, uint32_t capacity, uint32_t* total) { return gphys_scene_penetration_filtered(handle(), shape.type, shape.pointer, filter, out_penetrations, capacity, total); });
    }

    // What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
    // Scene::penetration_batch: each character leaves out its own model.
    //   - filters: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_UNSUPPORTED as Scene::penetration.
    // Cost: that of as many single calls; shared among workers. Since 1.1.
    Ragged<Penetration> penetration_filtered_batch(ShapeSpan shapes, Span<const QueryFilterDesc> filters = {}) const {
        const uint32_t count = common_size({shapes.sizes(), filters.sizes()});
        return ragged<Penetration>([&](Penetration* out_penetrations, uint32_t capacity, uint32_t* offsets) { return gphys_scene_penetration_filtered_batch(handle(), shapes.type, shapes.data, shapes.stride, count, filters.data, filters.stride, out_penetrations, capacity, offsets); }, count);
    }

    // Rebuild the scene's octree, as good as that of one Scene::add_batch. Never required: ids, answers
    // and their bits do not change. Where many models were added one by one, such as a level that was
    // streamed in, rays then take 0.6 to 0.95 of the time.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY with nothing changed.
    // Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.
    void rebuild_octree() {
        check(gphys_scene_rebuild_octree(handle()));
    }

    // Rebuild the octree in parts, one in each call, until it is as good as after Scene::rebuild_octree:
    // for levels that are streamed in while frames go on. Each Scene::add and Scene::remove does a part by
    // itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are. Models
    // may be added, moved and removed between the calls. A call that updates an eighth of them or more
    // restarts it.
    //   - budget: how much work to do, as a number of models, of 0.3 to 3 us each. The work is the same on
    //     every machine and does not depend on time.
    // Result: 1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
    // again.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY : the octree is as before, and the next call begins
    // again.
    // Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.
    bool maintain_octree(uint32_t budget) {
        int32_t out_done{};
        check(gphys_scene_maintain_octree(handle(), budget, &out_done));
        return out_done != 0;
    }

    // How the scene's octree is made up.
    // Cost: O(nodes).
    OctreeStats get_octree_stats() const {
        OctreeStats out_stats{};
        check(gphys_scene_get_octree_stats(handle(), &out_stats));
        return out_stats;
    }

    // Boxes of the scene's octree, each parent before its children.
    // Cost: O(nodes).
    std::vector<OctreeBox> get_octree_boxes() const {
        return list<OctreeBox>([&](OctreeBox* out_boxes, uint32_t capacity, uint32_t* total) { return gphys_scene_get_octree_boxes(handle(), out_boxes, capacity, total); });
    }

    // Check the scene's own structure: every model once in the tree, every box around its content, parents
    // and children in agreement, free slots free. For tests.
    // Throws Error with GPHYS_ERROR_INTERNAL and the exception's message says what is wrong.
    // Cost: O(n).
    void validate() const {
        check(gphys_scene_validate(handle()));
    }

    // Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
    // shapes, the order of future ids, and the octree. Workers and allocator are not in it.
    //   - embed_meshes: 1: meshes are in the snapshot, each once, so it is complete in itself: for saved
    //     games and for other machines. 0: they are identified by their content, and Scene::restore looks
    //     for them: for undo, and rollback each frame.
    // Result: the snapshot. Words are in the machine's byte order. Every later release of the same major
    // version reads it.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words.
    // Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (Mesh::get_snapshot).
    // Allocates a few words for each different mesh.
    std::vector<uint32_t> get_snapshot(int32_t embed_meshes) const {
        return list<uint32_t>([&](uint32_t* out_words, uint32_t capacity, uint32_t* total) { return gphys_scene_get_snapshot(handle(), embed_meshes, out_words, capacity, total); });
    }

    // Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
    // time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
    // that is restored with its scene continues with the same bits. On an error the scene is as before.
    // Any words are safe, also from an untrusted source: all that is used as a number or an index is
    // checked first. Forged words are refused, or taken as a scene like any other.
    //   - library: meshes that are not embedded are looked for among those that models of this scene use,
    //     by their content: vertices and indices. A mesh deformed since must get its old form back first.
    //     nullptr: among those that models of `scene` itself use, before it is restored.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot of a scene, damaged,
    // of a later format or of another byte order, and if a mesh is missing.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY if there is no room for it.
    // Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.
    void restore(const Scene* library, Span<const uint32_t> words) {
        const uint32_t count = common_size({words.sizes()});
        check(gphys_scene_restore(handle(), optional_handle(library), words.contiguous("words"), count));
    }

    // A hash of the whole state except the octree, the low half first; meshes count by their content.
    // Equal states have equal hashes on every machine; different ones differ with near certainty (not
    // against an adversary). Compare it between machines that run the same simulation, to detect when they
    // diverge.
    // Cost: O(n), some 50 ns for each model.
    std::array<uint32_t, 2> get_hash() const {
        std::array<uint32_t, 2> out_hash{};
        check(gphys_scene_get_hash(handle(), out_hash.data()));
        return out_hash;
    }

    // A model's shape in its own coordinates; S is that shape's struct, else std::invalid_argument. An Error for a
    // mesh, which Mesh(scene, model) gives.
    template <class S>
    S get_shape(gphys_model_id model) const {
        S shape{};
        const gphys_shape_type type = get_info(model).type;
        if (type != GPHYS_SHAPE_MESH && type != ShapeRef(shape).type) throw std::invalid_argument("a shape of another kind");
        check(gphys_scene_get_shape(handle(), model, &shape, sizeof shape));
        return shape;
    }

};

class Camera : public Object<gphys_camera, gphys_camera_destroy> {
public:
    // Create a camera at the origin, with the projection and the viewport of its desc.
    //   - desc: nullptr: the defaults
    // Cost: O(1).
    explicit Camera(const CameraDesc* desc = nullptr) {
        gphys_camera* made = nullptr;
        check(gphys_camera_create(desc, &made));
        own(made);
    }

    // Move the point of the world that the camera's coordinates count from; see Scene::set_origin. The
    // camera and the target of its orbit stay where they are in the world. Picking and culling need a
    // scene of the same origin, else they fail with GPHYS_ERROR_INVALID_ARGUMENT.
    //   - origin: x, y, z in the world, metres, within GPHYS_MAX_COORDINATE
    // Cost: O(1).
    void set_origin(const std::array<double, 3>& origin) {
        check(gphys_camera_set_origin(handle(), origin.data()));
    }

    // Where in the world the camera's coordinates count from, metres.
    // Cost: O(1).
    std::array<double, 3> get_origin() const {
        std::array<double, 3> out_origin{};
        check(gphys_camera_get_origin(handle(), out_origin.data()));
        return out_origin;
    }

    // Use a perspective projection: distant objects appear smaller.
    //   - fov_y: full vertical angle in radians, 1e-6 <= fov_y < pi
    //   - near_distance: metres, > 0
    //   - far_distance: metres, > near_distance; INFINITY allowed
    // Cost: O(1).
    void set_perspective(float fov_y, float near_distance, float far_distance) {
        check(gphys_camera_set_perspective(handle(), fov_y, near_distance, far_distance));
    }

    // Use an orthographic projection: the distance does not change apparent size.
    //   - height: metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is at
    //     most twice GPHYS_MAX_COORDINATE
    //   - near_distance: metres, may be negative
    //   - far_distance: metres, at least 1e-6 above near_distance
    // Cost: O(1).
    void set_orthographic(float height, float near_distance, float far_distance) {
        check(gphys_camera_set_orthographic(handle(), height, near_distance, far_distance));
    }

    // Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
    // library's). It is not changed by Camera::set_viewport.
    // Throws Error with GPHYS_ERROR_SINGULAR if it has no inverse, or is too close to such a matrix to
    // tell.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if a plane other than far lies at infinity, as it
    // does when the matrix is for another depth range, or one lies beyond GPHYS_MAX_COORDINATE.
    // Cost: O(1).
    void set_projection(const Mat4& projection) {
        check(gphys_camera_set_projection(handle(), &projection));
    }

    // As Camera::set_perspective, with a fixed aspect ratio: the image is stretched to the viewport, as
    // with pixels that are not square, and the viewport does not change what is seen.
    //   - fov_y: full vertical angle in radians, 1e-6 <= fov_y < pi
    //   - aspect: width over height of what is seen, 1e-6 .. 1e6
    //   - near_distance: metres, > 0
    //   - far_distance: metres, > near_distance; INFINITY allowed
    // Cost: O(1). Since 1.1.
    void set_perspective_aspect(float fov_y, float aspect, float near_distance, float far_distance) {
        check(gphys_camera_set_perspective_aspect(handle(), fov_y, aspect, near_distance, far_distance));
    }

    // As Camera::set_orthographic, with a width of its own, which the viewport does not change.
    //   - width: metres seen from left to right, >= 1e-6
    //   - height: metres seen from top to bottom, >= 1e-6
    //   - near_distance: metres, may be negative
    //   - far_distance: metres, at least 1e-6 above near_distance
    // Cost: O(1). Since 1.1.
    void set_orthographic_size(float width, float height, float near_distance, float far_distance) {
        check(gphys_camera_set_orthographic_size(handle(), width, height, near_distance, far_distance));
    }

    // Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height; the
    // call is refused if that makes the width more than twice GPHYS_MAX_COORDINATE.
    //   - width, height: pixels, 1e-3 .. 1e6
    // Cost: O(1).
    void set_viewport(float width, float height) {
        check(gphys_camera_set_viewport(handle(), width, height));
    }

    // Where the viewport is in its window, as one of several of a split screen: pixels of all functions
    // count from the window's top left corner. (0, 0) at creation.
    //   - x: pixels from the window's left edge to the viewport's
    //   - y: pixels from the window's top edge to the viewport's
    // Cost: O(1). Since 1.1.
    void set_viewport_origin(float x, float y) {
        check(gphys_camera_set_viewport_origin(handle(), x, y));
    }

    // Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
    // rays of other projections always begin there.
    // Cost: O(1). Since 1.1.
    void set_pick_start(gphys_pick_start start) {
        check(gphys_camera_set_pick_start(handle(), start));
    }

    // How the camera projects, as it was set.
    // Result: what of the following was called last: Camera::set_perspective, as at creation,
    // Camera::set_orthographic (or those with a width of their own), or Camera::set_projection. the
    // vertical field of view in radians of a perspective, the height in metres of an orthographic
    // projection, 0 of a matrix. the distance of the near plane, metres; 0 of a matrix. that of the far
    // plane; INFINITY without one; 0 of a matrix.
    // Cost: O(1).
    std::tuple<gphys_projection, float, float, float> get_projection() const {
        gphys_projection out_kind{};
        float out_size{};
        float out_near{};
        float out_far{};
        check(gphys_camera_get_projection(handle(), &out_kind, &out_size, &out_near, &out_far));
        return std::make_tuple(out_kind, out_size, out_near, out_far);
    }

    // The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
    // image.
    // Cost: O(1).
    std::tuple<float, float> get_viewport() const {
        float out_width{};
        float out_height{};
        check(gphys_camera_get_viewport(handle(), &out_width, &out_height));
        return std::make_tuple(out_width, out_height);
    }

    // Where the viewport is in its window, in pixels, as it was set.
    // Cost: O(1). Since 1.1.
    std::tuple<float, float> get_viewport_origin() const {
        float out_x{};
        float out_y{};
        check(gphys_camera_get_viewport_origin(handle(), &out_x, &out_y));
        return std::make_tuple(out_x, out_y);
    }

    // Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
    // viewport.
    // Result: 1 if Camera::set_perspective_aspect or Camera::set_orthographic_size was the last to set the
    // projection; 0 if it follows the viewport.
    // Cost: O(1). Since 1.1.
    std::tuple<float, int32_t> get_aspect() const {
        float out_aspect{};
        int32_t out_is_fixed{};
        check(gphys_camera_get_aspect(handle(), &out_aspect, &out_is_fixed));
        return std::make_tuple(out_aspect, out_is_fixed);
    }

    // Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
    // the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
    // distance by an orthographic projection, in metres as they were set; 0 by a matrix.
    // Cost: O(1). Since 1.1.
    std::tuple<float, float> get_image_size() const {
        float out_width{};
        float out_height{};
        check(gphys_camera_get_image_size(handle(), &out_width, &out_height));
        return std::make_tuple(out_width, out_height);
    }

    // Where the rays of a perspective begin, as it was set.
    // Cost: O(1). Since 1.1.
    gphys_pick_start get_pick_start() const {
        gphys_pick_start out_start{};
        check(gphys_camera_get_pick_start(handle(), &out_start));
        return out_start;
    }

    // What the camera was created with, as in CameraDesc.
    // Cost: O(1). Since 1.1.
    std::tuple<gphys_handedness, gphys_depth_range, int32_t> get_conventions() const {
        gphys_handedness out_handedness{};
        gphys_depth_range out_depth_range{};
        int32_t out_reverse_z{};
        check(gphys_camera_get_conventions(handle(), &out_handedness, &out_depth_range, &out_reverse_z));
        return std::make_tuple(out_handedness, out_depth_range, out_reverse_z);
    }

    // Place the camera.
    //   - position: metres, of its centre
    //   - rotation: from its own axes to those of the world
    // Cost: O(1).
    void set_transform(const Vec3& position, const Quat& rotation) {
        check(gphys_camera_set_transform(handle(), &position, &rotation));
    }

    // Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
    // kept, then up), so that a matrix which drifted is corrected.
    // Throws Error with GPHYS_ERROR_SINGULAR if the axes do not span space.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if they mirror or the last row is not 0 0 0 1.
    // Cost: O(1).
    void set_world_matrix(const Mat4& world) {
        check(gphys_camera_set_world_matrix(handle(), &world));
    }

    // Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
    // Camera::set_world_matrix. That of Camera::get_view_matrix puts a camera back within 2^-22 of its
    // distance from the origin and 2^-22 rad.
    // Throws Error with GPHYS_ERROR_SINGULAR if the axes do not span space.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if they mirror, the last row is not 0 0 0 1, or the
    // camera would be beyond GPHYS_MAX_COORDINATE.
    // Cost: O(1). Since 1.1.
    void set_view_matrix(const Mat4& view) {
        check(gphys_camera_set_view_matrix(handle(), &view));
    }

    // Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
    // chosen in its place, always the same for the same input.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if eye equals target or up is zero.
    // Cost: O(1).
    void look_at(const Vec3& eye, const Vec3& target, const Vec3& up) {
        check(gphys_camera_look_at(handle(), &eye, &target, &up));
    }

    // The camera's position, in metres, and its rotation, rounded to float32.
    // Cost: O(1).
    std::tuple<Vec3, Quat> get_transform() const {
        Vec3 out_position{};
        Quat out_rotation{};
        check(gphys_camera_get_transform(handle(), &out_position, &out_rotation));
        return std::make_tuple(out_position, out_rotation);
    }

    // The matrix from camera to world.
    // Cost: O(1).
    Mat4 get_world_matrix() const {
        Mat4 out_world{};
        check(gphys_camera_get_world_matrix(handle(), &out_world));
        return out_world;
    }

    // The matrix from world to camera: the transpose of the orthonormal world axes, and the position
    // transformed by it.
    // Cost: O(1).
    Mat4 get_view_matrix() const {
        Mat4 out_view{};
        check(gphys_camera_get_view_matrix(handle(), &out_view));
        return out_view;
    }

    // The matrix from camera to clip space.
    // Cost: O(1).
    Mat4 get_projection_matrix() const {
        Mat4 out_projection{};
        check(gphys_camera_get_projection_matrix(handle(), &out_projection));
        return out_projection;
    }

    // Projection * view, multiplied in double precision and rounded once.
    // Cost: O(1).
    Mat4 get_view_projection_matrix() const {
        Mat4 out_view_projection{};
        check(gphys_camera_get_view_projection_matrix(handle(), &out_view_projection));
        return out_view_projection;
    }

    // Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
    // distance outside its limits is brought inside.
    // Cost: O(1).
    void set_orbit(const Orbit& orbit) {
        check(gphys_camera_set_orbit(handle(), &orbit));
    }

    // The present settings, angles and distance of the orbit.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1).
    Orbit get_orbit() const {
        Orbit out_orbit{};
        check(gphys_camera_get_orbit(handle(), &out_orbit));
        return out_orbit;
    }

    // Set a speed for each input of the orbit, in place of the two of Orbit, which Camera::set_orbit
    // starts from. Input since the last update uses the new speeds.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1). Since 1.1.
    void set_orbit_speeds(const OrbitSpeeds& speeds) {
        check(gphys_camera_set_orbit_speeds(handle(), &speeds));
    }

    // The present speeds of the orbit's inputs.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1). Since 1.1.
    OrbitSpeeds get_orbit_speeds() const {
        OrbitSpeeds out_speeds{};
        check(gphys_camera_get_orbit_speeds(handle(), &out_speeds));
        return out_speeds;
    }

    // Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds that
    // were set.
    //   - units_x, units_y: finite, any size
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1).
    void orbit_rotate(float units_x, float units_y) {
        check(gphys_camera_orbit_rotate(handle(), units_x, units_y));
    }

    // Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
    // away if negative.
    //   - units: finite, any size
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1).
    void orbit_zoom(float units) {
        check(gphys_camera_orbit_zoom(handle(), units));
    }

    // Add input to the orbit: move the target to the camera's right and up, as the last update left them,
    // by units times metres_per_unit or the speeds that were set.
    //   - units_right, units_up: finite, any size
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1).
    void orbit_pan(float units_right, float units_up) {
        check(gphys_camera_orbit_pan(handle(), units_right, units_up));
    }

    // Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
    // to -pi .. pi in constant time.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit.
    // Cost: O(1).
    void orbit_update() {
        check(gphys_camera_orbit_update(handle()));
    }

    // The view frustum, with origin at the camera's position and planes from its parameters: each number
    // within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
    // Gribb-Hartmann in double precision.
    // Cost: O(1).
    Frustum get_frustum() const {
        Frustum out_frustum{};
        check(gphys_camera_get_frustum(handle(), &out_frustum));
        return out_frustum;
    }

    // World positions of the corners of the view frustum, in the order of gamephys::frustum_corners.
    // Result: std::nullopt with an infinite far plane, or a corner beyond the largest float.
    // Cost: O(1).
    std::optional<std::array<Vec3, 8>> get_corners() const {
        std::array<Vec3, 8> out_corners{};
        if (!found(gphys_camera_get_corners(handle(), out_corners.data()))) return std::nullopt;
        return out_corners;
    }

    // What is seen in a rectangle of pixels, as Camera::get_frustum: of a tile, a marquee, a portal.
    //   - x0, y0: pixels, a corner of the rectangle; may lie outside the viewport
    //   - x1, y1: pixels, the opposite corner, in any order; may lie outside the viewport
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area, or a side of what a
    // matrix shows in it lies at infinity or beyond GPHYS_MAX_COORDINATE.
    // Cost: O(1). Since 1.1.
    Frustum get_rectangle_frustum(float x0, float y0, float x1, float y1) const {
        Frustum out_frustum{};
        check(gphys_camera_get_rectangle_frustum(handle(), x0, y0, x1, y1, &out_frustum));
        return out_frustum;
    }

    // World positions of the corners of what is seen in a rectangle of pixels, as Camera::get_corners.
    //   - x0, y0, x1, y1: as Camera::get_rectangle_frustum
    // Result: std::nullopt as Camera::get_corners.
    // Cost: O(1). Since 1.1.
    std::optional<std::array<Vec3, 8>> get_rectangle_corners(float x0, float y0, float x1, float y1) const {
        std::array<Vec3, 8> out_corners{};
        if (!found(gphys_camera_get_rectangle_corners(handle(), x0, y0, x1, y1, out_corners.data()))) return std::nullopt;
        return out_corners;
    }

    // World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
    // viewport; z is the depth in the camera's range.
    // Result: std::nullopt if the point is not in front of the camera's centre (no image), or its image
    // lies beyond the range of coordinates.
    // Cost: O(1).
    std::optional<Vec3> project(const Vec3& point) const {
        Vec3 out_pixel{};
        if (!found(gphys_camera_project(handle(), &point, &out_pixel))) return std::nullopt;
        return out_pixel;
    }

    // Pixels of count world points, as Camera::project; a point without an image gets x = y = z =
    // INFINITY.
    //   - points: metres
    // Cost: O(elements).
    void project_batch(Span<const Vec3> points, Span<Vec3> out_pixels) const {
        const uint32_t count = common_size({points.sizes()});
        require_size(out_pixels.size, count);
        check(gphys_camera_project_batch(handle(), points.data, points.stride, count, out_pixels.data, out_pixels.stride));
    }

    // Pixel and depth to world point: the inverse of Camera::project.
    // Result: std::nullopt for the depth of an infinite far plane, and for points beyond that or beyond
    // the range of coordinates.
    // Cost: O(1).
    std::optional<Vec3> unproject(const Vec3& pixel) const {
        Vec3 out_point{};
        if (!found(gphys_camera_unproject(handle(), &pixel, &out_point))) return std::nullopt;
        return out_point;
    }

    // World points of the pixels with depth, as Camera::unproject; one at infinity gets x = y = z =
    // INFINITY.
    //   - pixels: x, y in pixels, z the depth
    // Cost: O(elements).
    void unproject_batch(Span<const Vec3> pixels, Span<Vec3> out_points) const {
        const uint32_t count = common_size({pixels.sizes()});
        require_size(out_points.size, count);
        check(gphys_camera_unproject_batch(handle(), pixels.data, pixels.stride, count, out_points.data, out_points.stride));
    }

    // The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
    // (INFINITY without one). With GPHYS_PICK_FROM_CENTRE that of a perspective starts at the camera's
    // position. Its image is within 1e-3 pixel of the given one or, for fields of view below about 3
    // degrees, within half an ulp of its direction. Its start is rounded to float32, too, which moves the
    // ray by half an ulp of the coordinates (but not from the camera's position, which has float
    // coordinates); Camera::pick is not limited in this way.
    //   - pixel_x, pixel_y: pixels; may lie outside the viewport
    // Result: std::nullopt if the line of sight does not meet the near plane (user projections), or would
    // begin beyond GPHYS_MAX_COORDINATE.
    // Cost: O(1).
    std::optional<Ray> pick_ray(float pixel_x, float pixel_y) const {
        Ray out_ray{};
        if (!found(gphys_camera_pick_ray(handle(), pixel_x, pixel_y, &out_ray))) return std::nullopt;
        return out_ray;
    }

    // Rays for a rectangle of pixel centres, as Camera::pick_ray, row by row.
    //   - x: the left column of the rectangle
    //   - y: its top row
    //   - width: its columns
    //   - height: its rows; width * height fewer than 2^32
    // Cost: O(width * height).
    void pick_rays(uint32_t x, uint32_t y, uint32_t width, uint32_t height, Span<Ray> out_rays) const {
        require_size(out_rays.size, width * height);
        check(gphys_camera_pick_rays(handle(), x, y, width, height, out_rays.data, out_rays.stride));
    }

    // The model under a pixel: the first hit of Camera::pick_ray, before that is rounded to float32; t is
    // in metres from where it starts.
    //   - pixel_x, pixel_y: pixels; may lie outside the viewport
    // Result: std::nullopt if nothing is found.
    // Cost: O(log n) expected.
    std::optional<Hit> pick(const Scene& scene, float pixel_x, float pixel_y, uint32_t layers = GPHYS_ALL_LAYERS) const {
        Hit out_hit{};
        if (!found(gphys_camera_pick(handle(), scene.handle(), pixel_x, pixel_y, layers, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // The models under the pixels, as Camera::pick; a pixel without one gets model = 0 and t = INFINITY.
    //   - pixels: x, y pairs of floats
    // Cost: at most that of as many single calls; shared among the scene's workers.
    void pick_batch(const Scene& scene, Span<const float> pixels, uint32_t layers, Span<Hit> out_hits) const {
        const uint32_t count = common_size({pixels.sizes()});
        require_size(out_hits.size, count);
        check(gphys_camera_pick_batch(handle(), scene.handle(), pixels.data, pixels.stride, count, layers, out_hits.data, out_hits.stride));
    }

    // Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
    // tested by their exact shapes, ascending.
    //   - x0, y0: pixels, a corner of the rectangle; may lie outside the viewport
    //   - x1, y1: pixels, the opposite corner, in any order; may lie outside the viewport
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area.
    // Cost: that of Scene::overlap.
    std::vector<gphys_model_id> pick_rectangle(const Scene& scene, float x0, float y0, float x1, float y1, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_camera_pick_rectangle(handle(), scene.handle(), x0, y0, x1, y1, layers, out_models, capacity, total); });
    }

    // Ids of the models to draw: Scene::cull with the camera's frustum.
    // Cost: O(log n + k) expected.
    std::vector<gphys_model_id> cull(const Scene& scene, uint32_t layers = GPHYS_ALL_LAYERS) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_camera_cull(handle(), scene.handle(), layers, out_models, capacity, total); });
    }

    // The model under a pixel that the filter sees, as Camera::pick: what lies behind a selection.
    //   - pixel_x, pixel_y: pixels; may lie outside the viewport
    //   - filter: nullptr: the defaults
    // Result: std::nullopt if nothing is found.
    // Cost: as Scene::raycast_filtered.
    std::optional<Hit> pick_filtered(const Scene& scene, float pixel_x, float pixel_y, const QueryFilterDesc* filter = nullptr) const {
        Hit out_hit{};
        if (!found(gphys_camera_pick_filtered(handle(), scene.handle(), pixel_x, pixel_y, filter, &out_hit))) return std::nullopt;
        return out_hit;
    }

    // The models under the pixels that the filters see, as Camera::pick_batch.
    //   - pixels: x, y pairs of floats
    //   - filters: nullptr: the defaults
    // Cost: at most that of as many single calls; shared among the scene's workers.
    void pick_filtered_batch(const Scene& scene, Span<const float> pixels, Span<const QueryFilterDesc> filters, Span<Hit> out_hits) const {
        const uint32_t count = common_size({pixels.sizes(), filters.sizes()});
        require_size(out_hits.size, count);
        check(gphys_camera_pick_filtered_batch(handle(), scene.handle(), pixels.data, pixels.stride, count, filters.data, filters.stride, out_hits.data, out_hits.stride));
    }

    // Marquee: ids of all models in the pixel rectangle that the filter sees, as Camera::pick_rectangle.
    //   - x0, y0: pixels, a corner of the rectangle
    //   - x1, y1: pixels, the opposite corner, in any order
    //   - filter: nullptr: the defaults
    // Cost: as Scene::overlap_filtered.
    std::vector<gphys_model_id> pick_rectangle_filtered(const Scene& scene, float x0, float y0, float x1, float y1, const QueryFilterDesc* filter = nullptr) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_camera_pick_rectangle_filtered(handle(), scene.handle(), x0, y0, x1, y1, filter, out_models, capacity, total); });
    }

    // Ids of the models to draw that the filter sees: Scene::cull_filtered with the camera's frustum.
    //   - filter: nullptr: the defaults
    // Cost: as Scene::cull_filtered.
    std::vector<gphys_model_id> cull_filtered(const Scene& scene, const QueryFilterDesc* filter = nullptr) const {
        return list<gphys_model_id>([&](gphys_model_id* out_models, uint32_t capacity, uint32_t* total) { return gphys_camera_cull_filtered(handle(), scene.handle(), filter, out_models, capacity, total); });
    }

};

class Solver : public Object<gphys_solver, gphys_solver_destroy> {
public:
    // Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step; the
    // results have the same bits for every n. Threads are started, joined and lost as those of Scene.
    //   - desc: nullptr: the defaults
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started.
    // Cost: O(1), and that of starting the threads.
    explicit Solver(const SolverDesc* desc = nullptr) {
        gphys_solver* made = nullptr;
        check(gphys_solver_create(desc, &made));
        own(made);
    }

    // Change the number of threads that share the steps of a solver, as Scene::set_worker_count. The bits
    // of the motion stay the same.
    //   - workers: as SolverDesc.worker_count
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY also if the threads cannot be started; the former ones
    // are kept.
    // Cost: as Scene::set_worker_count; allocates. Since 1.1.
    void set_worker_count(uint32_t workers) {
        check(gphys_solver_set_worker_count(handle(), workers));
    }

    // How many threads share the steps of a solver, as Scene::get_worker_count.
    // Cost: O(1). Since 1.1.
    uint32_t get_worker_count() const {
        uint32_t out_workers{};
        check(gphys_solver_get_worker_count(handle(), &out_workers));
        return out_workers;
    }

    // Move the point of the world that the coordinates of all particles count from; see Scene::set_origin.
    // Particles stay where they are in the world and keep moving as they do. A step and an attachment need
    // a scene of the same origin, else they fail with GPHYS_ERROR_INVALID_ARGUMENT.
    //   - origin: x, y, z in the world, metres, within GPHYS_MAX_COORDINATE
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if a particle or an animation target would leave
    // the range of coordinates.
    // Cost: O(particles).
    void set_origin(const std::array<double, 3>& origin) {
        check(gphys_solver_set_origin(handle(), origin.data()));
    }

    // Where in the world the particles' coordinates count from, metres.
    // Cost: O(1).
    std::array<double, 3> get_origin() const {
        std::array<double, 3> out_origin{};
        check(gphys_solver_get_origin(handle(), out_origin.data()));
        return out_origin;
    }

    // Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
    //   - gravity: m/s^2; may be zero
    // Cost: O(bodies).
    void set_gravity(const Vec3& gravity) {
        check(gphys_solver_set_gravity(handle(), &gravity));
    }

    // Change the number of substeps of a step. More substeps: smaller errors, proportionally more time.
    // The error of motion goes with the square of their length. Ropes that move calmly - in a substep no
    // link turns by half a radian, or would swing by one if its ends were pushed - make each in two stages
    // (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
    //   - substeps: 1 .. 1000
    // Cost: O(1).
    void set_substeps(uint32_t substeps) {
        check(gphys_solver_set_substeps(handle(), substeps));
    }

    // The settings of a solver as they are.
    // Cost: O(1).
    SolverSettings get_settings() const {
        SolverSettings out_settings{};
        check(gphys_solver_get_settings(handle(), &out_settings));
        return out_settings;
    }

    // Change all settings, from the next step on. Read them, change some, and give them back. Bodies wake
    // if gravity or the settings of sleep change. Time that Solver::advance owes beyond the new fixed_step
    // is dropped.
    // Cost: O(bodies).
    void set_settings(const SolverSettings& settings) {
        check(gphys_solver_set_settings(handle(), &settings));
    }

    // Add a body of particles without constraints.
    //   - desc: nullptr: the defaults
    //   - positions: metres
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies.
    // Cost: O(elements).
    gphys_body_id add_particles(Span<const Vec3> positions, const BodyDesc* desc = nullptr) {
        const uint32_t count = common_size({positions.sizes()});
        gphys_body_id out_body{};
        check(gphys_solver_add_particles(handle(), desc, positions.data, positions.stride, count, &out_body));
        return out_body;
    }

    // Add a rope through the given points, one particle at each.
    //   - desc: nullptr: the defaults
    //   - positions: metres
    //   - link_length: rest length of each link in metres; 0: as placed. A length below 1e-9 m counts as
    //     0. Rigid links get their lengths in the first step, and the particles no speed by it.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies.
    // Cost: O(elements).
    gphys_body_id add_rope(Span<const Vec3> positions, float link_length, const BodyDesc* desc = nullptr) {
        const uint32_t count = common_size({positions.sizes()});
        gphys_body_id out_body{};
        check(gphys_solver_add_rope(handle(), desc, positions.data, positions.stride, count, link_length, &out_body));
        return out_body;
    }

    // Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
    // corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the order
    // of their ids, are those from row to row, those from column to column, both diagonals
    // (GPHYS_CLOTH_SHEAR), and those that resist folding (GPHYS_CLOTH_BEND);
    // Solver::set_constraint_settings makes them softer or stiffer later.
    //   - desc: nullptr: the defaults
    //   - corner: metres
    //   - edge_u: metres, from the corner along a row
    //   - edge_v: metres, from the corner along a column
    //   - columns, rows: >= 2
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if the edges are parallel or zero.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles, links or bodies.
    // Cost: O(columns * rows).
    gphys_body_id add_cloth(const Vec3& corner, const Vec3& edge_u, const Vec3& edge_v, uint32_t columns, uint32_t rows, const BodyDesc* desc = nullptr) {
        gphys_body_id out_body{};
        check(gphys_solver_add_cloth(handle(), desc, &corner, &edge_u, &edge_v, columns, rows, &out_body));
        return out_body;
    }

    // Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and with
    // GPHYS_CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at
    // the same place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported balls,
    // has a rest length of 0.
    //   - desc: nullptr: the defaults
    //   - transform: places the mesh; nullptr is the identity
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or bodies.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED for a mesh made from a rope or from particles, which has
    // no triangles.
    // Cost: O(n log n).
    gphys_body_id add_cloth_mesh(const Mesh& mesh, const Transform* transform = nullptr, const BodyDesc* desc = nullptr) {
        gphys_body_id out_body{};
        check(gphys_solver_add_cloth_mesh(handle(), desc, mesh.handle(), transform, &out_body));
        return out_body;
    }

    // Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave in
    // the last step are no longer listed.
    // Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
    // impulses to the same models).
    void remove_body(gphys_body_id body) {
        check(gphys_solver_remove_body(handle(), body));
    }

    // Ids of all bodies, ascending.
    // Cost: O(bodies).
    std::vector<gphys_body_id> get_bodies() const {
        return list<gphys_body_id>([&](gphys_body_id* out_bodies, uint32_t capacity, uint32_t* total) { return gphys_solver_get_bodies(handle(), out_bodies, capacity, total); });
    }

    // Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
    // sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by more
    // than sleep_strain; cloth, when its root mean square speed from step to step was no higher, no
    // particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals of
    // cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0, it
    // keeps its contacts, and a step costs it one query for models nearby. It wakes in the next step after
    // a model within reach (as far as one could move in a step at 50 m/s) was added, removed or moved, or
    // a model that it is attached to, or after the scene was replaced; and at once by any change of its
    // state, of gravity or of the origin. Cloth is brought to rest, whatever sleep_speed is, once friction
    // holds it on models that stand still and it moves by centimetres a second without sagging further:
    // within a second it is slowed down to 0. It moves again when one of these models or the body changes.
    // Not in wind, with joints, animation targets, clusters or a volume, or near other bodies.
    // Cost: O(bodies).
    std::vector<gphys_body_id> get_sleeping() const {
        return list<gphys_body_id>([&](gphys_body_id* out_bodies, uint32_t capacity, uint32_t* total) { return gphys_solver_get_sleeping(handle(), out_bodies, capacity, total); });
    }

    // Wake a body; its time of rest begins again.
    //   - body: 0: all
    // Cost: O(1) a body.
    void wake(gphys_body_id body) {
        check(gphys_solver_wake(handle(), body));
    }

    // The present settings of a body; static_friction as it acts, at least friction.
    // Cost: O(1).
    BodySettings get_body_settings(gphys_body_id body) const {
        BodySettings out_settings{};
        check(gphys_solver_get_body_settings(handle(), body, &out_settings));
        return out_settings;
    }

    // Change all settings of a body, from the next step on: read them, change some, and give them back.
    // Wakes the body.
    // Cost: O(1); O(particles) when self_collision changes, and it allocates.
    void set_body_settings(gphys_body_id body, const BodySettings& settings) {
        check(gphys_solver_set_body_settings(handle(), body, &settings));
    }

    // What a body is made of and how it is solved.
    // Cost: O(1); after a change of constraints O(particles), and it allocates.
    BodyInfo get_body_info(gphys_body_id body) const {
        BodyInfo out_info{};
        check(gphys_solver_get_body_info(handle(), body, &out_info));
        return out_info;
    }

    // Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
    // change, and their number does not.
    // Cost: O(triangles).
    std::vector<uint32_t> get_triangles(gphys_body_id body) const {
        return list<uint32_t>([&](uint32_t* out_indices, uint32_t capacity, uint32_t* total) { return gphys_solver_get_triangles(handle(), body, out_indices, capacity, total); });
    }

    // The particle of a body nearest to a point, for example to grab it; of equally near ones the lowest.
    //   - triangle: as in a hit, nearest or penetration of the body's mesh: its corners are compared, of a
    //     rope the ends of the link, or the particle; GPHYS_NO_TRIANGLE: all particles
    //   - point: metres, in the solver's coordinates: that of the hit
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT also if the mesh has no such triangle.
    // Cost: O(1); O(particles) for GPHYS_NO_TRIANGLE. Since 1.1.
    uint32_t get_nearest_particle(gphys_body_id body, uint32_t triangle, const Vec3& point) const {
        uint32_t out_particle{};
        check(gphys_solver_get_nearest_particle(handle(), body, triangle, &point, &out_particle));
        return out_particle;
    }

    // Where the particles are, metres.
    //   - first: the first particle
    //   - count: how many from there on; a range beyond the body is GPHYS_ERROR_INVALID_ARGUMENT
    // Cost: O(count).
    void get_positions(gphys_body_id body, uint32_t first, uint32_t count, Span<Vec3> out_positions) const {
        require_size(out_positions.size, count);
        check(gphys_solver_get_positions(handle(), body, first, count, out_positions.data, out_positions.stride));
    }

    // Move particles at once and without collision on the way; velocities stay as they are. Wakes the
    // body. Rigid links that are too long or too short then get their lengths in the next step, and the
    // particles no speed by it. Pinned particles that are moved alone pull the others: during the next
    // step they go evenly from where they were to their new places, as attached ones do. They are placed
    // at once before the body's first step, or if a free particle of the body is placed as well.
    //   - first: as in Solver::get_positions
    // Cost: O(elements).
    void set_positions(gphys_body_id body, uint32_t first, Span<const Vec3> positions) {
        const uint32_t count = common_size({positions.sizes()});
        check(gphys_solver_set_positions(handle(), body, first, count, positions.data, positions.stride));
    }

    // How fast the particles are, m/s.
    //   - first, count: as in Solver::get_positions
    // Result: 0 of what is pinned and stands still.
    // Cost: O(count).
    void get_velocities(gphys_body_id body, uint32_t first, uint32_t count, Span<Vec3> out_velocities) const {
        require_size(out_velocities.size, count);
        check(gphys_solver_get_velocities(handle(), body, first, count, out_velocities.data, out_velocities.stride));
    }

    // Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles keep 0.
    //   - first: as in Solver::get_positions
    //   - velocities: m/s
    // Cost: O(elements).
    void set_velocities(gphys_body_id body, uint32_t first, Span<const Vec3> velocities) {
        const uint32_t count = common_size({velocities.sizes()});
        check(gphys_solver_set_velocities(handle(), body, first, count, velocities.data, velocities.stride));
    }

    // Masses of particles, kg. That of a pinned particle is what it has when it is released.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count).
    void get_masses(gphys_body_id body, uint32_t first, uint32_t count, Span<float> out_masses) const {
        require_size(out_masses.size, count);
        check(gphys_solver_get_masses(handle(), body, first, count, out_masses.data, out_masses.stride));
    }

    // Change the masses of particles. A pinned particle keeps its mass for the time when it is released.
    // Wakes the body.
    //   - first: as in Solver::get_positions
    //   - masses: kg, > 0
    // Cost: O(elements).
    void set_masses(gphys_body_id body, uint32_t first, Span<const float> masses) {
        const uint32_t count = common_size({masses.sizes()});
        check(gphys_solver_set_masses(handle(), body, first, count, masses.data, masses.stride));
    }

    // Collision radii of particles, metres.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count).
    void get_radii(gphys_body_id body, uint32_t first, uint32_t count, Span<float> out_radii) const {
        require_size(out_radii.size, count);
        check(gphys_solver_get_radii(handle(), body, first, count, out_radii.data, out_radii.stride));
    }

    // Change the collision radii of particles. Wakes the body.
    //   - first: as in Solver::get_positions
    //   - radii: metres, >= 0
    // Cost: O(elements).
    void set_radii(gphys_body_id body, uint32_t first, Span<const float> radii) {
        const uint32_t count = common_size({radii.sizes()});
        check(gphys_solver_set_radii(handle(), body, first, count, radii.data, radii.stride));
    }

    // Friction factors of particles; 1 until they are set.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count). Since 1.1.
    void get_friction_factors(gphys_body_id body, uint32_t first, uint32_t count, Span<float> out_factors) const {
        require_size(out_factors.size, count);
        check(gphys_solver_get_friction_factors(handle(), body, first, count, out_factors.data, out_factors.stride));
    }

    // Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In every
    // contact, with models and with particles, the coefficients of a particle are the friction and the
    // static_friction of its body times its factor. A body with a friction of 1 thus has the factors for
    // coefficients; Solver::set_body_settings scales them all and keeps the factors. Wakes the body.
    //   - first: as in Solver::get_positions
    //   - factors: >= 0
    // Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.
    void set_friction_factors(gphys_body_id body, uint32_t first, Span<const float> factors) {
        const uint32_t count = common_size({factors.sizes()});
        check(gphys_solver_set_friction_factors(handle(), body, first, count, factors.data, factors.stride));
    }

    // The forces that were set for particles, newtons.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count).
    void get_forces(gphys_body_id body, uint32_t first, uint32_t count, Span<Vec3> out_forces) const {
        require_size(out_forces.size, count);
        check(gphys_solver_get_forces(handle(), body, first, count, out_forces.data, out_forces.stride));
    }

    // Set the forces that act on particles beside gravity, from now on until set again. Wakes the body.
    //   - first: as in Solver::get_positions
    //   - forces: newtons
    // Cost: O(elements).
    void set_forces(gphys_body_id body, uint32_t first, Span<const Vec3> forces) {
        const uint32_t count = common_size({forces.sizes()});
        check(gphys_solver_set_forces(handle(), body, first, count, forces.data, forces.stride));
    }

    // Which particles are pinned or attached.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count).
    void get_pinned(gphys_body_id body, uint32_t first, uint32_t count, Span<int32_t> out_pinned) const {
        require_size(out_pinned.size, count);
        check(gphys_solver_get_pinned(handle(), body, first, count, out_pinned.data, out_pinned.stride));
    }

    // Pin or release particles. A pinned particle stays where it is put and moves only by
    // Solver::set_positions, or with an animation target of max_distance 0; else its speed is 0. Both
    // pinning and releasing end an attachment.
    //   - first, count: as in Solver::get_positions
    //   - pinned: 1: pin; 0: release
    // Cost: O(count).
    void set_pinned(gphys_body_id body, uint32_t first, uint32_t count, int32_t pinned) {
        check(gphys_solver_set_pinned(handle(), body, first, count, pinned));
    }

    // Put a body into moving air. Until this is called there is none. Wakes the body. With u the velocity
    // relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L cos^2 a) u +
    // C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a, which is what
    // the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al. 2004, "Modelling
    // effects of wind fields in cloth animations"); with C_L = C_D it is nearly the pressure on a plate,
    // along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u across it, r the radius (the
    // cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a free particle -rho/2 C_D pi r^2 |u|
    // u. Strong wind carries bodies along but never overshoots: whatever the density, a substep does not
    // reverse u. The drag of a free particle is of second order in the substep; that of a link is the one
    // at the beginning of the step.
    //   - body: 0: all bodies there are
    //   - wind: of density 0: no air
    // Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a rope
    // as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a speed.
    void set_wind(gphys_body_id body, const Wind& wind) {
        check(gphys_solver_set_wind(handle(), body, &wind));
    }

    // The air around a body as it was set; zeros if it was not.
    // Cost: O(1).
    Wind get_wind(gphys_body_id body) const {
        Wind out_wind{};
        check(gphys_solver_get_wind(handle(), body, &out_wind));
        return out_wind;
    }

    // Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
    // eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
    //   - first: as in Solver::get_positions
    //   - velocities: m/s
    // Cost: O(elements); the first time O(particles), and it allocates.
    void set_air_velocities(gphys_body_id body, uint32_t first, Span<const Vec3> velocities) {
        const uint32_t count = common_size({velocities.sizes()});
        check(gphys_solver_set_air_velocities(handle(), body, first, count, velocities.data, velocities.stride));
    }

    // Velocities of the air at particles, m/s, beside that of Wind.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count).
    void get_air_velocities(gphys_body_id body, uint32_t first, uint32_t count, Span<Vec3> out_velocities) const {
        require_size(out_velocities.size, count);
        check(gphys_solver_get_air_velocities(handle(), body, first, count, out_velocities.data, out_velocities.stride));
    }

    // Give particles animation targets, before each step that is to follow an animation: a cape or skirt
    // that is skinned to its character stays within max_distance of the skinned vertices and does not sink
    // into the body behind them. In the next step position and normal go evenly from the old target to the
    // new one, substep by substep; distances act at once. A target that is not set again stands still. A
    // first target, and that of a particle which Solver::set_positions has moved since the last step,
    // takes effect at its new place at once: to teleport, make that call and this one. If the body is
    // attached to a model that jumps (Solver::step), this call alone is enough. max_distance 0 carries a
    // particle: it is at its target, as if attached there, and moves links with infinite mass; this also
    // moves a pinned particle, which stays pinned, at constant speed during a step. Otherwise particles
    // that are pinned or attached are not moved. A particle that is out of its bounds at the end of a
    // substep is put on the nearest place within both, without friction; its velocity across them is then
    // that of the target. What lies within its bounds is not touched. Bounds act after constraints and
    // before models: where a target is inside a model, or behind one, the particle stays outside. Links
    // yield to bounds that contradict them. What hangs from a particle at its bounds is carried, in cloth
    // and in ropes that are moved alone; ropes and free particles that are joined, or collide with bodies,
    // are put back particle by particle, and links beside these may be strained by the motion of a
    // substep. Wakes the body if a target changes.
    //   - first: as in Solver::get_positions
    //   - targets: max_distance and backstop INFINITY: no target any more
    // Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
    // particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.
    void set_animation_targets(gphys_body_id body, uint32_t first, Span<const AnimationTarget> targets) {
        const uint32_t count = common_size({targets.sizes()});
        check(gphys_solver_set_animation_targets(handle(), body, first, count, targets.data, targets.stride));
    }

    // Animation targets of particles as they were set; 0 and INFINITY of what has none.
    //   - first, count: as in Solver::get_positions
    // Cost: O(count). Since 1.1.
    void get_animation_targets(gphys_body_id body, uint32_t first, uint32_t count, Span<AnimationTarget> out_targets) const {
        require_size(out_targets.size, count);
        check(gphys_solver_get_animation_targets(handle(), body, first, count, out_targets.data, out_targets.stride));
    }

    // Fix a particle to a model: it follows the model's transform in each step, and is released when the
    // model is gone. Steps must then be given this scene; in a step without one the particle stays where
    // it is. If the model jumps (Solver::step), the whole body goes with it as if it were rigid, and its
    // velocities turn with it: a cape stays on a character that respawns. Bodies with other pinned
    // particles, joints, or attachments to models that go elsewhere do not, nor do bodies without
    // constraints.
    //   - scene: of the same origin as the solver; not modified
    //   - local_point: in the model's coordinates, to which its transform applies, with the transform's
    //     scale, and not Scene::set_scale; nullptr: where the particle is now
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist.
    // Cost: O(1); allocates.
    void attach(const Scene& scene, gphys_body_id body, uint32_t particle, gphys_model_id model, const Vec3* local_point = nullptr) {
        check(gphys_solver_attach(handle(), scene.handle(), body, particle, model, local_point));
    }

    // Release an attached particle.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT if it is not attached, or does not exist.
    // Cost: O(1).
    void detach(gphys_body_id body, uint32_t particle) {
        check(gphys_solver_detach(handle(), body, particle));
    }

    // The attachments of a body, by particle. One to a model that is gone is listed until the next step.
    // Cost: O(attachments). Since 1.1.
    std::vector<Attachment> get_attachments(gphys_body_id body) const {
        return list<Attachment>([&](Attachment* out_attachments, uint32_t capacity, uint32_t* total) { return gphys_solver_get_attachments(handle(), body, out_attachments, capacity, total); });
    }

    // Hold two different particles of a body at a distance.
    //   - rest_length: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    //   - compliance: metres per newton, >= 0; 0 is rigid
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same
    // one.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 constraints of a body.
    // Cost: O(1); the next step plans the body again, O(constraints).
    gphys_constraint_id add_distance(gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float rest_length, float compliance) {
        gphys_constraint_id out_constraint{};
        check(gphys_solver_add_distance(handle(), body, particle_a, particle_b, rest_length, compliance, &out_constraint));
        return out_constraint;
    }

    // Keep two different particles of a body from being further apart than a length, like a string between
    // them: it pulls and never pushes. While it is slack it does nothing; when it becomes taut, and is
    // rigid, only the speed at which the particles separate is lost.
    // Fails as Solver::add_distance.
    // It is a constraint like others: listed with max_length as its rest_length, removed as they are, and
    // strained only when it is too long.
    //   - max_length: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
    //   - compliance: metres per newton, >= 0, of what it yields beyond that; 0 is rigid
    // Cost: as Solver::add_distance.
    gphys_constraint_id add_max_distance(gphys_body_id body, uint32_t particle_a, uint32_t particle_b, float max_length, float compliance) {
        gphys_constraint_id out_constraint{};
        check(gphys_solver_add_max_distance(handle(), body, particle_a, particle_b, max_length, compliance, &out_constraint));
        return out_constraint;
    }

    // Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping * v
    // in addition to its tension; one of Solver::add_max_distance never pushes. The decay depends on time,
    // not on steps. Rigid constraints have nothing to damp.
    //   - damping: N s/m, >= 0; 0, which every constraint begins with: none
    // Throws Error with GPHYS_ERROR_INVALID_ID for a body or constraint that does not exist.
    // Cost: as Solver::add_distance.
    void set_constraint_damping(gphys_body_id body, gphys_constraint_id constraint, float damping) {
        check(gphys_solver_set_constraint_damping(handle(), body, constraint, damping));
    }

    // Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
    // setting it again changes it, which inflates a body.
    //   - rest_volume: m^3, > 0; negative: the present volume
    //   - compliance: m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as water,
    //     which keeps its volume; INFINITY: none, which ends the constraint
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if the triangles do not close (each side is that of two
    // triangles), are not oriented consistently, or face inward when the present volume is asked for.
    // Cost: O(triangles) in each substep, twice. Allocates.
    void set_volume(gphys_body_id body, float rest_volume, float compliance) {
        check(gphys_solver_set_volume(handle(), body, rest_volume, compliance));
    }

    // The volume held by Solver::set_volume, m^3, as it is, and the pressure in pascals with which it was
    // held at the end of the last step: above 0 it pushes outward.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if none is held.
    // Cost: O(triangles).
    std::tuple<float, float> get_volume(gphys_body_id body) const {
        float out_volume{};
        float out_pressure{};
        check(gphys_solver_get_volume(handle(), body, &out_volume, &out_pressure));
        return std::make_tuple(out_volume, out_pressure);
    }

    // What was given to Solver::set_volume: m^3 (for a negative volume the one at that time), and m^3 per
    // pascal.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED if none is held.
    // Cost: O(1). Since 1.1.
    std::tuple<float, float> get_volume_settings(gphys_body_id body) const {
        float out_rest_volume{};
        float out_compliance{};
        check(gphys_solver_get_volume_settings(handle(), body, &out_rest_volume, &out_compliance));
        return std::make_tuple(out_rest_volume, out_compliance);
    }

    // Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body. The
    // triangles of cloth stay together: Solver::break_constraint tears them apart.
    // Throws Error with GPHYS_ERROR_INVALID_ID for a body or constraint that does not exist, or no longer.
    // Cost: as Solver::add_distance; allocates.
    void remove_constraint(gphys_body_id body, gphys_constraint_id constraint) {
        check(gphys_solver_remove_constraint(handle(), body, constraint));
    }

    // All constraints of a body, including those created with the body, by id.
    // Cost: O(constraints).
    std::vector<ConstraintInfo> get_constraints(gphys_body_id body) const {
        return list<ConstraintInfo>([&](ConstraintInfo* out_constraints, uint32_t capacity, uint32_t* total) { return gphys_solver_get_constraints(handle(), body, out_constraints, capacity, total); });
    }

    // Which constraints keep a length, and which a maximum.
    //   - constraints: the ids; one may appear twice
    // Cost: O(elements). Since 1.1.
    void get_constraint_kinds(gphys_body_id body, Span<const gphys_constraint_id> constraints, Span<gphys_constraint_kind> out_kinds) const {
        const uint32_t count = common_size({constraints.sizes()});
        require_size(out_kinds.size, count);
        check(gphys_solver_get_constraint_kinds(handle(), body, constraints.contiguous("constraints"), count, out_kinds.data, out_kinds.stride));
    }

    // The present settings of constraints.
    //   - constraints: the ids; one may appear twice
    // Cost: O(elements).
    void get_constraint_settings(gphys_body_id body, Span<const gphys_constraint_id> constraints, Span<ConstraintSettings> out_settings) const {
        const uint32_t count = common_size({constraints.sizes()});
        require_size(out_settings.size, count);
        check(gphys_solver_get_constraint_settings(handle(), body, constraints.contiguous("constraints"), count, out_settings.data, out_settings.stride));
    }

    // Change constraints while they act, all or none: winches, muscles. A rest length goes from the old to
    // the new one at constant speed during the next step; a winch that reels in at v m/s is given a length
    // that is v dt shorter before each step of dt. Wakes the body.
    //   - constraints: the ids; one that appears twice gets the last
    // Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins that
    // gets longer links O(n log n). Chains are not planned again. Allocates.
    void set_constraint_settings(gphys_body_id body, Span<const gphys_constraint_id> constraints, Span<const ConstraintSettings> settings) {
        const uint32_t count = common_size({constraints.sizes(), settings.sizes()});
        check(gphys_solver_set_constraint_settings(handle(), body, constraints.contiguous("constraints"), settings.data, settings.stride, count));
    }

    // Make particles of a body a rigid cluster: they keep the shape in which they are now, and move and
    // turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links between
    // them are not needed. A particle may be in several clusters: planks with two particles in common are
    // hinged there, with one they are jointed. The mass of a cluster is that of its particles; hollow
    // shapes are light in the middle. Particles that are pinned or attached stay where they are held: with
    // one the cluster swings about it, with two about the line through them, and with three that are not
    // on a line it does not move. Models that particles are attached to get the impulses. Contacts with
    // models move the cluster as a whole, with friction; only particles touch, not the faces between them,
    // so they should be no further apart than the thickness of the thinnest thing that a cluster meets. It
    // bounces as a whole, too; one that is held, joined, or shares particles shows only the share of its
    // restitution that its particles in contact have of its mass. A shape is matched once in each substep,
    // after the links: then what hangs from it by links may be strained a little, and clusters that share
    // particles approach their shapes in eight passes. What is joined to it by Solver::join is solved
    // together with it, unless one of its particles is attached, or another cluster has it, too: hang
    // heavy loads, or a light cluster under a heavy load, by joints. Bodies with clusters are solved as
    // cloth (GPHYS_SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed
    // by a cluster.
    //   - particles: count different particles, at least 2
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or appears twice.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 clusters of a body, or that many particles in
    // them.
    // Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and 0.3
    // us one that touches a model, and up to eight times that if clusters of the body share particles; the
    // first and the last cluster plan the body again, O(constraints). Since 1.1.
    gphys_cluster_id add_cluster(gphys_body_id body, Span<const uint32_t> particles) {
        const uint32_t count = common_size({particles.sizes()});
        gphys_cluster_id out_cluster{};
        check(gphys_solver_add_cluster(handle(), body, particles.contiguous("particles"), count, &out_cluster));
        return out_cluster;
    }

    // End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
    // Throws Error with GPHYS_ERROR_INVALID_ID for a body or cluster that does not exist, or no longer.
    // Cost: O(particles in clusters of the body). Since 1.1.
    void remove_cluster(gphys_body_id body, gphys_cluster_id cluster) {
        check(gphys_solver_remove_cluster(handle(), body, cluster));
    }

    // All clusters of a body, by id.
    // Cost: O(clusters). Since 1.1.
    std::vector<gphys_cluster_id> get_clusters(gphys_body_id body) const {
        return list<gphys_cluster_id>([&](gphys_cluster_id* out_clusters, uint32_t capacity, uint32_t* total) { return gphys_solver_get_clusters(handle(), body, out_clusters, capacity, total); });
    }

    // The particles of a cluster, in the order in which they were given.
    // Throws Error with GPHYS_ERROR_INVALID_ID for a body or cluster that does not exist, or no longer.
    // Cost: O(particles of the cluster). Since 1.1.
    std::vector<uint32_t> get_cluster_particles(gphys_body_id body, gphys_cluster_id cluster) const {
        return list<uint32_t>([&](uint32_t* out_particles, uint32_t capacity, uint32_t* total) { return gphys_solver_get_cluster_particles(handle(), body, cluster, out_particles, capacity, total); });
    }

    // Hold a particle of one body and a particle of another at a distance. Both are moved, by forces that
    // are equal and opposite; either may be pinned or attached. Joined ropes, free particles and rigid
    // clusters are solved as one system, as stiff as one rope; a joined particle of cloth has the inertia
    // of all that hangs on it. Free particles of a joined body are moved by the time scheme of ropes, no
    // longer exactly. Joined bodies are moved by one thread and fall asleep and wake together. A joint is
    // removed with either body. Particles of the two that are linked to a joint within touch of each other
    // do not collide there.
    //   - rest_length: metres; 0: at the same place, as below 1e-9; negative: the present distance.
    //     Particles at another distance are moved to it in the next step; by a rigid joint without speed.
    //   - compliance: metres per newton, >= 0; 0 is rigid
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for a particle that does not exist or twice the same
    // body (see Solver::add_distance).
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 joints.
    // Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as one
    // of a rope that is not joined. Allocates.
    gphys_joint_id join(gphys_body_id body_a, uint32_t particle_a, gphys_body_id body_b, uint32_t particle_b, float rest_length, float compliance) {
        gphys_joint_id out_joint{};
        check(gphys_solver_join(handle(), body_a, particle_a, body_b, particle_b, rest_length, compliance, &out_joint));
        return out_joint;
    }

    // End a joint. Wakes both bodies.
    // Throws Error with GPHYS_ERROR_INVALID_ID for a joint that does not exist, or no longer.
    // Cost: as Solver::join.
    void unjoin(gphys_joint_id joint) {
        check(gphys_solver_unjoin(handle(), joint));
    }

    // Joints of a body, by id.
    //   - body: 0: of all bodies
    // Cost: O(joints of the solver).
    std::vector<JointInfo> get_joints(gphys_body_id body) const {
        return list<JointInfo>([&](JointInfo* out_joints, uint32_t capacity, uint32_t* total) { return gphys_solver_get_joints(handle(), body, out_joints, capacity, total); });
    }

    // Breaking forces of constraints. Wakes the body.
    //   - constraints: the ids; one that appears twice gets the last
    //   - forces: newtons, >= 0; 0: never breaks, as all that are added to a body later
    // Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of a
    // pin. Allocates. Since 1.1.
    void set_breaking_forces(gphys_body_id body, Span<const gphys_constraint_id> constraints, Span<const float> forces) {
        const uint32_t count = common_size({constraints.sizes(), forces.sizes()});
        check(gphys_solver_set_breaking_forces(handle(), body, constraints.contiguous("constraints"), forces.data, forces.stride, count));
    }

    // What Solver::set_breaking_forces or BodyDesc.breaking_force has set; 0: never breaks.
    //   - constraints: the ids; one may appear twice
    // Result: newtons.
    // Cost: O(elements). Since 1.1.
    void get_breaking_forces(gphys_body_id body, Span<const gphys_constraint_id> constraints, Span<float> out_forces) const {
        const uint32_t count = common_size({constraints.sizes()});
        require_size(out_forces.size, count);
        check(gphys_solver_get_breaking_forces(handle(), body, constraints.contiguous("constraints"), count, out_forces.data, out_forces.stride));
    }

    // Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the body.
    // Result: what came of it.
    // Throws Error with GPHYS_ERROR_UNSUPPORTED and nothing has changed, for an edge where the cloth
    // cannot part: of a triangle that is connected to no other.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^24 - 1 particles or constraints.
    // Cost: O(particles + constraints); allocates. Since 1.1.
    Break break_constraint(gphys_body_id body, gphys_constraint_id constraint) {
        Break out_result{};
        check(gphys_solver_break_constraint(handle(), body, constraint, &out_result));
        return out_result;
    }

    // Constraints that broke in the last Solver::step or Solver::advance, in its order: for sounds, dust,
    // and to know that a body has more particles. Not those that the caller broke. They are not part of
    // snapshots: after Solver::restore there are none.
    // Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1.
    std::vector<Break> get_breaks() const {
        return list<Break>([&](Break* out_breaks, uint32_t capacity, uint32_t* total) { return gphys_solver_get_breaks(handle(), out_breaks, capacity, total); });
    }

    // Simulate dt seconds in the set number of substeps, or as many as the error targets ask for; cloth
    // takes more where they would be longer than 25 ms.
    // Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
    // through particles. A model moves evenly from its place at the last step to its present one, unless
    // it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to more than
    // that, or its surface does by a change of scale. One that jumps is not swept and gives no speed. What
    // is then within a solid is pushed out slowly; what is then behind a plane or a mesh stays there.
    // Allocates when what it steps has changed.
    //   - scene: to collide with and to follow attachments; nullptr: none. Not modified.
    //   - dt: seconds, 1e-6 .. 0.5
    // Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1) and a
    // scene query for a body that the last step, of the same dt, left exactly as it was.
    void step(const Scene* scene, float dt) {
        check(gphys_solver_step(handle(), optional_handle(scene), dt));
    }

    // Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next frame,
    // so the motion does not depend on the frame rate. Models, pins and animation targets are given the
    // places of the end of the frame. They move there evenly in the time since the last step: attached
    // particles, pins and what lies on models are at their places of the time that the solver has reached,
    // leftover of a step before that of the frame. Impulses, contacts and breaks are those of the last
    // step.
    //   - frame_time: seconds, >= 0
    // Result: steps made. 0 <= fraction of a step still owed < 1, to interpolate when drawing.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY if there is none for the first step: nothing has
    // changed. If there is none for a later one.
    // Cost: that of the steps made.
    std::tuple<uint32_t, float> advance(const Scene* scene, float frame_time) {
        uint32_t out_steps{};
        float out_leftover{};
        check(gphys_solver_advance(handle(), optional_handle(scene), frame_time, &out_steps, &out_leftover));
        return std::make_tuple(out_steps, out_leftover);
    }

    // The fraction of a step that Solver::advance still owes: what it gave last as leftover, unless the
    // solver was restored or given another fixed_step since.
    // Result: from 0 to below 1.
    // Cost: O(1). Since 1.1.
    float get_leftover() const {
        float out_leftover{};
        check(gphys_solver_get_leftover(handle(), &out_leftover));
        return out_leftover;
    }

    // The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain or
    // tolerance set, each body takes as many as its own motion needs: their length follows from what the
    // last step measured, the largest strain of its rigid constraints and the local error of the time
    // scheme, both proportional to the square of that length. It is at most quartered and grows by at most
    // an eighth from one step to the next, so a sudden impact exceeds a target for a few steps; one of
    // strain only where links of cloth cannot be relaxed below it. A target that cannot be met takes
    // max_substeps, unless the strain of cloth stays above eight times the target. Where positions jump,
    // by contacts, the error is that of the jump. What may meet others takes at least the set number.
    // Cost: O(1).
    uint32_t get_substeps(gphys_body_id body) const {
        uint32_t out_substeps{};
        check(gphys_solver_get_substeps(handle(), body, &out_substeps));
        return out_substeps;
    }

    // Counts, strain and energy of a body at present.
    //   - body: 0: all bodies together
    // Cost: O(particles + constraints).
    SolverStats get_stats(gphys_body_id body) const {
        SolverStats out_stats{};
        check(gphys_solver_get_stats(handle(), body, &out_stats));
        return out_stats;
    }

    // Contacts of the last step by body, particle, model.
    // Cost: O(contacts).
    std::vector<Contact> get_contacts() const {
        return list<Contact>([&](Contact* out_contacts, uint32_t capacity, uint32_t* total) { return gphys_solver_get_contacts(handle(), out_contacts, capacity, total); });
    }

    // Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b, particle_b:
    // for sounds, damage and sparks. Of sleeping bodies those of the step in which they fell asleep.
    // Contacts with a body that was removed are no longer listed. They are not part of snapshots: after
    // Solver::restore there are none until the next step. Contacts within a body (BodyDesc.self_collision)
    // are not listed. where particles have more than 12 contacts on average, not all are known.
    // Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1.
    std::vector<BodyContact> get_body_contacts() const {
        return list<BodyContact>([&](BodyContact* out_contacts, uint32_t capacity, uint32_t* total) { return gphys_solver_get_body_contacts(handle(), out_contacts, capacity, total); });
    }

    // Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the step in
    // which they fell asleep. After Solver::advance, times the steps that it made, they are those of the
    // frame. Divided by dt they are mean forces: what lies on a model presses on it with its weight. A
    // particle of cloth that touches several models at once gives its impulse to the one that it touches
    // most. Models have no mass here: the step does as if they went where you put them, whatever the
    // force. So a rope between a held end and a body of yours must be elastic, its stiffness times dt^2
    // well below the mass of the body, which needs some damping; a body of yours much lighter than what
    // hangs from it should be moved in small steps.
    // Cost: O(models touched); no allocation. The same bits for any number of workers.
    std::vector<Impulse> get_impulses() const {
        return list<Impulse>([&](Impulse* out_impulses, uint32_t capacity, uint32_t* total) { return gphys_solver_get_impulses(handle(), out_impulses, capacity, total); });
    }

    // Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
    // impulses, time that Solver::advance still owes. The scene, workers and allocator are not in it.
    // Result: the snapshot. It is for the same release of the library and machines of the same byte order;
    // it may be stored, but not changed.
    // Throws Error with GPHYS_ERROR_CAPACITY beyond 2^32 - 1 words.
    // Cost: O(particles + constraints), some 50 words for each.
    std::vector<uint32_t> get_snapshot() const {
        return list<uint32_t>([&](uint32_t* out_words, uint32_t capacity, uint32_t* total) { return gphys_solver_get_snapshot(handle(), out_words, capacity, total); });
    }

    // Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of the
    // time of the snapshot. Steps continue with the same bits as they did then, provided that the scene,
    // too, is as it was. On an error the solver is as before. Any words are safe, also from an untrusted
    // source: all that is used as a number or an index is checked first. Forged words are refused, or
    // taken as a state whose numbers are in range.
    // Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for words that are no snapshot, damaged, of another
    // version or byte order.
    // Throws Error with GPHYS_ERROR_OUT_OF_MEMORY if there is no room for it.
    // Cost: as Solver::get_snapshot; allocates.
    void restore(Span<const uint32_t> words) {
        const uint32_t count = common_size({words.sizes()});
        check(gphys_solver_restore(handle(), words.contiguous("words"), count));
    }

    // A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
    // different ones differ with near certainty (not against an adversary). Compare it between machines
    // that run the same simulation, to detect when they diverge.
    // Cost: O(particles + constraints).
    std::array<uint32_t, 2> get_hash() const {
        std::array<uint32_t, 2> out_hash{};
        check(gphys_solver_get_hash(handle(), out_hash.data()));
        return out_hash;
    }

};

inline Mesh::Mesh(const Scene& scene, gphys_model_id model) {
    gphys_mesh* made = nullptr;
    check(gphys_scene_get_mesh(scene.handle(), model, &made));
    own(made);
}

inline Mesh::Mesh(Solver& solver, gphys_body_id body, const MeshDesc* desc) {
    gphys_mesh* made = nullptr;
    check(gphys_mesh_create_from_body(desc, solver.handle(), body, &made));
    own(made);
}

// Whether the fields of the shape are in the ranges stated beside its struct.
// Throws Error with GPHYS_ERROR_INVALID_ARGUMENT and the exception's message names the field.
// Cost: O(1).
inline void validate(ShapeRef shape) {
    check(gphys_shape_validate(shape.type, shape.pointer));
}

// The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
// Result: std::nullopt for a plane, a ray without end (or with one beyond all floats) and a frustum
// that extends to infinity; for an empty mesh or frustum.
// Cost: O(1), for a mesh too.
inline std::optional<Aabb> bounds(ShapeRef shape) {
    Aabb out_bounds{};
    if (!found(gphys_shape_bounds(shape.type, shape.pointer, &out_bounds))) return std::nullopt;
    return out_bounds;
}

// Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0 the
// answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of its
// rotation in double precision). Others are as gamephys::overlaps with a sphere.
//   - tolerance: metres, >= 0
// Cost: O(1); O(log n) expected for a mesh.
inline bool contains(ShapeRef shape, const Vec3& point, float tolerance) {
    int32_t out_contains{};
    check(gphys_shape_contains(shape.type, shape.pointer, &point, tolerance, &out_contains));
    return out_contains != 0;
}

// Whether each of the points is within tolerance metres of one shape, as gamephys::contains.
//   - tolerance: metres, >= 0, for all points
// Cost: that of as many single calls.
inline void contains_batch(ShapeRef shape, Span<const Vec3> points, float tolerance, Span<int32_t> out_contains) {
    const uint32_t count = common_size({points.sizes()});
    require_size(out_contains.size, count);
    check(gphys_shape_contains_batch(shape.type, shape.pointer, points.data, points.stride, count, tolerance, out_contains.data, out_contains.stride));
}

// The point of the shape that is closest to the given point: the point itself inside a solid. Error: 1
// ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest coordinate
// difference. If several are equally close, one of them, always the same. For a ray, t is limited by
// t_max.
// Result: std::nullopt only for an empty mesh or an empty frustum.
// Cost: O(1); O(log n) expected for a mesh.
inline std::optional<Nearest> closest_point(ShapeRef shape, const Vec3& point) {
    Nearest out_nearest{};
    if (!found(gphys_shape_closest_point(shape.type, shape.pointer, &point, &out_nearest))) return std::nullopt;
    return out_nearest;
}

// The points of one shape that are closest to each of the points, as gamephys::closest_point. An
// element for which there is none gets distance INFINITY.
// Cost: that of as many single calls.
inline void closest_point_batch(ShapeRef shape, Span<const Vec3> points, Span<Nearest> out_nearest) {
    const uint32_t count = common_size({points.sizes()});
    require_size(out_nearest.size, count);
    check(gphys_shape_closest_point_batch(shape.type, shape.pointer, points.data, points.stride, count, out_nearest.data, out_nearest.stride));
}

// The closest points of two segments and their distance. Parallel segments have many: the first along
// a, always the same.
// Result: metres.
// Cost: O(1).
inline std::tuple<Vec3, Vec3, float> segment_closest_points(const Segment& a, const Segment& b) {
    Vec3 out_a{};
    Vec3 out_b{};
    float out_distance{};
    check(gphys_segment_closest_points(&a, &b, &out_a, &out_b, &out_distance));
    return std::make_tuple(out_a, out_b, out_distance);
}

// Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane, triangle,
// frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a closed mesh does
// not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes, triangles, meshes and
// frusta; other pairs are decided in double precision and may err only where the gap is below 2^-40 of
// the largest coordinate difference.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or segment (see gamephys::segment_test).
// Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.
inline bool overlaps(ShapeRef a, ShapeRef b) {
    int32_t out_overlaps{};
    check(gphys_shape_overlaps(a.type, a.pointer, b.type, b.pointer, &out_overlaps));
    return out_overlaps != 0;
}

// Whether the shapes of each of the pairs overlap, as gamephys::overlaps: pair i is a[i] against b[i].
//   - a, b: shapes of one type
// Throws Error with GPHYS_ERROR_UNSUPPORTED for rays and segments.
// Cost: that of as many single calls.
inline void overlaps_batch(ShapeSpan a, ShapeSpan b, Span<int32_t> out_overlaps) {
    const uint32_t count = common_size({a.sizes(), b.sizes()});
    require_size(out_overlaps.size, count);
    check(gphys_shape_overlaps_batch(a.type, a.data, a.stride, b.type, b.data, b.stride, count, out_overlaps.data, out_overlaps.stride));
}

// Classify a sphere, capsule, AABB, OBB or triangle against a plane.
// Result: metres, of the shape's nearest point to the plane: > 0 in front, < 0 behind, 0 when
// crossing.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for other types of shapes.
// Cost: O(1).
inline std::tuple<gphys_side, float> classify_plane(ShapeRef shape, const Plane& plane) {
    gphys_side out_side{};
    float out_signed_distance{};
    check(gphys_shape_classify_plane(shape.type, shape.pointer, &plane, &out_side, &out_signed_distance));
    return std::make_tuple(out_side, out_signed_distance);
}

// Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that no
// point is shared, inside that the frustum holds the whole shape.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for other types of shapes.
// Cost: O(1).
inline gphys_side classify_frustum(ShapeRef shape, const Frustum& frustum) {
    gphys_side out_side{};
    check(gphys_shape_classify_frustum(shape.type, shape.pointer, &frustum, &out_side));
    return out_side;
}

// First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. Triangles
// and meshes are hit from both sides, and meshes are watertight: a ray through a shared edge or vertex
// always meets one of the triangles there. Error: t within 1 ulp. No false miss and no false hit at
// all for spheres, triangles, meshes, AABBs and planes; for capsules only within 2^-48 of the
// distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the distance.
// docs/accuracy.md has the bounds of all functions.
// Result: std::nullopt if nothing is found.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape.
// Cost: O(1); O(log n) expected for a mesh.
inline std::optional<Hit> raycast(ShapeRef shape, const Ray& ray) {
    Hit out_hit{};
    if (!found(gphys_shape_raycast(shape.type, shape.pointer, &ray, &out_hit))) return std::nullopt;
    return out_hit;
}

// First hits of the rays with one shape, as gamephys::raycast. A ray that hits nothing gets t =
// INFINITY, triangle = GPHYS_NO_TRIANGLE and zeros in its hits element.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape.
// Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.
inline void raycast_batch(ShapeRef shape, Span<const Ray> rays, Span<Hit> out_hits) {
    const uint32_t count = common_size({rays.sizes()});
    require_size(out_hits.size, count);
    check(gphys_shape_raycast_batch(shape.type, shape.pointer, rays.data, rays.stride, count, out_hits.data, out_hits.stride));
}

// First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
// segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack of a
// direction, the normal is zero.
// Result: std::nullopt if nothing is found.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape.
// Cost: as gamephys::raycast.
inline std::optional<Hit> segment_test(ShapeRef shape, const Segment& segment) {
    Hit out_hit{};
    if (!found(gphys_shape_segment_test(shape.type, shape.pointer, &segment, &out_hit))) return std::nullopt;
    return out_hit;
}

// First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
// triangle, frustum or mesh.
// Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
//   - displacement: metres; may be zero
// Result: t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
// the sphere's centre; in double precision its dot with the displacement is never above 0. Already
// overlapping: t = 0, GPHYS_HIT_INSIDE, and the normal may be along the displacement too; where the
// centre itself is in a solid, it is opposite to the displacement (zero if that is zero). A sphere of
// radius 0 gets the hit of the ray along its path. std::nullopt if nothing is found.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape.
// Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected for a
// mesh.
inline std::optional<Hit> sweep_sphere(ShapeRef shape, const Sphere& sphere, const Vec3& displacement) {
    Hit out_hit{};
    if (!found(gphys_shape_sweep_sphere(shape.type, shape.pointer, &sphere, &displacement, &out_hit))) return std::nullopt;
    return out_hit;
}

// First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning, with a
// sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere moves, must
// be the hull of its corners (gamephys::frustum_corners).
// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
// ulp of t. Point and normal are those of that contact.
//   - displacement: metres; may be zero
// Result: t, point and normal as in gamephys::sweep_sphere, which gives the answer for a sphere. The
// point is one of those where the two touch, always the same. Already overlapping, except for a
// sphere: t = 0, GPHYS_HIT_INSIDE, and point and normal of gamephys::penetration; for a mesh that is
// not a hull, those of its first triangle. std::nullopt if nothing is found.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for a ray or a segment as the shape, for a frustum that is
// not the hull of its corners, unless a sphere moves, and for other types that move.
// Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.
inline std::optional<Hit> sweep(ShapeRef shape, ShapeRef moving, const Vec3& displacement) {
    Hit out_hit{};
    if (!found(gphys_shape_sweep(shape.type, shape.pointer, moving.type, moving.pointer, &displacement, &out_hit))) return std::nullopt;
    return out_hit;
}

// First contacts of count moving shapes of one type with the shapes of another, as gamephys::sweep:
// moving[i] with shapes[i]. One that touches nothing gets t = INFINITY, triangle = GPHYS_NO_TRIANGLE
// and zeros.
//   - shapes, moving: shapes of one type
//   - displacements: metres
// Throws Error with GPHYS_ERROR_UNSUPPORTED as gamephys::sweep.
// Cost: that of as many single calls. Since 1.1.
inline void sweep_batch(ShapeSpan shapes, ShapeSpan moving, Span<const Vec3> displacements, Span<Hit> out_hits) {
    const uint32_t count = common_size({shapes.sizes(), moving.sizes(), displacements.sizes()});
    require_size(out_hits.size, count);
    check(gphys_shape_sweep_batch(shapes.type, shapes.data, shapes.stride, moving.type, moving.data, moving.stride, displacements.data, displacements.stride, count, out_hits.data, out_hits.stride));
}

// The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule, AABB,
// OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or triangle
// that is nearer. Of a mesh: out of the triangle that it is deepest in; others may remain, and have
// translations of their own. Of a hull: out of all of it, and triangle is GPHYS_NO_TRIANGLE. A frustum
// must be the hull of its corners (gamephys::frustum_corners).
// Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and 1
// ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the other
// shape. Added to float positions, the translation may leave an overlap as large as the spacing of
// floats there.
// Result: depth and normal of the translation, which is their product; of several equally short ones
// always the same one. The deepest point of the solid is point - depth * normal. std::nullopt if
// nothing is found.
// Throws Error with GPHYS_ERROR_UNSUPPORTED for rays, segments, frusta that are not the hull of their
// corners, and for other types that move.
// Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
// separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
// Keerthi 1988).
inline std::optional<Penetration> penetration(ShapeRef shape, ShapeRef moving) {
    Penetration out_penetration{};
    if (!found(gphys_shape_penetration(shape.type, shape.pointer, moving.type, moving.pointer, &out_penetration))) return std::nullopt;
    return out_penetration;
}

// The shortest translations that take the shapes of one type out of the shapes of another, as
// gamephys::penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth = -INFINITY,
// triangle = GPHYS_NO_TRIANGLE and zeros.
//   - shapes, moving: shapes of one type
// Throws Error with GPHYS_ERROR_UNSUPPORTED as gamephys::penetration.
// Cost: that of as many single calls. Since 1.1.
inline void penetration_batch(ShapeSpan shapes, ShapeSpan moving, Span<Penetration> out_penetrations) {
    const uint32_t count = common_size({shapes.sizes(), moving.sizes()});
    require_size(out_penetrations.size, count);
    check(gphys_shape_penetration_batch(shapes.type, shapes.data, shapes.stride, moving.type, moving.data, moving.stride, count, out_penetrations.data, out_penetrations.stride));
}

// The eight corners, each the intersection of three planes: near then far, each in the order
// left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
// intersections themselves, not rounded to floats) if each is within GPHYS_MAX_COORDINATE and in front
// of the three planes that do not meet there, by more than 2^-39 of its distance from origin; that is,
// unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a frustum and
// pushed out of it; for the bounds of their errors, origin counts as a corner.
// Result: std::nullopt if three planes do not meet in a point (infinite far plane), or meet beyond the
// largest float.
// Cost: O(1).
inline std::optional<std::array<Vec3, 8>> frustum_corners(const Frustum& frustum) {
    std::array<Vec3, 8> out_corners{};
    if (!found(gphys_frustum_corners(&frustum, out_corners.data()))) return std::nullopt;
    return out_corners;
}

// The point that three planes have in common, within an ulp of each coordinate.
// Result: std::nullopt if the planes have no single point in common, which is decided exactly, or one
// beyond GPHYS_MAX_COORDINATE.
// Cost: O(1). Source: Cramer's rule. Since 1.1.
inline std::optional<Vec3> planes_intersection(const Plane& a, const Plane& b, const Plane& c) {
    Vec3 out_point{};
    if (!found(gphys_planes_intersection(&a, &b, &c, &out_point))) return std::nullopt;
    return out_point;
}

// The points of the triples of planes, as gamephys::planes_intersection; one without gets x = y = z =
// INFINITY.
//   - a, b, c: the planes
// Cost: that of as many single calls. Since 1.1.
inline void planes_intersection_batch(Span<const Plane> a, Span<const Plane> b, Span<const Plane> c, Span<Vec3> out_points) {
    const uint32_t count = common_size({a.sizes(), b.sizes(), c.sizes()});
    require_size(out_points.size, count);
    check(gphys_planes_intersection_batch(a.data, a.stride, b.data, b.stride, c.data, c.stride, count, out_points.data, out_points.stride));
}

// How far the axes of a matrix (its first three columns without the last row) are from orthonormal:
// the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the identity, below 2^-22
// for the matrices that a camera gives, about 2e for axes that are too long by a fraction e.
//   - matrix: elements within GPHYS_MAX_COORDINATE
// Cost: O(1). Since 1.1.
inline float mat4_orthonormality(const Mat4& matrix) {
    float out_deviation{};
    check(gphys_mat4_orthonormality(&matrix, &out_deviation));
    return out_deviation;
}

// The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
// origin (0, 0, 0). For a camera, Camera::get_frustum is more precise.
//   - reverse_z: 0: near has the low depth; 1: near has the high depth
// Throws Error with GPHYS_ERROR_SINGULAR if the matrix has no inverse, or what it shows has no volume:
// its four near corners are not all finite points in front of the viewer.
// Cost: O(1).
inline Frustum frustum_from_matrix(const Mat4& view_projection, gphys_depth_range depth_range, int32_t reverse_z) {
    Frustum out_frustum{};
    check(gphys_frustum_from_matrix(&view_projection, depth_range, reverse_z, &out_frustum));
    return out_frustum;
}

// Examine arrays without building anything. Allocates while it runs.
//   - vertices: elements of 3 floats, metres
//   - indices: numbers, three for each triangle
// Result: what was found; indices out of range and bad vertices are counted, not refused.
// Throws Error with GPHYS_ERROR_INVALID_ARGUMENT for an index_count that is no multiple of 3.
// Cost: O(n log n).
inline MeshReport mesh_check(Span<const float> vertices, Span<const uint32_t> indices) {
    MeshReport out_report{};
    check(gphys_mesh_check(vertices.data, vertices.stride, vertices.size, indices.contiguous("indices"), indices.size, &out_report));
    return out_report;
}

// The shape moved; an Aabb becomes an Obb.
template <class S>
auto transform(const S& shape, const Transform& by) {
    std::conditional_t<std::is_same_v<S, Aabb>, Obb, S> moved{};
    check(gphys_shape_transform(ShapeRef(shape).type, &shape, &by, &moved));
    return moved;
}
// The orbit settings that the library starts from.
inline Orbit orbit() {
    Orbit settings;
    check(gphys_orbit_init(&settings));
    return settings;
}

} // namespace gamephys

#endif
