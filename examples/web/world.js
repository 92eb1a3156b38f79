// What there is, for the library: objects, bodies that bend, a camera that circles them, and the questions of the
// mouse. Nothing here knows how it is drawn.
import * as gp from 'gamephys';

export const OBJECT_LAYER = 1; // of what is added without a layer
export const BODY_LAYER = 2; // the mouse points through bodies, and takes hold of them

/** Kinds of objects; those of MESH, BALL and BOX have one shape each, a capsule its own. */
export const MESH = 0, BALL = 1, BOX = 2, CAPSULE = 3;
const BALL_SHAPE = { centre: [0, 0.5, 0], radius: 0.5 }, BOX_SHAPE = { low: [-0.4, 0, -0.4], high: [0.4, 0.8, 0.4] };
const UPRIGHT = [0, 0, 0, 1];

export class World {
    /** Objects are numbered from 0; `ids` ascend with the numbers. */
    kinds = [];
    ids = [];
    transforms = []; // of each object: position, quaternion, scale
    sizes = []; // of each object: its scale per axis
    colours = []; // of each object; undefined: that of its kind
    capsules = new Map(); // number to { a, b, radius }
    bodies = []; // { id, kind: 'cloth', 'rope' or 'balls', radius, colour, positions, model }
    owned = []; // what is freed with the world
    moved = new Set(); // numbers of the objects that moved since they were drawn
    hasGround = true;
    reach = 40; // half of the side of the ground as it is drawn, m
    time = 0;

    constructor(positions, indices, build) {
        this.scene = new gp.Scene();
        this.camera = new gp.Camera({ handedness: gp.RIGHT_HANDED, depth_range: gp.DEPTH_MINUS_ONE_TO_ONE });
        this.solver = new gp.Solver({ max_strain: 0.02 }); // as many substeps as that takes
        this.mesh = new gp.Mesh(positions, indices);
        this.owned.push(this.mesh, this.scene, this.camera, this.solver);
        build(this);
        if (this.hasGround) this.scene.add(gp.plane([0, 1, 0], 0));
        this.numbers = new Map(this.ids.map((id, number) => [id, number]));
        this.transforms = Float32Array.from(this.transforms.flat());
        this.move?.(0);
        this.#readBodies();
    }

    setOrigin(origin) {
        for (const object of [this.scene, this.solver, this.camera]) object.setOrigin(origin);
    }

    /** Objects of one kind. The colour may be a function of their number in the list. */
    add(kind, transforms, colour) {
        if (transforms.length === 0) return;
        const shape = [
            () => this.mesh, () => gp.sphere(BALL_SHAPE.centre, BALL_SHAPE.radius), () => gp.aabb(BOX_SHAPE.low, BOX_SHAPE.high),
        ][kind]();
        const ids = this.scene.addBatch(shape, new Float32Array(transforms.flat()));
        transforms.forEach((transform, i) => this.#remember(kind, ids.u32[i], transform, [1, 1, 1], typeof colour === 'function' ? colour(i) : colour));
    }

    addBall([x, y, z], radius, colour) {
        this.add(BALL, [[x, y - radius, z, ...UPRIGHT, 2 * radius]], colour);
    }

    addBox(low, high, colour) {
        const size = high.map((value, k) => (value - low[k]) / 0.8), foot = [(low[0] + high[0]) / 2, low[1], (low[2] + high[2]) / 2];
        this.#remember(BOX, this.scene.add(gp.aabb(low, high)), [...foot, ...UPRIGHT, 1], size, colour);
    }

    addCapsule(a, b, radius, colour) {
        this.capsules.set(this.ids.length, { a, b, radius });
        return this.#remember(CAPSULE, this.scene.add(gp.capsule(a, b, radius)), [0, 0, 0, ...UPRIGHT, 1], [1, 1, 1], colour);
    }

    #remember(kind, id, transform, size, colour) {
        this.kinds.push(kind);
        this.ids.push(id);
        this.transforms.push(transform);
        this.sizes.push(size);
        this.colours.push(colour);
        return this.ids.length - 1;
    }

    /** Move an object there. */
    place(number, position) {
        this.scene.setTransform(this.ids[number], { position, rotation: UPRIGHT, scale: 1 });
        if (this.transforms instanceof Float32Array) this.transforms.set(position, 8 * number);
        this.moved.add(number);
    }

    addCloth(corner, u, v, columns, rows, desc, colour) {
        return this.#keep('cloth', this.solver.addCloth(corner, u, v, columns, rows, desc), columns * rows, desc, colour);
    }

    addRope(points, linkLength, desc, colour) {
        return this.#keep('rope', this.solver.addRope(new Float32Array(points.flat()), linkLength, desc), points.length, desc, colour);
    }

    addBalls(places, desc, colour) {
        return this.#keep('balls', this.solver.addParticles(new Float32Array(places.flat()), desc), places.length, desc, colour);
    }

    #keep(kind, id, count, { radius }, colour) {
        const mesh = gp.Mesh.fromBody(this.solver, id); // follows the body
        const model = this.scene.add(mesh, null, { layers: BODY_LAYER });
        mesh.close(); // the model keeps it
        const positions = gp.records('vec3', count);
        this.owned.push(positions);
        this.bodies.push({ id, kind, radius, colour, positions, model });
        return id;
    }

    #readBodies() {
        for (const { id, positions } of this.bodies) this.solver.getPositions(id, 0, positions.length, positions);
    }

    step(seconds) {
        this.time += seconds;
        this.move?.(this.time);
        this.solver.advance(this.scene, seconds);
        this.#readBodies();
    }

    /** Start to circle: input is in pixels to turn, in metres to zoom and pan. */
    orbit() {
        this.camera.setOrbit({ ...gp.defaultOrbit(), ...this.view, radians_per_unit: 0.005, min_distance: 3, max_distance: 800, min_pitch: 0.03 });
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

    /** Take hold of a body under a pixel, if one is in front there. */
    grab(x, y) {
        const hit = this.camera.pick(this.scene, x, y);
        const body = this.bodies.find(({ model }) => model === hit?.model);
        if (!body) return false;
        const particle = this.solver.getNearestParticle(body.id, hit.triangle, hit.point);
        const depth = this.camera.project(body.positions.get(particle))[2], pinned = this.solver.getPinned(body.id, particle, 1).get(0) !== 0;
        this.held = { body, particle, depth, pinned }; // as it was before
        this.solver.setPinned(body.id, particle, 1, true);
        return true;
    }

    /** Hold it under this pixel, as far away as it was, but above the ground. A world that has replaced another holds nothing. */
    drag(x, y) {
        if (!this.held) return;
        const point = this.camera.unproject([x, y, this.held.depth]);
        point[1] = Math.max(point[1], 0.05);
        this.solver.setPositions(this.held.body.id, this.held.particle, Float32Array.from(point));
    }

    release() {
        if (!this.held) return;
        this.solver.setPinned(this.held.body.id, this.held.particle, 1, this.held.pinned);
        this.held = undefined;
    }

    close() {
        for (const object of this.owned.reverse()) object.close();
    }
}
