// A proof as a link: a certificate's text in an address, packed.

const mark = "#proof=";
export const linked = "linked.dbc"; // its name as a file
const most = 8000; // characters of an address that programs hand on whole

const through = (bytes, stream) => new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer();

/// What base64 has, packed.
export const unpacked = (base64, format) => through(Uint8Array.from(atob(base64), (c) => c.charCodeAt(0)), new DecompressionStream(format));

/// The address of this page with the certificate in it, or null if that is too long.
export async function linkOf(file) {
    const packed = new Uint8Array(await through(await file.arrayBuffer(), new CompressionStream("deflate-raw")));
    const text = packed.length < most ? btoa(String.fromCharCode(...packed)).replace(/\+/g, "-").replace(/\//g, "_").replace(/=+$/, "") : "";
    return text !== "" && text.length < most ? `${location.href.replace(/#.*/, "")}${mark}${text}` : null;
}

export const isLinked = () => location.hash.startsWith(mark);

/// The certificate in the address of this page: a file, or null if there is none. Throws if the link is damaged.
export async function linkedFile() {
    if (!isLinked()) {
        return null;
    }
    const base64 = location.hash.slice(mark.length).replace(/-/g, "+").replace(/_/g, "/");
    return new File([await unpacked(base64, "deflate-raw")], linked);
}
