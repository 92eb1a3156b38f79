// Each function that test.js and the examples do not call, once, against an answer known by heart.
import assert from 'node:assert';
import test from 'node:test';
import * as gp from 'gamephys';

const IDENTITY = [0, 0, 0, 1];
const at = (x, y, z, scale = 1) => ({ position: [x, y, z], rotation: IDENTITY, scale });
const floats = (...numbers) => Float32Array.from(numbers);
/** Equal, a minus before a zero apart. */
const same = (actual, expected) => assert.deepEqual(actual, expected);
const near = (actual, expected, error = 1e-5) => {
    assert.strictEqual(actual.length, expected.length);
    actual.forEach((x, i) => assert(Math.abs(x - expected[i]) <= error, `${actual} is not ${expected}`));
};

const ball = gp.sphere([0, 0, 0], 1);
/** A tetrahedron with three edges along the axes. */
const tetrahedron = { vertices: floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1), indices: Uint32Array.of(0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3) };
const someMesh = (desc) => new gp.Mesh(tetrahedron.vertices, tetrahedron.indices, desc);

test('shapes: validity, points', () => {
    gp.validate(ball);
    assert.throws(() => gp.validate(gp.sphere([0, 0, 0], NaN)), gp.GamephysError);
    same(gp.bounds(gp.capsule([0, 0, 0], [2, 0, 0], 1)), { min: [-1, -1, -1], max: [3, 1, 1] });
    assert.strictEqual(gp.bounds(gp.plane([0, 1, 0], 0)), null);
    assert.strictEqual(gp.contains(ball, [1.5, 0, 0], 0), false);
    assert.strictEqual(gp.contains(ball, [1.5, 0, 0], 0.5), true);
    same([...gp.containsBatch(ball, floats(0, 0, 0, 0, 2, 0), 0)], [1, 0]);
    const { point, distance } = gp.closestPoint(gp.aabb([0, 0, 0], [1, 1, 1]), { x: 3, y: 0.5, z: 0.5 });
    same([point, distance], [[1, 0.5, 0.5], 2]);
    same([...gp.closestPointBatch(ball, floats(0, 0, 3, 0, 5, 0))].map((n) => n.distance), [2, 4]);
    same(gp.segmentClosestPoints([[-1, 0, 0], [1, 0, 0]], { a: [0, 2, -1], b: [0, 2, 1] }), [[0, 0, 0], [0, 2, 0], 2]);
});

test('shapes: sides and lines', () => {
    same(gp.classifyPlane(gp.sphere([0, 3, 0], 1), { normal: [0, 1, 0], distance: 0 }), [gp.SIDE_INSIDE, 2]);
    const camera = new gp.Camera();
    assert.strictEqual(gp.classifyFrustum(gp.sphere([0, 0, 50], 1), camera.getFrustum()), gp.SIDE_INSIDE);
    assert.strictEqual(gp.classifyFrustum(gp.sphere([0, 0, -50], 1), camera.getFrustum()), gp.SIDE_OUTSIDE);
    same([...gp.raycastBatch(ball, floats(0, 0, -5, 0, 0, 1, 9, 0, 3, -5, 0, 0, 1, 9))].map((hit) => hit.t), [4, Infinity]);
    assert.strictEqual(gp.segmentTest(ball, [[0, 0, -2], [0, 0, 2]]).t, 0.25);
    assert.strictEqual(gp.segmentTest(ball, [[0, 0, -2], [0, 0, -1.5]]), null);
    assert.strictEqual(gp.sweepSphere(ball, { center: [0, 0, -5], radius: 1 }, [0, 0, 6]).t, 0.5);
});

test('frusta', () => {
    const camera = new gp.Camera({ viewport_width: 100, viewport_height: 100 });
    camera.setOrthographic(2, 1, 3);
    const corners = [[-1, -1, 1], [1, -1, 1], [1, 1, 1], [-1, 1, 1], [-1, -1, 3], [1, -1, 3], [1, 1, 3], [-1, 1, 3]];
    gp.frustumCorners(camera.getFrustum()).forEach((corner, i) => near(corner, corners[i]));
    camera.getCorners().forEach((corner, i) => near(corner, corners[i]));
    const { origin, planes } = gp.frustumFromMatrix(camera.getViewProjectionMatrix(), gp.DEPTH_ZERO_TO_ONE, false);
    same(origin, [0, 0, 0]);
    assert.strictEqual(planes.length, 6);
    near(planes[gp.FRUSTUM_NEAR].normal, [0, 0, planes[gp.FRUSTUM_NEAR].normal[2]]);
    camera.setPerspective(1, 1, Infinity);
    assert.strictEqual(camera.getCorners(), null);
});

