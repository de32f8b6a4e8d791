// The rules of the law's covers against true steps in 80 digits: what a box encloses holds the truth, and in
// a small box it is so narrow that a wrong constant or sign would not.
#include "verify/wings/law/leaf.hpp"

#include "catch.hpp"
#include "rooms/number/random.hpp"
#include "scale.hpp"
#include "truth.hpp"
#include "verify/core/big.hpp"
#include "verify/wings/law/constants.hpp"

using namespace dumbbell_verify;
using law_truth::enclosure;

namespace {

dumbbell_test::Random law_random(20261122);

const char* const excess_fact = "(1 - D/D0(T))/y - 5/(3 pi) is not too small";
const char* const drift_fact = "a/(2 ehat^2)";

/// A true step of the layer, J at `share` of its window pi/2 + [-5.3 eps^2/u^3, eps^2/4], times `window`.
struct LayerTruth {
    law_truth::Real excess, drift, eps, offset;  ///< offset: (Q - pi/2)/(rho^2 U)
    LayerTruth(double U_, double rho_, double share, const law_truth::Real& factor = 1, double window = 1) {
        const law_truth::Real U = U_, rho = rho_, d = U * rho;
        law_truth::Real Q = law_truth::pi() / 2;
        for (int i = 0; i < 60; ++i) {
            const law_truth::Step step(U, rho, Q);
            const law_truth::Real lo = -law_truth::Real("5.3") * step.eps * step.eps / pow(step.u, 3),
                                  hi = step.eps * step.eps / 4;
            Q += law_truth::pi() / 2 + law_truth::Real(window) * (lo + (hi - lo) * law_truth::Real(share)) -
                 step.j;
        }
        const law_truth::Step step(U, rho, Q);
        eps = step.eps;
        offset = (Q - law_truth::pi() / 2) / (U * rho * rho);
        const law_truth::Real T = law_truth::tau(step.u, step.j) / (2 * eps),
                              after = law_truth::tau(step.v, step.j_v) / (2 * eps);
        const law_truth::Real D0 = factor * law_truth::k0() * sqrt(eps) * pow(sqrt(T) - sqrt(T - 1), 3);
        const law_truth::Real y =
            sqrt(sqrt(law_truth::Real(3)) * law_truth::pi() * eps) * (sqrt(T) + sqrt(T - 1));
        excess = (1 - (T - 1 - after) / D0) / y - 5 / (3 * law_truth::pi());
        drift = (step.j - step.j_v) * pow(U, 4) / (2 * d * eps * eps);
    }
};

/// A box with the point in it, of these widths; not beyond the layer.
law::Leaf layer_leaf(law::Leaf::Rule rule, double U, double rho, double width_U, double width_rho) {
    law::Leaf leaf;
    leaf.rule = rule;
    const double point[] = {U, rho}, width[] = {width_U, width_rho}, most[] = {0.9, 0.2};
    for (std::size_t i = 0; i < 2; ++i) {
        const double lo = std::max(0.0, point[i] - law_random.uniform(0, width[i]));
        leaf.box.lo.at(i) = mpq_class(lo);
        leaf.box.hi.at(i) = mpq_class(std::max(point[i], std::min(most[i], lo + width[i])));
    }
    return leaf;
}
bool holds_truth(const std::pair<double, double>& x, const law_truth::Real& truth) {
    return x.first <= truth && truth <= x.second;
}

}  // namespace

TEST_CASE("law: the constants hold their values in 80 digits") {
    const law_truth::Real C = law_truth::tau_by_angle<law_truth::Real>(0, law_truth::pi() / 2);
    const law_truth::Real zeta =
        [] {  // -6 zeta(-1/2), the sum of (sqrt n - sqrt(n - 1))^3 with its tail expanded
            law_truth::Real sum = 0;
            const int m = 2000;
            for (int n = 1; n <= m; ++n)
                sum += pow(sqrt(law_truth::Real(n)) - sqrt(law_truth::Real(n - 1)), 3);
            return sum + 1 / (4 * sqrt(law_truth::Real(m)));
        }();
    const auto growth = law::growth_constant<double>(), comparison = law::comparison_constant<double>(),
               law = law::law_constant<double>();
    CHECK(abs(C - law_truth::Real(law_truth::C)) < 1e-60);
    CHECK(holds_truth({growth.lo, growth.hi}, C));
    CHECK(growth.hi - growth.lo < 1e-8);
    CHECK(holds_truth({comparison.lo, comparison.hi}, law_truth::k0()));
    CHECK(comparison.hi - comparison.lo < 1e-15);
    CHECK(abs(2 * zeta * law_truth::k0() - (law_truth::Real(law.lo) + law.hi) / 2) < 1e-6);
    CHECK(holds_truth({law.lo, law.hi}, law_truth::Real(law_truth::c0)));
    CHECK(law.hi - law.lo < 1e-9);
    CHECK(law::check_constant(53, false, nullptr) == nullptr);
    CHECK(law::check_constant(120, true, nullptr) == nullptr);
    CHECK(law::check_bulk_window(53, false, nullptr) == nullptr);
    CHECK(law::check_bulk_window(80, true, nullptr) == nullptr);
}

