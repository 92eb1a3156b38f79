// How what bends is drawn: cloth as thick as it is for the library, ropes and particles round.
import * as THREE from 'three';

const UP = new THREE.Vector3(0, 1, 0);
const A = new THREE.Vector3(), B = new THREE.Vector3(), MATRIX = new THREE.Matrix4(), TURN = new THREE.Quaternion(), SCALE = new THREE.Vector3();

/** Edges of one triangle only, as [from, to] in its order: where cloth ends. */
function rim(triangles) {
    const edges = new Map();
    for (let i = 0; i < triangles.length; i += 3) {
        for (let k = 0; k < 3; ++k) edges.set(`${triangles[i + k]} ${triangles[i + ((k + 1) % 3)]}`, [triangles[i + k], triangles[i + ((k + 1) % 3)]]);
    }
    return [...edges.values()].filter(([from, to]) => !edges.has(`${to} ${from}`));
}

/** Two faces, half of the particles' radius to both sides of them, and a rim between. */
class Cloth {
    constructor(body, stage, world) {
        this.body = body;
        this.triangles = world.solver.getTriangles(body.id).u32.slice();
        const count = body.positions.length;
        const sides = [...this.triangles];
        for (let i = 0; i < this.triangles.length; i += 3) sides.push(this.triangles[i] + count, this.triangles[i + 2] + count, this.triangles[i + 1] + count);
        for (const [from, to] of rim(this.triangles)) sides.push(from, from + count, to, to, from + count, to + count);
        this.middle = new THREE.BufferGeometry(); // whose normals tell where the faces are
        this.middle.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * count), 3));
        this.middle.setIndex(new THREE.BufferAttribute(this.triangles, 1));
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(6 * count), 3));
        geometry.setAttribute('normal', new THREE.BufferAttribute(new Float32Array(6 * count), 3));
        geometry.setIndex(sides);
        this.mesh = new THREE.Mesh(geometry, new THREE.MeshLambertMaterial({ color: body.colour, side: THREE.DoubleSide }));
        this.mesh.frustumCulled = false;
        stage.add(this.mesh);
    }

    update() {
        const { geometry } = this.mesh, points = this.middle.getAttribute('position');
        points.array.set(this.body.positions.f32);
        this.middle.computeVertexNormals();
        const normals = this.middle.getAttribute('normal').array, half = this.body.radius / 2, count = points.array.length;
        const place = geometry.getAttribute('position'), normal = geometry.getAttribute('normal');
        for (let i = 0; i < count; ++i) {
            place.array[i] = points.array[i] + half * normals[i];
            place.array[count + i] = points.array[i] - half * normals[i];
            normal.array[i] = normals[i];
            normal.array[count + i] = -normals[i];
        }
        place.needsUpdate = normal.needsUpdate = true;
    }
}

/** Copies of one shape, whose places follow the particles. */
class Copies {
    constructor(body, stage, geometry, count) {
        this.body = body;
        this.mesh = new THREE.InstancedMesh(geometry, new THREE.MeshLambertMaterial({ color: body.colour }), count);
        this.mesh.frustumCulled = false;
        stage.add(this.mesh);
    }
}

class Balls extends Copies {
    constructor(body, stage) {
        super(body, stage, new THREE.IcosahedronGeometry(body.radius, 2), body.positions.length);
    }

    update() {
        const at = this.body.positions.f32;
        for (let i = 0; i < this.body.positions.length; ++i) this.mesh.setMatrixAt(i, MATRIX.makeTranslation(at[3 * i], at[3 * i + 1], at[3 * i + 2]));
        this.mesh.instanceMatrix.needsUpdate = true;
    }
}

/** A tube for each link. */
class Rope extends Copies {
    constructor(body, stage) {
        super(body, stage, new THREE.CylinderGeometry(body.radius, body.radius, 1, 8), body.positions.length - 1);
    }

    update() {
        const at = this.body.positions.f32;
        for (let i = 0; i + 1 < this.body.positions.length; ++i) {
            A.fromArray(at, 3 * i);
            B.fromArray(at, 3 * i + 3).sub(A);
            SCALE.set(1, B.length(), 1);
            A.addScaledVector(B, 0.5);
            this.mesh.setMatrixAt(i, MATRIX.compose(A, TURN.setFromUnitVectors(UP, B.normalize()), SCALE));
        }
        this.mesh.instanceMatrix.needsUpdate = true;
    }
}

export const DRAWN = { cloth: Cloth, rope: Rope, balls: Balls };

export function capsuleGeometry({ a, b, radius }) {
    A.fromArray(a);
    B.fromArray(b).sub(A);
    const length = B.length();
    A.addScaledVector(B, 0.5);
    return new THREE.CapsuleGeometry(radius, length, 8, 20).applyMatrix4(MATRIX.compose(A, TURN.setFromUnitVectors(UP, B.normalize()), SCALE.set(1, 1, 1)));
}

/** Room for so many dots. */
export function points(stage, count) {
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(3 * count), 3));
    const dots = new THREE.Points(geometry, new THREE.PointsMaterial({ color: 0xe2541b, size: 2, sizeAttenuation: false }));
    dots.frustumCulled = false;
    stage.add(dots);
    return dots;
}
