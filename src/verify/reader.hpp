// What the readers of all claim kinds share: trees, leaves that are checked together, the trailer.
#pragma once
#include <mpfr.h>

#include <atomic>
#include <optional>
#include <span>
#include <stdexcept>
#include <thread>

#include "certificate.hpp"
#include "number.hpp"

namespace dumbbell_verify {

constexpr std::size_t batch = 1024;  ///< leaves that are read before they are checked together
constexpr int most_splits = 400;     ///< of one axis, above a node

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

    /// A node and what is below; `leaf` is called at each line that is no split.
    template <class Leaf>
    void read(const Leaf& leaf) {
        text.next();
        if (text.fields[0] != "split") return leaf();
        const auto axis =
            text.fields.size() == 2 ? std::find(axes.begin(), axes.end(), text.fields[1]) : axes.end();
        if (axis == axes.end()) text.reject("syntax", "not an axis of this chart");
        const auto i = static_cast<std::size_t>(axis - axes.begin());
        if (++depths[i] > most)
            text.reject("depth", "more than " + std::to_string(most) + " splits of one axis");
        ++splits;
        ++depth;
        const mpq_class lo = box.lo[i], hi = box.hi[i], middle = (lo + hi) / 2;
        if (lo == hi) text.reject("split", "an axis of width 0");
        for (const bool upper : {false, true}) {
            box.lo[i] = upper ? middle : lo;
            box.hi[i] = upper ? hi : middle;
            path += upper ? '1' : '0';
            read(leaf);
            path.pop_back();
        }
        box.lo[i] = lo;
        --depth;
        --depths[i];
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

/// Judges all leaves, on up to `jobs` threads and within the budget; the failure on the least line is thrown,
/// whoever finds it. Leaves behind a failure are not judged; those before it have been taken before.
template <class Leaf, class Judge>
void judge_all(const std::vector<Leaf>& leaves, unsigned jobs, Budget& budget, const Judge& judge_one) {
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
        mpfr_free_cache();
    };
    {
        std::vector<std::jthread> crew(std::min<std::size_t>(jobs, leaves.size() / 8 + 1) - 1);
        for (std::jthread& thread : crew) thread = std::jthread(work);
        work();
    }
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        budget.take(shares.of(i), leaves[i].line);
        if (found[i]) throw Failure(*found[i]);
    }
}

/// Shows a leaf that a user asked for, within what is left of the budget.
template <class Check>
void explain(Text& text, std::string shown, const Check& check) {
    Shares alone(1, text.budget.left());
    Work::begin(&alone);
    shown += check(&shown) ? "  NOT certified\n" : "  certified\n";
    text.budget.take(Work::done(), text.line);
    Work::begin();
    std::fputs(shown.c_str(), stdout);
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

}  // namespace dumbbell_verify
