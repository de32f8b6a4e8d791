// In a worker, from a blob: the page stays alive whatever a file asks for. It gets {packed}, the module, once; then {file, words} for
// each file, and answers {seconds, read, pieces} while it works, then {answer, time}, or {failure}.
import { moduleFrom, verify } from "./module.js";

const often = 100; // ms between two words about how far it is
let module;

onmessage = async ({ data }) => {
    if (data.packed) {
        module = moduleFrom(data.packed);
        return;
    }
    const reader = new FileReaderSync();
    let at = 0;
    const read = (size) => {
        const bytes = new Uint8Array(reader.readAsArrayBuffer(data.file.slice(at, at + size)));
        at += bytes.length;
        return bytes;
    };
    try {
        const compiled = await module;
        const start = performance.now();
        let told = start;
        const answer = await verify(compiled, data.words, read, (seconds, done, pieces) => {
            if (performance.now() - told > often) {
                told = performance.now();
                postMessage({ seconds, read: done, pieces });
            }
        });
        postMessage({ answer, time: (performance.now() - start) / 1000 });
    } catch (error) {
        postMessage({ failure: String(error.message ?? error) });
    }
};
