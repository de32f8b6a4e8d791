// What the readers of all claim kinds share: leaves that are checked together, the trailer, the verdict.
#pragma once
#include <optional>
#include <stdexcept>
#include <utility>

#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"

namespace dumbbell_verify {

constexpr std::size_t batch = 1024;  ///< leaves that are read before they are checked together

/// What `check` finds missing (nullptr: nothing), as the failure of this line.
template <class Check>
std::optional<Failure> judge(std::uint64_t line, std::string_view opcode, const Check& check) try {
    if (!arithmetic_works()) throw std::runtime_error("not IEEE 754: rounding mode or subnormals");
    const char* missing = check();
    if (!missing) return std::nullopt;
    return Failure{Verdict::rejected, line, std::string(opcode), std::string("not certified: ") + missing};
} catch (const std::exception& error) {
    return Failure{Verdict::limit, line, "limit", error.what()};
}

/// Judges all leaves, on `jobs` >= 1 threads and within the budget; the failure on the least line is thrown,
/// whichever thread finds it. A leaf that nobody has judged is a failure, too.
template <class Leaf, class Judge>
void judge_all(const std::vector<Leaf>& leaves, std::size_t jobs, Budget& budget, const Judge& judge_one) {
    std::vector<std::optional<Failure>> found(leaves.size(),
                                              Failure{Verdict::limit, 0, "limit", "not judged"});
    const auto costs = share_out(leaves.size(), jobs, budget, [&](std::size_t i) {
        found[i] = judge_one(leaves[i]);
        return !found[i];
    });
    for (std::size_t i = 0; i < leaves.size(); ++i) {
        budget.take(costs.at(i), leaves[i].line);
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
    Proof proof() {
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
    /// nullptr if the leaf is certified, else what is missing.
    [[nodiscard]] virtual const char* check(const Leaf& leaf, Log* log) const = 0;
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
        judge_all(std::vector{leaf}, 1, text_.budget, [&](const Leaf& only) {
            Log log;
            log.text = settings_.explain + ", line " + std::to_string(leaf.line) + ": " +
                       text_.fields[0].data() + shown;  // the whole line
            auto failure = judged(only, &log);
            log.show(!failure);
            return failure;
        });
    }

    const Settings& settings_;
    Text& text_;
    Proof proof_;

  private:
    [[nodiscard]] std::optional<Failure> judged(const Leaf& leaf, Log* log) const {
        return judge(leaf.line, opcode(leaf), [&] { return check(leaf, log); });
    }
    void check_pending() {
        const std::vector<Leaf> leaves = std::exchange(pending_, {});
        const std::size_t most = leaves.size() / worth_a_thread_ + 1;
        judge_all(leaves, std::min<std::size_t>(settings_.jobs, most), text_.budget,
                  [this](const Leaf& leaf) { return judged(leaf, nullptr); });
    }

    std::vector<Leaf> pending_;
    std::size_t worth_a_thread_ = 8;  ///< leaves: so many in double precision, one in more
};

}  // namespace dumbbell_verify
