#include "certificate.hpp"

#include <cmath>

#include "adiabatic.hpp"
#include "initial.hpp"
#include "reader.hpp"

namespace dumbbell_verify {
namespace {

class Reader {
  public:
    Reader(const std::string& path, const Settings& settings)
        : settings_(settings), text_(path, settings.budget) {
        proof_.claim = settings.demand;
    }

    Proof run() {
        try {
            header();
            if (!section_ && settings_.check != all_pieces)
                misused("a file with this claim has no pieces: it is verified as a whole only");
            if (adiabatic_) return adiabatic(text_, settings_, *adiabatic_);
            if (!section_) return initial(text_, settings_);
            range();
            for (const std::uint64_t k = text_.natural(1); claim_.pieces < k;) piece();
            if (end_ != claim_.hi) text_.reject("chain", "the last piece does not end at HI");
            read_trailer(text_, proof_);
            check_pending();
            proof_.work = text_.budget.taken();
            if (settings_.scene != section_->scene) text_.reject("claim-not-proved", "the scene is another");
            if (!settings_.claim.empty() && settings_.claim != "collisions")
                text_.reject("claim-not-proved", "the claim is another");
            if (const auto gap = claim_.missing(); !gap.empty()) text_.reject("claim-not-proved", gap);
        } catch (const Failure&) {
            check_pending();  // a leaf on an earlier line goes first
            throw;
        }
        proof_.heavy_once = section_->heavy_once && claim_.upper;
        return std::move(proof_);
    }

  private:
    /// A line with one value: a word, or a number (or either). The file
    /// is unsupported unless `is_known`.
    template <class Predicate>
    std::string known(const std::string& keyword, bool number, bool word, Predicate is_known) {
        text_.expect(keyword, 1);
        const char first = text_.fields[1][0];
        const bool digit = number && (!word || (first >= '0' && first <= '9'));
        const std::string found = digit ? std::to_string(text_.natural(1)) : text_.word(1);
        if (!is_known(found)) unsupported("unknown " + keyword + " " + found);
        return found;
    }
    [[noreturn]] void unsupported(const std::string& text) const {
        throw Failure{Verdict::unsupported, text_.line, "unsupported", text};
    }
    [[noreturn]] void misused(const std::string& text) const {
        throw Failure{Verdict::unreadable, text_.line, "usage", text};
    }
    /// The section that the lines `lemmas`, `scene` and `section` choose; nullptr: none.
    void choose_section() {
        const auto table = sections();
        const auto in = [&](std::string_view Section::*column) {
            return [&table, column](const std::string& word) {
                return std::any_of(table.begin(), table.end(),
                                   [&](const Section* s) { return s->*column == word; });
            };
        };
        const std::string lemmas = known("lemmas", true, true, in(&Section::lemmas));
        const std::string scene = known("scene", false, true, in(&Section::scene));
        const auto is_section = in(&Section::name);
        const std::string name = known("section", false, true, [&](const std::string& word) {
            return word == "none" || is_section(word);
        });
        if (lemmas == "1" && scene == "dumbbell" && name == "none") return;
        const auto found = std::find_if(table.begin(), table.end(), [&](const Section* s) {
            return s->lemmas == lemmas && s->scene == scene && s->name == name;
        });
        if (found == table.end())
            unsupported("no section " + name + " of the scene " + scene + " with lemmas " + lemmas);
        section_ = *found;
        proof_.section = section_->name;
        proof_.tallies.push_back({"split"});
        for (const Opcode& opcode : section_->opcodes) proof_.tallies.push_back({opcode.name});
        proof_.tallies.push_back({"open"});
    }
    void header() {
        known("dumbbell-certificate", true, false, [](const std::string& version) { return version == "1"; });
        text_.expect("generator", 2);
        text_.require_word(1);
        text_.require_word(2, true);
        choose_section();
        const std::string kind = known("claim", false, true, [&](const std::string& word) {
            return section_ ? word == "collisions" : word == "initial-conditions" || adiabatic_kind(word);
        });
        adiabatic_ = adiabatic_kind(kind);
    }
    void range() {
        text_.expect("ratio", 2);
        end_ = claim_.lo = text_.ratio(1);
        claim_.hi = text_.ratio(2);
        if (claim_.lo < 1 || claim_.lo > claim_.hi) text_.reject("number", "not 1 <= LO <= HI");
        text_.expect("pieces", 1);
        const std::uint64_t k = text_.natural(1);
        if (k == 0) text_.reject("number", "no piece");
        Watched::pieces += k;
        if (settings_.check != all_pieces && settings_.check.last > k)
            misused("there is no piece " + std::to_string(settings_.check.last) + ": the file has " +
                    std::to_string(k) + (k == 1 ? " piece" : " pieces"));
    }

