// The library for Node, through koffi. Its functions are built here from api.json, which is generated
// from the C header: a method for each function of an object, a plain function for the others.
'use strict';
const koffi = require('koffi');
const api = require('./api.json');

const names = { win32: 'gamephys.dll', darwin: 'libgamephys.1.dylib' };
const library = koffi.load(process.env.GAMEPHYS_LIBRARY || names[process.platform] || 'libgamephys.so.1');
const width = koffi.sizeof('void *') === 8 ? 0 : 1; // which column of sizes and offsets holds
const NUMBERS = { float: 'Float32', double: 'Float64', int32_t: 'Int32', uint32_t: 'Uint32' };
const { OK, INCOMPLETE, ALL_LAYERS } = api.constants;

// --- errors ---------------------------------------------------------------------------------

/** A call failed: the message is the library's, status its number. */
class GamephysError extends Error {
    constructor(status) {
        super(lastError());
        this.name = 'GamephysError';
        this.status = status;
    }
}

const lastError = library.func('gphys_last_error', 'str', []);

function check(status) {
    if (status < 0) throw new GamephysError(status);
    return status;
}

// --- structs <-> plain objects --------------------------------------------------------------

function sizeOf(of) {
    if (of === 'double') return 8;
    return of in NUMBERS ? 4 : api.structs[of].size[width];
}

/** Write a value: a number, an array of a struct's numbers or fields in order, or an object. */
function pack(view, offset, of, value) {
    if (of in NUMBERS) {
        if (typeof value !== 'number') throw new TypeError(`expected a number, got ${value}`);
        view[`set${NUMBERS[of]}`](offset, value, true);
        return;
    }
    const fields = api.structs[of].fields;
    if (fields.length === 1 && fields[0].count > 1 && value.length === fields[0].count) value = [value]; // a matrix
    const inOrder = Array.isArray(value) || ArrayBuffer.isView(value);
    if (inOrder && value.length !== fields.length) throw new TypeError(`${of} has ${fields.length} fields`);
    fields.forEach((field, index) => {
        const given = inOrder ? value[index] : value[field.name];
        if (given === undefined) throw new TypeError(`${of}.${field.name} is missing`);
        if (field.of.includes('*')) return;
        for (let i = 0; i < field.count; ++i) {
            const item = field.count > 1 ? given[i] : given;
            pack(view, offset + field.offset[width] + i * sizeOf(field.of), field.of, item);
        }
    });
}

/** Read a value; structs of a few floats of one meaning become arrays. */
function unpack(view, offset, of) {
    if (of in NUMBERS) return view[`get${NUMBERS[of]}`](offset, true);
    const fields = api.structs[of].fields;
    const read = (field) => {
        if (field.of.includes('*')) return null;
        const at = (i) => unpack(view, offset + field.offset[width] + i * sizeOf(field.of), field.of);
        return field.count > 1 ? Array.from({ length: field.count }, (_, i) => at(i)) : at(0);
    };
    if (of === 'gphys_mat4') return read(fields[0]);
    if (of === 'gphys_vec3' || of === 'gphys_quat') return fields.map(read);
    return Object.fromEntries(fields.map((field) => [field.name, read(field)]));
}

/** Results of a batch: one view for each type of number over the same memory, and objects on demand. */
class Records {
    constructor(of, length, memory = new ArrayBuffer(length * sizeOf(of)), start = 0) {
        this.of = of;
        this.length = length;
        this.stride = sizeOf(of);
        const numbers = (length * this.stride) / 4;
        this.f32 = new Float32Array(memory, start, numbers);
        this.u32 = new Uint32Array(memory, start, numbers);
        this.i32 = new Int32Array(memory, start, numbers);
        if (of === 'double') this.f64 = new Float64Array(memory, start, length);
    }
    get(index) {
        if (!(index >= 0 && index < this.length)) throw new RangeError(`no element ${index}`);
        return unpack(new DataView(this.f32.buffer), this.f32.byteOffset + index * this.stride, this.of);
    }
    slice(length) {
        return new Records(this.of, length, this.f32.buffer, this.f32.byteOffset);
    }
}

function packed(of, value) {
    const memory = new ArrayBuffer(sizeOf(of));
    pack(new DataView(memory), 0, of, value);
    return memory;
}

