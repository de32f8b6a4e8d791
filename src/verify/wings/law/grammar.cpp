// The grammar of a file about the law (format-law.md).
#include "verify/wings/law/grammar.hpp"

#include "verify/core/proofs.hpp"
#include "verify/core/reader.hpp"
#include "verify/core/tree.hpp"
#include "verify/wings/law/leaf.hpp"
#include "verify/wings/law/steps.hpp"

namespace dumbbell_verify::law {
namespace {

constexpr std::uint64_t most_parts = 100'000;  ///< of a range of the bulk, and of the end
constexpr std::array<std::string_view, 2> layer_axes{"U", "rho"};

class ClaimReader : public Reader<Leaf> {
  public:
    ClaimReader(Text& text, const Settings& settings)
        : Reader(text, settings),
          proofs_{text, turning(), proof_.tallies,
                  [this](const dumbbell_verify::Leaf& leaf, const std::string& path) {
                      take_of_step(leaf, path);
                  }} {
        proofs_.add_tallies();
        first_ = proof_.tallies.size();
        for (const auto rule : {Leaf::slope, Leaf::beyond}) proof_.tallies.push_back({Leaf::names.at(rule)});
    }
    [[nodiscard]] Claim& claim() { return claim_; }

  private:
    [[nodiscard]] std::string_view kind() const override { return claim_.kind_name(); }
    [[nodiscard]] const char* check(const Leaf& leaf, Log* log) const override {
        if (leaf.rule == Leaf::step) return turning().check(leaf.at_step, log);
        if (leaf.rule == Leaf::bulk) return check_bulk(leaf, log);
        return leaf.rule == Leaf::end ? check_end(leaf, log) : check_layer(leaf, log);
    }
    [[nodiscard]] std::string_view opcode(const Leaf& leaf) const override {
        return leaf.rule == Leaf::step ? turning().opcodes[leaf.at_step.opcode].name
                                       : Leaf::names.at(leaf.rule);
    }

    void read() override {
        text_.expect("steps", 2);
        if (text_.natural(1) != first_step || text_.natural(2) != last_step)
            text_.reject("number", "the steps are 3 to 902");
        Watched::pieces += last_step - first_step + 1 + 3;  // and the covers
        if (settings_.precision > 0) {
            Big::precision = settings_.precision;
            steps(StepPlaces<Big>());
        } else {
            steps(StepPlaces<double>());
        }
        leaf_.bits = std::max(53U, settings_.precision);  // of the covers a file has no say in them
        leaf_.multiple = settings_.precision > 0;
        for (const auto cover : {&ClaimReader::layer, &ClaimReader::bulk, &ClaimReader::end}) {
            (this->*cover)();
            ++Watched::read;
        }
    }

    template <class Places>
    void steps(const Places& places) {
        for (unsigned n = first_step; n <= last_step; ++n) {
            text_.expect("step", 3);
            if (text_.natural(1) != n) text_.reject("number", "expected step " + std::to_string(n));
            const mpq_class a = text_.ratio(2), b = text_.ratio(3);
            if (!(1 <= a && a < b)) text_.reject("number", "not 1 <= A < B");
            require(text_.line, "step", [&] { return places.check(n, a, b); });
            if (n == law_step) claim_.from = {a, b};
            step_ = n;
            read_bits(leaf_);
            dumbbell_verify::Leaf leaf;
            leaf.bits = leaf_.bits;
            leaf.multiple = leaf_.multiple;
            leaf.claimed = number("upper", n - 1);
            proof_.roots += static_cast<double>(turning().charts.size());
            proofs_.cover(leaf, a, a);
            leaf.claimed = number("lower", n);
            proofs_.witness(leaf, b, b);
            ++Watched::read;
        }
    }
    unsigned number(std::string_view keyword, unsigned expected) {
        text_.expect(keyword, 1);
        if (text_.natural(1) != expected) text_.reject("number", "expected " + std::to_string(expected));
        return expected;
    }
    template <class Check>
    static void require(std::uint64_t line, std::string_view code, const Check& check) {
        if (const auto failure = judge(line, code, check)) throw Failure(*failure);
    }
    void take_of_step(const dumbbell_verify::Leaf& at_step, const std::string& path) {
        Leaf leaf;
        leaf.line = at_step.line;
        leaf.at_step = at_step;
        explain(leaf, std::to_string(step_) + ":" + path);
        Reader::take(std::move(leaf));
    }

