// Builds dist/dumbbell.html from src/: `npm run build`. It is embedded in the program, and `./run web` puts the modules into it. With
// --check it writes nothing and fails if the committed file is not what the sources give.
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const here = new URL(".", import.meta.url);
const places = { DATA: "@DUMBBELL_DATA@", VERIFIER: "@DUMBBELL_VERIFIER@", PROVER: "@DUMBBELL_PROVER@" };

async function bundled(entry, define = {}) {
    const result = await build({
        entryPoints: [new URL(`src/${entry}`, here).pathname],
        bundle: true,
        minify: true,
        write: false,
        charset: "ascii",
        format: "iife",
        target: "es2020",
        legalComments: "inline",
        define,
    });
    return result.outputFiles[0].text.trim();
}

const parts = {
    STYLE: await bundled("report.css"),
    DARK: await bundled("dark.css"),
    SCRIPT: await bundled("main.js", { WORKER: JSON.stringify(await bundled("modules/worker.js")) }),
};
const text = Object.values(parts).join("");
if (/<\/(script|style)/i.test(text) || Object.values(places).some((place) => text.includes(place))) {
    throw new Error("the bundle would end its own element, or has a place of the data in it");
}
const built = (await readFile(new URL("src/page.html", here), "utf8")).replace(/\/\*([A-Z]+)\*\//g, (_, name) => parts[name] ?? places[name]);

const target = new URL("dist/dumbbell.html", here);
if (!process.argv.includes("--check")) {
    await writeFile(target, built);
    console.log(`wrote web/dist/dumbbell.html (${built.length} bytes)`);
} else if ((await readFile(target, "utf8").catch(() => "")) === built) {
    console.log(`web/dist/dumbbell.html is what web/src gives (${built.length} bytes)`);
} else {
    console.error("web/dist/dumbbell.html is not what web/src gives: run `npm ci && npm run build` in web/");
    process.exitCode = 1;
}
