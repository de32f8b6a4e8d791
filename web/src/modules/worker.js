// In a worker, from a blob: the page stays alive whatever a file asks for. It gets {packed}, the module, once; then {name, input, file},
// a call and its Blobs, and answers {progress} while it works, then {answer, time}, or {failure}.
import { call, moduleFrom } from "./module.js";

const often = 100; // ms between two words about how far it is
let module;

onmessage = async ({ data }) => {
    if (data.packed) {
        module = moduleFrom(data.packed);
        module.catch(() => {}); // said with the first call
        return;
    }
    const reader = new FileReaderSync();
    const bytes = (blob) => new Uint8Array(reader.readAsArrayBuffer(blob));
    let at = 0;
    const read = (size) => {
        const next = bytes(data.file.slice(at, at + size));
        at += next.length;
        return next;
    };
    try {
        const compiled = await module;
        const start = performance.now();
        let told = start;
        const answer = await call(compiled, data.name, bytes(data.input), (...progress) => {
            if (performance.now() - told > often) {
                told = performance.now();
                postMessage({ progress });
            }
        }, read);
        postMessage({ answer, time: (performance.now() - start) / 1000 });
    } catch (error) {
        postMessage({ failure: String(error.message ?? error) });
    }
};
