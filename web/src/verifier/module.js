// The verifier: dumbbell-verify as a WebAssembly module, and the few things of a system that it asks for. The same in a page's worker and
// under node.

/// base64 of the module, packed by gzip, as it stands in a page.
export async function moduleFrom(text) {
    const packed = Uint8Array.from(atob(text), (c) => c.charCodeAt(0));
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

const noFile = 8; // WASI's "bad file descriptor"

/// Verifies one file, in an instance of its own. `read(size)` gives the file's next bytes, none at its end; `words` are options of
/// dumbbell-verify that state a claim or say what it may cost; `progress(seconds, read, pieces)` hears how far it is.
/// Gives {line, sentence, result}, or {usage}: what is wrong with the words. Throws if memory or the stack is used up.
export async function verify(module, words, read, progress) {
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
    const refuse = { get: (known, name) => known[name] ?? (() => noFile) };
    const { exports } = await WebAssembly.instantiate(module, {
        page: { progress },
        wasi_snapshot_preview1: new Proxy(wasi, refuse),
    });
    const { memory } = exports;
    exports._initialize();
    const options = new TextEncoder().encode(words.map((word) => `${word}\n`).join(""));
    const room = exports.options(options.length); // memory may have grown: its views come behind
    new Uint8Array(memory.buffer).set(options, room);
    const begin = exports.verify();
    const bytes = new Uint8Array(memory.buffer);
    return JSON.parse(new TextDecoder().decode(bytes.subarray(begin, bytes.indexOf(0, begin))));
}
