#include "cluster/kind.hpp"

#include <fmt/format.h>

#include "arith/error.hpp"
#include "arith/printable.hpp"
#include "cluster/collisions_kind.hpp"
#include "cluster/critical_kind.hpp"

namespace dumbbell {

const Kind& kind_named(std::string_view name) {
    static const CollisionsKind collisions;
    static const CriticalKind critical;
    if (name == "collisions") {
        return collisions;
    }
    if (name == "critical") {
        return critical;
    }
    throw InputError(fmt::format("there are no campaigns of the kind '{}'", printable(name, 40)));
}

}  // namespace dumbbell
