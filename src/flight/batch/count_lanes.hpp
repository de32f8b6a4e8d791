#pragma once

#include "flight/batch/aim.hpp"
#include "flight/batch/query.hpp"
#include "flight/batch/step.hpp"

namespace dumbbell::flight::batch {

/// Rounds without a contact after which a lane gives up.
inline constexpr double most_rounds = 40;
inline constexpr double nan = __builtin_nan("");
/// Rounds between two questions whether to stop: some milliseconds.
inline constexpr long rounds_between_questions = 0x4000;

/// count_at_most (Bound: Lower) and count_at_least (Upper) of flight/count.hpp for a queue of rays. Each lane
/// follows its own, and takes the next one when it has its answer, so that packs stay full; what happens to a
/// ray does not depend on the others.
template <class D, class Bound>
class CountLanes {
  public:
    CountLanes(const Query* queries, Answer* answers, long size)
        : queries_(queries), answers_(answers), size_(size) {}

    /// Writes the answers that it has; the others stay as they are if it is stopped.
    void run(Stop stop) {
        for (int lane = 0; lane < Lanes<D>::width; ++lane) {
            take_next(lane);
        }
        for (long rounds = 1; busy_ > 0; ++rounds) {
            if (rounds % rounds_between_questions == 0 && stop.asks(stop.context)) {
                return;
            }
            const unsigned done = lanes(round());
            if (done != 0) {
                hand_in(done);
            }
        }
    }

  private:
    void hand_in(unsigned done) {
        Lanes<D>::store(counts_, count_);
        const unsigned clear = lanes(clear_);
        for (int lane = 0; lane < Lanes<D>::width; ++lane) {
            if (((done >> lane) & 1U) == 0) {
                continue;
            }
            if (owner_[lane] >= 0) {
                answers_[owner_[lane]] = {static_cast<long>(counts_[lane]), ((clear >> lane) & 1U) != 0};
                --busy_;
            }
            take_next(lane);
        }
    }

    /// A lane for which no query is left follows no ray, and gives up again and again.
    void take_next(int lane) {
        if (next_ == size_) {
            owner_[lane] = -1;
            put(lane, {{nan, nan, nan}, 0});
            return;
        }
        owner_[lane] = next_++;
        ++busy_;
        put(lane, queries_[owner_[lane]]);
    }

    void put(int lane, const Query& query) {
        const Mask<D> here = Lanes<D>::only(lane);
        const double r = query.ray.r > 0 && query.ray.r <= 1 ? query.ray.r : nan;
        // 0 and -1 are bounds of every ray that the query is about.
        c_ = select(here, D(query.ray.c < 0 ? 0 : query.ray.c), c_);
        kappa_ = select(here, D(query.ray.kappa < -1 ? -1 : query.ray.kappa), kappa_);
        r_ = select(here, D(r), r_);
        cap_ = select(here, D(static_cast<double>(query.cap)), cap_);
        count_ = select(here, D(0.0), count_);
        rounds_ = select(here, D(0.0), rounds_);
        fresh_ = fresh_ || here;
        clear_ = clear_ || here;
    }

    /// One tangent for each lane; which of them have their answer. Flattened: packs are not passed in
    /// registers.
    [[gnu::flatten]] Mask<D> round() {
        if (lanes(fresh_) != 0) {
            const Aim<D> first = first_aim(c_, kappa_);
            aim_.z = select(fresh_, first.z, aim_.z);
            aim_.at_top = select(fresh_, first.at_top, aim_.at_top);
        }
        const SinCosOf<D> at = sin_cos(aim_.z);
        const Contact<D> contact = Bound::contact(aim_.z, at, c_, kappa_);
        Mask<D> over = kappa_ >= D(1.0) || contact.beyond;  // L3
        if (lanes(aim_.at_top) != 0) {
            over = over || (aim_.at_top && strict_miss(aim_.z, at, c_, kappa_));
        }
        const Mask<D> hit = contact.close && !aim_.at_top && !over;
        const Mask<D> searching = !(hit || over);
        Mask<D> stuck = Lanes<D>::none();
        fresh_ = Lanes<D>::none();
        if (lanes(searching) != 0) {
            const Aim<D> next = next_aim(aim_, at, c_, kappa_);
            aim_.z = select(searching, next.z, aim_.z);
            aim_.at_top = select(searching, next.at_top, aim_.at_top);
            rounds_ = select(searching, rounds_ + 1.0, rounds_);
            stuck = searching && rounds_ > D(most_rounds);
        }
        if (lanes(hit) != 0) {
            const Bounce<D> next = Bound::bounce(aim_.z, at, contact.shift, kappa_, r_);
            count_ = select(hit, count_ + 1.0, count_);
            rounds_ = select(hit, D(0.0), rounds_);
            c_ = select(hit, next.c, c_);
            kappa_ = select(hit, next.kappa, kappa_);
            clear_ = clear_ && (!hit || next.clear);
            over = over || (hit && next.ends);
            stuck = stuck || (hit && !next.ends && !next.follows);
            fresh_ = hit;
        }
        count_ = select(stuck, Bound::undecided(count_, cap_), count_);
        clear_ = clear_ && !stuck;
        return over || stuck || Bound::full(count_, cap_);
    }

    const Query* queries_;
    Answer* answers_;
    long size_;
    long next_ = 0;
    long busy_ = 0;
    long owner_[Lanes<D>::width] = {};  ///< whose ray a lane follows; -1: nobody's
    double counts_[Lanes<D>::width] = {};

    D c_ = 0.0, kappa_ = 0.0, r_ = 1.0, cap_ = 0.0, count_ = 0.0;
    D rounds_ = 0.0;  ///< since the last contact
    Aim<D> aim_{0.0, Lanes<D>::none()};
    Mask<D> fresh_ = Lanes<D>::none();
    Mask<D> clear_ = Lanes<D>::none();
};

}  // namespace dumbbell::flight::batch
