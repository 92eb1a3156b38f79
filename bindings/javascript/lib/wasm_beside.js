// The library as WebAssembly, from the file of this package. Bundlers know it by this form of its URL.
import { memory as wasm } from './wasm_memory.js';

export async function memory() {
    const url = new URL('../gamephys.wasm', import.meta.url);
    if (url.protocol !== 'file:') return wasm(url);
    const files = 'node:fs/promises'; // not in the call itself: bundlers for pages look for what is named there
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ files);
    return wasm(readFile(url));
}