/** A desc with the library's defaults and the fields given. */
function desc(of, fields) {
    const memory = new ArrayBuffer(sizeOf(of));
    check(functions[`${of}_init`](memory, memory.byteLength));
    const view = new DataView(memory);
    for (const [name, value] of Object.entries(fields)) {
        const field = api.structs[of].fields.find((f) => f.name === name);
        if (!field) throw new TypeError(`${of} has no field ${name}`);
        pack(view, field.offset[width], field.of, value);
    }
    return memory;
}

// --- shapes ---------------------------------------------------------------------------------

class Shape {
    constructor(kind, memory, stride = 0, length) {
        this.type = api.constants[`SHAPE_${kind.toUpperCase()}`];
        this.pointer = memory;
        this.stride = stride;
        this.length = length; // undefined: one that stands for each of a batch
    }
}

function shapeOf(shape) {
    if (shape instanceof Mesh) return { type: api.constants.SHAPE_MESH, pointer: shape.pointer, stride: 0 };
    if (!(shape instanceof Shape)) throw new TypeError('not a shape');
    return shape;
}

/** Many shapes of one kind from rows of floats: shapes('sphere', Float32Array). */
function shapes(kind, data) {
    const size = sizeOf(`gphys_${kind}`);
    if (data.byteLength % size) throw new RangeError(`not a whole number of ${kind}s`);
    return new Shape(kind, data, size, data.byteLength / size);
}

// --- objects --------------------------------------------------------------------------------