test('models with descs of their own', () => {
    const scene = new gp.Scene();
    const root = scene.add(ball);
    const readBack = (models) => [...models].map((model) => scene.getInfo(model)).map(({ parent, layers, tag }) => [parent, layers, tag]);
    const three = gp.shapes('sphere', floats(0, 0, 0, 1, 3, 0, 0, 1, 6, 0, 0, 1));
    const some = [{ parent: root, layers: 2, tag: 5 }, { tag: 6 }, {}];
    const known = [[root, 2, 5], [0, 1, 6], [0, 1, 0]];
    same(readBack(scene.addDescribedBatch(three, null, some)), known);
    same(readBack(scene.addDescribedBatch(ball, null, some)), known);
    same(readBack(scene.addDescribedBatch(three, null, some[0])), [known[0], known[0], known[0]]);
    same(readBack(scene.addDescribedBatch(three)), [known[2], known[2], known[2]]);
    same(readBack(scene.addDescribedBatch(ball, null, [])), []);
    const count = scene.getModels().length;
    assert.throws(() => scene.addDescribedBatch(three, null, [{}, {}]), RangeError);
    assert.throws(() => scene.addDescribedBatch(three, null, [{}, {}, { weight: 1 }]), TypeError);
    assert.throws(() => scene.addDescribedBatch(three, null, [{}, {}, null]), TypeError);
    assert.throws(() => scene.addDescribedBatch(three, null, { parent: 12345 }), gp.GamephysError);
    assert.strictEqual(scene.getModels().length, count);
});

test('meshes', () => {
    const bad = gp.meshCheck(tetrahedron.vertices, Uint32Array.of(0, 1, 9, 0, 0, 0));
    same([bad.out_of_range_count, bad.first_out_of_range, bad.degenerate_count], [1, 0, 1]);
    assert.throws(() => new gp.Mesh(tetrahedron.vertices, Uint32Array.of(0, 1, 9)), gp.GamephysError);
    const mesh = someMesh({});
    assert.strictEqual(mesh.getReport().open_edge_count, 0);
    same(mesh.getVertices().f32, tetrahedron.vertices);
    same(mesh.getIndices().u32, tetrahedron.indices);
    const loaded = gp.Mesh.fromSnapshot(mesh.getSnapshot());
    assert(loaded instanceof gp.Mesh);
    same(loaded.getIndices().u32, tetrahedron.indices);
    loaded.close();
    assert.throws(() => gp.Mesh.fromSnapshot(mesh.getSnapshot().u32.subarray(1)), gp.GamephysError);
    const ray = [[0.25, 0.25, -1], [0, 0, 1], Infinity];
    near([...mesh.raycastAll(ray)].map((hit) => hit.t), [1, 1.5]);
    assert.strictEqual(mesh.raycastAny(ray), true);
    assert.strictEqual(mesh.raycastAny([[2, 2, -1], [0, 0, 1], Infinity]), false);
    const missed = floats(2, 2, -1, 0, 0, 1, Infinity);
    same([...mesh.raycastAnyBatch(missed)], [0]);
    assert.strictEqual(mesh.raycastDistanceBatch(missed).get(0).t, Infinity);
    same([...mesh.overlap(gp.sphere([0.3, 0.3, 0], 0.05))], [0]);
    assert.strictEqual(mesh.getOctreeStats().item_count, 4);
    assert.strictEqual([...mesh.getOctreeBoxes()].reduce((sum, box) => sum + box.item_count, 0), 4);
});

test('models', () => {
    const scene = new gp.Scene({ reserve_models: 10 });
    const parent = scene.add(ball, at(10, 0, 0), { tag: 7, layers: 2 });
    const child = scene.add(ball, at(0, 5, 0), { parent });
    assert.strictEqual(scene.has(child), true);
    const world = () => [...scene.getWorldTransforms(Uint32Array.of(child))].map((t) => t.position);
    same(world(), [[10, 5, 0]]);
    same(scene.getBounds(parent), { min: [9, -1, -1], max: [11, 1, 1] });
    same(scene.getSceneBounds(), { min: [9, -1, -1], max: [11, 6, 1] });
    scene.setTransform(parent, at(20, 0, 0));
    same(world(), [[20, 5, 0]]);
    scene.setTransforms(Uint32Array.of(parent, child), floats(1, 0, 0, ...IDENTITY, 1, 0, 2, 0, ...IDENTITY, 1));
    same(scene.getTransforms(Uint32Array.of(child)).get(0).position, [0, 2, 0]);
    scene.setParent(child, 0, true);
    same(scene.getTransforms(Uint32Array.of(child)).get(0).position, [1, 2, 0]);
    scene.setTag(child, 9);
    scene.setLayers(child, 4);
    same([scene.getInfo(child).tag, scene.getInfo(child).layers], [9, 4]);
    scene.setParent(child, parent, true);
    scene.validate();
    scene.removeSubtree(parent);
    assert.strictEqual(scene.has(child), false);
    scene.add(ball);
    scene.rebuildOctree();
    assert.equal(scene.maintainOctree(1000), true);
    scene.setWorkerCount(2);
    assert.ok([1, 2].includes(scene.getWorkerCount())); // 1 where there are no threads
    scene.clear();
    assert.strictEqual(scene.getSceneBounds(), null);
});

