// The page: shows the files that the program put into it, or those that the prover makes here, and that come into it.
import { Ask } from "./ask.js";
import { collisionsSection } from "./collisions_section.js";
import { parseReport } from "./counts.js";
import { h, labelled, select } from "./dom.js";
import { initialSection } from "./initial_section.js";
import { licences, prover, verifier } from "./modules/jobs.js";
import { OwnStart } from "./own_start.js";
import { linkedStart, numberFrom } from "./start.js";
import { setTheme, useColours, watchTheme } from "./theme.js";

function header(data) {
    const theme = labelled("Colours", select([["auto", "as the system"], ["light", "light"], ["dark", "dark"]], "auto", setTheme));
    const links = data.files.map((file, i) => h("li", {}, h("a", { href: `#file-${i + 1}` }, file.name)));
    return h(
        "header",
        {},
        h("div", { class: "title" }, h("h1", {}, "How often can a bouncing dumbbell hit the floor?"), theme),
        h("p", {}, "Two point masses on a massless rod, or a rigid body with two contacts, bounce elastically on a flat floor, in a vertical plane, without gravity."),
        links.length > 1 && h("nav", { "aria-label": "Contents" }, h("ul", {}, links, h("li", {}, h("a", { href: "#own" }, "your own initial condition")))),
    );
}

const greatest = 1e6; // mass ratio whose orbits are soon followed

/// At the ratio of the first file, if it has one; nine collisions at q = 100, by `dumbbell trace`, too.
const firstStart = ([{ lo_text: q, hi_text } = {}]) => ({ q: q === hi_text && numberFrom(q) <= greatest ? q : "100", phi: "-1.4", phidot: "1", y: "1", ydot: "-0.8" });

function sectionOf(file, data, own, isFirst) {
    const isAlone = data.files.length === 1;
    return file.claim === "collisions"
        ? collisionsSection(file, Number(data.growth_constant), isAlone, isFirst)
        : initialSection(file, own, isAlone, isFirst);
}

const data = parseReport(document.getElementById("data").textContent);
const own = new OwnStart(firstStart(data.files));
const shown = h("div", {});

/// A section for each file; or an element that says something else.
function show(what) {
    [...shown.querySelectorAll(".outcome button")].reverse().forEach((stop) => stop.click()); // the last first: none begins
    if (what instanceof Element) {
        shown.replaceChildren(what);
        return;
    }
    useColours(what.colours);
    document.title = `dumbbell: ${what.files.length > 1 ? `${what.files.length} files` : what.files[0].name}`;
    shown.replaceChildren(
        ...what.files.map((file, i) => h("section", { id: `file-${i + 1}` }, ...sectionOf(file, what, own, i === 0).filter(Boolean))),
    );
}

watchTheme();
const ask = prover.isHere && new Ask(show, data.bodies);
document.getElementById("page").replaceChildren(
    header(data),
    ...(ask ? [ask.element, ask.bodies.element] : []),
    shown,
    own.element,
    h("footer", {}, `dumbbell ${data.version}. Pictures and motions are drawn in double precision: they illustrate. What is proved, the verifier says. `, verifier.isHere ? `A verdict rests on its source, that of dumbbell-verify, on clang and emscripten, and on this browser. ${licences}` : ""),
);
if (data.files.length > 0) {
    show(data);
}
requestAnimationFrame(() => requestAnimationFrame(() => {
    const linked = linkedStart(location.hash); // now that no map sets another start
    if (linked) {
        own.set(linked);
    }
    ask && ask.open();
    document.documentElement.dataset.drawn = String(Math.round(performance.now())); // ms since the page was asked for
}));
