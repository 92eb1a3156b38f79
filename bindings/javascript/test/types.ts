// What TypeScript must take, and what it must refuse.
import * as gp from 'gamephys';
import init from 'gamephys/init';
import * as wasm from 'gamephys/wasm';

const scene = new gp.Scene({ worker_count: 2 });
const ball: number = scene.add(gp.sphere([0, 0, 5], 1), { position: [0, 0, 0], rotation: new Float32Array(4), scale: 1 }, { tag: 3 });
const hit: gp.Hit | null = scene.raycast({ origin: [0, 0, 0], direction: new Float32Array(3), t_max: 1 });
const ordered: gp.Hit | null = scene.raycast([[0, 0, 0], [0, 0, 1], 1], gp.ALL_LAYERS);
const rays: gp.Records<gp.Ray> = gp.records('ray', 10);
const hits: gp.Records<gp.Hit> = scene.raycastBatch(rays, undefined, new Float32Array(130));
for (const { t, point: [x] } of hits) t + x;
const plain: gp.Hit[] = hits.toJSON();
const there: boolean = scene.has(ball);
const [side, distance]: [number, number] = gp.classifyPlane(gp.sphere([0, 0, 0], 1), [[0, 1, 0], 0]);
const models: Uint32Array = scene.overlap(new gp.Mesh(new Float32Array(9), new Uint32Array(3))).u32;
const corners: number[][] | null = new wasm.Camera({ viewport_width: 3 }).getCorners();
scene.addDescribedBatch(gp.sphere([0, 0, 0], 1), null, [{ tag: 1 }, { layers: 2, parent: ball }, {}]);
scene.addDescribedBatch(gp.sphere([0, 0, 0], 1), rays, { tag: 1 }, new Uint32Array(10));

scene.raycastFiltered(rays.get(0), { ignored_models: [ball] });
scene.raycastFilteredBatch(rays, [{ ignored_models: models }, { ignored_model: ball }]);
scene.setTransform(ball, { position: [1, 2, 3] });
scene.raycast({ origin: [0, 0, 0], direction: [0, 0, 1] });
const threes = new gp.Mesh(new Float32Array(9), new Uint16Array(3));
const soup = new gp.Mesh(new Float32Array(9));
const solver = new gp.Solver();
const rope: number = solver.addRope(new Float32Array(9));
const places: gp.Records<number[]> = solver.getPositions(rope);
solver.setPinned(rope, 0, 1);

// What the README promises.
{
    using passing = new gp.Scene(), room = gp.records('ray', 10);
    passing.add(gp.sphere({ x: 0, y: 0, z: 5 }, 1), { position: { x: 0, y: 0, z: 0 }, rotation: { x: 0, y: 0, z: 0, w: 1 } });
    room.set(0, { origin: [0, 0, 0], direction: { x: 0, y: 0, z: 1 } });
}
const camera = new gp.Camera();
for (const matrix of [{ elements: new Array<number>(16) }, new Float32Array(16), camera.getViewMatrix()]) camera.setProjection(matrix);
const another: typeof gp = await init(new URL('gamephys.wasm', 'https://example.org'));
const of: Promise<typeof gp>[] = [init('gamephys.wasm'), init(fetch('gamephys.wasm')), init(new Uint8Array(8)), init({} as WebAssembly.Module)];
another.records('hit', of.length).close();

// @ts-expect-error: there is no such field
scene.setTransform(ball, { postion: [1, 2, 3] });
// @ts-expect-error: rays are floats
scene.raycastBatch(new Int32Array(7));
// @ts-expect-error: indices are whole numbers
new gp.Mesh(new Float32Array(9), new Float32Array(3));
// @ts-expect-error: there is no such field
scene.addDescribedBatch(gp.sphere([0, 0, 0], 1), null, [{ weight: 1 }]);
// @ts-expect-error: there is no such field
new gp.Camera({ width: 3 });
// @ts-expect-error: it goes with the list
scene.raycastFiltered(rays.get(0), { ignored_count: 1 });
// @ts-expect-error: a ray may meet nothing
scene.raycast(rays.get(0)).t;
// @ts-expect-error: there is no such kind
gp.records('raygun', 1);
// @ts-expect-error: not a scene
new gp.Solver().step(new gp.Camera(), 0.1);
// @ts-expect-error: a field is missing
scene.raycast({ origin: [0, 0, 0] });
// @ts-expect-error: a matrix is not a vector
camera.setProjection({ x: 0, y: 0, z: 0 });
// @ts-expect-error: a vector is not a matrix
camera.lookAt([0, 0, 0], { elements: [0, 0, 1] }, [0, 1, 0]);
// @ts-expect-error: gamephys.wasm is missing
init();
