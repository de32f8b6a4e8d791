// What the readers of all claim kinds share: trees, leaves that are checked together, the trailer.
#pragma once
#include <mpfr.h>

#include <atomic>
#include <functional>
#include <optional>
#include <span>
#include <stdexcept>
#include <utility>

#include "verify/format/proof.hpp"
#include "verify/format/text.hpp"
#include "verify/number/integer.hpp"
#include "verify/number/number.hpp"
#include "verify/number/threads.hpp"

namespace dumbbell_verify {

constexpr std::size_t batch = 1024;  ///< leaves that are read before they are checked together
constexpr int most_splits = 400;     ///< of one axis, above a node

/// Of all ends of a box, in words.
template <class Box>
std::uint64_t words_of(const Box& box) {
    std::uint64_t sum = 0;
    for (const auto* side : {&box.lo, &box.hi})
        for (const mpq_class& end : *side) sum += words(end);
    return sum;
}

/// A tree of halved boxes in pre-order: the leaves are halves of halves of the root box, together they cover
/// it.
template <class Box>
struct Tree {
    Text& text;
    std::span<const std::string_view> axes;
    std::uint64_t& splits;   ///< counts the lines `split`
    Box& box;                ///< of the present node; in the end the root box again
    std::string path;        ///< the halves (0 lower, 1 upper) from the root to here
    int most = most_splits;  ///< of one axis
    int depth = 0;
    std::array<int, std::tuple_size_v<decltype(Box::lo)>> depths{};  ///< splits of each axis above here

    /// A node above the present one: the side of its box that is halved.
    struct Halved {
        std::size_t axis;
        mpq_class lo, hi;
    };
    std::vector<Halved> above{};

    /// Of a line `split`.
    std::size_t axis() {
        const auto axis =
            text.fields.size() == 2 ? std::find(axes.begin(), axes.end(), text.fields[1]) : axes.end();
        if (axis == axes.end()) text.reject("syntax", "not an axis of this chart");
        const auto i = static_cast<std::size_t>(axis - axes.begin());
        if (++depths[i] > most)
            text.reject("depth", "more than " + std::to_string(most) + " splits of one axis");
        if (box.lo[i] == box.hi[i]) text.reject("split", "an axis of width 0");
        return i;
    }

    /// The whole tree; `leaf` is called at each line that is no split. Without recursion: a stack may be
    /// small.
    template <class Leaf>
    void read(const Leaf& leaf) {
        do {
            text.next();
            if (text.fields[0] == "split")
                halve(axis());
            else {
                text.budget.take(Work::of_box(words_of(box), depth), text.line);
                leaf();
                leave();
            }
        } while (!above.empty());
    }
    /// To the lower half.
    void halve(std::size_t i) {
        text.budget.take(Work::of_halving(words(box.lo[i]) + words(box.hi[i])), text.line);
        ++splits;
        ++depth;
        path += '0';
        above.push_back({i, box.lo[i], box.hi[i]});
        box.hi[i] = (box.lo[i] + box.hi[i]) / 2;
    }
    /// From what has been read to the next upper half; to the root if there is none.
    void leave() {
        while (!above.empty() && path.back() == '1') {
            Halved& node = above.back();
            box.lo[node.axis] = std::move(node.lo);
            --depth;
            --depths[node.axis];
            path.pop_back();
            above.pop_back();
        }
        if (above.empty()) return;
        const Halved& node = above.back();
        box.lo[node.axis] = box.hi[node.axis];
        box.hi[node.axis] = node.hi;
        path.back() = '1';
    }
};

/// What `check` finds missing (nullptr: nothing), as the failure of this line.
template <class Check>
std::optional<Failure> judge(std::uint64_t line, std::string_view opcode, const Check& check) try {
    if (!arithmetic_works()) throw std::runtime_error("not IEEE 754: rounding mode, subnormals or fma");
    const char* missing = check();
    if (!missing) return std::nullopt;
    return Failure{Verdict::rejected, line, std::string(opcode), std::string("not certified: ") + missing};
} catch (const std::exception& error) {
    return Failure{Verdict::limit, line, "limit", error.what()};
}

/// Judges all leaves, on `jobs` >= 1 threads and within the budget; the failure on the least line is thrown,
/// whichever thread finds it. Leaves after a failure are not judged; those before it have been taken before.
template <class Leaf, class Judge>
void judge_all(const std::vector<Leaf>& leaves, std::size_t jobs, Budget& budget, const Judge& judge_one) {
    std::vector<std::optional<Failure>> found(leaves.size());
    Shares shares(leaves.size(), budget.left());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> failed = false;
    const auto work = [&] {
        while (!failed) {
            const std::size_t i = next++;
            if (i >= leaves.size()) break;
            Work::begin(&shares, i);
            found[i] = judge_one(leaves[i]);
            if (!shares.note(i, Work::done()) || found[i]) failed = true;
        }
        Work::begin();
    };
    {
        Crew crew;
        crew.start(jobs - 1, std::cref(work));
        work();
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        budget.take(shares.of(i), leaves[i].line);
        if (found[i]) throw Failure(*found[i]);
    }
}

/// Reads the totals, the SHA-256, and the end.
inline void read_trailer(Text& text, Proof& proof) {
    for (const Tally& tally : proof.tallies) {
        text.expect("total", 2);
        if (text.fields[1] != tally.name || text.natural(2) != tally.lines)
            text.reject("total", "expected " + std::string(tally.name) + " " + std::to_string(tally.lines));
    }
    text.expect("sha256", 1);
    proof.digest = text.digest();
    if (text.fields[1] != proof.digest) text.reject("sha256", "expected " + proof.digest);
    text.end();
}

/// Reads a file from after its line `claim`. Leaves are checked many together, and the failure on the least
/// line is the one that is thrown.
template <class Leaf>
class Reader {
  public:
    Reader(Text& text, const Settings& settings) : settings_(settings), text_(text) {}
    virtual ~Reader() = default;
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    /// Returns only if all that the file and the demand say is certified.
    Proof run() {
        try {
            read();
            read_trailer(text_, proof_);
            check_pending();
            proof_.work = text_.budget.taken();
            if (const auto asked = settings_.demanded_scene(); !asked.empty() && asked != scene())
                text_.reject("claim-not-proved", "the scene is another");
            if (!settings_.claim.empty() && settings_.claim != kind())
                text_.reject("claim-not-proved", "the claim is another");
            if (const auto gap = missing(); !gap.empty()) text_.reject("claim-not-proved", gap);
        } catch (const Failure&) {
            check_pending();  // a leaf on an earlier line goes first
            throw;
        }
        return std::move(proof_);
    }

