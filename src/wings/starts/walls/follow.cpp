#include "starts/walls/follow.hpp"

namespace dumbbell::starts {

template Followed<Interval> follow(const State<Interval>&, long, Observer&, const Interrupted&);
template Followed<BigInterval> follow(const State<BigInterval>&, long, Observer&, const Interrupted&);
template Followed<Jet<Interval>> follow(const State<Jet<Interval>>&, long, Observer&, const Interrupted&);
template Followed<Jet<BigInterval>> follow(const State<Jet<BigInterval>>&, long, Observer&,
                                           const Interrupted&);

}  // namespace dumbbell::starts
