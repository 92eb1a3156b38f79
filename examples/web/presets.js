// The presets, the same as in examples/window: eight worlds that show what the library is for. Each builds its objects
// and bodies by the methods of World.
import { BALL, BOX, MESH } from './world.js';
import * as gp from 'gamephys';

const STONE = 0x8e9099, WOOD = 0x8a6238, IVORY = 0xd9ccad, RED = 0xb23a48, ORANGE = 0xe68c26, BLUE = 0x3c6fb4, HEMP = 0xcdb072;
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5)); // a spiral that leaves no gaps (Vogel 1979)
const BUNNIES = 300; // at most: beyond, there are too many triangles to draw

/** The same numbers in each run. */
function uniform(seed) {
    let state = seed;
    return (low, high) => {
        state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
        return low + ((high - low) * (state >>> 8)) / 16777216;
    };
}

/** Colours far apart for successive numbers. */
function hue(number) {
    const part = (shift) => Math.round(255 * (0.56 + 0.3 * Math.cos(GOLDEN_ANGLE * number - shift)));
    return (part(0) << 16) | (part(2 * Math.PI / 3) << 8) | part(4 * Math.PI / 3);
}

const turned = (x, y, z, angle, scale) => [x, y, z, 0, Math.sin(angle / 2), 0, Math.cos(angle / 2), scale];

/** Settings of a square sheet whose cells yield in their plane, as woven cloth does: springs of 30 rad/s a particle. */
const woven = (mass, radius, side) => ({ mass, radius, damping: 0.5, friction: 0.6, shear_compliance: side ** 2 / (mass * 30 ** 2) });

function statues(world, count) {
    world.add(MESH, [[0, 0, 0, 0, 0, 0, 1, 6]]);
    const groups = { [MESH]: [], [BALL]: [], [BOX]: [] };
    for (let i = 0; i < count; ++i) {
        const radius = 1.1 * Math.sqrt(i + 40), angle = GOLDEN_ANGLE * i, turn = 7 * i;
        const kind = [MESH, BALL, BOX][i < BUNNIES ? i % 3 : 1 + (i % 2)];
        groups[kind].push([
            radius * Math.cos(angle), 0, radius * Math.sin(angle), 0, Math.sin(turn), 0, Math.cos(turn), 0.7 + 0.3 * Math.sin(3 * i),
        ]);
    }
    for (const [kind, transforms] of Object.entries(groups)) world.add(Number(kind), transforms);
    world.addCloth([-3.5, 7, -3.5], [7, 0, 0], [0, 0, 7], 36, 36, { ...woven(4, 0.05, 36), bend_compliance: 0.1 }, RED);
    world.reach = 2.2 * Math.sqrt(count + 40);
    world.view = { target: [0, 2.5, 0], distance: 20, yaw: 0.5, pitch: 0.4 };
}

function clothOnAnything(world) {
    world.addBall([-3.6, 1, 0], 1, STONE);
    world.addBox([-2, 0, -0.8], [-0.4, 1.6, 0.8], STONE);
    world.addCapsule([0.9, 0.6, -0.7], [2.1, 1.4, 0.7], 0.5, STONE);
    world.add(MESH, [turned(4, 0, 0, 0.6, 2)], IVORY);
    for (let i = 0; i < 4; ++i) {
        world.addCloth([-4.6 + 2.4 * i, 2.4, -1], [2, 0, 0], [0, 0, 2], 28, 28, woven(1, 0.03, 28), hue(i + 1));
    }
    world.view = { target: [0, 0.8, 0], distance: 10, yaw: 0.6, pitch: 0.35 };
}

function ropeBridge(world) {
    const columns = 72, rows = 10;
    world.addBox([-7, 0, -2], [-4, 2.5, 2], STONE);
    world.addBox([4, 0, -2], [7, 2.5, 2], STONE);
    // Heavy and damped, so that the balls do not leap.
    const deck = world.addCloth([-4.1, 2.56, -0.6], [8.2, 0, 0], [0, 0, 1.2], columns, rows,
        { mass: 120, radius: 0.05, damping: 2, cloth_flags: gp.CLOTH_BEND, body_layers: 1 }, WOOD);
    for (let row = 0; row < rows; ++row) {
        world.solver.setPinned(deck, row * columns, 1, true);
        world.solver.setPinned(deck, row * columns + columns - 1, 1, true);
    }
    for (const side of [-1, 1]) {
        const z = 0.62 * side;
        for (const x of [-4.15, 4.15]) world.addCapsule([x, 2.5, z], [x, 3.5, z], 0.07, WOOD);
        const points = Array.from({ length: 33 }, (_, i) => [-4.15 + (8.3 * i) / 32, 3.55, z]);
        const rope = world.addRope(points, (1.01 * 8.3) / 32, { mass: 2, radius: 0.03, damping: 0.3 }, HEMP);
        for (const end of [0, 32]) world.solver.setPinned(rope, end, 1, true);
        for (let i = 2; i < 31; i += 2) { // strings hold the deck below the rope
            const column = Math.floor((i * (columns - 1)) / 32), row = side < 0 ? 0 : rows - 1;
            world.solver.join(rope, i, deck, row * columns + column, -1, 1e-4);
        }
    }
    const balls = Array.from({ length: 6 }, (_, i) => [-1.8 + 0.72 * i, 3.6 + 0.5 * i, 0.05 * (i % 3)]);
    world.addBalls(balls, { mass: 24, radius: 0.3, damping: 0.3, body_layers: 1, self_collision: 1 }, BLUE);
    world.view = { target: [0, 2, 0], distance: 11, yaw: 0.6, pitch: 0.35 };
}

