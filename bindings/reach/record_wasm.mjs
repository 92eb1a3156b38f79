// node --import this: writes the names of the WebAssembly module's functions that are called to the
// file $GAMEPHYS_CALLS, as the recorder does for the native library.
import { appendFileSync } from 'node:fs';

const called = new Set();
const instantiate = WebAssembly.instantiate;
WebAssembly.instantiate = async (...given) => {
    const made = await instantiate(...given);
    const instance = made.instance ?? made; // of a compiled module it is that alone
    const recorded = ([name, value]) => {
        if (!name.startsWith('gphys_')) return [name, value];
        return [name, (...parameters) => (called.add(name), value(...parameters))];
    };
    const exports = Object.fromEntries(Object.entries(instance.exports).map(recorded));
    return made === instance ? { exports } : { module: made.module, instance: { exports } };
};
process.on('exit', () => appendFileSync(process.env.GAMEPHYS_CALLS, [...called, ''].join('\n')));