test('questions to a scene', () => {
    const scene = new gp.Scene();
    const first = scene.add(ball), second = scene.add(ball, at(0, 0, 10), { layers: 2 });
    const ray = [[0, 0, -5], [0, 0, 1], 100], rays = floats(0, 0, -5, 0, 0, 1, 100, 9, 9, 9, 0, 1, 0, 100);
    assert.strictEqual(scene.raycastAny(ray), true);
    assert.strictEqual(scene.raycastAny(ray, 4), false);
    same([...scene.raycastAnyBatch(rays)], [1, 0]);
    same([...scene.raycastDistanceBatch(rays)].map((d) => [d.t, d.model]), [[4, first], [Infinity, 0]]);
    assert.strictEqual(scene.raycast(ray, 2).model, second);
    assert.strictEqual(scene.segmentTest([[0, 0, -5], [0, 0, 5]]).model, first);
    same([...scene.segmentTestBatch(floats(0, 0, -5, 0, 0, 5, 9, 9, 9, 9, 9, 10))].map((hit) => hit.model), [first, 0]);
    const camera = new gp.Camera();
    same(scene.cull(camera.getFrustum()).u32, Uint32Array.of(first, second));
    same([...scene.nearestBatch(floats(0, 0, 8, 0, 0, 3), 1.5)].map((n) => n.model), [second, 0]);
    assert.strictEqual(scene.sweepSphere([[0, 0, -6], 1], [0, 0, 8]).t, 0.5);
    assert.strictEqual(scene.sweepSphereBatch(floats(0, 0, -6, 1, 5, 5, 5, 1), floats(0, 0, 8, 0, 1, 0)).get(1).model, 0);
    assert.strictEqual(scene.getOctreeStats().item_count, 2);
    assert.strictEqual([...scene.getOctreeBoxes()].reduce((sum, box) => sum + box.item_count, 0), 2);
});

test('solids move up to what they touch, and out of what they overlap', () => {
    const above = gp.sphere([0, 4, 0], 1), moving = gp.sphere([0, 0, 5], 1), deep = gp.sphere([0, 0, 8.5], 1);
    assert.strictEqual(gp.sweep(ball, above, [0, -4, 0]).t, 0.5);
    assert.strictEqual(gp.penetration(ball, gp.sphere([0, 0, 1.5], 1)).depth, 0.5);
    const scene = new gp.Scene();
    scene.add(ball);
    const target = scene.add(ball, at(0, 0, 10)), filter = { ignored_model: target }, ways = floats(0, 0, 6, 0, 0, 6);
    assert.strictEqual(scene.sweep(moving, [0, 0, 6]).model, target);
    assert.strictEqual(scene.sweepFiltered(moving, [0, 0, 6], filter), null);
    assert.strictEqual(scene.sweepBatch(moving, ways).get(1).model, target);
    assert.strictEqual(scene.sweepFilteredBatch(moving, ways, filter).get(1).model, 0);
    assert.strictEqual(scene.penetration(deep).get(0).depth, 0.5);
    assert.strictEqual([...scene.penetrationFiltered(deep, filter)].length, 0);
    const crowd = gp.shapes('sphere', floats(0, 0, 8.5, 1, 0, 0, 5, 1)), { values, offsets } = scene.penetrationBatch(crowd);
    same([values.get(0).model, [...offsets]], [target, [0, 1, 1]]);
    same([...scene.penetrationFilteredBatch(crowd, filter).offsets], [0, 0, 0]);
    const others = gp.shapes('sphere', floats(0, 4, 0, 1, 0, 0, 1.5, 1));
    same([...gp.sweepBatch(ball, others, floats(0, -4, 0, 0, -4, 0))].map((hit) => hit.t), [0.5, 0]);
    same([...gp.penetrationBatch(ball, others)].map((way) => way.depth), [-Infinity, 0.5]);
});

