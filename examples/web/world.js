// What there is, for the library: a statue with a cloth over it and many objects around, a camera that
// circles them, and the questions of the mouse. Nothing here knows how it is drawn.
import * as gp from 'gamephys';

const STATUE_HEIGHT = 6;
const CLOTH = { size: 7, particles: 36, height: 7 };
const GOLDEN_ANGLE = Math.PI * (3 - Math.sqrt(5)); // a spiral that leaves no gaps (Vogel 1979)
const BUNNIES = 300; // at most: beyond, there are too many triangles to draw

const OBJECT_LAYER = 1; // of what is added without a layer
const CLOTH_LAYER = 2; // the mouse points through it, and takes hold of it

export const KINDS = ['mesh', 'ball', 'box'];

export class World {
    constructor(positions, indices, count) {
        this.scene = new gp.Scene({ reserve_models: count + 2 });
        this.camera = new gp.Camera({ handedness: gp.RIGHT_HANDED, depth_range: gp.DEPTH_MINUS_ONE_TO_ONE });
        this.solver = new gp.Solver();
        this.#place(positions, indices, count);
        this.#hang();
    }

    /** Objects are numbered from 0, the statue; `ids` ascend with the numbers. */
    #place(positions, indices, count) {
        this.ground = this.scene.add(gp.plane([0, 1, 0], 0));
        const mesh = new gp.Mesh(positions, indices);
        const shapes = { mesh, ball: gp.sphere([0, 0.5, 0], 0.5), box: gp.aabb([-0.4, 0, -0.4], [0.4, 0.8, 0.4]) };
        const groups = KINDS.map((kind) => ({ kind, transforms: [] }));
        groups[0].transforms.push([0, 0, 0, 0, 0, 0, 1, STATUE_HEIGHT]);
        for (let i = 0; i < count; ++i) {
            const radius = 1.1 * Math.sqrt(i + 40), angle = GOLDEN_ANGLE * i, turn = 7 * i;
            const kind = i < BUNNIES ? i % 3 : 1 + (i % 2);
            groups[kind].transforms.push([
                radius * Math.cos(angle), 0, radius * Math.sin(angle), 0, Math.sin(turn), 0, Math.cos(turn), 0.7 + 0.3 * Math.sin(3 * i),
            ]);
        }
        this.kinds = []; // of each object, an index into KINDS
        const ids = [];
        this.transforms = new Float32Array(groups.flatMap((group) => group.transforms).flat());
        for (const [kind, { transforms }] of groups.entries()) {
            if (transforms.length === 0) continue;
            const models = this.scene.addBatch(shapes[KINDS[kind]], new Float32Array(transforms.flat()));
            ids.push(...Array.from(models.u32));
            for (const _ of transforms) this.kinds.push(kind);
        }
        this.ids = Uint32Array.from(ids);
        this.numbers = new Map(ids.map((id, number) => [id, number]));
        mesh.close(); // the models keep it
    }

    #hang() {
        const { size, particles, height } = CLOTH;
        this.cloth = this.solver.addCloth([-size / 2, height, -size / 2], [size, 0, 0], [0, 0, size], particles, particles,
            {
                mass: 4, damping: 0.5, radius: 0.05, friction: 0.6, bend_compliance: 0.1,
                // Woven: cells yield in their plane. Springs of 30 rad/s a particle.
                shear_compliance: particles ** 2 / (4 * 30 ** 2),
            });
        this.clothTriangles = this.solver.getTriangles(this.cloth).u32;
        this.clothPositions = gp.records('vec3', particles * particles);
        const mesh = gp.Mesh.fromBody(this.solver, this.cloth); // follows the cloth
        this.clothModel = this.scene.add(mesh, null, { layers: CLOTH_LAYER });
        mesh.close();
        this.#readCloth();
    }

    #readCloth() {
        this.solver.getPositions(this.cloth, 0, this.clothPositions.length, this.clothPositions);
    }

    step(seconds) {
        this.solver.advance(this.scene, seconds);
        this.#readCloth();
    }

    get contacts() {
        return this.solver.getStats(0).contact_count;
    }

    /** Start to circle the statue: input is in pixels to turn, in metres to zoom and pan. */
    orbit() {
        this.camera.setOrbit({
            ...gp.defaultOrbit(), target: [0, 2.5, 0], distance: 20, yaw: 0.5, pitch: 0.4,
            radians_per_unit: 0.005, min_distance: 3, max_distance: 800, min_pitch: 0.03,
        });
    }

    /** Numbers of the objects that may be in view, ascending. */
    visible() {
        const found = this.camera.cull(this.scene).u32;
        const numbers = new Uint32Array(found.length);
        let count = 0, number = 0;
        for (const id of found) {
            while (number < this.ids.length && this.ids[number] < id) ++number;
            if (this.ids[number] === id) numbers[count++] = number;
        }
        return numbers.subarray(0, count);
    }

    /** The object under a pixel: { number, hit }, number undefined on the ground; null where there is nothing. */
    pick(x, y) {
        const hit = this.camera.pick(this.scene, x, y, OBJECT_LAYER);
        return hit && { number: this.numbers.get(hit.model), hit };
    }

    /** Numbers of the objects that show in a rectangle. */
    pickRectangle(x0, y0, x1, y1) {
        const numbers = [];
        for (const id of this.camera.pickRectangle(this.scene, x0, y0, x1, y1).u32) {
            const number = this.numbers.get(id);
            if (number !== undefined) numbers.push(number);
        }
        return numbers;
    }

    /** Take hold of the cloth under a pixel, if it is in front there. */
    grab(x, y) {
        const hit = this.camera.pick(this.scene, x, y);
        if (hit?.model !== this.clothModel) return false;
        this.held = this.solver.getNearestParticle(this.cloth, hit.triangle, hit.point);
        this.heldDepth = this.camera.project(this.clothPositions.get(this.held))[2];
        this.solver.setPinned(this.cloth, this.held, 1, true);
        return true;
    }

    /** Hold it under this pixel, as far away as it was, but above the ground. */
    drag(x, y) {
        const point = this.camera.unproject([x, y, this.heldDepth]);
        point[1] = Math.max(point[1], 0.05);
        this.solver.setPositions(this.cloth, this.held, Float32Array.from(point));
    }

    release() {
        this.solver.setPinned(this.cloth, this.held, 1, false);
        this.held = undefined;
    }

    close() {
        for (const object of [this.scene, this.camera, this.solver, this.clothPositions]) object.close();
    }
}
