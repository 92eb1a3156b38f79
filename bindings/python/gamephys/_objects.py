"""Generated from gamephys_api.json by bindings/generate.py. Not for editing."""
from __future__ import annotations

import ctypes
from typing import Any, Sequence, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _low as low
from ._library import check, found
from ._numbers import flag, mask, number, value, whole
from ._runtime import (Bodies, Models, Object, array_of, common_length, descs_of, handle_of, list_of, matrix, matrix_of,
                       numbers_of, ragged_of, result_array, shape_of, shapes_of, value_of)
from ._values import StructLike, VectorLike



class Mesh(Object):
    """Build a mesh from copies of the arrays. Triangles of zero area are kept: queries treat them as
    the segments or points that they are, and the report counts them. 0 triangles are allowed.
    Cost: O(n log n), about 1 us per triangle.

    Raises:
        InvalidArgument: for an index out of range, an index_count that is no multiple of 3 or a bad
            vertex; gamephys.mesh_check tells which"""
    _destroy = low.gphys_mesh_destroy
    _shape_type = low.SHAPE_MESH

    def __init__(self, vertices: ArrayLike, indices: ArrayLike, desc: low.MeshDesc | None = None) -> None:
        desc_ = desc if desc is None else value_of(desc, low.MeshDesc, "desc")
        vertices_ = array_of(vertices, "<f4", 3)
        indices_ = array_of(indices, "<u4", packed=True)
        handle = ctypes.c_void_p()
        check(low.gphys_mesh_create(desc_, vertices_.address, vertices_.stride, vertices_.length, indices_.address, indices_.numbers, ctypes.byref(handle)))
        self._own(handle.value)

    @classmethod
    def hull(cls, points: ArrayLike, desc: low.MeshDesc | None = None) -> Mesh:
        """Make the convex hull of points: a mesh that is solid, as spheres and boxes are. It can be used
        wherever a mesh can: functions of shapes, models of scenes, snapshots, and solvers, whose
        particles stay outside and are pushed out. A ray that starts inside hits at t = 0 with
        HIT_INSIDE; one from outside hits the face through which it enters, `triangle` says where.
        Whether a ray hits and whether a point is inside is exact with respect to the points. Inside,
        the closest point is the point itself and triangle NO_TRIANGLE. Mesh.overlap lists the triangles
        of the surface; Mesh.raycast_all gives only the first hit. The vertices are the points that are
        corners of the hull, in their original order; of equal points the first. The triangles come face
        by face, all that lie in one plane being one face; seen from outside their corners go
        counterclockwise where axes are right-handed, and the normal cross(b - a, c - a) points out.
        Cost: O(point_count * faces); allocates. Rays take O(log faces), other queries up to O(faces).
        Source: quickhull (Barber, Dobkin, Huhdanpaa 1996) with exact predicates. Since 1.1.

        Args:
            desc: deformable must be 0
            points: elements of 3 floats, metres; copied

        Raises:
            InvalidArgument: if a point is out of range or if all lie in a plane, which is decided
                exactly
            Error, status ERROR_CAPACITY: if the hull has more than 256 faces
            Error, status ERROR_UNSUPPORTED: if desc asks for a deformable mesh"""
        desc_ = desc if desc is None else value_of(desc, low.MeshDesc, "desc")
        points_ = array_of(points, "<f4", 3)
        handle = ctypes.c_void_p()
        check(low.gphys_mesh_create_hull(desc_, points_.address, points_.stride, points_.length, ctypes.byref(handle)))
        made = cls.__new__(cls)
        made._own(handle.value)
        return made

    @classmethod
    def from_snapshot(cls, words: ArrayLike, desc: low.MeshDesc | None = None) -> Mesh:
        """Make a mesh from a snapshot: all its answers have the same bits as those of the mesh in the
        snapshot. Any words are safe, also from an untrusted source: vertices, indices and the tree are
        checked, and what follows from them is computed. Forged words are refused, or taken as a mesh
        like any other; only the counts of its report (triangles of zero area, open edges) are taken
        from the words as they are.
        Cost: O(n), a small part of Mesh's; allocates.

        Args:
            desc: with `deformable` the mesh takes new vertices, even if the one in the snapshot did not

        Raises:
            InvalidArgument: for words that are no snapshot of a mesh, damaged, of a later format or of
                another byte order
            Error, status ERROR_UNSUPPORTED: for a deformable hull"""
        desc_ = desc if desc is None else value_of(desc, low.MeshDesc, "desc")
        words_ = array_of(words, "<u4", packed=True)
        handle = ctypes.c_void_p()
        check(low.gphys_mesh_create_from_snapshot(desc_, words_.address, words_.length, ctypes.byref(handle)))
        made = cls.__new__(cls)
        made._own(handle.value)
        return made

    @classmethod
    def from_scene(cls, scene: Scene | None, model: int) -> Mesh:
        """A handle of a model's mesh: of the mesh itself, not of a copy, so that what Mesh.set_vertices
        does to it is seen by all its models. It gives the meshes of a restored scene, which are not
        deformable if they were embedded in its snapshot.
        Cost: O(1). Since 1.1.

        Returns:
            a reference of its own, which keeps the mesh alive, and is to be destroyed like any handle.

        Raises:
            Error, status ERROR_UNSUPPORTED: if the model's shape is no mesh"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        handle = ctypes.c_void_p()
        check(low.gphys_scene_get_mesh(handle_of(scene, Scene), model, ctypes.byref(handle)))
        made = cls.__new__(cls)
        made._own(handle.value)
        return made

    @classmethod
    def from_body(cls, solver: Solver | None, body: int, desc: low.MeshDesc | None = None) -> Mesh:
        """Make a mesh that has the form of a body and follows it automatically: cloth, ropes and particles
        can be hit by rays, picked, overlapped and culled as models of scenes (Scene.add with
        SHAPE_MESH; without a transform the model is where the body is) or queried by shape_* and mesh_*
        functions. Vertex p is particle p. For cloth the mesh is the surface of its triangles, in the
        order of Solver.get_triangles. A rope of n particles is solid. In a hit, `triangle` t below n -
        1 is the link from particle t to t + 1, a capsule with the smaller of their radii, present while
        a constraint holds them together; n - 1 + p is particle p, a sphere, present where no link
        beside it is as thick. Free particles are spheres, and `triangle` is the particle.
        Solver.get_nearest_particle finds the particle of a hit. The mesh has the new form when
        Solver.step, Solver.advance, Solver.restore or an edit of the body returns. When cloth tears
        (Break), its triangles keep their numbers, and the mesh gets vertices for the new particles. A
        model that would leave the range of the world, and a torn mesh or one of less than 2^-32 m for
        which there is no memory, keep their form until they can follow. Solver.set_origin moves the
        coordinates of the mesh, and the models back by as much: they stay where they are in the world,
        exactly if scenes have moved their origin before. Bodies neither collide with models of such
        meshes nor wake because of them: BodyDesc.body_layers sets which bodies collide. A restored body
        is followed if it has the same id and parts as before. Restore the solver before the scene. A
        mesh that is loaded from a snapshot, that of a scene included, is a copy that follows nothing;
        Scene.set_shape gives its model one that does. Mesh and solver are destroyed in any order. When
        the body is gone the mesh keeps the form that it had last and is deformable by
        Mesh.set_vertices, which returns ERROR_UNSUPPORTED before. A mesh that neither its handle nor a
        model holds follows no more.
        Threads: the functions above become edits of the mesh and of each scene that has a model of it.
        Cost: as Mesh, and then that of Mesh.set_vertices for a body that has moved; one that rests is
        compared, O(particles). Since 1.1.

        Args:
            desc: the mesh is deformable whatever it says"""
        desc_ = desc if desc is None else value_of(desc, low.MeshDesc, "desc")
        if type(body) is not int or body >> 32: body = whole(body, "body")
        handle = ctypes.c_void_p()
        check(low.gphys_mesh_create_from_body(desc_, handle_of(solver, Solver), body, ctypes.byref(handle)))
        made = cls.__new__(cls)
        made._own(handle.value)
        return made

    def get_hull_planes(self) -> NDArray[np.void]:
        """The planes of a hull's faces: normals are unit and point out, within float32 rounding.
        Cost: O(faces). Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: for a mesh that is no hull"""
        return list_of(low.gphys_mesh_get_hull_planes, (self._handle,), low.plane_dtype)

    def get_hull_faces(self) -> NDArray[np.uint32]:
        """For each triangle of a hull the index of its face in the list of Mesh.get_hull_planes, ascending
        from 0.
        Cost: O(triangles). Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: for a mesh that is no hull"""
        return list_of(low.gphys_mesh_get_hull_faces, (self._handle,), "<u4")

    def set_vertices(self, vertices: ArrayLike) -> None:
        """Replace the vertices of a deformable mesh, such as a skinned character, or cloth as
        Solver.get_positions writes it. All models of the mesh take the new form at once, in every
        scene, and all answers have the same bits as those of a mesh created from the new vertices. A
        call that fails leaves the mesh and the scenes as they were. A solver sees the new form at its
        next step, as a surface that stands still.
        Threads: an edit of the mesh and of every scene that has a model of it: not beside other calls
        on these.
        Cost: O(vertices + triangles + log n for each model), a few per cent of creating it: the tree is
        refitted, and parts that have degraded are rebuilt. If the triangles have moved apart so far
        that the boxes of their groups of eight have twice the area, once as much as creating it.
        Allocates. Since 1.1.

        Args:
            vertices: elements of 3 floats, metres; copied

        Raises:
            Error, status ERROR_UNSUPPORTED: if the mesh is not deformable
            InvalidArgument: for a vertex that is not finite or too large, or if a model of the mesh
                would reach beyond the range of coordinates"""
        vertices_ = array_of(vertices, "<f4", 3)
        status = low.gphys_mesh_set_vertices(self._handle, vertices_.address, vertices_.stride, vertices_.length)
        if status < 0: check(status)

    def get_info(self) -> low.MeshInfo:
        """Kind and size of a mesh, and whether its vertices change.
        Cost: O(1). Since 1.1."""
        out_info = low.MeshInfo()
        status = low.gphys_mesh_get_info(self._handle, ctypes.byref(out_info))
        if status < 0: check(status)
        return out_info

    def get_report(self) -> low.MeshReport:
        """What the mesh was built from: the report that gamephys.mesh_check makes of its arrays.
        Cost: O(1); O(triangles) for a deformable mesh."""
        out_report = low.MeshReport()
        status = low.gphys_mesh_get_report(self._handle, ctypes.byref(out_report))
        if status < 0: check(status)
        return out_report

    def get_vertices(self) -> NDArray[np.float32]:
        """Copy the vertices out, in metres and in their original order.
        Cost: O(vertices)."""
        return list_of(low.gphys_mesh_get_vertices, (self._handle,), low.vec3_dtype)

    def get_indices(self) -> NDArray[np.uint32]:
        """Copy the indices out, three for each triangle, in their original order.
        Cost: O(n)."""
        return list_of(low.gphys_mesh_get_indices, (self._handle,), "<u4")

    def get_snapshot(self) -> NDArray[np.uint32]:
        """Copy a mesh out with its tree, from which Mesh makes it without building the tree.
        Threads: any.
        Cost: O(n), some 24 bytes and 5 ns for each triangle; no allocation.

        Returns:
            the snapshot. Words are in the machine's byte order. Every later release of the same major
                version reads it.

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^32 - 1 words"""
        return list_of(low.gphys_mesh_get_snapshot, (self._handle,), "<u4")

    def raycast_all(self, ray: low.Ray | StructLike) -> NDArray[np.void]:
        """All hits of a ray, by t, then triangle. A ray through a shared edge hits both triangles.
        Cost: O(log n + k) expected."""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        return list_of(low.gphys_mesh_raycast_all, (self._handle, ray_,), low.hit_dtype)

    def raycast_any(self, ray: low.Ray | StructLike) -> bool:
        """Whether a ray hits anything; cheaper than the closest hit.
        Cost: O(log n) expected."""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        out_hit = ctypes.c_int32()
        status = low.gphys_mesh_raycast_any(self._handle, ray_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return bool(out_hit.value)

    def raycast_any_batch(self, rays: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
        """Whether each of the rays hits anything, as Mesh.raycast_any.
        Cost: that of as many single calls; less if neighbouring rays are similar. Since 1.1."""
        rays_ = array_of(rays, low.ray_dtype)
        count = common_length(rays_)
        out_ = result_array(out, count, "<i4")
        status = low.gphys_mesh_raycast_any_batch(self._handle, rays_.address, rays_.stride, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_distance_batch(self, rays: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """How far each of the rays goes, and which triangle it hits: t and triangle of
        gamephys.raycast_batch for the mesh, with the same bits, without the rest of a hit; model is 0.
        Cost: less than that of gamephys.raycast_batch. Since 1.1.

        Returns:
            a ray that hits nothing gets t = INFINITY and triangle = NO_TRIANGLE."""
        rays_ = array_of(rays, low.ray_dtype)
        count = common_length(rays_)
        out_ = result_array(out, count, low.distance_dtype)
        status = low.gphys_mesh_raycast_distance_batch(self._handle, rays_.address, rays_.stride, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def overlap(self, shape: Shape) -> NDArray[np.uint32]:
        """Indices of all triangles that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum,
        ascending.
        Cost: O(log n + k) expected.

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types of shapes"""
        type_, shape_ = shape_of(shape)
        return list_of(low.gphys_mesh_overlap, (self._handle, type_, shape_,), "<u4")

    def get_octree_stats(self) -> low.OctreeStats:
        """How the mesh's octree is made up.
        Cost: O(nodes)."""
        out_stats = low.OctreeStats()
        status = low.gphys_mesh_get_octree_stats(self._handle, ctypes.byref(out_stats))
        if status < 0: check(status)
        return out_stats

    def get_octree_boxes(self) -> NDArray[np.void]:
        """Boxes of the mesh's octree, each parent before its children.
        Cost: O(nodes)."""
        return list_of(low.gphys_mesh_get_octree_boxes, (self._handle,), low.octree_box_dtype)



class Scene(Models):
    """Create a scene without models. With a worker_count of n, all batch queries of the scene
    (Camera.pick_batch too), and adding and moving many models, share their work among n threads;
    the results have the same bits for every n. Without a task_runner n - 1 threads are started here
    and joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run
    on their own thread alone. They take no signals but faults, and have the standard floating-point
    settings. In a child of fork they are gone: calls there run on one thread, as they do on a
    platform without threads (WebAssembly, unless built for shared memory), whatever is asked for.
    Cost: O(reserve_models), and that of starting the threads.

    Args:
        desc: None: the defaults

    Raises:
        OutOfMemory: also if the threads cannot be started
        Error, status ERROR_CAPACITY: if reserve_models is above 2^24 - 1"""
    _destroy = low.gphys_scene_destroy

    def __init__(self, desc: low.SceneDesc | None = None) -> None:
        desc_ = desc if desc is None else value_of(desc, low.SceneDesc, "desc")
        handle = ctypes.c_void_p()
        check(low.gphys_scene_create(desc_, ctypes.byref(handle)))
        self._own(handle.value)

    def set_worker_count(self, workers: int) -> None:
        """Change the number of threads that share the calls of a scene, for example when the user changes
        a setting. They are those of its task_runner if it was created with one. In a child of fork they
        are started again. Answers keep their bits.
        Cost: that of joining the former threads and starting others; allocates. Since 1.1.

        Args:
            workers: as SceneDesc.worker_count

        Raises:
            OutOfMemory: also if the threads cannot be started; the former ones are kept"""
        if type(workers) is not int or workers >> 32: workers = whole(workers, "workers")
        status = low.gphys_scene_set_worker_count(self._handle, workers)
        if status < 0: check(status)

    def get_worker_count(self) -> int:
        """How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a
        child of fork it is still the number that was set, though calls run on one thread.
        Cost: O(1). Since 1.1."""
        out_workers = ctypes.c_uint32()
        status = low.gphys_scene_get_worker_count(self._handle, ctypes.byref(out_workers))
        if status < 0: check(status)
        return out_workers.value

    def set_origin(self, origin: ArrayLike) -> None:
        """Move the point of the world that all coordinates of the scene are relative to, those passed to
        it and those that it returns. Models stay where they are in the world: the positions of those
        without a parent become what they are from there, kept in double precision and rounded to
        float32 once, however often the origin moves. For worlds beyond some kilometres: keep the origin
        near the camera, and when the camera has gone a few kilometres, move it together with that of
        cameras and solvers.
        Cost: that of Scene.set_transforms of all models, and 24 bytes a model from the first call on.
        Queries cost nothing more. Allocates.

        Args:
            origin: x, y, z in the world, within MAX_COORDINATE; before the first call 0 0 0

        Raises:
            InvalidArgument: also if a model would leave the range of coordinates"""
        origin_ = numbers_of(origin, "<f8", 3)
        status = low.gphys_scene_set_origin(self._handle, origin_.address)
        if status < 0: check(status)

    def get_origin(self) -> NDArray[np.float64]:
        """Where in the world the scene's coordinates count from.
        Cost: O(1)."""
        out_origin = np.empty(3, "<f8")
        status = low.gphys_scene_get_origin(self._handle, out_origin.ctypes.data)
        if status < 0: check(status)
        return out_origin

    def add(self, shape: low.Sphere | low.Capsule | low.Aabb | low.Obb | low.Plane | low.Triangle | Mesh, transform: low.Transform | StructLike | None = None, desc: low.ModelDesc | None = None) -> int:
        """Add a model.
        Cost: O(log n) amortised.

        Args:
            shape: sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
            shape: in the model's own coordinates
            transform: local; None is the identity
            desc: None: no parent, layer 1, tag 0

        Raises:
            Error, status ERROR_UNSUPPORTED: for another type, or a scale that the shape cannot have
                (Scene.set_scale)
            InvalidId: for a stale parent
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 models"""
        type_, shape_ = shape_of(shape)
        transform_ = transform if transform is None else value_of(transform, low.Transform, "transform")
        desc_ = desc if desc is None else value_of(desc, low.ModelDesc, "desc")
        out_model = ctypes.c_uint32()
        status = low.gphys_scene_add(self._handle, type_, shape_, transform_, desc_, ctypes.byref(out_model))
        if status < 0: check(status)
        return out_model.value

    def add_batch(self, shapes: ArrayLike | Mesh, transforms: ArrayLike | None = None, desc: low.ModelDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.uint32]:
        """Add the models of one type, all or none, as Scene.add does one.
        Fails as Scene.add.
        Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their
        number is of the order of n.

        Args:
            shapes: in the models' own coordinates
            transforms: local; None is the identity
            desc: for all; None: no parent, layer 1, tag 0"""
        type_, shapes_ = shapes_of(shapes)
        transforms_ = array_of(transforms, low.transform_dtype)
        desc_ = desc if desc is None else value_of(desc, low.ModelDesc, "desc")
        count = common_length(shapes_, transforms_)
        out_ = result_array(out, count, "<u4", packed=True)
        status = low.gphys_scene_add_batch(self._handle, type_, shapes_.address, shapes_.stride, transforms_.address, transforms_.stride, count, desc_, out_.address)
        if status < 0: check(status)
        return out_.array

    def add_described_batch(self, shapes: ArrayLike | Mesh, transforms: ArrayLike | None = None, descs: NDArray[np.void] | Sequence[low.ModelDesc] | low.ModelDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.uint32]:
        """Add the models of one type, all or none, each with a desc of its own.
        Fails as Scene.add; ERROR_STRUCT_SIZE as for a single desc.
        Cost: as Scene.add_batch.

        Args:
            shapes: in the models' own coordinates
            transforms: local; None is the identity
            descs: one for each; None: no parent, layer 1, tag 0. Parents are models that the scene has
                before the call"""
        type_, shapes_ = shapes_of(shapes)
        transforms_ = array_of(transforms, low.transform_dtype)
        descs_ = descs_of(descs, low.ModelDesc)
        count = common_length(shapes_, transforms_, descs_)
        out_ = result_array(out, count, "<u4", packed=True)
        status = low.gphys_scene_add_described_batch(self._handle, type_, shapes_.address, shapes_.stride, transforms_.address, transforms_.stride, descs_.address, descs_.stride, count, out_.address)
        if status < 0: check(status)
        return out_.array

    def remove(self, model: int) -> None:
        """Remove a model. Its children stay where they are in the world and lose their parent.
        Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        status = low.gphys_scene_remove(self._handle, model)
        if status < 0: check(status)

    def remove_batch(self, models: ArrayLike) -> None:
        """Remove models, all or none.
        Cost: that of as many calls of Scene.remove. Renews the octree as far as there is memory.

        Args:
            models: the ids; an id that appears twice is ERROR_INVALID_ID"""
        models_ = array_of(models, "<u4", packed=True)
        count = common_length(models_)
        status = low.gphys_scene_remove_batch(self._handle, models_.address, count)
        if status < 0: check(status)

    def remove_subtree(self, model: int) -> None:
        """Remove a model and all its descendants.
        Cost: O(log n) amortised for each. Renews the octree as far as there is memory."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        status = low.gphys_scene_remove_subtree(self._handle, model)
        if status < 0: check(status)

    def clear(self) -> None:
        """Remove all models. Ids given out before stay invalid.
        Cost: O(n)."""
        status = low.gphys_scene_clear(self._handle)
        if status < 0: check(status)

    def has(self, model: int) -> bool:
        """Whether an id names a model of this scene.
        Cost: O(1)."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        status = low.gphys_scene_has(self._handle, model)
        return not status or status != low.ERROR_INVALID_ID and found(status)

    def get_models(self) -> NDArray[np.uint32]:
        """Ids of all models, ascending.
        Cost: O(n)."""
        return list_of(low.gphys_scene_get_models, (self._handle,), "<u4")

    def get_roots(self) -> NDArray[np.uint32]:
        """Ids of all models without a parent, ascending.
        Cost: O(n)."""
        return list_of(low.gphys_scene_get_roots, (self._handle,), "<u4")

    def get_children(self, model: int) -> NDArray[np.uint32]:
        """Ids of the direct children of a model, ascending.
        Cost: O(k log k)."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        return list_of(low.gphys_scene_get_children, (self._handle, model,), "<u4")

    def get_info(self, model: int) -> low.ModelInfo:
        """Kind, parent, layers, tag and number of children of a model.
        Cost: O(1)."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        out_info = low.ModelInfo()
        status = low.gphys_scene_get_info(self._handle, model, ctypes.byref(out_info))
        if status < 0: check(status)
        return out_info

    def get_bounds(self, model: int) -> low.Aabb | None:
        """World box of a model, by which queries find it: contains the model, and is wider by at most 3
        ulps and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
        Cost: O(1).

        Returns:
            None for a plane."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        out_bounds = low.Aabb()
        status = low.gphys_scene_get_bounds(self._handle, model, ctypes.byref(out_bounds))
        if status < 0: check(status)
        return None if status else out_bounds

    def get_scene_bounds(self) -> low.Aabb | None:
        """World box of all bounded models. Planes are left out.
        Cost: O(1).

        Returns:
            None if there are none."""
        out_bounds = low.Aabb()
        status = low.gphys_scene_get_scene_bounds(self._handle, ctypes.byref(out_bounds))
        if status < 0: check(status)
        return None if status else out_bounds

    def set_shape(self, model: int, shape: low.Sphere | low.Capsule | low.Aabb | low.Obb | low.Plane | low.Triangle | Mesh) -> None:
        """Give a model another shape, or another mesh, of any type that Scene.add takes: a character
        crouches, a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale
        and transforms stay. Sleeping bodies near it wake, and particles that are inside then come out
        as they do of any solid.
        Cost: as Scene.set_transform of a model without children, whatever the size of a mesh.

        Args:
            shape: as in Scene.add: a struct, copied, or a mesh with SHAPE_MESH. The scene holds the new
                mesh and no longer the old one, which may be the same.

        Raises:
            Error, status ERROR_UNSUPPORTED: for a frustum, ray or segment, and for a shape that cannot
                have the model's scale (Scene.set_scale)
            InvalidArgument: also if the model would leave the range of the world
            OutOfMemory:"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        type_, shape_ = shape_of(shape)
        status = low.gphys_scene_set_shape(self._handle, model, type_, shape_)
        if status < 0: check(status)

    def set_scale(self, model: int, scale: VectorLike) -> None:
        """Scale a model's own shape along the three axes of the model, before its transform: a tree grows,
        a unit box becomes a wall, a rock is stretched. Every query, and solvers, see the scaled shape;
        normals are those of its surface. Children and attached particles (Solver.attach) are not
        affected: they follow the transform, whose scale is one number. A new scale replaces the old
        one. No scale mirrors: for that, negate a coordinate of a mesh's vertices and swap two corners
        of each triangle. There is no form for many models: three equal numbers belong in their
        transforms (Scene.set_transforms), and Scene.add_described_batch takes a scale for each model
        that it adds. A mesh or a hull is scaled exactly, without a copy: answers are those of a mesh of
        the scaled vertices. Of a box or a triangle each number is multiplied and rounded to float32. A
        sphere, capsule or plane, and an OBB whose own rotation is not the identity, take three equal
        numbers only.
        Cost: as Scene.set_transform of a model without children. Models that have a scale take 16 bytes
        more if they are meshes, else 52, up to the highest id. Queries of a scaled mesh or hull take 1
        to 11 % more; rays at a mesh that is flattened to a twentieth take 1.3 times those at a mesh of
        the scaled vertices, whose tree is made for that form.

        Args:
            scale: x, y, z, each from 1e-15 to 1e15

        Raises:
            Error, status ERROR_UNSUPPORTED: for numbers that are not equal where they have to be, and
                for the mesh of a rope or of particles (Mesh) unless it is 1 1 1
            InvalidArgument: also if a coordinate of the scaled shape would exceed MAX_COORDINATE, if a
                number times that of a mesh's world transform is not from 1e-15 to 1e15, or if the model
                would leave the range of the world
            OutOfMemory:"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        scale_ = scale if type(scale) is low.Vec3 else value_of(scale, low.Vec3, "scale")
        status = low.gphys_scene_set_scale(self._handle, model, scale_)
        if status < 0: check(status)

    def get_scale(self, model: int) -> low.Vec3:
        """The scale of a model's own shape, 1 1 1 unless another was set.
        Cost: O(1)."""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        out_scale = low.Vec3()
        status = low.gphys_scene_get_scale(self._handle, model, ctypes.byref(out_scale))
        if status < 0: check(status)
        return out_scale

    def set_layers(self, model: int, layers: int = low.ALL_LAYERS) -> None:
        """Change which queries see a model: those with a mask m of which layers & m is not 0. Children are
        not affected.
        Cost: O(1).

        Args:
            layers: any mask; 0: no query sees it"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        status = low.gphys_scene_set_layers(self._handle, model, layers)
        if status < 0: check(status)

    def set_tag(self, model: int, tag: int) -> None:
        """Change the number that a model's hits report beside its id. Children are not affected.
        Cost: O(1).

        Args:
            tag: any number of the caller's"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        if type(tag) is not int or tag >> 32: tag = whole(tag, "tag")
        status = low.gphys_scene_set_tag(self._handle, model, tag)
        if status < 0: check(status)

    def set_parent(self, model: int, parent: int, keep_world: bool) -> None:
        """Make a model the child of another one, or of none (0).
        Cost: O(depth of the tree of models), and as Scene.set_transform for what moves. Renews the
        octree as far as there is memory.

        Args:
            keep_world: False: the local transform is kept, the model jumps; True: the local transform
                is changed so that the world transform stays (within float32 rounding)

        Raises:
            Error, status ERROR_CYCLE: if parent is the model or one of its descendants"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        if type(parent) is not int or parent >> 32: parent = whole(parent, "parent")
        if type(keep_world) is not bool: keep_world = flag(keep_world, "keep_world")
        status = low.gphys_scene_set_parent(self._handle, model, parent, keep_world)
        if status < 0: check(status)

    def set_transform(self, model: int, transform: low.Transform | StructLike | None = None) -> None:
        """Set a model's local transform. Descendants follow.
        Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.

        Args:
            transform: relative to the parent; scale > 0

        Raises:
            InvalidArgument: also if it, or a descendant, would leave the range of the world"""
        if type(model) is not int or model >> 32: model = whole(model, "model")
        transform_ = transform if type(transform) is low.Transform else value_of(transform, low.Transform, "transform")
        status = low.gphys_scene_set_transform(self._handle, model, transform_)
        if status < 0: check(status)

    def set_transforms(self, models: ArrayLike, transforms: ArrayLike | None = None) -> None:
        """Set the local transforms of many models, all or none; a model that appears twice gets the last.
        Descendants follow.
        Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers.
        Renews the octree as far as there is memory.

        Args:
            models: the ids
            transforms: as in Scene.set_transform"""
        models_ = array_of(models, "<u4", packed=True)
        transforms_ = array_of(transforms, low.transform_dtype)
        count = common_length(models_, transforms_)
        status = low.gphys_scene_set_transforms(self._handle, models_.address, transforms_.address, transforms_.stride, count)
        if status < 0: check(status)

    def get_transforms(self, models: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Local transforms of the models, as they were set: relative to the parent.
        Cost: O(elements).

        Args:
            models: the ids; an id may appear twice"""
        models_ = array_of(models, "<u4", packed=True)
        count = common_length(models_)
        out_ = result_array(out, count, low.transform_dtype)
        status = low.gphys_scene_get_transforms(self._handle, models_.address, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def get_world_transforms(self, models: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """World transforms of the models: with those of all ancestors applied, rounded to float32. Answers
        of queries are exact with respect to these.
        Cost: O(elements).

        Args:
            models: the ids; an id may appear twice"""
        models_ = array_of(models, "<u4", packed=True)
        count = common_length(models_)
        out_ = result_array(out, count, low.transform_dtype)
        status = low.gphys_scene_get_world_transforms(self._handle, models_.address, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast(self, ray: low.Ray | StructLike, layers: int = low.ALL_LAYERS) -> low.Hit | None:
        """Closest model on a ray; the fields are exact as in gamephys.raycast.
        Cost: O(log n) expected; no allocation.

        Returns:
            None if nothing is found."""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = low.Hit()
        status = low.gphys_scene_raycast(self._handle, ray_, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def raycast_batch(self, rays: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Closest models on the rays, as Scene.raycast; a ray that hits nothing gets model = 0 and t =
        INFINITY.
        Cost: at most that of as many single calls; shared among workers."""
        rays_ = array_of(rays, low.ray_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(rays_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_raycast_batch(self._handle, rays_.address, rays_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_distance_batch(self, rays: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """How far each of the rays goes, and what it hits: t, model and triangle of Scene.raycast_batch,
        with the same bits, without the rest of a hit. For lidars and depth images.
        Cost: less than that of Scene.raycast_batch; shared among workers. Since 1.1.

        Returns:
            a ray that hits nothing gets t = INFINITY, model = 0 and triangle = NO_TRIANGLE."""
        rays_ = array_of(rays, low.ray_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(rays_)
        out_ = result_array(out, count, low.distance_dtype)
        status = low.gphys_scene_raycast_distance_batch(self._handle, rays_.address, rays_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_any(self, ray: low.Ray | StructLike, layers: int = low.ALL_LAYERS) -> bool:
        """Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
        Cost: O(log n) expected."""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = ctypes.c_int32()
        status = low.gphys_scene_raycast_any(self._handle, ray_, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return bool(out_hit.value)

    def raycast_any_batch(self, rays: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
        """Whether each of the rays meets anything, as Scene.raycast_any.
        Cost: at most that of as many single calls; shared among workers."""
        rays_ = array_of(rays, low.ray_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(rays_)
        out_ = result_array(out, count, "<i4")
        status = low.gphys_scene_raycast_any_batch(self._handle, rays_.address, rays_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_all(self, ray: low.Ray | StructLike, layers: int = low.ALL_LAYERS) -> NDArray[np.void]:
        """Every model that a ray meets, each once with its first hit, by t, then id.
        Cost: O(log n + k log k) expected."""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_scene_raycast_all, (self._handle, ray_, layers,), low.hit_dtype)

    def raycast_all_batch(self, rays: ArrayLike, layers: int = low.ALL_LAYERS) -> tuple[NDArray[np.void], NDArray[np.uint32]]:
        """Every model that each of the rays meets, as Scene.raycast_all: the hits of ray i are at
        hits[offsets[i]] up to offsets[i + 1].
        The contents of hits behind the last hit are unspecified.
        Cost: that of as many single calls; shared among workers."""
        rays_ = array_of(rays, low.ray_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(rays_)
        return ragged_of(low.gphys_scene_raycast_all_batch, (self._handle, rays_.address, rays_.stride, count, layers,), low.hit_dtype, count)

    def segment_test(self, segment: low.Segment | StructLike, layers: int = low.ALL_LAYERS) -> low.Hit | None:
        """Closest model along a segment from a to b, both included; t in 0..1. Fields as in
        gamephys.segment_test.
        Cost: O(log n) expected.

        Returns:
            None if nothing is found."""
        segment_ = segment if type(segment) is low.Segment else value_of(segment, low.Segment, "segment")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = low.Hit()
        status = low.gphys_scene_segment_test(self._handle, segment_, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def segment_test_batch(self, segments: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Closest models along the segments, as Scene.segment_test; one that hits nothing gets model = 0
        and t = INFINITY.
        Cost: that of as many single calls; shared among workers."""
        segments_ = array_of(segments, low.segment_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(segments_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_segment_test_batch(self._handle, segments_.address, segments_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def overlap(self, shape: Shape, layers: int = low.ALL_LAYERS) -> NDArray[np.uint32]:
        """Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
        gamephys.overlaps, ascending.
        Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32
        + 64 more saves most of that, unless many models have replaced removed ones.

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types of shapes"""
        type_, shape_ = shape_of(shape)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_scene_overlap, (self._handle, type_, shape_, layers,), "<u4")

    def overlap_batch(self, shapes: ArrayLike | Mesh, layers: int = low.ALL_LAYERS) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Ids of all models that each of the shapes of one type overlaps, as Scene.overlap: those of shape
        i are at models[offsets[i]] up to offsets[i + 1], as in Scene.raycast_all_batch.
        Cost: at most that of as many single calls; shared among workers.

        Raises:
            Error, status ERROR_UNSUPPORTED: as there"""
        type_, shapes_ = shapes_of(shapes)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(shapes_)
        return ragged_of(low.gphys_scene_overlap_batch, (self._handle, type_, shapes_.address, shapes_.stride, count, layers,), "<u4", count)

    def cull(self, frustum: low.Frustum | StructLike, layers: int = low.ALL_LAYERS) -> NDArray[np.uint32]:
        """Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
        box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
        edges are listed, too: a few per cent more where models are compact or not rotated; about a
        third more where they are long or flat and rotated, so that their world boxes are mostly empty,
        and as many again as are visible where they are as long as the view is wide. Scene.overlap
        leaves these out by testing the shapes. In scenes of more than 130 000 models, room for n / 32
        more ids than are listed is best: it is used to order them.
        Cost: O(log n + k) expected."""
        frustum_ = frustum if type(frustum) is low.Frustum else value_of(frustum, low.Frustum, "frustum")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_scene_cull, (self._handle, frustum_, layers,), "<u4")

    def cull_batch(self, frusta: ArrayLike, layers: int = low.ALL_LAYERS) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Ids of the models in each of count frusta, as Scene.cull: for split screens, cascades of shadow
        maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
        offsets[i + 1], as in Scene.raycast_all_batch.
        Cost: that of as many single calls; shared among workers. Since 1.1."""
        frusta_ = array_of(frusta, low.frustum_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(frusta_)
        return ragged_of(low.gphys_scene_cull_batch, (self._handle, frusta_.address, frusta_.stride, count, layers,), "<u4", count)

    def nearest(self, point: VectorLike, max_distance: float = float("inf"), layers: int = low.ALL_LAYERS) -> low.Nearest | None:
        """The model nearest to a point, and its closest point.
        Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
        nearer than the answer, are visited in vain, until it is faster to test all models in the
        layers. That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive
        models is in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us,
        and of 100 some 15 us.

        Args:
            max_distance: metres, >= 0, INFINITY allowed; a model at exactly this distance counts

        Returns:
            None if nothing is found."""
        point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
        if type(max_distance) is not float: max_distance = number(max_distance, "max_distance")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_nearest = low.Nearest()
        status = low.gphys_scene_nearest(self._handle, point_, max_distance, layers, ctypes.byref(out_nearest))
        if status < 0: check(status)
        return None if status else out_nearest

    def nearest_batch(self, points: ArrayLike, max_distance: float = float("inf"), layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """The models nearest to the points, as Scene.nearest; a point with none gets model = 0 and
        distance = INFINITY.
        Cost: that of as many single calls; shared among workers.

        Args:
            max_distance: metres, >= 0, INFINITY allowed, for all points"""
        points_ = array_of(points, low.vec3_dtype)
        if type(max_distance) is not float: max_distance = number(max_distance, "max_distance")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(points_)
        out_ = result_array(out, count, low.nearest_dtype)
        status = low.gphys_scene_nearest_batch(self._handle, points_.address, points_.stride, count, max_distance, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def sweep_sphere(self, sphere: low.Sphere | StructLike, displacement: VectorLike, layers: int = low.ALL_LAYERS) -> low.Hit | None:
        """First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
        gamephys.sweep_sphere.
        Cost: O(log n + k) expected, k the models that the swept box touches.

        Args:
            displacement: metres; may be zero

        Returns:
            None if nothing is found."""
        sphere_ = sphere if type(sphere) is low.Sphere else value_of(sphere, low.Sphere, "sphere")
        displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = low.Hit()
        status = low.gphys_scene_sweep_sphere(self._handle, sphere_, displacement_, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def sweep_sphere_batch(self, spheres: ArrayLike, displacements: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """First models that the spheres touch while each moves by its displacement, as Scene.sweep_sphere;
        one that touches nothing gets model = 0 and t = INFINITY.
        Cost: that of as many single calls; shared among workers.

        Args:
            displacements: metres"""
        spheres_ = array_of(spheres, low.sphere_dtype)
        displacements_ = array_of(displacements, low.vec3_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(spheres_, displacements_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_sweep_sphere_batch(self._handle, spheres_.address, spheres_.stride, displacements_.address, displacements_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def sweep(self, shape: Shape, displacement: VectorLike, layers: int = low.ALL_LAYERS) -> low.Hit | None:
        """First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
        turning; t in 0..1. Fields as in gamephys.sweep.
        Cost: O(log n + k) expected, k the models that the swept box touches.

        Args:
            displacement: metres; may be zero

        Returns:
            None if nothing is found.

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types"""
        type_, shape_ = shape_of(shape)
        displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = low.Hit()
        status = low.gphys_scene_sweep(self._handle, type_, shape_, displacement_, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def sweep_batch(self, shapes: ArrayLike | Mesh, displacements: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """First models that the shapes of one type touch while each moves by its displacement, as
        Scene.sweep; one that touches nothing gets model = 0 and t = INFINITY.
        Cost: that of as many single calls; shared among workers.

        Args:
            displacements: metres

        Raises:
            Error, status ERROR_UNSUPPORTED: as Scene.sweep"""
        type_, shapes_ = shapes_of(shapes)
        displacements_ = array_of(displacements, low.vec3_dtype)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(shapes_, displacements_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_sweep_batch(self._handle, type_, shapes_.address, shapes_.stride, displacements_.address, displacements_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def penetration(self, shape: Shape, layers: int = low.ALL_LAYERS) -> NDArray[np.void]:
        """What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model,
        and of a mesh one for each triangle, as gamephys.penetration. Deepest first; equal depths by
        model, then triangle. Each is the way out of that one alone. The models are those of
        Scene.overlap.
        Cost: O(log n + k log k) expected.

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types"""
        type_, shape_ = shape_of(shape)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_scene_penetration, (self._handle, type_, shape_, layers,), low.penetration_dtype)

    def penetration_batch(self, shapes: ArrayLike | Mesh, layers: int = low.ALL_LAYERS) -> tuple[NDArray[np.void], NDArray[np.uint32]]:
        """What each of the shapes of one type overlaps, and how it gets out, as Scene.penetration: the
        ways out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in
        Scene.raycast_all_batch. So a crowd of characters is pushed out in one call.
        Cost: that of as many single calls; shared among workers. Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: as Scene.penetration"""
        type_, shapes_ = shapes_of(shapes)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(shapes_)
        return ragged_of(low.gphys_scene_penetration_batch, (self._handle, type_, shapes_.address, shapes_.stride, count, layers,), low.penetration_dtype, count)

    def raycast_filtered(self, ray: low.Ray | StructLike, filter: low.QueryFilterDesc | None = None) -> low.Hit | None:
        """Closest model on a ray that the filter sees, as Scene.raycast.
        Cost: that of Scene.raycast for one ignored model. For each model that is met within the ray's
        reach, besides: O(its depth below its root) with FILTER_SUBTREE if ignored_model has children;
        of m ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m).
        Whether they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a
        time.

        Args:
            filter: None: the defaults

        Returns:
            None if nothing is found.

        Raises:
            InvalidArgument: for unknown flags, or ignored_models None with an ignored_count above 0"""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = low.Hit()
        status = low.gphys_scene_raycast_filtered(self._handle, ray_, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def raycast_filtered_batch(self, rays: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Closest models on the rays that the filters see, as Scene.raycast_batch.
        Cost: at most that of as many calls of Scene.raycast_filtered; shared among workers.

        Args:
            filters: None: the defaults"""
        rays_ = array_of(rays, low.ray_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(rays_, filters_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_raycast_filtered_batch(self._handle, rays_.address, rays_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_distance_filtered_batch(self, rays: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """How far each of the rays goes among the models that its filter sees, as
        Scene.raycast_distance_batch: a lidar leaves out the robot that carries it.
        Cost: less than that of Scene.raycast_filtered_batch; shared among workers. Since 1.1.

        Args:
            filters: None: the defaults"""
        rays_ = array_of(rays, low.ray_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(rays_, filters_)
        out_ = result_array(out, count, low.distance_dtype)
        status = low.gphys_scene_raycast_distance_filtered_batch(self._handle, rays_.address, rays_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_any_filtered(self, ray: low.Ray | StructLike, filter: low.QueryFilterDesc | None = None) -> bool:
        """Whether a ray meets anything that the filter sees, as Scene.raycast_any: line of sight between
        two models that both are left out.
        Cost: as Scene.raycast_filtered.

        Args:
            filter: None: the defaults"""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = ctypes.c_int32()
        status = low.gphys_scene_raycast_any_filtered(self._handle, ray_, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return bool(out_hit.value)

    def raycast_any_filtered_batch(self, rays: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
        """Whether each of the rays meets anything that its filter sees, as Scene.raycast_any_batch.
        Cost: at most that of as many single calls; shared among workers.

        Args:
            filters: None: the defaults"""
        rays_ = array_of(rays, low.ray_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(rays_, filters_)
        out_ = result_array(out, count, "<i4")
        status = low.gphys_scene_raycast_any_filtered_batch(self._handle, rays_.address, rays_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def raycast_all_filtered(self, ray: low.Ray | StructLike, filter: low.QueryFilterDesc | None = None) -> NDArray[np.void]:
        """Every model that a ray meets and the filter sees, as Scene.raycast_all.
        Cost: that of Scene.raycast_all, and for each model as Scene.raycast_filtered.

        Args:
            filter: None: the defaults"""
        ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_scene_raycast_all_filtered, (self._handle, ray_, filter_,), low.hit_dtype)

    def raycast_all_filtered_batch(self, rays: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None) -> tuple[NDArray[np.void], NDArray[np.uint32]]:
        """Every model that each of the rays meets and its filter sees, as Scene.raycast_all_batch.
        Cost: that of as many single calls; shared among workers.

        Args:
            filters: None: the defaults"""
        rays_ = array_of(rays, low.ray_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(rays_, filters_)
        return ragged_of(low.gphys_scene_raycast_all_filtered_batch, (self._handle, rays_.address, rays_.stride, count, filters_.address, filters_.stride,), low.hit_dtype, count)

    def segment_test_filtered(self, segment: low.Segment | StructLike, filter: low.QueryFilterDesc | None = None) -> low.Hit | None:
        """Closest model along a segment that the filter sees, as Scene.segment_test.
        Cost: as Scene.raycast_filtered.

        Args:
            filter: None: the defaults

        Returns:
            None if nothing is found."""
        segment_ = segment if type(segment) is low.Segment else value_of(segment, low.Segment, "segment")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = low.Hit()
        status = low.gphys_scene_segment_test_filtered(self._handle, segment_, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def segment_test_filtered_batch(self, segments: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Closest models along the segments that the filters see, as Scene.segment_test_batch.
        Cost: that of as many single calls; shared among workers.

        Args:
            filters: None: the defaults"""
        segments_ = array_of(segments, low.segment_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(segments_, filters_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_segment_test_filtered_batch(self._handle, segments_.address, segments_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def overlap_filtered(self, shape: Shape, filter: low.QueryFilterDesc | None = None) -> NDArray[np.uint32]:
        """Ids of all models that overlap a shape and that the filter sees, as Scene.overlap.
        Cost: that of Scene.overlap, and for each model as Scene.raycast_filtered.

        Args:
            filter: None: the defaults

        Raises:
            Error, status ERROR_UNSUPPORTED: for types of shapes that Scene.overlap does not take"""
        type_, shape_ = shape_of(shape)
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_scene_overlap_filtered, (self._handle, type_, shape_, filter_,), "<u4")

    def overlap_filtered_batch(self, shapes: ArrayLike | Mesh, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Ids of all models that each of the shapes of one type overlaps and its filter sees, as
        Scene.overlap_batch.
        Cost: at most that of as many single calls; shared among workers.

        Args:
            filters: None: the defaults

        Raises:
            Error, status ERROR_UNSUPPORTED: as there"""
        type_, shapes_ = shapes_of(shapes)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(shapes_, filters_)
        return ragged_of(low.gphys_scene_overlap_filtered_batch, (self._handle, type_, shapes_.address, shapes_.stride, count, filters_.address, filters_.stride,), "<u4", count)

    def cull_filtered(self, frustum: low.Frustum | StructLike, filter: low.QueryFilterDesc | None = None) -> NDArray[np.uint32]:
        """Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene.cull: a
        player's own head, say, is not drawn.
        Cost: that of Scene.cull, and for each model as Scene.raycast_filtered.

        Args:
            filter: None: the defaults"""
        frustum_ = frustum if type(frustum) is low.Frustum else value_of(frustum, low.Frustum, "frustum")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_scene_cull_filtered, (self._handle, frustum_, filter_,), "<u4")

    def cull_filtered_batch(self, frusta: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None) -> tuple[NDArray[np.uint32], NDArray[np.uint32]]:
        """Ids of the models in each of count frusta that its filter sees, as Scene.cull_batch: each
        player's view leaves out the player's own head.
        Cost: that of as many single calls; shared among workers. Since 1.1.

        Args:
            filters: None: the defaults"""
        frusta_ = array_of(frusta, low.frustum_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(frusta_, filters_)
        return ragged_of(low.gphys_scene_cull_filtered_batch, (self._handle, frusta_.address, frusta_.stride, count, filters_.address, filters_.stride,), "<u4", count)

    def nearest_filtered(self, point: VectorLike, max_distance: float = float("inf"), filter: low.QueryFilterDesc | None = None) -> low.Nearest | None:
        """The model nearest to a point that the filter sees, as Scene.nearest: the nearest other model, if
        the one at the point is left out.
        Cost: that of Scene.nearest, and for each model as Scene.raycast_filtered; each ignored model
        that is nearer than the answer is visited.

        Args:
            max_distance: metres, >= 0, INFINITY allowed; a model at exactly this distance counts
            filter: None: the defaults

        Returns:
            None if nothing is found."""
        point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
        if type(max_distance) is not float: max_distance = number(max_distance, "max_distance")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_nearest = low.Nearest()
        status = low.gphys_scene_nearest_filtered(self._handle, point_, max_distance, filter_, ctypes.byref(out_nearest))
        if status < 0: check(status)
        return None if status else out_nearest

    def nearest_filtered_batch(self, points: ArrayLike, max_distance: float = float("inf"), filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """The models nearest to the points that the filters see, as Scene.nearest_batch.
        Cost: that of as many single calls; shared among workers.

        Args:
            max_distance: metres, >= 0, INFINITY allowed, for all points
            filters: None: the defaults"""
        points_ = array_of(points, low.vec3_dtype)
        if type(max_distance) is not float: max_distance = number(max_distance, "max_distance")
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(points_, filters_)
        out_ = result_array(out, count, low.nearest_dtype)
        status = low.gphys_scene_nearest_filtered_batch(self._handle, points_.address, points_.stride, count, max_distance, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def sweep_sphere_filtered(self, sphere: low.Sphere | StructLike, displacement: VectorLike, filter: low.QueryFilterDesc | None = None) -> low.Hit | None:
        """First model that a moving sphere touches and the filter sees, as Scene.sweep_sphere: the sphere
        may be the bounding sphere of the ignored model.
        Cost: that of Scene.sweep_sphere, and for each model as Scene.raycast_filtered.

        Args:
            displacement: metres; may be zero
            filter: None: the defaults

        Returns:
            None if nothing is found."""
        sphere_ = sphere if type(sphere) is low.Sphere else value_of(sphere, low.Sphere, "sphere")
        displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = low.Hit()
        status = low.gphys_scene_sweep_sphere_filtered(self._handle, sphere_, displacement_, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def sweep_sphere_filtered_batch(self, spheres: ArrayLike, displacements: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """First models that count moving spheres touch and the filters see, as Scene.sweep_sphere_batch.
        Cost: that of as many single calls; shared among workers.

        Args:
            displacements: metres
            filters: None: the defaults"""
        spheres_ = array_of(spheres, low.sphere_dtype)
        displacements_ = array_of(displacements, low.vec3_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(spheres_, displacements_, filters_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_sweep_sphere_filtered_batch(self._handle, spheres_.address, spheres_.stride, displacements_.address, displacements_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def sweep_filtered(self, shape: Shape, displacement: VectorLike, filter: low.QueryFilterDesc | None = None) -> low.Hit | None:
        """First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as
        Scene.sweep: a character leaves out its own model.
        Cost: that of Scene.sweep, and for each model as Scene.raycast_filtered.

        Args:
            displacement: metres; may be zero
            filter: None: the defaults

        Returns:
            None if nothing is found.

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types"""
        type_, shape_ = shape_of(shape)
        displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = low.Hit()
        status = low.gphys_scene_sweep_filtered(self._handle, type_, shape_, displacement_, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def sweep_filtered_batch(self, shapes: ArrayLike | Mesh, displacements: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """First models that count moving shapes of one type touch and the filters see, as
        Scene.sweep_batch.
        Cost: that of as many single calls; shared among workers.

        Args:
            displacements: metres
            filters: None: the defaults

        Raises:
            Error, status ERROR_UNSUPPORTED: as Scene.sweep"""
        type_, shapes_ = shapes_of(shapes)
        displacements_ = array_of(displacements, low.vec3_dtype)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(shapes_, displacements_, filters_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_scene_sweep_filtered_batch(self._handle, type_, shapes_.address, shapes_.stride, displacements_.address, displacements_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def penetration_filtered(self, shape: Shape, filter: low.QueryFilterDesc | None = None) -> NDArray[np.void]:
        """What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
        Scene.penetration.
        Cost: that of Scene.penetration, and for each model as Scene.raycast_filtered.

        Args:
            filter: None: the defaults

        Raises:
            Error, status ERROR_UNSUPPORTED: for other types"""
        type_, shape_ = shape_of(shape)
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_scene_penetration_filtered, (self._handle, type_, shape_, filter_,), low.penetration_dtype)

    def penetration_filtered_batch(self, shapes: ArrayLike | Mesh, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None) -> tuple[NDArray[np.void], NDArray[np.uint32]]:
        """What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
        Scene.penetration_batch: each character leaves out its own model.
        Cost: that of as many single calls; shared among workers. Since 1.1.

        Args:
            filters: None: the defaults

        Raises:
            Error, status ERROR_UNSUPPORTED: as Scene.penetration"""
        type_, shapes_ = shapes_of(shapes)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(shapes_, filters_)
        return ragged_of(low.gphys_scene_penetration_filtered_batch, (self._handle, type_, shapes_.address, shapes_.stride, count, filters_.address, filters_.stride,), low.penetration_dtype, count)

    def rebuild_octree(self) -> None:
        """Rebuild the scene's octree, as good as that of one Scene.add_batch. Never required: ids, answers
        and their bits do not change. Where many models were added one by one, such as a level that was
        streamed in, rays then take 0.6 to 0.95 of the time.
        Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.

        Raises:
            OutOfMemory: with nothing changed"""
        status = low.gphys_scene_rebuild_octree(self._handle)
        if status < 0: check(status)

    def maintain_octree(self, budget: int) -> bool:
        """Rebuild the octree in parts, one in each call, until it is as good as after
        Scene.rebuild_octree: for levels that are streamed in while frames go on. Each Scene.add and
        Scene.remove does a part by itself; these calls do the rest. Never needed: ids, answers and
        their bits stay as they are. Models may be added, moved and removed between the calls. A call
        that updates an eighth of them or more restarts it.
        Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.

        Args:
            budget: how much work to do, as a number of models, of 0.3 to 3 us each. The work is the
                same on every machine and does not depend on time.

        Returns:
            1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
                again.

        Raises:
            OutOfMemory: : the octree is as before, and the next call begins again"""
        if type(budget) is not int or budget >> 32: budget = whole(budget, "budget")
        out_done = ctypes.c_int32()
        status = low.gphys_scene_maintain_octree(self._handle, budget, ctypes.byref(out_done))
        if status < 0: check(status)
        return bool(out_done.value)

    def get_octree_stats(self) -> low.OctreeStats:
        """How the scene's octree is made up.
        Cost: O(nodes)."""
        out_stats = low.OctreeStats()
        status = low.gphys_scene_get_octree_stats(self._handle, ctypes.byref(out_stats))
        if status < 0: check(status)
        return out_stats

    def get_octree_boxes(self) -> NDArray[np.void]:
        """Boxes of the scene's octree, each parent before its children.
        Cost: O(nodes)."""
        return list_of(low.gphys_scene_get_octree_boxes, (self._handle,), low.octree_box_dtype)

    def validate(self) -> None:
        """Check the scene's own structure: every model once in the tree, every box around its content,
        parents and children in agreement, free slots free. For tests.
        Cost: O(n).

        Raises:
            Error, status ERROR_INTERNAL: and the error's message says what is wrong"""
        status = low.gphys_scene_validate(self._handle)
        if status < 0: check(status)

    def get_snapshot(self, embed_meshes: bool) -> NDArray[np.uint32]:
        """Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms
        and shapes, the order of future ids, and the octree. Workers and allocator are not in it.
        Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes
        (Mesh.get_snapshot). Allocates a few words for each different mesh.

        Args:
            embed_meshes: True: meshes are in the snapshot, each once, so it is complete in itself: for
                saved games and for other machines. False: they are identified by their content, and
                Scene.restore looks for them: for undo, and rollback each frame.

        Returns:
            the snapshot. Words are in the machine's byte order. Every later release of the same major
                version reads it.

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^32 - 1 words"""
        if type(embed_meshes) is not bool: embed_meshes = flag(embed_meshes, "embed_meshes")
        return list_of(low.gphys_scene_get_snapshot, (self._handle, embed_meshes,), "<u4")

    def restore(self, library: Scene | None, words: ArrayLike) -> None:
        """Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
        time of the snapshot, and so are future ones. All answers have the bits that they had then; a
        solver that is restored with its scene continues with the same bits. On an error the scene is as
        before. Any words are safe, also from an untrusted source: all that is used as a number or an
        index is checked first. Forged words are refused, or taken as a scene like any other.
        Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.

        Args:
            library: meshes that are not embedded are looked for among those that models of this scene
                use, by their content: vertices and indices. A mesh deformed since must get its old form
                back first. None: among those that models of `scene` itself use, before it is restored.

        Raises:
            InvalidArgument: for words that are no snapshot of a scene, damaged, of a later format or of
                another byte order, and if a mesh is missing
            OutOfMemory: if there is no room for it"""
        words_ = array_of(words, "<u4", packed=True)
        count = common_length(words_)
        status = low.gphys_scene_restore(self._handle, handle_of(library, Scene), words_.address, count)
        if status < 0: check(status)

    def get_hash(self) -> NDArray[np.uint32]:
        """A hash of the whole state except the octree, the low half first; meshes count by their content.
        Equal states have equal hashes on every machine; different ones differ with near certainty (not
        against an adversary). Compare it between machines that run the same simulation, to detect when
        they diverge.
        Cost: O(n), some 50 ns for each model."""
        out_hash = np.empty(2, "<u4")
        status = low.gphys_scene_get_hash(self._handle, out_hash.ctypes.data)
        if status < 0: check(status)
        return out_hash



class Camera(Object):
    """Create a camera at the origin, with the projection and the viewport of its desc.
    Cost: O(1).

    Args:
        desc: None: the defaults"""
    _destroy = low.gphys_camera_destroy

    def __init__(self, desc: low.CameraDesc | None = None) -> None:
        desc_ = desc if desc is None else value_of(desc, low.CameraDesc, "desc")
        handle = ctypes.c_void_p()
        check(low.gphys_camera_create(desc_, ctypes.byref(handle)))
        self._own(handle.value)

    def set_origin(self, origin: ArrayLike) -> None:
        """Move the point of the world that the camera's coordinates count from; see Scene.set_origin. The
        camera and the target of its orbit stay where they are in the world. Picking and culling need a
        scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
        Cost: O(1).

        Args:
            origin: x, y, z in the world, metres, within MAX_COORDINATE"""
        origin_ = numbers_of(origin, "<f8", 3)
        status = low.gphys_camera_set_origin(self._handle, origin_.address)
        if status < 0: check(status)

    def get_origin(self) -> NDArray[np.float64]:
        """Where in the world the camera's coordinates count from, metres.
        Cost: O(1)."""
        out_origin = np.empty(3, "<f8")
        status = low.gphys_camera_get_origin(self._handle, out_origin.ctypes.data)
        if status < 0: check(status)
        return out_origin

    def set_perspective(self, fov_y: float, near_distance: float, far_distance: float) -> None:
        """Use a perspective projection: distant objects appear smaller.
        Cost: O(1).

        Args:
            fov_y: full vertical angle in radians, 1e-6 <= fov_y < pi
            near_distance: metres, > 0
            far_distance: metres, > near_distance; INFINITY allowed"""
        if type(fov_y) is not float: fov_y = number(fov_y, "fov_y")
        if type(near_distance) is not float: near_distance = number(near_distance, "near_distance")
        if type(far_distance) is not float: far_distance = number(far_distance, "far_distance")
        status = low.gphys_camera_set_perspective(self._handle, fov_y, near_distance, far_distance)
        if status < 0: check(status)

    def set_orthographic(self, height: float, near_distance: float, far_distance: float) -> None:
        """Use an orthographic projection: the distance does not change apparent size.
        Cost: O(1).

        Args:
            height: metres seen from top to bottom, >= 1e-6; the width follows from the viewport and is
                at most twice MAX_COORDINATE
            near_distance: metres, may be negative
            far_distance: metres, at least 1e-6 above near_distance"""
        if type(height) is not float: height = number(height, "height")
        if type(near_distance) is not float: near_distance = number(near_distance, "near_distance")
        if type(far_distance) is not float: far_distance = number(far_distance, "far_distance")
        status = low.gphys_camera_set_orthographic(self._handle, height, near_distance, far_distance)
        if status < 0: check(status)

    def set_projection(self, projection: low.Mat4 | ArrayLike) -> None:
        """Use any projection matrix of the camera's depth range and direction (off-centre, oblique,
        another library's). It is not changed by Camera.set_viewport.
        Cost: O(1).

        Raises:
            Error, status ERROR_SINGULAR: if it has no inverse, or is too close to such a matrix to tell
            InvalidArgument: if a plane other than far lies at infinity, as it does when the matrix is
                for another depth range, or one lies beyond MAX_COORDINATE"""
        projection_ = matrix_of(projection, low.Mat4, "projection")
        status = low.gphys_camera_set_projection(self._handle, projection_)
        if status < 0: check(status)

    def set_perspective_aspect(self, fov_y: float, aspect: float, near_distance: float, far_distance: float) -> None:
        """As Camera.set_perspective, with a fixed aspect ratio: the image is stretched to the viewport, as
        with pixels that are not square, and the viewport does not change what is seen.
        Cost: O(1). Since 1.1.

        Args:
            fov_y: full vertical angle in radians, 1e-6 <= fov_y < pi
            aspect: width over height of what is seen, 1e-6 .. 1e6
            near_distance: metres, > 0
            far_distance: metres, > near_distance; INFINITY allowed"""
        if type(fov_y) is not float: fov_y = number(fov_y, "fov_y")
        if type(aspect) is not float: aspect = number(aspect, "aspect")
        if type(near_distance) is not float: near_distance = number(near_distance, "near_distance")
        if type(far_distance) is not float: far_distance = number(far_distance, "far_distance")
        status = low.gphys_camera_set_perspective_aspect(self._handle, fov_y, aspect, near_distance, far_distance)
        if status < 0: check(status)

    def set_orthographic_size(self, width: float, height: float, near_distance: float, far_distance: float) -> None:
        """As Camera.set_orthographic, with a width of its own, which the viewport does not change.
        Cost: O(1). Since 1.1.

        Args:
            width: metres seen from left to right, >= 1e-6
            height: metres seen from top to bottom, >= 1e-6
            near_distance: metres, may be negative
            far_distance: metres, at least 1e-6 above near_distance"""
        if type(width) is not float: width = number(width, "width")
        if type(height) is not float: height = number(height, "height")
        if type(near_distance) is not float: near_distance = number(near_distance, "near_distance")
        if type(far_distance) is not float: far_distance = number(far_distance, "far_distance")
        status = low.gphys_camera_set_orthographic_size(self._handle, width, height, near_distance, far_distance)
        if status < 0: check(status)

    def set_viewport(self, width: float, height: float) -> None:
        """Set the size of the viewport. A perspective keeps fov_y, an orthographic projection its height;
        the call is refused if that makes the width more than twice MAX_COORDINATE.
        Cost: O(1).

        Args:
            width, height: pixels, 1e-3 .. 1e6"""
        if type(width) is not float: width = number(width, "width")
        if type(height) is not float: height = number(height, "height")
        status = low.gphys_camera_set_viewport(self._handle, width, height)
        if status < 0: check(status)

    def set_viewport_origin(self, x: float, y: float) -> None:
        """Where the viewport is in its window, as one of several of a split screen: pixels of all
        functions count from the window's top left corner. (0, 0) at creation.
        Cost: O(1). Since 1.1.

        Args:
            x: pixels from the window's left edge to the viewport's
            y: pixels from the window's top edge to the viewport's"""
        if type(x) is not float: x = number(x, "x")
        if type(y) is not float: y = number(y, "y")
        status = low.gphys_camera_set_viewport_origin(self._handle, x, y)
        if status < 0: check(status)

    def set_pick_start(self, start: int) -> None:
        """Where the rays of a perspective begin, for all functions that pick. From the near plane at
        creation; rays of other projections always begin there.
        Cost: O(1). Since 1.1."""
        if type(start) is not int or start >> 31: start = value(start, "start")
        status = low.gphys_camera_set_pick_start(self._handle, start)
        if status < 0: check(status)

    def get_projection(self) -> tuple[int, float, float, float]:
        """How the camera projects, as it was set.
        Cost: O(1).

        Returns:
            what of the following was called last: Camera.set_perspective, as at creation,
                Camera.set_orthographic (or those with a width of their own), or Camera.set_projection.
                the vertical field of view in radians of a perspective, the height in metres of an
                orthographic projection, 0 of a matrix. the distance of the near plane, metres; 0 of a
                matrix. that of the far plane; INFINITY without one; 0 of a matrix."""
        out_kind = ctypes.c_int32()
        out_size = ctypes.c_float()
        out_near = ctypes.c_float()
        out_far = ctypes.c_float()
        status = low.gphys_camera_get_projection(self._handle, ctypes.byref(out_kind), ctypes.byref(out_size), ctypes.byref(out_near), ctypes.byref(out_far))
        if status < 0: check(status)
        return out_kind.value, out_size.value, out_near.value, out_far.value

    def get_viewport(self) -> tuple[float, float]:
        """The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of
        the image.
        Cost: O(1)."""
        out_width = ctypes.c_float()
        out_height = ctypes.c_float()
        status = low.gphys_camera_get_viewport(self._handle, ctypes.byref(out_width), ctypes.byref(out_height))
        if status < 0: check(status)
        return out_width.value, out_height.value

    def get_viewport_origin(self) -> tuple[float, float]:
        """Where the viewport is in its window, in pixels, as it was set.
        Cost: O(1). Since 1.1."""
        out_x = ctypes.c_float()
        out_y = ctypes.c_float()
        status = low.gphys_camera_get_viewport_origin(self._handle, ctypes.byref(out_x), ctypes.byref(out_y))
        if status < 0: check(status)
        return out_x.value, out_y.value

    def get_aspect(self) -> tuple[float, bool]:
        """Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
        viewport.
        Cost: O(1). Since 1.1.

        Returns:
            1 if Camera.set_perspective_aspect or Camera.set_orthographic_size was the last to set the
                projection; 0 if it follows the viewport."""
        out_aspect = ctypes.c_float()
        out_is_fixed = ctypes.c_int32()
        status = low.gphys_camera_get_aspect(self._handle, ctypes.byref(out_aspect), ctypes.byref(out_is_fixed))
        if status < 0: check(status)
        return out_aspect.value, bool(out_is_fixed.value)

    def get_image_size(self) -> tuple[float, float]:
        """Width and height of what is seen, within an ulp: at a distance of one metre by a perspective
        (twice the tangents of half the angles; over the viewport's size, what a pixel spans there), at
        any distance by an orthographic projection, in metres as they were set; 0 by a matrix.
        Cost: O(1). Since 1.1."""
        out_width = ctypes.c_float()
        out_height = ctypes.c_float()
        status = low.gphys_camera_get_image_size(self._handle, ctypes.byref(out_width), ctypes.byref(out_height))
        if status < 0: check(status)
        return out_width.value, out_height.value

    def get_pick_start(self) -> int:
        """Where the rays of a perspective begin, as it was set.
        Cost: O(1). Since 1.1."""
        out_start = ctypes.c_int32()
        status = low.gphys_camera_get_pick_start(self._handle, ctypes.byref(out_start))
        if status < 0: check(status)
        return out_start.value

    def get_conventions(self) -> tuple[int, int, bool]:
        """What the camera was created with, as in CameraDesc.
        Cost: O(1). Since 1.1."""
        out_handedness = ctypes.c_int32()
        out_depth_range = ctypes.c_int32()
        out_reverse_z = ctypes.c_int32()
        status = low.gphys_camera_get_conventions(self._handle, ctypes.byref(out_handedness), ctypes.byref(out_depth_range), ctypes.byref(out_reverse_z))
        if status < 0: check(status)
        return out_handedness.value, out_depth_range.value, bool(out_reverse_z.value)

    def set_transform(self, position: VectorLike, rotation: VectorLike) -> None:
        """Place the camera.
        Cost: O(1).

        Args:
            position: metres, of its centre
            rotation: from its own axes to those of the world"""
        position_ = position if type(position) is low.Vec3 else value_of(position, low.Vec3, "position")
        rotation_ = rotation if type(rotation) is low.Quat else value_of(rotation, low.Quat, "rotation")
        status = low.gphys_camera_set_transform(self._handle, position_, rotation_)
        if status < 0: check(status)

    def set_world_matrix(self, world: low.Mat4 | ArrayLike) -> None:
        """Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
        kept, then up), so that a matrix which drifted is corrected.
        Cost: O(1).

        Raises:
            Error, status ERROR_SINGULAR: if the axes do not span space
            InvalidArgument: if they mirror or the last row is not 0 0 0 1"""
        world_ = matrix_of(world, low.Mat4, "world")
        status = low.gphys_camera_set_world_matrix(self._handle, world_)
        if status < 0: check(status)

    def set_view_matrix(self, view: low.Mat4 | ArrayLike) -> None:
        """Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
        Camera.set_world_matrix. That of Camera.get_view_matrix puts a camera back within 2^-22 of its
        distance from the origin and 2^-22 rad.
        Cost: O(1). Since 1.1.

        Raises:
            Error, status ERROR_SINGULAR: if the axes do not span space
            InvalidArgument: if they mirror, the last row is not 0 0 0 1, or the camera would be beyond
                MAX_COORDINATE"""
        view_ = matrix_of(view, low.Mat4, "view")
        status = low.gphys_camera_set_view_matrix(self._handle, view_)
        if status < 0: check(status)

    def look_at(self, eye: VectorLike, target: VectorLike, up: VectorLike) -> None:
        """Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
        chosen in its place, always the same for the same input.
        Cost: O(1).

        Raises:
            InvalidArgument: if eye equals target or up is zero"""
        eye_ = eye if type(eye) is low.Vec3 else value_of(eye, low.Vec3, "eye")
        target_ = target if type(target) is low.Vec3 else value_of(target, low.Vec3, "target")
        up_ = up if type(up) is low.Vec3 else value_of(up, low.Vec3, "up")
        status = low.gphys_camera_look_at(self._handle, eye_, target_, up_)
        if status < 0: check(status)

    def get_transform(self) -> tuple[low.Vec3, low.Quat]:
        """The camera's position, in metres, and its rotation, rounded to float32.
        Cost: O(1)."""
        out_position = low.Vec3()
        out_rotation = low.Quat()
        status = low.gphys_camera_get_transform(self._handle, ctypes.byref(out_position), ctypes.byref(out_rotation))
        if status < 0: check(status)
        return out_position, out_rotation

    def get_world_matrix(self) -> NDArray[np.float32]:
        """The matrix from camera to world.
        Cost: O(1)."""
        out_world = low.Mat4()
        status = low.gphys_camera_get_world_matrix(self._handle, ctypes.byref(out_world))
        if status < 0: check(status)
        return matrix(out_world)

    def get_view_matrix(self) -> NDArray[np.float32]:
        """The matrix from world to camera: the transpose of the orthonormal world axes, and the position
        transformed by it.
        Cost: O(1)."""
        out_view = low.Mat4()
        status = low.gphys_camera_get_view_matrix(self._handle, ctypes.byref(out_view))
        if status < 0: check(status)
        return matrix(out_view)

    def get_projection_matrix(self) -> NDArray[np.float32]:
        """The matrix from camera to clip space.
        Cost: O(1)."""
        out_projection = low.Mat4()
        status = low.gphys_camera_get_projection_matrix(self._handle, ctypes.byref(out_projection))
        if status < 0: check(status)
        return matrix(out_projection)

    def get_view_projection_matrix(self) -> NDArray[np.float32]:
        """Projection * view, multiplied in double precision and rounded once.
        Cost: O(1)."""
        out_view_projection = low.Mat4()
        status = low.gphys_camera_get_view_projection_matrix(self._handle, ctypes.byref(out_view_projection))
        if status < 0: check(status)
        return matrix(out_view_projection)

    def set_orbit(self, orbit: low.Orbit | StructLike) -> None:
        """Start orbiting with these settings; places the camera at once and drops pending input. An angle
        or a distance outside its limits is brought inside.
        Cost: O(1)."""
        orbit_ = orbit if type(orbit) is low.Orbit else value_of(orbit, low.Orbit, "orbit")
        status = low.gphys_camera_set_orbit(self._handle, orbit_)
        if status < 0: check(status)

    def get_orbit(self) -> low.Orbit:
        """The present settings, angles and distance of the orbit.
        Cost: O(1).

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        out_orbit = low.Orbit()
        status = low.gphys_camera_get_orbit(self._handle, ctypes.byref(out_orbit))
        if status < 0: check(status)
        return out_orbit

    def set_orbit_speeds(self, speeds: low.OrbitSpeeds | StructLike) -> None:
        """Set a speed for each input of the orbit, in place of the two of Orbit, which Camera.set_orbit
        starts from. Input since the last update uses the new speeds.
        Cost: O(1). Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        speeds_ = speeds if type(speeds) is low.OrbitSpeeds else value_of(speeds, low.OrbitSpeeds, "speeds")
        status = low.gphys_camera_set_orbit_speeds(self._handle, speeds_)
        if status < 0: check(status)

    def get_orbit_speeds(self) -> low.OrbitSpeeds:
        """The present speeds of the orbit's inputs.
        Cost: O(1). Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        out_speeds = low.OrbitSpeeds()
        status = low.gphys_camera_get_orbit_speeds(self._handle, ctypes.byref(out_speeds))
        if status < 0: check(status)
        return out_speeds

    def orbit_rotate(self, units_x: float, units_y: float) -> None:
        """Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit or the speeds
        that were set.
        Cost: O(1).

        Args:
            units_x, units_y: finite, any size

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        if type(units_x) is not float: units_x = number(units_x, "units_x")
        if type(units_y) is not float: units_y = number(units_y, "units_y")
        status = low.gphys_camera_orbit_rotate(self._handle, units_x, units_y)
        if status < 0: check(status)

    def orbit_zoom(self, units: float) -> None:
        """Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
        away if negative.
        Cost: O(1).

        Args:
            units: finite, any size

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        if type(units) is not float: units = number(units, "units")
        status = low.gphys_camera_orbit_zoom(self._handle, units)
        if status < 0: check(status)

    def orbit_pan(self, units_right: float, units_up: float) -> None:
        """Add input to the orbit: move the target to the camera's right and up, as the last update left
        them, by units times metres_per_unit or the speeds that were set.
        Cost: O(1).

        Args:
            units_right, units_up: finite, any size

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        if type(units_right) is not float: units_right = number(units_right, "units_right")
        if type(units_up) is not float: units_up = number(units_up, "units_up")
        status = low.gphys_camera_orbit_pan(self._handle, units_right, units_up)
        if status < 0: check(status)

    def orbit_update(self) -> None:
        """Apply the input since the last update, within the limits, and place the camera. Angles are
        wrapped to -pi .. pi in constant time.
        Cost: O(1).

        Raises:
            Error, status ERROR_UNSUPPORTED: if the camera was never set to orbit"""
        status = low.gphys_camera_orbit_update(self._handle)
        if status < 0: check(status)

    def get_frustum(self) -> low.Frustum:
        """The view frustum, with origin at the camera's position and planes from its parameters: each
        number within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
        Gribb-Hartmann in double precision.
        Cost: O(1)."""
        out_frustum = low.Frustum()
        status = low.gphys_camera_get_frustum(self._handle, ctypes.byref(out_frustum))
        if status < 0: check(status)
        return out_frustum

    def get_corners(self) -> NDArray[np.float32] | None:
        """World positions of the corners of the view frustum, in the order of gamephys.frustum_corners.
        Cost: O(1).

        Returns:
            None with an infinite far plane, or a corner beyond the largest float."""
        out_corners = np.empty(8, low.vec3_dtype)
        status = low.gphys_camera_get_corners(self._handle, out_corners.ctypes.data)
        if status < 0: check(status)
        return None if status else out_corners

    def get_rectangle_frustum(self, x0: float, y0: float, x1: float, y1: float) -> low.Frustum:
        """What is seen in a rectangle of pixels, as Camera.get_frustum: of a tile, a marquee, a portal.
        Cost: O(1). Since 1.1.

        Args:
            x0, y0: pixels, a corner of the rectangle; may lie outside the viewport
            x1, y1: pixels, the opposite corner, in any order; may lie outside the viewport

        Raises:
            InvalidArgument: if the rectangle has no area, or a side of what a matrix shows in it lies
                at infinity or beyond MAX_COORDINATE"""
        if type(x0) is not float: x0 = number(x0, "x0")
        if type(y0) is not float: y0 = number(y0, "y0")
        if type(x1) is not float: x1 = number(x1, "x1")
        if type(y1) is not float: y1 = number(y1, "y1")
        out_frustum = low.Frustum()
        status = low.gphys_camera_get_rectangle_frustum(self._handle, x0, y0, x1, y1, ctypes.byref(out_frustum))
        if status < 0: check(status)
        return out_frustum

    def get_rectangle_corners(self, x0: float, y0: float, x1: float, y1: float) -> NDArray[np.float32] | None:
        """World positions of the corners of what is seen in a rectangle of pixels, as Camera.get_corners.
        Cost: O(1). Since 1.1.

        Args:
            x0, y0, x1, y1: as Camera.get_rectangle_frustum

        Returns:
            None as Camera.get_corners."""
        if type(x0) is not float: x0 = number(x0, "x0")
        if type(y0) is not float: y0 = number(y0, "y0")
        if type(x1) is not float: x1 = number(x1, "x1")
        if type(y1) is not float: y1 = number(y1, "y1")
        out_corners = np.empty(8, low.vec3_dtype)
        status = low.gphys_camera_get_rectangle_corners(self._handle, x0, y0, x1, y1, out_corners.ctypes.data)
        if status < 0: check(status)
        return None if status else out_corners

    def project(self, point: VectorLike) -> low.Vec3 | None:
        """World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
        viewport; z is the depth in the camera's range.
        Cost: O(1).

        Returns:
            None if the point is not in front of the camera's centre (no image), or its image lies
                beyond the range of coordinates."""
        point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
        out_pixel = low.Vec3()
        status = low.gphys_camera_project(self._handle, point_, ctypes.byref(out_pixel))
        if status < 0: check(status)
        return None if status else out_pixel

    def project_batch(self, points: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Pixels of count world points, as Camera.project; a point without an image gets x = y = z =
        INFINITY.
        Cost: O(elements).

        Args:
            points: metres"""
        points_ = array_of(points, low.vec3_dtype)
        count = common_length(points_)
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_camera_project_batch(self._handle, points_.address, points_.stride, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def unproject(self, pixel: VectorLike) -> low.Vec3 | None:
        """Pixel and depth to world point: the inverse of Camera.project.
        Cost: O(1).

        Returns:
            None for the depth of an infinite far plane, and for points beyond that or beyond the range
                of coordinates."""
        pixel_ = pixel if type(pixel) is low.Vec3 else value_of(pixel, low.Vec3, "pixel")
        out_point = low.Vec3()
        status = low.gphys_camera_unproject(self._handle, pixel_, ctypes.byref(out_point))
        if status < 0: check(status)
        return None if status else out_point

    def unproject_batch(self, pixels: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """World points of the pixels with depth, as Camera.unproject; one at infinity gets x = y = z =
        INFINITY.
        Cost: O(elements).

        Args:
            pixels: x, y in pixels, z the depth"""
        pixels_ = array_of(pixels, low.vec3_dtype)
        count = common_length(pixels_)
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_camera_unproject_batch(self._handle, pixels_.address, pixels_.stride, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def pick_ray(self, pixel_x: float, pixel_y: float) -> low.Ray | None:
        """The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
        (INFINITY without one). With PICK_FROM_CENTRE that of a perspective starts at the camera's
        position. Its image is within 1e-3 pixel of the given one or, for fields of view below about 3
        degrees, within half an ulp of its direction. Its start is rounded to float32, too, which moves
        the ray by half an ulp of the coordinates (but not from the camera's position, which has float
        coordinates); Camera.pick is not limited in this way.
        Cost: O(1).

        Args:
            pixel_x, pixel_y: pixels; may lie outside the viewport

        Returns:
            None if the line of sight does not meet the near plane (user projections), or would begin
                beyond MAX_COORDINATE."""
        if type(pixel_x) is not float: pixel_x = number(pixel_x, "pixel_x")
        if type(pixel_y) is not float: pixel_y = number(pixel_y, "pixel_y")
        out_ray = low.Ray()
        status = low.gphys_camera_pick_ray(self._handle, pixel_x, pixel_y, ctypes.byref(out_ray))
        if status < 0: check(status)
        return None if status else out_ray

    def pick_rays(self, x: int, y: int, width: int, height: int, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Rays for a rectangle of pixel centres, as Camera.pick_ray, row by row.
        Cost: O(width * height).

        Args:
            x: the left column of the rectangle
            y: its top row
            width: its columns
            height: its rows; width * height fewer than 2^32"""
        if type(x) is not int or x >> 32: x = whole(x, "x")
        if type(y) is not int or y >> 32: y = whole(y, "y")
        if type(width) is not int or width >> 32: width = whole(width, "width")
        if type(height) is not int or height >> 32: height = whole(height, "height")
        out_ = result_array(out, width * height, low.ray_dtype)
        status = low.gphys_camera_pick_rays(self._handle, x, y, width, height, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def pick(self, scene: Scene | None, pixel_x: float, pixel_y: float, layers: int = low.ALL_LAYERS) -> low.Hit | None:
        """The model under a pixel: the first hit of Camera.pick_ray, before that is rounded to float32; t
        is in metres from where it starts.
        Cost: O(log n) expected.

        Args:
            pixel_x, pixel_y: pixels; may lie outside the viewport

        Returns:
            None if nothing is found."""
        if type(pixel_x) is not float: pixel_x = number(pixel_x, "pixel_x")
        if type(pixel_y) is not float: pixel_y = number(pixel_y, "pixel_y")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        out_hit = low.Hit()
        status = low.gphys_camera_pick(self._handle, handle_of(scene, Scene), pixel_x, pixel_y, layers, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def pick_batch(self, scene: Scene | None, pixels: ArrayLike, layers: int = low.ALL_LAYERS, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """The models under the pixels, as Camera.pick; a pixel without one gets model = 0 and t =
        INFINITY.
        Cost: at most that of as many single calls; shared among the scene's workers.

        Args:
            pixels: x, y pairs of floats"""
        pixels_ = array_of(pixels, "<f4", 2)
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        count = common_length(pixels_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_camera_pick_batch(self._handle, handle_of(scene, Scene), pixels_.address, pixels_.stride, count, layers, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def pick_rectangle(self, scene: Scene | None, x0: float, y0: float, x1: float, y1: float, layers: int = low.ALL_LAYERS) -> NDArray[np.uint32]:
        """Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far
        plane; tested by their exact shapes, ascending.
        Cost: that of Scene.overlap.

        Args:
            x0, y0: pixels, a corner of the rectangle; may lie outside the viewport
            x1, y1: pixels, the opposite corner, in any order; may lie outside the viewport

        Raises:
            InvalidArgument: if the rectangle has no area"""
        if type(x0) is not float: x0 = number(x0, "x0")
        if type(y0) is not float: y0 = number(y0, "y0")
        if type(x1) is not float: x1 = number(x1, "x1")
        if type(y1) is not float: y1 = number(y1, "y1")
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_camera_pick_rectangle, (self._handle, handle_of(scene, Scene), x0, y0, x1, y1, layers,), "<u4")

    def cull(self, scene: Scene | None, layers: int = low.ALL_LAYERS) -> NDArray[np.uint32]:
        """Ids of the models to draw: Scene.cull with the camera's frustum.
        Cost: O(log n + k) expected."""
        if type(layers) is not int or layers >> 32: layers = mask(layers, "layers")
        return list_of(low.gphys_camera_cull, (self._handle, handle_of(scene, Scene), layers,), "<u4")

    def pick_filtered(self, scene: Scene | None, pixel_x: float, pixel_y: float, filter: low.QueryFilterDesc | None = None) -> low.Hit | None:
        """The model under a pixel that the filter sees, as Camera.pick: what lies behind a selection.
        Cost: as Scene.raycast_filtered.

        Args:
            pixel_x, pixel_y: pixels; may lie outside the viewport
            filter: None: the defaults

        Returns:
            None if nothing is found."""
        if type(pixel_x) is not float: pixel_x = number(pixel_x, "pixel_x")
        if type(pixel_y) is not float: pixel_y = number(pixel_y, "pixel_y")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        out_hit = low.Hit()
        status = low.gphys_camera_pick_filtered(self._handle, handle_of(scene, Scene), pixel_x, pixel_y, filter_, ctypes.byref(out_hit))
        if status < 0: check(status)
        return None if status else out_hit

    def pick_filtered_batch(self, scene: Scene | None, pixels: ArrayLike, filters: NDArray[np.void] | Sequence[low.QueryFilterDesc] | low.QueryFilterDesc | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """The models under the pixels that the filters see, as Camera.pick_batch.
        Cost: at most that of as many single calls; shared among the scene's workers.

        Args:
            pixels: x, y pairs of floats
            filters: None: the defaults"""
        pixels_ = array_of(pixels, "<f4", 2)
        filters_ = descs_of(filters, low.QueryFilterDesc)
        count = common_length(pixels_, filters_)
        out_ = result_array(out, count, low.hit_dtype)
        status = low.gphys_camera_pick_filtered_batch(self._handle, handle_of(scene, Scene), pixels_.address, pixels_.stride, count, filters_.address, filters_.stride, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def pick_rectangle_filtered(self, scene: Scene | None, x0: float, y0: float, x1: float, y1: float, filter: low.QueryFilterDesc | None = None) -> NDArray[np.uint32]:
        """Marquee: ids of all models in the pixel rectangle that the filter sees, as
        Camera.pick_rectangle.
        Cost: as Scene.overlap_filtered.

        Args:
            x0, y0: pixels, a corner of the rectangle
            x1, y1: pixels, the opposite corner, in any order
            filter: None: the defaults"""
        if type(x0) is not float: x0 = number(x0, "x0")
        if type(y0) is not float: y0 = number(y0, "y0")
        if type(x1) is not float: x1 = number(x1, "x1")
        if type(y1) is not float: y1 = number(y1, "y1")
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_camera_pick_rectangle_filtered, (self._handle, handle_of(scene, Scene), x0, y0, x1, y1, filter_,), "<u4")

    def cull_filtered(self, scene: Scene | None, filter: low.QueryFilterDesc | None = None) -> NDArray[np.uint32]:
        """Ids of the models to draw that the filter sees: Scene.cull_filtered with the camera's frustum.
        Cost: as Scene.cull_filtered.

        Args:
            filter: None: the defaults"""
        filter_ = filter if filter is None else value_of(filter, low.QueryFilterDesc, "filter")
        return list_of(low.gphys_camera_cull_filtered, (self._handle, handle_of(scene, Scene), filter_,), "<u4")



class Solver(Bodies):
    """Create a solver without bodies. With a worker_count of n, n threads share the bodies of a step;
    the results have the same bits for every n. Threads are started, joined and lost as those of
    Scene.
    Cost: O(1), and that of starting the threads.

    Args:
        desc: None: the defaults

    Raises:
        OutOfMemory: also if the threads cannot be started"""
    _destroy = low.gphys_solver_destroy

    def __init__(self, desc: low.SolverDesc | None = None) -> None:
        desc_ = desc if desc is None else value_of(desc, low.SolverDesc, "desc")
        handle = ctypes.c_void_p()
        check(low.gphys_solver_create(desc_, ctypes.byref(handle)))
        self._own(handle.value)

    def set_worker_count(self, workers: int) -> None:
        """Change the number of threads that share the steps of a solver, as Scene.set_worker_count. The
        bits of the motion stay the same.
        Cost: as Scene.set_worker_count; allocates. Since 1.1.

        Args:
            workers: as SolverDesc.worker_count

        Raises:
            OutOfMemory: also if the threads cannot be started; the former ones are kept"""
        if type(workers) is not int or workers >> 32: workers = whole(workers, "workers")
        status = low.gphys_solver_set_worker_count(self._handle, workers)
        if status < 0: check(status)

    def get_worker_count(self) -> int:
        """How many threads share the steps of a solver, as Scene.get_worker_count.
        Cost: O(1). Since 1.1."""
        out_workers = ctypes.c_uint32()
        status = low.gphys_solver_get_worker_count(self._handle, ctypes.byref(out_workers))
        if status < 0: check(status)
        return out_workers.value

    def set_origin(self, origin: ArrayLike) -> None:
        """Move the point of the world that the coordinates of all particles count from; see
        Scene.set_origin. Particles stay where they are in the world and keep moving as they do. A step
        and an attachment need a scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
        Cost: O(particles).

        Args:
            origin: x, y, z in the world, metres, within MAX_COORDINATE

        Raises:
            InvalidArgument: also if a particle or an animation target would leave the range of
                coordinates"""
        origin_ = numbers_of(origin, "<f8", 3)
        status = low.gphys_solver_set_origin(self._handle, origin_.address)
        if status < 0: check(status)

    def get_origin(self) -> NDArray[np.float64]:
        """Where in the world the particles' coordinates count from, metres.
        Cost: O(1)."""
        out_origin = np.empty(3, "<f8")
        status = low.gphys_solver_get_origin(self._handle, out_origin.ctypes.data)
        if status < 0: check(status)
        return out_origin

    def set_gravity(self, gravity: VectorLike) -> None:
        """Change the acceleration of all particles, from the next step on. Wakes all bodies if it changes.
        Cost: O(bodies).

        Args:
            gravity: m/s^2; may be zero"""
        gravity_ = gravity if type(gravity) is low.Vec3 else value_of(gravity, low.Vec3, "gravity")
        status = low.gphys_solver_set_gravity(self._handle, gravity_)
        if status < 0: check(status)

    def set_substeps(self, substeps: int) -> None:
        """Change the number of substeps of a step. More substeps: smaller errors, proportionally more
        time. The error of motion goes with the square of their length. Ropes that move calmly - in a
        substep no link turns by half a radian, or would swing by one if its ends were pushed - make
        each in two stages (TR-BDF2; Bank et al. 1985): twice the time, a seventh of the error.
        Cost: O(1).

        Args:
            substeps: 1 .. 1000"""
        if type(substeps) is not int or substeps >> 32: substeps = whole(substeps, "substeps")
        status = low.gphys_solver_set_substeps(self._handle, substeps)
        if status < 0: check(status)

    def get_settings(self) -> low.SolverSettings:
        """The settings of a solver as they are.
        Cost: O(1)."""
        out_settings = low.SolverSettings()
        status = low.gphys_solver_get_settings(self._handle, ctypes.byref(out_settings))
        if status < 0: check(status)
        return out_settings

    def set_settings(self, settings: low.SolverSettings | StructLike) -> None:
        """Change all settings, from the next step on. Read them, change some, and give them back. Bodies
        wake if gravity or the settings of sleep change. Time that Solver.advance owes beyond the new
        fixed_step is dropped.
        Cost: O(bodies)."""
        settings_ = settings if type(settings) is low.SolverSettings else value_of(settings, low.SolverSettings, "settings")
        status = low.gphys_solver_set_settings(self._handle, settings_)
        if status < 0: check(status)

    def add_particles(self, positions: ArrayLike, desc: low.BodyDesc | None = None) -> int:
        """Add a body of particles without constraints.
        Cost: O(elements).

        Args:
            desc: None: the defaults
            positions: metres

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies"""
        desc_ = desc if desc is None else value_of(desc, low.BodyDesc, "desc")
        positions_ = array_of(positions, low.vec3_dtype)
        out_body = ctypes.c_uint32()
        count = common_length(positions_)
        status = low.gphys_solver_add_particles(self._handle, desc_, positions_.address, positions_.stride, count, ctypes.byref(out_body))
        if status < 0: check(status)
        return out_body.value

    def add_rope(self, positions: ArrayLike, link_length: float = 0, desc: low.BodyDesc | None = None) -> int:
        """Add a rope through the given points, one particle at each.
        Cost: O(elements).

        Args:
            desc: None: the defaults
            positions: metres
            link_length: rest length of each link in metres; 0: as placed. A length below 1e-9 m counts
                as 0. Rigid links get their lengths in the first step, and the particles no speed by it.

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies"""
        desc_ = desc if desc is None else value_of(desc, low.BodyDesc, "desc")
        positions_ = array_of(positions, low.vec3_dtype)
        if type(link_length) is not float: link_length = number(link_length, "link_length")
        out_body = ctypes.c_uint32()
        count = common_length(positions_)
        status = low.gphys_solver_add_rope(self._handle, desc_, positions_.address, positions_.stride, count, link_length, ctypes.byref(out_body))
        if status < 0: check(status)
        return out_body.value

    def add_cloth(self, corner: VectorLike, edge_u: VectorLike, edge_v: VectorLike, columns: int, rows: int, desc: low.BodyDesc | None = None) -> int:
        """Add a rectangle of cloth: particle (column, row) is number row * columns + column and stands at
        corner + column / (columns - 1) * edge_u + row / (rows - 1) * edge_v. Its constraints, in the
        order of their ids, are those from row to row, those from column to column, both diagonals
        (CLOTH_SHEAR), and those that resist folding (CLOTH_BEND); Solver.set_constraint_settings makes
        them softer or stiffer later.
        Cost: O(columns * rows).

        Args:
            desc: None: the defaults
            corner: metres
            edge_u: metres, from the corner along a row
            edge_v: metres, from the corner along a column
            columns, rows: >= 2

        Raises:
            InvalidArgument: if the edges are parallel or zero
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 particles, links or bodies"""
        desc_ = desc if desc is None else value_of(desc, low.BodyDesc, "desc")
        corner_ = corner if type(corner) is low.Vec3 else value_of(corner, low.Vec3, "corner")
        edge_u_ = edge_u if type(edge_u) is low.Vec3 else value_of(edge_u, low.Vec3, "edge_u")
        edge_v_ = edge_v if type(edge_v) is low.Vec3 else value_of(edge_v, low.Vec3, "edge_v")
        if type(columns) is not int or columns >> 32: columns = whole(columns, "columns")
        if type(rows) is not int or rows >> 32: rows = whole(rows, "rows")
        out_body = ctypes.c_uint32()
        status = low.gphys_solver_add_cloth(self._handle, desc_, corner_, edge_u_, edge_v_, columns, rows, ctypes.byref(out_body))
        if status < 0: check(status)
        return out_body.value

    def add_cloth_mesh(self, mesh: Mesh | None, transform: low.Transform | StructLike | None = None, desc: low.BodyDesc | None = None) -> int:
        """Add cloth in the form of a mesh: a particle at each vertex, a constraint along each edge, and
        with CLOTH_BEND one across each inner edge, whose ids come after those of the edges. Vertices at
        the same place stay separate: an edge shorter than 1e-9 m, as at the poles of many imported
        balls, has a rest length of 0.
        Cost: O(n log n).

        Args:
            desc: None: the defaults
            transform: places the mesh; None is the identity

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 particles or bodies
            Error, status ERROR_UNSUPPORTED: for a mesh made from a rope or from particles, which has no
                triangles"""
        desc_ = desc if desc is None else value_of(desc, low.BodyDesc, "desc")
        transform_ = transform if transform is None else value_of(transform, low.Transform, "transform")
        out_body = ctypes.c_uint32()
        status = low.gphys_solver_add_cloth_mesh(self._handle, desc_, handle_of(mesh, Mesh), transform_, ctypes.byref(out_body))
        if status < 0: check(status)
        return out_body.value

    def remove_body(self, body: int) -> None:
        """Remove a body with its constraints and joints. Its id stays invalid. The impulses that it gave
        in the last step are no longer listed.
        Cost: O(particles + constraints of the body), O(joints of the solver), and O(bodies that gave
        impulses to the same models)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        status = low.gphys_solver_remove_body(self._handle, body)
        if status < 0: check(status)

    def get_bodies(self) -> NDArray[np.uint32]:
        """Ids of all bodies, ascending.
        Cost: O(bodies)."""
        return list_of(low.gphys_solver_get_bodies, (self._handle,), "<u4")

    def get_sleeping(self) -> NDArray[np.uint32]:
        """Ids of the bodies that are asleep, ascending. A body falls asleep at the end of a step when for
        sleep_time seconds no particle was faster than sleep_speed and no rigid constraint strained by
        more than sleep_strain; cloth, when its root mean square speed from step to step was no higher,
        no particle ten times as fast, and strain, without a max_strain, at most 3 %, that of diagonals
        of cells apart: these yield, on sharp and round models by a tenth and more. Its speed is then 0,
        it keeps its contacts, and a step costs it one query for models nearby. It wakes in the next
        step after a model within reach (as far as one could move in a step at 50 m/s) was added,
        removed or moved, or a model that it is attached to, or after the scene was replaced; and at
        once by any change of its state, of gravity or of the origin. Cloth is brought to rest, whatever
        sleep_speed is, once friction holds it on models that stand still and it moves by centimetres a
        second without sagging further: within a second it is slowed down to 0. It moves again when one
        of these models or the body changes. Not in wind, with joints, animation targets, clusters or a
        volume, or near other bodies.
        Cost: O(bodies)."""
        return list_of(low.gphys_solver_get_sleeping, (self._handle,), "<u4")

    def wake(self, body: int) -> None:
        """Wake a body; its time of rest begins again.
        Cost: O(1) a body.

        Args:
            body: 0: all"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        status = low.gphys_solver_wake(self._handle, body)
        if status < 0: check(status)

    def get_body_settings(self, body: int) -> low.BodySettings:
        """The present settings of a body; static_friction as it acts, at least friction.
        Cost: O(1)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_settings = low.BodySettings()
        status = low.gphys_solver_get_body_settings(self._handle, body, ctypes.byref(out_settings))
        if status < 0: check(status)
        return out_settings

    def set_body_settings(self, body: int, settings: low.BodySettings | StructLike) -> None:
        """Change all settings of a body, from the next step on: read them, change some, and give them
        back. Wakes the body.
        Cost: O(1); O(particles) when self_collision changes, and it allocates."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        settings_ = settings if type(settings) is low.BodySettings else value_of(settings, low.BodySettings, "settings")
        status = low.gphys_solver_set_body_settings(self._handle, body, settings_)
        if status < 0: check(status)

    def get_body_info(self, body: int) -> low.BodyInfo:
        """What a body is made of and how it is solved.
        Cost: O(1); after a change of constraints O(particles), and it allocates."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_info = low.BodyInfo()
        status = low.gphys_solver_get_body_info(self._handle, body, ctypes.byref(out_info))
        if status < 0: check(status)
        return out_info

    def get_triangles(self, body: int) -> NDArray[np.uint32]:
        """Particle numbers of a cloth's triangles, three each, for drawing. Where cloth tears (Break) they
        change, and their number does not.
        Cost: O(triangles)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        return list_of(low.gphys_solver_get_triangles, (self._handle, body,), "<u4")

    def get_nearest_particle(self, body: int, triangle: int, point: VectorLike) -> int:
        """The particle of a body nearest to a point, for example to grab it; of equally near ones the
        lowest.
        Cost: O(1); O(particles) for NO_TRIANGLE. Since 1.1.

        Args:
            triangle: as in a hit, nearest or penetration of the body's mesh: its corners are compared,
                of a rope the ends of the link, or the particle; NO_TRIANGLE: all particles
            point: metres, in the solver's coordinates: that of the hit

        Raises:
            InvalidArgument: also if the mesh has no such triangle"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(triangle) is not int or triangle >> 32: triangle = whole(triangle, "triangle")
        point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
        out_particle = ctypes.c_uint32()
        status = low.gphys_solver_get_nearest_particle(self._handle, body, triangle, point_, ctypes.byref(out_particle))
        if status < 0: check(status)
        return out_particle.value

    def get_positions(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Where the particles are, metres.
        Cost: O(count).

        Args:
            first: the first particle
            count: how many from there on; a range beyond the body is ERROR_INVALID_ARGUMENT"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_solver_get_positions(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_positions(self, body: int, first: int, positions: ArrayLike) -> None:
        """Move particles at once and without collision on the way; velocities stay as they are. Wakes the
        body. Rigid links that are too long or too short then get their lengths in the next step, and
        the particles no speed by it. Pinned particles that are moved alone pull the others: during the
        next step they go evenly from where they were to their new places, as attached ones do. They are
        placed at once before the body's first step, or if a free particle of the body is placed as
        well.
        Cost: O(elements).

        Args:
            first: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        positions_ = array_of(positions, low.vec3_dtype)
        count = common_length(positions_)
        status = low.gphys_solver_set_positions(self._handle, body, first, count, positions_.address, positions_.stride)
        if status < 0: check(status)

    def get_velocities(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """How fast the particles are, m/s.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions

        Returns:
            0 of what is pinned and stands still."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_solver_get_velocities(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_velocities(self, body: int, first: int, velocities: ArrayLike) -> None:
        """Give particles a velocity, which the next step starts from. Wakes the body. Pinned particles
        keep 0.
        Cost: O(elements).

        Args:
            first: as in Solver.get_positions
            velocities: m/s"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        velocities_ = array_of(velocities, low.vec3_dtype)
        count = common_length(velocities_)
        status = low.gphys_solver_set_velocities(self._handle, body, first, count, velocities_.address, velocities_.stride)
        if status < 0: check(status)

    def get_masses(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Masses of particles, kg. That of a pinned particle is what it has when it is released.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, "<f4")
        status = low.gphys_solver_get_masses(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_masses(self, body: int, first: int, masses: ArrayLike) -> None:
        """Change the masses of particles. A pinned particle keeps its mass for the time when it is
        released. Wakes the body.
        Cost: O(elements).

        Args:
            first: as in Solver.get_positions
            masses: kg, > 0"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        masses_ = array_of(masses, "<f4")
        count = common_length(masses_)
        status = low.gphys_solver_set_masses(self._handle, body, first, count, masses_.address, masses_.stride)
        if status < 0: check(status)

    def get_radii(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Collision radii of particles, metres.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, "<f4")
        status = low.gphys_solver_get_radii(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_radii(self, body: int, first: int, radii: ArrayLike) -> None:
        """Change the collision radii of particles. Wakes the body.
        Cost: O(elements).

        Args:
            first: as in Solver.get_positions
            radii: metres, >= 0"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        radii_ = array_of(radii, "<f4")
        count = common_length(radii_)
        status = low.gphys_solver_set_radii(self._handle, body, first, count, radii_.address, radii_.stride)
        if status < 0: check(status)

    def get_friction_factors(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Friction factors of particles; 1 until they are set.
        Cost: O(count). Since 1.1.

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, "<f4")
        status = low.gphys_solver_get_friction_factors(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_friction_factors(self, body: int, first: int, factors: ArrayLike) -> None:
        """Give particles more or less friction than their body has: ice, a sticky hem, a worn patch. In
        every contact, with models and with particles, the coefficients of a particle are the friction
        and the static_friction of its body times its factor. A body with a friction of 1 thus has the
        factors for coefficients; Solver.set_body_settings scales them all and keeps the factors. Wakes
        the body.
        Cost: O(elements); the first factor other than 1 O(particles), and it allocates. Since 1.1.

        Args:
            first: as in Solver.get_positions
            factors: >= 0"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        factors_ = array_of(factors, "<f4")
        count = common_length(factors_)
        status = low.gphys_solver_set_friction_factors(self._handle, body, first, count, factors_.address, factors_.stride)
        if status < 0: check(status)

    def get_forces(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """The forces that were set for particles, newtons.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_solver_get_forces(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_forces(self, body: int, first: int, forces: ArrayLike) -> None:
        """Set the forces that act on particles beside gravity, from now on until set again. Wakes the
        body.
        Cost: O(elements).

        Args:
            first: as in Solver.get_positions
            forces: newtons"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        forces_ = array_of(forces, low.vec3_dtype)
        count = common_length(forces_)
        status = low.gphys_solver_set_forces(self._handle, body, first, count, forces_.address, forces_.stride)
        if status < 0: check(status)

    def get_pinned(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
        """Which particles are pinned or attached.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, "<i4")
        status = low.gphys_solver_get_pinned(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_pinned(self, body: int, first: int = 0, count: int | None = None, pinned: bool = True) -> None:
        """Pin or release particles. A pinned particle stays where it is put and moves only by
        Solver.set_positions, or with an animation target of max_distance 0; else its speed is 0. Both
        pinning and releasing end an attachment.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions
            pinned: True: pin; False: release"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        if type(pinned) is not bool: pinned = flag(pinned, "pinned")
        status = low.gphys_solver_set_pinned(self._handle, body, first, count, pinned)
        if status < 0: check(status)

    def set_wind(self, body: int, wind: low.Wind | StructLike) -> None:
        """Put a body into moving air. Until this is called there is none. Wakes the body. With u the
        velocity relative to the air, the force is on a triangle of cloth -rho/2 A |u| ((C_D cos a - C_L
        cos^2 a) u + C_L (u . n) n), cos a = |u . n| / |u|, the first term not below 0: drag as A cos a,
        which is what the wind sees of it, and lift across the wind as sin a cos a (Keckeisen et al.
        2004, "Modelling effects of wind fields in cloth animations"); with C_L = C_D it is nearly the
        pressure on a plate, along n; on a link of a rope -rho/2 C_D 2 r l |u'| u', u' the part of u
        across it, r the radius (the cross-flow principle: Hoerner 1965, "Fluid-dynamic drag"); on a
        free particle -rho/2 C_D pi r^2 |u| u. Strong wind carries bodies along but never overshoots:
        whatever the density, a substep does not reverse u. The drag of a free particle is of second
        order in the substep; that of a link is the one at the beginning of the step.
        Cost: O(1) a body; in each substep of cloth some 370 instructions a triangle, in each step of a
        rope as many for each link; some 100 for each free particle, as often as drag takes 1/32 of a
        speed.

        Args:
            body: 0: all bodies there are
            wind: of density 0: no air"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        wind_ = wind if type(wind) is low.Wind else value_of(wind, low.Wind, "wind")
        status = low.gphys_solver_set_wind(self._handle, body, wind_)
        if status < 0: check(status)

    def get_wind(self, body: int) -> low.Wind:
        """The air around a body as it was set; zeros if it was not.
        Cost: O(1)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_wind = low.Wind()
        status = low.gphys_solver_get_wind(self._handle, body, ctypes.byref(out_wind))
        if status < 0: check(status)
        return out_wind

    def set_air_velocities(self, body: int, first: int, velocities: ArrayLike) -> None:
        """Give the air at particles a velocity beside that of Wind, from now on until set again: gusts,
        eddies, a field of your own that is sampled at the particles' positions. Wakes the body.
        Cost: O(elements); the first time O(particles), and it allocates.

        Args:
            first: as in Solver.get_positions
            velocities: m/s"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        velocities_ = array_of(velocities, low.vec3_dtype)
        count = common_length(velocities_)
        status = low.gphys_solver_set_air_velocities(self._handle, body, first, count, velocities_.address, velocities_.stride)
        if status < 0: check(status)

    def get_air_velocities(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """Velocities of the air at particles, m/s, beside that of Wind.
        Cost: O(count).

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, low.vec3_dtype)
        status = low.gphys_solver_get_air_velocities(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_animation_targets(self, body: int, first: int, targets: ArrayLike) -> None:
        """Give particles animation targets, before each step that is to follow an animation: a cape or
        skirt that is skinned to its character stays within max_distance of the skinned vertices and
        does not sink into the body behind them. In the next step position and normal go evenly from the
        old target to the new one, substep by substep; distances act at once. A target that is not set
        again stands still. A first target, and that of a particle which Solver.set_positions has moved
        since the last step, takes effect at its new place at once: to teleport, make that call and this
        one. If the body is attached to a model that jumps (Solver.step), this call alone is enough.
        max_distance 0 carries a particle: it is at its target, as if attached there, and moves links
        with infinite mass; this also moves a pinned particle, which stays pinned, at constant speed
        during a step. Otherwise particles that are pinned or attached are not moved. A particle that is
        out of its bounds at the end of a substep is put on the nearest place within both, without
        friction; its velocity across them is then that of the target. What lies within its bounds is
        not touched. Bounds act after constraints and before models: where a target is inside a model,
        or behind one, the particle stays outside. Links yield to bounds that contradict them. What
        hangs from a particle at its bounds is carried, in cloth and in ropes that are moved alone;
        ropes and free particles that are joined, or collide with bodies, are put back particle by
        particle, and links beside these may be strained by the motion of a substep. Wakes the body if a
        target changes.
        Cost: O(elements); the first time O(particles), and it allocates. In each substep some 100 ns a
        particle; ropes with targets are solved one by one, as those that touch models. Since 1.1.

        Args:
            first: as in Solver.get_positions
            targets: max_distance and backstop INFINITY: no target any more"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        targets_ = array_of(targets, low.animation_target_dtype)
        count = common_length(targets_)
        status = low.gphys_solver_set_animation_targets(self._handle, body, first, count, targets_.address, targets_.stride)
        if status < 0: check(status)

    def get_animation_targets(self, body: int, first: int = 0, count: int | None = None, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """Animation targets of particles as they were set; 0 and INFINITY of what has none.
        Cost: O(count). Since 1.1.

        Args:
            first, count: as in Solver.get_positions"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(first) is not int or first >> 32: first = whole(first, "first")
        if count is None: count = self._rest(body, first)
        if type(count) is not int or count >> 32: count = whole(count, "count")
        out_ = result_array(out, count, low.animation_target_dtype)
        status = low.gphys_solver_get_animation_targets(self._handle, body, first, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def attach(self, scene: Scene | None, body: int, particle: int, model: int, local_point: VectorLike | None = None) -> None:
        """Fix a particle to a model: it follows the model's transform in each step, and is released when
        the model is gone. Steps must then be given this scene; in a step without one the particle stays
        where it is. If the model jumps (Solver.step), the whole body goes with it as if it were rigid,
        and its velocities turn with it: a cape stays on a character that respawns. Bodies with other
        pinned particles, joints, or attachments to models that go elsewhere do not, nor do bodies
        without constraints.
        Cost: O(1); allocates.

        Args:
            scene: of the same origin as the solver; not modified
            local_point: in the model's coordinates, to which its transform applies, with the
                transform's scale, and not Scene.set_scale; None: where the particle is now

        Raises:
            InvalidArgument: for a particle that does not exist"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(particle) is not int or particle >> 32: particle = whole(particle, "particle")
        if type(model) is not int or model >> 32: model = whole(model, "model")
        local_point_ = local_point if local_point is None else value_of(local_point, low.Vec3, "local_point")
        status = low.gphys_solver_attach(self._handle, handle_of(scene, Scene), body, particle, model, local_point_)
        if status < 0: check(status)

    def detach(self, body: int, particle: int) -> None:
        """Release an attached particle.
        Cost: O(1).

        Raises:
            InvalidArgument: if it is not attached, or does not exist"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(particle) is not int or particle >> 32: particle = whole(particle, "particle")
        status = low.gphys_solver_detach(self._handle, body, particle)
        if status < 0: check(status)

    def get_attachments(self, body: int) -> NDArray[np.void]:
        """The attachments of a body, by particle. One to a model that is gone is listed until the next
        step.
        Cost: O(attachments). Since 1.1."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        return list_of(low.gphys_solver_get_attachments, (self._handle, body,), low.attachment_dtype)

    def add_distance(self, body: int, particle_a: int, particle_b: int, rest_length: float, compliance: float = 0) -> int:
        """Hold two different particles of a body at a distance.
        Cost: O(1); the next step plans the body again, O(constraints).

        Args:
            rest_length: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
            compliance: metres per newton, >= 0; 0 is rigid

        Raises:
            InvalidArgument: for a particle that does not exist or twice the same one
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 constraints of a body"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(particle_a) is not int or particle_a >> 32: particle_a = whole(particle_a, "particle_a")
        if type(particle_b) is not int or particle_b >> 32: particle_b = whole(particle_b, "particle_b")
        if type(rest_length) is not float: rest_length = number(rest_length, "rest_length")
        if type(compliance) is not float: compliance = number(compliance, "compliance")
        out_constraint = ctypes.c_uint32()
        status = low.gphys_solver_add_distance(self._handle, body, particle_a, particle_b, rest_length, compliance, ctypes.byref(out_constraint))
        if status < 0: check(status)
        return out_constraint.value

    def add_max_distance(self, body: int, particle_a: int, particle_b: int, max_length: float, compliance: float = 0) -> int:
        """Keep two different particles of a body from being further apart than a length, like a string
        between them: it pulls and never pushes. While it is slack it does nothing; when it becomes
        taut, and is rigid, only the speed at which the particles separate is lost.
        Fails as Solver.add_distance.
        It is a constraint like others: listed with max_length as its rest_length, removed as they are,
        and strained only when it is too long.
        Cost: as Solver.add_distance.

        Args:
            max_length: metres, >= 0; negative: the present distance. Below 1e-9 m it counts as 0.
            compliance: metres per newton, >= 0, of what it yields beyond that; 0 is rigid"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(particle_a) is not int or particle_a >> 32: particle_a = whole(particle_a, "particle_a")
        if type(particle_b) is not int or particle_b >> 32: particle_b = whole(particle_b, "particle_b")
        if type(max_length) is not float: max_length = number(max_length, "max_length")
        if type(compliance) is not float: compliance = number(compliance, "compliance")
        out_constraint = ctypes.c_uint32()
        status = low.gphys_solver_add_max_distance(self._handle, body, particle_a, particle_b, max_length, compliance, ctypes.byref(out_constraint))
        if status < 0: check(status)
        return out_constraint.value

    def set_constraint_damping(self, body: int, constraint: int, damping: float) -> None:
        """Damp a constraint that has compliance: when its ends separate at speed v, it pulls with damping
        * v in addition to its tension; one of Solver.add_max_distance never pushes. The decay depends
        on time, not on steps. Rigid constraints have nothing to damp.
        Cost: as Solver.add_distance.

        Args:
            damping: N s/m, >= 0; 0, which every constraint begins with: none

        Raises:
            InvalidId: for a body or constraint that does not exist"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(constraint) is not int or constraint >> 32: constraint = whole(constraint, "constraint")
        if type(damping) is not float: damping = number(damping, "damping")
        status = low.gphys_solver_set_constraint_damping(self._handle, body, constraint, damping)
        if status < 0: check(status)

    def set_volume(self, body: int, rest_volume: float, compliance: float = 0) -> None:
        """Hold the volume that the triangles of a cloth enclose, as air in a ball does. One volume a body;
        setting it again changes it, which inflates a body.
        Cost: O(triangles) in each substep, twice. Allocates.

        Args:
            rest_volume: m^3, > 0; negative: the present volume
            compliance: m^3 per pascal, >= 0: the volume that a pressure of one pascal takes; 0: as
                water, which keeps its volume; INFINITY: none, which ends the constraint

        Raises:
            Error, status ERROR_UNSUPPORTED: if the triangles do not close (each side is that of two
                triangles), are not oriented consistently, or face inward when the present volume is
                asked for"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(rest_volume) is not float: rest_volume = number(rest_volume, "rest_volume")
        if type(compliance) is not float: compliance = number(compliance, "compliance")
        status = low.gphys_solver_set_volume(self._handle, body, rest_volume, compliance)
        if status < 0: check(status)

    def get_volume(self, body: int) -> tuple[float, float]:
        """The volume held by Solver.set_volume, m^3, as it is, and the pressure in pascals with which it
        was held at the end of the last step: above 0 it pushes outward.
        Cost: O(triangles).

        Raises:
            Error, status ERROR_UNSUPPORTED: if none is held"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_volume = ctypes.c_float()
        out_pressure = ctypes.c_float()
        status = low.gphys_solver_get_volume(self._handle, body, ctypes.byref(out_volume), ctypes.byref(out_pressure))
        if status < 0: check(status)
        return out_volume.value, out_pressure.value

    def get_volume_settings(self, body: int) -> tuple[float, float]:
        """What was given to Solver.set_volume: m^3 (for a negative volume the one at that time), and m^3
        per pascal.
        Cost: O(1). Since 1.1.

        Raises:
            Error, status ERROR_UNSUPPORTED: if none is held"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_rest_volume = ctypes.c_float()
        out_compliance = ctypes.c_float()
        status = low.gphys_solver_get_volume_settings(self._handle, body, ctypes.byref(out_rest_volume), ctypes.byref(out_compliance))
        if status < 0: check(status)
        return out_rest_volume.value, out_compliance.value

    def remove_constraint(self, body: int, constraint: int) -> None:
        """Remove a constraint of a body, even one created with it. Its id stays invalid. Wakes the body.
        The triangles of cloth stay together: Solver.break_constraint tears them apart.
        Cost: as Solver.add_distance; allocates.

        Raises:
            InvalidId: for a body or constraint that does not exist, or no longer"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(constraint) is not int or constraint >> 32: constraint = whole(constraint, "constraint")
        status = low.gphys_solver_remove_constraint(self._handle, body, constraint)
        if status < 0: check(status)

    def get_constraints(self, body: int) -> NDArray[np.void]:
        """All constraints of a body, including those created with the body, by id.
        Cost: O(constraints)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        return list_of(low.gphys_solver_get_constraints, (self._handle, body,), low.constraint_info_dtype)

    def get_constraint_kinds(self, body: int, constraints: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
        """Which constraints keep a length, and which a maximum.
        Cost: O(elements). Since 1.1.

        Args:
            constraints: the ids; one may appear twice"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        constraints_ = array_of(constraints, "<u4", packed=True)
        count = common_length(constraints_)
        out_ = result_array(out, count, "<i4")
        status = low.gphys_solver_get_constraint_kinds(self._handle, body, constraints_.address, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def get_constraint_settings(self, body: int, constraints: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
        """The present settings of constraints.
        Cost: O(elements).

        Args:
            constraints: the ids; one may appear twice"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        constraints_ = array_of(constraints, "<u4", packed=True)
        count = common_length(constraints_)
        out_ = result_array(out, count, low.constraint_settings_dtype)
        status = low.gphys_solver_get_constraint_settings(self._handle, body, constraints_.address, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def set_constraint_settings(self, body: int, constraints: ArrayLike, settings: ArrayLike) -> None:
        """Change constraints while they act, all or none: winches, muscles. A rest length goes from the
        old to the new one at constant speed during the next step; a winch that reels in at v m/s is
        given a length that is v dt shorter before each step of dt. Wakes the body.
        Cost: O(elements); in the next step O(constraints) to pack them again, of rigid cloth with pins
        that gets longer links O(n log n). Chains are not planned again. Allocates.

        Args:
            constraints: the ids; one that appears twice gets the last"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        constraints_ = array_of(constraints, "<u4", packed=True)
        settings_ = array_of(settings, low.constraint_settings_dtype)
        count = common_length(constraints_, settings_)
        status = low.gphys_solver_set_constraint_settings(self._handle, body, constraints_.address, settings_.address, settings_.stride, count)
        if status < 0: check(status)

    def add_cluster(self, body: int, particles: ArrayLike) -> int:
        """Make particles of a body a rigid cluster: they keep the shape in which they are now, and move
        and turn as one stiff part, such as a plank of a bridge, a crate or a plate of armour. Links
        between them are not needed. A particle may be in several clusters: planks with two particles in
        common are hinged there, with one they are jointed. The mass of a cluster is that of its
        particles; hollow shapes are light in the middle. Particles that are pinned or attached stay
        where they are held: with one the cluster swings about it, with two about the line through them,
        and with three that are not on a line it does not move. Models that particles are attached to
        get the impulses. Contacts with models move the cluster as a whole, with friction; only
        particles touch, not the faces between them, so they should be no further apart than the
        thickness of the thinnest thing that a cluster meets. It bounces as a whole, too; one that is
        held, joined, or shares particles shows only the share of its restitution that its particles in
        contact have of its mass. A shape is matched once in each substep, after the links: then what
        hangs from it by links may be strained a little, and clusters that share particles approach
        their shapes in eight passes. What is joined to it by Solver.join is solved together with it,
        unless one of its particles is attached, or another cluster has it, too: hang heavy loads, or a
        light cluster under a heavy load, by joints. Bodies with clusters are solved as cloth
        (SOLVE_GRAPH), ropes and free particles too. The rest positions of cloth are not changed by a
        cluster.
        Cost: O(particles); allocates. In each substep about 1 us a cluster, 50 ns a particle of it and
        0.3 us one that touches a model, and up to eight times that if clusters of the body share
        particles; the first and the last cluster plan the body again, O(constraints). Since 1.1.

        Args:
            particles: count different particles, at least 2

        Raises:
            InvalidArgument: for a particle that does not exist or appears twice
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 clusters of a body, or that many particles in
                them"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        particles_ = array_of(particles, "<u4", packed=True)
        out_cluster = ctypes.c_uint32()
        count = common_length(particles_)
        status = low.gphys_solver_add_cluster(self._handle, body, particles_.address, count, ctypes.byref(out_cluster))
        if status < 0: check(status)
        return out_cluster.value

    def remove_cluster(self, body: int, cluster: int) -> None:
        """End a cluster. Its particles stay where they are; its id stays invalid. Wakes the body.
        Cost: O(particles in clusters of the body). Since 1.1.

        Raises:
            InvalidId: for a body or cluster that does not exist, or no longer"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(cluster) is not int or cluster >> 32: cluster = whole(cluster, "cluster")
        status = low.gphys_solver_remove_cluster(self._handle, body, cluster)
        if status < 0: check(status)

    def get_clusters(self, body: int) -> NDArray[np.uint32]:
        """All clusters of a body, by id.
        Cost: O(clusters). Since 1.1."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        return list_of(low.gphys_solver_get_clusters, (self._handle, body,), "<u4")

    def get_cluster_particles(self, body: int, cluster: int) -> NDArray[np.uint32]:
        """The particles of a cluster, in the order in which they were given.
        Cost: O(particles of the cluster). Since 1.1.

        Raises:
            InvalidId: for a body or cluster that does not exist, or no longer"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(cluster) is not int or cluster >> 32: cluster = whole(cluster, "cluster")
        return list_of(low.gphys_solver_get_cluster_particles, (self._handle, body, cluster,), "<u4")

    def join(self, body_a: int, particle_a: int, body_b: int, particle_b: int, rest_length: float, compliance: float = 0) -> int:
        """Hold a particle of one body and a particle of another at a distance. Both are moved, by forces
        that are equal and opposite; either may be pinned or attached. Joined ropes, free particles and
        rigid clusters are solved as one system, as stiff as one rope; a joined particle of cloth has
        the inertia of all that hangs on it. Free particles of a joined body are moved by the time
        scheme of ropes, no longer exactly. Joined bodies are moved by one thread and fall asleep and
        wake together. A joint is removed with either body. Particles of the two that are linked to a
        joint within touch of each other do not collide there.
        Cost: the next step plans all joined ropes again. A link of them takes 2.5 to 4 times as long as
        one of a rope that is not joined. Allocates.

        Args:
            rest_length: metres; 0: at the same place, as below 1e-9; negative: the present distance.
                Particles at another distance are moved to it in the next step; by a rigid joint without
                speed.
            compliance: metres per newton, >= 0; 0 is rigid

        Raises:
            InvalidArgument: for a particle that does not exist or twice the same body (see
                Solver.add_distance)
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 joints"""
        if type(body_a) is not int or body_a >> 32: body_a = whole(body_a, "body_a")
        if type(particle_a) is not int or particle_a >> 32: particle_a = whole(particle_a, "particle_a")
        if type(body_b) is not int or body_b >> 32: body_b = whole(body_b, "body_b")
        if type(particle_b) is not int or particle_b >> 32: particle_b = whole(particle_b, "particle_b")
        if type(rest_length) is not float: rest_length = number(rest_length, "rest_length")
        if type(compliance) is not float: compliance = number(compliance, "compliance")
        out_joint = ctypes.c_uint32()
        status = low.gphys_solver_join(self._handle, body_a, particle_a, body_b, particle_b, rest_length, compliance, ctypes.byref(out_joint))
        if status < 0: check(status)
        return out_joint.value

    def unjoin(self, joint: int) -> None:
        """End a joint. Wakes both bodies.
        Cost: as Solver.join.

        Raises:
            InvalidId: for a joint that does not exist, or no longer"""
        if type(joint) is not int or joint >> 32: joint = whole(joint, "joint")
        status = low.gphys_solver_unjoin(self._handle, joint)
        if status < 0: check(status)

    def get_joints(self, body: int) -> NDArray[np.void]:
        """Joints of a body, by id.
        Cost: O(joints of the solver).

        Args:
            body: 0: of all bodies"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        return list_of(low.gphys_solver_get_joints, (self._handle, body,), low.joint_info_dtype)

    def set_breaking_forces(self, body: int, constraints: ArrayLike, forces: ArrayLike) -> None:
        """Breaking forces of constraints. Wakes the body.
        Cost: O(elements + constraints); of cloth that gets its first or loses its last one also that of
        a pin. Allocates. Since 1.1.

        Args:
            constraints: the ids; one that appears twice gets the last
            forces: newtons, >= 0; 0: never breaks, as all that are added to a body later"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        constraints_ = array_of(constraints, "<u4", packed=True)
        forces_ = array_of(forces, "<f4")
        count = common_length(constraints_, forces_)
        status = low.gphys_solver_set_breaking_forces(self._handle, body, constraints_.address, forces_.address, forces_.stride, count)
        if status < 0: check(status)

    def get_breaking_forces(self, body: int, constraints: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
        """What Solver.set_breaking_forces or BodyDesc.breaking_force has set; 0: never breaks.
        Cost: O(elements). Since 1.1.

        Args:
            constraints: the ids; one may appear twice

        Returns:
            newtons."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        constraints_ = array_of(constraints, "<u4", packed=True)
        count = common_length(constraints_)
        out_ = result_array(out, count, "<f4")
        status = low.gphys_solver_get_breaking_forces(self._handle, body, constraints_.address, count, out_.address, out_.stride)
        if status < 0: check(status)
        return out_.array

    def break_constraint(self, body: int, constraint: int) -> low.Break:
        """Break a constraint as a load would, whatever its breaking force: scissors, claws. Wakes the
        body.
        Cost: O(particles + constraints); allocates. Since 1.1.

        Returns:
            what came of it.

        Raises:
            Error, status ERROR_UNSUPPORTED: and nothing has changed, for an edge where the cloth cannot
                part: of a triangle that is connected to no other
            Error, status ERROR_CAPACITY: beyond 2^24 - 1 particles or constraints"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        if type(constraint) is not int or constraint >> 32: constraint = whole(constraint, "constraint")
        out_result = low.Break()
        status = low.gphys_solver_break_constraint(self._handle, body, constraint, ctypes.byref(out_result))
        if status < 0: check(status)
        return out_result

    def get_breaks(self) -> NDArray[np.void]:
        """Constraints that broke in the last Solver.step or Solver.advance, in its order: for sounds,
        dust, and to know that a body has more particles. Not those that the caller broke. They are not
        part of snapshots: after Solver.restore there are none.
        Cost: O(breaks); no allocation. The same bits for any number of workers. Since 1.1."""
        return list_of(low.gphys_solver_get_breaks, (self._handle,), low.break_dtype)

    def step(self, scene: Scene | None, dt: float) -> None:
        """Simulate dt seconds in the set number of substeps, or as many as the error targets ask for;
        cloth takes more where they would be longer than 25 ms.
        Particles do not pass through models, whatever their speed, nor models that move at up to 50 m/s
        through particles. A model moves evenly from its place at the last step to its present one,
        unless it jumps: it turns by a right angle or more, its velocity changes by more than 50 m/s to
        more than that, or its surface does by a change of scale. One that jumps is not swept and gives
        no speed. What is then within a solid is pushed out slowly; what is then behind a plane or a
        mesh stays there. Allocates when what it steps has changed.
        Cost: O(particles + constraints) a substep, and a scene query for particles near models; O(1)
        and a scene query for a body that the last step, of the same dt, left exactly as it was.

        Args:
            scene: to collide with and to follow attachments; None: none. Not modified.
            dt: seconds, 1e-6 .. 0.5"""
        if type(dt) is not float: dt = number(dt, "dt")
        status = low.gphys_solver_step(self._handle, handle_of(scene, Scene), dt)
        if status < 0: check(status)

    def advance(self, scene: Scene | None, frame_time: float) -> tuple[int, float]:
        """Simulate a frame of any length in steps of fixed_step; what is left over is kept for the next
        frame, so the motion does not depend on the frame rate. Models, pins and animation targets are
        given the places of the end of the frame. They move there evenly in the time since the last
        step: attached particles, pins and what lies on models are at their places of the time that the
        solver has reached, leftover of a step before that of the frame. Impulses, contacts and breaks
        are those of the last step.
        Cost: that of the steps made.

        Args:
            frame_time: seconds, >= 0

        Returns:
            steps made. 0 <= fraction of a step still owed < 1, to interpolate when drawing.

        Raises:
            OutOfMemory: if there is none for the first step: nothing has changed. If there is none for
                a later one"""
        if type(frame_time) is not float: frame_time = number(frame_time, "frame_time")
        out_steps = ctypes.c_uint32()
        out_leftover = ctypes.c_float()
        status = low.gphys_solver_advance(self._handle, handle_of(scene, Scene), frame_time, ctypes.byref(out_steps), ctypes.byref(out_leftover))
        if status < 0: check(status)
        return out_steps.value, out_leftover.value

    def get_leftover(self) -> float:
        """The fraction of a step that Solver.advance still owes: what it gave last as leftover, unless the
        solver was restored or given another fixed_step since.
        Cost: O(1). Since 1.1.

        Returns:
            from 0 to below 1."""
        out_leftover = ctypes.c_float()
        status = low.gphys_solver_get_leftover(self._handle, ctypes.byref(out_leftover))
        if status < 0: check(status)
        return out_leftover.value

    def get_substeps(self, body: int) -> int:
        """The substeps that a body took in the last step; 0 before its first. With SolverDesc.max_strain
        or tolerance set, each body takes as many as its own motion needs: their length follows from
        what the last step measured, the largest strain of its rigid constraints and the local error of
        the time scheme, both proportional to the square of that length. It is at most quartered and
        grows by at most an eighth from one step to the next, so a sudden impact exceeds a target for a
        few steps; one of strain only where links of cloth cannot be relaxed below it. A target that
        cannot be met takes max_substeps, unless the strain of cloth stays above eight times the target.
        Where positions jump, by contacts, the error is that of the jump. What may meet others takes at
        least the set number.
        Cost: O(1)."""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_substeps = ctypes.c_uint32()
        status = low.gphys_solver_get_substeps(self._handle, body, ctypes.byref(out_substeps))
        if status < 0: check(status)
        return out_substeps.value

    def get_stats(self, body: int) -> low.SolverStats:
        """Counts, strain and energy of a body at present.
        Cost: O(particles + constraints).

        Args:
            body: 0: all bodies together"""
        if type(body) is not int or body >> 32: body = whole(body, "body")
        out_stats = low.SolverStats()
        status = low.gphys_solver_get_stats(self._handle, body, ctypes.byref(out_stats))
        if status < 0: check(status)
        return out_stats

    def get_contacts(self) -> NDArray[np.void]:
        """Contacts of the last step by body, particle, model.
        Cost: O(contacts)."""
        return list_of(low.gphys_solver_get_contacts, (self._handle,), low.contact_dtype)

    def get_body_contacts(self) -> NDArray[np.void]:
        """Contacts between bodies in the last step, of any substep, by body_a, particle_a, body_b,
        particle_b: for sounds, damage and sparks. Of sleeping bodies those of the step in which they
        fell asleep. Contacts with a body that was removed are no longer listed. They are not part of
        snapshots: after Solver.restore there are none until the next step. Contacts within a body
        (BodyDesc.self_collision) are not listed. where particles have more than 12 contacts on average,
        not all are known.
        Cost: O(contacts); no allocation. The same bits for any number of workers. Since 1.1."""
        return list_of(low.gphys_solver_get_body_contacts, (self._handle,), low.body_contact_dtype)

    def get_impulses(self) -> NDArray[np.void]:
        """Impulses of the last step, of all bodies together, by model; of sleeping bodies those of the
        step in which they fell asleep. After Solver.advance, times the steps that it made, they are
        those of the frame. Divided by dt they are mean forces: what lies on a model presses on it with
        its weight. A particle of cloth that touches several models at once gives its impulse to the one
        that it touches most. Models have no mass here: the step does as if they went where you put
        them, whatever the force. So a rope between a held end and a body of yours must be elastic, its
        stiffness times dt^2 well below the mass of the body, which needs some damping; a body of yours
        much lighter than what hangs from it should be moved in small steps.
        Cost: O(models touched); no allocation. The same bits for any number of workers."""
        return list_of(low.gphys_solver_get_impulses, (self._handle,), low.impulse_dtype)

    def get_snapshot(self) -> NDArray[np.uint32]:
        """Copy the whole state out: settings, origin, bodies with their ids, constraints, contacts and
        impulses, time that Solver.advance still owes. The scene, workers and allocator are not in it.
        Cost: O(particles + constraints), some 50 words for each.

        Returns:
            the snapshot. It is for the same release of the library and machines of the same byte order;
                it may be stored, but not changed.

        Raises:
            Error, status ERROR_CAPACITY: beyond 2^32 - 1 words"""
        return list_of(low.gphys_solver_get_snapshot, (self._handle,), "<u4")

    def restore(self, words: ArrayLike) -> None:
        """Replace the whole state by that of a snapshot, of this or of another solver. Ids are those of
        the time of the snapshot. Steps continue with the same bits as they did then, provided that the
        scene, too, is as it was. On an error the solver is as before. Any words are safe, also from an
        untrusted source: all that is used as a number or an index is checked first. Forged words are
        refused, or taken as a state whose numbers are in range.
        Cost: as Solver.get_snapshot; allocates.

        Raises:
            InvalidArgument: for words that are no snapshot, damaged, of another version or byte order
            OutOfMemory: if there is no room for it"""
        words_ = array_of(words, "<u4", packed=True)
        count = common_length(words_)
        status = low.gphys_solver_restore(self._handle, words_.address, count)
        if status < 0: check(status)

    def get_hash(self) -> NDArray[np.uint32]:
        """A hash of the whole state, the low half first. Equal states have equal hashes on every machine;
        different ones differ with near certainty (not against an adversary). Compare it between
        machines that run the same simulation, to detect when they diverge.
        Cost: O(particles + constraints)."""
        out_hash = np.empty(2, "<u4")
        status = low.gphys_solver_get_hash(self._handle, out_hash.ctypes.data)
        if status < 0: check(status)
        return out_hash


__all__ = [
    "Mesh", "Scene", "Camera", "Solver", "Shape", "validate", "bounds", "contains", "contains_batch",
    "closest_point", "closest_point_batch", "segment_closest_points", "overlaps", "overlaps_batch",
    "classify_plane", "classify_frustum", "raycast", "raycast_batch", "segment_test", "sweep_sphere", "sweep",
    "sweep_batch", "penetration", "penetration_batch", "frustum_corners", "planes_intersection",
    "planes_intersection_batch", "mat4_orthonormality", "frustum_from_matrix", "mesh_check",
]

Shape = Union[low.Sphere, low.Capsule, low.Aabb, low.Obb, low.Plane, low.Triangle, low.Frustum, Mesh, low.Ray, low.Segment]


def validate(shape: Shape) -> None:
    """Whether the fields of the shape are in the ranges stated beside its struct.
    Cost: O(1).

    Raises:
        InvalidArgument: and the error's message names the field"""
    type_, shape_ = shape_of(shape)
    status = low.gphys_shape_validate(type_, shape_)
    if status < 0: check(status)


def bounds(shape: Shape) -> low.Aabb | None:
    """The smallest float box that holds the shape: each side rounded outward, by at most 1 ulp.
    Cost: O(1), for a mesh too.

    Returns:
        None for a plane, a ray without end (or with one beyond all floats) and a frustum that
            extends to infinity; for an empty mesh or frustum."""
    type_, shape_ = shape_of(shape)
    out_bounds = low.Aabb()
    status = low.gphys_shape_bounds(type_, shape_, ctypes.byref(out_bounds))
    if status < 0: check(status)
    return None if status else out_bounds


def contains(shape: Shape, point: VectorLike, tolerance: float = 0) -> bool:
    """Whether the point is within tolerance metres of the shape (solid or surface). With tolerance 0
    the answer is exact: on the plane, on the segment, inside the box (an OBB's axes are those of
    its rotation in double precision). Others are as gamephys.overlaps with a sphere.
    Cost: O(1); O(log n) expected for a mesh.

    Args:
        tolerance: metres, >= 0"""
    type_, shape_ = shape_of(shape)
    point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
    if type(tolerance) is not float: tolerance = number(tolerance, "tolerance")
    out_contains = ctypes.c_int32()
    status = low.gphys_shape_contains(type_, shape_, point_, tolerance, ctypes.byref(out_contains))
    if status < 0: check(status)
    return bool(out_contains.value)


def contains_batch(shape: Shape, points: ArrayLike, tolerance: float = 0, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
    """Whether each of the points is within tolerance metres of one shape, as gamephys.contains.
    Cost: that of as many single calls.

    Args:
        tolerance: metres, >= 0, for all points"""
    type_, shape_ = shape_of(shape)
    points_ = array_of(points, low.vec3_dtype)
    if type(tolerance) is not float: tolerance = number(tolerance, "tolerance")
    count = common_length(points_)
    out_ = result_array(out, count, "<i4")
    status = low.gphys_shape_contains_batch(type_, shape_, points_.address, points_.stride, count, tolerance, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def closest_point(shape: Shape, point: VectorLike) -> low.Nearest | None:
    """The point of the shape that is closest to the given point: the point itself inside a solid.
    Error: 1 ulp of the largest coordinate per axis, the distance 1 ulp and 2^-40 of the largest
    coordinate difference. If several are equally close, one of them, always the same. For a ray, t
    is limited by t_max.
    Cost: O(1); O(log n) expected for a mesh.

    Returns:
        None only for an empty mesh or an empty frustum."""
    type_, shape_ = shape_of(shape)
    point_ = point if type(point) is low.Vec3 else value_of(point, low.Vec3, "point")
    out_nearest = low.Nearest()
    status = low.gphys_shape_closest_point(type_, shape_, point_, ctypes.byref(out_nearest))
    if status < 0: check(status)
    return None if status else out_nearest


def closest_point_batch(shape: Shape, points: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
    """The points of one shape that are closest to each of the points, as gamephys.closest_point. An
    element for which there is none gets distance INFINITY.
    Cost: that of as many single calls."""
    type_, shape_ = shape_of(shape)
    points_ = array_of(points, low.vec3_dtype)
    count = common_length(points_)
    out_ = result_array(out, count, low.nearest_dtype)
    status = low.gphys_shape_closest_point_batch(type_, shape_, points_.address, points_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def segment_closest_points(a: low.Segment | StructLike, b: low.Segment | StructLike) -> tuple[low.Vec3, low.Vec3, float]:
    """The closest points of two segments and their distance. Parallel segments have many: the first
    along a, always the same.
    Cost: O(1).

    Returns:
        metres."""
    a_ = a if type(a) is low.Segment else value_of(a, low.Segment, "a")
    b_ = b if type(b) is low.Segment else value_of(b, low.Segment, "b")
    out_a = low.Vec3()
    out_b = low.Vec3()
    out_distance = ctypes.c_float()
    status = low.gphys_segment_closest_points(a_, b_, ctypes.byref(out_a), ctypes.byref(out_b), ctypes.byref(out_distance))
    if status < 0: check(status)
    return out_a, out_b, out_distance.value


def overlaps(a: Shape, b: Shape) -> bool:
    """Whether two shapes have a point in common; any pair of sphere, capsule, AABB, OBB, plane,
    triangle, frustum and mesh, in either order. A mesh is its surface: a sphere deep inside a
    closed mesh does not overlap it. A convex hull (Mesh) is solid. Exact between AABBs, planes,
    triangles, meshes and frusta; other pairs are decided in double precision and may err only where
    the gap is below 2^-40 of the largest coordinate difference.
    Cost: 5 to 500 ns, 0.5 to 20 us with a frustum; O(log n + k) expected with a mesh.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or segment (see gamephys.segment_test)"""
    a_type_, a_ = shape_of(a)
    b_type_, b_ = shape_of(b)
    out_overlaps = ctypes.c_int32()
    status = low.gphys_shape_overlaps(a_type_, a_, b_type_, b_, ctypes.byref(out_overlaps))
    if status < 0: check(status)
    return bool(out_overlaps.value)


def overlaps_batch(a: ArrayLike | Mesh, b: ArrayLike | Mesh, *, out: NDArray[Any] | None = None) -> NDArray[np.int32]:
    """Whether the shapes of each of the pairs overlap, as gamephys.overlaps: pair i is a[i] against
    b[i].
    Cost: that of as many single calls.

    Args:
        a, b: shapes of one type

    Raises:
        Error, status ERROR_UNSUPPORTED: for rays and segments"""
    a_type_, a_ = shapes_of(a)
    b_type_, b_ = shapes_of(b)
    count = common_length(a_, b_)
    out_ = result_array(out, count, "<i4")
    status = low.gphys_shape_overlaps_batch(a_type_, a_.address, a_.stride, b_type_, b_.address, b_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def classify_plane(shape: Shape, plane: low.Plane | StructLike) -> tuple[int, float]:
    """Classify a sphere, capsule, AABB, OBB or triangle against a plane.
    Cost: O(1).

    Returns:
        metres, of the shape's nearest point to the plane: > 0 in front, < 0 behind, 0 when
            crossing.

    Raises:
        Error, status ERROR_UNSUPPORTED: for other types of shapes"""
    type_, shape_ = shape_of(shape)
    plane_ = plane if type(plane) is low.Plane else value_of(plane, low.Plane, "plane")
    out_side = ctypes.c_int32()
    out_signed_distance = ctypes.c_float()
    status = low.gphys_shape_classify_plane(type_, shape_, plane_, ctypes.byref(out_side), ctypes.byref(out_signed_distance))
    if status < 0: check(status)
    return out_side.value, out_signed_distance.value


def classify_frustum(shape: Shape, frustum: low.Frustum | StructLike) -> int:
    """Classify a sphere, capsule, AABB, OBB or triangle against a frustum, exactly: outside means that
    no point is shared, inside that the frustum holds the whole shape.
    Cost: O(1).

    Raises:
        Error, status ERROR_UNSUPPORTED: for other types of shapes"""
    type_, shape_ = shape_of(shape)
    frustum_ = frustum if type(frustum) is low.Frustum else value_of(frustum, low.Frustum, "frustum")
    out_side = ctypes.c_int32()
    status = low.gphys_shape_classify_frustum(type_, shape_, frustum_, ctypes.byref(out_side))
    if status < 0: check(status)
    return out_side.value


def raycast(shape: Shape, ray: low.Ray | StructLike) -> low.Hit | None:
    """First hit of a ray with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh.
    Triangles and meshes are hit from both sides, and meshes are watertight: a ray through a shared
    edge or vertex always meets one of the triangles there. Error: t within 1 ulp. No false miss and
    no false hit at all for spheres, triangles, meshes, AABBs and planes; for capsules only within
    2^-48 of the distance. An OBB is hit as if it were larger or smaller by up to 2^-40 of the
    distance. docs/accuracy.md has the bounds of all functions.
    Cost: O(1); O(log n) expected for a mesh.

    Returns:
        None if nothing is found.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or a segment as the shape"""
    type_, shape_ = shape_of(shape)
    ray_ = ray if type(ray) is low.Ray else value_of(ray, low.Ray, "ray")
    out_hit = low.Hit()
    status = low.gphys_shape_raycast(type_, shape_, ray_, ctypes.byref(out_hit))
    if status < 0: check(status)
    return None if status else out_hit


def raycast_batch(shape: Shape, rays: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
    """First hits of the rays with one shape, as gamephys.raycast. A ray that hits nothing gets t =
    INFINITY, triangle = NO_TRIANGLE and zeros in its hits element.
    Cost: that of as many single calls; less for rays at a mesh if neighbouring rays are similar.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or a segment as the shape"""
    type_, shape_ = shape_of(shape)
    rays_ = array_of(rays, low.ray_dtype)
    count = common_length(rays_)
    out_ = result_array(out, count, low.hit_dtype)
    status = low.gphys_shape_raycast_batch(type_, shape_, rays_.address, rays_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def segment_test(shape: Shape, segment: low.Segment | StructLike) -> low.Hit | None:
    """First hit along the segment from a to b; t runs from 0 to 1. Contains both end points exactly. A
    segment whose ends coincide hits at t = 0 if the shape contains the point; on a solid, for lack
    of a direction, the normal is zero.
    Cost: as gamephys.raycast.

    Returns:
        None if nothing is found.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or a segment as the shape"""
    type_, shape_ = shape_of(shape)
    segment_ = segment if type(segment) is low.Segment else value_of(segment, low.Segment, "segment")
    out_hit = low.Hit()
    status = low.gphys_shape_segment_test(type_, shape_, segment_, ctypes.byref(out_hit))
    if status < 0: check(status)
    return None if status else out_hit


def sweep_sphere(shape: Shape, sphere: low.Sphere | StructLike, displacement: VectorLike) -> low.Hit | None:
    """First contact of a sphere that moves by displacement with a sphere, capsule, AABB, OBB, plane,
    triangle, frustum or mesh.
    Error: as if the radius were off by 2^-40 of the largest coordinate difference, and 1 ulp of t.
    Cost: O(1), about 10 us for a frustum, which is approached step by step; O(log n + k) expected
    for a mesh.

    Args:
        displacement: metres; may be zero

    Returns:
        t in 0..1 of the displacement; point: of contact, on the shape; normal: from the point to
            the sphere's centre; in double precision its dot with the displacement is never above 0.
            Already overlapping: t = 0, HIT_INSIDE, and the normal may be along the displacement
            too; where the centre itself is in a solid, it is opposite to the displacement (zero if
            that is zero). A sphere of radius 0 gets the hit of the ray along its path. None if
            nothing is found.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or a segment as the shape"""
    type_, shape_ = shape_of(shape)
    sphere_ = sphere if type(sphere) is low.Sphere else value_of(sphere, low.Sphere, "sphere")
    displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
    out_hit = low.Hit()
    status = low.gphys_shape_sweep_sphere(type_, shape_, sphere_, displacement_, ctypes.byref(out_hit))
    if status < 0: check(status)
    return None if status else out_hit


def sweep(shape: Shape, moving: low.Sphere | low.Capsule | low.Aabb | low.Obb, displacement: VectorLike) -> low.Hit | None:
    """First contact of a sphere, capsule, AABB or OBB that moves by displacement, without turning,
    with a sphere, capsule, AABB, OBB, plane, triangle, frustum or mesh. A frustum, unless a sphere
    moves, must be the hull of its corners (gamephys.frustum_corners).
    Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and
    1 ulp of t. Point and normal are those of that contact.
    Cost: O(1), 0.1 to 2 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh.

    Args:
        displacement: metres; may be zero

    Returns:
        t, point and normal as in gamephys.sweep_sphere, which gives the answer for a sphere. The
            point is one of those where the two touch, always the same. Already overlapping, except
            for a sphere: t = 0, HIT_INSIDE, and point and normal of gamephys.penetration; for a
            mesh that is not a hull, those of its first triangle. None if nothing is found.

    Raises:
        Error, status ERROR_UNSUPPORTED: for a ray or a segment as the shape, for a frustum that is
            not the hull of its corners, unless a sphere moves, and for other types that move"""
    type_, shape_ = shape_of(shape)
    moving_type_, moving_ = shape_of(moving)
    displacement_ = displacement if type(displacement) is low.Vec3 else value_of(displacement, low.Vec3, "displacement")
    out_hit = low.Hit()
    status = low.gphys_shape_sweep(type_, shape_, moving_type_, moving_, displacement_, ctypes.byref(out_hit))
    if status < 0: check(status)
    return None if status else out_hit


def sweep_batch(shapes: ArrayLike | Mesh, moving: ArrayLike | Mesh, displacements: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
    """First contacts of count moving shapes of one type with the shapes of another, as gamephys.sweep:
    moving[i] with shapes[i]. One that touches nothing gets t = INFINITY, triangle = NO_TRIANGLE and
    zeros.
    Cost: that of as many single calls. Since 1.1.

    Args:
        shapes, moving: shapes of one type
        displacements: metres

    Raises:
        Error, status ERROR_UNSUPPORTED: as gamephys.sweep"""
    type_, shapes_ = shapes_of(shapes)
    moving_type_, moving_ = shapes_of(moving)
    displacements_ = array_of(displacements, low.vec3_dtype)
    count = common_length(shapes_, moving_, displacements_)
    out_ = result_array(out, count, low.hit_dtype)
    status = low.gphys_shape_sweep_batch(type_, shapes_.address, shapes_.stride, moving_type_, moving_.address, moving_.stride, displacements_.address, displacements_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def penetration(shape: Shape, moving: low.Sphere | low.Capsule | low.Aabb | low.Obb) -> low.Penetration | None:
    """The shortest translation that takes a sphere, capsule, AABB or OBB out of a sphere, capsule,
    AABB, OBB, plane, triangle or frustum: to where the two just touch, on the side of a plane or
    triangle that is nearer. Of a mesh: out of the triangle that it is deepest in; others may
    remain, and have translations of their own. Of a hull: out of all of it, and triangle is
    NO_TRIANGLE. A frustum must be the hull of its corners (gamephys.frustum_corners).
    Error: as if the shape were larger or smaller by 2^-40 of the largest coordinate difference, and
    1 ulp of depth; by 2^-32 where the centre or axis of a round solid is closer than that to the
    other shape. Added to float positions, the translation may leave an overlap as large as the
    spacing of floats there.
    Cost: O(1), 0.1 to 1 us, 3 to 20 us for a frustum; O(log n + k) expected for a mesh. Boxes by
    separating axes (Gottschalk 1996), round solids by the distance of their core (Gilbert, Johnson,
    Keerthi 1988).

    Returns:
        depth and normal of the translation, which is their product; of several equally short ones
            always the same one. The deepest point of the solid is point - depth * normal. None if
            nothing is found.

    Raises:
        Error, status ERROR_UNSUPPORTED: for rays, segments, frusta that are not the hull of their
            corners, and for other types that move"""
    type_, shape_ = shape_of(shape)
    moving_type_, moving_ = shape_of(moving)
    out_penetration = low.Penetration()
    status = low.gphys_shape_penetration(type_, shape_, moving_type_, moving_, ctypes.byref(out_penetration))
    if status < 0: check(status)
    return None if status else out_penetration


def penetration_batch(shapes: ArrayLike | Mesh, moving: ArrayLike | Mesh, *, out: NDArray[Any] | None = None) -> NDArray[np.void]:
    """The shortest translations that take the shapes of one type out of the shapes of another, as
    gamephys.penetration: moving[i] out of shapes[i]. One that overlaps nothing gets depth =
    -INFINITY, triangle = NO_TRIANGLE and zeros.
    Cost: that of as many single calls. Since 1.1.

    Args:
        shapes, moving: shapes of one type

    Raises:
        Error, status ERROR_UNSUPPORTED: as gamephys.penetration"""
    type_, shapes_ = shapes_of(shapes)
    moving_type_, moving_ = shapes_of(moving)
    count = common_length(shapes_, moving_)
    out_ = result_array(out, count, low.penetration_dtype)
    status = low.gphys_shape_penetration_batch(type_, shapes_.address, shapes_.stride, moving_type_, moving_.address, moving_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def frustum_corners(frustum: low.Frustum | StructLike) -> NDArray[np.float32] | None:
    """The eight corners, each the intersection of three planes: near then far, each in the order
    left-bottom, right-bottom, right-top, left-top. A frustum is the convex hull of its corners (the
    intersections themselves, not rounded to floats) if each is within MAX_COORDINATE and in front
    of the three planes that do not meet there, by more than 2^-39 of its distance from origin; that
    is, unless it is empty, flat, unbounded or ends in a tip. Solids are swept against such a
    frustum and pushed out of it; for the bounds of their errors, origin counts as a corner.
    Cost: O(1).

    Returns:
        None if three planes do not meet in a point (infinite far plane), or meet beyond the largest
            float."""
    frustum_ = frustum if type(frustum) is low.Frustum else value_of(frustum, low.Frustum, "frustum")
    out_corners = np.empty(8, low.vec3_dtype)
    status = low.gphys_frustum_corners(frustum_, out_corners.ctypes.data)
    if status < 0: check(status)
    return None if status else out_corners


def planes_intersection(a: low.Plane | StructLike, b: low.Plane | StructLike, c: low.Plane | StructLike) -> low.Vec3 | None:
    """The point that three planes have in common, within an ulp of each coordinate.
    Cost: O(1). Source: Cramer's rule. Since 1.1.

    Returns:
        None if the planes have no single point in common, which is decided exactly, or one beyond
            MAX_COORDINATE."""
    a_ = a if type(a) is low.Plane else value_of(a, low.Plane, "a")
    b_ = b if type(b) is low.Plane else value_of(b, low.Plane, "b")
    c_ = c if type(c) is low.Plane else value_of(c, low.Plane, "c")
    out_point = low.Vec3()
    status = low.gphys_planes_intersection(a_, b_, c_, ctypes.byref(out_point))
    if status < 0: check(status)
    return None if status else out_point


def planes_intersection_batch(a: ArrayLike, b: ArrayLike, c: ArrayLike, *, out: NDArray[Any] | None = None) -> NDArray[np.float32]:
    """The points of the triples of planes, as gamephys.planes_intersection; one without gets x = y = z
    = INFINITY.
    Cost: that of as many single calls. Since 1.1.

    Args:
        a, b, c: the planes"""
    a_ = array_of(a, low.plane_dtype)
    b_ = array_of(b, low.plane_dtype)
    c_ = array_of(c, low.plane_dtype)
    count = common_length(a_, b_, c_)
    out_ = result_array(out, count, low.vec3_dtype)
    status = low.gphys_planes_intersection_batch(a_.address, a_.stride, b_.address, b_.stride, c_.address, c_.stride, count, out_.address, out_.stride)
    if status < 0: check(status)
    return out_.array


def mat4_orthonormality(matrix: low.Mat4 | ArrayLike) -> float:
    """How far the axes of a matrix (its first three columns without the last row) are from
    orthonormal: the largest |a_i . a_j - d_ij|, where d_ij is 1 for i = j, else 0. 0 for the
    identity, below 2^-22 for the matrices that a camera gives, about 2e for axes that are too long
    by a fraction e.
    Cost: O(1). Since 1.1.

    Args:
        matrix: elements within MAX_COORDINATE"""
    matrix_ = matrix_of(matrix, low.Mat4, "matrix")
    out_deviation = ctypes.c_float()
    status = low.gphys_mat4_orthonormality(matrix_, ctypes.byref(out_deviation))
    if status < 0: check(status)
    return out_deviation.value


def frustum_from_matrix(view_projection: low.Mat4 | ArrayLike, depth_range: int, reverse_z: bool) -> low.Frustum:
    """The frustum of any view-projection matrix (Gribb and Hartmann 2001), in double precision, with
    origin (0, 0, 0). For a camera, Camera.get_frustum is more precise.
    Cost: O(1).

    Args:
        reverse_z: False: near has the low depth; True: near has the high depth

    Raises:
        Error, status ERROR_SINGULAR: if the matrix has no inverse, or what it shows has no volume:
            its four near corners are not all finite points in front of the viewer"""
    view_projection_ = matrix_of(view_projection, low.Mat4, "view_projection")
    if type(depth_range) is not int or depth_range >> 31: depth_range = value(depth_range, "depth_range")
    if type(reverse_z) is not bool: reverse_z = flag(reverse_z, "reverse_z")
    out_frustum = low.Frustum()
    status = low.gphys_frustum_from_matrix(view_projection_, depth_range, reverse_z, ctypes.byref(out_frustum))
    if status < 0: check(status)
    return out_frustum


def mesh_check(vertices: ArrayLike, indices: ArrayLike) -> low.MeshReport:
    """Examine arrays without building anything. Allocates while it runs.
    Cost: O(n log n).

    Args:
        vertices: elements of 3 floats, metres
        indices: numbers, three for each triangle

    Returns:
        what was found; indices out of range and bad vertices are counted, not refused.

    Raises:
        InvalidArgument: for an index_count that is no multiple of 3"""
    vertices_ = array_of(vertices, "<f4", 3)
    indices_ = array_of(indices, "<u4", packed=True)
    out_report = low.MeshReport()
    status = low.gphys_mesh_check(vertices_.address, vertices_.stride, vertices_.length, indices_.address, indices_.numbers, ctypes.byref(out_report))
    if status < 0: check(status)
    return out_report