test('filters leave out models', () => {
    const scene = new gp.Scene();
    const body = scene.add(ball);
    scene.add(ball, at(0, 0, 3), { parent: body });
    const target = scene.add(ball, at(0, 0, 10));
    const ray = [[0, 0, 0], [0, 0, 1], Infinity], segment = [[0, 0, 0], [0, 0, 20]], large = gp.sphere([0, 0, 0], 50);
    const filter = { ignored_model: body, flags: gp.FILTER_SUBTREE };
    const rays = floats(0, 0, 0, 0, 0, 1, 100, 0, 0, 0, 0, 0, 1, 100), models = (hits) => [...hits].map((hit) => hit.model);
    assert.strictEqual(scene.raycastFiltered(ray).model, body);
    assert.strictEqual(scene.raycastFiltered(ray, filter).model, target);
    assert.strictEqual(scene.segmentTestFiltered(segment, filter).model, target);
    assert.strictEqual(scene.nearestFiltered([0, 0, 0], Infinity, filter).model, target);
    assert.strictEqual(scene.sweepSphereFiltered([[0, 0, 0], 0.5], [0, 0, 20], filter).model, target);
    same([scene.raycastAnyFiltered(ray, filter), scene.raycastAnyFiltered(ray, { layers: 0 })], [true, false]);
    same(models(scene.raycastAllFiltered(ray, filter)), [target]);
    same([...scene.overlapFiltered(large, filter)], [target]);
    same(models(scene.raycastFilteredBatch(rays, filter)), [target, target]);
    same([...scene.raycastAnyFilteredBatch(rays, filter)], [1, 1]);
    same([...scene.raycastDistanceFilteredBatch(rays, filter)].map((d) => d.model), [target, target]);
    same(models(scene.raycastAllFilteredBatch(rays, filter).values), [target, target]);
    same(models(scene.segmentTestFilteredBatch(floats(0, 0, 0, 0, 0, 20), filter)), [target]);
    same(models(scene.nearestFilteredBatch(floats(0, 0, 0), Infinity, filter)), [target]);
    same(models(scene.sweepSphereFilteredBatch(floats(0, 0, 0, 0.5), floats(0, 0, 20), filter)), [target]);
    same([...scene.overlapFilteredBatch(gp.shapes('sphere', floats(0, 0, 0, 50, 0, 0, 0, 50)), filter).values], [target, target]);
    const camera = new gp.Camera();
    camera.lookAt([0, 0, -10], [0, 0, 0], [0, 1, 0]);
    assert.strictEqual(camera.pickFiltered(scene, 400, 300, filter).model, target);
    same(models(camera.pickFilteredBatch(scene, floats(400, 300, 1, 1), filter)), [target, 0]);
    same([...camera.pickRectangleFiltered(scene, 0, 0, 800, 600, filter)], [target]);
    same([...camera.cullFiltered(scene, filter)], [target]);
    same([...scene.cullFiltered(camera.getFrustum(), filter)], [target]);
    const { origin, planes } = camera.getFrustum();
    const view = [...origin, ...planes.flatMap(({ normal, distance }) => [...normal, distance])], views = floats(...view, ...view);
    same([...scene.cullBatch(views).offsets], [0, 3, 6]);
    same([...scene.cullFilteredBatch(views, filter).values], [target, target]);
});

test('filters have lists of models', () => {
    const scene = new gp.Scene();
    const models = [0, 4, 8, 12].map((z) => scene.add(ball, at(0, 0, z))), two = models.slice(0, 2);
    const ray = { origin: [0, 0, -5], direction: [0, 0, 1] };
    const records = gp.records('uint32_t', 2);
    records.u32.set(two);
    for (const list of [two, Uint32Array.from(two), Int32Array.from(two), scene.overlap(gp.sphere([0, 0, 2], 2)), records]) {
        assert.strictEqual(scene.raycastFiltered(ray, { ignored_models: list }).model, models[2]);
        same([...scene.overlapFiltered(gp.sphere([0, 0, 2], 50), { ignored_models: list })], models.slice(2));
    }
    for (const list of [[], null, undefined, new Uint32Array(0)]) {
        assert.strictEqual(scene.raycastFiltered(ray, { ignored_models: list }).model, models[0]);
    }
    const many = Uint32Array.from({ length: 1_000_000 }, (_, i) => models[i % 3]); // more memory than there was
    assert.strictEqual(scene.raycastFiltered(ray, { layers: 1, ignored_models: many, flags: 0 }).model, models[3]);
    assert.throws(() => scene.raycastFiltered(ray, { ignored_models: [0.5] }), /ignored_models 0.5 is not a whole number/);
    assert.throws(() => scene.raycastFiltered(ray, { ignored_models: new Float32Array(1) }), /ignored_models must hold whole numbers/);
    assert.throws(() => scene.raycastFiltered(ray, { ignored_models: 7 }), /ignored_models must be/);
    assert.throws(() => scene.raycastFiltered(ray, { ignored_count: 1 }), /no field ignored_count/);
});

test('batches take a filter for each', () => {
    const scene = new gp.Scene();
    const models = [0, 4, 8, 12].map((z) => scene.add(ball, at(0, 0, z)));
    const rays = gp.records('ray', 3);
    for (let i = 0; i < 3; ++i) rays.set(i, { origin: [0, 0, -5], direction: [0, 0, 1] });
    const met = (filters) => [...scene.raycastFilteredBatch(rays, filters)].map((hit) => hit.model);
    same(met([0, 1, 2].map((i) => ({ ignored_models: models.slice(0, i) }))), models.slice(0, 3));
    same(met([{}, { ignored_model: models[0] }, { ignored_model: models[1] }]), [models[0], models[1], models[0]]);
    same(met({ ignored_models: models.slice(0, 2) }), [models[2], models[2], models[2]]);
    same(met(null), [models[0], models[0], models[0]]);
    const { offsets } = scene.overlapFilteredBatch(gp.sphere([0, 0, 2], 2), [{}, { ignored_models: models }, { ignored_model: models[0] }]);
    same([...offsets], [0, 2, 2, 3]);
    assert.throws(() => met([{}, {}]), /different lengths/);
    assert.throws(() => met([{}, {}, null]), /filters: expected an object/);
});

test('records have a length, and rays no end', () => {
    for (const length of [-1, 1.5, NaN, 2 ** 32, '3']) assert.throws(() => gp.records('ray', length), /length/);
    const rays = gp.records('ray', 2);
    same([...rays].map(({ t_max }) => t_max), [Infinity, Infinity]);
    same([...gp.records('ray', 0)], []);
});

