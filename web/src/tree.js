// A bisection tree of boxes, as the program writes it: pre-order, lower half first, k >= 0 a leaf of kind k, -1 - a a split of
// axis a. Halves are exact in the file; here they are doubles.
import { parse, toNumber } from "./rational.js";

export class BoxTree {
    /// data: {nodes, axes: [{name, lo, hi}], leaves, stands_for}
    constructor(data) {
        this.nodes = Int32Array.from(data.nodes);
        this.axes = data.axes.map(({ name, lo, hi }) => ({ name, lo: toNumber(parse(lo)), hi: toNumber(parse(hi)) }));
        this.leaves = data.leaves;
        this.standsFor = data.stands_for;
        const n = this.nodes.length;
        this.upper = new Int32Array(n); // of an inner node, where its upper half begins
        this.greatest = new Int32Array(n); // kind in the subtree
        this.leafNumber = new Int32Array(n); // of the first leaf in it
        const roots = [];
        for (let i = n - 1; i >= 0; --i) {
            if (this.nodes[i] < 0) {
                const lower = roots.pop();
                this.upper[i] = roots.pop();
                this.greatest[i] = Math.max(this.greatest[lower], this.greatest[this.upper[i]]);
            } else {
                this.greatest[i] = this.nodes[i];
            }
            roots.push(i);
        }
        let leaf = 0;
        for (let i = 0; i < n; ++i) {
            this.leafNumber[i] = leaf;
            leaf += this.nodes[i] >= 0 ? 1 : 0;
        }
        this.shown = leaf;
    }

    /// lo and hi of each axis: [lo0, hi0, lo1, hi1, ...]
    root() {
        return Float64Array.from(this.axes.flatMap(({ lo, hi }) => [lo, hi]));
    }

    /// The leaf whose box holds the point (a value for each axis): its box, kind, path from the root (0 lower, 1 upper half), and
    /// how many leaves of the file it stands for. Null outside.
    find(point) {
        const box = this.root();
        if (point.some((x, a) => !(x >= box[2 * a] && x <= box[2 * a + 1]))) {
            return null;
        }
        let node = 0;
        let path = "";
        while (this.nodes[node] < 0) {
            const axis = -1 - this.nodes[node];
            const middle = (box[2 * axis] + box[2 * axis + 1]) / 2;
            const isUpper = point[axis] > middle;
            box[2 * axis + (isUpper ? 0 : 1)] = middle;
            node = isUpper ? this.upper[node] : node + 1;
            path += isUpper ? "1" : "0";
        }
        const number = this.leafNumber[node];
        return { box, kind: this.nodes[node], path, number, standsFor: this.standsFor[number] ?? 1 };
    }

    /// Calls visit(box, kind, number, isLeaf) for the boxes that meet the slice: `fixed[a]` is a value for an axis that is fixed,
    /// else NaN. `skip(box)` true: not in the picture; `small(box)` true: its subtree is drawn as one.
    walk(fixed, skip, small, visit) {
        const depth = [0];
        const boxes = [this.root()];
        while (depth.length > 0) {
            const node = depth.pop();
            const box = boxes.pop();
            if (skip(box)) {
                continue;
            }
            if (this.nodes[node] >= 0 || small(box)) {
                visit(box, this.greatest[node], this.leafNumber[node], this.nodes[node] >= 0);
                continue;
            }
            const axis = -1 - this.nodes[node];
            const middle = (box[2 * axis] + box[2 * axis + 1]) / 2;
            const at = fixed[axis];
            if (!(at <= middle)) { // NaN: both halves
                const half = box.slice();
                half[2 * axis] = middle;
                depth.push(this.upper[node]);
                boxes.push(half);
            }
            if (!(at > middle)) {
                box[2 * axis + 1] = middle;
                depth.push(node + 1);
                boxes.push(box);
            }
        }
    }
}
