// A lidar that turns on a vehicle: a million rays a frame, from memory that the library reads in place.
//
// lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
import assert from 'node:assert';
import * as gp from 'gamephys';

const BEAMS = 64, RANGE = 120;
const [frames = 3, columns = 15625] = process.argv.slice(2).map(Number);

// A street: ground, and houses and posts to both sides.
const scene = new gp.Scene();
scene.add(gp.plane([0, 1, 0], 0));
for (let i = 0; i < 40; ++i) {
    const side = 1 - 2 * (i % 2), z = 5 * i - 100;
    scene.add(gp.aabb([14 * side - 5, 0, z], [14 * side + 5, 6, z + 8]));
    scene.add(gp.capsule([7 * side, 0, z], [7 * side, 6, z], 0.15));
}

const count = columns * BEAMS;
const rays = gp.records('ray', count), hits = gp.records('hit', count); // hits are filled again by every frame
const perRay = rays.stride / 4, perHit = hits.stride / 4;
let beam = rays.f32;
for (let i = 0; i < count; ++i) {
    const turn = (Math.floor(i / BEAMS) / columns) * 2 * Math.PI;
    const tilt = -0.43 + (0.46 * (i % BEAMS)) / (BEAMS - 1);
    const direction = [Math.cos(turn) * Math.cos(tilt), Math.sin(tilt), Math.sin(turn) * Math.cos(tilt)];
    beam.set([0, 1.8, 0, ...direction, RANGE], perRay * i);
}
for (let frame = 0; frame < frames; ++frame) {
    beam = rays.f32;
    for (let i = 0; i < count; ++i) beam[perRay * i + 2] = 0.5 * frame; // the vehicle drives on
    const start = performance.now();
    scene.raycastBatch(rays, gp.ALL_LAYERS, hits);
    const time = performance.now() - start;
    const model = hits.u32, hit = hits.f32; // model, tag, t, point, ...
    beam = rays.f32;
    let seen = 0;
    for (let i = 0; i < count; ++i) {
        if (model[perHit * i] === 0) continue;
        ++seen;
        const t = hit[perHit * i + 2], end = beam[perRay * i + 1] + beam[perRay * i + 4] * t;
        if (t > RANGE || Math.abs(end - hit[perHit * i + 4]) > 1e-4) assert.fail(`ray ${i}`);
    }
    console.log(`frame ${frame}: ${count} rays in ${time.toFixed(0)} ms, ${seen} points`);
    assert(seen > count / 2 && seen < count);
}
scene.close();
