// JavaScript: overhead.mjs native|wasm [milliseconds a case]
import assert from 'node:assert';

const RAYS = 1000;
const [, , memory, milliseconds = 200] = process.argv;
const gp = await import(`../javascript/${memory}.js`);
const language = memory === 'wasm' ? 'wasm' : 'javascript';

const scene = new gp.Scene();
const camera = new gp.Camera();
const model = scene.add(gp.sphere([0, 0, 5], 1));
const ray = { origin: [0, 0, 0], direction: [0, 0, 1], t_max: 100 };
const rays = gp.records('ray', RAYS);
const hits = gp.records('hit', RAYS);
for (let i = 0; i < RAYS; ++i) rays.set(i, ray);

function measure(name, call, items) {
    const finish = performance.now() + Number(milliseconds);
    let best = Infinity;
    for (let calls = 1; performance.now() < finish || best === Infinity; ) {
        const start = performance.now();
        for (let i = 0; i < calls; ++i) call();
        const elapsed = performance.now() - start;
        if (elapsed < 1) calls *= 2;
        else best = Math.min(best, elapsed / calls);
    }
    console.log(`${language},${name},${((1e6 * best) / items).toFixed(2)}`);
}

assert.strictEqual(scene.raycast(ray).t, 4);
assert.strictEqual(scene.raycastBatch(rays, gp.ALL_LAYERS, hits).get(RAYS - 1).t, 4);
measure('scalar', () => scene.has(model), 1);
measure('vec3', () => camera.getOrigin(), 1);
measure('raycast', () => scene.raycast(ray), 1);
measure('raycast_batch', () => scene.raycastBatch(rays, gp.ALL_LAYERS, hits), RAYS);
