#pragma once

#include "flight/batch/bounce.hpp"
#include "flight/batch/lane_queue.hpp"

namespace dumbbell::flight::batch {

/// Rounds without a contact after which a lane gives up.
inline constexpr double most_rounds = 40;
/// Rounds between two questions whether to stop: some milliseconds.
inline constexpr long rounds_between_questions = 0x4000;

/// count_at_most (Bound: Lower) and count_at_least (Upper) of flight/count.hpp for a queue of rays, in n
/// packs; what happens to a ray does not depend on the others. A round is one tangent for each lane. It goes
/// in stages, each for all packs in turn: while one pack waits for a result the processor works on the next
/// one, and the numbers of one stage for one pack fit into the registers.
template <class D, int n, class Bound>
class CountLanes {
  public:
    CountLanes(const Query* queries, Answer* answers, long size)
        : queue_(queries, answers, size, Bound::outward) {}

    /// Writes the answers that it has; the others stay as they are if it is stopped.
    void run(Stop stop) {
        for (long rounds = 1; !queue_.empty(); ++rounds) {
            if (rounds % rounds_between_questions == 0 && stop.asks(stop.context)) {
                return;
            }
            round();
        }
    }

  private:
    using Numbers = typename LaneQueue<D, n>::Numbers;

    /// Flattened: packs are not passed in registers.
    [[gnu::flatten]] void round() {
        evaluate();
        if (look() != 0) {
            search();
        }
        bounce();
        if (aim() != 0 || queue_.brief) {
            aim_afresh();
        }
        finish();
    }

    void evaluate() {
        for (int i = 0; i < queue_.packs; ++i) {
            const SinCosOf<D> at = sin_cos(queue_.z[i]);
            sine_.put(i, at.sin);
            cosine_.put(i, at.cos);
        }
    }

    /// Bounds of the contacts, where they are close; which lanes have none.
    unsigned look() {
        unsigned searching = 0;
        for (int i = 0; i < queue_.packs; ++i) {
            const D c = queue_.c[i];
            const D kappa = queue_.kappa[i];
            const auto [place, near] = place_near(queue_.z[i], {sine_[i], cosine_[i]}, c, kappa);
            const Contact<D> contact = Bound::contact(place, c, kappa);
            z_.put(i, place.z);
            z_sine_.put(i, place.at.sin);
            z_cosine_.put(i, place.at.cos);
            inverse_.put(i, place.inverse);
            shift_.put(i, contact.shift);
            const Mask<D> hit = contact.close && near && !queue_.at_top[i];
            hit_[i] = hit;
            over_[i] = Lanes<D>::none();
            stuck_[i] = Lanes<D>::none();
            searching |= lanes(!(hit || queue_.idle[i]));
        }
        return searching;
    }

    /// For the lanes without a contact: the next point, or that there is none.
    void search() {
        for (int i = 0; i < queue_.packs; ++i) {
            const Mask<D> searching = !(hit_[i] || queue_.idle[i]);
            const D c = queue_.c[i];
            const D kappa = queue_.kappa[i];
            const D z = queue_.z[i];
            const SinCosOf<D> at{sine_[i], cosine_[i]};
            const Mask<D> over =
                searching && (kappa >= D(1.0) || strict_miss(z, at, c, kappa));  // L3, L12 (c)
            Aim<D> aim = step_to_contact(z_[i], at, kappa);
            if (lanes(queue_.at_top[i]) != 0) {
                const Aim<D> top = step_to_top(z, at, c, kappa);
                aim.z = select(queue_.at_top[i], top.z, aim.z);
                aim.at_top = select(queue_.at_top[i], top.at_top, aim.at_top);
            }
            const D room = queue_.room[i];
            const D rounds = select(room < queue_.then[i], D(0.0), queue_.rounds[i]) + 1.0;
            queue_.z.put(i, select(searching, aim.z, z));
            queue_.at_top[i] = searching && aim.at_top;
            queue_.rounds.put(i, select(searching, rounds, queue_.rounds[i]));
            queue_.then.put(i, select(searching, room, queue_.then[i]));
            over_[i] = over;
            stuck_[i] = searching && !over && rounds > D(most_rounds);
        }
    }

