// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.util.Optional;

/**
 * <pre>
 * Create a scene without models. With a worker_count of n, all batch queries of the scene
 * (Camera.pickBatch too), and adding and moving many models, share their work among n threads; the
 * results have the same bits for every n. Without a task_runner n - 1 threads are started here and
 * joined when the scene is destroyed. They serve one call at a time: calls made meanwhile run on their
 * own thread alone. They take no signals but faults, and have the standard floating-point settings. In
 * a child of fork they are gone: calls there run on one thread, as they do on a platform without
 * threads (WebAssembly, unless built for shared memory), whatever is asked for.
 *   - desc: null: the defaults
 * Throws GamephysException with ERROR_OUT_OF_MEMORY also if the threads cannot be started.
 * Throws GamephysException with ERROR_CAPACITY if reserve_models is above 2^24 - 1.
 * Cost: O(reserve_models), and that of starting the threads.
 * </pre>
 */
public final class Scene extends SceneBase {
    public Scene(SceneDesc desc) {
        super(create(desc), Low::gphys_scene_destroy);
    }

    public Scene() {
        super(create((SceneDesc) null), Low::gphys_scene_destroy);
    }

    private static Pointer create(SceneDesc desc) {
        return Low.create(made -> {
            int status = Low.gphys_scene_create(desc == null ? null : desc.pointer(), made);
            Low.keep(desc);
            return status;
        });
    }

    /**
     * Change the number of threads that share the calls of a scene, for example when the user changes a
     * setting. They are those of its task_runner if it was created with one. In a child of fork they are
     * started again. Answers keep their bits.
     * Cost: that of joining the former threads and starting others; allocates. Since 1.1.
     * @param workers as SceneDesc.worker_count
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: also if the threads cannot be started; the
     *     former ones are kept
     */
    public void setWorkerCount(int workers) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_worker_count(self, workers);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * How many threads share the calls of a scene: 1 or more, 1 on a platform without threads. In a child
     * of fork it is still the number that was set, though calls run on one thread.
     * Cost: O(1). Since 1.1.
     */
    public int getWorkerCount() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_worker_count(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(1);
    }

