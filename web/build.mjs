// Builds dist/report.html, the one file that the program embeds, from src/: `npm run build`. With --check it
// writes nothing and fails if the committed file is not what the sources give.
import { readFile, writeFile } from "node:fs/promises";
import { build } from "esbuild";

const here = new URL(".", import.meta.url);
const target = new URL("dist/report.html", here);
const place = "@DUMBBELL_DATA@";

async function bundled(entry) {
    const result = await build({
        entryPoints: [new URL(entry, here).pathname],
        bundle: true,
        minify: true,
        write: false,
        charset: "ascii",
        format: "iife",
        target: "es2020",
        legalComments: "inline",
    });
    return result.outputFiles[0].text.trim();
}

async function page() {
    const [html, script, style, dark] = await Promise.all([
        readFile(new URL("src/page.html", here), "utf8"),
        bundled("src/main.js"),
        bundled("src/style.css"),
        bundled("src/dark.css"),
    ]);
    if (/<\/(script|style)/i.test(script + style + dark) || script.includes(place)) {
        throw new Error("the bundle would end its own element, or has the place of the data in it");
    }
    // Functions: a `$` in the code is no pattern.
    return html
        .replace("/*STYLE*/", () => style)
        .replace("/*DARK*/", () => dark)
        .replace("/*SCRIPT*/", () => script)
        .replace("/*DATA*/", () => place);
}

const built = await page();
if (process.argv.includes("--check")) {
    const committed = await readFile(target, "utf8").catch(() => "");
    if (committed !== built) {
        console.error("web/dist/report.html is not what web/src gives: run `npm ci && npm run build` in web/");
        process.exit(1);
    }
    console.log(`web/dist/report.html is what web/src gives (${built.length} bytes)`);
} else {
    await writeFile(target, built);
    console.log(`wrote web/dist/report.html (${built.length} bytes)`);
}
