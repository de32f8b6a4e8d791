// A question to the prover, and certificates that come from elsewhere: each is verified and shown.
import { Bodies } from "./bodies.js";
import { parseReport } from "./counts.js";
import { command, h, labelled, output, select } from "./dom.js";
import { missing, prover, verifier } from "./modules/jobs.js";
import { lines } from "./modules/module.js";
import { verified } from "./outcome.js";
import { isLinked, linked, linkedFile } from "./proof_link.js";

/// What can be asked about: words for the prover, and for `dumbbell certify`.
const things = {
    dumbbell: { text: "two masses on a rod without mass", fields: ["ratio"], words: ({ ratio }) => ["ratio", ratio], command: ({ ratio }) => ratio },
    rod: { text: "two masses on a rod with mass", fields: ["ratio", "mass"], words: ({ ratio, mass }) => ["rod", ratio, mass], command: ({ ratio, mass }) => `${ratio} --rod-mass ${mass}` },
    uniform: { text: "a uniform rod alone", title: "A uniform rod", fields: [], words: () => ["body", "1", "3"], command: () => "--rho 1 --inertia 3" },
    ring: { text: "a thin ring", title: "A thin ring", fields: [], words: () => ["body", "1", "2"], command: () => "--rho 1 --inertia 2" },
    coin: { text: "a thin coin", title: "A thin coin", fields: [], words: () => ["body", "1", "4"], command: () => "--coin" },
    body: { text: "any body with two contacts", fields: ["rho", "inertia"], words: ({ rho, inertia }) => ["body", rho, inertia], command: ({ rho, inertia }) => `--rho ${rho} --inertia ${inertia}` },
};

const damaged = "The link is damaged: no whole certificate is in it. Was all of it copied?";

export class Ask {
    /// show(data) puts what the prover has read of a file into the page; show(element) what is said of another one. `picture`: of the plane of bodies, packed.
    constructor(show, picture) {
        this.picture = picture;
        this.bodies = new Bodies((rho, inertia) => {
            this.fields.rho.value = rho;
            this.fields.inertia.value = inertia;
            this.ask();
        });
        this.show = (what) => {
            show(what);
            this.bodies.take(what.files?.[0], document.getElementById("file-1"));
        };
        this.thing = select(Object.entries(things).map(([id, { text }]) => [id, text]), "dumbbell", () => this.fit());
        const field = (value, size) => h("input", { type: "text", value, size, autocomplete: "off", spellcheck: "false" });
        const texts = { ratio: "mass ratio, or a range like 1:100", mass: "mass of the rod over that of both ends", rho: "\u03c1 = d2/d1, of the distances of the contacts from the centre of mass", inertia: "Q = (d1/k)\u00b2, k the radius of gyration" };
        this.fields = { ratio: field("10", 10), mass: field("1/100", 6), rho: field("1/2", 6), inertia: field("9", 6) };
        this.labels = Object.fromEntries(Object.entries(texts).map(([name, text]) => [name, labelled(text, this.fields[name])]));
        this.told = output("told");
        this.stop = h("button", { type: "button", hidden: true, onclick: () => this.job?.stop() }, "Stop");
        this.more = h("div", {});
        const take = ([file]) => file && this.read(file);
        const chooser = h("input", { type: "file", id: "files", multiple: true, onchange: () => take(chooser.files) });
        this.element = h(
            "form",
            { class: "verify ask", onsubmit: (event) => (event.preventDefault(), this.ask()) },
            h("p", { class: "controls" }, labelled("How often can it hit the floor:", this.thing), Object.values(this.labels), h("button", { type: "submit" }, "Prove it")),
            h("p", { class: "controls" }, h("label", { for: "files" }, "Or open a certificate, or drop it anywhere:"), chooser),
            h("div", { class: "controls" }, this.told, this.stop),
            this.more,
        );
        this.fit();
        watchDrops(take);
        addEventListener("hashchange", () => isLinked() && this.open());
    }

    fit() {
        for (const [name, label] of Object.entries(this.labels)) {
            label.hidden = !things[this.thing.value].fields.includes(name);
        }
        document.getElementById("file-1")?.prepend(...this.bodies.answer.childNodes); // to what else is shown of it
        this.bodies.element.hidden = this.thing.value !== "body" || !this.bodies.picture;
    }

    /// What stands in the address, or else the first question.
    async open() {
        const lacking = missing();
        if (lacking.length > 0) {
            this.say(`This browser lacks what the page needs to prove and to verify: ${lacking.join(", ")}. Firefox 113, Chrome 103 and Safari 16.4, or later ones, have it.`);
            return;
        }
        prover.start();
        verifier.start();
        await this.bodies.draw(this.picture);
        this.fit();
        const file = await linkedFile().catch(() => "damaged");
        if (file === "damaged") {
            this.say(damaged);
        } else {
            await (file ? this.read(file) : this.ask());
        }
    }

    say(text, ...more) {
        this.told.textContent = text;
        this.more.replaceChildren(...more);
    }

    /// A call of the prover, as JSON; null if it came to no answer, which is said, with `instead`; or if there is another question by then.
    async answer(name, input, ...instead) {
        this.job?.stop();
        this.show(h("div", {})); // what was shown answers another question
        const job = prover.call(name, input, { progress: (done, total) => this.say(`Proving: ${done.toLocaleString("en")} of ${total.toLocaleString("en")}`) });
        this.job = job;
        this.stop.hidden = false;
        const { answer, failure, stopped } = await job.promise;
        if (this.job !== job) {
            return null;
        }
        this.stop.hidden = true;
        if (answer === undefined) {
            this.say(stopped ? "Stopped." : `The prover came to no answer: ${failure}.`, ...instead);
            return null;
        }
        return parseReport(answer);
    }

    async ask() {
        const thing = things[this.thing.value];
        const values = Object.fromEntries(Object.entries(this.fields).map(([name, { value }]) => [name, value.replace(/\s+/g, "")]));
        const words = thing.words(values);
        this.say("Proving");
        const proof = await this.answer("certify", [lines(words)], h("p", {}, "Without a browser:"), command(`dumbbell certify ${thing.command(values)}`));
        if (proof?.usage) {
            this.say(`${proof.usage[0].toUpperCase()}${proof.usage.slice(1)}.`);
        } else if (proof?.why) {
            this.say(`Not decided here: ${proof.why}. This command decides it, or says why not:`, command(proof.command));
        } else if (proof) {
            await this.read(new File([proof.certificate], `${words.join("-").replace("ratio", "q").replace(/[^\w.-]+/g, "-")}.dbc`), proof.claim, thing);
        }
    }

    /// Shows a certificate, verified with this claim, or else with all that it claims.
    async read(file, claim = null, thing = null) {
        const data = await this.answer("show", [`${file.name}\n`, file]);
        if (data === null) {
            return;
        }
        this.say("");
        if (data.usage && file.name === linked) {
            this.say(damaged);
        } else if (data.usage) { // it may be of a kind that is verified and not shown
            this.show(h("section", {}, h("h2", {}, file.name), h("p", {}, `${data.usage}.`), verified(file, [])));
        } else {
            Object.assign(data.files[0], { blob: file, ...(claim && { verify_options: claim }), ...(thing?.title && { thing: thing.title }) });
            this.show(data);
        }
    }
}

function watchDrops(take) {
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
