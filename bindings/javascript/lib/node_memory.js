// In Node: the native library if koffi and the library are there, else WebAssembly. A library that GAMEPHYS_LIBRARY names
// has to be there.
import { memory as native } from './native_memory.js';
import { memory as wasm } from './wasm_beside.js';

export async function memory() {
    try {
        return native();
    } catch (error) {
        if (process.env.GAMEPHYS_LIBRARY) throw error;
        return wasm().catch((second) => {
            const [first] = error.message.split('\n');
            throw new Error(`no gamephys library: not as a native one (${first}), nor as WebAssembly (${second.message})`, { cause: second });
        });
    }
}