    /// Are the leaves of the present piece checked?
    [[nodiscard]] bool checked() const { return settings_.check.have(claim_.pieces + 1); }
    void piece() {
        Leaf leaf;
        text_.expect("piece", 2);
        const mpq_class a = text_.ratio(1), b = text_.ratio(2);
        if (a != end_ || a > b) text_.reject("chain", "a piece must begin where the one before ended");
        end_ = b;
        text_.expect("bits", 1);
        const std::uint64_t bits = text_.natural(1);
        if (bits < 53 || bits > 4096) text_.reject("number", "bits beyond 53 to 4096");
        if (checked() && bits > settings_.max_bits)
            throw Failure{Verdict::limit, text_.line, "limit", "see --max-bits"};
        leaf.bits = std::max(static_cast<unsigned>(bits), settings_.precision);
        leaf.multiple = settings_.precision > 0;
        text_.expect("upper", 1);
        std::optional<std::uint64_t> upper;
        if (text_.fields[1] != "none") {
            upper = leaf.claimed = text_.natural(1);
            proof_.roots += static_cast<double>(section_->charts.size());
            cover(leaf, a, b);
        } else {
            ++proof_.tallies.back().lines;
        }
        text_.expect("lower", 1);
        leaf.claimed = text_.natural(1);
        if (upper && leaf.claimed > *upper) text_.reject("number", "lower above upper");
        if (leaf.claimed > 0) {
            text_.expect("witness", 5);
            const mpq_class e = text_.dyadic(2), y = text_.dyadic(3);
            leaf.box = {{e, y, a}, {e, y, b}};
            take(leaf, Place::witness, 4, 0, "witness");
        }
        claim_.add(a, b, upper, leaf.claimed);
        ++Watched::read;
    }

    void cover(Leaf leaf, const mpq_class& a, const mpq_class& b) {
        for (std::size_t i = 0; i < section_->charts.size(); ++i) {
            leaf.box = section_->root(i, a, b);
            text_.next();
            if (i == 0 && text_.fields[0] != "chart")
                return take(leaf, Place::cover, 1, static_cast<double>(section_->charts.size()), "cover");
            std::string path(section_->charts[i].name);
            if (text_.fields.size() != 2 || text_.fields[0] != "chart" || text_.fields[1] != path)
                text_.reject("syntax", "expected `chart " + path + "`");
            leaf.chart = i;
            Tree<Box> tree{text_, section_->charts[i].axes, proof_.tallies[0].lines, leaf.box, path + '.'};
            tree.read([&] { take(leaf, Place::leaf, 1, std::ldexp(1, -tree.depth), tree.path); });
        }
    }

    /// The present line as one thing to check; its hints are the fields from number `hints` on.
    void take(Leaf leaf, Place place, std::size_t hints, double covered, const std::string& path) {
        const auto& fields = text_.fields;
        const auto& table = section_->opcodes;
        const auto fits = [&](const Opcode& o) {
            return o.name == fields[0] && o.place == place && (o.charts >> leaf.chart & 1) != 0;
        };
        const auto opcode = std::find_if(table.begin(), table.end(), fits);
        if (opcode == table.end()) text_.reject("opcode", "not a line for this place");
        if (fields.size() != hints + opcode->hints ||
            (place == Place::witness && fields[1] != section_->witness))
            text_.reject("syntax", "wrong number of values, or unknown kind");
        if (opcode->hints > 0) leaf.a = text_.natural(hints);
        if (opcode->hints > 1) leaf.b = text_.natural(hints + 1);
        leaf.opcode = static_cast<std::size_t>(opcode - table.begin());
        leaf.line = text_.line;
        ++proof_.tallies[1 + leaf.opcode].lines;
        proof_.tallies[1 + leaf.opcode].covered += covered;
        if (!settings_.explain.empty()) explain(leaf, path);
        if (checked()) pending_.push_back(std::move(leaf));
        if (pending_.size() == batch) check_pending();
    }
    /// Shows a referee the leaf that was asked for: its box, every inequality, and whether it holds.
    void explain(const Leaf& leaf, const std::string& path) {
        const std::string here = std::to_string(claim_.pieces + 1) + ":" + path, &wanted = settings_.explain;
        if (here != wanted && here != wanted + ".") return;
        proof_.explained = true;
        std::string text =
            wanted + ", line " + std::to_string(leaf.line) + ": " + text_.fields[0].data();  // the whole line
        dumbbell_verify::explain(text_, std::move(text),
                                 [&](std::string* log) { return section_->check(leaf, log); });
    }

    /// Checks what has been read; the failure on the least line is thrown.
    void check_pending() {
        const std::vector<Leaf> leaves = std::exchange(pending_, {});
        judge_all(leaves, settings_.jobs, text_.budget, [this](const Leaf& leaf) {
            return judge(leaf.line, section_->opcodes[leaf.opcode].name,
                         [&] { return section_->check(leaf, nullptr); });
        });
    }

    const Settings& settings_;
    const Section* section_ = nullptr;          ///< from line 5 on
    std::optional<Adiabatic::Kind> adiabatic_;  ///< from line 6 on
    Text text_;
    Proof proof_;
    Collisions& claim_ = proof_.claim;
    mpq_class end_;  ///< of the pieces so far
    std::vector<Leaf> pending_;
};

}  // namespace

Proof verify(const std::string& path, const Settings& settings) { return Reader(path, settings).run(); }

}  // namespace dumbbell_verify
