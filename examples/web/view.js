// Draws the world with three.js: one instanced mesh for each kind, with what is in view only.
import * as THREE from 'three';
import { CAPSULE } from './world.js';
import { capsuleGeometry, DRAWN, points } from './bodies.js';

const COLOURS = [0xc9b79c, 0x9fb8a8, 0xa9aec4, 0xa9aec4].map((colour) => new THREE.Color(colour));
const HOVERED = new THREE.Color(0xff8a1f);
const SELECTED = new THREE.Color(0x2f6fe4);
const MATRIX = new THREE.Matrix4(), POSITION = new THREE.Vector3(), TURN = new THREE.Quaternion(), SCALE = new THREE.Vector3();

export class View {
    constructor(canvas) {
        this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true });
        this.camera = new THREE.Camera(); // its matrices are those of the world's camera
        this.camera.matrixAutoUpdate = false;
        this.scene = new THREE.Scene();
        this.scene.background = new THREE.Color(0xdfe6ec);
        this.scene.add(new THREE.HemisphereLight(0xffffff, 0x8a8f80, 2));
        const sun = new THREE.DirectionalLight(0xffffff, 2);
        sun.position.set(3, 8, 5);
        this.scene.add(sun, this.camera);
    }

    /** Show another world; geometry is that of its mesh. */
    show(world, geometry) {
        this.stage?.removeFromParent();
        this.stage?.traverse((part) => part.geometry?.dispose());
        this.world = world;
        this.stage = new THREE.Group();
        this.scene.add(this.stage);
        this.octree = undefined;

        const ground = new THREE.Mesh(new THREE.PlaneGeometry(4 * world.reach, 4 * world.reach).rotateX(-Math.PI / 2),
            new THREE.MeshLambertMaterial({ color: 0xcdd5cf, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
        ground.visible = world.hasGround;
        this.stage.add(ground);
        this.#showObjects(geometry);
        this.bodies = world.bodies.map((body) => new DRAWN[body.kind](body, this.stage, world));
        if (world.scan) this.scan = points(this.stage, world.scan.length);
    }

    /** An instanced mesh for each kind of object, and one for each capsule. */
    #showObjects(geometry) {
        const { world } = this, count = world.ids.length;
        const round = count > 5000 ? 1 : 3; // subdivisions
        const geometries = [geometry, new THREE.IcosahedronGeometry(0.5, round).translate(0, 0.5, 0), new THREE.BoxGeometry(0.8, 0.8, 0.8).translate(0, 0.4, 0)];
        this.instanceOf = Uint8Array.from(world.kinds, (kind, number) =>
            kind === CAPSULE ? geometries.push(capsuleGeometry(world.capsules.get(number))) - 1 : kind);
        this.colours = world.colours.map((colour, number) => (colour === undefined ? COLOURS[world.kinds[number]] : new THREE.Color(colour)));
        this.matrices = new Float32Array(16 * count);
        for (let number = 0; number < count; ++number) this.#place(number);
        const counts = new Uint32Array(geometries.length);
        for (const instance of this.instanceOf) ++counts[instance];
        this.instances = geometries.map((shape, i) => {
            const room = Math.max(1, counts[i]);
            const mesh = new THREE.InstancedMesh(shape, new THREE.MeshLambertMaterial(), room);
            mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * room), 3);
            mesh.frustumCulled = false; // the library has culled
            this.stage.add(mesh);
            return mesh;
        });
    }

    /** Put an object's matrix where the world has it. */
    #place(number) {
        const row = this.world.transforms.subarray(8 * number, 8 * number + 8);
        SCALE.fromArray(this.world.sizes[number]).multiplyScalar(row[7]);
        MATRIX.compose(POSITION.fromArray(row), TURN.fromArray(row, 3), SCALE).toArray(this.matrices, 16 * number);
    }

    /** Lines along the boxes of the scene's octree, or none. */
    showOctree(shown) {
        this.octree?.removeFromParent();
        this.octree?.geometry.dispose();
        this.octree = undefined;
        if (!shown) return;
        const boxes = this.world.scene.getOctreeBoxes();
        const numbers = boxes.stride / 4;
        const lines = new Float32Array(72 * boxes.length);
        let at = 0;
        for (let b = 0; b < boxes.length; ++b) {
            const low = boxes.f32.subarray(numbers * b, numbers * b + 3), high = boxes.f32.subarray(numbers * b + 3, numbers * b + 6);
            for (let axis = 0; axis < 3; ++axis) {
                for (const [p, q] of [[low, low], [low, high], [high, low], [high, high]]) {
                    for (const end of [low, high]) {
                        lines[at + axis] = end[axis];
                        lines[at + ((axis + 1) % 3)] = p[(axis + 1) % 3];
                        lines[at + ((axis + 2) % 3)] = q[(axis + 2) % 3];
                        at += 3;
                    }
                }
            }
        }
        const geometry = new THREE.BufferGeometry();
        geometry.setAttribute('position', new THREE.BufferAttribute(lines, 3));
        this.octree = new THREE.LineSegments(geometry, new THREE.LineBasicMaterial({ color: 0x1b7f5c, transparent: true, opacity: 0.45 }));
        this.octree.frustumCulled = false;
        this.octree.boxes = boxes.length;
        this.stage.add(this.octree);
    }

    draw(visible, hovered, selected) {
        const { world, instances } = this;
        for (const number of world.moved) this.#place(number);
        world.moved.clear();
        for (const mesh of instances) mesh.count = 0;
        for (const number of visible) {
            const mesh = instances[this.instanceOf[number]], at = mesh.count++;
            mesh.instanceMatrix.array.set(this.matrices.subarray(16 * number, 16 * number + 16), 16 * at);
            const colour = number === hovered ? HOVERED : selected.has(number) ? SELECTED : this.colours[number];
            colour.toArray(mesh.instanceColor.array, 3 * at);
        }
        for (const mesh of instances) mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;
        for (const body of this.bodies) body.update();
        if (world.scan) this.#showScan();

        this.camera.matrixWorld.fromArray(world.camera.getWorldMatrix());
        this.camera.matrix.copy(this.camera.matrixWorld);
        this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert();
        this.camera.projectionMatrix.fromArray(world.camera.getProjectionMatrix());
        this.camera.projectionMatrixInverse.copy(this.camera.projectionMatrix).invert();
        this.renderer.render(this.scene, this.camera);
    }

    /** A dot at each hit of the world's scan. */
    #showScan() {
        const { f32, u32, length, stride } = this.world.scan, attribute = this.scan.geometry.getAttribute('position');
        let count = 0;
        for (let i = 0, at = 0; i < length; ++i, at += stride / 4) {
            if (u32[at] !== 0) attribute.array.set(f32.subarray(at + 3, at + 6), 3 * count++); // model, and the point
        }
        this.scan.geometry.setDrawRange(0, count);
        attribute.needsUpdate = true;
    }
}
