#include <algorithm>
#include <set>
#include <span>

#include "mutations.hpp"

namespace dumbbell_mutation {
namespace {

/// The axes of all trees but those about the adiabatic invariant, and of these.
constexpr std::string_view axes[] = {"e",   "eta",    "lambda", "t",    "q", "rho",
                                     "phi", "phidot", "y",      "ydot", "s"};
constexpr std::string_view adiabatic_axes[] = {"u", "s", "v", "delta", "sigma", "q"};

class Trees {
  public:
    Trees(const std::string& text, const Sink& sink)
        : lines_(lines_of(body_of(text))), nodes_(nodes_of(lines_)), sink_(sink) {}

    void run() {
        for (const TreeNode& node : nodes_)
            if (node.upper > 0)
                inner(node);
            else
                leaf(node);
        for (std::size_t i = 0; i < nodes_.size(); ++i)
            for (const std::size_t step : {1UL, 5UL, 11UL})
                exchange_subtrees(nodes_[i], nodes_[(i + step) % nodes_.size()]);
        blocks("chart ", "chart");
        blocks("piece ", "piece");
        classes();
    }

  private:
    [[nodiscard]] Lines part(std::size_t begin, std::size_t end) const {
        return {lines_.begin() + static_cast<std::ptrdiff_t>(begin),
                lines_.begin() + static_cast<std::ptrdiff_t>(end)};
    }
    /// The file with lines [begin, end) replaced.
    [[nodiscard]] Lines with(std::size_t begin, std::size_t end, const Lines& instead) const {
        Lines changed = part(0, begin);
        changed.insert(changed.end(), instead.begin(), instead.end());
        changed.insert(changed.end(), lines_.begin() + static_cast<std::ptrdiff_t>(end), lines_.end());
        return changed;
    }
    void give(std::string_view kind, std::size_t begin, const std::string& what, const Lines& changed) {
        sink_({kind, "line " + std::to_string(begin + 1) + ": " + lines_[begin] + what, text_of(changed)});
    }
    static Lines both(Lines a, const Lines& b) {
        a.insert(a.end(), b.begin(), b.end());
        return a;
    }

    void inner(const TreeNode& n) {
        const Lines lower = part(n.begin + 1, n.upper), upper = part(n.upper, n.end);
        give("halves exchanged", n.begin, "", with(n.begin + 1, n.end, both(upper, lower)));
        give("half lifted", n.begin, " -> lower", with(n.begin, n.end, lower));
        give("half lifted", n.begin, " -> upper", with(n.begin, n.end, upper));
        give("half doubled", n.begin, " lower", with(n.upper, n.end, lower));
        give("half doubled", n.begin, " upper", with(n.begin + 1, n.upper, upper));
        give("half missing", n.begin, " lower", with(n.begin + 1, n.upper, {}));
        give("half missing", n.begin, " upper", with(n.upper, n.end, {}));
        for (const std::string& text : leaves(n))
            give("leaf lifted", n.begin, " -> " + text, with(n.begin, n.end, {text}));
    }
    void leaf(const TreeNode& n) {
        const std::string& here = lines_[n.begin];
        for (const std::string& text : other_leaves(n))
            if (text != here) give("leaf replaced", n.begin, " -> " + text, with(n.begin, n.end, {text}));
        using Axes = std::span<const std::string_view>;
        for (const std::string_view axis : is_adiabatic(lines_) ? Axes(adiabatic_axes) : Axes(axes))
            give("leaf split", n.begin, " by " + std::string(axis),
                 with(n.begin, n.end, {"split " + std::string(axis), here, here}));
    }
    /// The different leaves in a subtree.
    [[nodiscard]] std::set<std::string> leaves(const TreeNode& n) const {
        std::set<std::string> texts;
        for (std::size_t i = n.begin; i < n.end; ++i)
            if (!lines_[i].starts_with("split ")) texts.insert(lines_[i]);
        return texts;
    }
    /// All leaves of the file, and every opcode with the hints that fit the claimed bound best.
    [[nodiscard]] std::set<std::string> other_leaves(const TreeNode& n) const {
        std::set<std::string> texts;
        for (const TreeNode& other : nodes_)
            if (other.upper == 0) texts.insert(lines_[other.begin]);
        if (is_adiabatic(lines_)) {
            for (const char* text : {"outside", "bound", "bound 0", "bound 1", "bound 2"}) texts.insert(text);
            return texts;
        }
        if (is_initial(lines_)) {
            for (const char* text :
                 {"open", "exactly 0", "between 0 1", "between 0 2", "between 1 9", "between 0 99"})
                texts.insert(text);
            return texts;
        }
        std::string upper = "1";
        for (std::size_t i = 0; i < n.begin; ++i)
            if (lines_[i].starts_with("upper ")) upper = words_of(lines_[i])[1];
        const long rest = upper == "none" ? 1 : std::stol(upper) - 1;
        for (const char* text :
             {"outside", "meets", "meets-reversed", "once", "equal-masses", "witness bridge 1b-1 1b-1 0 0"})
            texts.insert(text);
        for (long a = 0; a <= std::min(rest, 20L); ++a)
            texts.insert("count " + std::to_string(a) + " " + std::to_string(rest - a));
        texts.insert("count " + std::to_string(rest));
        return texts;
    }

