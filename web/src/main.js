// The page: reads the data that the program put into it, and makes a section for each file.
import { collisionsSection } from "./collisions_section.js";
import { parseReport } from "./counts.js";
import { h, labelled, select } from "./dom.js";
import { initialSection } from "./initial_section.js";
import { OwnStart } from "./own_start.js";
import { linkedStart, numberFrom } from "./start.js";
import { setTheme, useColours, watchTheme } from "./theme.js";
import { hasVerifier, licences } from "./verifier/verification.js";

function header(data) {
    const theme = labelled("Colours", select([["auto", "as the system"], ["light", "light"], ["dark", "dark"]], "auto", setTheme));
    const links = data.files.map((file, i) => h("li", {}, h("a", { href: `#file-${i + 1}` }, file.name)));
    return h(
        "header",
        {},
        h("div", { class: "title" }, h("h1", {}, "How often can a bouncing dumbbell hit the floor?"), theme),
        h("p", {}, "Two point masses on a massless rod", data.bodies && ", or a rigid body with two contacts,", " bounce elastically on a flat floor, in a vertical plane, without gravity. This report shows what ", data.files.length === 1 ? "a file claims" : `${data.files.length} files claim`, " about their collisions. ", hasVerifier() ? "It contains the verifier, and runs it here, on each file, without a network." : "It does not verify anything: each file comes with the command that does."),
        h("nav", { "aria-label": "Contents" }, h("ul", {}, links, h("li", {}, h("a", { href: "#own" }, "your own initial condition")))),
    );
}

const greatest = 1e6; // mass ratio whose orbits are soon followed

/// At the ratio of the first file, if it has one; nine collisions at q = 100, by `dumbbell trace`, too.
const firstStart = ([{ lo_text: q, hi_text }]) => ({ q: q === hi_text && numberFrom(q) <= greatest ? q : "100", phi: "-1.4", phidot: "1", y: "1", ydot: "-0.8" });

function sectionOf(file, data, own, isFirst) {
    const isAlone = data.files.length === 1;
    return file.claim === "collisions"
        ? collisionsSection(file, Number(data.growth_constant), isAlone, isFirst)
        : initialSection(file, own, isAlone, isFirst);
}

const data = parseReport(document.getElementById("data").textContent);
useColours(data.colours);
watchTheme();
const own = new OwnStart(firstStart(data.files));
document.title = `dumbbell report: ${data.files.length > 1 ? `${data.files.length} files` : data.files[0].name}`;
document.getElementById("page").replaceChildren(
    header(data),
    data.bodies && h("figure", { class: "wide" }, h("img", { src: `data:image/svg+xml,${encodeURIComponent(data.bodies)}`, alt: "The bodies of the files in the plane of rho and Q, coloured by their greatest number of collisions", style: "max-width: 100%" }),
        h("figcaption", {}, "What the files claim, among all rigid bodies that touch the floor with two points, by \u03c1 = d2/d1 and Q = (d1/k)\u00b2: the contacts are at the distances d1 \u2265 d2 from the centre of mass, and k is the radius of gyration. Massless dumbbells are on the edge Q\u03c1 = 1.")),
    ...data.files.map((file, i) => h("section", { id: `file-${i + 1}` }, h("p", { class: "filename" }, file.name), ...sectionOf(file, data, own, i === 0).filter(Boolean))),
    own.element,
    h("footer", {}, `dumbbell ${data.version}. Pictures and motions are drawn in double precision: they illustrate. What is claimed is in the files; what is proved, the verifier says.`, hasVerifier() ? ` ${licences}` : ""),
);
requestAnimationFrame(() => requestAnimationFrame(() => {
    const linked = linkedStart(location.hash); // now that no map sets another start
    if (linked) {
        own.set(linked);
    }
    document.documentElement.dataset.drawn = String(Math.round(performance.now())); // ms since the page was asked for
}));