    /**
     * Move the point of the world that all coordinates of the scene are relative to, those passed to it
     * and those that it returns. Models stay where they are in the world: the positions of those without a
     * parent become what they are from there, kept in double precision and rounded to float32 once,
     * however often the origin moves. For worlds beyond some kilometres: keep the origin near the camera,
     * and when the camera has gone a few kilometres, move it together with that of cameras and solvers.
     * Cost: that of Scene.setTransforms of all models, and 24 bytes a model from the first call on.
     * Queries cost nothing more. Allocates.
     * @param origin x, y, z in the world, within MAX_COORDINATE; before the first call 0 0 0
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if a model would leave the range of
     *     coordinates
     */
    public void setOrigin(double[] origin) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_origin(self, scratch.put(1, origin, 3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Where in the world the scene's coordinates count from.
     * Cost: O(1).
     */
    public double[] getOrigin() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_origin(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.doubles(1, 3);
    }

    /**
     * Add a model.
     * Cost: O(log n) amortised.
     * @param shape sphere, capsule, AABB, OBB, plane, triangle or mesh (a hull too)
     * @param shape in the model's own coordinates
     * @param transform local; null is the identity
     * @param desc null: no parent, layer 1, tag 0
     * @throws GamephysException with ERROR_UNSUPPORTED: for another type, or a scale that the shape cannot
     *     have (Scene.setScale)
     * @throws GamephysException with ERROR_INVALID_ID: for a stale parent
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^24 - 1 models
     */
    public int add(Shape shape, Transform transform, ModelDesc desc) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(Low.mesh(shape));
            try {
                status = Low.gphys_scene_add(self, shape.kind(), Low.shape(shape, scratch, 2), scratch.put(3, transform), desc == null ? null : desc.pointer(), scratch.slot(5));
            } finally {
                Owned.leave(Low.mesh(shape));
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shape, desc);
        Low.check(status);
        return scratch.getInt(5);
    }

    /** The same with defaults. */
    public int add(Shape shape, Transform transform) {
        return add(shape, transform, (ModelDesc) null);
    }

    /** The same with defaults. */
    public int add(Shape shape) {
        return add(shape, (Transform) null, (ModelDesc) null);
    }

    /**
     * Add the models of one type, all or none, as Scene.add does one.
     * Fails as Scene.add.
     * Cost: O(elements log n), less with workers; a rebuild of the octree, O(n log n), where their number
     * is of the order of n.
     * @param shapes in the models' own coordinates
     * @param transforms local; null is the identity
     * @param desc for all; null: no parent, layer 1, tag 0
     */
    public Batch<Integer> addBatch(Shapes shapes, Batch<Transform> transforms, ModelDesc desc, Batch<Integer> out) {
        int count = Low.common(shapes.common(), Batch.common(transforms));
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(shapes.mesh());
            try {
                status = Low.gphys_scene_add_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), Batch.pointer(transforms), Batch.stride(transforms), count, desc == null ? null : desc.pointer(), room.pointer());
            } finally {
                Owned.leave(shapes.mesh());
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shapes, transforms, desc, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> addBatch(Shapes shapes, Batch<Transform> transforms, ModelDesc desc) {
        return addBatch(shapes, transforms, desc, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> addBatch(Shapes shapes, Batch<Transform> transforms) {
        return addBatch(shapes, transforms, (ModelDesc) null, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> addBatch(Shapes shapes) {
        return addBatch(shapes, (Batch<Transform>) null, (ModelDesc) null, (Batch<Integer>) null);
    }

    /**
     * Add the models of one type, all or none, each with a desc of its own.
     * Fails as Scene.add; ERROR_STRUCT_SIZE as for a single desc.
     * Cost: as Scene.addBatch.
     * @param shapes in the models' own coordinates
     * @param transforms local; null is the identity
     * @param descs one for each; null: no parent, layer 1, tag 0. Parents are models that the scene has
     *     before the call
     */
    public Batch<Integer> addDescribedBatch(Shapes shapes, Batch<Transform> transforms, Batch<ModelDesc> descs, Batch<Integer> out) {
        int count = Low.common(shapes.common(), Batch.common(transforms), Batch.common(descs));
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(shapes.mesh());
            try {
                status = Low.gphys_scene_add_described_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), Batch.pointer(transforms), Batch.stride(transforms), Batch.pointer(descs), Batch.stride(descs), count, room.pointer());
            } finally {
                Owned.leave(shapes.mesh());
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shapes, transforms, descs, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> addDescribedBatch(Shapes shapes, Batch<Transform> transforms, Batch<ModelDesc> descs) {
        return addDescribedBatch(shapes, transforms, descs, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> addDescribedBatch(Shapes shapes, Batch<Transform> transforms) {
        return addDescribedBatch(shapes, transforms, (Batch<ModelDesc>) null, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> addDescribedBatch(Shapes shapes) {
        return addDescribedBatch(shapes, (Batch<Transform>) null, (Batch<ModelDesc>) null, (Batch<Integer>) null);
    }

    /**
     * Remove a model. Its children stay where they are in the world and lose their parent.
     * Cost: O(log n) amortised, and O(1) a child. Renews the octree as far as there is memory.
     */
    public void remove(int model) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_remove(self, model);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Remove models, all or none.
     * Cost: that of as many calls of Scene.remove. Renews the octree as far as there is memory.
     * @param models the ids; an id that appears twice is ERROR_INVALID_ID
     */
    public void removeBatch(Batch<Integer> models) {
        int count = Low.common(models.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_remove_batch(self, models.pointer(), count);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, models);
        Low.check(status);
    }

    /**
     * Remove a model and all its descendants.
     * Cost: O(log n) amortised for each. Renews the octree as far as there is memory.
     */
    public void removeSubtree(int model) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_remove_subtree(self, model);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Remove all models. Ids given out before stay invalid.
     * Cost: O(n).
     */
    public void clear() {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_clear(self);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Whether an id names a model of this scene.
     * Cost: O(1).
     */
    public boolean has(int model) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_has(self, model);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.answered(status, Gamephys.ERROR_INVALID_ID);
    }

    /**
     * Ids of all models, ascending.
     * Cost: O(n).
     */
    public Batch<Integer> getModels() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_get_models(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Ids of all models without a parent, ascending.
     * Cost: O(n).
     */
    public Batch<Integer> getRoots() {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_get_roots(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Ids of the direct children of a model, ascending.
     * Cost: O(k log k).
     */
    public Batch<Integer> getChildren(int model) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_get_children(self, model, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Kind, parent, layers, tag and number of children of a model.
     * Cost: O(1).
     */
    public ModelInfo getInfo(int model) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_info(self, model, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return ModelInfo.read(scratch.memory, Scratch.at(2));
    }

    /**
     * World box of a model, by which queries find it: contains the model, and is wider by at most 3 ulps
     * and 2^-19 of the sum of its sizes. That of an empty mesh is its position.
     * Cost: O(1).
     * @return empty for a plane.
     */
    public Optional<Aabb> getBounds(int model) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_bounds(self, model, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Aabb.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * World box of all bounded models. Planes are left out.
     * Cost: O(1).
     * @return empty if there are none.
     */
    public Optional<Aabb> getSceneBounds() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_scene_bounds(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Aabb.read(scratch.memory, Scratch.at(1))) : Optional.empty();
    }

    /**
     * Give a model another shape, or another mesh, of any type that Scene.add takes: a character crouches,
     * a level of detail changes, a wall breaks. Its id, parent, children, tag, layers, scale and
     * transforms stay. Sleeping bodies near it wake, and particles that are inside then come out as they
     * do of any solid.
     * Cost: as Scene.setTransform of a model without children, whatever the size of a mesh.
     * @param shape as in Scene.add: a struct, copied, or a mesh with SHAPE_MESH. The scene holds the new
     *     mesh and no longer the old one, which may be the same.
     * @throws GamephysException with ERROR_UNSUPPORTED: for a frustum, ray or segment, and for a shape
     *     that cannot have the model's scale (Scene.setScale)
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if the model would leave the range of
     *     the world
     * @throws GamephysException with ERROR_OUT_OF_MEMORY:
     */
    public void setShape(int model, Shape shape) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(Low.mesh(shape));
            try {
                status = Low.gphys_scene_set_shape(self, model, shape.kind(), Low.shape(shape, scratch, 3));
            } finally {
                Owned.leave(Low.mesh(shape));
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shape);
        Low.check(status);
    }

    /**
     * Scale a model's own shape along the three axes of the model, before its transform: a tree grows, a
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
     * @param scale x, y, z, each from 1e-15 to 1e15
     * @throws GamephysException with ERROR_UNSUPPORTED: for numbers that are not equal where they have to
     *     be, and for the mesh of a rope or of particles (Mesh) unless it is 1 1 1
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if a coordinate of the scaled shape
     *     would exceed MAX_COORDINATE, if a number times that of a mesh's world transform is not from
     *     1e-15 to 1e15, or if the model would leave the range of the world
     * @throws GamephysException with ERROR_OUT_OF_MEMORY:
     */
    public void setScale(int model, Vec3 scale) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_scale(self, model, scratch.put(2, scale));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The scale of a model's own shape, 1 1 1 unless another was set.
     * Cost: O(1).
     */
    public Vec3 getScale(int model) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_scale(self, model, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Vec3.read(scratch.memory, Scratch.at(2));
    }

    /**
     * Change which queries see a model: those with a mask m of which layers &amp; m is not 0. Children are not
     * affected.
     * Cost: O(1).
     * @param layers any mask; 0: no query sees it
     */
    public void setLayers(int model, int layers) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_layers(self, model, layers);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Change the number that a model's hits report beside its id. Children are not affected.
     * Cost: O(1).
     * @param tag any number of the caller's
     */
    public void setTag(int model, int tag) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_tag(self, model, tag);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Make a model the child of another one, or of none (0).
     * Cost: O(depth of the tree of models), and as Scene.setTransform for what moves. Renews the octree as
     * far as there is memory.
     * @param keepWorld false: the local transform is kept, the model jumps; true: the local transform is
     *     changed so that the world transform stays (within float32 rounding)
     * @throws GamephysException with ERROR_CYCLE: if parent is the model or one of its descendants
     */
    public void setParent(int model, int parent, boolean keepWorld) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_parent(self, model, parent, keepWorld ? 1 : 0);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Set a model's local transform. Descendants follow.
     * Cost: O(log n) for each model that moves. Renews the octree as far as there is memory.
     * @param transform relative to the parent; scale &gt; 0
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: also if it, or a descendant, would leave the
     *     range of the world
     */
    public void setTransform(int model, Transform transform) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_transform(self, model, scratch.put(2, transform));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /** The same with defaults. */
    public void setTransform(int model) {
        setTransform(model, (Transform) null);
    }

    /**
     * Set the local transforms of many models, all or none; a model that appears twice gets the last.
     * Descendants follow.
     * Cost: O(log n) for each model that moves when few move, O(n) when many do; less with workers. Renews
     * the octree as far as there is memory.
     * @param models the ids
     * @param transforms as in Scene.setTransform
     */
    public void setTransforms(Batch<Integer> models, Batch<Transform> transforms) {
        int count = Low.common(models.common(), transforms.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_set_transforms(self, models.pointer(), transforms.pointer(), transforms.stride(), count);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, models, transforms);
        Low.check(status);
    }

    /** The same with defaults. */
    public void setTransforms(Batch<Integer> models) {
        setTransforms(models, (Batch<Transform>) null);
    }

    /**
     * Local transforms of the models, as they were set: relative to the parent.
     * Cost: O(elements).
     * @param models the ids; an id may appear twice
     */
    public Batch<Transform> getTransforms(Batch<Integer> models, Batch<Transform> out) {
        int count = Low.common(models.common());
        Batch<Transform> room = Batch.room(Transform.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_transforms(self, models.pointer(), count, room.pointer(), Transform.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, models, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Transform> getTransforms(Batch<Integer> models) {
        return getTransforms(models, (Batch<Transform>) null);
    }

    /**
     * World transforms of the models: with those of all ancestors applied, rounded to float32. Answers of
     * queries are exact with respect to these.
     * Cost: O(elements).
     * @param models the ids; an id may appear twice
     */
    public Batch<Transform> getWorldTransforms(Batch<Integer> models, Batch<Transform> out) {
        int count = Low.common(models.common());
        Batch<Transform> room = Batch.room(Transform.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_world_transforms(self, models.pointer(), count, room.pointer(), Transform.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, models, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Transform> getWorldTransforms(Batch<Integer> models) {
        return getWorldTransforms(models, (Batch<Transform>) null);
    }

    /**
     * Closest model on a ray; the fields are exact as in Gamephys.raycast.
     * Cost: O(log n) expected; no allocation.
     * @return empty if nothing is found.
     */
    public Optional<Hit> raycast(Ray ray, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast(self, scratch.put(1, ray), layers, scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> raycast(Ray ray) {
        return raycast(ray, Gamephys.ALL_LAYERS);
    }

    /**
     * Closest models on the rays, as Scene.raycast; a ray that hits nothing gets model = 0 and t =
     * INFINITY.
     * Cost: at most that of as many single calls; shared among workers.
     */
    public Batch<Hit> raycastBatch(Batch<Ray> rays, int layers, Batch<Hit> out) {
        int count = Low.common(rays.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_batch(self, rays.pointer(), rays.stride(), count, layers, room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> raycastBatch(Batch<Ray> rays, int layers) {
        return raycastBatch(rays, layers, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> raycastBatch(Batch<Ray> rays) {
        return raycastBatch(rays, Gamephys.ALL_LAYERS, (Batch<Hit>) null);
    }

    /**
     * How far each of the rays goes, and what it hits: t, model and triangle of Scene.raycastBatch, with
     * the same bits, without the rest of a hit. For lidars and depth images.
     * Cost: less than that of Scene.raycastBatch; shared among workers. Since 1.1.
     * @return a ray that hits nothing gets t = INFINITY, model = 0 and triangle = NO_TRIANGLE.
     */
    public Batch<Distance> raycastDistanceBatch(Batch<Ray> rays, int layers, Batch<Distance> out) {
        int count = Low.common(rays.common());
        Batch<Distance> room = Batch.room(Distance.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_distance_batch(self, rays.pointer(), rays.stride(), count, layers, room.pointer(), Distance.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Distance> raycastDistanceBatch(Batch<Ray> rays, int layers) {
        return raycastDistanceBatch(rays, layers, (Batch<Distance>) null);
    }

    /** The same with defaults. */
    public Batch<Distance> raycastDistanceBatch(Batch<Ray> rays) {
        return raycastDistanceBatch(rays, Gamephys.ALL_LAYERS, (Batch<Distance>) null);
    }

    /**
     * Whether a ray meets anything (shadow, line of sight); cheaper than the closest hit.
     * Cost: O(log n) expected.
     */
    public boolean raycastAny(Ray ray, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_any(self, scratch.put(1, ray), layers, scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(3) != 0;
    }

    /** The same with defaults. */
    public boolean raycastAny(Ray ray) {
        return raycastAny(ray, Gamephys.ALL_LAYERS);
    }

    /**
     * Whether each of the rays meets anything, as Scene.raycastAny.
     * Cost: at most that of as many single calls; shared among workers.
     */
    public Batch<Integer> raycastAnyBatch(Batch<Ray> rays, int layers, Batch<Integer> out) {
        int count = Low.common(rays.common());
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_any_batch(self, rays.pointer(), rays.stride(), count, layers, room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> raycastAnyBatch(Batch<Ray> rays, int layers) {
        return raycastAnyBatch(rays, layers, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> raycastAnyBatch(Batch<Ray> rays) {
        return raycastAnyBatch(rays, Gamephys.ALL_LAYERS, (Batch<Integer>) null);
    }

    /**
     * Every model that a ray meets, each once with its first hit, by t, then id.
     * Cost: O(log n + k log k) expected.
     */
    public Batch<Hit> raycastAll(Ray ray, int layers) {
        Scratch scratch = Scratch.get();
        return Low.list(Hit.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_raycast_all(self, scratch.put(1, ray), layers, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Hit> raycastAll(Ray ray) {
        return raycastAll(ray, Gamephys.ALL_LAYERS);
    }

    /**
     * Every model that each of the rays meets, as Scene.raycastAll: the hits of ray i are at
     * hits[offsets[i]] up to offsets[i + 1].
     * The contents of hits behind the last hit are unspecified.
     * Cost: that of as many single calls; shared among workers.
     */
    public Ragged<Hit> raycastAllBatch(Batch<Ray> rays, int layers) {
        int count = Low.common(rays.common());
        return Low.ragged(Hit.LAYOUT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_raycast_all_batch(self, rays.pointer(), rays.stride(), count, layers, room, capacity, offsets);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, rays);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Hit> raycastAllBatch(Batch<Ray> rays) {
        return raycastAllBatch(rays, Gamephys.ALL_LAYERS);
    }

    /**
     * Closest model along a segment from a to b, both included; t in 0..1. Fields as in
     * Gamephys.segmentTest.
     * Cost: O(log n) expected.
     * @return empty if nothing is found.
     */
    public Optional<Hit> segmentTest(Segment segment, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_segment_test(self, scratch.put(1, segment), layers, scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> segmentTest(Segment segment) {
        return segmentTest(segment, Gamephys.ALL_LAYERS);
    }

    /**
     * Closest models along the segments, as Scene.segmentTest; one that hits nothing gets model = 0 and t
     * = INFINITY.
     * Cost: that of as many single calls; shared among workers.
     */
    public Batch<Hit> segmentTestBatch(Batch<Segment> segments, int layers, Batch<Hit> out) {
        int count = Low.common(segments.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_segment_test_batch(self, segments.pointer(), segments.stride(), count, layers, room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, segments, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> segmentTestBatch(Batch<Segment> segments, int layers) {
        return segmentTestBatch(segments, layers, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> segmentTestBatch(Batch<Segment> segments) {
        return segmentTestBatch(segments, Gamephys.ALL_LAYERS, (Batch<Hit>) null);
    }

    /**
     * Ids of all models that overlap a sphere, capsule, AABB, OBB, plane, triangle or frustum, as
     * Gamephys.overlaps, ascending.
     * Cost: O(log n + k) expected, and O(k log k) to order hundreds of ids. Room in models for n / 32 + 64
     * more saves most of that, unless many models have replaced removed ones.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types of shapes
     */
    public Batch<Integer> overlap(Shape shape, int layers) {
        Scratch scratch = Scratch.get();
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(Low.mesh(shape));
                    try {
                        status = Low.gphys_scene_overlap(self, shape.kind(), Low.shape(shape, scratch, 2), layers, room, capacity, total);
                    } finally {
                        Owned.leave(Low.mesh(shape));
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shape);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> overlap(Shape shape) {
        return overlap(shape, Gamephys.ALL_LAYERS);
    }

    /**
     * Ids of all models that each of the shapes of one type overlaps, as Scene.overlap: those of shape i
     * are at models[offsets[i]] up to offsets[i + 1], as in Scene.raycastAllBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @throws GamephysException with ERROR_UNSUPPORTED: as there
     */
    public Ragged<Integer> overlapBatch(Shapes shapes, int layers) {
        int count = Low.common(shapes.common());
        return Low.ragged(Layout.INT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(shapes.mesh());
                    try {
                        status = Low.gphys_scene_overlap_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), count, layers, room, capacity, offsets);
                    } finally {
                        Owned.leave(shapes.mesh());
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shapes);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Integer> overlapBatch(Shapes shapes) {
        return overlapBatch(shapes, Gamephys.ALL_LAYERS);
    }

    /**
     * Ids of all models whose world box is not wholly outside any of a frustum's six planes or its own
     * box, ascending: for drawing. No visible model is missed. Some invisible ones near the frustum's
     * edges are listed, too: a few per cent more where models are compact or not rotated; about a third
     * more where they are long or flat and rotated, so that their world boxes are mostly empty, and as
     * many again as are visible where they are as long as the view is wide. Scene.overlap leaves these out
     * by testing the shapes. In scenes of more than 130 000 models, room for n / 32 more ids than are
     * listed is best: it is used to order them.
     * Cost: O(log n + k) expected.
     */
    public Batch<Integer> cull(Frustum frustum, int layers) {
        Scratch scratch = Scratch.get();
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_cull(self, scratch.put(1, frustum), layers, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> cull(Frustum frustum) {
        return cull(frustum, Gamephys.ALL_LAYERS);
    }

    /**
     * Ids of the models in each of count frusta, as Scene.cull: for split screens, cascades of shadow
     * maps, faces of a cube map, many sensors. Those of frustum i are at models[offsets[i]] up to
     * offsets[i + 1], as in Scene.raycastAllBatch.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     */
    public Ragged<Integer> cullBatch(Batch<Frustum> frusta, int layers) {
        int count = Low.common(frusta.common());
        return Low.ragged(Layout.INT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_cull_batch(self, frusta.pointer(), frusta.stride(), count, layers, room, capacity, offsets);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, frusta);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Integer> cullBatch(Batch<Frustum> frusta) {
        return cullBatch(frusta, Gamephys.ALL_LAYERS);
    }

    /**
     * The model nearest to a point, and its closest point.
     * Cost: O(log n) expected if all models are in the layers. Otherwise those that are not, and are
     * nearer than the answer, are visited in vain, until it is faster to test all models in the layers.
     * That takes time for them, for n / 64 words, and for 64 words where one of 64 consecutive models is
     * in the layers. So the nearest of 10 or of 1000 among 100 000 models takes some 3 us, and of 100 some
     * 15 us.
     * @param maxDistance metres, &gt;= 0, INFINITY allowed; a model at exactly this distance counts
     * @return empty if nothing is found.
     */
    public Optional<Nearest> nearest(Vec3 point, float maxDistance, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_nearest(self, scratch.put(1, point), maxDistance, layers, scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Nearest.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Nearest> nearest(Vec3 point, float maxDistance) {
        return nearest(point, maxDistance, Gamephys.ALL_LAYERS);
    }

    /** The same with defaults. */
    public Optional<Nearest> nearest(Vec3 point) {
        return nearest(point, Float.POSITIVE_INFINITY, Gamephys.ALL_LAYERS);
    }

    /**
     * The models nearest to the points, as Scene.nearest; a point with none gets model = 0 and distance =
     * INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param maxDistance metres, &gt;= 0, INFINITY allowed, for all points
     */
    public Batch<Nearest> nearestBatch(Batch<Vec3> points, float maxDistance, int layers, Batch<Nearest> out) {
        int count = Low.common(points.common());
        Batch<Nearest> room = Batch.room(Nearest.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_nearest_batch(self, points.pointer(), points.stride(), count, maxDistance, layers, room.pointer(), Nearest.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, points, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestBatch(Batch<Vec3> points, float maxDistance, int layers) {
        return nearestBatch(points, maxDistance, layers, (Batch<Nearest>) null);
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestBatch(Batch<Vec3> points, float maxDistance) {
        return nearestBatch(points, maxDistance, Gamephys.ALL_LAYERS, (Batch<Nearest>) null);
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestBatch(Batch<Vec3> points) {
        return nearestBatch(points, Float.POSITIVE_INFINITY, Gamephys.ALL_LAYERS, (Batch<Nearest>) null);
    }

    /**
     * First model that a sphere touches while it moves by displacement; t in 0..1. Fields as in
     * Gamephys.sweepSphere.
     * Cost: O(log n + k) expected, k the models that the swept box touches.
     * @param displacement metres; may be zero
     * @return empty if nothing is found.
     */
    public Optional<Hit> sweepSphere(Sphere sphere, Vec3 displacement, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_sweep_sphere(self, scratch.put(1, sphere), scratch.put(2, displacement), layers, scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> sweepSphere(Sphere sphere, Vec3 displacement) {
        return sweepSphere(sphere, displacement, Gamephys.ALL_LAYERS);
    }

    /**
     * First models that the spheres touch while each moves by its displacement, as Scene.sweepSphere; one
     * that touches nothing gets model = 0 and t = INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements metres
     */
    public Batch<Hit> sweepSphereBatch(Batch<Sphere> spheres, Batch<Vec3> displacements, int layers, Batch<Hit> out) {
        int count = Low.common(spheres.common(), displacements.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_sweep_sphere_batch(self, spheres.pointer(), spheres.stride(), displacements.pointer(), displacements.stride(), count, layers, room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, spheres, displacements, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> sweepSphereBatch(Batch<Sphere> spheres, Batch<Vec3> displacements, int layers) {
        return sweepSphereBatch(spheres, displacements, layers, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> sweepSphereBatch(Batch<Sphere> spheres, Batch<Vec3> displacements) {
        return sweepSphereBatch(spheres, displacements, Gamephys.ALL_LAYERS, (Batch<Hit>) null);
    }

    /**
     * First model that a sphere, capsule, AABB or OBB touches while it moves by displacement, without
     * turning; t in 0..1. Fields as in Gamephys.sweep.
     * Cost: O(log n + k) expected, k the models that the swept box touches.
     * @param displacement metres; may be zero
     * @return empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types
     */
    public Optional<Hit> sweep(Shape shape, Vec3 displacement, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(Low.mesh(shape));
            try {
                status = Low.gphys_scene_sweep(self, shape.kind(), Low.shape(shape, scratch, 2), scratch.put(3, displacement), layers, scratch.slot(5));
            } finally {
                Owned.leave(Low.mesh(shape));
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shape);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> sweep(Shape shape, Vec3 displacement) {
        return sweep(shape, displacement, Gamephys.ALL_LAYERS);
    }

    /**
     * First models that the shapes of one type touch while each moves by its displacement, as Scene.sweep;
     * one that touches nothing gets model = 0 and t = INFINITY.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements metres
     * @throws GamephysException with ERROR_UNSUPPORTED: as Scene.sweep
     */
    public Batch<Hit> sweepBatch(Shapes shapes, Batch<Vec3> displacements, int layers, Batch<Hit> out) {
        int count = Low.common(shapes.common(), displacements.common());
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(shapes.mesh());
            try {
                status = Low.gphys_scene_sweep_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), displacements.pointer(), displacements.stride(), count, layers, room.pointer(), Hit.LAYOUT.bytes());
            } finally {
                Owned.leave(shapes.mesh());
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shapes, displacements, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> sweepBatch(Shapes shapes, Batch<Vec3> displacements, int layers) {
        return sweepBatch(shapes, displacements, layers, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> sweepBatch(Shapes shapes, Batch<Vec3> displacements) {
        return sweepBatch(shapes, displacements, Gamephys.ALL_LAYERS, (Batch<Hit>) null);
    }

    /**
     * What a sphere, capsule, AABB or OBB overlaps, and how it gets out: an element for each model, and of
     * a mesh one for each triangle, as Gamephys.penetration. Deepest first; equal depths by model, then
     * triangle. Each is the way out of that one alone. The models are those of Scene.overlap.
     * Cost: O(log n + k log k) expected.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types
     */
    public Batch<Penetration> penetration(Shape shape, int layers) {
        Scratch scratch = Scratch.get();
        return Low.list(Penetration.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(Low.mesh(shape));
                    try {
                        status = Low.gphys_scene_penetration(self, shape.kind(), Low.shape(shape, scratch, 2), layers, room, capacity, total);
                    } finally {
                        Owned.leave(Low.mesh(shape));
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shape);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Penetration> penetration(Shape shape) {
        return penetration(shape, Gamephys.ALL_LAYERS);
    }

    /**
     * What each of the shapes of one type overlaps, and how it gets out, as Scene.penetration: the ways
     * out of shape i are at penetrations[offsets[i]] up to offsets[i + 1], as in Scene.raycastAllBatch. So
     * a crowd of characters is pushed out in one call.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: as Scene.penetration
     */
    public Ragged<Penetration> penetrationBatch(Shapes shapes, int layers) {
        int count = Low.common(shapes.common());
        return Low.ragged(Penetration.LAYOUT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(shapes.mesh());
                    try {
                        status = Low.gphys_scene_penetration_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), count, layers, room, capacity, offsets);
                    } finally {
                        Owned.leave(shapes.mesh());
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shapes);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Penetration> penetrationBatch(Shapes shapes) {
        return penetrationBatch(shapes, Gamephys.ALL_LAYERS);
    }

    /**
     * Closest model on a ray that the filter sees, as Scene.raycast.
     * Cost: that of Scene.raycast for one ignored model. For each model that is met within the ray's
     * reach, besides: O(its depth below its root) with FILTER_SUBTREE if ignored_model has children; of m
     * ignored_models O(log m) if they are ascending, as all lists of the library are, else O(m). Whether
     * they are takes O(m) a call. Where faces are left out, a batch tests a mesh one ray at a time.
     * @param filter null: the defaults
     * @return empty if nothing is found.
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for unknown flags, or ignored_models null
     *     with an ignored_count above 0
     */
    public Optional<Hit> raycastFiltered(Ray ray, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_filtered(self, scratch.put(1, ray), filter == null ? null : filter.pointer(), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, filter);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> raycastFiltered(Ray ray) {
        return raycastFiltered(ray, (QueryFilterDesc) null);
    }

    /**
     * Closest models on the rays that the filters see, as Scene.raycastBatch.
     * Cost: at most that of as many calls of Scene.raycastFiltered; shared among workers.
     * @param filters null: the defaults
     */
    public Batch<Hit> raycastFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters, Batch<Hit> out) {
        int count = Low.common(rays.common(), Batch.common(filters));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_filtered_batch(self, rays.pointer(), rays.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> raycastFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters) {
        return raycastFilteredBatch(rays, filters, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> raycastFilteredBatch(Batch<Ray> rays) {
        return raycastFilteredBatch(rays, (Batch<QueryFilterDesc>) null, (Batch<Hit>) null);
    }

    /**
     * How far each of the rays goes among the models that its filter sees, as Scene.raycastDistanceBatch:
     * a lidar leaves out the robot that carries it.
     * Cost: less than that of Scene.raycastFilteredBatch; shared among workers. Since 1.1.
     * @param filters null: the defaults
     */
    public Batch<Distance> raycastDistanceFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters, Batch<Distance> out) {
        int count = Low.common(rays.common(), Batch.common(filters));
        Batch<Distance> room = Batch.room(Distance.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_distance_filtered_batch(self, rays.pointer(), rays.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Distance.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Distance> raycastDistanceFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters) {
        return raycastDistanceFilteredBatch(rays, filters, (Batch<Distance>) null);
    }

    /** The same with defaults. */
    public Batch<Distance> raycastDistanceFilteredBatch(Batch<Ray> rays) {
        return raycastDistanceFilteredBatch(rays, (Batch<QueryFilterDesc>) null, (Batch<Distance>) null);
    }

    /**
     * Whether a ray meets anything that the filter sees, as Scene.raycastAny: line of sight between two
     * models that both are left out.
     * Cost: as Scene.raycastFiltered.
     * @param filter null: the defaults
     */
    public boolean raycastAnyFiltered(Ray ray, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_any_filtered(self, scratch.put(1, ray), filter == null ? null : filter.pointer(), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, filter);
        Low.check(status);
        return scratch.getInt(3) != 0;
    }

    /** The same with defaults. */
    public boolean raycastAnyFiltered(Ray ray) {
        return raycastAnyFiltered(ray, (QueryFilterDesc) null);
    }

    /**
     * Whether each of the rays meets anything that its filter sees, as Scene.raycastAnyBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @param filters null: the defaults
     */
    public Batch<Integer> raycastAnyFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters, Batch<Integer> out) {
        int count = Low.common(rays.common(), Batch.common(filters));
        Batch<Integer> room = Batch.room(Layout.INT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_raycast_any_filtered_batch(self, rays.pointer(), rays.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Layout.INT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, rays, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Integer> raycastAnyFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters) {
        return raycastAnyFilteredBatch(rays, filters, (Batch<Integer>) null);
    }

    /** The same with defaults. */
    public Batch<Integer> raycastAnyFilteredBatch(Batch<Ray> rays) {
        return raycastAnyFilteredBatch(rays, (Batch<QueryFilterDesc>) null, (Batch<Integer>) null);
    }

    /**
     * Every model that a ray meets and the filter sees, as Scene.raycastAll.
     * Cost: that of Scene.raycastAll, and for each model as Scene.raycastFiltered.
     * @param filter null: the defaults
     */
    public Batch<Hit> raycastAllFiltered(Ray ray, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        return Low.list(Hit.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_raycast_all_filtered(self, scratch.put(1, ray), filter == null ? null : filter.pointer(), room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Hit> raycastAllFiltered(Ray ray) {
        return raycastAllFiltered(ray, (QueryFilterDesc) null);
    }

    /**
     * Every model that each of the rays meets and its filter sees, as Scene.raycastAllBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param filters null: the defaults
     */
    public Ragged<Hit> raycastAllFilteredBatch(Batch<Ray> rays, Batch<QueryFilterDesc> filters) {
        int count = Low.common(rays.common(), Batch.common(filters));
        return Low.ragged(Hit.LAYOUT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_raycast_all_filtered_batch(self, rays.pointer(), rays.stride(), count, Batch.pointer(filters), Batch.stride(filters), room, capacity, offsets);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, rays, filters);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Hit> raycastAllFilteredBatch(Batch<Ray> rays) {
        return raycastAllFilteredBatch(rays, (Batch<QueryFilterDesc>) null);
    }

    /**
     * Closest model along a segment that the filter sees, as Scene.segmentTest.
     * Cost: as Scene.raycastFiltered.
     * @param filter null: the defaults
     * @return empty if nothing is found.
     */
    public Optional<Hit> segmentTestFiltered(Segment segment, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_segment_test_filtered(self, scratch.put(1, segment), filter == null ? null : filter.pointer(), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, filter);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> segmentTestFiltered(Segment segment) {
        return segmentTestFiltered(segment, (QueryFilterDesc) null);
    }

    /**
     * Closest models along the segments that the filters see, as Scene.segmentTestBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param filters null: the defaults
     */
    public Batch<Hit> segmentTestFilteredBatch(Batch<Segment> segments, Batch<QueryFilterDesc> filters, Batch<Hit> out) {
        int count = Low.common(segments.common(), Batch.common(filters));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_segment_test_filtered_batch(self, segments.pointer(), segments.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, segments, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> segmentTestFilteredBatch(Batch<Segment> segments, Batch<QueryFilterDesc> filters) {
        return segmentTestFilteredBatch(segments, filters, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> segmentTestFilteredBatch(Batch<Segment> segments) {
        return segmentTestFilteredBatch(segments, (Batch<QueryFilterDesc>) null, (Batch<Hit>) null);
    }

    /**
     * Ids of all models that overlap a shape and that the filter sees, as Scene.overlap.
     * Cost: that of Scene.overlap, and for each model as Scene.raycastFiltered.
     * @param filter null: the defaults
     * @throws GamephysException with ERROR_UNSUPPORTED: for types of shapes that Scene.overlap does not
     *     take
     */
    public Batch<Integer> overlapFiltered(Shape shape, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(Low.mesh(shape));
                    try {
                        status = Low.gphys_scene_overlap_filtered(self, shape.kind(), Low.shape(shape, scratch, 2), filter == null ? null : filter.pointer(), room, capacity, total);
                    } finally {
                        Owned.leave(Low.mesh(shape));
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shape, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> overlapFiltered(Shape shape) {
        return overlapFiltered(shape, (QueryFilterDesc) null);
    }

    /**
     * Ids of all models that each of the shapes of one type overlaps and its filter sees, as
     * Scene.overlapBatch.
     * Cost: at most that of as many single calls; shared among workers.
     * @param filters null: the defaults
     * @throws GamephysException with ERROR_UNSUPPORTED: as there
     */
    public Ragged<Integer> overlapFilteredBatch(Shapes shapes, Batch<QueryFilterDesc> filters) {
        int count = Low.common(shapes.common(), Batch.common(filters));
        return Low.ragged(Layout.INT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(shapes.mesh());
                    try {
                        status = Low.gphys_scene_overlap_filtered_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), count, Batch.pointer(filters), Batch.stride(filters), room, capacity, offsets);
                    } finally {
                        Owned.leave(shapes.mesh());
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shapes, filters);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Integer> overlapFilteredBatch(Shapes shapes) {
        return overlapFilteredBatch(shapes, (Batch<QueryFilterDesc>) null);
    }

    /**
     * Ids of all models in a frustum, by their world boxes, that the filter sees, as Scene.cull: a
     * player's own head, say, is not drawn.
     * Cost: that of Scene.cull, and for each model as Scene.raycastFiltered.
     * @param filter null: the defaults
     */
    public Batch<Integer> cullFiltered(Frustum frustum, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_cull_filtered(self, scratch.put(1, frustum), filter == null ? null : filter.pointer(), room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> cullFiltered(Frustum frustum) {
        return cullFiltered(frustum, (QueryFilterDesc) null);
    }

    /**
     * Ids of the models in each of count frusta that its filter sees, as Scene.cullBatch: each player's
     * view leaves out the player's own head.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @param filters null: the defaults
     */
    public Ragged<Integer> cullFilteredBatch(Batch<Frustum> frusta, Batch<QueryFilterDesc> filters) {
        int count = Low.common(frusta.common(), Batch.common(filters));
        return Low.ragged(Layout.INT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_cull_filtered_batch(self, frusta.pointer(), frusta.stride(), count, Batch.pointer(filters), Batch.stride(filters), room, capacity, offsets);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, frusta, filters);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Integer> cullFilteredBatch(Batch<Frustum> frusta) {
        return cullFilteredBatch(frusta, (Batch<QueryFilterDesc>) null);
    }

    /**
     * The model nearest to a point that the filter sees, as Scene.nearest: the nearest other model, if the
     * one at the point is left out.
     * Cost: that of Scene.nearest, and for each model as Scene.raycastFiltered; each ignored model that is
     * nearer than the answer is visited.
     * @param maxDistance metres, &gt;= 0, INFINITY allowed; a model at exactly this distance counts
     * @param filter null: the defaults
     * @return empty if nothing is found.
     */
    public Optional<Nearest> nearestFiltered(Vec3 point, float maxDistance, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_nearest_filtered(self, scratch.put(1, point), maxDistance, filter == null ? null : filter.pointer(), scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, filter);
        return Low.found(status) ? Optional.of(Nearest.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Nearest> nearestFiltered(Vec3 point, float maxDistance) {
        return nearestFiltered(point, maxDistance, (QueryFilterDesc) null);
    }

    /** The same with defaults. */
    public Optional<Nearest> nearestFiltered(Vec3 point) {
        return nearestFiltered(point, Float.POSITIVE_INFINITY, (QueryFilterDesc) null);
    }

    /**
     * The models nearest to the points that the filters see, as Scene.nearestBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param maxDistance metres, &gt;= 0, INFINITY allowed, for all points
     * @param filters null: the defaults
     */
    public Batch<Nearest> nearestFilteredBatch(Batch<Vec3> points, float maxDistance, Batch<QueryFilterDesc> filters, Batch<Nearest> out) {
        int count = Low.common(points.common(), Batch.common(filters));
        Batch<Nearest> room = Batch.room(Nearest.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_nearest_filtered_batch(self, points.pointer(), points.stride(), count, maxDistance, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Nearest.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, points, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestFilteredBatch(Batch<Vec3> points, float maxDistance, Batch<QueryFilterDesc> filters) {
        return nearestFilteredBatch(points, maxDistance, filters, (Batch<Nearest>) null);
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestFilteredBatch(Batch<Vec3> points, float maxDistance) {
        return nearestFilteredBatch(points, maxDistance, (Batch<QueryFilterDesc>) null, (Batch<Nearest>) null);
    }

    /** The same with defaults. */
    public Batch<Nearest> nearestFilteredBatch(Batch<Vec3> points) {
        return nearestFilteredBatch(points, Float.POSITIVE_INFINITY, (Batch<QueryFilterDesc>) null, (Batch<Nearest>) null);
    }

    /**
     * First model that a moving sphere touches and the filter sees, as Scene.sweepSphere: the sphere may
     * be the bounding sphere of the ignored model.
     * Cost: that of Scene.sweepSphere, and for each model as Scene.raycastFiltered.
     * @param displacement metres; may be zero
     * @param filter null: the defaults
     * @return empty if nothing is found.
     */
    public Optional<Hit> sweepSphereFiltered(Sphere sphere, Vec3 displacement, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_sweep_sphere_filtered(self, scratch.put(1, sphere), scratch.put(2, displacement), filter == null ? null : filter.pointer(), scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, filter);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(4))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> sweepSphereFiltered(Sphere sphere, Vec3 displacement) {
        return sweepSphereFiltered(sphere, displacement, (QueryFilterDesc) null);
    }

    /**
     * First models that count moving spheres touch and the filters see, as Scene.sweepSphereBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements metres
     * @param filters null: the defaults
     */
    public Batch<Hit> sweepSphereFilteredBatch(Batch<Sphere> spheres, Batch<Vec3> displacements, Batch<QueryFilterDesc> filters, Batch<Hit> out) {
        int count = Low.common(spheres.common(), displacements.common(), Batch.common(filters));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_sweep_sphere_filtered_batch(self, spheres.pointer(), spheres.stride(), displacements.pointer(), displacements.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Hit.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, spheres, displacements, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> sweepSphereFilteredBatch(Batch<Sphere> spheres, Batch<Vec3> displacements, Batch<QueryFilterDesc> filters) {
        return sweepSphereFilteredBatch(spheres, displacements, filters, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> sweepSphereFilteredBatch(Batch<Sphere> spheres, Batch<Vec3> displacements) {
        return sweepSphereFilteredBatch(spheres, displacements, (Batch<QueryFilterDesc>) null, (Batch<Hit>) null);
    }

    /**
     * First model that a moving sphere, capsule, AABB or OBB touches and the filter sees, as Scene.sweep:
     * a character leaves out its own model.
     * Cost: that of Scene.sweep, and for each model as Scene.raycastFiltered.
     * @param displacement metres; may be zero
     * @param filter null: the defaults
     * @return empty if nothing is found.
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types
     */
    public Optional<Hit> sweepFiltered(Shape shape, Vec3 displacement, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(Low.mesh(shape));
            try {
                status = Low.gphys_scene_sweep_filtered(self, shape.kind(), Low.shape(shape, scratch, 2), scratch.put(3, displacement), filter == null ? null : filter.pointer(), scratch.slot(5));
            } finally {
                Owned.leave(Low.mesh(shape));
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shape, filter);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> sweepFiltered(Shape shape, Vec3 displacement) {
        return sweepFiltered(shape, displacement, (QueryFilterDesc) null);
    }

    /**
     * First models that count moving shapes of one type touch and the filters see, as Scene.sweepBatch.
     * Cost: that of as many single calls; shared among workers.
     * @param displacements metres
     * @param filters null: the defaults
     * @throws GamephysException with ERROR_UNSUPPORTED: as Scene.sweep
     */
    public Batch<Hit> sweepFilteredBatch(Shapes shapes, Batch<Vec3> displacements, Batch<QueryFilterDesc> filters, Batch<Hit> out) {
        int count = Low.common(shapes.common(), displacements.common(), Batch.common(filters));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Owned.enter(shapes.mesh());
            try {
                status = Low.gphys_scene_sweep_filtered_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), displacements.pointer(), displacements.stride(), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Hit.LAYOUT.bytes());
            } finally {
                Owned.leave(shapes.mesh());
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, shapes, displacements, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> sweepFilteredBatch(Shapes shapes, Batch<Vec3> displacements, Batch<QueryFilterDesc> filters) {
        return sweepFilteredBatch(shapes, displacements, filters, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> sweepFilteredBatch(Shapes shapes, Batch<Vec3> displacements) {
        return sweepFilteredBatch(shapes, displacements, (Batch<QueryFilterDesc>) null, (Batch<Hit>) null);
    }

    /**
     * What a sphere, capsule, AABB or OBB overlaps and the filter sees, and how it gets out, as
     * Scene.penetration.
     * Cost: that of Scene.penetration, and for each model as Scene.raycastFiltered.
     * @param filter null: the defaults
     * @throws GamephysException with ERROR_UNSUPPORTED: for other types
     */
    public Batch<Penetration> penetrationFiltered(Shape shape, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        return Low.list(Penetration.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(Low.mesh(shape));
                    try {
                        status = Low.gphys_scene_penetration_filtered(self, shape.kind(), Low.shape(shape, scratch, 2), filter == null ? null : filter.pointer(), room, capacity, total);
                    } finally {
                        Owned.leave(Low.mesh(shape));
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shape, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Penetration> penetrationFiltered(Shape shape) {
        return penetrationFiltered(shape, (QueryFilterDesc) null);
    }

    /**
     * What each of the shapes of one type overlaps and its filter sees, and how it gets out, as
     * Scene.penetrationBatch: each character leaves out its own model.
     * Cost: that of as many single calls; shared among workers. Since 1.1.
     * @param filters null: the defaults
     * @throws GamephysException with ERROR_UNSUPPORTED: as Scene.penetration
     */
    public Ragged<Penetration> penetrationFilteredBatch(Shapes shapes, Batch<QueryFilterDesc> filters) {
        int count = Low.common(shapes.common(), Batch.common(filters));
        return Low.ragged(Penetration.LAYOUT, count, (room, capacity, offsets) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Owned.enter(shapes.mesh());
                    try {
                        status = Low.gphys_scene_penetration_filtered_batch(self, shapes.kind(), shapes.pointer(), shapes.stride(), count, Batch.pointer(filters), Batch.stride(filters), room, capacity, offsets);
                    } finally {
                        Owned.leave(shapes.mesh());
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, shapes, filters);
                return status;
            });
    }

    /** The same with defaults. */
    public Ragged<Penetration> penetrationFilteredBatch(Shapes shapes) {
        return penetrationFilteredBatch(shapes, (Batch<QueryFilterDesc>) null);
    }

    /**
     * Rebuild the scene's octree, as good as that of one Scene.addBatch. Never required: ids, answers and
     * their bits do not change. Where many models were added one by one, such as a level that was streamed
     * in, rays then take 0.6 to 0.95 of the time.
     * Cost: O(n log n), 0.15 to 0.45 us a model, less with workers; allocates. Since 1.1.
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: with nothing changed
     */
    public void rebuildOctree() {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_rebuild_octree(self);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Rebuild the octree in parts, one in each call, until it is as good as after Scene.rebuildOctree: for
     * levels that are streamed in while frames go on. Each Scene.add and Scene.remove does a part by
     * itself; these calls do the rest. Never needed: ids, answers and their bits stay as they are. Models
     * may be added, moved and removed between the calls. A call that updates an eighth of them or more
     * restarts it.
     * Cost: O(budget); allocates, until it is done about 130 bytes a model. Since 1.1.
     * @param budget how much work to do, as a number of models, of 0.3 to 3 us each. The work is the same
     *     on every machine and does not depend on time.
     * @return 1: nothing is left to do, since fewer than one in 64 models were added one by one; 0: call
     *     again.
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: : the octree is as before, and the next call
     *     begins again
     */
    public boolean maintainOctree(int budget) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_maintain_octree(self, budget, scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(2) != 0;
    }

    /**
     * How the scene's octree is made up.
     * Cost: O(nodes).
     */
    public OctreeStats getOctreeStats() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_octree_stats(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return OctreeStats.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Boxes of the scene's octree, each parent before its children.
     * Cost: O(nodes).
     */
    public Batch<OctreeBox> getOctreeBoxes() {
        return Low.list(OctreeBox.LAYOUT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_get_octree_boxes(self, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Check the scene's own structure: every model once in the tree, every box around its content, parents
     * and children in agreement, free slots free. For tests.
     * Cost: O(n).
     * @throws GamephysException with ERROR_INTERNAL: and the exception's message says what is wrong
     */
    public void validate() {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_validate(self);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Copy the whole state out: the origin, models with their ids, parents, tags, layers, transforms and
     * shapes, the order of future ids, and the octree. Workers and allocator are not in it.
     * Cost: O(n), some 80 bytes and 100 ns for each model, besides embedded meshes (Mesh.getSnapshot).
     * Allocates a few words for each different mesh.
     * @param embedMeshes true: meshes are in the snapshot, each once, so it is complete in itself: for
     *     saved games and for other machines. false: they are identified by their content, and
     *     Scene.restore looks for them: for undo, and rollback each frame.
     * @return the snapshot. Words are in the machine's byte order. Every later release of the same major
     *     version reads it.
     * @throws GamephysException with ERROR_CAPACITY: beyond 2^32 - 1 words
     */
    public Batch<Integer> getSnapshot(boolean embedMeshes) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    status = Low.gphys_scene_get_snapshot(self, embedMeshes ? 1 : 0, room, capacity, total);
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this);
                return status;
            });
    }

    /**
     * Replace the whole state by that of a snapshot, of this or of another scene. Ids are those of the
     * time of the snapshot, and so are future ones. All answers have the bits that they had then; a solver
     * that is restored with its scene continues with the same bits. On an error the scene is as before.
     * Any words are safe, also from an untrusted source: all that is used as a number or an index is
     * checked first. Forged words are refused, or taken as a scene like any other.
     * Cost: O(n), 150 to 700 ns for each model, besides embedded meshes (Mesh). Allocates.
     * @param library meshes that are not embedded are looked for among those that models of this scene
     *     use, by their content: vertices and indices. A mesh deformed since must get its old form back
     *     first. null: among those that models of `scene` itself use, before it is restored.
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: for words that are no snapshot of a scene,
     *     damaged, of a later format or of another byte order, and if a mesh is missing
     * @throws GamephysException with ERROR_OUT_OF_MEMORY: if there is no room for it
     */
    public void restore(Scene library, Batch<Integer> words) {
        int count = Low.common(words.common());
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer library_ = Owned.enter(library);
            try {
                status = Low.gphys_scene_restore(self, library_, words.pointer(), count);
            } finally {
                Owned.leave(library);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, library, words);
        Low.check(status);
    }

    /**
     * A hash of the whole state except the octree, the low half first; meshes count by their content.
     * Equal states have equal hashes on every machine; different ones differ with near certainty (not
     * against an adversary). Compare it between machines that run the same simulation, to detect when they
     * diverge.
     * Cost: O(n), some 50 ns for each model.
     */
    public int[] getHash() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_scene_get_hash(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.ints(1, 2);
    }
}