test('shapes change, trees and cameras are read', () => {
    const scene = new gp.Scene();
    const body = scene.add(ball), head = scene.add(ball, null, { parent: body });
    scene.setShape(body, gp.sphere([0, 0, 0], 5));
    same(scene.getBounds(body).max, [5, 5, 5]);
    scene.setScale(body, [2, 2, 2]);
    same([scene.getBounds(body).max, scene.getScale(body)], [[10, 10, 10], [2, 2, 2]]);
    same([...scene.getRoots()], [body]);
    same([...scene.getChildren(body)], [head]);
    const camera = new gp.Camera();
    camera.setOrthographic(10, 1, 100);
    camera.setViewport(200, 100);
    same(camera.getProjection(), [gp.PROJECTION_ORTHOGRAPHIC, 10, 1, 100]);
    same(camera.getViewport(), [200, 100]);
});

test('cameras see by aspect, in a window, from the near plane on', () => {
    const camera = new gp.Camera();
    camera.setPerspectiveAspect(1, 2, 1, 100);
    same(camera.getAspect(), [2, true]);
    same(camera.getConventions(), [gp.LEFT_HANDED, gp.DEPTH_ZERO_TO_ONE, false]);
    camera.setOrthographicSize(8, 6, 1, 100);
    same(camera.getImageSize(), [8, 6]);
    camera.setViewportOrigin(800, 0);
    same(camera.getViewportOrigin(), [800, 0]);
    camera.setPerspective(1, 1, 100);
    same([...camera.pickRay(1200, 300).origin], [0, 0, 1]);
    camera.setPickStart(gp.PICK_FROM_CENTRE);
    assert.strictEqual(camera.getPickStart(), gp.PICK_FROM_CENTRE);
    same([...camera.pickRay(1200, 300).origin], [0, 0, 0]);
    const view = camera.getViewMatrix();
    camera.setViewMatrix(view);
    assert.strictEqual(gp.mat4Orthonormality(view), 0);
    same(camera.getRectangleCorners(800, 0, 1600, 600), camera.getCorners());
    same([...camera.getRectangleFrustum(800, 0, 1200, 600).origin], [0, 0, 0]);
    camera.setOrbit(gp.defaultOrbit());
    camera.setOrbitSpeeds([0.5, 1, 2, 3, 4]);
    assert.strictEqual(camera.getOrbitSpeeds().pan_y, 4);
    const x1 = [[1, 0, 0], 1], y2 = [[0, 1, 0], 2], z3 = [[0, 0, 1], 3];
    same([...gp.planesIntersection(x1, y2, z3)], [1, 2, 3]);
    assert.strictEqual(gp.planesIntersection(x1, y2, y2), null);
    same([...gp.planesIntersectionBatch(floats(1, 0, 0, 1), floats(0, 1, 0, 2), floats(0, 0, 1, 3)).get(0)], [1, 2, 3]);
});

test('a mesh deforms, and its models with it', () => {
    const mesh = new gp.Mesh(floats(0, 0, 0, 1, 0, 0, 0, 1, 0), Uint32Array.of(0, 1, 2), { deformable: 1 });
    const scene = new gp.Scene(), model = scene.add(mesh);
    mesh.setVertices(floats(0, 0, 7, 1, 0, 7, 0, 1, 7));
    near([scene.getBounds(model).min[2]], [7], 1e-3);
    assert.strictEqual(mesh.getInfo().deformable, 1);
    // The mesh of a restored scene, met from behind, or not.
    const copy = new gp.Scene();
    copy.restore(null, scene.getSnapshot(1));
    const { kind, vertex_count, triangle_count } = gp.Mesh.fromScene(copy, model).getInfo();
    same([kind, vertex_count, triangle_count], [gp.MESH_SURFACE, 3, 1]);
    const fromBehind = [[0.2, 0.2, 0], [0, 0, 1], Infinity];
    assert.strictEqual(copy.raycastFiltered(fromBehind, { flags: gp.FILTER_NO_FRONT_FACES }).flags, gp.HIT_BACK);
    assert.strictEqual(copy.raycastFiltered(fromBehind, { flags: gp.FILTER_NO_BACK_FACES }), null);
});

test('a hull is a solid mesh', () => {
    const hull = gp.Mesh.hull(floats(0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.1, 0.1, 0.1));
    same(hull.getVertices().length, 4);
    same(hull.getHullPlanes().length, 4);
    same([...hull.getHullFaces()], [0, 1, 2, 3]);
});

test('a rope is picked as a model that follows it', () => {
    const solver = new gp.Solver(), scene = new gp.Scene();
    const rope = solver.addRope(floats(0, 0, 0, 1, 0, 0, 2, 0, 0), 0);
    const model = scene.add(gp.Mesh.fromBody(solver, rope));
    solver.setPositions(rope, 0, floats(0, 0, 7, 1, 0, 7, 2, 0, 7));
    const hit = scene.raycast([[1.8, 0, 0], [0, 0, 1], Infinity]);
    same([hit.model, hit.triangle], [model, 1]);
    same(solver.getNearestParticle(rope, hit.triangle, hit.point), 2);
});

