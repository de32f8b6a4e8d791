#include "truth.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <vector>

#include "attacks/oracle/tangents.hpp"
#include "number/rational.hpp"
#include "target.hpp"

namespace dumbbell_fuzz {
namespace {

constexpr std::size_t first_step = 3;

/// q_c(n) lies in [cut, cut + radius].
struct Step {
    mpq_class cut, radius;
};

mpq_class number(const std::string& text) { return mpq_class(dumbbell::parse_rational(text).raw()); }

/// Of q_c(3), q_c(4), ...
std::vector<Step> read_table() {
    std::ifstream in(DUMBBELL_PROJECT "/certificates/critical-ratios.tsv");
    std::vector<Step> steps;
    for (std::string line; std::getline(in, line);) {
        if (line.starts_with('#')) continue;
        std::istringstream fields(line);
        std::size_t n = 0;
        std::string ratio, radius;
        if (!(fields >> n >> ratio >> radius) || n != first_step + steps.size())
            throw std::runtime_error("the table of critical ratios: " + line);
        steps.push_back({number(ratio), number(radius)});
    }
    if (steps.size() < 900) throw std::runtime_error("the table of critical ratios is missing");
    return steps;
}

const std::vector<Step>& table() {
    static const std::vector<Step> steps = read_table();
    return steps;
}

/// least <= N*(q) <= most.
struct Bounds {
    std::uint64_t least = 0;
    std::uint64_t most = std::numeric_limits<std::uint64_t>::max();
};

/// N*(q) >= n iff q > q_c(n). Equal bounds, but for ratios within 1e-50 of a critical one, and beyond the
/// table (10^6), where there is no upper one.
Bounds of_dumbbell(const mpq_class& q) {
    const auto& steps = table();
    const auto first =
        std::partition_point(steps.begin(), steps.end(), [&](const Step& s) { return s.cut + s.radius < q; });
    const auto certain = static_cast<std::uint64_t>(first - steps.begin());
    Bounds result{first_step - 1 + certain};
    if (first != steps.end()) result.most = result.least + (q > first->cut ? 1 : 0);
    return result;
}

/// ceil(pi/angle), 1e-12 around a step.
Bounds of_angle(long double angle) {
    const long double value = std::acos(-1.0L) / angle;
    const auto natural = [](long double x) { return static_cast<std::uint64_t>(std::ceil(x)); };
    return {natural(value * (1 - 1e-12L)), natural(value * (1 + 1e-12L))};
}
Bounds of_symmetric(const mpq_class& q) {
    return of_angle(2 * std::atan(1 / std::sqrt(static_cast<long double>(q.get_d()))));
}
/// L72 or Theorem B of body.md, 1e-9 around a step; of long orbits L73 and L84 (a).
Bounds of_body(const dumbbell::Rational& rho, const mpq_class& q) {
    if (rho == 1) return of_symmetric(q);
    const double height = rho.convert_to<double>(), inertia = q.get_d();
    if (inertia <= 1000) {
        const auto most = [&](double share) {
            return dumbbell_oracle::TheoremB::of<long double>({height, inertia * (1 + share)}).maximum();
        };
        return {most(-1e-9), most(1e-9)};
    }
    const long double root = std::sqrt(static_cast<long double>(inertia));
    return {of_angle(std::acos(-1.0L) - std::atan(root) - std::atan(height * root)).least,
            of_symmetric(q).most + 2};
}

}  // namespace

mpq_class critical_ratio(std::size_t n) { return table().at(n - first_step).cut; }
std::size_t greatest_critical() { return first_step + table().size() - 1; }

void must_be_true(const dumbbell::collisions::Piece& piece, const std::optional<dumbbell::Rational>& height) {
    const mpq_class lo(piece.q_lo.raw()), hi(piece.q_hi.raw());
    // The maximum does not decrease with q or Q.
    const Bounds at_lo = height ? of_body(*height, lo) : of_dumbbell(lo),
                 at_hi = height ? of_body(*height, hi) : of_dumbbell(hi);
    if ((!piece.upper || *piece.upper >= at_hi.least) && piece.lower <= at_lo.most) return;
    trap("verified, but false: " + std::string(height ? "a body, Q " : "ratios ") + lo.get_str() + ":" +
         hi.get_str() + ", upper " + (piece.upper ? piece.upper->str() : "none") + ", lower " +
         piece.lower.str() + "; the maximum is at least " + std::to_string(at_hi.least) +
         " at the end, at most " + std::to_string(at_lo.most) + " at the beginning");
}

}  // namespace dumbbell_fuzz
