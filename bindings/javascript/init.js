// The library as WebAssembly, from where the program says, and when: without an await at the top of a module.
import * as constants from './lib/constants.js';
import { objects } from './lib/objects.js';
import { memory } from './lib/wasm_memory.js';

export default async function init(source) {
    return { ...constants, ...objects(await memory(source)) };
}
