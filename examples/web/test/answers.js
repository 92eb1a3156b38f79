// Answers to the page's questions found the plain way, in double precision and without the library:
// every object is looked at, by textbook formulas.

const add = (a, b, s = 1) => a.map((x, i) => x + s * b[i]);
export const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const scaled = (a, s) => a.map((x) => x * s);

/** A camera that looks at a target from a distance; yaw 0 looks along +z, in right-handed axes. */
export function cameraAt({ target, distance, yaw, pitch }, { fieldOfView, near, width, height }) {
    const forward = [-Math.sin(yaw) * Math.cos(pitch), -Math.sin(pitch), Math.cos(yaw) * Math.cos(pitch)];
    const level = cross(forward, [0, 1, 0]);
    const right = scaled(level, 1 / Math.hypot(...level));
    const tangent = Math.tan(fieldOfView / 2);
    return { eye: add(target, forward, -distance), forward, right, up: cross(right, forward), tangent, near, width, height };
}

/** From the near plane on, where sight begins. */
export function rayThrough(camera, x, y) {
    const across = ((2 * x) / camera.width - 1) * camera.tangent * (camera.width / camera.height);
    const upward = (1 - (2 * y) / camera.height) * camera.tangent;
    const direction = add(add(camera.forward, camera.right, across), camera.up, upward);
    return { origin: add(camera.eye, direction, camera.near), direction: scaled(direction, 1 / Math.hypot(...direction)) };
}

export function project(camera, point) {
    const offset = add(point, camera.eye, -1);
    const depth = dot(offset, camera.forward);
    const across = dot(offset, camera.right) / (depth * camera.tangent * (camera.width / camera.height));
    const upward = dot(offset, camera.up) / (depth * camera.tangent);
    return { x: ((across + 1) * camera.width) / 2, y: ((1 - upward) * camera.height) / 2, depth };
}

/** Turned about +y by the angle of a quaternion (0, sin, 0, cos), forth (1) or back (-1). */
function turned([x, y, z], sine, cosine, sense) {
    const s = sense * 2 * sine * cosine, c = cosine * cosine - sine * sine;
    return [c * x + s * z, y, c * z - s * x];
}

const LOW = [-0.4, 0, -0.4], HIGH = [0.4, 0.8, 0.4];

/** t of the first hit in the object's own coordinates, or Infinity. */
function hitBall({ origin, direction }) {
    const offset = add(origin, [0, 0.5, 0], -1);
    const a = dot(direction, direction), b = dot(offset, direction), c = dot(offset, offset) - 0.25;
    const root = b * b - a * c;
    return root < 0 || b > 0 ? Infinity : (-b - Math.sqrt(root)) / a;
}
function hitBox({ origin, direction }) {
    let enter = 0, leave = Infinity;
    for (let k = 0; k < 3; ++k) {
        const a = (LOW[k] - origin[k]) / direction[k], b = (HIGH[k] - origin[k]) / direction[k];
        enter = Math.max(enter, Math.min(a, b));
        leave = Math.min(leave, Math.max(a, b));
    }
    return enter <= leave ? enter : Infinity;
}
function hitMesh({ origin, direction }, { positions, indices }) { // Moeller and Trumbore 1997
    let first = Infinity;
    const corner = (i) => [positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]];
    for (let i = 0; i < indices.length; i += 3) {
        const a = corner(indices[i]), ab = add(corner(indices[i + 1]), a, -1), ac = add(corner(indices[i + 2]), a, -1);
        const p = cross(direction, ac), determinant = dot(ab, p);
        const offset = add(origin, a, -1), q = cross(offset, ab);
        const u = dot(offset, p) / determinant, v = dot(direction, q) / determinant, t = dot(ac, q) / determinant;
        if (u >= 0 && v >= 0 && u + v <= 1 && t >= 0 && t < first) first = t;
    }
    return first;
}

/** What a ray meets first, up to t = end: { number, t }; number undefined for the ground, -1 for nothing. */
export function pick(world, ray, end = Infinity) {
    let best = { number: -1, t: end };
    const ground = ray.direction[1] < 0 ? -ray.origin[1] / ray.direction[1] : Infinity;
    if (ground <= end) best = { number: undefined, t: ground };
    world.kinds.forEach((kind, number) => {
        const row = world.transforms.slice(8 * number, 8 * number + 8), position = row.slice(0, 3), scale = row[7];
        const length = Math.hypot(row[4], row[6]), sine = row[4] / length, cosine = row[6] / length;
        const own = {
            origin: scaled(turned(add(ray.origin, position, -1), sine, cosine, -1), 1 / scale),
            direction: scaled(turned(ray.direction, sine, cosine, -1), 1 / scale),
        };
        // All meshes are within 2 of their feet; the rest of the work is for those that may be met.
        const near = Math.hypot(...add(own.origin, own.direction, -dot(own.origin, own.direction) / dot(own.direction, own.direction)));
        if (near > 2) return;
        const t = [hitMesh, hitBall, hitBox][kind](own, world);
        if (t < best.t) best = { number, t };
    });
    return best;
}

/** Points of an object's surface, in the world: enough to say that all are on one side of a plane. */
function hull(world, number) {
    const row = world.transforms.slice(8 * number, 8 * number + 8), kind = world.kinds[number];
    let points = [];
    if (kind === 0) for (let i = 0; i < world.positions.length; i += 3) points.push(world.positions.slice(i, i + 3));
    else for (let i = 0; i < 8; ++i) {
        const bits = [i & 1, i & 2, i & 4];
        points.push(kind === 2 ? bits.map((bit, k) => (bit ? HIGH[k] : LOW[k])) : bits.map((bit, k) => (bit ? 0.5 : -0.5) + (k === 1 ? 0.5 : 0)));
    }
    return points.map((point) => add(row.slice(0, 3), scaled(turned(point, row[4], row[6], 1), row[7])));
}

/** Each object against a rectangle of pixels: true if a point of it shows inside, false if all of it is
 *  beyond one side, undefined where this plain test does not tell. */
export function inRectangle(world, camera, x0, y0, x1, y1) {
    return world.kinds.map((kind, number) => {
        const row = world.transforms.slice(8 * number, 8 * number + 8);
        const images = hull(world, number).map((point) => project(camera, point));
        const inside = ({ x, y, depth }) => depth > 0 && x > x0 && x < x1 && y > y0 && y < y1;
        const centre = project(camera, add(row.slice(0, 3), [0, 0.5 * row[7], 0]));
        if (kind === 1 ? inside(centre) : images.some(inside)) return true;
        const sides = [({ x }) => x < x0, ({ x }) => x > x1, ({ y }) => y < y0, ({ y }) => y > y1];
        // Behind the camera images are reversed; such an object is told by its depth.
        if (images.every(({ depth }) => depth < 0)) return false;
        if (images.every(({ depth }) => depth > 0) && sides.some((beyond) => images.every(beyond))) return false;
        return undefined;
    });
}
