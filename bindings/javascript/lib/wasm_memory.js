// The library as WebAssembly: its functions reach only the memory of the instance. Arrays that are
// there already are passed as they are, others are copied in and results out.
import { PASS_BYTES, GamephysClosed, GamephysError, Records, viewsOf } from './runtime.js';
import { ERROR_OUT_OF_MEMORY } from './constants.js';

const NOT_SUPPORTED = 58; // WASI's errno ENOTSUP

/** Of a URL, a response, bytes, a module, or a promise of one of these. */
async function instantiate(source, imports) {
    const given = await (typeof source === 'string' || source instanceof URL ? fetch(source) : source);
    if (given == null) throw new TypeError('gamephys.wasm: its URL, response, bytes or module is missing');
    if (given instanceof WebAssembly.Module) return WebAssembly.instantiate(given, imports);
    if (!(given instanceof Response)) return (await WebAssembly.instantiate(given, imports)).instance;
    if (!given.ok) throw new Error(`${given.url}: ${given.status} ${given.statusText}`);
    const typed = given.headers.get('Content-Type') === 'application/wasm';
    const { instance } = await (typed ? WebAssembly.instantiateStreaming(given, imports) : WebAssembly.instantiate(await given.arrayBuffer(), imports));
    return instance;
}

export async function memory(source) {
    const views = { wide: false };
    let native, base;
    /** Memory has grown: views of it as it was have no elements any more. */
    const renew = () => Object.assign(views, viewsOf(native.memory.buffer, base, PASS_BYTES));

    const instance = await instantiate(source, {
        env: { emscripten_notify_memory_growth: () => base && renew(), __call_sighandler() {} },
        // It asks a system for the environment, and there is none, and for the time where several threads work, and there
        // is one.
        wasi_snapshot_preview1: {
            clock_time_get: () => NOT_SUPPORTED,
            environ_sizes_get: () => NOT_SUPPORTED,
            environ_get: () => NOT_SUPPORTED,
            proc_exit(code) {
                throw new Error(`the module ended with ${code}`);
            },
        },
    });
    native = instance.exports;
    native._initialize();

    function allocate(bytes) {
        const address = native.malloc(bytes);
        if (address === 0) throw new GamephysError(`no memory for ${bytes} bytes`, ERROR_OUT_OF_MEMORY);
        return address;
    }
    base = allocate(PASS_BYTES);
    renew();

    // Arrays of one call lie in blocks. The last block, the largest, is kept for the next call.
    let blocks = [{ address: allocate(1 << 16), bytes: 1 << 16 }];
    let used = 0;
    function block(bytes) {
        const { address, bytes: all } = blocks.at(-1);
        if (used + bytes > all) {
            const more = Math.max(2 * all, bytes);
            blocks.push({ address: allocate(more), bytes: more });
            used = 0;
            return block(bytes);
        }
        const start = address + used;
        used = (used + bytes + 15) & ~15;
        return start;
    }

    const registry = new FinalizationRegistry((address) => native.free(address));

    /** Records in the memory of the instance. Their views are made again when it has grown. */
    class OwnRecords extends Records {
        #address;
        #views;
        constructor(kind, length, address) {
            super(kind, length, null);
            this.#address = address ?? allocate(Math.max(8, length * this.stride));
            if (address !== undefined) return;
            registry.register(this, this.#address, this);
            this.u32.fill(0); // memory that was freed keeps what was in it
        }
        get views() {
            if (this.#address === 0) throw new GamephysClosed('Records');
            if (this.#views?.f32.buffer !== native.memory.buffer) {
                this.#views = viewsOf(native.memory.buffer, this.#address, this.length * this.stride);
            }
            return this.#views;
        }
        close() {
            if (this.#address === 0) return;
            if (registry.unregister(this)) native.free(this.#address);
            this.#address = 0;
        }
    }

    const bytesOf = (view) => new Uint8Array(view.buffer, view.byteOffset, view.byteLength);
    const text = new TextDecoder();

    return {
        native, views, base,
        text(address) {
            const bytes = new Uint8Array(native.memory.buffer);
            return text.decode(bytes.subarray(address, bytes.indexOf(0, address)));
        },
        begin() {
            while (blocks.length > 1) native.free(blocks.shift().address);
            used = 0;
        },
        hold(view) {
            if (view.buffer === native.memory.buffer) return view.byteOffset;
            const copy = block(view.byteLength);
            new Uint8Array(native.memory.buffer).set(bytesOf(view), copy);
            return copy;
        },
        locate: (view) => (view.buffer === native.memory.buffer ? view.byteOffset : undefined),
        pass(array) {
            if (array.address !== undefined) return array.address;
            array.copy = block(array.view.byteLength);
            if (!array.out) new Uint8Array(native.memory.buffer).set(bytesOf(array.view), array.copy);
            return array.copy;
        },
        nowhere: (address) => address,
        finish({ view, copy }) {
            if (copy !== undefined) bytesOf(view).set(new Uint8Array(native.memory.buffer, copy, view.byteLength));
        },
        room(bytes) {
            const argument = block(bytes);
            const { address, bytes: all } = blocks.at(-1);
            used = all;
            return { argument, bytes: address + all - argument };
        },
        take: ({ argument }, bytes) => native.memory.buffer.slice(argument, argument + bytes),
        records: (kind, length, address) => new OwnRecords(kind, length, address),
    };
}