    void bounce() {
        for (int i = 0; i < queue_.packs; ++i) {
            const D kappa = queue_.kappa[i];
            const Mask<D> hit = hit_[i];
            const Bounce<D> next =
                Bound::bounce(z_[i], SinCosOf<D>{z_sine_[i], z_cosine_[i]}, shift_[i], kappa, queue_.r[i]);
            const D room = queue_.room[i];
            const D left = select(hit, room - 1.0, room);
            const Mask<D> stuck = hit && !next.ends && !next.follows;
            queue_.c.put(i, select(hit, next.c, queue_.c[i]));
            queue_.kappa.put(i, select(hit, next.kappa, kappa));
            queue_.room.put(i, left);
            queue_.clear[i] = queue_.clear[i] && (!hit || next.clear);
            stuck_[i] = stuck_[i] || stuck;
            over_[i] = over_[i] || (hit && next.ends) || Bound::full(left);
            sine_.put(i, next.at.sin);
            cosine_.put(i, next.at.cos);
        }
    }

    /// The next point after a contact, by a step from there; which lanes have none.
    unsigned aim() {
        unsigned lost = 0;
        for (int i = 0; i < queue_.packs; ++i) {
            const Mask<D> hit = hit_[i];
            const Aim<D> next = point_after(z_[i] + shift_[i], SinCosOf<D>{sine_[i], cosine_[i]},
                                            queue_.kappa[i], inverse_[i]);
            lost_[i] = hit && next.at_top;
            lost |= lanes(lost_[i]);
            queue_.z.put(i, select(hit, next.z, queue_.z[i]));
        }
        return lost;
    }

    /// The same where that step does not help: that there will be no contact, or the top; or the first point
    /// of a new ray.
    void aim_afresh() {
        for (int i = 0; i < queue_.packs; ++i) {
            const D c = queue_.c[i];
            const D kappa = queue_.kappa[i];
            Mask<D> lost = lost_[i];
            if (queue_.brief) {
                const Mask<D> brief = hit_[i] && queue_.r[i] > D(few_collisions);
                const D first = first_point(c, kappa);
                lost = select(brief, !(cosine_[i] > kappa && first < D(half_pi_hi)), lost);
                queue_.z.put(i, select(brief, first, queue_.z[i]));
            }
            const Mask<D> none = kappa >= D(1.0) ||  // L3
                                 strict_miss(z_[i], SinCosOf<D>{z_sine_[i], z_cosine_[i]}, c, kappa);
            queue_.z.put(i, select(lost, rough_top(kappa), queue_.z[i]));
            queue_.at_top[i] = queue_.at_top[i] || lost;
            over_[i] = over_[i] || (lost && !stuck_[i] && none);
        }
    }

    void finish() {
        for (int i = 0; i < queue_.packs; ++i) {
            const Mask<D> stuck = stuck_[i];
            const Mask<D> done = over_[i] || stuck;
            if (lanes(done) == 0) {
                continue;
            }
            queue_.room.put(i, select(stuck, Bound::undecided(queue_.room[i]), queue_.room[i]));
            queue_.clear[i] = queue_.clear[i] && !stuck;
            queue_.hand_in(i, done);
        }
    }

    LaneQueue<D, n> queue_;
    Numbers sine_, cosine_;          ///< at the point of the queue, then at the contact
    Numbers z_, z_sine_, z_cosine_;  ///< the place near the contact
    Numbers inverse_, shift_;
    Mask<D> hit_[n];
    Mask<D> over_[n];
    Mask<D> stuck_[n];
    Mask<D> lost_[n];
};

}  // namespace dumbbell::flight::batch
