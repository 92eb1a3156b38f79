// A scene and questions to it, one by one and in a batch.
import assert from 'node:assert';
import * as gp from 'gamephys';

const scene = new gp.Scene();
const ground = scene.add(gp.plane([0, 1, 0], 0));

// A row of 100 pyramids that share one mesh, which they keep alive.
const places = new Float32Array(100 * 8); // position, rotation, scale
for (let i = 0; i < 100; ++i) places.set([5 * i, 0, 10, 0, 0, 0, 1, 1], 8 * i);
const mesh = new gp.Mesh(
    new Float32Array([-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0]),
    new Uint32Array([0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4]),
);
assert.strictEqual(mesh.getReport().open_edge_count, 0);
const pyramids = scene.addBatch(mesh, places).u32;
mesh.close();

const hit = scene.raycast({ origin: [25, 1, 0], direction: [0, 0, 1], t_max: Infinity });
console.log(`ray: a pyramid, triangle ${hit.triangle}, ${hit.t.toFixed(3)} m away`);
assert.strictEqual(hit.model, pyramids[5]);
assert.strictEqual(scene.raycast([[25, 1, 0], [0, 1, 0], Infinity]), null);
assert.strictEqual(scene.overlap(gp.aabb([-1, 0.5, 8], [21, 1, 12])).length, 5);
assert.strictEqual(scene.nearest([0, 10, -50], Infinity).model, ground);

// One call for 1000 rays that look down: 7 floats each.
const rays = new Float32Array(1000 * 7);
for (let i = 0; i < 1000; ++i) rays.set([0.5 * i, 5, 10, 0, -1, 0, 10], 7 * i);
const hits = scene.raycastBatch(rays);
let above = 0;
for (let i = 0; i < hits.length; ++i) above += hits.get(i).t < 5;
console.log(`${above} of 1000 rays end on a pyramid`);
assert.strictEqual(above, 299);
scene.close();
