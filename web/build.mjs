// Builds the pages in dist/ from src/: `npm run build`. report.html is embedded in the program; verify.html becomes a page by
// `./run web`, which has the verifier for it. With --check it writes nothing and fails if the committed files are not what
// the sources give.
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const here = new URL(".", import.meta.url);
const places = { DATA: "@DUMBBELL_DATA@", VERSION: "@DUMBBELL_VERSION@", VERIFIER: "@DUMBBELL_VERIFIER@" };

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

const worker = await bundled("verifier/worker.js");

async function page(html, script, style) {
    const parts = {
        STYLE: await bundled(style),
        DARK: await bundled("dark.css"),
        SCRIPT: await bundled(script, { WORKER: JSON.stringify(worker) }),
    };
    const text = Object.values(parts).join("");
    if (/<\/(script|style)/i.test(text) || Object.values(places).some((place) => text.includes(place))) {
        throw new Error("the bundle would end its own element, or has a place of the data in it");
    }
    return (await readFile(new URL(`src/${html}`, here), "utf8")).replace(/\/\*([A-Z]+)\*\//g, (_, name) => parts[name] ?? places[name]);
}

const pages = {
    "report.html": await page("page.html", "main.js", "report.css"),
    "verify.html": await page("verifier/page.html", "verifier/page.js", "verifier/style.css"),
};
for (const [name, built] of Object.entries(pages)) {
    const target = new URL(`dist/${name}`, here);
    if (!process.argv.includes("--check")) {
        await writeFile(target, built);
        console.log(`wrote web/dist/${name} (${built.length} bytes)`);
    } else if ((await readFile(target, "utf8").catch(() => "")) === built) {
        console.log(`web/dist/${name} is what web/src gives (${built.length} bytes)`);
    } else {
        console.error(`web/dist/${name} is not what web/src gives: run \`npm ci && npm run build\` in web/`);
        process.exitCode = 1;
    }
}
