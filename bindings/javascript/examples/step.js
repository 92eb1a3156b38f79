// A rope with a weight, and a cloth that falls over a ball.
import assert from 'node:assert';
import * as gp from 'gamephys';

const scene = new gp.Scene();
scene.add(gp.plane([0, 1, 0], 0));
scene.add(gp.sphere([0, 1, 0], 1));
const solver = new gp.Solver();
const line = new Float32Array(41 * 3);
for (let i = 0; i <= 40; ++i) line.set([5 + 0.05 * i, 3, 0], 3 * i);
const rope = solver.addRope(line, 0, { damping: 2 });
solver.setPinned(rope, 0, 1, true);
solver.setMasses(rope, 40, new Float32Array([5]));
const cloth = solver.addCloth([-1.5, 3, -1.5], [3, 0, 0], [0, 0, 3], 31, 31,
    { damping: 2, radius: 0.02, cloth_flags: gp.CLOTH_BEND });
for (let frame = 0; frame < 360; ++frame) solver.advance(scene, 1 / 60);

const count = solver.getBodyInfo(cloth).particle_count;
const positions = new Float32Array(3 * count);
solver.getPositions(cloth, 0, count, positions); // into the caller's memory
let height = Infinity;
for (let i = 0; i < count; ++i) {
    height = Math.min(height, Math.hypot(positions[3 * i], positions[3 * i + 1] - 1, positions[3 * i + 2]) - 1);
}
const weight = solver.getPositions(rope, 40, 1).get(0);
console.log(`weight ${(3 - weight[1]).toFixed(3)} m below the nail, cloth ${height.toFixed(4)} m above the ball`);
assert(weight[1] < 1.02 && height > 0.015 && height < 0.03);
