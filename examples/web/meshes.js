// The mesh that the world is made of: the bunny, or a file of the user's.
import bunny from 'bunny';
import { Box3, BufferAttribute, BufferGeometry, Vector3 } from 'three';
import { OBJLoader } from 'three/addons/loaders/OBJLoader.js';
import { mergeVertices } from 'three/addons/utils/BufferGeometryUtils.js';

/** One metre high, standing on the origin. */
function placed(geometry) {
    const box = new Box3().setFromBufferAttribute(geometry.getAttribute('position'));
    const size = box.getSize(new Vector3());
    const foot = box.getCenter(new Vector3()).setY(box.min.y);
    geometry.translate(-foot.x, -foot.y, -foot.z);
    geometry.scale(1 / size.y, 1 / size.y, 1 / size.y);
    geometry.computeVertexNormals();
    return geometry;
}

export function bunnyGeometry() {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(Float32Array.from(bunny.positions.flat()), 3));
    geometry.setIndex(bunny.cells.flat());
    return placed(geometry);
}

export function objGeometry(text) {
    const parts = [];
    new OBJLoader().parse(text).traverse((part) => part.isMesh && parts.push(part.geometry.getAttribute('position').array));
    const positions = new Float32Array(parts.reduce((sum, part) => sum + part.length, 0));
    let at = 0;
    for (const part of parts) {
        positions.set(part, at);
        at += part.length;
    }
    if (at === 0) throw new Error('there are no triangles in this file');
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(positions, 3));
    return placed(mergeVertices(geometry));
}