test('cameras', () => {
    const camera = new gp.Camera({ viewport_width: 200, viewport_height: 100 });
    camera.lookAt([0, 0, -10], [0, 0, 0], [0, 1, 0]);
    near(camera.project([0, 0, 5]).slice(0, 2), [100, 50]);
    near(camera.unproject(camera.project([1, 2, 5])), [1, 2, 5], 1e-3);
    const pixels = camera.projectBatch(floats(0, 0, 5, 1, 2, 5));
    near(camera.unprojectBatch(pixels).get(1), [1, 2, 5], 1e-3);
    near(camera.getTransform()[0], [0, 0, -10]);
    const view = camera.getViewMatrix(), projection = camera.getProjectionMatrix();
    near(view, [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 10, 1]);
    near(camera.getWorldMatrix(), [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -10, 1]);
    near(camera.getViewProjectionMatrix().slice(0, 12), projection.slice(0, 12)); // only moved
    camera.setWorldMatrix(camera.getWorldMatrix());
    camera.setTransform([0, 0, -20], IDENTITY);
    near(camera.getTransform()[0], [0, 0, -20]);
    camera.setProjection(projection);
    camera.setViewport(400, 200);
    near(camera.project([0, 0, 5]).slice(0, 2), [200, 100]);
    camera.setOrigin([0, 0, -20]);
    same([camera.getOrigin(), camera.getTransform()[0]], [[0, 0, -20], [0, 0, 0]]);
});

test('picking', () => {
    const scene = new gp.Scene(), camera = new gp.Camera({ viewport_width: 4, viewport_height: 2 });
    const model = scene.add(gp.sphere([0, 0, 5], 0.5));
    same([...camera.pickBatch(scene, floats(2, 1, 0, 0))].map((hit) => hit.model), [model, 0]);
    const rays = camera.pickRays(0, 0, 4, 2);
    assert.strictEqual(rays.length, 8);
    near([...rays.get(5).direction], [...camera.pickRay(1.5, 1.5).direction]);
    camera.setOrbit({ ...gp.defaultOrbit(), metres_per_unit: 0.5 });
    camera.orbitZoom(4);
    camera.orbitPan(2, 6);
    camera.orbitUpdate();
    const { distance, target } = camera.getOrbit();
    assert.strictEqual(distance, 8);
    near(target, [1, 3, 0]);
});

test('bodies', () => {
    const solver = new gp.Solver({ substeps: 4, gravity: [0, -10, 0] });
    const drops = solver.addParticles(floats(0, 0, 0, 1, 0, 0, 2, 0, 0), { mass: 3 });
    same([...solver.getMasses(drops, 0, 3)], [1, 1, 1]);
    solver.setGravity([0, 0, 0]);
    solver.setSubsteps(1);
    solver.setVelocities(drops, 0, floats(1, 0, 0));
    solver.setForces(drops, 1, floats(0, 2, 0));
    solver.setRadii(drops, 0, floats(0.1, 0.1, 0.1));
    solver.step(null, 0.5);
    near(solver.getPositions(drops, 0, 1).get(0), [0.5, 0, 0]);
    near(solver.getVelocities(drops, 1, 1).get(0), [0, 1, 0]);
    solver.setPositions(drops, 2, floats(5, 5, 5));
    same(solver.getPositions(drops, 2, 1).get(0), [5, 5, 5]);
    const link = solver.addDistance(drops, 0, 1, 2, 0.001);
    same([...solver.getConstraints(drops)].map((c) => [c.id, c.particle_a, c.particle_b, c.rest_length]), [[link, 0, 1, 2]]);
    solver.removeConstraint(drops, link);
    assert.strictEqual(solver.getStats(drops).constraint_count, 0);
    solver.setOrigin([0, 0, 1]);
    same([solver.getOrigin(), solver.getPositions(drops, 2, 1).get(0)], [[0, 0, 1], [5, 5, 4]]);
    same([...solver.getBodies()], [drops]);
    const snapshot = solver.getSnapshot(), hash = solver.getHash();
    assert.strictEqual(hash.length, 2);
    solver.removeBody(drops);
    assert.notDeepStrictEqual(solver.getHash(), hash);
    const other = new gp.Solver();
    other.restore(snapshot);
    same(other.getHash(), hash);
    assert.throws(() => other.restore(snapshot.u32.subarray(1)), gp.GamephysError);
    const place = new gp.Scene(), copy = new gp.Scene();
    place.add(gp.sphere([0, 1, 0], 1));
    copy.restore(null, place.getSnapshot(1));
    same(copy.getHash(), place.getHash());
    copy.restore(place, place.getSnapshot(0));
    same([...copy.getModels()], [...place.getModels()]);
    same([...solver.getBodies()], []);
    other.wake(0);
    same([...other.getSleeping()], []);
});

test('substeps, as many as asked for or as a target takes', () => {
    const [plain, careful] = [{}, { max_strain: 1e-6 }].map((desc) => {
        const solver = new gp.Solver(desc);
        const cloth = solver.addCloth([0, 0, 0], [1, 0, 0], [0, 0, 1], 3, 3);
        solver.setPinned(cloth, 0, 1, true);
        assert.strictEqual(solver.getSubsteps(cloth), 0);
        for (let i = 0; i < 5; ++i) solver.step(null, 0.01);
        return solver.getSubsteps(cloth);
    });
    assert.strictEqual(plain, 8);
    assert(careful > 8);
});

