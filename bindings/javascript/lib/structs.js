// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
import { bits, flag, real, signed, whole } from './numbers.js';

function named(value, name) {
    if (typeof value !== 'object') throw new TypeError(`expected a ${name}, got ${value}`);
}

/** Refuses a field that is misspelt where those that are missing have a meaning. */
function only(value, fields, name) {
    for (const field in value) if (!fields.includes(field)) throw new TypeError(`${name} has no field ${field}`);
}

/** Whether the fields are given in order, as an array, and not by name. */
function row(value, count, name) {
    if (typeof value !== 'object' || value === null) throw new TypeError(`expected a ${name}, got ${value}`);
    if (value.length === undefined) return false;
    if (value.length !== count) throw new TypeError(`${name}: expected ${count} fields, got ${value.length}`);
    return true;
}

// v: views of memory, at: where in it, counted in numbers of four bytes

export const readVec3 = (v, at) => [v.f32[at], v.f32[at + 1], v.f32[at + 2]];
export function writeVec3(v, at, value) {
    const rows = row(value, 3, 'vec3');
    v.f32[at] = real(rows ? value[0] : value.x, 'x');
    v.f32[at + 1] = real(rows ? value[1] : value.y, 'y');
    v.f32[at + 2] = real(rows ? value[2] : value.z, 'z');
}
export const readQuat = (v, at) => [v.f32[at], v.f32[at + 1], v.f32[at + 2], v.f32[at + 3]];
export function writeQuat(v, at, value) {
    const rows = row(value, 4, 'quat');
    v.f32[at] = real(rows ? value[0] : value.x, 'x');
    v.f32[at + 1] = real(rows ? value[1] : value.y, 'y');
    v.f32[at + 2] = real(rows ? value[2] : value.z, 'z');
    v.f32[at + 3] = real(rows ? value[3] : value.w, 'w');
}
export const readMat4 = (v, at) => Array.from(v.f32.subarray(at, at + 16));
export function writeMat4(v, at, value) {
    const m = row(value, 16, 'mat4') ? value : value.m ?? value.elements;
    for (let i = 0; i < 16; ++i) v.f32[at + i] = real(m[i], 'm');
}
export const readTransform = (v, at) => ({ position: readVec3(v, at), rotation: readQuat(v, at + 3), scale: v.f32[at + 7] });
export function writeTransform(v, at, value) {
    const rows = row(value, 3, 'transform');
    if (!rows && (value.position === undefined || value.rotation === undefined || value.scale === undefined)) only(value, ['position', 'rotation', 'scale'], 'transform');
    writeVec3(v, at, rows ? value[0] : value.position ?? [0, 0, 0]);
    writeQuat(v, at + 3, rows ? value[1] : value.rotation ?? [0, 0, 0, 1]);
    v.f32[at + 7] = real(rows ? value[2] : value.scale ?? 1, 'scale');
}
export const readRay = (v, at) => ({ origin: readVec3(v, at), direction: readVec3(v, at + 3), t_max: v.f32[at + 6] });
export function writeRay(v, at, value) {
    const rows = row(value, 3, 'ray');
    if (!rows && (value.t_max === undefined)) only(value, ['origin', 'direction', 't_max'], 'ray');
    writeVec3(v, at, rows ? value[0] : value.origin);
    writeVec3(v, at + 3, rows ? value[1] : value.direction);
    v.f32[at + 6] = real(rows ? value[2] : value.t_max ?? Infinity, 't_max');
}
export const readSegment = (v, at) => ({ a: readVec3(v, at), b: readVec3(v, at + 3) });
export function writeSegment(v, at, value) {
    const rows = row(value, 2, 'segment');
    writeVec3(v, at, rows ? value[0] : value.a);
    writeVec3(v, at + 3, rows ? value[1] : value.b);
}
export const readSphere = (v, at) => ({ center: readVec3(v, at), radius: v.f32[at + 3] });
export function writeSphere(v, at, value) {
    const rows = row(value, 2, 'sphere');
    writeVec3(v, at, rows ? value[0] : value.center);
    v.f32[at + 3] = real(rows ? value[1] : value.radius, 'radius');
}
export const readCapsule = (v, at) => ({ a: readVec3(v, at), b: readVec3(v, at + 3), radius: v.f32[at + 6] });
export function writeCapsule(v, at, value) {
    const rows = row(value, 3, 'capsule');
    writeVec3(v, at, rows ? value[0] : value.a);
    writeVec3(v, at + 3, rows ? value[1] : value.b);
    v.f32[at + 6] = real(rows ? value[2] : value.radius, 'radius');
}
export const readAabb = (v, at) => ({ min: readVec3(v, at), max: readVec3(v, at + 3) });
export function writeAabb(v, at, value) {
    const rows = row(value, 2, 'aabb');
    writeVec3(v, at, rows ? value[0] : value.min);
    writeVec3(v, at + 3, rows ? value[1] : value.max);
}
export const readObb = (v, at) => ({ center: readVec3(v, at), half_extents: readVec3(v, at + 3), rotation: readQuat(v, at + 6) });
export function writeObb(v, at, value) {
    const rows = row(value, 3, 'obb');
    if (!rows && (value.rotation === undefined)) only(value, ['center', 'half_extents', 'rotation'], 'obb');
    writeVec3(v, at, rows ? value[0] : value.center);
    writeVec3(v, at + 3, rows ? value[1] : value.half_extents);
    writeQuat(v, at + 6, rows ? value[2] : value.rotation ?? [0, 0, 0, 1]);
}
export const readPlane = (v, at) => ({ normal: readVec3(v, at), distance: v.f32[at + 3] });
export function writePlane(v, at, value) {
    const rows = row(value, 2, 'plane');
    writeVec3(v, at, rows ? value[0] : value.normal);
    v.f32[at + 3] = real(rows ? value[1] : value.distance, 'distance');
}
export const readTriangle = (v, at) => ({ a: readVec3(v, at), b: readVec3(v, at + 3), c: readVec3(v, at + 6) });
export function writeTriangle(v, at, value) {
    const rows = row(value, 3, 'triangle');
    writeVec3(v, at, rows ? value[0] : value.a);
    writeVec3(v, at + 3, rows ? value[1] : value.b);
    writeVec3(v, at + 6, rows ? value[2] : value.c);
}
export const readFrustum = (v, at) => ({ origin: readVec3(v, at), planes: Array.from({ length: 6 }, (_, i) => readPlane(v, at + 3 + 4 * i)) });
export function writeFrustum(v, at, value) {
    const rows = row(value, 2, 'frustum');
    writeVec3(v, at, rows ? value[0] : value.origin);
    const planes = rows ? value[1] : value.planes;
    for (let i = 0; i < 6; ++i) writePlane(v, at + 3 + 4 * i, planes[i]);
}
export const readHit = (v, at) => ({ model: v.u32[at], tag: v.u32[at + 1], t: v.f32[at + 2], point: readVec3(v, at + 3), normal: readVec3(v, at + 6), triangle: v.u32[at + 9], u: v.f32[at + 10], v: v.f32[at + 11], flags: v.u32[at + 12] });
export function writeHit(v, at, value) {
    const rows = row(value, 9, 'hit');
    v.u32[at] = whole(rows ? value[0] : value.model, 'model');
    v.u32[at + 1] = whole(rows ? value[1] : value.tag, 'tag');
    v.f32[at + 2] = real(rows ? value[2] : value.t, 't');
    writeVec3(v, at + 3, rows ? value[3] : value.point);
    writeVec3(v, at + 6, rows ? value[4] : value.normal);
    v.u32[at + 9] = whole(rows ? value[5] : value.triangle, 'triangle');
    v.f32[at + 10] = real(rows ? value[6] : value.u, 'u');
    v.f32[at + 11] = real(rows ? value[7] : value.v, 'v');
    v.u32[at + 12] = bits(rows ? value[8] : value.flags, 'flags');
}
export const readNearest = (v, at) => ({ model: v.u32[at], tag: v.u32[at + 1], point: readVec3(v, at + 2), distance: v.f32[at + 5], triangle: v.u32[at + 6] });
export function writeNearest(v, at, value) {
    const rows = row(value, 5, 'nearest');
    v.u32[at] = whole(rows ? value[0] : value.model, 'model');
    v.u32[at + 1] = whole(rows ? value[1] : value.tag, 'tag');
    writeVec3(v, at + 2, rows ? value[2] : value.point);
    v.f32[at + 5] = real(rows ? value[3] : value.distance, 'distance');
    v.u32[at + 6] = whole(rows ? value[4] : value.triangle, 'triangle');
}
export const readDistance = (v, at) => ({ t: v.f32[at], model: v.u32[at + 1], triangle: v.u32[at + 2] });
export function writeDistance(v, at, value) {
    const rows = row(value, 3, 'distance');
    v.f32[at] = real(rows ? value[0] : value.t, 't');
    v.u32[at + 1] = whole(rows ? value[1] : value.model, 'model');
    v.u32[at + 2] = whole(rows ? value[2] : value.triangle, 'triangle');
}
export const readPenetration = (v, at) => ({ model: v.u32[at], tag: v.u32[at + 1], point: readVec3(v, at + 2), normal: readVec3(v, at + 5), depth: v.f32[at + 8], triangle: v.u32[at + 9] });
export function writePenetration(v, at, value) {
    const rows = row(value, 6, 'penetration');
    v.u32[at] = whole(rows ? value[0] : value.model, 'model');
    v.u32[at + 1] = whole(rows ? value[1] : value.tag, 'tag');
    writeVec3(v, at + 2, rows ? value[2] : value.point);
    writeVec3(v, at + 5, rows ? value[3] : value.normal);
    v.f32[at + 8] = real(rows ? value[4] : value.depth, 'depth');
    v.u32[at + 9] = whole(rows ? value[5] : value.triangle, 'triangle');
}
export const readMeshReport = (v, at) => ({ triangle_count: v.u32[at], degenerate_count: v.u32[at + 1], first_degenerate: v.u32[at + 2], out_of_range_count: v.u32[at + 3], first_out_of_range: v.u32[at + 4], bad_vertex_count: v.u32[at + 5], first_bad_vertex: v.u32[at + 6], open_edge_count: v.u32[at + 7] });
export function writeMeshReport(v, at, value) {
    const rows = row(value, 8, 'mesh_report');
    v.u32[at] = whole(rows ? value[0] : value.triangle_count, 'triangle_count');
    v.u32[at + 1] = whole(rows ? value[1] : value.degenerate_count, 'degenerate_count');
    v.u32[at + 2] = whole(rows ? value[2] : value.first_degenerate, 'first_degenerate');
    v.u32[at + 3] = whole(rows ? value[3] : value.out_of_range_count, 'out_of_range_count');
    v.u32[at + 4] = whole(rows ? value[4] : value.first_out_of_range, 'first_out_of_range');
    v.u32[at + 5] = whole(rows ? value[5] : value.bad_vertex_count, 'bad_vertex_count');
    v.u32[at + 6] = whole(rows ? value[6] : value.first_bad_vertex, 'first_bad_vertex');
    v.u32[at + 7] = whole(rows ? value[7] : value.open_edge_count, 'open_edge_count');
}
export function writeMeshDesc(v, at, value) {
    named(value, 'mesh_desc');
    for (const name in value) {
        switch (name) {
            case 'deformable': v.i32[at + (v.wide ? 4 : 2)] = flag(value[name], 'deformable'); break;
            default: throw new TypeError(`mesh_desc has no field ${name}`);
        }
    }
}
export const readMeshInfo = (v, at) => ({ kind: v.i32[at], vertex_count: v.u32[at + 1], triangle_count: v.u32[at + 2], deformable: v.i32[at + 3], follows_body: v.i32[at + 4] });
export function writeMeshInfo(v, at, value) {
    const rows = row(value, 5, 'mesh_info');
    v.i32[at] = signed(rows ? value[0] : value.kind, 'kind');
    v.u32[at + 1] = whole(rows ? value[1] : value.vertex_count, 'vertex_count');
    v.u32[at + 2] = whole(rows ? value[2] : value.triangle_count, 'triangle_count');
    v.i32[at + 3] = flag(rows ? value[3] : value.deformable, 'deformable');
    v.i32[at + 4] = flag(rows ? value[4] : value.follows_body, 'follows_body');
}
export const readOctreeStats = (v, at) => ({ item_count: v.u32[at], unbounded_count: v.u32[at + 1], node_count: v.u32[at + 2], leaf_count: v.u32[at + 3], depth: v.u32[at + 4], rebuilds: v.u32[at + 5], cost: v.f32[at + 6], memory_bytes: v.u32[at + 7] });
export function writeOctreeStats(v, at, value) {
    const rows = row(value, 8, 'octree_stats');
    v.u32[at] = whole(rows ? value[0] : value.item_count, 'item_count');
    v.u32[at + 1] = whole(rows ? value[1] : value.unbounded_count, 'unbounded_count');
    v.u32[at + 2] = whole(rows ? value[2] : value.node_count, 'node_count');
    v.u32[at + 3] = whole(rows ? value[3] : value.leaf_count, 'leaf_count');
    v.u32[at + 4] = whole(rows ? value[4] : value.depth, 'depth');
    v.u32[at + 5] = whole(rows ? value[5] : value.rebuilds, 'rebuilds');
    v.f32[at + 6] = real(rows ? value[6] : value.cost, 'cost');
    v.u32[at + 7] = whole(rows ? value[7] : value.memory_bytes, 'memory_bytes');
}
export const readOctreeBox = (v, at) => ({ bounds: readAabb(v, at), depth: v.u32[at + 6], item_count: v.u32[at + 7] });
export function writeOctreeBox(v, at, value) {
    const rows = row(value, 3, 'octree_box');
    writeAabb(v, at, rows ? value[0] : value.bounds);
    v.u32[at + 6] = whole(rows ? value[1] : value.depth, 'depth');
    v.u32[at + 7] = whole(rows ? value[2] : value.item_count, 'item_count');
}
export function writeSceneDesc(v, at, value) {
    named(value, 'scene_desc');
    for (const name in value) {
        switch (name) {
            case 'reserve_models': v.u32[at + (v.wide ? 4 : 2)] = whole(value[name], 'reserve_models'); break;
            case 'worker_count': v.u32[at + (v.wide ? 8 : 4)] = whole(value[name], 'worker_count'); break;
            default: throw new TypeError(`scene_desc has no field ${name}`);
        }
    }
}
export function writeModelDesc(v, at, value) {
    named(value, 'model_desc');
    for (const name in value) {
        switch (name) {
            case 'parent': v.u32[at + 1] = whole(value[name], 'parent'); break;
            case 'layers': v.u32[at + 2] = bits(value[name], 'layers'); break;
            case 'tag': v.u32[at + 3] = whole(value[name], 'tag'); break;
            case 'scale': writeVec3(v, at + 4, value[name]); break;
            default: throw new TypeError(`model_desc has no field ${name}`);
        }
    }
}
export const readModelInfo = (v, at) => ({ type: v.i32[at], parent: v.u32[at + 1], layers: v.u32[at + 2], tag: v.u32[at + 3], child_count: v.u32[at + 4] });
export function writeModelInfo(v, at, value) {
    const rows = row(value, 5, 'model_info');
    v.i32[at] = signed(rows ? value[0] : value.type, 'type');
    v.u32[at + 1] = whole(rows ? value[1] : value.parent, 'parent');
    v.u32[at + 2] = bits(rows ? value[2] : value.layers, 'layers');
    v.u32[at + 3] = whole(rows ? value[3] : value.tag, 'tag');
    v.u32[at + 4] = whole(rows ? value[4] : value.child_count, 'child_count');
}
export function writeQueryFilterDesc(v, at, value) {
    named(value, 'query_filter_desc');
    for (const name in value) {
        switch (name) {
            case 'layers': v.u32[at + 1] = bits(value[name], 'layers'); break;
            case 'ignored_model': v.u32[at + 2] = whole(value[name], 'ignored_model'); break;
            case 'flags': v.u32[at + 3] = bits(value[name], 'flags'); break;
            case 'ignored_models': {
                const { address, length } = v.hold(value[name], 'ignored_models');
                v.u32[at + 4] = address;
                if (v.wide) v.u32[at + 4 + 1] = Math.floor(address / 2 ** 32);
                v.u32[at + (v.wide ? 6 : 5)] = length;
                break;
            }
            default: throw new TypeError(`query_filter_desc has no field ${name}`);
        }
    }
}
export function writeCameraDesc(v, at, value) {
    named(value, 'camera_desc');
    for (const name in value) {
        switch (name) {
            case 'handedness': v.i32[at + (v.wide ? 4 : 2)] = signed(value[name], 'handedness'); break;
            case 'depth_range': v.i32[at + (v.wide ? 5 : 3)] = signed(value[name], 'depth_range'); break;
            case 'reverse_z': v.i32[at + (v.wide ? 6 : 4)] = flag(value[name], 'reverse_z'); break;
            case 'viewport_width': v.f32[at + (v.wide ? 7 : 5)] = real(value[name], 'viewport_width'); break;
            case 'viewport_height': v.f32[at + (v.wide ? 8 : 6)] = real(value[name], 'viewport_height'); break;
            default: throw new TypeError(`camera_desc has no field ${name}`);
        }
    }
}
export const readOrbit = (v, at) => ({ target: readVec3(v, at), up: readVec3(v, at + 3), distance: v.f32[at + 6], yaw: v.f32[at + 7], pitch: v.f32[at + 8], radians_per_unit: v.f32[at + 9], metres_per_unit: v.f32[at + 10], min_distance: v.f32[at + 11], max_distance: v.f32[at + 12], min_pitch: v.f32[at + 13], max_pitch: v.f32[at + 14] });
export function writeOrbit(v, at, value) {
    const rows = row(value, 11, 'orbit');
    writeVec3(v, at, rows ? value[0] : value.target);
    writeVec3(v, at + 3, rows ? value[1] : value.up);
    v.f32[at + 6] = real(rows ? value[2] : value.distance, 'distance');
    v.f32[at + 7] = real(rows ? value[3] : value.yaw, 'yaw');
    v.f32[at + 8] = real(rows ? value[4] : value.pitch, 'pitch');
    v.f32[at + 9] = real(rows ? value[5] : value.radians_per_unit, 'radians_per_unit');
    v.f32[at + 10] = real(rows ? value[6] : value.metres_per_unit, 'metres_per_unit');
    v.f32[at + 11] = real(rows ? value[7] : value.min_distance, 'min_distance');
    v.f32[at + 12] = real(rows ? value[8] : value.max_distance, 'max_distance');
    v.f32[at + 13] = real(rows ? value[9] : value.min_pitch, 'min_pitch');
    v.f32[at + 14] = real(rows ? value[10] : value.max_pitch, 'max_pitch');
}
export const readOrbitSpeeds = (v, at) => ({ rotate_x: v.f32[at], rotate_y: v.f32[at + 1], zoom: v.f32[at + 2], pan_x: v.f32[at + 3], pan_y: v.f32[at + 4] });
export function writeOrbitSpeeds(v, at, value) {
    const rows = row(value, 5, 'orbit_speeds');
    v.f32[at] = real(rows ? value[0] : value.rotate_x, 'rotate_x');
    v.f32[at + 1] = real(rows ? value[1] : value.rotate_y, 'rotate_y');
    v.f32[at + 2] = real(rows ? value[2] : value.zoom, 'zoom');
    v.f32[at + 3] = real(rows ? value[3] : value.pan_x, 'pan_x');
    v.f32[at + 4] = real(rows ? value[4] : value.pan_y, 'pan_y');
}
export function writeSolverDesc(v, at, value) {
    named(value, 'solver_desc');
    for (const name in value) {
        switch (name) {
            case 'gravity': writeVec3(v, at + (v.wide ? 4 : 2), value[name]); break;
            case 'substeps': v.u32[at + (v.wide ? 7 : 5)] = whole(value[name], 'substeps'); break;
            case 'fixed_step': v.f32[at + (v.wide ? 8 : 6)] = real(value[name], 'fixed_step'); break;
            case 'max_steps': v.u32[at + (v.wide ? 9 : 7)] = whole(value[name], 'max_steps'); break;
            case 'worker_count': v.u32[at + (v.wide ? 12 : 9)] = whole(value[name], 'worker_count'); break;
            case 'sleep_speed': v.f32[at + (v.wide ? 13 : 10)] = real(value[name], 'sleep_speed'); break;
            case 'sleep_strain': v.f32[at + (v.wide ? 14 : 11)] = real(value[name], 'sleep_strain'); break;
            case 'sleep_time': v.f32[at + (v.wide ? 15 : 12)] = real(value[name], 'sleep_time'); break;
            case 'max_strain': v.f32[at + (v.wide ? 16 : 13)] = real(value[name], 'max_strain'); break;
            case 'tolerance': v.f32[at + (v.wide ? 17 : 14)] = real(value[name], 'tolerance'); break;
            case 'max_substeps': v.u32[at + (v.wide ? 18 : 15)] = whole(value[name], 'max_substeps'); break;
            case 'max_work': v.u32[at + (v.wide ? 19 : 16)] = whole(value[name], 'max_work'); break;
            default: throw new TypeError(`solver_desc has no field ${name}`);
        }
    }
}
export const readSolverSettings = (v, at) => ({ gravity: readVec3(v, at), substeps: v.u32[at + 3], fixed_step: v.f32[at + 4], max_steps: v.u32[at + 5], sleep_speed: v.f32[at + 6], sleep_strain: v.f32[at + 7], sleep_time: v.f32[at + 8], max_strain: v.f32[at + 9], tolerance: v.f32[at + 10], max_substeps: v.u32[at + 11], max_work: v.u32[at + 12] });
export function writeSolverSettings(v, at, value) {
    const rows = row(value, 11, 'solver_settings');
    writeVec3(v, at, rows ? value[0] : value.gravity);
    v.u32[at + 3] = whole(rows ? value[1] : value.substeps, 'substeps');
    v.f32[at + 4] = real(rows ? value[2] : value.fixed_step, 'fixed_step');
    v.u32[at + 5] = whole(rows ? value[3] : value.max_steps, 'max_steps');
    v.f32[at + 6] = real(rows ? value[4] : value.sleep_speed, 'sleep_speed');
    v.f32[at + 7] = real(rows ? value[5] : value.sleep_strain, 'sleep_strain');
    v.f32[at + 8] = real(rows ? value[6] : value.sleep_time, 'sleep_time');
    v.f32[at + 9] = real(rows ? value[7] : value.max_strain, 'max_strain');
    v.f32[at + 10] = real(rows ? value[8] : value.tolerance, 'tolerance');
    v.u32[at + 11] = whole(rows ? value[9] : value.max_substeps, 'max_substeps');
    v.u32[at + 12] = whole(rows ? value[10] : value.max_work, 'max_work');
}
export function writeBodyDesc(v, at, value) {
    named(value, 'body_desc');
    for (const name in value) {
        switch (name) {
            case 'mass': v.f32[at + 1] = real(value[name], 'mass'); break;
            case 'radius': v.f32[at + 2] = real(value[name], 'radius'); break;
            case 'damping': v.f32[at + 3] = real(value[name], 'damping'); break;
            case 'friction': v.f32[at + 4] = real(value[name], 'friction'); break;
            case 'restitution': v.f32[at + 5] = real(value[name], 'restitution'); break;
            case 'compliance': v.f32[at + 6] = real(value[name], 'compliance'); break;
            case 'bend_compliance': v.f32[at + 7] = real(value[name], 'bend_compliance'); break;
            case 'cloth_flags': v.u32[at + 8] = bits(value[name], 'cloth_flags'); break;
            case 'layers': v.u32[at + 9] = bits(value[name], 'layers'); break;
            case 'static_friction': v.f32[at + 10] = real(value[name], 'static_friction'); break;
            case 'self_collision': v.u32[at + 11] = whole(value[name], 'self_collision'); break;
            case 'body_layers': v.u32[at + 12] = bits(value[name], 'body_layers'); break;
            case 'shear_compliance': v.f32[at + 13] = real(value[name], 'shear_compliance'); break;
            case 'breaking_force': v.f32[at + 14] = real(value[name], 'breaking_force'); break;
            case 'bending_stiffness': v.f32[at + 15] = real(value[name], 'bending_stiffness'); break;
            default: throw new TypeError(`body_desc has no field ${name}`);
        }
    }
}
export const readBodySettings = (v, at) => ({ damping: v.f32[at], friction: v.f32[at + 1], static_friction: v.f32[at + 2], restitution: v.f32[at + 3], layers: v.u32[at + 4], body_layers: v.u32[at + 5], self_collision: v.u32[at + 6] });
export function writeBodySettings(v, at, value) {
    const rows = row(value, 7, 'body_settings');
    v.f32[at] = real(rows ? value[0] : value.damping, 'damping');
    v.f32[at + 1] = real(rows ? value[1] : value.friction, 'friction');
    v.f32[at + 2] = real(rows ? value[2] : value.static_friction, 'static_friction');
    v.f32[at + 3] = real(rows ? value[3] : value.restitution, 'restitution');
    v.u32[at + 4] = bits(rows ? value[4] : value.layers, 'layers');
    v.u32[at + 5] = bits(rows ? value[5] : value.body_layers, 'body_layers');
    v.u32[at + 6] = whole(rows ? value[6] : value.self_collision, 'self_collision');
}
export const readBodyInfo = (v, at) => ({ kind: v.i32[at], method: v.i32[at + 1], particle_count: v.u32[at + 2], constraint_count: v.u32[at + 3], triangle_count: v.u32[at + 4] });
export function writeBodyInfo(v, at, value) {
    const rows = row(value, 5, 'body_info');
    v.i32[at] = signed(rows ? value[0] : value.kind, 'kind');
    v.i32[at + 1] = signed(rows ? value[1] : value.method, 'method');
    v.u32[at + 2] = whole(rows ? value[2] : value.particle_count, 'particle_count');
    v.u32[at + 3] = whole(rows ? value[3] : value.constraint_count, 'constraint_count');
    v.u32[at + 4] = whole(rows ? value[4] : value.triangle_count, 'triangle_count');
}
export const readWind = (v, at) => ({ velocity: readVec3(v, at), density: v.f32[at + 3], drag: v.f32[at + 4], lift: v.f32[at + 5] });
export function writeWind(v, at, value) {
    const rows = row(value, 4, 'wind');
    writeVec3(v, at, rows ? value[0] : value.velocity);
    v.f32[at + 3] = real(rows ? value[1] : value.density, 'density');
    v.f32[at + 4] = real(rows ? value[2] : value.drag, 'drag');
    v.f32[at + 5] = real(rows ? value[3] : value.lift, 'lift');
}
export const readAnimationTarget = (v, at) => ({ position: readVec3(v, at), normal: readVec3(v, at + 3), max_distance: v.f32[at + 6], backstop: v.f32[at + 7] });
export function writeAnimationTarget(v, at, value) {
    const rows = row(value, 4, 'animation_target');
    writeVec3(v, at, rows ? value[0] : value.position);
    writeVec3(v, at + 3, rows ? value[1] : value.normal);
    v.f32[at + 6] = real(rows ? value[2] : value.max_distance, 'max_distance');
    v.f32[at + 7] = real(rows ? value[3] : value.backstop, 'backstop');
}
export const readAttachment = (v, at) => ({ particle: v.u32[at], model: v.u32[at + 1], local_point: readVec3(v, at + 2) });
export function writeAttachment(v, at, value) {
    const rows = row(value, 3, 'attachment');
    v.u32[at] = whole(rows ? value[0] : value.particle, 'particle');
    v.u32[at + 1] = whole(rows ? value[1] : value.model, 'model');
    writeVec3(v, at + 2, rows ? value[2] : value.local_point);
}
export const readConstraintInfo = (v, at) => ({ id: v.u32[at], particle_a: v.u32[at + 1], particle_b: v.u32[at + 2], rest_length: v.f32[at + 3], compliance: v.f32[at + 4] });
export function writeConstraintInfo(v, at, value) {
    const rows = row(value, 5, 'constraint_info');
    v.u32[at] = whole(rows ? value[0] : value.id, 'id');
    v.u32[at + 1] = whole(rows ? value[1] : value.particle_a, 'particle_a');
    v.u32[at + 2] = whole(rows ? value[2] : value.particle_b, 'particle_b');
    v.f32[at + 3] = real(rows ? value[3] : value.rest_length, 'rest_length');
    v.f32[at + 4] = real(rows ? value[4] : value.compliance, 'compliance');
}
export const readConstraintSettings = (v, at) => ({ rest_length: v.f32[at], compliance: v.f32[at + 1], damping: v.f32[at + 2] });
export function writeConstraintSettings(v, at, value) {
    const rows = row(value, 3, 'constraint_settings');
    v.f32[at] = real(rows ? value[0] : value.rest_length, 'rest_length');
    v.f32[at + 1] = real(rows ? value[1] : value.compliance, 'compliance');
    v.f32[at + 2] = real(rows ? value[2] : value.damping, 'damping');
}
export const readJointInfo = (v, at) => ({ id: v.u32[at], body_a: v.u32[at + 1], particle_a: v.u32[at + 2], body_b: v.u32[at + 3], particle_b: v.u32[at + 4], rest_length: v.f32[at + 5], compliance: v.f32[at + 6], force: v.f32[at + 7] });
export function writeJointInfo(v, at, value) {
    const rows = row(value, 8, 'joint_info');
    v.u32[at] = whole(rows ? value[0] : value.id, 'id');
    v.u32[at + 1] = whole(rows ? value[1] : value.body_a, 'body_a');
    v.u32[at + 2] = whole(rows ? value[2] : value.particle_a, 'particle_a');
    v.u32[at + 3] = whole(rows ? value[3] : value.body_b, 'body_b');
    v.u32[at + 4] = whole(rows ? value[4] : value.particle_b, 'particle_b');
    v.f32[at + 5] = real(rows ? value[5] : value.rest_length, 'rest_length');
    v.f32[at + 6] = real(rows ? value[6] : value.compliance, 'compliance');
    v.f32[at + 7] = real(rows ? value[7] : value.force, 'force');
}
export const readBreak = (v, at) => ({ body: v.u32[at], constraint: v.u32[at + 1], particle_a: v.u32[at + 2], particle_b: v.u32[at + 3], torn_particle: v.u32[at + 4], new_particle: v.u32[at + 5], load: v.f32[at + 6] });
export function writeBreak(v, at, value) {
    const rows = row(value, 7, 'break');
    v.u32[at] = whole(rows ? value[0] : value.body, 'body');
    v.u32[at + 1] = whole(rows ? value[1] : value.constraint, 'constraint');
    v.u32[at + 2] = whole(rows ? value[2] : value.particle_a, 'particle_a');
    v.u32[at + 3] = whole(rows ? value[3] : value.particle_b, 'particle_b');
    v.u32[at + 4] = whole(rows ? value[4] : value.torn_particle, 'torn_particle');
    v.u32[at + 5] = whole(rows ? value[5] : value.new_particle, 'new_particle');
    v.f32[at + 6] = real(rows ? value[6] : value.load, 'load');
}
export const readSolverStats = (v, at) => ({ particle_count: v.u32[at], pinned_count: v.u32[at + 1], constraint_count: v.u32[at + 2], contact_count: v.u32[at + 3], strain_max: v.f32[at + 4], strain_rms: v.f32[at + 5], kinetic_energy: v.f32[at + 6], potential_energy: v.f32[at + 7] });
export function writeSolverStats(v, at, value) {
    const rows = row(value, 8, 'solver_stats');
    v.u32[at] = whole(rows ? value[0] : value.particle_count, 'particle_count');
    v.u32[at + 1] = whole(rows ? value[1] : value.pinned_count, 'pinned_count');
    v.u32[at + 2] = whole(rows ? value[2] : value.constraint_count, 'constraint_count');
    v.u32[at + 3] = whole(rows ? value[3] : value.contact_count, 'contact_count');
    v.f32[at + 4] = real(rows ? value[4] : value.strain_max, 'strain_max');
    v.f32[at + 5] = real(rows ? value[5] : value.strain_rms, 'strain_rms');
    v.f32[at + 6] = real(rows ? value[6] : value.kinetic_energy, 'kinetic_energy');
    v.f32[at + 7] = real(rows ? value[7] : value.potential_energy, 'potential_energy');
}
export const readContact = (v, at) => ({ body: v.u32[at], particle: v.u32[at + 1], model: v.u32[at + 2], tag: v.u32[at + 3], point: readVec3(v, at + 4), normal: readVec3(v, at + 7) });
export function writeContact(v, at, value) {
    const rows = row(value, 6, 'contact');
    v.u32[at] = whole(rows ? value[0] : value.body, 'body');
    v.u32[at + 1] = whole(rows ? value[1] : value.particle, 'particle');
    v.u32[at + 2] = whole(rows ? value[2] : value.model, 'model');
    v.u32[at + 3] = whole(rows ? value[3] : value.tag, 'tag');
    writeVec3(v, at + 4, rows ? value[4] : value.point);
    writeVec3(v, at + 7, rows ? value[5] : value.normal);
}
export const readBodyContact = (v, at) => ({ body_a: v.u32[at], particle_a: v.u32[at + 1], body_b: v.u32[at + 2], particle_b: v.u32[at + 3], normal: readVec3(v, at + 4), distance: v.f32[at + 7], impulse: v.f32[at + 8] });
export function writeBodyContact(v, at, value) {
    const rows = row(value, 7, 'body_contact');
    v.u32[at] = whole(rows ? value[0] : value.body_a, 'body_a');
    v.u32[at + 1] = whole(rows ? value[1] : value.particle_a, 'particle_a');
    v.u32[at + 2] = whole(rows ? value[2] : value.body_b, 'body_b');
    v.u32[at + 3] = whole(rows ? value[3] : value.particle_b, 'particle_b');
    writeVec3(v, at + 4, rows ? value[4] : value.normal);
    v.f32[at + 7] = real(rows ? value[5] : value.distance, 'distance');
    v.f32[at + 8] = real(rows ? value[6] : value.impulse, 'impulse');
}
export const readImpulse = (v, at) => ({ model: v.u32[at], tag: v.u32[at + 1], linear: readVec3(v, at + 2), angular: readVec3(v, at + 5) });
export function writeImpulse(v, at, value) {
    const rows = row(value, 4, 'impulse');
    v.u32[at] = whole(rows ? value[0] : value.model, 'model');
    v.u32[at + 1] = whole(rows ? value[1] : value.tag, 'tag');
    writeVec3(v, at + 2, rows ? value[2] : value.linear);
    writeVec3(v, at + 5, rows ? value[3] : value.angular);
}
/** What arrays can contain. */
export const types = {
    float: { size: 4, read: (v, at) => v.f32[at] },
    double: { size: 8, read: (v, at) => v.f64[at >> 1] },
    int32_t: { size: 4, read: (v, at) => v.i32[at] },
    uint32_t: { size: 4, read: (v, at) => v.u32[at] },
    vec3: { size: 12, read: readVec3, write: writeVec3 },
    quat: { size: 16, read: readQuat, write: writeQuat },
    mat4: { size: 64, read: readMat4, write: writeMat4 },
    transform: { size: 32, read: readTransform, write: writeTransform },
    ray: { size: 28, read: readRay, write: writeRay },
    segment: { size: 24, read: readSegment, write: writeSegment },
    sphere: { size: 16, read: readSphere, write: writeSphere },
    capsule: { size: 28, read: readCapsule, write: writeCapsule },
    aabb: { size: 24, read: readAabb, write: writeAabb },
    obb: { size: 40, read: readObb, write: writeObb },
    plane: { size: 16, read: readPlane, write: writePlane },
    triangle: { size: 36, read: readTriangle, write: writeTriangle },
    frustum: { size: 108, read: readFrustum, write: writeFrustum },
    hit: { size: 52, read: readHit, write: writeHit },
    nearest: { size: 28, read: readNearest, write: writeNearest },
    distance: { size: 12, read: readDistance, write: writeDistance },
    penetration: { size: 40, read: readPenetration, write: writePenetration },
    mesh_report: { size: 32, read: readMeshReport, write: writeMeshReport },
    mesh_info: { size: 20, read: readMeshInfo, write: writeMeshInfo },
    octree_stats: { size: 32, read: readOctreeStats, write: writeOctreeStats },
    octree_box: { size: 32, read: readOctreeBox, write: writeOctreeBox },
    model_info: { size: 20, read: readModelInfo, write: writeModelInfo },
    orbit: { size: 60, read: readOrbit, write: writeOrbit },
    orbit_speeds: { size: 20, read: readOrbitSpeeds, write: writeOrbitSpeeds },
    solver_settings: { size: 52, read: readSolverSettings, write: writeSolverSettings },
    body_settings: { size: 28, read: readBodySettings, write: writeBodySettings },
    body_info: { size: 20, read: readBodyInfo, write: writeBodyInfo },
    wind: { size: 24, read: readWind, write: writeWind },
    animation_target: { size: 32, read: readAnimationTarget, write: writeAnimationTarget },
    attachment: { size: 20, read: readAttachment, write: writeAttachment },
    constraint_info: { size: 20, read: readConstraintInfo, write: writeConstraintInfo },
    constraint_settings: { size: 12, read: readConstraintSettings, write: writeConstraintSettings },
    joint_info: { size: 32, read: readJointInfo, write: writeJointInfo },
    break: { size: 28, read: readBreak, write: writeBreak },
    solver_stats: { size: 32, read: readSolverStats, write: writeSolverStats },
    contact: { size: 40, read: readContact, write: writeContact },
    body_contact: { size: 36, read: readBodyContact, write: writeBodyContact },
    impulse: { size: 32, read: readImpulse, write: writeImpulse },
};