TEST_CASE("law: a box of the layer holds the defect and the drift of its steps") {
    long passed = 0;
    const long boxes = scaled(100);
    for (long i = 0; i < boxes; ++i) {
        const double U = i % 4 == 0 ? law_random.log_uniform(1e-6, 0.9) : law_random.uniform(0.01, 0.9);
        const double rho = law_random.log_uniform(1e-5, std::min(0.2, 2e-3 / (U * U)));
        const LayerTruth truth(U, rho, law_random.uniform(0, 1));
        if (truth.eps > 1e-3) continue;
        for (const double widest : {0.002, 0.02}) {
            law::Leaf leaf = layer_leaf(law::Leaf::slope, U, rho, law_random.log_uniform(1e-9, widest),
                                        law_random.log_uniform(1e-9, widest / 4));
            Log log;
            passed += law::check_layer(leaf, &log) == nullptr;
            const auto excess = enclosure(log.text, excess_fact);
            INFO("U " << U << " rho " << rho << " excess " << truth.excess << " drift " << truth.drift << "\n"
                      << log.text);
            REQUIRE(excess.first <= excess.second);
            REQUIRE(holds_truth(excess, truth.excess));
            if (const auto drift = enclosure(log.text, drift_fact); drift.first <= drift.second)
                REQUIRE(holds_truth(drift, truth.drift));
            leaf.rule = law::Leaf::beyond;
            REQUIRE(law::check_layer(leaf, nullptr) != nullptr);
        }
    }
    CHECK(passed > boxes / 2);
}

TEST_CASE(
    "law: in a point of the layer the defect is known so well that a constant a little off would show") {
    for (const auto& [U, rho, width] : {std::tuple{0x1p-10, 0.125, 0.01},
                                        {0x1p-10, 0.1875, 0.02},
                                        {0.25, 0.03125, 0.02},
                                        {0.5, 0x1p-7, 0.03},
                                        {0.875, 0x1p-9, 0.08}}) {
        law::Leaf leaf;
        leaf.rule = law::Leaf::slope;
        leaf.box = {{mpq_class(U), mpq_class(rho)}, {mpq_class(U), mpq_class(rho)}};
        Log log;
        CHECK(law::check_layer(leaf, &log) == nullptr);
        const auto excess = enclosure(log.text, excess_fact);
        INFO("U " << U << " rho " << rho << "\n" << log.text);
        CHECK(excess.second - excess.first < width);
        for (const double share : {0.0, 0.5, 1.0})
            CHECK(holds_truth(excess, LayerTruth(U, rho, share).excess));
        // k0 larger or smaller by this would be out of the box.
        const law_truth::Real off = 2 * law_truth::Real(width) * law_truth::Real(U);
        CHECK_FALSE(holds_truth(excess, LayerTruth(U, rho, 0.5, 1 + off).excess));
        CHECK_FALSE(holds_truth(excess, LayerTruth(U, rho, 0.5, 1 - off).excess));
    }
}

TEST_CASE("law: if J is known, a point of the layer is known to many digits") {
    law::States exact;
    exact.drift = exact.rise = 0;
    exact.parts = 200;
    for (long i = 0; i < scaled(60); ++i) {
        const double U = i % 2 == 0 ? law_random.log_uniform(1e-3, 0.9) : law_random.uniform(0.1, 0.9);
        const double rho = law_random.log_uniform(1e-4, std::min(0.2, 2e-3 / (U * U)));
        const LayerTruth truth(U, rho, 0, 1, 0);
        law::Leaf leaf;
        leaf.rule = law::Leaf::slope;
        leaf.states = &exact;
        leaf.box = {{mpq_class(U), mpq_class(rho)}, {mpq_class(U), mpq_class(rho)}};
        Log log;
        law::check_layer(leaf, &log);
        const auto excess = enclosure(log.text, excess_fact), drift = enclosure(log.text, drift_fact);
        INFO("U " << U << " rho " << rho << " excess " << truth.excess << " drift " << truth.drift << "\n"
                  << log.text);
        REQUIRE(holds_truth(excess, truth.excess));
        const auto q = law_truth::bounds(log.text, "(Q - pi/2)/(rho^2 U)");
        REQUIRE(holds_truth(q, truth.offset));
        REQUIRE(q.second - q.first < 1e-6);
        REQUIRE(holds_truth(drift, truth.drift));
        REQUIRE(excess.second - excess.first < 0.005 + rho / 10);
        REQUIRE(drift.second - drift.first < 1e-4);
    }
}

