#include "law/writer.hpp"

#include <catch2/catch.hpp>

#include "base/error.hpp"

using namespace dumbbell;
using namespace dumbbell::law;

TEST_CASE("a certificate of the law without all of its steps is not written") {
    CHECK_THROWS_AS(render(LawCertificate{}), BrokenInvariant);
}

TEST_CASE("the certificate of one mass ratio names the ratio, the law's certificate and both bounds") {
    const std::string law(64, 'a');
    const SealedText written = render(AtRatio{Rational(Integer(7), Integer(3)), 3, 2, 3, {}}, law);
    CHECK(written.text ==
          "dumbbell-certificate 1\ngenerator dumbbell " DUMBBELL_VERSION
          "\nlemmas 1\nscene dumbbell\nsection none\nclaim collisions-by-law\nratio 7/3\nlaw " +
              law + "\nupper 3\nlower 2\nsha256 " + written.sha256 + "\n");
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
