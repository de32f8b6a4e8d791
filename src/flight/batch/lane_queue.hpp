#pragma once

#include "flight/batch/aim.hpp"
#include "flight/batch/query.hpp"

namespace dumbbell::flight::batch {

/// Rays of a greater r have so few collisions that one does not tell where the next one is.
inline constexpr double few_collisions = 0x1p-10;

/// A queue of rays, and the n packs of lanes that follow them: each lane one, and the next one when it has
/// its answer, so that packs stay full.
template <class D, int n>
class LaneQueue {
  public:
    static constexpr int width = Lanes<D>::width;
    static constexpr double nan = __builtin_nan("");

    /// One double for each lane.
    struct Numbers {
        alignas(64) double of[n * width] = {};

        [[nodiscard]] D operator[](int pack) const { return Lanes<D>::load(of + pack * width); }
        void put(int pack, D value) { Lanes<D>::store(of + pack * width, value); }
    };

    /// `outward`: what r is multiplied by, to be a bound.
    LaneQueue(const Query* queries, Answer* answers, long size, double outward)
        : packs(size < long{n} * width ? static_cast<int>((size + width - 1) / width) : n),
          queries_(queries),
          answers_(answers),
          size_(size),
          outward_(outward) {
        for (int pack = 0; pack < n; ++pack) {
            for (int lane = 0; lane < width; ++lane) {
                owner_[pack * width + lane] = -1;
            }
            at_top[pack] = Lanes<D>::none();
            clear[pack] = Lanes<D>::none();
            hand_in(pack, !Lanes<D>::none());
        }
    }

    /// Takes the answers of these lanes of a pack, and gives them the next rays. A lane for which none is
    /// left is idle.
    void hand_in(int pack, Mask<D> done) {
        const unsigned clears = lanes(clear[pack]);
        for (unsigned left = lanes(done); left != 0; left &= left - 1) {
            const int bit = __builtin_ctz(left);
            const int lane = pack * width + bit;
            if (owner_[lane] >= 0) {
                const long cap = queries_[owner_[lane]].cap;
                answers_[owner_[lane]] = {cap - static_cast<long>(room.of[lane]),
                                          ((clears >> bit) & 1U) != 0};
                --busy_;
            }
            owner_[lane] = next_ < size_ ? next_ : -1;
            if (next_ < size_) {
                put(lane, queries_[next_++]);
                ++busy_;
            } else {
                put(lane, {{nan, nan, nan}, 0});
            }
        }
        idle[pack] = !(room[pack] <= D(static_cast<double>(greatest_cap)));
        at_top[pack] = at_top[pack] && !done;
        clear[pack] = clear[pack] || done;
        z.put(pack, select(done, first_point(c[pack], kappa[pack]), z[pack]));
    }

    [[nodiscard]] bool empty() const { return busy_ == 0; }

    const int packs;  ///< as many as are needed
    Numbers c, kappa, r;
    Numbers z;       ///< where the next contact is looked for
    Numbers room;    ///< collisions up to the cap, less those up to now
    Numbers rounds;  ///< of search, since the contact after which the room was
    Numbers then;    ///< this
    Mask<D> at_top[n];
    Mask<D> clear[n];
    Mask<D> idle[n];
    bool brief = false;  ///< any ray of few collisions

  private:
    void put(int lane, const Query& query) {
        // 0 and -1 are bounds of every ray that the query is about.
        c.of[lane] = query.ray.c < 0 ? 0 : query.ray.c;
        kappa.of[lane] = query.ray.kappa < -1 ? -1 : query.ray.kappa;
        r.of[lane] = query.ray.r >= 0x1p-900 && query.ray.r <= 1 ? query.ray.r * outward_ : nan;
        room.of[lane] = owner_[lane] < 0 ? nan : static_cast<double>(query.cap);
        rounds.of[lane] = 0;
        then.of[lane] = room.of[lane];
        brief = brief || query.ray.r > few_collisions;
    }

    const Query* queries_;
    Answer* answers_;
    long size_;
    double outward_;
    long next_ = 0;
    long busy_ = 0;
    long owner_[n * width];  ///< whose ray a lane follows; -1: nobody's
};

}  // namespace dumbbell::flight::batch
