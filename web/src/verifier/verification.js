// Verifications in a worker, one after the other.

/* global WORKER */ // the text of worker.js: build.mjs

const held = () => document.getElementById("verifier")?.textContent.trim() ?? "";

/// Does this page contain the verifier?
export const hasVerifier = () => held() !== "";

export const licences = "The verifier in this page contains GMP, MPFR and Nettle, which are under the LGPL, and zlib; ./run web makes it again, from their source or from yours.";

let worker = null, last = Promise.resolve();

function start() {
    const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
    worker = new Worker(address);
    URL.revokeObjectURL(address);
    worker.postMessage({ packed: held() });
}

/// Verifies a file (a Blob) after those before it: {promise, stop}. `words` are options of dumbbell-verify; `progress` gets {seconds, read, pieces}
/// now and then. The promise is of {answer, time}, of {failure} with what went wrong, or of {stopped: true}.
export function verification(file, words, progress) {
    let isStopped = false, stop = () => (isStopped = true);
    const run = () => new Promise((resolve) => {
        const end = (result, isBroken) => {
            if (isBroken) { // what it has of memory is gone with it
                worker.terminate();
                worker = null;
            }
            stop = () => {};
            resolve(result);
        };
        if (isStopped) {
            resolve({ stopped: true });
            return;
        }
        if (worker === null) {
            start();
        }
        stop = () => end({ stopped: true }, true);
        worker.onmessage = ({ data }) => ("answer" in data || "failure" in data ? end(data, "failure" in data) : progress(data));
        worker.onerror = (event) => {
            event.preventDefault();
            end({ failure: event.message || "the worker could not be started" }, true);
        };
        worker.postMessage({ file, words });
    });
    const promise = last.then(run);
    last = promise;
    return { promise, stop: () => stop() };
}
