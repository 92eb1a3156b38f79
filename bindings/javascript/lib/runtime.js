// What the generated methods (objects.js) are made of: ownership, errors, and the ways of single values,
// arrays and lists into a call and out of it. How the library's memory is reached is left to `memory`:
//
//   native       the library's functions
//   base         address of PASS_BYTES bytes that single values pass through
//   views        f32, u32, i32, f64 over those bytes, replaced when memory moves; wide: 8-byte pointers
//   text(value)  a returned string
//   begin()      forgets the arrays passed before
//   locate(view) the address of a view of the library's own memory, else undefined
//   pass(array)  what a native function takes for an array { view, address, out }
//   nowhere(address)  the same for an object's address, or none
//   finish(array)  brings results back into the view
//   room(bytes)  { argument, bytes } for a list of at least so many bytes, until the next room or begin
//   take(room, bytes)  a copy of its first bytes
//   hold(view)   the address of a copy of a view, or of itself, until begin
//   records(kind, length, address)  Records that native functions reach without a copy, at an address or of their own
import { INCOMPLETE, SHAPE_AABB } from './constants.js';
import * as constants from './constants.js';
import { whole } from './numbers.js';
import { elements, inspected, noData, showObject, showRecords } from './plain.js';
import { readOrbit, types, writeTransform } from './structs.js';

export const PASS_BYTES = 1024; // the generator asserts that it is enough for every function

/** A call failed: the message is the library's, status its number. */
export class GamephysError extends Error {
    constructor(message, status) {
        super(message);
        this.name = 'GamephysError';
        this.status = status;
    }
}

/** An object was used after close(). */
export class GamephysClosed extends Error {
    constructor(name) {
        super(`${name} is closed`);
        this.name = 'GamephysClosed';
    }
}

export function viewsOf(buffer, start, bytes) {
    const views = {
        f32: new Float32Array(buffer, start, bytes >> 2),
        u32: new Uint32Array(buffer, start, bytes >> 2),
        i32: new Int32Array(buffer, start, bytes >> 2),
    };
    if (start % 8 === 0 && bytes % 8 === 0) views.f64 = new Float64Array(buffer, start, bytes >> 3);
    return views;
}

function typeNamed(kind) {
    if (!Object.hasOwn(types, kind)) throw new TypeError(`there is no kind ${kind}`);
    return types[kind];
}

