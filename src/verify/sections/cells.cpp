// The section cells of the scene body (format-sections.md, section 6): rectangles of bodies.
#include <cmath>

#include "verify/core/reader.hpp"
#include "verify/core/tree.hpp"
#include "verify/functions/exact_value.hpp"
#include "verify/sections/cell.hpp"

namespace dumbbell_verify {
namespace {

class CellReader : public Reader<Cell> {
  public:
    CellReader(Text& text, const Settings& settings) : Reader(text, settings) {
        proof_.claim = settings.demand;
        proof_.section = &cells();
        proof_.tallies = {{"split"}, {"cell"}, {"beyond"}, {"open"}};
    }

  private:
    [[nodiscard]] std::string_view kind() const override { return "collisions"; }
    [[nodiscard]] std::string_view scene() const override { return "body"; }
    [[nodiscard]] std::string missing() const override { return proof_.claim.missing(); }
    [[nodiscard]] const char* check(const Cell& cell, Log* log) const override {
        return dumbbell_verify::judged<CellRule>(cell, log);
    }
    [[nodiscard]] std::string_view opcode(const Cell& /*cell*/) const override { return "cell"; }

    void read() override {
        static constexpr std::array<std::string_view, 4> axes{"", "", "q", "rho"};
        Collisions& claim = proof_.claim;
        text_.expect("ratio", 2);
        claim.lo = text_.ratio(1);
        claim.hi = text_.ratio(2);
        text_.expect("rho", 2);
        const auto& [lowest, greatest] = *(claim.rho = {text_.ratio(1), text_.ratio(2)});
        if (claim.lo > claim.hi || lowest > greatest || greatest > 1)
            text_.reject("number", "not LO <= HI and R0 <= R1 <= 1");
        claim.leap = 2;
        asked_ = {claim.question(), claim.rhos.value_or(*claim.rho)};
        Cell cell;
        read_bits(cell);
        root_ = cell.box = {{0, 0, claim.lo, lowest}, {0, 0, claim.hi, greatest}};
        proof_.roots = 1;
        Tree<Box> tree{text_, axes, proof_.tallies[0].lines, cell.box, "cell."};
        tree.read([&] { leaf(cell, std::ldexp(1, -tree.depth), tree.path); });
        claim.add(claim.lo, claim.hi, part_.upper, part_.lower);
        static_cast<Bounds&>(claim) = Bounds(whole_.upper, whole_.lower, claim.leap);
        const mpq_class known = exact_value(decided_.lo), all = known + exact_value(undecided_.hi);
        proof_.decided = part_.upper == part_.lower ? 1 : all > 0 ? mpq_class(known / all) : 0;
    }

    void leaf(Cell& cell, double share, const std::string& path) {
        const std::string_view opcode = text_.fields[0];
        const bool says_nothing = text_.fields.size() == 1 && (opcode == "open" || opcode == "beyond");
        if (!says_nothing && opcode != "cell") text_.reject("opcode", "not a line for this place");
        Tally& tally = proof_.tallies[opcode == "cell" ? 1 : opcode == "beyond" ? 2 : 3];
        ++tally.lines;
        tally.covered += share;
        if (opcode == "beyond" && cell.box.hi[2] * cell.box.hi[3] > 1)
            text_.reject("beyond", "not certified: R1 B <= 1");
        if (says_nothing) return join(cell.box, {std::nullopt, 0});
        if (text_.fields.size() < 6 || text_.fields.size() % 2 != 0)
            text_.reject("syntax", "expected `cell U V j p end`, and pairs `x p`");
        cell.line = text_.line;
        cell.upper = text_.long_natural(1);
        cell.lower = text_.long_natural(2);
        cell.j = text_.long_natural(3);
        cell.p = text_.dyadic(4);
        cell.end = text_.long_natural(5);
        cell.orbits.clear();
        for (std::size_t i = 6; i < text_.fields.size(); i += 2)
            cell.orbits.emplace_back(text_.long_natural(i), text_.dyadic(i + 1));
        if (cell.lower > cell.upper || cell.upper == 0) text_.reject("number", "not V <= U, 1 <= U");
        explain(cell, path);
        take(cell);
        join(cell.box, {cell.upper, cell.lower});
    }

    /// What is said of a cell. Areas are those above the edge, Q rho = 1: a cell across it counts as a whole,
    /// as undecided.
    void join(const Box& box, const Bounds& bounds) {
        whole_.join(bounds);
        text_.budget.take(units_of_logs, text_.line);
        Big::precision = bits_of_logs;
        const auto area = area_of(box);
        if (!area) return;
        part_.join(bounds);
        const bool is_above = box.lo[2] * box.lo[3] >= 1, is_beyond = box.hi[2] * box.hi[3] <= 1;
        if (is_above && bounds.upper == bounds.lower)
            decided_ = decided_ + *area;
        else if (!is_beyond)
            undecided_ = undecided_ + *area;
    }

    /// In (log Q, log rho), of what is asked about in the box; of a single Q or rho the length. Of boxes that
    /// share an end, the upper one has it.
    [[nodiscard]] std::optional<Interval<Big>> area_of(const Box& box) const {
        Interval<Big> area = 1;
        for (const std::size_t i : {2, 3}) {
            const auto& [from, to] = asked_[i - 2];
            const mpq_class lo = std::max(from, box.lo[i]), hi = std::min(to, box.hi[i]);
            if (from < to ? lo >= hi : lo > hi || (hi == box.hi[i] && hi < root_.hi[i])) return std::nullopt;
            if (from < to) area = area * Interval<Big>(log_of(down, hi / lo), log_of(up, hi / lo));
        }
        return area;
    }
    /// MPFR rounds it correctly.
    static Big log_of(Round d, const mpq_class& x) {
        return Big::rounded(d, mpfr_log, bound(d, x, Big(0)).get());
    }

    static constexpr std::uint64_t units_of_logs = 1 << 16;
    static constexpr int bits_of_logs = 128;

    std::array<Range, 2> asked_;  ///< Q, rho
    Box root_;
    Bounds whole_, part_;                ///< of all cells so far, of those of the part
    Interval<Big> decided_, undecided_;  ///< areas of the part
};

Proof read_cells(Text& text, const Settings& settings) { return CellReader(text, settings).proof(); }

}  // namespace

const Section& cells() {
    static const Section section = [] {
        Section made{"body", "body", "cells", {}, {{"cell", {"q", "rho"}}}, {}, nullptr, nullptr};
        made.read = read_cells;
        return made;
    }();
    return section;
}

}  // namespace dumbbell_verify
