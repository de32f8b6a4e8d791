// The grammar of a file about mass ratios (format.md, sections 2 and 3).
#include "verify/core/certificate.hpp"

#include <algorithm>

#include "verify/core/proofs.hpp"
#include "verify/core/reader.hpp"

namespace dumbbell_verify {
namespace {

/// A line with one value: a word, or a number (or either). The file is unsupported unless `is_known`.
template <class Predicate>
std::string known(Text& text, const std::string& keyword, bool number, bool word, Predicate is_known) {
    text.expect(keyword, 1);
    const char first = text.fields[1][0];
    const bool digit = number && (!word || (first >= '0' && first <= '9'));
    const std::string found = digit ? std::to_string(text.natural(1)) : text.word(1);
    if (!is_known(found)) text.unsupported("unknown " + keyword + " " + found);
    return found;
}

/// The section that the lines `lemmas`, `scene` and `section` choose; nullptr: none.
const Section* read_section(Text& text) {
    const auto table = sections();
    const auto in = [&](std::string_view Section::*column) {
        return [&table, column](const std::string& word) {
            return std::any_of(table.begin(), table.end(), [&](auto* s) { return s->*column == word; });
        };
    };
    const std::string lemmas = known(text, "lemmas", true, true, in(&Section::lemmas));
    const std::string scene = known(text, "scene", false, true, in(&Section::scene));
    const std::string name = known(text, "section", false, true, [&](const std::string& word) {
        return word == "none" || in(&Section::name)(word);
    });
    if (lemmas == "1" && scene == "dumbbell" && name == "none") return nullptr;
    const auto found = std::find_if(table.begin(), table.end(), [&](const Section* s) {
        return s->lemmas == lemmas && s->scene == scene && s->name == name;
    });
    if (found == table.end())
        text.unsupported("no section " + name + " of the scene " + scene + " with lemmas " + lemmas);
    return *found;
}

class CollisionsReader : public Reader<Leaf> {
  public:
    CollisionsReader(Text& text, const Settings& settings, const Section& section)
        : Reader(text, settings),
          section_(section),
          proofs_{text, section, proof_.tallies,
                  [this](Leaf leaf, const std::string& path) { take(std::move(leaf), path); }} {
        proof_.claim = settings.demand;
        proof_.section = &section;
        proofs_.add_tallies();
        proof_.tallies.push_back({"open"});
    }

  private:
    [[nodiscard]] std::string_view kind() const override { return "collisions"; }
    [[nodiscard]] std::string_view scene() const override { return section_.scene; }
    [[nodiscard]] std::string missing() const override { return claim_.missing(); }
    [[nodiscard]] const char* check(const Leaf& leaf, Log* log) const override {
        return section_.check(leaf, log);
    }
    [[nodiscard]] std::string_view opcode(const Leaf& leaf) const override {
        return section_.opcodes[leaf.opcode].name;
    }

    void read() override {
        range();
        for (const std::uint64_t k = text_.natural(1); claim_.pieces < k;) piece();
        if (end_ != claim_.hi) text_.reject("chain", "the last piece does not end at HI");
        proof_.heavy_once = section_.heavy_once && claim_.upper;
    }

    void range() {
        text_.expect("ratio", 2);
        end_ = claim_.lo = text_.ratio(1);
        claim_.hi = text_.ratio(2);
        if ((claim_.lo < 1 && !section_.every_body) || claim_.lo > claim_.hi)
            text_.reject("number", "not 1 <= LO <= HI");
        if (section_.scene == "body") {
            text_.expect("rho", 2);
            const auto& [lowest, greatest] = *(claim_.rho = {text_.ratio(1), text_.ratio(2)});
            if (lowest > greatest || greatest > 1 || (claim_.lo * lowest < 1 && !section_.every_body))
                text_.reject("number", "not R0 <= R1 <= 1 <= LO R0");
            proofs_.rho = *claim_.rho;
            claim_.leap = 2;
        }
        text_.expect("pieces", 1);
        const std::uint64_t k = text_.natural(1);
        if (k == 0) text_.reject("number", "no piece");
        Watched::pieces += k;
    }

    void piece() {
        Leaf leaf;
        text_.expect("piece", 2);
        const mpq_class a = text_.ratio(1), b = text_.ratio(2);
        if (a != end_ || a > b) text_.reject("chain", "a piece must begin where the one before ended");
        end_ = b;
        read_bits(leaf);
        text_.expect("upper", 1);
        std::optional<mpz_class> upper;
        if (text_.fields[1] != "none") {
            upper = leaf.claimed = text_.long_natural(1);
            // Double precision cannot tell such counts apart.
            leaf.multiple = leaf.multiple || (leaf.bits > 53 && *upper > 20'000'000'000'000.0);
            proof_.roots += static_cast<double>(section_.charts.size());
            proofs_.cover(leaf, a, b);
        } else {
            ++proof_.tallies.back().lines;
        }
        text_.expect("lower", 1);
        leaf.claimed = text_.long_natural(1);
        if (upper && leaf.claimed > *upper) text_.reject("number", "lower above upper");
        if (leaf.claimed > 0) proofs_.witness(leaf, a, b);
        claim_.add(a, b, upper, leaf.claimed);
        ++Watched::read;
    }

    void take(Leaf leaf, const std::string& path) {
        explain(leaf, std::to_string(claim_.pieces + 1) + ":" + path);
        Reader::take(std::move(leaf));
    }

    const Section& section_;
    Proofs proofs_;
    Collisions& claim_ = proof_.claim;
    mpq_class end_;  ///< of the pieces so far
};

}  // namespace

Header read_header(Text& text) {
    known(text, "dumbbell-certificate", true, false,
          [](const std::string& version) { return version == "1"; });
    text.expect("generator", 2);
    text.require_word(1);
    text.require_word(2, true);
    const Section* section = read_section(text);
    text.expect("claim", 1);
    return {section, text.word(1)};
}

Proof collisions(Text& text, const Settings& settings, const Section& section) {
    return section.read ? section.read(text, settings) : CollisionsReader(text, settings, section).proof();
}

}  // namespace dumbbell_verify