/** Owns one object of the library: freed by close(), or when it is no longer reachable. */
class Handle {
    #pointer;
    #destroy;
    static #registry = new FinalizationRegistry(([destroy, pointer]) => destroy(pointer));
    constructor(destroy, pointer) {
        this.#pointer = pointer;
        this.#destroy = destroy;
        Handle.#registry.register(this, [destroy, pointer], this);
    }
    get pointer() {
        if (this.#pointer === null) throw new GamephysClosed(`${this.constructor.name} is closed`);
        return this.#pointer;
    }
    close() {
        if (this.#pointer === null) return;
        Handle.#registry.unregister(this);
        this.#destroy(this.#pointer);
        this.#pointer = null;
    }
}
if (Symbol.dispose) Handle.prototype[Symbol.dispose] = Handle.prototype.close;

/** An object was used after close(). */
class GamephysClosed extends Error {}

// --- calls ----------------------------------------------------------------------------------

const POINTERS = ['in', 'array', 'shape', 'out', 'out_array', 'list', 'ragged', 'total', 'offsets', 'new'];

function nativeType(parameter) {
    if (parameter.role === 'handle') return 'uintptr_t';
    return POINTERS.includes(parameter.role) ? 'void *' : parameter.of;
}

const functions = {};
for (const name of api.inits) functions[name] = library.func(name, 'int32_t', name === 'gphys_orbit_init' ? ['void *'] : ['void *', 'uint32_t']);

/** An array of a given number of elements, such as an origin. */
function typed(parameter, value) {
    if (value.length !== parameter.count) throw new RangeError(`${parameter.name} has ${parameter.count} numbers`);
    return parameter.of === 'double' ? Float64Array.from(value) : Float32Array.from(value);
}

const made = new BigUint64Array(1); // where a create function puts its object

/** A JavaScript function for a described C function; `this` is the object, if it has one. */
function build(call) {
    const native = library.func(call.c, 'int32_t', call.parameters.map(nativeType));
    const { parameters, inputs } = call;
    const listed = parameters.find((p) => p.role === 'list' || p.role === 'ragged');

    return function (...given) {
        const values = Object.fromEntries(inputs.map((name, i) => [name, given[i]]));
        if ('layers' in values && values.layers === undefined) values.layers = ALL_LAYERS;
        const out = given[inputs.length];
        const prepared = {};
        let count;
        const same = (length) => {
            if (count !== undefined && count !== length) throw new RangeError('arrays of different lengths');
            count = length;
        };
        for (const p of parameters) {
            const value = values[p.name];
            if (p.of === 'void') {
                const shape = shapeOf(value);
                prepared[p.name] = { pointer: shape.pointer, stride: shape.stride, type: shape.type };
                if (shape.length !== undefined) same(shape.length);
            } else if (p.role === 'in') {
                const none = value === undefined || value === null;
                if (p.count) prepared[p.name] = typed(p, value);
                else prepared[p.name] = none ? null : p.of.endsWith('_desc') ? desc(p.of, value) : packed(p.of, value);
            } else if (p.role === 'array') {
                if (value === undefined || value === null) {
                    prepared[p.name] = { pointer: null, stride: 0, length: 0, numbers: 0 };
                    continue;
                }
                const numbers = value instanceof Records ? value.f32 : value;
                if (!ArrayBuffer.isView(numbers)) throw new TypeError(`${p.name} must be a typed array`);
                const size = sizeOf(p.of) * (p.width || 1);
                if (numbers.byteLength % size) throw new RangeError(`${p.name} is not a whole number of elements`);
                prepared[p.name] = { pointer: numbers, stride: size, length: numbers.byteLength / size, numbers: numbers.length };
                if (parameters.some((q) => q.name === 'count')) same(prepared[p.name].length);
            }
        }
        const results = [];
        const memory = (p, length) => {
            if (out !== undefined && p.role === 'out_array') {
                if (out.byteLength !== length * sizeOf(p.of)) throw new RangeError('out has another length');
                return new Records(p.of, length, out.buffer, out.byteOffset);
            }
            return new Records(p.of, length);
        };
        let previous, lastArray;
        const args = parameters.map((p, i) => {
            const before = previous;
            previous = p;
            switch (p.role) {
                case 'handle': {
                    if (i === 0 && call.owner) return this.pointer;
                    const object = values[p.name];
                    return object === null || object === undefined ? 0 : object.pointer;
                }
                case 'shape_type': return prepared[parameters[i + 1].name].type;
                case 'shape': return prepared[p.name].pointer;
                case 'in': return prepared[p.name];
                case 'array': lastArray = p.name; return prepared[p.name].pointer;
                case 'stride': return before.role === 'out_array' ? sizeOf(before.of) : prepared[before.name].stride;
                case 'count':
                    if (p.name === 'index_count') return prepared[lastArray].numbers;
                    if (p.name !== 'count') return prepared[lastArray].length;
                    if (p.name in values) count = values.count;
                    if (count === undefined) throw new RangeError('no array says how many there are');
                    return count;
                case 'out': {
                    const records = memory(p, p.count || 1);
                    results.push([p, records]);
                    return records.f32;
                }
                case 'out_array': {
                    const records = memory(p, p.length ? values.width * values.height : count);
                    results.push([p, records]);
                    return records.f32;
                }
                case 'scalar': return values[p.name] === true ? 1 : values[p.name] === false ? 0 : values[p.name];
                case 'new': return made;
                default: return null; // of a list: filled by fetchList
            }
        });
        if (listed) return fetchList(native, args, parameters, listed, count);
        if (check(native(...args)) !== OK && call.mayMiss) return null;
        const values_ = results.map(([p, records]) => {
            if (p.role === 'out_array' || p.count) return records;
            const value = records.get(0);
            return p.of === 'int32_t' && p.name !== 'out_side' ? value !== 0 : value;
        });
        return values_.length > 1 ? values_ : values_[0];
    };
}

/** All results of a call that fills a caller's array, which is made larger if it has to be. */
function fetchList(invoke, args, parameters, listed, count) {
    const at = (role) => parameters.findIndex((p) => p.role === role);
    const totals = new Uint32Array(listed.role === 'ragged' ? count + 1 : 1);
    args[at(listed.role === 'ragged' ? 'offsets' : 'total')] = totals;
    for (let capacity = Math.max(64, count || 0); ; capacity = totals[totals.length - 1]) {
        const records = new Records(listed.of, capacity);
        args[at(listed.role)] = records.f32;
        args[at('capacity')] = capacity;
        if (check(invoke(...args)) === INCOMPLETE) continue;
        const values = records.slice(totals[totals.length - 1]);
        return listed.role === 'ragged' ? { values, offsets: totals } : values;
    }
}

const exported = { ...api.constants, GamephysError, GamephysClosed, Records, shapes };
for (const [name, creation] of Object.entries(api.creations)) {
    const destroy = library.func(api.destroys[name], 'void', ['uintptr_t']);
    const create = build(creation);
    exported[name] = {
        [name]: class extends Handle {
            constructor(...given) {
                create(...given);
                super(destroy, made[0]);
            }
        },
    }[name];
}
const { Mesh } = exported;
for (const call of api.calls) {
    const target = call.owner ? exported[call.owner].prototype : exported;
    target[call.name] = build(call);
}
for (const kind of api.shapes) {
    exported[kind] = (...fields) => new Shape(kind, packed(`gphys_${kind}`, fields));
}

/** The orbit settings that the library starts from. */
exported.defaultOrbit = () => {
    const memory = new ArrayBuffer(sizeOf('gphys_orbit'));
    check(functions.gphys_orbit_init(memory));
    return unpack(new DataView(memory), 0, 'gphys_orbit');
};
module.exports = exported;