test('a string holds a weight, a tetrahedron keeps its volume', () => {
    const scene = new gp.Scene(), solver = new gp.Solver();
    const hook = scene.add(gp.sphere([0, 0, 0], 0.1), null, { tag: 5 });
    const weights = solver.addParticles(floats(0, 0, 0, 0, -1, 0), { mass: 2, layers: 0 });
    solver.attach(scene, weights, 0, hook, [0, 0, 0]);
    const string = solver.addMaxDistance(weights, 0, 1, 2, 1e-6);
    solver.setConstraintDamping(weights, string, 50);
    same([...solver.getConstraintKinds(weights, Uint32Array.of(string))], [gp.CONSTRAINT_MAX_DISTANCE]);
    same([...solver.getAttachments(weights)].map((attachment) => attachment.model), [hook]);
    for (let i = 0; i < 300; ++i) solver.step(scene, 0.01);
    near(solver.getPositions(weights, 1, 1).get(0), [0, -2, 0], 1e-3);
    const [impulse, ...others] = solver.getImpulses();
    same([impulse.model, impulse.tag, others], [hook, 5, []]);
    near(impulse.linear, [0, -2 * 9.81 * 0.01, 0], 5e-3);
    const ball = solver.addClothMesh(someMesh(), at(0, 0, 0));
    solver.setVolume(ball, -1, 0);
    near(solver.getVolume(ball), [1 / 6, 0]);
    near(solver.getVolumeSettings(ball), [1 / 6, 0]);
    solver.setVolume(ball, 1, Infinity);
    assert.throws(() => solver.getVolume(ball), { status: gp.ERROR_UNSUPPORTED });
});

test('settings change live', () => {
    const solver = new gp.Solver();
    solver.setSettings({ ...solver.getSettings(), substeps: 5 });
    assert.strictEqual(solver.getSettings().substeps, 5);
    solver.setWorkerCount(1);
    same([solver.getWorkerCount(), solver.getLeftover()], [1, 0]);
    const rope = solver.addRope(floats(0, 0, 0, 0, -1, 0), 0);
    solver.setPinned(rope, 0, 1, true);
    same([...solver.getPinned(rope, 0, 2)], [1, 0]);
    solver.setBodySettings(rope, { ...solver.getBodySettings(rope), damping: 0.5 });
    assert.strictEqual(solver.getBodySettings(rope).damping, 0.5);
    const links = Uint32Array.from(solver.getConstraints(rope), (link) => link.id);
    same([...solver.getConstraintSettings(rope, links)].map((link) => link.rest_length), [1]);
    solver.setConstraintSettings(rope, links, floats(0.5, 0, 0));
    near(solver.getRadii(rope, 0, 2).f32, [0.01, 0.01]);
    near(solver.getForces(rope, 0, 2).get(1), [0, 0, 0]);
    for (let i = 0; i < 10; ++i) solver.step(null, 0.01);
    near(solver.getPositions(rope, 1, 1).get(0), [0, -0.5, 0]);
});

test('wind carries balls along', () => {
    const solver = new gp.Solver({ gravity: [0, 0, 0] });
    const balls = solver.addParticles(floats(0, 0, 0, 1, 0, 0));
    solver.setWind(balls, { velocity: [2, 0, 0], density: 1e4, drag: 0.5, lift: 0 });
    assert.strictEqual(solver.getWind(balls).density, 1e4);
    solver.setAirVelocities(balls, 1, floats(0, 3, 0));
    near(solver.getAirVelocities(balls, 0, 2).get(1), [0, 3, 0]);
    for (let i = 0; i < 500; ++i) solver.step(null, 0.01);
    const [first, second] = solver.getVelocities(balls, 0, 2);
    assert(first[0] > 1.8 && second[1] > 2.7);
});

test('a cluster holds out a particle until it ends', () => {
    const solver = new gp.Solver();
    const plank = solver.addParticles(floats(0, 0, 0, 1, 0, 0, 2, 0, 0));
    solver.setPinned(plank, 0, 2, true);
    const cluster = solver.addCluster(plank, Uint32Array.of(0, 1, 2));
    same([...solver.getClusters(plank)], [cluster]);
    same([...solver.getClusterParticles(plank, cluster)], [0, 1, 2]);
    for (let i = 0; i < 30; ++i) solver.step(null, 0.01);
    near(solver.getPositions(plank, 2, 1).f32, [2, 0, 0]);
    solver.removeCluster(plank, cluster);
    for (let i = 0; i < 30; ++i) solver.step(null, 0.01);
    assert(solver.getPositions(plank, 2, 1).f32[1] < -0.4);
    assert.throws(() => solver.removeCluster(plank, cluster), { status: gp.ERROR_INVALID_ID });
});

