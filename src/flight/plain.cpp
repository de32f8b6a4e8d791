#include "flight/plain.hpp"

namespace dumbbell::flight {

template long plain_count(PlainRay<Interval>, const Body<Interval>&, long, const Interrupted&);
template long plain_count(PlainRay<BigInterval>, const Body<BigInterval>&, long, const Interrupted&);
template long plain_later_collisions(PlainDeparture<Interval>, const Body<Interval>&, long,
                                     const Interrupted&);
template long plain_later_collisions(PlainDeparture<BigInterval>, const Body<BigInterval>&, long,
                                     const Interrupted&);

}  // namespace dumbbell::flight
