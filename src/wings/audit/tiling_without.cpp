// In the place of tiling.cpp where there is no CGAL.
#include "audit/tiling.hpp"
#include "base/error.hpp"

namespace dumbbell::audit {

void need_exact_geometry() {
    throw InputError("this dumbbell was built without CGAL, by which it would prove that leaves tile");
}

Tiling check_tiling(const collisions::Boxes& /*boxes*/, const TilingProgress& /*progress*/) {
    throw BrokenInvariant("a tiling is checked without CGAL");
}

}  // namespace dumbbell::audit