/** Rows of one kind of struct or number, one after the other: views of them as numbers, and each as an object. */
export class Records {
    #views;
    constructor(kind, length, buffer, start = 0) {
        const { size } = typeNamed(kind);
        whole(length, 'length');
        this.kind = kind;
        this.length = length;
        this.stride = size;
        this.toJSON = elements;
        if (buffer !== null) this.#views = viewsOf(buffer ?? new ArrayBuffer(length * size), start, length * size);
    }
    get views() {
        return this.#views;
    }
    get f32() {
        return this.views.f32;
    }
    get u32() {
        return this.views.u32;
    }
    get i32() {
        return this.views.i32;
    }
    get f64() {
        return this.views.f64;
    }
    #at(index) {
        if (!(Number.isInteger(index) && index >= 0 && index < this.length)) throw new RangeError(`no element ${index}`);
        return (index * this.stride) / 4;
    }
    get(index) {
        return types[this.kind].read(this.views, this.#at(index));
    }
    set(index, value) {
        types[this.kind].write(this.views, this.#at(index), value);
    }
    *[Symbol.iterator]() {
        for (let i = 0; i < this.length; ++i) yield this.get(i);
    }
    /** Gives the memory back at once, where it is the library's. */
    close() {}
}
Records.prototype[inspected] = showRecords;
if (Symbol.dispose) {
    Records.prototype[Symbol.dispose] = function () {
        this.close();
    };
}

/** A shape without a place in a scene: its kind and its numbers. */
export class Shape {
    constructor(kind, fields) {
        this.kind = kind;
        this.type = constants[`SHAPE_${kind.toUpperCase()}`];
        this.data = new Float32Array(types[kind].size / 4);
        types[kind].write({ f32: this.data }, 0, fields);
    }
    /** Its fields by name. */
    get value() {
        return types[this.kind].read({ f32: this.data }, 0);
    }
}

/** Many shapes of one kind, from rows of their numbers. */
export class Shapes {
    constructor(kind, data) {
        this.type = constants[`SHAPE_${kind.toUpperCase()}`];
        if (this.type === undefined || kind === 'mesh') throw new TypeError(`there is no shape ${kind}`);
        this.kind = kind;
        this.data = data;
    }
}

/** Older engines have no property for it. */
function isDetached(buffer) {
    if (buffer.detached !== undefined) return buffer.detached;
    try {
        new Uint8Array(buffer);
        return false;
    } catch {
        return true;
    }
}

const wholeNumbers = ['uint32_t', 'int32_t'];

/** The memory of a typed array or of Records. Numbers must be those that are meant, if only one kind is. */
function viewOf(value, name, kind = '') {
    if (value instanceof Uint16Array && kind === 'u32') return Uint32Array.from(value);
    const rows = value instanceof Records;
    const view = rows ? value.views.f32 : value;
    const floats = rows ? !wholeNumbers.includes(value.kind) : view instanceof Float32Array;
    if (kind === 'f32' ? !floats && view?.BYTES_PER_ELEMENT === 4 : kind && floats) {
        throw new TypeError(`${name} must hold ${kind === 'f32' ? 'floats' : 'whole numbers'}: not ${rows ? `Records of ${value.kind}` : view.constructor.name}`);
    }
    if (!ArrayBuffer.isView(view)) throw new TypeError(`${name} must be a typed array or Records`);
    if (view.byteLength === 0 && isDetached(view.buffer)) {
        throw new TypeError(`${name}: the memory of this view has moved, as WebAssembly's does when it grows. Give the Records, or take their view afresh`);
    }
    const bytes = view.BYTES_PER_ELEMENT ?? 1;
    if (bytes !== 4 && bytes !== 1) throw new TypeError(`${name} must hold numbers of four bytes, or bytes: not ${view.constructor.name}`);
    return view;
}

/** Everything that objects.js needs, over one kind of memory. */
export function runtime(memory) {
    const { native, base, views: v } = memory;
    let Mesh;

    // --- errors and ownership

    const failed = (status) => new GamephysError(memory.text(native.gphys_last_error()), status);

    function check(status) {
        if (status < 0) throw failed(status);
        return status;
    }

    const registry = new FinalizationRegistry(({ destroy, address }) => destroy(address));

    /** Owns one object of the library: freed by close(), or when it is no longer reachable. */
    class Handle {
        #address;
        #destroy;
        constructor(create, destroy) {
            const address = create();
            this.#address = address;
            this.#destroy = destroy;
            this.toJSON = noData;
            registry.register(this, { destroy, address }, this);
        }
        get pointer() {
            if (this.#address === 0) throw new GamephysClosed(this.constructor.name);
            return this.#address;
        }
        close() {
            if (this.#address === 0) return;
            registry.unregister(this);
            this.#destroy(this.#address);
            this.#address = 0;
        }
        [inspected](...how) {
            return showObject.call(this, this.#address === 0, ...how);
        }
    }
    if (Symbol.dispose) Handle.prototype[Symbol.dispose] = Handle.prototype.close;

    /** The address that a create function has written. */
    const made = (place) => v.u32[place / 4] + (v.wide ? v.u32[place / 4 + 1] * 2 ** 32 : 0);

    function pointer(object, type, name, nullable) {
        if (object instanceof type) return object.pointer;
        if (nullable && object == null) return 0;
        throw new TypeError(`${name} must be a ${type.name}`);
    }

    // --- shapes

    function typeOf(shape) {
        if (shape instanceof Shape) return shape.type;
        if (shape instanceof Mesh) return constants.SHAPE_MESH;
        throw new TypeError('expected a shape');
    }

    function putShape(shape, at) {
        if (shape instanceof Mesh) return shape.pointer;
        v.f32.set(shape.data, at);
        return base + 4 * at;
    }

    /** For a batch: many shapes, or one that stands for each. */
    function inputShapes(shapes) {
        if (shapes instanceof Shapes) {
            const { size } = types[shapes.kind];
            return { ...input(shapes.data, size, `${shapes.kind}s`, 'f32'), type: shapes.type };
        }
        const type = typeOf(shapes);
        if (shapes instanceof Mesh) return { type, object: shapes.pointer, stride: 0 };
        return { type, view: shapes.data, stride: 0 };
    }

    // --- arrays

    const nothing = { object: 0, stride: 0 };

    function input(value, size, name, kind) {
        let view = viewOf(value, name, kind);
        if (value instanceof Records && value.stride % size && size % value.stride) {
            throw new TypeError(`${name}: ${value.kind} has ${value.stride} bytes, not ${size}`);
        }
        // The library reads numbers of four bytes only where these may lie.
        if (view.byteOffset % 4) view = new Uint8Array(view.buffer.slice(view.byteOffset, view.byteOffset + view.byteLength));
        if (view.byteLength % size) throw new RangeError(`${name}: not a whole number of elements of ${size} bytes`);
        return { view, address: memory.locate(view), stride: size, length: view.byteLength / size, numbers: view.byteLength / 4 };
    }

    /** Settings over the library's defaults, which are written at a place first: for each element, or for all. */
    function inputDescs(descs, at, size, init, write, name) {
        check(init(base + 4 * at, size));
        if (!Array.isArray(descs)) {
            write(v, at, descs);
            return { view: v.u32.subarray(at, at + size / 4), address: base + 4 * at, stride: 0 };
        }
        const view = new Uint32Array((descs.length * size) / 4);
        descs.forEach((desc, i) => view.set(v.u32.subarray(at, at + size / 4), (i * size) / 4));
        const views = { ...viewsOf(view.buffer, 0, view.byteLength), wide: v.wide, hold: v.hold };
        descs.forEach((desc, i) => {
            if (typeof desc !== 'object' || desc === null) throw new TypeError(`${name}: expected an object, got ${desc}`);
            write(views, (i * size) / 4, desc);
        });
        return input(view, size, name);
    }

    /** A list in a desc: where it is while the call reads it, and its length. */
    v.hold = function (value, name) {
        const view = Array.isArray(value) ? Uint32Array.from(value, (number) => whole(number, name)) : viewOf(value ?? new Uint32Array(0), name, 'u32');
        if (view.byteLength % 4) throw new RangeError(`${name}: not a whole number of elements of 4 bytes`);
        return { address: view.byteLength === 0 ? 0 : memory.hold(view), length: view.byteLength / 4 };
    };

    /** The indices of vertices that are not shared. */
    const ascending = (count) => Uint32Array.from({ length: count }, (_, i) => i);

    /** The number of a body's particles from the first that is asked for. */
    const rest = (solver, body, first) => Math.max(0, solver.getBodyInfo(body).particle_count - first);

    /** The length that arrays have in common, those apart that stand for one element or for none. */
    function common(...arrays) {
        const lengths = arrays.map((array) => array.length).filter((length) => length !== undefined);
        if (lengths.length === 0) throw new RangeError('no array says how many there are');
        if (lengths.some((length) => length !== lengths[0])) throw new RangeError(`arrays of different lengths: ${lengths.join(', ')}`);
        return lengths[0];
    }

    /** Where results go: into what the caller gave, or into memory of their own. */
    function output(out, kind, length) {
        const bytes = length * types[kind].size;
        if (out == null) {
            const records = new Records(kind, length);
            return { view: records.f32, records, out: true };
        }
        if (out instanceof Records && out.kind !== kind) throw new TypeError(`out must be Records of ${kind}, not of ${out.kind}`);
        const view = viewOf(out, 'out', wholeNumbers.includes(kind) ? 'u32' : kind === 'float' ? 'f32' : '');
        if (view.byteLength !== bytes) throw new RangeError(`out has ${view.byteLength} bytes, not ${bytes}`);
        const address = memory.locate(view);
        if (out instanceof Records) return { view, records: out, address, out: true };
        const records = address === undefined ? new Records(kind, length, view.buffer, view.byteOffset) : memory.records(kind, length, address);
        return { view, records, address, out: true };
    }

    /** To a native function: an object's address, or an array. */
    const pass = (array) => (array.view === undefined ? memory.nowhere(array.object) : memory.pass(array));

    function finish(array) {
        memory.finish(array);
        return array.records;
    }

    /** A few numbers in, such as an origin. */
    function numbers(view, at, values, count, name) {
        if (values.length !== count) throw new RangeError(`${name}: expected ${count} numbers, got ${values.length}`);
        view.set(values, at);
    }

    // --- lists of unknown length: asked again with more room if there are more than fit

    function fill(kind, total, call) {
        const { size } = types[kind];
        for (let bytes = 64 * size; ; bytes = total() * size) {
            const place = memory.room(bytes);
            if (check(call(place.argument, Math.floor(place.bytes / size))) === INCOMPLETE) continue;
            return new Records(kind, total(), memory.take(place, total() * size));
        }
    }

    const list = (kind, at, call) => fill(kind, () => v.u32[at], call);

    /** The lists of a batch behind one another, and where each begins. */
    function ragged(kind, offsets, call) {
        const ends = offsets.records.u32;
        const values = fill(kind, () => (memory.finish(offsets), ends[ends.length - 1]), call);
        return { values, offsets: ends };
    }

    // --- functions that do not fit the rule

    function more(Scene, MeshClass) {
        Mesh = MeshClass;
        /** The shape of a model, in its own coordinates; an error for a mesh, which Mesh.fromScene gives. */
        Scene.prototype.getShape = function (model) {
            const kind = kindOf(this.getInfo(model).type);
            check(native.gphys_scene_get_shape(this.pointer, model, base, types[kind]?.size ?? 0));
            return shapeAt(kind, 0);
        };
        return {
            GamephysClosed, GamephysError, Records, Shape, Shapes,
            shapes: (kind, data) => new Shapes(kind, data),
            /** Memory for rows, which are 0; rays have no end. */
            records(kind, length) {
                const made = memory.records(kind, whole(length, 'length'));
                if (kind === 'ray') {
                    const { f32 } = made, step = made.stride / 4;
                    for (let end = step - 1; end < f32.length; end += step) f32[end] = Infinity;
                }
                return made;
            },
            version: () => {
                const version = native.gphys_version();
                return `${version >>> 16}.${(version >>> 8) & 255}.${version & 255}`;
            },
            statusName: (status) => memory.text(native.gphys_status_name(status)),
            /** The orbit settings that the library starts from. */
            defaultOrbit() {
                check(native.gphys_orbit_init(base));
                return readOrbit(v, 0);
            },
            /** A shape moved; that of a box along the axes is a turned box. */
            transform(shape, by) {
                const type = typeOf(shape);
                writeTransform(v, types.frustum.size / 4, by);
                const moved = (types.frustum.size + types.transform.size) / 4;
                check(native.gphys_shape_transform(type, putShape(shape, 0), base + types.frustum.size, base + 4 * moved));
                return shapeAt(kindOf(type === SHAPE_AABB ? constants.SHAPE_OBB : type), moved);
            },
        };
    }

    const kindOf = (type) => Object.keys(types).find((kind) => constants[`SHAPE_${kind.toUpperCase()}`] === type);

    function shapeAt(kind, at) {
        return new Shape(kind, types[kind].read(v, at));
    }

    return {
        native, v, base, Handle, ascending, begin: memory.begin, check, common, finish, input, inputDescs, inputShapes, list, made, nothing,
        numbers, output, pass, pointer, putShape, ragged, rest, typeOf, more,
    };
}
