// What the page's modules do, each in a worker of its own, one job after the other.

/* global WORKER */ // the text of worker.js: build.mjs

class Module {
    constructor(id) {
        this.packed = document.getElementById(id)?.textContent.trim() ?? "";
        this.isHere = this.packed !== ""; // in this page
        this.worker = null;
        this.last = Promise.resolve();
    }

    /// Unpacks and compiles it.
    start() {
        if (this.worker !== null) {
            return;
        }
        const address = URL.createObjectURL(new Blob([WORKER], { type: "text/javascript" }));
        this.worker = new Worker(address);
        URL.revokeObjectURL(address);
        this.worker.postMessage({ packed: this.packed });
    }

    /// A call of it after those before it: {promise, stop}. `input` is a list of parts of a Blob; `progress` hears what the module tells,
    /// now and then. The promise is of {answer, time}, of {failure} with what went wrong, or of {stopped: true}.
    call(name, input, { file = null, progress = () => {} } = {}) {
        let isStopped = false, stop = () => (isStopped = true);
        const run = () => new Promise((resolve) => {
            const end = (result, isBroken) => {
                if (isBroken) { // what it has of memory is gone with it
                    this.worker.terminate();
                    this.worker = null;
                }
                stop = () => {};
                resolve(result);
            };
            if (isStopped) {
                resolve({ stopped: true });
                return;
            }
            this.start();
            stop = () => end({ stopped: true }, true);
            this.worker.onmessage = ({ data }) => ("progress" in data ? progress(...data.progress) : end(data, "failure" in data));
            this.worker.onerror = (event) => {
                event.preventDefault();
                end({ failure: event.message || "the worker could not be started" }, true);
            };
            this.worker.postMessage({ name, input: new Blob(input), file });
        });
        const promise = this.last.then(run);
        this.last = promise;
        return { promise, stop: () => stop() };
    }
}

/// What this browser lacks of what the modules need.
export const missing = () => [
    ["WebAssembly with exceptions", typeof WebAssembly === "object" && "Tag" in WebAssembly],
    ["DecompressionStream", "DecompressionStream" in globalThis],
    ["workers", "Worker" in globalThis],
].flatMap(([name, isThere]) => (isThere ? [] : [name]));

export const verifier = new Module("verifier");
export const prover = new Module("prover");

export const licences = "The modules in this page contain GMP, MPFR, FLINT, Arb and Nettle, which are under the LGPL, and zlib; ./run web makes them again, from their source or from yours.";
