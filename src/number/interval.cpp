#include "number/interval.hpp"

#include <boost/numeric/interval/arith.hpp>
#include <boost/numeric/interval/arith2.hpp>
#include <boost/numeric/interval/checking.hpp>
#include <boost/numeric/interval/interval.hpp>
#include <boost/numeric/interval/policies.hpp>
#include <boost/numeric/interval/utility.hpp>

namespace dumbbell {
namespace {

namespace lib = boost::numeric::interval_lib;
using General =
    boost::numeric::interval<double, lib::policies<NeighbourRounding, lib::checking_base<double>>>;

General general(const Interval& x) { return {x.lo(), x.hi()}; }
Interval own(const General& x) { return {x.lower(), x.upper()}; }

}  // namespace

Interval Interval::hard_product(Interval a, Interval b) { return own(general(a) * general(b)); }
Interval Interval::hard_quotient(Interval a, Interval b) { return own(general(a) / general(b)); }

Interval sqrt(const Interval& a) { return own(boost::numeric::sqrt(general(a))); }
Interval abs(const Interval& a) { return own(boost::numeric::abs(general(a))); }

}  // namespace dumbbell
