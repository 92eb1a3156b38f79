// What a camera sees: culling, picking, marquee, orbit.
import assert from 'node:assert';
import * as gp from 'gamephys';

const scene = new gp.Scene();
const spheres = new Float32Array([-4, 0, 9, 1.5, 0, 0, 9, 1.5, 4, 0, 9, 1.5, 0, 0, -50, 2]);
const balls = scene.addBatch(gp.shapes('sphere', spheres)).u32;
const camera = new gp.Camera({ viewport_width: 640, viewport_height: 320 });
camera.setPerspective(0.7, 0.1, 100);
camera.setOrbit({ ...gp.defaultOrbit(), target: [0, 0, 9], distance: 8, radians_per_unit: 0.01 });
assert.strictEqual(camera.cull(scene).length, 3);
const [x, y] = camera.project([-4, 0, 9]);
assert.strictEqual(camera.pick(scene, x, y).model, balls[0]);
assert.strictEqual(camera.pickRectangle(scene, 340, 0, 640, 320).length, 2);
camera.orbitRotate(157.0796, 0);
camera.orbitUpdate();
const behind = scene.raycastAll(camera.pickRay(320, 160));
console.log(`after a quarter turn ${behind.length} balls stand behind one another`);
assert.strictEqual(behind.length, 3);
assert.strictEqual(behind.get(1).model, balls[1]);
