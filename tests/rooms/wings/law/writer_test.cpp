#include "law/writer.hpp"

#include "base/error.hpp"
#include "catch.hpp"

using namespace dumbbell;
using namespace dumbbell::law;

TEST_CASE("a certificate of the law without all of its steps is not written") {
    CHECK_THROWS_AS(render(LawCertificate{}), BrokenInvariant);
}

TEST_CASE("boxes of the layer are halves of its sides, exactly at 0") {
    const LayerShares root;
    CHECK(root.box().U.lo() == 0);
    CHECK(root.box().U.hi() >= 0.9);
    CHECK(root.box().rho.lo() == 0);
    CHECK(root.box().rho.hi() >= 0.2);
    const auto [lower, upper] = root.halves(LayerAxis::rho);
    CHECK(lower.U == root.U);
    CHECK(lower.rho == std::pair(0.0, 0.5));
    CHECK(upper.rho == std::pair(0.5, 1.0));
    CHECK(upper.box().rho.lo() <= 0.1);
    CHECK(upper.box().rho.lo() > 0.0999);
}
