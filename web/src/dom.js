// Building elements. Text is always text: nothing from a certificate is read as HTML.

/// h("p", {class: "note"}, "text", child, ...): attributes by name, functions as listeners (onclick, ...).
export const h = (tag, ...rest) => filled(document.createElement(tag), ...rest);

const svg = Object.assign(document.createElement("template"), { innerHTML: "<svg></svg>" }).content.firstChild.namespaceURI; // the page has no address in it

/// The same for an element of a picture.
export const s = (tag, ...rest) => filled(document.createElementNS(svg, tag), ...rest);

function filled(element, attributes = {}, ...children) {
    for (const [name, value] of Object.entries(attributes)) {
        if (typeof value === "function") {
            element.addEventListener(name.slice(2), value);
        } else if (value === true) {
            element.setAttribute(name, "");
        } else if (value !== false && value !== null && value !== undefined) {
            element.setAttribute(name, value);
        }
    }
    element.append(...children.flat().filter((child) => child !== null && child !== undefined && child !== false));
    return element;
}

/// A control with its label before it.
export function labelled(text, control) {
    if (control.matches("input, select") && !control.hasAttribute("aria-label")) {
        control.setAttribute("aria-label", text);
    }
    return h("label", { class: "labelled" }, h("span", {}, text), control);
}

/// Where a result stands: read out when it changes.
export const output = (kind, text = "") => h("output", { class: kind, "aria-live": "polite" }, text);

/// choices: [[value, text], ...]
export const select = (choices, value, onchange) => h(
    "select",
    { onchange: (event) => onchange(event.target.value) },
    choices.map(([id, text]) => h("option", { value: id, selected: String(id) === String(value) }, text)),
);

/// head: texts, or null: then the first column names the rows. rows: lists of texts or elements. Columns in `numeric` are
/// aligned right. It scrolls sideways inside its own frame, never the page.
export function table(caption, head, rows, numeric = []) {
    const cell = (tag, scope = null) => (content, i) => h(tag, { class: numeric.includes(i) ? "number" : null, scope }, content);
    const named = (content, i) => (head === null && i === 0 ? cell("th", "row") : cell("td"))(content, i);
    return h(
        "div",
        { class: "scroll", tabindex: "0", role: "group", "aria-label": caption },
        h(
            "table",
            {},
            h("caption", {}, caption),
            head && h("thead", {}, h("tr", {}, head.map(cell("th", "col")))),
            h("tbody", {}, rows.map((row) => h("tr", {}, row.map(named)))),
        ),
    );
}

/// A table whose rows beyond the first `most` come when asked for.
export function longTable(caption, head, rows, numeric, most) {
    if (rows.length <= most) {
        return table(caption, head, rows, numeric);
    }
    const host = h("div", {}, table(`${caption} (the first ${most} of ${rows.length})`, head, rows.slice(0, most), numeric));
    const all = () => host.replaceChildren(table(caption, head, rows, numeric));
    host.append(h("button", { type: "button", onclick: all }, `Show all ${rows.length}`));
    return host;
}

/// A button that copies a text. Where there is no clipboard, `shown` is selected: it can be copied by hand.
export function copying(name, text, shown = null) {
    const button = h("button", { type: "button", onclick: copy }, name);
    async function copy() {
        try {
            await navigator.clipboard.writeText(text);
            button.textContent = "Copied";
        } catch {
            shown ? getSelection().selectAllChildren(shown) : prompt(name, text);
        }
        setTimeout(() => (button.textContent = name), 1500);
    }
    return button;
}

/// A command to type, with a button that copies it.
export function command(text) {
    const code = h("code", {}, text);
    return h("div", { class: "command" }, code, copying("Copy", text, code));
}
