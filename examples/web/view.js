// Draws the world with three.js: one instanced mesh for each kind, with what is in view only.
import * as THREE from 'three';
import { KINDS } from './world.js';

const COLOURS = [0xc9b79c, 0x9fb8a8, 0xa9aec4].map((colour) => new THREE.Color(colour));
const HOVERED = new THREE.Color(0xff8a1f);
const SELECTED = new THREE.Color(0x2f6fe4);

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

        const reach = 2 * 1.1 * Math.sqrt(world.ids.length + 40);
        const ground = new THREE.Mesh(new THREE.PlaneGeometry(2 * reach, 2 * reach).rotateX(-Math.PI / 2),
            new THREE.MeshLambertMaterial({ color: 0xcdd5cf, polygonOffset: true, polygonOffsetFactor: 1, polygonOffsetUnits: 1 }));
        this.stage.add(ground);

        const round = world.ids.length > 5000 ? 1 : 3; // subdivisions
        const geometries = [geometry, new THREE.IcosahedronGeometry(0.5, round).translate(0, 0.5, 0), new THREE.BoxGeometry(0.8, 0.8, 0.8).translate(0, 0.4, 0)];
        this.matrices = new Float32Array(16 * world.ids.length);
        const matrix = new THREE.Matrix4(), position = new THREE.Vector3(), turn = new THREE.Quaternion(), scale = new THREE.Vector3();
        for (let i = 0; i < world.ids.length; ++i) {
            const row = world.transforms.subarray(8 * i, 8 * i + 8);
            matrix.compose(position.fromArray(row), turn.fromArray(row, 3), scale.setScalar(row[7])).toArray(this.matrices, 16 * i);
        }
        this.instances = KINDS.map((_, kind) => {
            const count = world.kinds.reduce((sum, k) => sum + (k === kind), 0);
            const mesh = new THREE.InstancedMesh(geometries[kind], new THREE.MeshLambertMaterial(), Math.max(1, count));
            mesh.instanceColor = new THREE.InstancedBufferAttribute(new Float32Array(3 * Math.max(1, count)), 3);
            mesh.frustumCulled = false; // the library has culled
            this.stage.add(mesh);
            return mesh;
        });

        const cloth = new THREE.BufferGeometry();
        cloth.setAttribute('position', new THREE.BufferAttribute(Float32Array.from(world.clothPositions.f32), 3));
        cloth.setIndex(new THREE.BufferAttribute(world.clothTriangles, 1));
        this.cloth = new THREE.Mesh(cloth, new THREE.MeshLambertMaterial({ color: 0xb23a48, side: THREE.DoubleSide }));
        this.cloth.frustumCulled = false;
        this.stage.add(this.cloth);
        this.octree = undefined;
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
        for (const mesh of instances) mesh.count = 0;
        for (const number of visible) {
            const kind = world.kinds[number], mesh = instances[kind], at = mesh.count++;
            mesh.instanceMatrix.array.set(this.matrices.subarray(16 * number, 16 * number + 16), 16 * at);
            const colour = number === hovered ? HOVERED : selected.has(number) ? SELECTED : COLOURS[kind];
            colour.toArray(mesh.instanceColor.array, 3 * at);
        }
        for (const mesh of instances) mesh.instanceMatrix.needsUpdate = mesh.instanceColor.needsUpdate = true;

        const positions = this.cloth.geometry.getAttribute('position');
        positions.array.set(world.clothPositions.f32);
        positions.needsUpdate = true;
        this.cloth.geometry.computeVertexNormals();

        this.camera.matrixWorld.fromArray(world.camera.getWorldMatrix());
        this.camera.matrix.copy(this.camera.matrixWorld);
        this.camera.matrixWorldInverse.copy(this.camera.matrixWorld).invert();
        this.camera.projectionMatrix.fromArray(world.camera.getProjectionMatrix());
        this.camera.projectionMatrixInverse.copy(this.camera.projectionMatrix).invert();
        this.renderer.render(this.scene, this.camera);
    }
}