    void cover(std::string_view name, std::size_t counts) {
        text_.expect("cover", 1 + counts);
        if (text_.fields[1] != name) text_.reject("syntax", "expected `cover " + std::string(name) + "`");
        leaf_.line = text_.line;
    }
    void layer() {
        cover("layer", 0);
        require(text_.line, "layer", [&] { return check_constant(leaf_.bits, leaf_.multiple, nullptr); });
        leaf_.box.hi = {layer_U, layer_rho};
        ++proof_.roots;
        Tree<Box> tree{text_, layer_axes, proof_.tallies[0].lines, leaf_.box, "layer."};
        tree.read([&] { layer_leaf(std::ldexp(1, -tree.depth), tree.path); });
    }
    void layer_leaf(double share, const std::string& path) {
        const auto& names = Leaf::names;
        const auto* const name = std::find(&names.at(Leaf::slope), &names.at(Leaf::bulk), text_.fields[0]);
        if (name == &names.at(Leaf::bulk)) text_.reject("opcode", "not a line for this place");
        if (text_.fields.size() != 1) text_.reject("syntax", "wrong number of values");
        leaf_.rule = static_cast<Leaf::Rule>(name - names.data());
        leaf_.line = text_.line;
        Tally& tally = proof_.tallies.at(first_ + static_cast<std::size_t>(leaf_.rule - Leaf::slope));
        ++tally.lines;
        tally.covered += share;
        take(path);
    }

    void bulk() {
        cover("bulk", 3);
        require(text_.line, "bulk", [&] { return check_bulk_window(leaf_.bits, leaf_.multiple, nullptr); });
        leaf_.rule = Leaf::bulk;
        for (leaf_.range = 0; leaf_.range < 3; ++leaf_.range)
            parts(bulk_angles.at(leaf_.range), bulk_angles.at(leaf_.range + 1), 2 + leaf_.range,
                  "bulk" + std::to_string(leaf_.range + 1));
    }
    void end() {
        cover("end", 1);
        leaf_.rule = Leaf::end;
        parts(0, end_d, 2, "end");
    }
    /// All parts of a range, as many as a field says.
    void parts(const mpq_class& lo, const mpq_class& hi, std::size_t field, const std::string& name) {
        const std::uint64_t n = text_.natural(field);
        if (n < 1 || n > most_parts) text_.reject("number", "not 1 to 100000 parts");
        const mpq_class width = (hi - lo) / static_cast<unsigned long>(n);
        for (std::uint64_t i = 0; i < n; ++i) {
            leaf_.box.lo = {lo + width * static_cast<unsigned long>(i), 0};
            leaf_.box.hi = {lo + width * static_cast<unsigned long>(i + 1), 0};
            take(name + "." + std::to_string(i + 1));
        }
    }
    /// The present leaf of a cover is to be checked.
    void take(const std::string& path) {
        if (is_asked_for(path)) {
            const bool layer = leaf_.rule < Leaf::bulk;
            std::string box;
            for (std::size_t i = 0; i < (layer ? 2 : 1); ++i)
                box += "  " +
                       std::string(layer                      ? layer_axes.at(i)
                                   : leaf_.rule == Leaf::bulk ? "th"
                                                              : "d") +
                       " in [" + to_string(leaf_.box.lo.at(i)) + ", " + to_string(leaf_.box.hi.at(i)) + "]\n";
            explain(leaf_, path, box);
        }
        Reader::take(leaf_);
    }

    const Proofs proofs_;
    Claim claim_;
    Leaf leaf_;  ///< the present one of the covers
    std::uint64_t step_ = 0;
    std::size_t first_ = 0;  ///< the place of `slope` in the tallies
};

}  // namespace

std::pair<Proof, Claim> proof(Text& text, const Settings& settings) {
    ClaimReader reader(text, settings);
    Proof proof = reader.proof();
    return {std::move(proof), std::move(reader.claim())};
}

std::span<const ClaimKind> claim_kinds() {
    static constexpr ClaimKind kinds[] = {
        {.name = "law",
         .proof = [](Text& text, const Request& request) { return about(proof(text, request)); },
         .is_of_section = true}};
    return kinds;
}

}  // namespace dumbbell_verify::law
