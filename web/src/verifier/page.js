// verify.html: choose or drop certificates, state a claim, and see what is proved.
import { h, labelled, select } from "../dom.js";
import { setTheme, watchTheme } from "../theme.js";
import { verified } from "./outcome.js";
import { licences } from "./verification.js";

let files = [];
const results = h("section", { class: "results", "aria-label": "Results", hidden: true });

const bounds = [["--max", "at most"], ["--min", "at least"], ["--exactly", "exactly"]];
const scenes = [["dumbbell", "the dumbbell"], ["body", "a rigid body"]];
const budgets = [["30s", "30 s"], ["10m", "10 min"], ["2h", "2 h"]];

/// The value of the option --ID.
const field = (id, label, hint, size) => h("span", { class: "labelled" }, h("label", { for: id }, label), h("input", { type: "text", id, size, placeholder: hint, autocomplete: "off", spellcheck: "false" }));
const value = (element) => element.lastChild.value.trim();
const radio = (value, text, isChecked) => h("label", { class: "labelled" }, h("input", { type: "radio", name: "claim", value, checked: isChecked }), h("span", {}, text));

const bound = select(bounds, "--max", () => {});
const scene = select(scenes, "dumbbell", () => {});
const budget = select(budgets, "30s", () => {});
const theirs = radio("file", "what the file itself claims", true);
const mine = radio("own", "this claim:", false);
const own = mine.firstChild;
const massless = [field("ratio", "at mass ratio (or LO:HI)", "10, 1:100, 4/3", 12)];
const bodies = [field("inertia", "with Q (or LO:HI)", "4", 8), field("rho", "and rho", "1", 8)];
const count = field("count", "N =", "4", 8), more = field("more", "and", "--gap 1e-6 --gaps 8", 20);
const claim = h(
    "p",
    { class: "controls" },
    labelled("Of", scene),
    massless,
    bodies,
    labelled("the greatest number of collisions is", bound),
    count,
    more,
);

const system = () => (scene.value === "body" ? bodies : massless);

/// A verdict is about the claim that was judged: an edited one has none yet.
function edited() {
    for (const element of [...massless, ...bodies]) {
        element.hidden = !system().includes(element);
    }
    claim.hidden = !own.checked;
    show();
}

/// The claim as options of dumbbell-verify.
function words() {
    const cost = ["--budget", budget.value];
    if (!own.checked) {
        return cost;
    }
    const given = [...system().map((element) => [`--${element.lastChild.id}`, value(element)]), [bound.value, value(count)]];
    return [...cost, "--scene", scene.value, ...given.filter(([, text]) => text !== "").flat(), ...value(more).split(/\s+/).filter(Boolean)];
}

function show(...elements) {
    stopAll();
    results.hidden = elements.length === 0;
    results.replaceChildren(...elements);
}

function verifyAll() {
    if (own.checked && value(count) + value(more) === "") {
        return show(h("p", { role: "alert" }, "Your claim has no number: give N, or what else must be proved."));
    }
    const options = words();
    show(...files.map((file) => h("article", {}, h("h2", {}, file.name), verified(file, options))));
}

function stopAll() {
    for (const button of [...results.querySelectorAll("button")].reverse()) {
        button.click();
    }
}

function take(list) {
    if (list.length > 0) {
        files = [...list];
        verifyAll();
    }
}

const chooser = h("input", { type: "file", id: "files", multiple: true, onchange: () => take(chooser.files) });

function watchDrops() {
    const over = (is) => document.documentElement.classList.toggle("dropping", is);
    addEventListener("dragover", (event) => {
        event.preventDefault();
        over(true);
    });
    addEventListener("dragleave", (event) => event.relatedTarget === null && over(false));
    addEventListener("drop", (event) => {
        event.preventDefault();
        over(false);
        take(event.dataTransfer.files);
    });
}

const theme = labelled("Colours", select([["auto", "as the system"], ["light", "light"], ["dark", "dark"]], "auto", setTheme));
const version = document.getElementById("version").textContent;
document.getElementById("page").replaceChildren(
    h(
        "header",
        {},
        h("div", { class: "title" }, h("h1", {}, "Is it proved? How often a bouncing dumbbell can hit the floor"), theme),
        h("p", {}, "This page contains the verifier of dumbbell, dumbbell-verify, and runs it here: it needs no network, and no file leaves this computer. Choose certificates (.dbc or .dbc.gz), or drop them anywhere on the page."),
    ),
    h(
        "form",
        { class: "verify", oninput: edited, onsubmit: (event) => (event.preventDefault(), verifyAll()) },
        h("p", { class: "chooser" }, h("label", { for: "files" }, "Certificates "), chooser),
        h("fieldset", {}, h("legend", {}, "To be proved"), h("p", { class: "controls" }, theirs, mine), claim),
        h("p", { class: "controls" }, labelled("Give up on a file that asks for more work than", budget), h("button", { type: "submit" }, "Verify")),
        h("p", { class: "note" }, "A claim of yours is the safer question: a file that proves less, or something else, is then rejected. The time is that of the native verifier on one core; here it takes longer."),
    ),
    results,
    h("footer", {}, `dumbbell ${version}. A verdict rests on the source of the verifier, which is that of the program dumbbell-verify, on clang and emscripten, and on this browser. ${licences}`),
);
edited();
watchTheme();
watchDrops();
document.documentElement.dataset.drawn = "1";
