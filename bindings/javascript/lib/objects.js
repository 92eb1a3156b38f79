// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
import { ALL_LAYERS, ERROR_INVALID_ID, OK } from './constants.js';
import { bits, flag, real, signed, whole } from './numbers.js';
import { readAabb, readBodyInfo, readBodySettings, readBreak, readFrustum, readHit, readMat4, readMeshInfo, readMeshReport, readModelInfo, readNearest, readOctreeStats, readOrbit, readOrbitSpeeds, readPenetration, readQuat, readRay, readSolverSettings, readSolverStats, readVec3, readWind, writeBodyDesc, writeBodySettings, writeCameraDesc, writeFrustum, writeMat4, writeMeshDesc, writeModelDesc, writeOrbit, writeOrbitSpeeds, writePlane, writeQuat, writeQueryFilterDesc, writeRay, writeSceneDesc, writeSegment, writeSolverDesc, writeSolverSettings, writeSphere, writeTransform, writeVec3, writeWind } from './structs.js';
import { Shape, runtime } from './runtime.js';

/** Everything of the library but constants, over one way to reach its memory and functions. */
export function objects(memory) {
    const { native, v, base, Handle, begin, check, common, finish, input, inputDescs, inputShapes, list, made, nothing,
        numbers, ascending, output, pass, pointer, putShape, ragged, rest, typeOf, more } = runtime(memory);

    class Mesh extends Handle {
        constructor(vertices, indices, desc) {
            super(() => {
                begin();
                if (desc != null) { check(native.gphys_mesh_desc_init(base, v.wide ? 24 : 16)); writeMeshDesc(v, 0, desc); }
                const vertices_ = input(vertices, 12, 'vertices', 'f32');
                const indices_ = input(indices ?? ascending(vertices_.length), 4, 'indices', 'u32');
                check(native.gphys_mesh_create(desc == null ? 0 : base, pass(vertices_), 12, vertices_.length, pass(indices_), indices_.numbers, base + 24));
                return made(24);
            }, native.gphys_mesh_destroy);
        }
        static hull(points, desc) {
            return Reflect.construct(Handle, [() => {
                begin();
                if (desc != null) { check(native.gphys_mesh_desc_init(base, v.wide ? 24 : 16)); writeMeshDesc(v, 0, desc); }
                const points_ = input(points, 12, 'points', 'f32');
                check(native.gphys_mesh_create_hull(desc == null ? 0 : base, pass(points_), 12, points_.length, base + 24));
                return made(24);
            }, native.gphys_mesh_destroy], Mesh);
        }
        static fromSnapshot(words, desc) {
            return Reflect.construct(Handle, [() => {
                begin();
                if (desc != null) { check(native.gphys_mesh_desc_init(base, v.wide ? 24 : 16)); writeMeshDesc(v, 0, desc); }
                const words_ = input(words, 4, 'words', 'u32');
                check(native.gphys_mesh_create_from_snapshot(desc == null ? 0 : base, pass(words_), words_.length, base + 24));
                return made(24);
            }, native.gphys_mesh_destroy], Mesh);
        }
        static fromScene(scene, model) {
            return Reflect.construct(Handle, [() => {
                check(native.gphys_scene_get_mesh(pointer(scene, Scene, 'scene', false), whole(model, 'model'), base));
                return made(0);
            }, native.gphys_mesh_destroy], Mesh);
        }
        static fromBody(solver, body, desc) {
            return Reflect.construct(Handle, [() => {
                if (desc != null) { check(native.gphys_mesh_desc_init(base, v.wide ? 24 : 16)); writeMeshDesc(v, 0, desc); }
                check(native.gphys_mesh_create_from_body(desc == null ? 0 : base, pointer(solver, Solver, 'solver', false), whole(body, 'body'), base + 24));
                return made(24);
            }, native.gphys_mesh_destroy], Mesh);
        }
        getHullPlanes() {
            begin();
            return list('plane', 0, (room, capacity) => native.gphys_mesh_get_hull_planes(this.pointer, room, capacity, base));
        }
        getHullFaces() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_mesh_get_hull_faces(this.pointer, room, capacity, base));
        }
        setVertices(vertices) {
            begin();
            const vertices_ = input(vertices, 12, 'vertices', 'f32');
            check(native.gphys_mesh_set_vertices(this.pointer, pass(vertices_), 12, vertices_.length));
        }
        getInfo() {
            check(native.gphys_mesh_get_info(this.pointer, base));
            return readMeshInfo(v, 0);
        }
        getReport() {
            check(native.gphys_mesh_get_report(this.pointer, base));
            return readMeshReport(v, 0);
        }
        getVertices() {
            begin();
            return list('vec3', 0, (room, capacity) => native.gphys_mesh_get_vertices(this.pointer, room, capacity, base));
        }
        getIndices() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_mesh_get_indices(this.pointer, room, capacity, base));
        }
        getSnapshot() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_mesh_get_snapshot(this.pointer, room, capacity, base));
        }
        raycastAll(ray) {
            begin();
            writeRay(v, 0, ray);
            return list('hit', 7, (room, capacity) => native.gphys_mesh_raycast_all(this.pointer, base, room, capacity, base + 28));
        }
        raycastAny(ray) {
            writeRay(v, 0, ray);
            check(native.gphys_mesh_raycast_any(this.pointer, base, base + 28));
            return v.i32[7] !== 0;
        }
        raycastAnyBatch(rays, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const out_hits_ = output(out, 'int32_t', count);
            check(native.gphys_mesh_raycast_any_batch(this.pointer, pass(rays_), 28, count, pass(out_hits_), 4));
            return finish(out_hits_);
        }
        raycastDistanceBatch(rays, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const out_distances_ = output(out, 'distance', count);
            check(native.gphys_mesh_raycast_distance_batch(this.pointer, pass(rays_), 28, count, pass(out_distances_), 12));
            return finish(out_distances_);
        }
        overlap(shape) {
            begin();
            return list('uint32_t', 27, (room, capacity) => native.gphys_mesh_overlap(this.pointer, typeOf(shape), putShape(shape, 0), room, capacity, base + 108));
        }
        getOctreeStats() {
            check(native.gphys_mesh_get_octree_stats(this.pointer, base));
            return readOctreeStats(v, 0);
        }
        getOctreeBoxes() {
            begin();
            return list('octree_box', 0, (room, capacity) => native.gphys_mesh_get_octree_boxes(this.pointer, room, capacity, base));
        }
    }
    class Scene extends Handle {
        constructor(desc) {
            super(() => {
                if (desc != null) { check(native.gphys_scene_desc_init(base, v.wide ? 40 : 24)); writeSceneDesc(v, 0, desc); }
                check(native.gphys_scene_create(desc == null ? 0 : base, base + 40));
                return made(40);
            }, native.gphys_scene_destroy);
        }
        setWorkerCount(workers) {
            check(native.gphys_scene_set_worker_count(this.pointer, whole(workers, 'workers')));
        }
        getWorkerCount() {
            check(native.gphys_scene_get_worker_count(this.pointer, base));
            return v.u32[0];
        }
        setOrigin(origin) {
            numbers(v.f64, 0, origin, 3, 'origin');
            check(native.gphys_scene_set_origin(this.pointer, base));
        }
        getOrigin() {
            check(native.gphys_scene_get_origin(this.pointer, base));
            return [v.f64[0], v.f64[1], v.f64[2]];
        }
        add(shape, transform, desc) {
            if (transform != null) { writeTransform(v, 28, transform); }
            if (desc != null) { check(native.gphys_model_desc_init(base + 144, 28)); writeModelDesc(v, 36, desc); }
            check(native.gphys_scene_add(this.pointer, typeOf(shape), putShape(shape, 0), transform == null ? 0 : base + 112, desc == null ? 0 : base + 144, base + 172));
            return v.u32[43];
        }
        addBatch(shapes, transforms, desc, out) {
            begin();
            const shapes_ = inputShapes(shapes);
            const transforms_ = transforms == null ? nothing : input(transforms, 32, 'transforms', 'f32');
            if (desc != null) { check(native.gphys_model_desc_init(base, 28)); writeModelDesc(v, 0, desc); }
            const count = common(shapes_, transforms_);
            const out_models_ = output(out, 'uint32_t', count);
            check(native.gphys_scene_add_batch(this.pointer, shapes_.type, pass(shapes_), shapes_.stride, pass(transforms_), transforms_.stride, count, desc == null ? 0 : base, pass(out_models_)));
            return finish(out_models_);
        }
        addDescribedBatch(shapes, transforms, descs, out) {
            begin();
            const shapes_ = inputShapes(shapes);
            const transforms_ = transforms == null ? nothing : input(transforms, 32, 'transforms', 'f32');
            const descs_ = descs == null ? nothing : inputDescs(descs, 0, 28, native.gphys_model_desc_init, writeModelDesc, 'descs');
            const count = common(shapes_, transforms_, descs_);
            const out_models_ = output(out, 'uint32_t', count);
            check(native.gphys_scene_add_described_batch(this.pointer, shapes_.type, pass(shapes_), shapes_.stride, pass(transforms_), transforms_.stride, pass(descs_), descs_.stride, count, pass(out_models_)));
            return finish(out_models_);
        }
        remove(model) {
            check(native.gphys_scene_remove(this.pointer, whole(model, 'model')));
        }
        removeBatch(models) {
            begin();
            const models_ = input(models, 4, 'models', 'u32');
            const count = common(models_);
            check(native.gphys_scene_remove_batch(this.pointer, pass(models_), count));
        }
        removeSubtree(model) {
            check(native.gphys_scene_remove_subtree(this.pointer, whole(model, 'model')));
        }
        clear() {
            check(native.gphys_scene_clear(this.pointer));
        }
        has(model) {
            const status = native.gphys_scene_has(this.pointer, whole(model, 'model'));
            return status !== ERROR_INVALID_ID && check(status) === OK;
        }
        getModels() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_scene_get_models(this.pointer, room, capacity, base));
        }
        getRoots() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_scene_get_roots(this.pointer, room, capacity, base));
        }
        getChildren(model) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_scene_get_children(this.pointer, whole(model, 'model'), room, capacity, base));
        }
        getInfo(model) {
            check(native.gphys_scene_get_info(this.pointer, whole(model, 'model'), base));
            return readModelInfo(v, 0);
        }
        getBounds(model) {
            if (check(native.gphys_scene_get_bounds(this.pointer, whole(model, 'model'), base)) !== OK) return null;
            return readAabb(v, 0);
        }
        getSceneBounds() {
            if (check(native.gphys_scene_get_scene_bounds(this.pointer, base)) !== OK) return null;
            return readAabb(v, 0);
        }
        setShape(model, shape) {
            check(native.gphys_scene_set_shape(this.pointer, whole(model, 'model'), typeOf(shape), putShape(shape, 0)));
        }
        setScale(model, scale) {
            writeVec3(v, 0, scale);
            check(native.gphys_scene_set_scale(this.pointer, whole(model, 'model'), base));
        }
        getScale(model) {
            check(native.gphys_scene_get_scale(this.pointer, whole(model, 'model'), base));
            return readVec3(v, 0);
        }
        setLayers(model, layers) {
            check(native.gphys_scene_set_layers(this.pointer, whole(model, 'model'), bits(layers, 'layers')));
        }
        setTag(model, tag) {
            check(native.gphys_scene_set_tag(this.pointer, whole(model, 'model'), whole(tag, 'tag')));
        }
        setParent(model, parent, keep_world) {
            check(native.gphys_scene_set_parent(this.pointer, whole(model, 'model'), whole(parent, 'parent'), flag(keep_world, 'keep_world')));
        }
        setTransform(model, transform) {
            writeTransform(v, 0, transform);
            check(native.gphys_scene_set_transform(this.pointer, whole(model, 'model'), base));
        }
        setTransforms(models, transforms) {
            begin();
            const models_ = input(models, 4, 'models', 'u32');
            const transforms_ = input(transforms, 32, 'transforms', 'f32');
            const count = common(models_, transforms_);
            check(native.gphys_scene_set_transforms(this.pointer, pass(models_), pass(transforms_), 32, count));
        }
        getTransforms(models, out) {
            begin();
            const models_ = input(models, 4, 'models', 'u32');
            const count = common(models_);
            const out_transforms_ = output(out, 'transform', count);
            check(native.gphys_scene_get_transforms(this.pointer, pass(models_), count, pass(out_transforms_), 32));
            return finish(out_transforms_);
        }
        getWorldTransforms(models, out) {
            begin();
            const models_ = input(models, 4, 'models', 'u32');
            const count = common(models_);
            const out_transforms_ = output(out, 'transform', count);
            check(native.gphys_scene_get_world_transforms(this.pointer, pass(models_), count, pass(out_transforms_), 32));
            return finish(out_transforms_);
        }
        raycast(ray, layers = ALL_LAYERS) {
            writeRay(v, 0, ray);
            if (check(native.gphys_scene_raycast(this.pointer, base, bits(layers, 'layers'), base + 28)) !== OK) return null;
            return readHit(v, 7);
        }
        raycastBatch(rays, layers = ALL_LAYERS, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_raycast_batch(this.pointer, pass(rays_), 28, count, bits(layers, 'layers'), pass(out_hits_), 52));
            return finish(out_hits_);
        }
        raycastDistanceBatch(rays, layers = ALL_LAYERS, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const out_distances_ = output(out, 'distance', count);
            check(native.gphys_scene_raycast_distance_batch(this.pointer, pass(rays_), 28, count, bits(layers, 'layers'), pass(out_distances_), 12));
            return finish(out_distances_);
        }
        raycastAny(ray, layers = ALL_LAYERS) {
            writeRay(v, 0, ray);
            check(native.gphys_scene_raycast_any(this.pointer, base, bits(layers, 'layers'), base + 28));
            return v.i32[7] !== 0;
        }
        raycastAnyBatch(rays, layers = ALL_LAYERS, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const out_hits_ = output(out, 'int32_t', count);
            check(native.gphys_scene_raycast_any_batch(this.pointer, pass(rays_), 28, count, bits(layers, 'layers'), pass(out_hits_), 4));
            return finish(out_hits_);
        }
        raycastAll(ray, layers = ALL_LAYERS) {
            begin();
            writeRay(v, 0, ray);
            return list('hit', 7, (room, capacity) => native.gphys_scene_raycast_all(this.pointer, base, bits(layers, 'layers'), room, capacity, base + 28));
        }
        raycastAllBatch(rays, layers = ALL_LAYERS) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const count = common(rays_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const raysAt = pass(rays_);
            const out_offsetsAt = pass(offsets);
            return ragged('hit', offsets, (room, capacity) => native.gphys_scene_raycast_all_batch(this.pointer, raysAt, 28, count, bits(layers, 'layers'), room, capacity, out_offsetsAt));
        }
        segmentTest(segment, layers = ALL_LAYERS) {
            writeSegment(v, 0, segment);
            if (check(native.gphys_scene_segment_test(this.pointer, base, bits(layers, 'layers'), base + 24)) !== OK) return null;
            return readHit(v, 6);
        }
        segmentTestBatch(segments, layers = ALL_LAYERS, out) {
            begin();
            const segments_ = input(segments, 24, 'segments', 'f32');
            const count = common(segments_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_segment_test_batch(this.pointer, pass(segments_), 24, count, bits(layers, 'layers'), pass(out_hits_), 52));
            return finish(out_hits_);
        }
        overlap(shape, layers = ALL_LAYERS) {
            begin();
            return list('uint32_t', 27, (room, capacity) => native.gphys_scene_overlap(this.pointer, typeOf(shape), putShape(shape, 0), bits(layers, 'layers'), room, capacity, base + 108));
        }
        overlapBatch(shapes, layers = ALL_LAYERS) {
            begin();
            const shapes_ = inputShapes(shapes);
            const count = common(shapes_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const shapesAt = pass(shapes_);
            const out_offsetsAt = pass(offsets);
            return ragged('uint32_t', offsets, (room, capacity) => native.gphys_scene_overlap_batch(this.pointer, shapes_.type, shapesAt, shapes_.stride, count, bits(layers, 'layers'), room, capacity, out_offsetsAt));
        }
        cull(frustum, layers = ALL_LAYERS) {
            begin();
            writeFrustum(v, 0, frustum);
            return list('uint32_t', 27, (room, capacity) => native.gphys_scene_cull(this.pointer, base, bits(layers, 'layers'), room, capacity, base + 108));
        }
        cullBatch(frusta, layers = ALL_LAYERS) {
            begin();
            const frusta_ = input(frusta, 108, 'frusta', 'f32');
            const count = common(frusta_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const frustaAt = pass(frusta_);
            const out_offsetsAt = pass(offsets);
            return ragged('uint32_t', offsets, (room, capacity) => native.gphys_scene_cull_batch(this.pointer, frustaAt, 108, count, bits(layers, 'layers'), room, capacity, out_offsetsAt));
        }
        nearest(point, max_distance = Infinity, layers = ALL_LAYERS) {
            writeVec3(v, 0, point);
            if (check(native.gphys_scene_nearest(this.pointer, base, real(max_distance, 'max_distance'), bits(layers, 'layers'), base + 12)) !== OK) return null;
            return readNearest(v, 3);
        }
        nearestBatch(points, max_distance = Infinity, layers = ALL_LAYERS, out) {
            begin();
            const points_ = input(points, 12, 'points', 'f32');
            const count = common(points_);
            const out_nearest_ = output(out, 'nearest', count);
            check(native.gphys_scene_nearest_batch(this.pointer, pass(points_), 12, count, real(max_distance, 'max_distance'), bits(layers, 'layers'), pass(out_nearest_), 28));
            return finish(out_nearest_);
        }
        sweepSphere(sphere, displacement, layers = ALL_LAYERS) {
            writeSphere(v, 0, sphere);
            writeVec3(v, 4, displacement);
            if (check(native.gphys_scene_sweep_sphere(this.pointer, base, base + 16, bits(layers, 'layers'), base + 28)) !== OK) return null;
            return readHit(v, 7);
        }
        sweepSphereBatch(spheres, displacements, layers = ALL_LAYERS, out) {
            begin();
            const spheres_ = input(spheres, 16, 'spheres', 'f32');
            const displacements_ = input(displacements, 12, 'displacements', 'f32');
            const count = common(spheres_, displacements_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_sweep_sphere_batch(this.pointer, pass(spheres_), 16, pass(displacements_), 12, count, bits(layers, 'layers'), pass(out_hits_), 52));
            return finish(out_hits_);
        }
        sweep(shape, displacement, layers = ALL_LAYERS) {
            writeVec3(v, 28, displacement);
            if (check(native.gphys_scene_sweep(this.pointer, typeOf(shape), putShape(shape, 0), base + 112, bits(layers, 'layers'), base + 124)) !== OK) return null;
            return readHit(v, 31);
        }
        sweepBatch(shapes, displacements, layers = ALL_LAYERS, out) {
            begin();
            const shapes_ = inputShapes(shapes);
            const displacements_ = input(displacements, 12, 'displacements', 'f32');
            const count = common(shapes_, displacements_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_sweep_batch(this.pointer, shapes_.type, pass(shapes_), shapes_.stride, pass(displacements_), 12, count, bits(layers, 'layers'), pass(out_hits_), 52));
            return finish(out_hits_);
        }
        penetration(shape, layers = ALL_LAYERS) {
            begin();
            return list('penetration', 27, (room, capacity) => native.gphys_scene_penetration(this.pointer, typeOf(shape), putShape(shape, 0), bits(layers, 'layers'), room, capacity, base + 108));
        }
        penetrationBatch(shapes, layers = ALL_LAYERS) {
            begin();
            const shapes_ = inputShapes(shapes);
            const count = common(shapes_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const shapesAt = pass(shapes_);
            const out_offsetsAt = pass(offsets);
            return ragged('penetration', offsets, (room, capacity) => native.gphys_scene_penetration_batch(this.pointer, shapes_.type, shapesAt, shapes_.stride, count, bits(layers, 'layers'), room, capacity, out_offsetsAt));
        }
        raycastFiltered(ray, filter) {
            begin();
            writeRay(v, 0, ray);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 32, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 8, filter); }
            if (check(native.gphys_scene_raycast_filtered(this.pointer, base, filter == null ? 0 : base + 32, base + 64)) !== OK) return null;
            return readHit(v, 16);
        }
        raycastFilteredBatch(rays, filters, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(rays_, filters_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_raycast_filtered_batch(this.pointer, pass(rays_), 28, count, pass(filters_), filters_.stride, pass(out_hits_), 52));
            return finish(out_hits_);
        }
        raycastDistanceFilteredBatch(rays, filters, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(rays_, filters_);
            const out_distances_ = output(out, 'distance', count);
            check(native.gphys_scene_raycast_distance_filtered_batch(this.pointer, pass(rays_), 28, count, pass(filters_), filters_.stride, pass(out_distances_), 12));
            return finish(out_distances_);
        }
        raycastAnyFiltered(ray, filter) {
            begin();
            writeRay(v, 0, ray);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 32, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 8, filter); }
            check(native.gphys_scene_raycast_any_filtered(this.pointer, base, filter == null ? 0 : base + 32, base + 64));
            return v.i32[16] !== 0;
        }
        raycastAnyFilteredBatch(rays, filters, out) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(rays_, filters_);
            const out_hits_ = output(out, 'int32_t', count);
            check(native.gphys_scene_raycast_any_filtered_batch(this.pointer, pass(rays_), 28, count, pass(filters_), filters_.stride, pass(out_hits_), 4));
            return finish(out_hits_);
        }
        raycastAllFiltered(ray, filter) {
            begin();
            writeRay(v, 0, ray);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 32, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 8, filter); }
            return list('hit', 16, (room, capacity) => native.gphys_scene_raycast_all_filtered(this.pointer, base, filter == null ? 0 : base + 32, room, capacity, base + 64));
        }
        raycastAllFilteredBatch(rays, filters) {
            begin();
            const rays_ = input(rays, 28, 'rays', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(rays_, filters_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const raysAt = pass(rays_);
            const filtersAt = pass(filters_);
            const out_offsetsAt = pass(offsets);
            return ragged('hit', offsets, (room, capacity) => native.gphys_scene_raycast_all_filtered_batch(this.pointer, raysAt, 28, count, filtersAt, filters_.stride, room, capacity, out_offsetsAt));
        }
        segmentTestFiltered(segment, filter) {
            begin();
            writeSegment(v, 0, segment);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 24, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 6, filter); }
            if (check(native.gphys_scene_segment_test_filtered(this.pointer, base, filter == null ? 0 : base + 24, base + 56)) !== OK) return null;
            return readHit(v, 14);
        }
        segmentTestFilteredBatch(segments, filters, out) {
            begin();
            const segments_ = input(segments, 24, 'segments', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(segments_, filters_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_segment_test_filtered_batch(this.pointer, pass(segments_), 24, count, pass(filters_), filters_.stride, pass(out_hits_), 52));
            return finish(out_hits_);
        }
        overlapFiltered(shape, filter) {
            begin();
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 112, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 28, filter); }
            return list('uint32_t', 36, (room, capacity) => native.gphys_scene_overlap_filtered(this.pointer, typeOf(shape), putShape(shape, 0), filter == null ? 0 : base + 112, room, capacity, base + 144));
        }
        overlapFilteredBatch(shapes, filters) {
            begin();
            const shapes_ = inputShapes(shapes);
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(shapes_, filters_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const shapesAt = pass(shapes_);
            const filtersAt = pass(filters_);
            const out_offsetsAt = pass(offsets);
            return ragged('uint32_t', offsets, (room, capacity) => native.gphys_scene_overlap_filtered_batch(this.pointer, shapes_.type, shapesAt, shapes_.stride, count, filtersAt, filters_.stride, room, capacity, out_offsetsAt));
        }
        cullFiltered(frustum, filter) {
            begin();
            writeFrustum(v, 0, frustum);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 112, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 28, filter); }
            return list('uint32_t', 36, (room, capacity) => native.gphys_scene_cull_filtered(this.pointer, base, filter == null ? 0 : base + 112, room, capacity, base + 144));
        }
        cullFilteredBatch(frusta, filters) {
            begin();
            const frusta_ = input(frusta, 108, 'frusta', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(frusta_, filters_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const frustaAt = pass(frusta_);
            const filtersAt = pass(filters_);
            const out_offsetsAt = pass(offsets);
            return ragged('uint32_t', offsets, (room, capacity) => native.gphys_scene_cull_filtered_batch(this.pointer, frustaAt, 108, count, filtersAt, filters_.stride, room, capacity, out_offsetsAt));
        }
        nearestFiltered(point, max_distance = Infinity, filter) {
            begin();
            writeVec3(v, 0, point);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 16, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 4, filter); }
            if (check(native.gphys_scene_nearest_filtered(this.pointer, base, real(max_distance, 'max_distance'), filter == null ? 0 : base + 16, base + 48)) !== OK) return null;
            return readNearest(v, 12);
        }
        nearestFilteredBatch(points, max_distance = Infinity, filters, out) {
            begin();
            const points_ = input(points, 12, 'points', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(points_, filters_);
            const out_nearest_ = output(out, 'nearest', count);
            check(native.gphys_scene_nearest_filtered_batch(this.pointer, pass(points_), 12, count, real(max_distance, 'max_distance'), pass(filters_), filters_.stride, pass(out_nearest_), 28));
            return finish(out_nearest_);
        }
        sweepSphereFiltered(sphere, displacement, filter) {
            begin();
            writeSphere(v, 0, sphere);
            writeVec3(v, 4, displacement);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 32, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 8, filter); }
            if (check(native.gphys_scene_sweep_sphere_filtered(this.pointer, base, base + 16, filter == null ? 0 : base + 32, base + 64)) !== OK) return null;
            return readHit(v, 16);
        }
        sweepSphereFilteredBatch(spheres, displacements, filters, out) {
            begin();
            const spheres_ = input(spheres, 16, 'spheres', 'f32');
            const displacements_ = input(displacements, 12, 'displacements', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(spheres_, displacements_, filters_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_sweep_sphere_filtered_batch(this.pointer, pass(spheres_), 16, pass(displacements_), 12, count, pass(filters_), filters_.stride, pass(out_hits_), 52));
            return finish(out_hits_);
        }
        sweepFiltered(shape, displacement, filter) {
            begin();
            writeVec3(v, 28, displacement);
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 128, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 32, filter); }
            if (check(native.gphys_scene_sweep_filtered(this.pointer, typeOf(shape), putShape(shape, 0), base + 112, filter == null ? 0 : base + 128, base + 160)) !== OK) return null;
            return readHit(v, 40);
        }
        sweepFilteredBatch(shapes, displacements, filters, out) {
            begin();
            const shapes_ = inputShapes(shapes);
            const displacements_ = input(displacements, 12, 'displacements', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(shapes_, displacements_, filters_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_scene_sweep_filtered_batch(this.pointer, shapes_.type, pass(shapes_), shapes_.stride, pass(displacements_), 12, count, pass(filters_), filters_.stride, pass(out_hits_), 52));
            return finish(out_hits_);
        }
        penetrationFiltered(shape, filter) {
            begin();
            if (filter != null) { check(native.gphys_query_filter_desc_init(base + 112, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 28, filter); }
            return list('penetration', 36, (room, capacity) => native.gphys_scene_penetration_filtered(this.pointer, typeOf(shape), putShape(shape, 0), filter == null ? 0 : base + 112, room, capacity, base + 144));
        }
        penetrationFilteredBatch(shapes, filters) {
            begin();
            const shapes_ = inputShapes(shapes);
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(shapes_, filters_);
            const offsets = output(undefined, 'uint32_t', count + 1);
            const shapesAt = pass(shapes_);
            const filtersAt = pass(filters_);
            const out_offsetsAt = pass(offsets);
            return ragged('penetration', offsets, (room, capacity) => native.gphys_scene_penetration_filtered_batch(this.pointer, shapes_.type, shapesAt, shapes_.stride, count, filtersAt, filters_.stride, room, capacity, out_offsetsAt));
        }
        rebuildOctree() {
            check(native.gphys_scene_rebuild_octree(this.pointer));
        }
        maintainOctree(budget) {
            check(native.gphys_scene_maintain_octree(this.pointer, whole(budget, 'budget'), base));
            return v.i32[0] !== 0;
        }
        getOctreeStats() {
            check(native.gphys_scene_get_octree_stats(this.pointer, base));
            return readOctreeStats(v, 0);
        }
        getOctreeBoxes() {
            begin();
            return list('octree_box', 0, (room, capacity) => native.gphys_scene_get_octree_boxes(this.pointer, room, capacity, base));
        }
        validate() {
            check(native.gphys_scene_validate(this.pointer));
        }
        getSnapshot(embed_meshes) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_scene_get_snapshot(this.pointer, flag(embed_meshes, 'embed_meshes'), room, capacity, base));
        }
        restore(library, words) {
            begin();
            const words_ = input(words, 4, 'words', 'u32');
            const count = common(words_);
            check(native.gphys_scene_restore(this.pointer, pointer(library, Scene, 'library', true), pass(words_), count));
        }
        getHash() {
            check(native.gphys_scene_get_hash(this.pointer, base));
            return [v.u32[0], v.u32[1]];
        }
    }
    class Camera extends Handle {
        constructor(desc) {
            super(() => {
                if (desc != null) { check(native.gphys_camera_desc_init(base, v.wide ? 40 : 32)); writeCameraDesc(v, 0, desc); }
                check(native.gphys_camera_create(desc == null ? 0 : base, base + 40));
                return made(40);
            }, native.gphys_camera_destroy);
        }
        setOrigin(origin) {
            numbers(v.f64, 0, origin, 3, 'origin');
            check(native.gphys_camera_set_origin(this.pointer, base));
        }
        getOrigin() {
            check(native.gphys_camera_get_origin(this.pointer, base));
            return [v.f64[0], v.f64[1], v.f64[2]];
        }
        setPerspective(fov_y, near_distance, far_distance) {
            check(native.gphys_camera_set_perspective(this.pointer, real(fov_y, 'fov_y'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')));
        }
        setOrthographic(height, near_distance, far_distance) {
            check(native.gphys_camera_set_orthographic(this.pointer, real(height, 'height'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')));
        }
        setProjection(projection) {
            writeMat4(v, 0, projection);
            check(native.gphys_camera_set_projection(this.pointer, base));
        }
        setPerspectiveAspect(fov_y, aspect, near_distance, far_distance) {
            check(native.gphys_camera_set_perspective_aspect(this.pointer, real(fov_y, 'fov_y'), real(aspect, 'aspect'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')));
        }
        setOrthographicSize(width, height, near_distance, far_distance) {
            check(native.gphys_camera_set_orthographic_size(this.pointer, real(width, 'width'), real(height, 'height'), real(near_distance, 'near_distance'), real(far_distance, 'far_distance')));
        }
        setViewport(width, height) {
            check(native.gphys_camera_set_viewport(this.pointer, real(width, 'width'), real(height, 'height')));
        }
        setViewportOrigin(x, y) {
            check(native.gphys_camera_set_viewport_origin(this.pointer, real(x, 'x'), real(y, 'y')));
        }
        setPickStart(start) {
            check(native.gphys_camera_set_pick_start(this.pointer, signed(start, 'start')));
        }
        getProjection() {
            check(native.gphys_camera_get_projection(this.pointer, base, base + 4, base + 8, base + 12));
            return [v.i32[0], v.f32[1], v.f32[2], v.f32[3]];
        }
        getViewport() {
            check(native.gphys_camera_get_viewport(this.pointer, base, base + 4));
            return [v.f32[0], v.f32[1]];
        }
        getViewportOrigin() {
            check(native.gphys_camera_get_viewport_origin(this.pointer, base, base + 4));
            return [v.f32[0], v.f32[1]];
        }
        getAspect() {
            check(native.gphys_camera_get_aspect(this.pointer, base, base + 4));
            return [v.f32[0], v.i32[1] !== 0];
        }
        getImageSize() {
            check(native.gphys_camera_get_image_size(this.pointer, base, base + 4));
            return [v.f32[0], v.f32[1]];
        }
        getPickStart() {
            check(native.gphys_camera_get_pick_start(this.pointer, base));
            return v.i32[0];
        }
        getConventions() {
            check(native.gphys_camera_get_conventions(this.pointer, base, base + 4, base + 8));
            return [v.i32[0], v.i32[1], v.i32[2] !== 0];
        }
        setTransform(position, rotation) {
            writeVec3(v, 0, position);
            writeQuat(v, 4, rotation);
            check(native.gphys_camera_set_transform(this.pointer, base, base + 16));
        }
        setWorldMatrix(world) {
            writeMat4(v, 0, world);
            check(native.gphys_camera_set_world_matrix(this.pointer, base));
        }
        setViewMatrix(view) {
            writeMat4(v, 0, view);
            check(native.gphys_camera_set_view_matrix(this.pointer, base));
        }
        lookAt(eye, target, up) {
            writeVec3(v, 0, eye);
            writeVec3(v, 4, target);
            writeVec3(v, 8, up);
            check(native.gphys_camera_look_at(this.pointer, base, base + 16, base + 32));
        }
        getTransform() {
            check(native.gphys_camera_get_transform(this.pointer, base, base + 12));
            return [readVec3(v, 0), readQuat(v, 3)];
        }
        getWorldMatrix() {
            check(native.gphys_camera_get_world_matrix(this.pointer, base));
            return readMat4(v, 0);
        }
        getViewMatrix() {
            check(native.gphys_camera_get_view_matrix(this.pointer, base));
            return readMat4(v, 0);
        }
        getProjectionMatrix() {
            check(native.gphys_camera_get_projection_matrix(this.pointer, base));
            return readMat4(v, 0);
        }
        getViewProjectionMatrix() {
            check(native.gphys_camera_get_view_projection_matrix(this.pointer, base));
            return readMat4(v, 0);
        }
        setOrbit(orbit) {
            writeOrbit(v, 0, orbit);
            check(native.gphys_camera_set_orbit(this.pointer, base));
        }
        getOrbit() {
            check(native.gphys_camera_get_orbit(this.pointer, base));
            return readOrbit(v, 0);
        }
        setOrbitSpeeds(speeds) {
            writeOrbitSpeeds(v, 0, speeds);
            check(native.gphys_camera_set_orbit_speeds(this.pointer, base));
        }
        getOrbitSpeeds() {
            check(native.gphys_camera_get_orbit_speeds(this.pointer, base));
            return readOrbitSpeeds(v, 0);
        }
        orbitRotate(units_x, units_y) {
            check(native.gphys_camera_orbit_rotate(this.pointer, real(units_x, 'units_x'), real(units_y, 'units_y')));
        }
        orbitZoom(units) {
            check(native.gphys_camera_orbit_zoom(this.pointer, real(units, 'units')));
        }
        orbitPan(units_right, units_up) {
            check(native.gphys_camera_orbit_pan(this.pointer, real(units_right, 'units_right'), real(units_up, 'units_up')));
        }
        orbitUpdate() {
            check(native.gphys_camera_orbit_update(this.pointer));
        }
        getFrustum() {
            check(native.gphys_camera_get_frustum(this.pointer, base));
            return readFrustum(v, 0);
        }
        getCorners() {
            if (check(native.gphys_camera_get_corners(this.pointer, base)) !== OK) return null;
            return [readVec3(v, 0), readVec3(v, 3), readVec3(v, 6), readVec3(v, 9), readVec3(v, 12), readVec3(v, 15), readVec3(v, 18), readVec3(v, 21)];
        }
        getRectangleFrustum(x0, y0, x1, y1) {
            check(native.gphys_camera_get_rectangle_frustum(this.pointer, real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), base));
            return readFrustum(v, 0);
        }
        getRectangleCorners(x0, y0, x1, y1) {
            if (check(native.gphys_camera_get_rectangle_corners(this.pointer, real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), base)) !== OK) return null;
            return [readVec3(v, 0), readVec3(v, 3), readVec3(v, 6), readVec3(v, 9), readVec3(v, 12), readVec3(v, 15), readVec3(v, 18), readVec3(v, 21)];
        }
        project(point) {
            writeVec3(v, 0, point);
            if (check(native.gphys_camera_project(this.pointer, base, base + 12)) !== OK) return null;
            return readVec3(v, 3);
        }
        projectBatch(points, out) {
            begin();
            const points_ = input(points, 12, 'points', 'f32');
            const count = common(points_);
            const out_pixels_ = output(out, 'vec3', count);
            check(native.gphys_camera_project_batch(this.pointer, pass(points_), 12, count, pass(out_pixels_), 12));
            return finish(out_pixels_);
        }
        unproject(pixel) {
            writeVec3(v, 0, pixel);
            if (check(native.gphys_camera_unproject(this.pointer, base, base + 12)) !== OK) return null;
            return readVec3(v, 3);
        }
        unprojectBatch(pixels, out) {
            begin();
            const pixels_ = input(pixels, 12, 'pixels', 'f32');
            const count = common(pixels_);
            const out_points_ = output(out, 'vec3', count);
            check(native.gphys_camera_unproject_batch(this.pointer, pass(pixels_), 12, count, pass(out_points_), 12));
            return finish(out_points_);
        }
        pickRay(pixel_x, pixel_y) {
            if (check(native.gphys_camera_pick_ray(this.pointer, real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), base)) !== OK) return null;
            return readRay(v, 0);
        }
        pickRays(x, y, width, height, out) {
            begin();
            const out_rays_ = output(out, 'ray', width * height);
            check(native.gphys_camera_pick_rays(this.pointer, whole(x, 'x'), whole(y, 'y'), whole(width, 'width'), whole(height, 'height'), pass(out_rays_), 28));
            return finish(out_rays_);
        }
        pick(scene, pixel_x, pixel_y, layers = ALL_LAYERS) {
            if (check(native.gphys_camera_pick(this.pointer, pointer(scene, Scene, 'scene', false), real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), bits(layers, 'layers'), base)) !== OK) return null;
            return readHit(v, 0);
        }
        pickBatch(scene, pixels, layers = ALL_LAYERS, out) {
            begin();
            const pixels_ = input(pixels, 8, 'pixels', 'f32');
            const count = common(pixels_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_camera_pick_batch(this.pointer, pointer(scene, Scene, 'scene', false), pass(pixels_), 8, count, bits(layers, 'layers'), pass(out_hits_), 52));
            return finish(out_hits_);
        }
        pickRectangle(scene, x0, y0, x1, y1, layers = ALL_LAYERS) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_camera_pick_rectangle(this.pointer, pointer(scene, Scene, 'scene', false), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), bits(layers, 'layers'), room, capacity, base));
        }
        cull(scene, layers = ALL_LAYERS) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_camera_cull(this.pointer, pointer(scene, Scene, 'scene', false), bits(layers, 'layers'), room, capacity, base));
        }
        pickFiltered(scene, pixel_x, pixel_y, filter) {
            begin();
            if (filter != null) { check(native.gphys_query_filter_desc_init(base, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 0, filter); }
            if (check(native.gphys_camera_pick_filtered(this.pointer, pointer(scene, Scene, 'scene', false), real(pixel_x, 'pixel_x'), real(pixel_y, 'pixel_y'), filter == null ? 0 : base, base + 32)) !== OK) return null;
            return readHit(v, 8);
        }
        pickFilteredBatch(scene, pixels, filters, out) {
            begin();
            const pixels_ = input(pixels, 8, 'pixels', 'f32');
            const filters_ = filters == null ? nothing : inputDescs(filters, 0, v.wide ? 32 : 28, native.gphys_query_filter_desc_init, writeQueryFilterDesc, 'filters');
            const count = common(pixels_, filters_);
            const out_hits_ = output(out, 'hit', count);
            check(native.gphys_camera_pick_filtered_batch(this.pointer, pointer(scene, Scene, 'scene', false), pass(pixels_), 8, count, pass(filters_), filters_.stride, pass(out_hits_), 52));
            return finish(out_hits_);
        }
        pickRectangleFiltered(scene, x0, y0, x1, y1, filter) {
            begin();
            if (filter != null) { check(native.gphys_query_filter_desc_init(base, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 0, filter); }
            return list('uint32_t', 8, (room, capacity) => native.gphys_camera_pick_rectangle_filtered(this.pointer, pointer(scene, Scene, 'scene', false), real(x0, 'x0'), real(y0, 'y0'), real(x1, 'x1'), real(y1, 'y1'), filter == null ? 0 : base, room, capacity, base + 32));
        }
        cullFiltered(scene, filter) {
            begin();
            if (filter != null) { check(native.gphys_query_filter_desc_init(base, v.wide ? 32 : 28)); writeQueryFilterDesc(v, 0, filter); }
            return list('uint32_t', 8, (room, capacity) => native.gphys_camera_cull_filtered(this.pointer, pointer(scene, Scene, 'scene', false), filter == null ? 0 : base, room, capacity, base + 32));
        }
    }
    class Solver extends Handle {
        constructor(desc) {
            super(() => {
                if (desc != null) { check(native.gphys_solver_desc_init(base, v.wide ? 80 : 68)); writeSolverDesc(v, 0, desc); }
                check(native.gphys_solver_create(desc == null ? 0 : base, base + 80));
                return made(80);
            }, native.gphys_solver_destroy);
        }
        setWorkerCount(workers) {
            check(native.gphys_solver_set_worker_count(this.pointer, whole(workers, 'workers')));
        }
        getWorkerCount() {
            check(native.gphys_solver_get_worker_count(this.pointer, base));
            return v.u32[0];
        }
        setOrigin(origin) {
            numbers(v.f64, 0, origin, 3, 'origin');
            check(native.gphys_solver_set_origin(this.pointer, base));
        }
        getOrigin() {
            check(native.gphys_solver_get_origin(this.pointer, base));
            return [v.f64[0], v.f64[1], v.f64[2]];
        }
        setGravity(gravity) {
            writeVec3(v, 0, gravity);
            check(native.gphys_solver_set_gravity(this.pointer, base));
        }
        setSubsteps(substeps) {
            check(native.gphys_solver_set_substeps(this.pointer, whole(substeps, 'substeps')));
        }
        getSettings() {
            check(native.gphys_solver_get_settings(this.pointer, base));
            return readSolverSettings(v, 0);
        }
        setSettings(settings) {
            writeSolverSettings(v, 0, settings);
            check(native.gphys_solver_set_settings(this.pointer, base));
        }
        addParticles(positions, desc) {
            begin();
            if (desc != null) { check(native.gphys_body_desc_init(base, 64)); writeBodyDesc(v, 0, desc); }
            const positions_ = input(positions, 12, 'positions', 'f32');
            const count = common(positions_);
            check(native.gphys_solver_add_particles(this.pointer, desc == null ? 0 : base, pass(positions_), 12, count, base + 64));
            return v.u32[16];
        }
        addRope(positions, link_length = 0, desc) {
            begin();
            if (desc != null) { check(native.gphys_body_desc_init(base, 64)); writeBodyDesc(v, 0, desc); }
            const positions_ = input(positions, 12, 'positions', 'f32');
            const count = common(positions_);
            check(native.gphys_solver_add_rope(this.pointer, desc == null ? 0 : base, pass(positions_), 12, count, real(link_length, 'link_length'), base + 64));
            return v.u32[16];
        }
        addCloth(corner, edge_u, edge_v, columns, rows, desc) {
            if (desc != null) { check(native.gphys_body_desc_init(base, 64)); writeBodyDesc(v, 0, desc); }
            writeVec3(v, 16, corner);
            writeVec3(v, 20, edge_u);
            writeVec3(v, 24, edge_v);
            check(native.gphys_solver_add_cloth(this.pointer, desc == null ? 0 : base, base + 64, base + 80, base + 96, whole(columns, 'columns'), whole(rows, 'rows'), base + 108));
            return v.u32[27];
        }
        addClothMesh(mesh, transform, desc) {
            if (desc != null) { check(native.gphys_body_desc_init(base, 64)); writeBodyDesc(v, 0, desc); }
            if (transform != null) { writeTransform(v, 16, transform); }
            check(native.gphys_solver_add_cloth_mesh(this.pointer, desc == null ? 0 : base, pointer(mesh, Mesh, 'mesh', false), transform == null ? 0 : base + 64, base + 96));
            return v.u32[24];
        }
        removeBody(body) {
            check(native.gphys_solver_remove_body(this.pointer, whole(body, 'body')));
        }
        getBodies() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_bodies(this.pointer, room, capacity, base));
        }
        getSleeping() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_sleeping(this.pointer, room, capacity, base));
        }
        wake(body) {
            check(native.gphys_solver_wake(this.pointer, whole(body, 'body')));
        }
        getBodySettings(body) {
            check(native.gphys_solver_get_body_settings(this.pointer, whole(body, 'body'), base));
            return readBodySettings(v, 0);
        }
        setBodySettings(body, settings) {
            writeBodySettings(v, 0, settings);
            check(native.gphys_solver_set_body_settings(this.pointer, whole(body, 'body'), base));
        }
        getBodyInfo(body) {
            check(native.gphys_solver_get_body_info(this.pointer, whole(body, 'body'), base));
            return readBodyInfo(v, 0);
        }
        getTriangles(body) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_triangles(this.pointer, whole(body, 'body'), room, capacity, base));
        }
        getNearestParticle(body, triangle, point) {
            writeVec3(v, 0, point);
            check(native.gphys_solver_get_nearest_particle(this.pointer, whole(body, 'body'), whole(triangle, 'triangle'), base, base + 12));
            return v.u32[3];
        }
        getPositions(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_positions_ = output(out, 'vec3', count);
            check(native.gphys_solver_get_positions(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_positions_), 12));
            return finish(out_positions_);
        }
        setPositions(body, first, positions) {
            begin();
            const positions_ = input(positions, 12, 'positions', 'f32');
            const count = common(positions_);
            check(native.gphys_solver_set_positions(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(positions_), 12));
        }
        getVelocities(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_velocities_ = output(out, 'vec3', count);
            check(native.gphys_solver_get_velocities(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_velocities_), 12));
            return finish(out_velocities_);
        }
        setVelocities(body, first, velocities) {
            begin();
            const velocities_ = input(velocities, 12, 'velocities', 'f32');
            const count = common(velocities_);
            check(native.gphys_solver_set_velocities(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(velocities_), 12));
        }
        getMasses(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_masses_ = output(out, 'float', count);
            check(native.gphys_solver_get_masses(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_masses_), 4));
            return finish(out_masses_);
        }
        setMasses(body, first, masses) {
            begin();
            const masses_ = input(masses, 4, 'masses', 'f32');
            const count = common(masses_);
            check(native.gphys_solver_set_masses(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(masses_), 4));
        }
        getRadii(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_radii_ = output(out, 'float', count);
            check(native.gphys_solver_get_radii(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_radii_), 4));
            return finish(out_radii_);
        }
        setRadii(body, first, radii) {
            begin();
            const radii_ = input(radii, 4, 'radii', 'f32');
            const count = common(radii_);
            check(native.gphys_solver_set_radii(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(radii_), 4));
        }
        getFrictionFactors(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_factors_ = output(out, 'float', count);
            check(native.gphys_solver_get_friction_factors(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_factors_), 4));
            return finish(out_factors_);
        }
        setFrictionFactors(body, first, factors) {
            begin();
            const factors_ = input(factors, 4, 'factors', 'f32');
            const count = common(factors_);
            check(native.gphys_solver_set_friction_factors(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(factors_), 4));
        }
        getForces(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_forces_ = output(out, 'vec3', count);
            check(native.gphys_solver_get_forces(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_forces_), 12));
            return finish(out_forces_);
        }
        setForces(body, first, forces) {
            begin();
            const forces_ = input(forces, 12, 'forces', 'f32');
            const count = common(forces_);
            check(native.gphys_solver_set_forces(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(forces_), 12));
        }
        getPinned(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_pinned_ = output(out, 'int32_t', count);
            check(native.gphys_solver_get_pinned(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_pinned_), 4));
            return finish(out_pinned_);
        }
        setPinned(body, first = 0, count = rest(this, body, first), pinned = true) {
            check(native.gphys_solver_set_pinned(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), flag(pinned, 'pinned')));
        }
        setWind(body, wind) {
            writeWind(v, 0, wind);
            check(native.gphys_solver_set_wind(this.pointer, whole(body, 'body'), base));
        }
        getWind(body) {
            check(native.gphys_solver_get_wind(this.pointer, whole(body, 'body'), base));
            return readWind(v, 0);
        }
        setAirVelocities(body, first, velocities) {
            begin();
            const velocities_ = input(velocities, 12, 'velocities', 'f32');
            const count = common(velocities_);
            check(native.gphys_solver_set_air_velocities(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(velocities_), 12));
        }
        getAirVelocities(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_velocities_ = output(out, 'vec3', count);
            check(native.gphys_solver_get_air_velocities(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_velocities_), 12));
            return finish(out_velocities_);
        }
        setAnimationTargets(body, first, targets) {
            begin();
            const targets_ = input(targets, 32, 'targets', 'f32');
            const count = common(targets_);
            check(native.gphys_solver_set_animation_targets(this.pointer, whole(body, 'body'), whole(first, 'first'), count, pass(targets_), 32));
        }
        getAnimationTargets(body, first = 0, count = rest(this, body, first), out) {
            begin();
            const out_targets_ = output(out, 'animation_target', count);
            check(native.gphys_solver_get_animation_targets(this.pointer, whole(body, 'body'), whole(first, 'first'), whole(count, 'count'), pass(out_targets_), 32));
            return finish(out_targets_);
        }
        attach(scene, body, particle, model, local_point) {
            if (local_point != null) { writeVec3(v, 0, local_point); }
            check(native.gphys_solver_attach(this.pointer, pointer(scene, Scene, 'scene', false), whole(body, 'body'), whole(particle, 'particle'), whole(model, 'model'), local_point == null ? 0 : base));
        }
        detach(body, particle) {
            check(native.gphys_solver_detach(this.pointer, whole(body, 'body'), whole(particle, 'particle')));
        }
        getAttachments(body) {
            begin();
            return list('attachment', 0, (room, capacity) => native.gphys_solver_get_attachments(this.pointer, whole(body, 'body'), room, capacity, base));
        }
        addDistance(body, particle_a, particle_b, rest_length, compliance = 0) {
            check(native.gphys_solver_add_distance(this.pointer, whole(body, 'body'), whole(particle_a, 'particle_a'), whole(particle_b, 'particle_b'), real(rest_length, 'rest_length'), real(compliance, 'compliance'), base));
            return v.u32[0];
        }
        addMaxDistance(body, particle_a, particle_b, max_length, compliance = 0) {
            check(native.gphys_solver_add_max_distance(this.pointer, whole(body, 'body'), whole(particle_a, 'particle_a'), whole(particle_b, 'particle_b'), real(max_length, 'max_length'), real(compliance, 'compliance'), base));
            return v.u32[0];
        }
        setConstraintDamping(body, constraint, damping) {
            check(native.gphys_solver_set_constraint_damping(this.pointer, whole(body, 'body'), whole(constraint, 'constraint'), real(damping, 'damping')));
        }
        setVolume(body, rest_volume, compliance = 0) {
            check(native.gphys_solver_set_volume(this.pointer, whole(body, 'body'), real(rest_volume, 'rest_volume'), real(compliance, 'compliance')));
        }
        getVolume(body) {
            check(native.gphys_solver_get_volume(this.pointer, whole(body, 'body'), base, base + 4));
            return [v.f32[0], v.f32[1]];
        }
        getVolumeSettings(body) {
            check(native.gphys_solver_get_volume_settings(this.pointer, whole(body, 'body'), base, base + 4));
            return [v.f32[0], v.f32[1]];
        }
        removeConstraint(body, constraint) {
            check(native.gphys_solver_remove_constraint(this.pointer, whole(body, 'body'), whole(constraint, 'constraint')));
        }
        getConstraints(body) {
            begin();
            return list('constraint_info', 0, (room, capacity) => native.gphys_solver_get_constraints(this.pointer, whole(body, 'body'), room, capacity, base));
        }
        getConstraintKinds(body, constraints, out) {
            begin();
            const constraints_ = input(constraints, 4, 'constraints', 'u32');
            const count = common(constraints_);
            const out_kinds_ = output(out, 'int32_t', count);
            check(native.gphys_solver_get_constraint_kinds(this.pointer, whole(body, 'body'), pass(constraints_), count, pass(out_kinds_), 4));
            return finish(out_kinds_);
        }
        getConstraintSettings(body, constraints, out) {
            begin();
            const constraints_ = input(constraints, 4, 'constraints', 'u32');
            const count = common(constraints_);
            const out_settings_ = output(out, 'constraint_settings', count);
            check(native.gphys_solver_get_constraint_settings(this.pointer, whole(body, 'body'), pass(constraints_), count, pass(out_settings_), 12));
            return finish(out_settings_);
        }
        setConstraintSettings(body, constraints, settings) {
            begin();
            const constraints_ = input(constraints, 4, 'constraints', 'u32');
            const settings_ = input(settings, 12, 'settings', 'f32');
            const count = common(constraints_, settings_);
            check(native.gphys_solver_set_constraint_settings(this.pointer, whole(body, 'body'), pass(constraints_), pass(settings_), 12, count));
        }
        addCluster(body, particles) {
            begin();
            const particles_ = input(particles, 4, 'particles', 'u32');
            const count = common(particles_);
            check(native.gphys_solver_add_cluster(this.pointer, whole(body, 'body'), pass(particles_), count, base));
            return v.u32[0];
        }
        removeCluster(body, cluster) {
            check(native.gphys_solver_remove_cluster(this.pointer, whole(body, 'body'), whole(cluster, 'cluster')));
        }
        getClusters(body) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_clusters(this.pointer, whole(body, 'body'), room, capacity, base));
        }
        getClusterParticles(body, cluster) {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_cluster_particles(this.pointer, whole(body, 'body'), whole(cluster, 'cluster'), room, capacity, base));
        }
        join(body_a, particle_a, body_b, particle_b, rest_length, compliance = 0) {
            check(native.gphys_solver_join(this.pointer, whole(body_a, 'body_a'), whole(particle_a, 'particle_a'), whole(body_b, 'body_b'), whole(particle_b, 'particle_b'), real(rest_length, 'rest_length'), real(compliance, 'compliance'), base));
            return v.u32[0];
        }
        unjoin(joint) {
            check(native.gphys_solver_unjoin(this.pointer, whole(joint, 'joint')));
        }
        getJoints(body) {
            begin();
            return list('joint_info', 0, (room, capacity) => native.gphys_solver_get_joints(this.pointer, whole(body, 'body'), room, capacity, base));
        }
        setBreakingForces(body, constraints, forces) {
            begin();
            const constraints_ = input(constraints, 4, 'constraints', 'u32');
            const forces_ = input(forces, 4, 'forces', 'f32');
            const count = common(constraints_, forces_);
            check(native.gphys_solver_set_breaking_forces(this.pointer, whole(body, 'body'), pass(constraints_), pass(forces_), 4, count));
        }
        getBreakingForces(body, constraints, out) {
            begin();
            const constraints_ = input(constraints, 4, 'constraints', 'u32');
            const count = common(constraints_);
            const out_forces_ = output(out, 'float', count);
            check(native.gphys_solver_get_breaking_forces(this.pointer, whole(body, 'body'), pass(constraints_), count, pass(out_forces_), 4));
            return finish(out_forces_);
        }
        breakConstraint(body, constraint) {
            check(native.gphys_solver_break_constraint(this.pointer, whole(body, 'body'), whole(constraint, 'constraint'), base));
            return readBreak(v, 0);
        }
        getBreaks() {
            begin();
            return list('break', 0, (room, capacity) => native.gphys_solver_get_breaks(this.pointer, room, capacity, base));
        }
        step(scene, dt) {
            check(native.gphys_solver_step(this.pointer, pointer(scene, Scene, 'scene', true), real(dt, 'dt')));
        }
        advance(scene, frame_time) {
            check(native.gphys_solver_advance(this.pointer, pointer(scene, Scene, 'scene', true), real(frame_time, 'frame_time'), base, base + 4));
            return [v.u32[0], v.f32[1]];
        }
        getLeftover() {
            check(native.gphys_solver_get_leftover(this.pointer, base));
            return v.f32[0];
        }
        getSubsteps(body) {
            check(native.gphys_solver_get_substeps(this.pointer, whole(body, 'body'), base));
            return v.u32[0];
        }
        getStats(body) {
            check(native.gphys_solver_get_stats(this.pointer, whole(body, 'body'), base));
            return readSolverStats(v, 0);
        }
        getContacts() {
            begin();
            return list('contact', 0, (room, capacity) => native.gphys_solver_get_contacts(this.pointer, room, capacity, base));
        }
        getBodyContacts() {
            begin();
            return list('body_contact', 0, (room, capacity) => native.gphys_solver_get_body_contacts(this.pointer, room, capacity, base));
        }
        getImpulses() {
            begin();
            return list('impulse', 0, (room, capacity) => native.gphys_solver_get_impulses(this.pointer, room, capacity, base));
        }
        getSnapshot() {
            begin();
            return list('uint32_t', 0, (room, capacity) => native.gphys_solver_get_snapshot(this.pointer, room, capacity, base));
        }
        restore(words) {
            begin();
            const words_ = input(words, 4, 'words', 'u32');
            const count = common(words_);
            check(native.gphys_solver_restore(this.pointer, pass(words_), count));
        }
        getHash() {
            check(native.gphys_solver_get_hash(this.pointer, base));
            return [v.u32[0], v.u32[1]];
        }
    }
    function validate(shape) {
        check(native.gphys_shape_validate(typeOf(shape), putShape(shape, 0)));
    }
    function bounds(shape) {
        if (check(native.gphys_shape_bounds(typeOf(shape), putShape(shape, 0), base + 108)) !== OK) return null;
        return readAabb(v, 27);
    }
    function contains(shape, point, tolerance = 0) {
        writeVec3(v, 28, point);
        check(native.gphys_shape_contains(typeOf(shape), putShape(shape, 0), base + 112, real(tolerance, 'tolerance'), base + 124));
        return v.i32[31] !== 0;
    }
    function containsBatch(shape, points, tolerance = 0, out) {
        begin();
        const points_ = input(points, 12, 'points', 'f32');
        const count = common(points_);
        const out_contains_ = output(out, 'int32_t', count);
        check(native.gphys_shape_contains_batch(typeOf(shape), putShape(shape, 0), pass(points_), 12, count, real(tolerance, 'tolerance'), pass(out_contains_), 4));
        return finish(out_contains_);
    }
    function closestPoint(shape, point) {
        writeVec3(v, 28, point);
        if (check(native.gphys_shape_closest_point(typeOf(shape), putShape(shape, 0), base + 112, base + 124)) !== OK) return null;
        return readNearest(v, 31);
    }
    function closestPointBatch(shape, points, out) {
        begin();
        const points_ = input(points, 12, 'points', 'f32');
        const count = common(points_);
        const out_nearest_ = output(out, 'nearest', count);
        check(native.gphys_shape_closest_point_batch(typeOf(shape), putShape(shape, 0), pass(points_), 12, count, pass(out_nearest_), 28));
        return finish(out_nearest_);
    }
    function segmentClosestPoints(a, b) {
        writeSegment(v, 0, a);
        writeSegment(v, 6, b);
        check(native.gphys_segment_closest_points(base, base + 24, base + 48, base + 60, base + 72));
        return [readVec3(v, 12), readVec3(v, 15), v.f32[18]];
    }
    function overlaps(a, b) {
        check(native.gphys_shape_overlaps(typeOf(a), putShape(a, 0), typeOf(b), putShape(b, 27), base + 216));
        return v.i32[54] !== 0;
    }
    function overlapsBatch(a, b, out) {
        begin();
        const a_ = inputShapes(a);
        const b_ = inputShapes(b);
        const count = common(a_, b_);
        const out_overlaps_ = output(out, 'int32_t', count);
        check(native.gphys_shape_overlaps_batch(a_.type, pass(a_), a_.stride, b_.type, pass(b_), b_.stride, count, pass(out_overlaps_), 4));
        return finish(out_overlaps_);
    }
    function classifyPlane(shape, plane) {
        writePlane(v, 28, plane);
        check(native.gphys_shape_classify_plane(typeOf(shape), putShape(shape, 0), base + 112, base + 128, base + 132));
        return [v.i32[32], v.f32[33]];
    }
    function classifyFrustum(shape, frustum) {
        writeFrustum(v, 28, frustum);
        check(native.gphys_shape_classify_frustum(typeOf(shape), putShape(shape, 0), base + 112, base + 220));
        return v.i32[55];
    }
    function raycast(shape, ray) {
        writeRay(v, 28, ray);
        if (check(native.gphys_shape_raycast(typeOf(shape), putShape(shape, 0), base + 112, base + 140)) !== OK) return null;
        return readHit(v, 35);
    }
    function raycastBatch(shape, rays, out) {
        begin();
        const rays_ = input(rays, 28, 'rays', 'f32');
        const count = common(rays_);
        const out_hits_ = output(out, 'hit', count);
        check(native.gphys_shape_raycast_batch(typeOf(shape), putShape(shape, 0), pass(rays_), 28, count, pass(out_hits_), 52));
        return finish(out_hits_);
    }
    function segmentTest(shape, segment) {
        writeSegment(v, 28, segment);
        if (check(native.gphys_shape_segment_test(typeOf(shape), putShape(shape, 0), base + 112, base + 136)) !== OK) return null;
        return readHit(v, 34);
    }
    function sweepSphere(shape, sphere, displacement) {
        writeSphere(v, 28, sphere);
        writeVec3(v, 32, displacement);
        if (check(native.gphys_shape_sweep_sphere(typeOf(shape), putShape(shape, 0), base + 112, base + 128, base + 140)) !== OK) return null;
        return readHit(v, 35);
    }
    function sweep(shape, moving, displacement) {
        writeVec3(v, 54, displacement);
        if (check(native.gphys_shape_sweep(typeOf(shape), putShape(shape, 0), typeOf(moving), putShape(moving, 27), base + 216, base + 228)) !== OK) return null;
        return readHit(v, 57);
    }
    function sweepBatch(shapes, moving, displacements, out) {
        begin();
        const shapes_ = inputShapes(shapes);
        const moving_ = inputShapes(moving);
        const displacements_ = input(displacements, 12, 'displacements', 'f32');
        const count = common(shapes_, moving_, displacements_);
        const out_hits_ = output(out, 'hit', count);
        check(native.gphys_shape_sweep_batch(shapes_.type, pass(shapes_), shapes_.stride, moving_.type, pass(moving_), moving_.stride, pass(displacements_), 12, count, pass(out_hits_), 52));
        return finish(out_hits_);
    }
    function penetration(shape, moving) {
        if (check(native.gphys_shape_penetration(typeOf(shape), putShape(shape, 0), typeOf(moving), putShape(moving, 27), base + 216)) !== OK) return null;
        return readPenetration(v, 54);
    }
    function penetrationBatch(shapes, moving, out) {
        begin();
        const shapes_ = inputShapes(shapes);
        const moving_ = inputShapes(moving);
        const count = common(shapes_, moving_);
        const out_penetrations_ = output(out, 'penetration', count);
        check(native.gphys_shape_penetration_batch(shapes_.type, pass(shapes_), shapes_.stride, moving_.type, pass(moving_), moving_.stride, count, pass(out_penetrations_), 40));
        return finish(out_penetrations_);
    }
    function frustumCorners(frustum) {
        writeFrustum(v, 0, frustum);
        if (check(native.gphys_frustum_corners(base, base + 108)) !== OK) return null;
        return [readVec3(v, 27), readVec3(v, 30), readVec3(v, 33), readVec3(v, 36), readVec3(v, 39), readVec3(v, 42), readVec3(v, 45), readVec3(v, 48)];
    }
    function planesIntersection(a, b, c) {
        writePlane(v, 0, a);
        writePlane(v, 4, b);
        writePlane(v, 8, c);
        if (check(native.gphys_planes_intersection(base, base + 16, base + 32, base + 48)) !== OK) return null;
        return readVec3(v, 12);
    }
    function planesIntersectionBatch(a, b, c, out) {
        begin();
        const a_ = input(a, 16, 'a', 'f32');
        const b_ = input(b, 16, 'b', 'f32');
        const c_ = input(c, 16, 'c', 'f32');
        const count = common(a_, b_, c_);
        const out_points_ = output(out, 'vec3', count);
        check(native.gphys_planes_intersection_batch(pass(a_), 16, pass(b_), 16, pass(c_), 16, count, pass(out_points_), 12));
        return finish(out_points_);
    }
    function mat4Orthonormality(matrix) {
        writeMat4(v, 0, matrix);
        check(native.gphys_mat4_orthonormality(base, base + 64));
        return v.f32[16];
    }
    function frustumFromMatrix(view_projection, depth_range, reverse_z) {
        writeMat4(v, 0, view_projection);
        check(native.gphys_frustum_from_matrix(base, signed(depth_range, 'depth_range'), flag(reverse_z, 'reverse_z'), base + 64));
        return readFrustum(v, 16);
    }
    function meshCheck(vertices, indices) {
        begin();
        const vertices_ = input(vertices, 12, 'vertices', 'f32');
        const indices_ = input(indices ?? ascending(vertices_.length), 4, 'indices', 'u32');
        check(native.gphys_mesh_check(pass(vertices_), 12, vertices_.length, pass(indices_), indices_.numbers, base));
        return readMeshReport(v, 0);
    }
    return {
        Mesh, Scene, Camera, Solver, validate, bounds, contains, containsBatch, closestPoint, closestPointBatch, segmentClosestPoints, overlaps, overlapsBatch, classifyPlane, classifyFrustum, raycast, raycastBatch, segmentTest, sweepSphere, sweep, sweepBatch, penetration, penetrationBatch, frustumCorners, planesIntersection, planesIntersectionBatch, mat4Orthonormality, frustumFromMatrix, meshCheck,
        sphere: (...fields) => new Shape('sphere', fields),
        capsule: (...fields) => new Shape('capsule', fields),
        aabb: (...fields) => new Shape('aabb', fields),
        obb: (...fields) => new Shape('obb', fields),
        plane: (...fields) => new Shape('plane', fields),
        triangle: (...fields) => new Shape('triangle', fields),
        frustum: (...fields) => new Shape('frustum', fields),
        ray: (...fields) => new Shape('ray', fields),
        segment: (...fields) => new Shape('segment', fields),
        ...more(Scene, Mesh),
    };
}
