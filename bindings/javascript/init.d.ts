/** Everything that `import * as gp from 'gamephys'` gives, as WebAssembly from where you say. Each call makes a library with
 *  a memory of its own: objects of one are not known to another.
 *  @param source - gamephys.wasm: its URL, the response to a fetch of it, its bytes, or the compiled module */
export default function init(source: Source | Promise<Source>): Promise<typeof import('./index.js')>;
export type Source = string | URL | Response | ArrayBuffer | ArrayBufferView | WebAssembly.Module;
