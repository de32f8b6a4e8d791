// The section cells of the scene body (format-sections.md, section 6): rectangles of bodies.
#include <cmath>

#include "verify/core/reader.hpp"
#include "verify/core/tree.hpp"
#include "verify/sections/cell.hpp"

namespace dumbbell_verify {
namespace {

class CellReader : public Reader<Cell> {
  public:
    CellReader(Text& text, const Settings& settings) : Reader(text, settings) {
        proof_.claim = settings.demand;
        proof_.section = &cells();
        proof_.tallies = {{"split"}, {"cell"}, {"open"}};
    }

  private:
    [[nodiscard]] std::string_view kind() const override { return "collisions"; }
    [[nodiscard]] std::string_view scene() const override { return "body"; }
    [[nodiscard]] std::string missing() const override {
        return settings_.together ? "" : proof_.claim.missing();
    }
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
        Cell cell;
        read_bits(cell);
        cell.box = {{0, 0, claim.lo, lowest}, {0, 0, claim.hi, greatest}};
        proof_.roots = 1;
        Tree<Box> tree{text_, axes, proof_.tallies[0].lines, cell.box, "cell."};
        tree.read([&] { leaf(cell, std::ldexp(1, -tree.depth), tree.path); });
        claim.add(claim.lo, claim.hi, upper_, lower_.value_or(0));
    }

    void leaf(Cell& cell, double share, const std::string& path) {
        const bool is_open = text_.fields[0] == "open" && text_.fields.size() == 1;
        Tally& tally = proof_.tallies[is_open ? 2 : 1];
        ++tally.lines;
        tally.covered += share;
        if (is_open) {
            upper_ = std::nullopt;
            lower_ = 0;
            has_open_ = true;
            return;
        }
        if (text_.fields[0] != "cell") text_.reject("opcode", "not a line for this place");
        if (text_.fields.size() < 6 || text_.fields.size() % 2 != 0)
            text_.reject("syntax", "expected `cell U V j p end`, and pairs `x p`");
        cell.line = text_.line;
        cell.upper = text_.long_natural(1);
        cell.lower = text_.long_natural(2);
        cell.j = text_.long_natural(3);
        cell.p = text_.dyadic(4);
        cell.x = {0};
        cell.p_of.clear();
        for (std::size_t i = 6; i < text_.fields.size(); i += 2) {
            cell.x.push_back(text_.long_natural(i));
            cell.p_of.push_back(text_.dyadic(i + 1));
        }
        cell.x.push_back(text_.long_natural(5));
        if (cell.lower > cell.upper || cell.upper == 0) text_.reject("number", "not V <= U, 1 <= U");
        explain(cell, path);
        take(cell);
        lower_ = std::min(lower_.value_or(cell.lower), cell.lower);
        if (!has_open_) upper_ = std::max(upper_.value_or(cell.upper), cell.upper);
    }

    std::optional<mpz_class> upper_, lower_;  ///< of all cells so far
    bool has_open_ = false;
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
