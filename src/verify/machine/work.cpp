// What a file may cost, and the threads that share it out.
#include <stdexcept>

#include "verify/core/text.hpp"
#include "verify/machine/integer.hpp"
#include "verify/machine/meter.hpp"
#include "verify/machine/seconds.hpp"
#include "verify/machine/threads.hpp"

namespace dumbbell_verify {
namespace {

constexpr std::uint64_t look_step = 1 << 24;    ///< between two looks at the shares
constexpr std::uint64_t leaf_itself = 1 << 14;  ///< its box, and inequalities without a ray

struct Present {
    std::uint64_t done = 0, look = UINT64_MAX;
    Shares* shares = nullptr;
    std::size_t leaf = 0;
};
thread_local Present present;

std::uint64_t limbs_of(const mpq_class& x) { return limbs(x.get_num()) + limbs(x.get_den()); }

}  // namespace

void Budget::take(std::uint64_t units, std::uint64_t line) {
    const bool enough = units <= left_;
    left_ -= enough ? units : left_;
    if (!enough)
        throw Failure{Verdict::limit, line, "limit",
                      "more work than the budget of " + seconds(all_) + ": --budget allows more"};
}

void Meter::begin(Shares* shares, std::size_t leaf) {
    present = {0, shares ? look_step : UINT64_MAX, shares, leaf};
    Meter::spend(leaf_itself);
}
std::uint64_t Meter::done() { return present.done; }

void Meter::spend(std::uint64_t units) {
    present.done += units;
    if (present.done < present.look) return;
    present.look = present.done + look_step;
    if (!present.shares->note(present.leaf, present.done)) throw std::length_error("the budget is used up");
}
void Work::operation(std::uint64_t bits) { Meter::spend(256 + bits); }
/// With more bits the operations are most of the work.
void Work::collision() { Meter::spend(4096); }
/// Mostly a greatest common divisor.
std::uint64_t Work::of_halving(const mpq_class& lo, const mpq_class& hi) {
    const std::uint64_t size = limbs_of(lo) + limbs_of(hi);
    return 512 + 320 * size + size * size / 2;
}
std::uint64_t Work::of_box(Ends lo, Ends hi, int depth) {
    std::uint64_t size = 0;
    for (const Ends ends : {lo, hi})
        for (const mpq_class& end : ends) size += limbs_of(end);
    return 1024 + 64 * size + static_cast<std::uint64_t>(depth);
}

std::vector<std::uint64_t> share_out(std::size_t n, std::size_t threads, const Budget& budget,
                                     const std::function<bool(std::size_t)>& task) {
    Shares shares(n, budget.left());
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> over = false;
    const auto work = [&] {
        while (!over) {
            const std::size_t i = next++;
            if (i >= n) break;
            Meter::begin(&shares, i);
            const bool good = task(i);
            if (!shares.note(i, Meter::done()) || !good) over = true;
        }
        Meter::begin();
    };
    {
        Crew crew;
        crew.start(threads - 1, std::cref(work));
        work();
    }
    std::vector<std::uint64_t> costs(n);
    for (std::size_t i = 0; i < n; ++i) costs[i] = shares.of(i);
    return costs;
}

}  // namespace dumbbell_verify