  protected:
    virtual void read() = 0;  ///< up to the trailer
    [[nodiscard]] virtual std::string_view kind() const = 0;
    [[nodiscard]] virtual std::string_view scene() const { return "dumbbell"; }
    /// What the demand asks and the file does not prove; empty: nothing.
    [[nodiscard]] virtual std::string missing() const { return ""; }
    /// nullptr if the leaf is certified, else what is missing; a log gets a line for every inequality.
    [[nodiscard]] virtual const char* check(const Leaf& leaf, std::string* log) const = 0;
    [[nodiscard]] virtual std::string_view opcode(const Leaf& leaf) const = 0;

    /// The line `bits`.
    void read_bits(Leaf& leaf) {
        text_.expect("bits", 1);
        const std::uint64_t bits = text_.natural(1);
        if (bits < 53 || bits > 4096) text_.reject("number", "bits outside 53 to 4096");
        if (bits > settings_.max_bits) throw Failure{Verdict::limit, text_.line, "limit", "see --max-bits"};
        leaf.bits = std::max(static_cast<unsigned>(bits), settings_.precision);
        leaf.multiple = settings_.precision > 0;
        if (leaf.bits > 53) worth_a_thread_ = 1;
    }
    /// The leaf is to be checked.
    void take(Leaf leaf) {
        pending_.push_back(std::move(leaf));
        if (pending_.size() == batch) check_pending();
    }
    [[nodiscard]] bool is_asked_for(const std::string& path) const {
        const std::string& wanted = settings_.explain;
        return !wanted.empty() && (path == wanted || path == wanted + ".");
    }
    /// Shows a referee the leaf if it is the one that was asked for: its line, what is `shown` of its box,
    /// every inequality, and whether it holds; within what is left of the budget.
    void explain(const Leaf& leaf, const std::string& path, const std::string& shown = "") {
        if (!is_asked_for(path)) return;
        proof_.explained = true;
        std::string text = settings_.explain + ", line " + std::to_string(leaf.line) + ": " +
                           text_.fields[0].data() + shown;  // the whole line
        judge_all(std::vector{leaf}, 1, text_.budget, [&](const Leaf& only) {
            return judge(only.line, opcode(only), [&]() -> const char* {
                text += check(only, &text) ? "  NOT certified\n" : "  certified\n";
                return nullptr;
            });
        });
        std::fputs(text.c_str(), stdout);
    }

    const Settings& settings_;
    Text& text_;
    Proof proof_;

  private:
    void check_pending() {
        const std::vector<Leaf> leaves = std::exchange(pending_, {});
        const std::size_t most = leaves.size() / worth_a_thread_ + 1;
        judge_all(leaves, std::min<std::size_t>(settings_.jobs, most), text_.budget,
                  [this](const Leaf& leaf) {
                      return judge(leaf.line, opcode(leaf), [&] { return check(leaf, nullptr); });
                  });
    }

    std::vector<Leaf> pending_;
    std::size_t worth_a_thread_ = 8;  ///< leaves: so many in double precision, one in more
};

}  // namespace dumbbell_verify
