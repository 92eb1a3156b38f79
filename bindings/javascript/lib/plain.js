// What becomes of Records and of the library's objects where plain data is meant: console.log of Node, JSON,
// structuredClone and postMessage. A clone would have no methods and no elements, and that of an object would be {}. A
// function among the fields makes cloning an error instead, whose message is the function's text.

/** Node asks this of what it prints. */
export const inspected = Symbol.for('nodejs.util.inspect.custom');

/** toJSON of Records: their elements. */
export function elements() {
    return [...this]; // Records are not cloned: post their f32.slice() or u32.slice()
}

/** toJSON of an object. */
export function noData() {
    // not cloned either: post the u32.slice() of its getSnapshot(), if it has one
    const instead = this.getSnapshot ? ': take its getSnapshot()' : '';
    throw new TypeError(`a ${this.constructor.name} is an object of the library, not data${instead}`);
}

const SHOWN = 100; // elements, as of arrays

export function showRecords(depth, options, inspect) {
    const name = `Records ${this.kind} (${this.length})`;
    if (depth < 0) return `[${name}]`;
    try {
        const first = Array.from({ length: Math.min(this.length, SHOWN) }, (_, i) => this.get(i));
        return `${name} ${inspect(first, options)}${this.length > SHOWN ? ` and ${this.length - SHOWN} more` : ''}`;
    } catch (error) {
        return `[${error.message}]`; // closed: what is printed must not throw
    }
}

const summaries = {
    Mesh: (mesh) => mesh.getInfo(),
    Scene: (scene) => ({ models: scene.getModels().length }),
    Camera: (camera) => ({ origin: camera.getOrigin(), viewport: camera.getViewport() }),
    Solver: (solver) => ({ bodies: solver.getBodies().length }),
};

/** An object in a line; of one that is closed that it is. */
export function showObject(isClosed, depth, options, inspect) {
    const { name } = this.constructor;
    if (isClosed) return `${name} (closed)`;
    if (depth < 0 || !summaries[name]) return `[${name}]`;
    return `${name} ${inspect(summaries[name](this), options)}`;
}
