// The Node package: batches against single calls, errors, ownership.
'use strict';
const assert = require('assert');
const test = require('node:test');
const gp = require('..');

function someScene() {
    const scene = new gp.Scene();
    for (let i = 0; i < 30; ++i) scene.add(gp.sphere([3 * Math.sin(i), 3 * Math.cos(2 * i), i / 3], 0.7));
    return scene;
}

test('a batch answers as single calls do', () => {
    const scene = someScene();
    const rays = new Float32Array(200 * 7);
    for (let i = 0; i < 200; ++i) rays.set([0, 0, -5, Math.sin(i) / 2, Math.cos(3 * i) / 2, 1, Infinity], 7 * i);
    const hits = scene.raycastBatch(rays);
    let met = 0;
    for (let i = 0; i < 200; ++i) {
        const ray = rays.subarray(7 * i, 7 * i + 7);
        const single = scene.raycast([ray.subarray(0, 3), ray.subarray(3, 6), ray[6]]);
        if (single) assert.deepStrictEqual(hits.get(i), single);
        else assert.strictEqual(hits.get(i).model, 0);
        met += single !== null;
    }
    assert(met > 0 && met < 200);
});

test('results go into the memory given', () => {
    const rays = new Float32Array([0, 0, -5, 0, 0, 1, Infinity]);
    const out = new Float32Array(2 + 13);
    const hits = someScene().raycastBatch(rays, undefined, out.subarray(2));
    assert.strictEqual(hits.f32.buffer, out.buffer);
    assert.throws(() => someScene().raycastBatch(rays, undefined, out), RangeError);
});

test('lists of any length, one and many', () => {
    const scene = new gp.Scene();
    const models = scene.addBatch(gp.shapes('sphere', new Float32Array(4 * 500)));
    assert.strictEqual(scene.getModels().length, 500);
    const { values, offsets } = scene.overlapBatch(gp.shapes('aabb', new Float32Array([-1, -1, -1, 1, 1, 1, 5, 5, 5, 6, 6, 6])));
    assert.deepStrictEqual(Array.from(offsets), [0, 500, 500]);
    assert.deepStrictEqual(values.u32, models.u32);
});

test('errors carry the message of the library', () => {
    const scene = new gp.Scene();
    assert.throws(() => scene.add(gp.sphere([0, 0, 0], -1)), (e) =>
        e instanceof gp.GamephysError && e.status === gp.ERROR_INVALID_ARGUMENT && /radius/.test(e.message));
    assert.throws(() => scene.remove(12345), gp.GamephysError);
    assert.throws(() => scene.add('ball'), TypeError);
    assert.throws(() => new gp.Camera({ width: 3 }), TypeError);
    assert.throws(() => scene.raycastBatch(new Float32Array(8)), RangeError);
});

test('use after close is an error, and closing again is not', () => {
    const scene = new gp.Scene();
    scene.close();
    scene.close();
    assert.throws(() => scene.getModels(), gp.GamephysClosed);
});

test('origins are doubles', () => {
    const scene = new gp.Scene();
    scene.setOrigin([1e9 + 0.5, 0, 0]);
    assert.deepStrictEqual(Array.from(scene.getOrigin().f64), [1e9 + 0.5, 0, 0]);
});

test('a mesh is a shape of free functions too', () => {
    const mesh = new gp.Mesh(new Float32Array([-1, -1, 5, 1, -1, 5, 0, 1, 5]), new Uint32Array([0, 1, 2]));
    assert.strictEqual(gp.raycast(mesh, [[0, 0, 0], [0, 0, 1], 100]).t, 5);
    assert.strictEqual(gp.overlaps(mesh, gp.sphere([0, 0, 4], 1.5)), true);
});
