// The library as a native one, through koffi: its functions reach typed arrays where they are.
import { createRequire } from 'node:module';
import { PASS_BYTES, Records, viewsOf } from './runtime.js';
import { signatures } from './signatures.js';

const FILES = { win32: 'gamephys.dll', darwin: 'libgamephys.1.dylib' };
const TYPES = { v: 'void', s: 'str', f: 'float', d: 'double', i: 'int32_t', u: 'uint32_t', z: 'size_t', p: 'uintptr_t', a: 'void *' };

export function memory() {
    const koffi = createRequire(import.meta.url)('koffi'); // require also looks at $NODE_PATH
    const library = koffi.load(process.env.GAMEPHYS_LIBRARY || FILES[process.platform] || 'libgamephys.so.1');
    const native = {};
    for (const [name, [result, ...parameters]] of Object.entries(signatures)) {
        native[name] = library.func(name, TYPES[result], parameters.map((letter) => TYPES[letter]));
    }
    const place = koffi.alloc('uint8_t', PASS_BYTES);
    const views = viewsOf(koffi.view(place, PASS_BYTES), 0, PASS_BYTES);
    views.wide = koffi.sizeof('void *') === 8;
    let list = new Uint8Array(0);
    const held = [];

    return {
        native, views,
        base: Number(koffi.address(place)),
        text: (value) => value,
        begin() {
            while (held.length > 0) koffi.free(held.pop());
        },
        locate() {},
        hold(view) {
            const copy = koffi.alloc('uint8_t', view.byteLength);
            held.push(copy);
            new Uint8Array(koffi.view(copy, view.byteLength)).set(new Uint8Array(view.buffer, view.byteOffset, view.byteLength));
            return Number(koffi.address(copy));
        },
        pass: (array) => array.view,
        nowhere: (address) => (address === 0 ? null : koffi.as(BigInt(address), 'void *')),
        finish() {},
        room(bytes) {
            if (bytes > list.byteLength) list = new Uint8Array(2 * bytes);
            return { argument: list, bytes: list.byteLength };
        },
        take: (room, bytes) => room.argument.buffer.slice(0, bytes),
        records: (kind, length) => new Records(kind, length),
    };
}