    void exchange_subtrees(const TreeNode& a, const TreeNode& b) {
        if (a.begin > b.begin) return exchange_subtrees(b, a);
        if (b.begin < a.end) return;  // the same, or one in the other
        const Lines first = part(a.begin, a.end), second = part(b.begin, b.end);
        if (first == second) return;
        Lines changed = with(b.begin, b.end, first);
        changed.erase(changed.begin() + static_cast<std::ptrdiff_t>(a.begin),
                      changed.begin() + static_cast<std::ptrdiff_t>(a.end));
        changed.insert(changed.begin() + static_cast<std::ptrdiff_t>(a.begin), second.begin(), second.end());
        give("subtrees exchanged", a.begin, " and line " + std::to_string(b.begin + 1), changed);
    }

    /// Classes with their trees, and the number of them that fits.
    void classes() {
        const auto count = std::find_if(lines_.begin(), lines_.end(),
                                        [](const std::string& line) { return line.starts_with("classes "); });
        if (count == lines_.end()) return;
        std::vector<std::size_t> begins;
        for (std::size_t i = 0; i < lines_.size(); ++i)
            if (lines_[i].starts_with("class ") || lines_[i] == "end") begins.push_back(i);
        const auto numbered = [&](Lines changed, std::size_t n) {
            changed[static_cast<std::size_t>(count - lines_.begin())] = "classes " + std::to_string(n);
            return changed;
        };
        const std::size_t n = begins.size() - 1;
        for (std::size_t i = 0; i < n; ++i) {
            const Lines block = part(begins[i], begins[i + 1]);
            give("class deleted", begins[i], "", numbered(with(begins[i], begins[i + 1], {}), n - 1));
            for (std::size_t j = 0; j <= n; ++j)
                give("class doubled", begins[i], " before line " + std::to_string(begins[j] + 1),
                     numbered(with(begins[j], begins[j], block), n + 1));
            for (std::size_t j = 0; j < n; ++j)
                if (i != j)
                    give("class instead of another", begins[i], " for line " + std::to_string(begins[j] + 1),
                         with(begins[j], begins[j + 1], block));
        }
    }

    /// Charts with their trees, or pieces.
    void blocks(std::string_view beginning, const std::string& name) {
        const auto ends_block = [&](std::size_t i) {
            return i == lines_.size() || lines_[i].starts_with(beginning) ||
                   lines_[i].starts_with("piece ") || (name == "chart" && lines_[i].starts_with("lower "));
        };
        std::vector<std::pair<std::size_t, std::size_t>> found;
        for (std::size_t i = 0; i < lines_.size(); ++i) {
            if (!lines_[i].starts_with(beginning)) continue;
            std::size_t end = i + 1;
            while (!ends_block(end)) ++end;
            found.emplace_back(i, end);
        }
        for (std::size_t k = 0; k < found.size(); ++k) {
            const auto [begin, end] = found[k];
            const Lines block = part(begin, end);
            give(name == "chart" ? "chart deleted" : "piece deleted", begin, "", with(begin, end, {}));
            give(name == "chart" ? "chart doubled" : "piece doubled", begin, "",
                 with(begin, end, both(block, block)));
            if (k + 1 == found.size()) continue;
            const auto [next, next_end] = found[k + 1];
            if (next != end) continue;
            give(name == "chart" ? "charts exchanged" : "pieces exchanged", begin, "",
                 with(begin, next_end, both(part(next, next_end), block)));
        }
    }

    Lines lines_;
    std::vector<TreeNode> nodes_;
    const Sink& sink_;
};

}  // namespace

void tree_mutations(const std::string& text, const Sink& sink) { Trees(text, sink).run(); }

}  // namespace dumbbell_mutation