TEST_CASE("law: with more bits the rules say the same") {
    law::Leaf leaf;
    leaf.bits = 120;
    leaf.multiple = true;
    leaf.box = {{mpq_class(1, 2), 0}, {mpq_class(501, 1000), mpq_class(1, 1000)}};
    for (const auto rule : {law::Leaf::slope, law::Leaf::beyond}) {
        leaf.rule = rule;
        CHECK((law::check_layer(leaf, nullptr) == nullptr) == (rule != law::Leaf::beyond));
    }
    leaf.box = {{mpq_class(4, 5), mpq_class(1, 10)}, {mpq_class(9, 10), mpq_class(1, 5)}};
    CHECK(law::check_layer(leaf, nullptr) == nullptr);
    leaf.box = {{mpq_class(1, 10), 0}, {mpq_class(1001, 10'000), 0}};
    CHECK(law::check_bulk(leaf, nullptr) == nullptr);
    leaf.box = {{mpq_class(1, 100), 0}, {mpq_class(1001, 100'000), 0}};
    CHECK(law::check_end(leaf, nullptr) == nullptr);
}

TEST_CASE("law: a leaf is refused where its inequality is false") {
    const auto verdict = [](law::Leaf::Rule rule, double U, double rho, double U_hi, double rho_hi) {
        law::Leaf leaf;
        leaf.rule = rule;
        leaf.box = {{mpq_class(U), mpq_class(rho)}, {mpq_class(U_hi), mpq_class(rho_hi)}};
        const char* missing = law::check_layer(leaf, nullptr);
        return std::string(missing ? missing : "certified");
    };
    CHECK(verdict(law::Leaf::slope, 0, 0, 0x1p-12, 0x1p-12) == "certified");
    CHECK(verdict(law::Leaf::slope, 0.5, 0, 0.5, 0x1p-12) == "certified");
    // The whole layer in one box says nothing, by any rule.
    for (const auto rule : {law::Leaf::slope, law::Leaf::beyond})
        CHECK(verdict(rule, 0.001, 0, 0.9, 0.2) != "certified");
    // eps = 1/1000 runs through the layer: on both sides of it.
    CHECK(verdict(law::Leaf::beyond, 0.5, 0.0145, 0.5, 0.0145) != "certified");
    CHECK(LayerTruth(0.5, 0.0145, 0.5).eps < 1e-3);
    CHECK(verdict(law::Leaf::beyond, 0.5, 0.0165, 0.5, 0.0165) == "certified");
    CHECK(LayerTruth(0.5, 0.0165, 0.5).eps > 1e-3);
}

TEST_CASE("law: a part of the bulk holds the defect and the drift of its steps") {
    for (long i = 0; i < scaled(40); ++i) {
        const std::size_t range = static_cast<std::size_t>(i) % 3;
        const double ends[] = {0.002, 0.6, 0.7, 0.7944};
        const double th = law_random.uniform(ends[range], ends[range + 1]),
                     eps = law_random.log_uniform(1e-8, 1e-3);
        const double offset = law_random.uniform(-1e-5, 3e-5);
        const law_truth::Real Q = law_truth::pi() / 2 + law_truth::Real(offset),
                              F = Q / cos(law_truth::Real(th)), U = law_truth::pi() - F;
        const law_truth::Step step(U, asin(law_truth::Real(eps) * tan(law_truth::Real(th)) * F / sin(U)) / U,
                                   Q);
        if (step.alpha() < 0 || step.u > law_truth::pi() / 2) continue;
        const law_truth::Real angles = step.alpha_v() - step.alpha();
        const law_truth::Real D = (law_truth::tau_by_angle(step.alpha(), step.j) -
                                   law_truth::tau_by_angle(step.alpha_v(), step.j_v)) /
                                      (2 * step.eps) -
                                  1;
        law::Leaf leaf;
        leaf.rule = law::Leaf::bulk;
        leaf.range = range;
        const double width = law_random.log_uniform(1e-9, 1e-3);
        leaf.box.lo[0] = mpq_class(th - law_random.uniform(0, width));
        leaf.box.hi[0] = leaf.box.lo[0] + mpq_class(width);
        if (leaf.box.hi[0] < mpq_class(th)) leaf.box.hi[0] = mpq_class(th);
        Log log;
        law::check_bulk(leaf, &log);
        const law_truth::Real M = 2 * D / (step.eps * angles),
                              fall = (step.j - step.j_v) / (step.eps * step.eps * angles);
        INFO("th " << th << " eps " << eps << " M " << M << " fall " << fall << "\n" << log.text);
        REQUIRE(abs(step.eps / law_truth::Real(eps) - 1) < 1e-60);
        const auto enclosed = enclosure(log.text, "|D/((eps/2) (alpha' - alpha))");
        REQUIRE(holds_truth(enclosed, M));
        if (th < 0.6) REQUIRE(enclosed.second - enclosed.first < 0.08 + 10 * width);
        if (const auto drift = enclosure(log.text, "(J - J')/(eps^2"); drift.first <= drift.second)
            REQUIRE(holds_truth(drift, fall));
        // If all is known: to more digits.
        law::States exact;
        exact.parts = 600;
        exact.least_eps = exact.most_eps = mpq_class(eps);
        exact.least_Q = exact.most_Q = mpq_class(offset);
        leaf.states = &exact;
        leaf.box.lo[0] = leaf.box.hi[0] = mpq_class(th);
        log.text.clear();
        law::check_bulk(leaf, &log);
        const auto sharp = enclosure(log.text, "|D/((eps/2) (alpha' - alpha))");
        INFO(log.text);
        REQUIRE(holds_truth(sharp, M));
        REQUIRE(sharp.second - sharp.first < 0.01 + 200 * eps);
        if (const auto drift = enclosure(log.text, "(J - J')/(eps^2"); drift.first <= drift.second) {
            REQUIRE(holds_truth(drift, fall));
            REQUIRE(drift.second - drift.first < 1e-4);
        }
    }
}

TEST_CASE("law: a part of the end holds what the last contact loses") {
    for (long i = 0; i < scaled(20); ++i) {
        const double d_ = i % 3 == 0 ? law_random.log_uniform(1e-8, 0.07) : law_random.uniform(1e-3, 0.0713),
                     share = law_random.uniform(0, 1);
        const law_truth::Real d = d_;
        law_truth::Real Q = law_truth::pi() / 2;
        const bool exact = i % 2 == 0;  // J = pi/2
        for (int round = 0; round < 60; ++round) {
            const law_truth::End end(d, acos(Q / (law_truth::pi() - d)));
            const law_truth::Real lo = -law_truth::Real("5.3") * end.eps * end.eps / pow(end.u, 3),
                                  hi = end.eps * end.eps / 4;
            Q += law_truth::pi() / 2 +
                 (exact ? law_truth::Real(0) : law_truth::Real(lo + (hi - lo) * law_truth::Real(share))) -
                 end.J;
        }
        const law_truth::End end(d, acos(Q / (law_truth::pi() - d)));
        if (end.eps > 1e-3) continue;
        const law_truth::Real loss = law_truth::tau(end.u, end.J) / (2 * end.eps) - 1;
        const law_truth::Real truth = (loss - law_truth::k0() * sqrt(end.eps)) / end.eps;
        law::Leaf leaf;
        leaf.rule = law::Leaf::end;
        leaf.box.lo[0] = mpq_class(std::max(0.0, d_ - law_random.uniform(0, 3e-5)));
        leaf.box.hi[0] = mpq_class(std::max(d_, leaf.box.lo[0].get_d() + 6e-5));
        law::States known;
        known.drift = known.rise = 0;
        known.parts = 200;
        if (exact) leaf.states = &known, leaf.box.lo[0] = leaf.box.hi[0] = mpq_class(d_);
        Log log;
        const bool certified = law::check_end(leaf, &log) == nullptr;
        INFO("d " << d_ << " truth " << truth << "\n" << log.text);
        REQUIRE(certified);
        const auto enclosed = enclosure(log.text, "|(e_end - k0");
        const auto q = law_truth::bounds(log.text, "(Q - pi/2)/d");
        REQUIRE(holds_truth(q, law_truth::Real((Q - law_truth::pi() / 2) / d)));
        if (exact) REQUIRE(q.second - q.first < 5e-6);
        REQUIRE(holds_truth(enclosed, truth));
        REQUIRE(enclosed.second - enclosed.first < (exact ? 0.03 : 0.07));
    }
    law::Leaf beyond;
    beyond.rule = law::Leaf::end;
    beyond.box.lo[0] = mpq_class(760, 10'000);
    beyond.box.hi[0] = mpq_class(761, 10'000);
    CHECK(law::check_end(beyond, nullptr) == nullptr);
    beyond.box.lo[0] = mpq_class(700, 10'000);
    CHECK(law::check_end(beyond, nullptr) != nullptr);
}
