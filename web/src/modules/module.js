// Verifier and prover: WebAssembly modules, and the few things of a system that they ask for. The same in a page's worker and under node.

/// base64 of a module, packed by gzip, as it stands in a page.
export async function moduleFrom(text) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

/// Words as a module takes them.
export const lines = (words) => new TextEncoder().encode(words.map((word) => `${word}\n`).join(""));

const noFile = 8; // WASI's "bad file descriptor"
const none = new Uint8Array();

/// Calls `verify`, `certify` or `show` in an instance of its own, with the bytes that it takes (web/modules), and gives its answer, JSON.
/// `read(size)` gives the next bytes of the file that is verified, none at its end; `progress` hears how far it is: of `verify`
/// (seconds, read, pieces), of `certify` (done, total). Throws if memory or the stack is used up.
export async function call(module, name, input, progress, read = () => none) {
    const time = () => BigInt(Math.round(performance.now() * 1e6));
    const view = () => new DataView(memory.buffer);
    const wasi = {
        fd_read(file, list, count, done) {
            const room = view();
            const [at, size] = [room.getUint32(list, true), room.getUint32(list + 4, true)];
            if (file !== 0 || count < 1) {
                return noFile;
            }
            const bytes = read(size);
            new Uint8Array(memory.buffer).set(bytes, at);
            room.setUint32(done, bytes.length, true);
            return 0;
        },
        fd_close: () => 0,
        clock_time_get(clock, precision, at) {
            view().setBigUint64(at, time(), true);
            return 0;
        },
    };
    const refuse = { get: (known, word) => known[word] ?? (() => noFile) };
    const { exports } = await WebAssembly.instantiate(module, {
        page: { progress },
        wasi_snapshot_preview1: new Proxy(wasi, refuse),
    });
    const { memory } = exports;
    exports._initialize();
    const room = exports.room_for(input.length); // memory may have grown: its views come behind
    new Uint8Array(memory.buffer).set(input, room);
    const begin = exports[name]();
    const bytes = new Uint8Array(memory.buffer);
    return new TextDecoder().decode(bytes.subarray(begin, bytes.indexOf(0, begin)));
}
