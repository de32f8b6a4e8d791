#include <CGAL/Interval_nt.h>

#include "operations.hpp"

void dumbbell_bench::measure_cgal() {
    using Unprotected = CGAL::Interval_nt<false>;  // its user keeps the rounding mode upward
    const auto upward = [] { return CGAL::Protect_FPU_rounding<true>(CGAL_FE_UPWARD); };
    measure_arithmetic("CGAL Interval_nt", upward, enclosures<Unprotected>);
}