test('a rope breaks under its weight, and cloth is cut', () => {
    const solver = new gp.Solver();
    const rope = solver.addRope(floats(0, 0, 0, 0, -1, 0), 0);
    solver.setPinned(rope, 0, 1, true);
    const links = Uint32Array.from(solver.getConstraints(rope), (link) => link.id);
    solver.setBreakingForces(rope, links, Float32Array.of(3));
    same([...solver.getBreakingForces(rope, links)], [3]);
    same([...solver.getBreaks()], []);
    for (let i = 0; i < 10 && [...solver.getBreaks()].length === 0; ++i) solver.step(null, 0.01);
    const [broken] = [...solver.getBreaks()];
    same([broken.body, broken.constraint, broken.torn_particle], [rope, links[0], gp.NO_PARTICLE]);
    assert(broken.load > 3);
    assert.throws(() => solver.breakConstraint(rope, links[0]), { status: gp.ERROR_INVALID_ID });
    const sheet = solver.addCloth([0, 0, 0], [1, 0, 0], [0, 0, 1], 3, 3);
    const [, second] = Array.from(solver.getConstraints(sheet), (link) => link.id);
    assert.strictEqual(solver.breakConstraint(sheet, second).new_particle, 9);
});

test('one of two balls slides over ice', () => {
    const solver = new gp.Solver();
    const scene = new gp.Scene();
    scene.add(gp.plane([0, 1, 0], 0));
    const balls = solver.addParticles(floats(0, 0.01, 0, 0, 0.01, 1));
    solver.setFrictionFactors(balls, 1, floats(0));
    near(solver.getFrictionFactors(balls, 0, 2).f32, [1, 0]);
    solver.setVelocities(balls, 0, floats(1, 0, 0, 1, 0, 0));
    for (let i = 0; i < 50; ++i) solver.step(scene, 0.01);
    const [first, second] = solver.getVelocities(balls, 0, 2);
    near([first[0], second[0]], [0, 1]);
});

test('a ball presses the one that it lies on', () => {
    const solver = new gp.Solver(), desc = { mass: 2, radius: 0.5, body_layers: 1 };
    const lower = solver.addParticles(floats(0, 0, 0), desc), upper = solver.addParticles(floats(0, 1, 0), desc);
    solver.setPinned(lower, 0, 1, true);
    for (let i = 0; i < 20; ++i) solver.step(null, 0.01);
    const [contact, ...others] = solver.getBodyContacts();
    same([contact.body_a, contact.body_b, contact.normal, others], [lower, upper, [0, 1, 0], []]);
    near([contact.impulse], [0.1962], 2e-3);
});

test('a ball hangs below its animation target', () => {
    const solver = new gp.Solver();
    const balls = solver.addParticles(floats(0, 0, 0, 1, 0, 0));
    solver.setAnimationTargets(balls, 1, floats(1, 0, 0, 0, 1, 0, 0.25, Infinity));
    same([...solver.getAnimationTargets(balls, 0, 2)].map((target) => target.max_distance), [Infinity, 0.25]);
    for (let i = 0; i < 60; ++i) solver.step(null, 0.01);
    assert.strictEqual(solver.getPositions(balls, 1, 1).get(0)[1], -0.25);
});

test('a joint holds a particle of another body', () => {
    const solver = new gp.Solver();
    const nail = solver.addParticles(floats(0, 0, 0), { mass: 2 });
    const weight = solver.addParticles(floats(0, -1, 0), { mass: 2 });
    solver.setPinned(nail, 0, 1, true);
    const joint = solver.join(nail, 0, weight, 0, -1, 0);
    for (let i = 0; i < 20; ++i) solver.step(null, 0.01);
    const [held, ...others] = solver.getJoints(weight);
    same([held.id, held.body_a, held.body_b, others], [joint, nail, weight, []]);
    near([held.force], [2 * 9.81], 0.01);
    solver.unjoin(joint);
    same([...solver.getJoints(0)], []);
    assert.throws(() => solver.unjoin(joint), { status: gp.ERROR_INVALID_ID });
});

test('bodies and models', () => {
    const scene = new gp.Scene(), solver = new gp.Solver();
    const floor = scene.add(gp.plane([0, 1, 0], 0), null, { tag: 3 });
    const hook = scene.add(gp.sphere([0, 0, 0], 0.1), at(0, 9, 0));
    const mesh = someMesh();
    const cloth = solver.addClothMesh(mesh, at(0, 0.5, 0), { radius: 0.1 });
    assert.strictEqual(solver.getBodyInfo(cloth).particle_count, 4);
    same(solver.getTriangles(cloth).u32, tetrahedron.indices);
    const rope = solver.addRope(floats(0, 9, 0, 0, 8, 0), 0, { layers: 0 });
    solver.attach(scene, rope, 0, hook, [0, 0, 0]);
    scene.setTransform(hook, at(4, 9, 0));
    for (let i = 0; i < 120; ++i) solver.step(scene, 1 / 60);
    near(solver.getPositions(rope, 0, 1).get(0), [4, 9, 0]);
    const contacts = [...solver.getContacts()];
    assert(contacts.length > 0);
    for (const contact of contacts) same([contact.body, contact.model, contact.tag, contact.normal], [cloth, floor, 3, [0, 1, 0]]);
    solver.detach(rope, 0);
    assert.throws(() => solver.detach(rope, 0), gp.GamephysError);
});
