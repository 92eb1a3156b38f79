// The package, as native library or as WebAssembly (node --conditions=browser): batches against single
// calls, memory, errors, ownership.
import assert from 'node:assert';
import { spawnSync } from 'node:child_process';
import { cpSync, existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test from 'node:test';
import { fileURLToPath } from 'node:url';
import { inspect } from 'node:util';
import * as gp from 'gamephys';
import init from 'gamephys/init';

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

test('new records are 0, also in memory that was used before', () => {
    for (let i = 0; i < 5; ++i) {
        const records = gp.records('hit', 300);
        assert(records.u32.every((word) => word === 0));
        records.u32.fill(7);
        records.close();
    }
});

test('results go into the memory given', () => {
    const rays = new Float32Array([0, 0, -5, 0, 0, 1, Infinity]);
    const out = new Float32Array(2 + 13);
    const hits = someScene().raycastBatch(rays, undefined, out.subarray(2));
    assert.strictEqual(hits.f32.buffer, out.buffer);
    assert.throws(() => someScene().raycastBatch(rays, undefined, out), RangeError);
});

test('workers, where there are threads for them, change no answer', () => {
    const rays = new Float32Array(3000 * 7);
    for (let i = 0; i < 3000; ++i) rays.set([0, 0, -5, Math.sin(i) / 2, Math.cos(3 * i) / 2, 1, Infinity], 7 * i);
    const answers = [1, 2].map((worker_count) => {
        const scene = new gp.Scene({ worker_count });
        for (let i = 0; i < 30; ++i) scene.add(gp.sphere([Math.sin(i), Math.cos(2 * i), i / 3], 0.7));
        const solver = new gp.Solver({ worker_count });
        for (let i = 0; i < 2; ++i) solver.addRope(new Float32Array([0, 2 + i, 0, 0, 2 + i, 1]), 0);
        solver.step(scene, 1 / 60);
        return [scene.raycastBatch(rays).u32, solver.getHash()];
    });
    assert.deepStrictEqual(answers[1], answers[0]);
});

test('Records and objects are no plain data: they are printed, and not cloned to nothing', () => {
    const scene = someScene();
    const all = scene.getModels();
    assert.strictEqual(JSON.stringify({ all }), JSON.stringify({ all: [...all.u32] }));
    assert.strictEqual(inspect(scene), 'Scene { models: 30 }');
    assert.strictEqual(inspect([[[[all, scene]]]]), '[ [ [ [Array] ] ] ]');
    assert.strictEqual(inspect([[[all, scene]]]), '[ [ [ [Records uint32_t (30)], [Scene] ] ] ]');
    assert.match(inspect(scene.raycastAll([[0, 0, 0], [0, 0, 1], 0])), /^Records hit \(0\) \[\]$/);
    assert.match(inspect(gp.records('hit', 300)), /^Records hit \(300\) \[\n {2}\{\n {4}model: 0,[^]* and 200 more$/);
    for (const value of [all, gp.records('ray', 2), scene, new gp.Camera(), new gp.Solver()]) {
        assert.throws(() => structuredClone(value), { name: 'DataCloneError' });
        assert.throws(() => structuredClone({ inside: [value] }), { name: 'DataCloneError' });
    }
    assert.throws(() => JSON.stringify({ scene }), { name: 'TypeError', message: /^a Scene is an object of the library, not data: take its getSnapshot\(\)$/ });
    const room = gp.records('ray', 2);
    room.close();
    scene.close();
    assert.strictEqual(inspect(scene), 'Scene (closed)');
    inspect(room);
});

test('ids and masks that are not whole numbers of 32 bits are refused by name', () => {
    const scene = new gp.Scene();
    const ball = scene.add(gp.sphere([0, 0, 5], 1));
    const ray = [[0, 0, 0], [0, 0, 1], 100];
    for (const [type, message, call] of [
        [RangeError, /^model \d+ is not a whole number from 0/, () => scene.remove(2 ** 32 + ball)],
        [RangeError, /^model -1 is not/, () => scene.remove(-1)],
        [RangeError, /^model .*\.5 is not/, () => scene.remove(ball + 0.5)],
        [TypeError, /^model: expected a number, got undefined/, () => scene.remove()],
        [TypeError, /^model: expected a number, got 5/, () => scene.has(5n)],
        [RangeError, /^layers 4294967296 is not a set/, () => scene.raycast(ray, 2 ** 32)],
        [RangeError, /^layers 1.5 is not a set/, () => scene.raycast(ray, 1.5)],
        [RangeError, /^tag 4294967296/, () => scene.add(gp.sphere([0, 0, 5], 1), null, { tag: 2 ** 32 })],
        [TypeError, /^dt: expected a number/, () => new gp.Solver().step(scene)],
        [TypeError, /^expected a scene_desc, got 3/, () => new gp.Scene(3)],
    ]) {
        assert.throws(call, (error) => error instanceof type && message.test(error.message));
    }
    assert(scene.has(ball));
    assert.strictEqual(scene.raycast(ray, ~2).t, 4);
    assert.strictEqual(scene.raycast(ray, -1).t, 4);
    assert.strictEqual(scene.raycast(ray, ~1), null);
});

test('what is not given is the identity, a ray without an end, a whole body', () => {
    const scene = new gp.Scene();
    const model = scene.add(gp.obb([0, 0, 0], [1, 1, 1], [0, 0, 0, 1]), { position: [0, 0, 5] });
    assert.deepStrictEqual(scene.getTransforms(new Uint32Array([model])).get(0), { position: [0, 0, 5], rotation: [0, 0, 0, 1], scale: 1 });
    assert.strictEqual(scene.raycast({ origin: [0, 0, 0], direction: [0, 0, 1] }).t, 4);
    assert.throws(() => scene.setTransform(model, { postion: [1, 2, 3] }), /transform has no field postion/);
    const solver = new gp.Solver();
    const rope = solver.addRope(new Float32Array([0, 0, 0, 0, 1, 0, 0, 2, 0]));
    assert.strictEqual(solver.getPositions(rope).length, 3);
    assert.strictEqual(solver.getPositions(rope, 1).length, 2);
    solver.setPinned(rope, 1);
    assert.deepStrictEqual([...solver.getPinned(rope)], [0, 1, 1]);
});

test('arrays hold the numbers that are meant', () => {
    const scene = new gp.Scene();
    const corners = new Float32Array([0, 0, 5, 1, 0, 5, 0, 1, 5]);
    assert.throws(() => scene.raycastBatch(new Int32Array([0, 0, 0, 0, 0, 1, 100])), /rays must hold floats: not Int32Array/);
    assert.throws(() => new gp.Mesh(corners, new Float32Array([0, 1, 2])), /indices must hold whole numbers: not Float32Array/);
    for (const indices of [new Uint16Array([0, 1, 2]), new Int32Array([0, 1, 2]), null, undefined]) {
        assert.deepStrictEqual([...new gp.Mesh(corners, indices).getIndices()], [0, 1, 2]);
    }
    const matrix = [0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 5, 6, 7, 1];
    for (const given of [matrix, new Float32Array(matrix), { m: matrix }, { elements: matrix }]) {
        const camera = new gp.Camera();
        camera.setWorldMatrix(given);
        assert.deepStrictEqual(camera.getTransform()[0], [5, 6, 7]);
    }
});

test('records and results are of the kind that is meant', () => {
    const scene = new gp.Scene();
    const model = scene.add(gp.sphere([0, 0, 5], 1));
    const rays = gp.records('ray', 3);
    for (let i = 0; i < 3; ++i) rays.set(i, { origin: [0, 0, 0], direction: [0, 0, 1], t_max: 100 });
    assert.throws(() => scene.raycastBatch(gp.records('transform', 7)), /rays: transform has 32 bytes, not 28/);
    assert.throws(() => scene.removeBatch(gp.records('ray', 1)), /models must hold whole numbers: not Records of ray/);
    assert.throws(() => new gp.Mesh(gp.records('uint32_t', 9)), /vertices must hold floats: not Records of uint32_t/);
    assert.equal(new gp.Mesh(gp.records('triangle', 1)).getInfo().vertex_count, 3);
    for (const out of [new Float32Array(3), gp.records('distance', 1), gp.records('float', 3)]) {
        assert.throws(() => scene.raycastAnyBatch(rays, gp.ALL_LAYERS, out), TypeError);
    }
    const out = new Uint32Array(3);
    scene.raycastAnyBatch(rays, gp.ALL_LAYERS, out);
    assert.deepEqual([...out], [1, 1, 1]);
    // Bytes that begin between two numbers.
    const bytes = new Uint8Array(rays.f32.byteLength + 1);
    bytes.set(new Uint8Array(rays.f32.buffer, rays.f32.byteOffset, rays.f32.byteLength), 1);
    assert.deepEqual([...scene.raycastBatch(bytes.subarray(1))].map((hit) => hit.model), [model, model, model]);
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
    assert.throws(() => scene.raycastBatch(new Float64Array(7)), TypeError);
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
    assert.deepStrictEqual(scene.getOrigin(), [1e9 + 0.5, 0, 0]);
});

test('a mesh is a shape of free functions too', () => {
    const mesh = new gp.Mesh(new Float32Array([-1, -1, 5, 1, -1, 5, 0, 1, 5]), new Uint32Array([0, 1, 2]));
    assert.strictEqual(gp.raycast(mesh, [[0, 0, 0], [0, 0, 1], 100]).t, 5);
    assert.strictEqual(gp.overlaps(mesh, gp.sphere([0, 0, 4], 1.5)), true);
});

test('each kind of shape is what it was made from', () => {
    const scene = new gp.Scene();
    const ball = scene.add(gp.sphere([1, 2, 3], 4));
    assert.deepStrictEqual(scene.getShape(ball).value, { center: [1, 2, 3], radius: 4 });
    const box = scene.add(gp.aabb({ x: -1, y: -2, z: -3 }, [1, 2, 3]));
    assert.deepStrictEqual(scene.getShape(box).value, { min: [-1, -2, -3], max: [1, 2, 3] });
    const mesh = scene.add(new gp.Mesh(new Float32Array(9), new Uint32Array([0, 1, 2])));
    assert.throws(() => scene.getShape(mesh), gp.GamephysError);
    const { frustum } = gp;
    const seen = new gp.Camera().getFrustum();
    assert.deepStrictEqual(frustum(seen.origin, seen.planes).value, seen);
});

test('a shape is moved, and a box turned', () => {
    const quarter = [0, Math.SQRT1_2, 0, Math.SQRT1_2]; // about y: z becomes x
    const moved = gp.transform(gp.aabb([0, 0, 0], [1, 2, 4]), [[10, 0, 0], quarter, 2]);
    assert.strictEqual(moved.kind, 'obb');
    assert.deepEqual(gp.bounds(moved), { min: [10, 0, -2], max: [18, 4, 0] });
    assert.deepEqual(gp.transform(gp.sphere([0, 0, 1], 1), [[0, 0, 0], quarter, 3]).value, { center: [3, 0, 0], radius: 3 });
});

test('one mesh against many shapes', () => {
    const mesh = new gp.Mesh(new Float32Array([-1, 0, -1, 1, 0, -1, 0, 0, 1]), new Uint32Array([0, 1, 2]));
    const balls = gp.shapes('sphere', new Float32Array([0, 2, 0, 1.5, 0, 2, 0, 2.5, 9, 0, 0, 1]));
    assert.deepStrictEqual(Array.from(gp.overlapsBatch(mesh, balls).i32), [0, 1, 0]);
    assert.throws(() => gp.overlapsBatch(mesh, mesh), RangeError);
});

test('records are written and read in place', () => {
    const rays = gp.records('ray', 100);
    const hits = gp.records('hit', 100);
    for (let i = 0; i < 100; ++i) rays.set(i, { origin: [0.05 * i, 0, -5], direction: [0, 0, 1], t_max: Infinity });
    assert.strictEqual(rays.f32[7 * 3], Math.fround(0.15));
    const scene = new gp.Scene();
    scene.add(gp.sphere([0, 0, 0], 1));
    assert.strictEqual(scene.raycastBatch(rays, undefined, hits), hits);
    assert.deepStrictEqual([...hits].map((hit) => hit.model !== 0), Array.from({ length: 100 }, (_, i) => 0.05 * i <= 1));
    assert.throws(() => hits.get(100), RangeError);
    assert.throws(() => gp.records('raygun', 1), TypeError);
    for (const length of [-1, 1.5, NaN, '1', undefined]) assert.throws(() => gp.records('ray', length), /length/);
    for (const records of [rays, hits]) records.close();
});

test('records outlive growth of memory, and views that do not are refused', () => {
    const scene = new gp.Scene();
    scene.add(gp.sphere([0, 0, 0], 1));
    const ray = gp.records('ray', 1);
    ray.set(0, [[0, 0, -5], [0, 0, 1], Infinity]);
    const hit = gp.records('hit', 1);
    const kept = ray.f32;
    const results = scene.raycastBatch(ray, undefined, hit.f32);
    const more = Array.from({ length: 8 }, () => gp.records('hit', 1 << 20)); // 436 MB
    assert.strictEqual(ray.f32[2], -5);
    assert.strictEqual(results.get(0).t, 4);
    if (kept.length === 0) assert.throws(() => scene.raycastBatch(kept), /^TypeError: rays: the memory of this view has moved/);
    assert.strictEqual(scene.raycastBatch(new Float32Array(0)).length, 0);
    // Growth while a call takes its arrays: a copied one, and results beside.
    const rays = new Float32Array(7 << 20);
    for (let i = 0; i < rays.length; i += 7) rays.set([0, 0, -5, 0, 0, 1, Infinity], i);
    const hits = scene.raycastBatch(rays, undefined, more[0].f32);
    assert.strictEqual(hits.get((1 << 20) - 1).t, 4);
    assert.strictEqual(more[0].get((1 << 20) - 1).t, 4);
    more.forEach((records) => records.close());
});

test('a list is as long as it is', () => {
    const scene = new gp.Scene();
    const ids = scene.addBatch(gp.shapes('sphere', new Float32Array(4 * 70000))).u32;
    assert.deepStrictEqual(scene.getModels().u32, ids);
    scene.removeBatch(ids.subarray(1));
    assert.deepStrictEqual(scene.getModels().u32, ids.slice(0, 1));
    const rays = new Float32Array([0, 0, -5, 0, 0, 1, 9, 0, 0, 5, 0, 0, 1, 9]);
    const { values, offsets } = scene.raycastAllBatch(rays);
    assert.deepStrictEqual(Array.from(offsets), [0, 1, 1]);
    assert.strictEqual(values.get(0).t, 5);
});

test('settings start from the defaults, and the library is named', () => {
    const camera = new gp.Camera({ handedness: gp.RIGHT_HANDED, viewport_width: 100, viewport_height: 50 });
    assert.deepStrictEqual(camera.project([0, 0, -1]).slice(0, 2), [50, 25]);
    const orbit = { ...gp.defaultOrbit(), distance: 7 };
    camera.setOrbit(orbit);
    assert.deepStrictEqual(camera.getOrbit(), orbit);
    assert.match(gp.version(), /^\d+\.\d+\.\d+$/);
    assert.strictEqual(gp.statusName(gp.NO_HIT), 'GPHYS_NO_HIT');
});

test('a package without any library says what it has looked for', () => {
    const folder = mkdtempSync(join(tmpdir(), 'gamephys-'));
    for (const name of ['package.json', 'node.js', 'lib']) {
        cpSync(fileURLToPath(new URL(`../${name}`, import.meta.url)), join(folder, name), { recursive: true });
    }
    const { GAMEPHYS_LIBRARY, NODE_PATH, LD_PRELOAD, ...env } = process.env;
    const { status, stderr } = spawnSync(process.execPath, [join(folder, 'node.js')], { env, encoding: 'utf8' });
    rmSync(folder, { recursive: true });
    assert.strictEqual(status, 1);
    assert.match(stderr, /no gamephys library: not as a native one \(.*koffi.*\), nor as WebAssembly \(.*gamephys\.wasm.*\)/);
});

const module = new URL('../gamephys.wasm', import.meta.url);

test('vectors and quaternions are taken as three.js has them', () => {
    const scene = new gp.Scene();
    const ball = scene.add(gp.sphere({ x: 0, y: 0, z: 5 }, 1), { position: { x: 1, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } });
    const hit = scene.raycast({ origin: { x: 1, y: 0, z: 0 }, direction: { x: 0, y: 0, z: 1 } });
    assert.deepStrictEqual([hit.model, hit.t, hit.point], [ball, 4, [1, 0, 4]]);
});

test('the module comes from where the program says', { skip: !existsSync(module) && 'there is no gamephys.wasm' }, async () => {
    const bytes = readFileSync(module);
    const url = URL.createObjectURL(new Blob([bytes], { type: 'application/wasm' }));
    const response = (type, status = 200) => new Response(bytes, { status, headers: { 'Content-Type': type } });
    const sources = [bytes, Promise.resolve(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length)), await WebAssembly.compile(bytes),
        url, new URL(url), response('application/wasm'), response('text/plain')];
    for (const source of sources) {
        const own = await init(source);
        const scene = new own.Scene();
        const ball = scene.add(own.sphere([0, 0, 5], 1));
        assert.strictEqual(scene.raycast({ origin: [0, 0, 0], direction: [0, 0, 1] }, own.ALL_LAYERS).model, ball);
        assert.throws(() => gp.raycast(own.sphere([0, 0, 5], 1), [[0, 0, 0], [0, 0, 1], -1]), gp.GamephysError);
        scene.close();
    }
    await assert.rejects(init(), /^TypeError: gamephys.wasm: its URL, response, bytes or module is missing/);
    await assert.rejects(init(response('application/wasm', 404)), /404/);
});

test('objects of another kind are refused', () => {
    const scene = new gp.Scene();
    const camera = new gp.Camera();
    assert.throws(() => camera.cull(camera), TypeError);
    assert.throws(() => new gp.Solver().step(camera, 0.01), TypeError);
    assert.throws(() => scene.add(camera), TypeError);
    new gp.Solver().step(null, 0.01);
});

test('memory of objects that nothing refers to comes back', { skip: !globalThis.gc && 'needs --expose-gc' }, async () => {
    for (let round = 0; round < 40; ++round) {
        for (let i = 0; i < 8; ++i) gp.records('hit', 1 << 20); // 40 rounds hold 17 GB, more than there is of WebAssembly's
        new gp.Scene({ reserve_models: 1 << 20 }); // and as much again
        globalThis.gc();
        await new Promise((resolve) => setTimeout(resolve));
    }
});