function curtainAndWalker(world) {
    const columns = 32, rows = 44;
    world.addCapsule([-2.3, 3, 0], [2.3, 3, 0], 0.06, WOOD);
    for (const x of [-2.2, 0.03]) {
        const cloth = world.addCloth([x, 2.9, 0], [2.17, 0, 0], [0, -2.75, 0], columns, rows,
            { mass: 3, radius: 0.02, damping: 0.3, cloth_flags: gp.CLOTH_BEND }, RED);
        for (let i = 0; i < columns; i += 2) world.solver.setPinned(cloth, i, 1, true);
    }
    const walker = world.addCapsule([0, 0.35, 0], [0, 1.45, 0], 0.35, ORANGE);
    world.move = (time) => world.place(walker, [1.1 * Math.sin(0.45 * time), 0, 2.2 * Math.cos(0.9 * time)]);
    world.view = { target: [0, 1.5, 0], distance: 8, yaw: 2.4, pitch: 0.35 };
}

function ballPit(world) {
    const a = 1.7, b = 1.9, high = 1.3, side = 12;
    for (const [low, top] of [[[-b, 0, -b], [-a, high, b]], [[a, 0, -b], [b, high, b]], [[-a, 0, -b], [a, high, -a]], [[-a, 0, a], [a, high, b]]]) {
        world.addBox(low, top, WOOD);
    }
    const random = uniform(3);
    for (let c = 0; c < 5; ++c) { // a body has one colour
        const places = [];
        for (let i = c; i < side * side * 10; i += 5) {
            places.push([
                0.25 * ((i % side) - 0.5 * (side - 1)) + random(-0.02, 0.02), 1.5 + 0.25 * Math.floor(i / side / side),
                0.25 * ((Math.floor(i / side) % side) - 0.5 * (side - 1)) + random(-0.02, 0.02),
            ]);
        }
        world.addBalls(places, {
            mass: 0.1 * places.length, radius: 0.11, damping: 0.3, self_collision: 1, body_layers: 1, restitution: 0.3, friction: 0.2,
        }, hue(c + 3));
    }
    world.view = { target: [0, 0.8, 0], distance: 8, yaw: 0.6, pitch: 0.35 };
}

/** A sensor above a walker's head scans its surroundings in rings and ignores the walker. */
function lidarSweep(world) {
    const random = uniform(11), rings = 48, columns = 360;
    for (let i = 0; i < 400; ++i) {
        const x = random(-40, 40), z = random(-40, 40);
        if (x * x + z * z < 36) continue;
        const w = random(0.6, 2), d = random(0.6, 2), h = random(0.5, 5);
        world.addBox([x - w, 0, z - d], [x + w, h, z + d], STONE);
    }
    for (let i = 0; i < 20; ++i) {
        const angle = (Math.PI / 10) * i;
        world.add(MESH, [turned(9 * Math.cos(angle), 0, 9 * Math.sin(angle), -angle, 2)], hue(i));
    }
    const walker = world.addCapsule([0, 0.3, 0], [0, 1.3, 0], 0.3, ORANGE);
    const rays = gp.records('ray', rings * columns), hits = gp.records('hit', rings * columns);
    const filter = { ignored_model: world.ids[walker] };
    world.owned.push(rays, hits);
    world.move = (time) => {
        const x = 3 * Math.cos(0.4 * time), z = 3 * Math.sin(0.4 * time), numbers = rays.f32;
        world.place(walker, [x, 0, z]);
        for (let i = 0; i < rings * columns; ++i) {
            const pitch = -0.44 + (0.53 * Math.floor(i / columns)) / (rings - 1), yaw = (2 * Math.PI * (i % columns)) / columns;
            numbers.set([x, 1.9, z, Math.cos(pitch) * Math.cos(yaw), Math.sin(pitch), Math.cos(pitch) * Math.sin(yaw), 60], 7 * i);
        }
        world.scene.raycastFilteredBatch(rays, filter, hits);
    };
    world.scan = hits;
    world.reach = 120;
    world.view = { target: [0, 0.8, 0], distance: 30, yaw: 0.6, pitch: 0.6 };
}

function manyBoxes(world) {
    const random = uniform(5), places = [];
    for (let i = 0; i < 100000; ++i) {
        // A direction of even density, and a distance that fills a ball with a hole.
        const y = random(-1, 1), angle = random(0, 2 * Math.PI), r = Math.sqrt(1 - y * y), far = 30 + 70 * Math.cbrt(random(0, 1));
        const turn = random(0, Math.PI), s = Math.sin(turn);
        places.push([far * r * Math.cos(angle), far * y, far * r * Math.sin(angle), 0.6 * s, 0.8 * s, 0, Math.cos(turn), random(0.3, 1.5)]);
    }
    world.add(BOX, places, hue);
    world.hasGround = false;
    world.view = { target: [0, 0, 0], distance: 12, yaw: 0.6, pitch: 0.35 };
}

/** Ten thousand kilometres from the origin of the world a float's step is a metre; none of that is seen. */
function farFromTheOrigin(world) {
    world.setOrigin([1e7, 0, -1e7]);
    clothOnAnything(world);
}

export const PRESETS = {
    'statues': statues, 'cloth on anything': clothOnAnything, 'rope bridge': ropeBridge, 'curtain and walker': curtainAndWalker,
    'ball pit': ballPit, 'lidar sweep': lidarSweep, '100 000 boxes': manyBoxes, 'far from the origin': farFromTheOrigin,
};
