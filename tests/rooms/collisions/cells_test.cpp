// Rectangles of bodies (plane.md): what is proved of them holds for bodies in them, and what can be is
// proved.
#include "collisions/cells.hpp"

#include <atomic>
#include <tuple>

#include "attacks/oracle/tangents.hpp"
#include "catch.hpp"
#include "number/parallel.hpp"
#include "scale.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;

namespace {

using dumbbell_oracle::Numbers;
using dumbbell_oracle::TheoremB;

Cells cells_of(double rho_lo, double rho_hi, double q_lo, double q_hi) {
    return prove_cells({{exact(rho_lo), exact(rho_hi)}, {exact(q_lo), exact(q_hi)}});
}

// 80 digits decide where it seems to be beyond what is proved.
bool is_within(const Numbers& n, const Cells& cells) {
    const auto fits = [&](const TheoremB& theorem) {
        const auto found = static_cast<long>(theorem.maximum());
        return cells.lower <= found && (!cells.upper || found <= *cells.upper);
    };
    return fits(TheoremB::of<long double>(n)) || fits(TheoremB::of<dumbbell_oracle::Digits80>(n));
}

}  // namespace

TEST_CASE("L87: bodies of a rectangle have no more and no fewer collisions than is proved of it") {
    dumbbell_oracle::Sampler sampler(1, 8701);
    int decided = 0, cut = 0;
    for (int i = 0; i < scaled(160); ++i) {
        const double wide = sampler.log_uniform(1e-3, 5), high = sampler.log_uniform(1e-3, 0.1),
                     rho = sampler.log_uniform(0.02, 1 / (1 + wide)), q = sampler.log_uniform(0.5, 150),
                     rho_hi = rho * (1 + wide), q_hi = q * (1 + high);
        const Cells cells = cells_of(rho, rho_hi, q, q_hi);
        decided += cells.is_decided();
        cut += cells.cells > 1;
        for (const double x : {0.0, sampler.uniform(0, 1), 1.0}) {
            for (const double y : {0.0, sampler.uniform(0, 1), 1.0}) {
                const Numbers n{std::min(rho + x * (rho_hi - rho), rho_hi),
                                std::min(q + y * (q_hi - q), q_hi)};
                INFO(n.rho << ' ' << n.q << " of " << rho << ' ' << rho_hi << ' ' << q << ' ' << q_hi);
                CHECK(is_within(n, cells));
            }
        }
    }
    CHECK((decided > 100 && cut > 2));
}

TEST_CASE("A rectangle is decided up to a thousandth of its width from the steps, in strips if need be") {
    for (const auto& [rho_lo, rho_hi, q_lo, q_hi, n, strips] :
         {std::tuple(0.40954596249011227, 0.48835534960380655, 30.799706956840303, 30.914147944455518, 6,
                     443),
          {0.3852776069962372, 0.42796344615684045, 30.996346024426572, 33.948655211727676, 7, 144},
          {0.39084506811193681, 0.46582853791294948, 59.622890358282319, 59.656548260713116, 8, 4},
          {0.8475309144249582, 0.99219787039570506, 25.253491210190663, 25.469048599244328, 8, 1},
          {0.12513698224614456, 0.12619919013768977, 5.9043466063543173, 6.3989264800762369, 4, 1},
          {0.95026029281811486, 0.96912390416650718, 2478.7679202674472, 2479.3725860207169, 77, 1},
          {0.43098017837834912, 0.99953638939317446, 2.3509245747492793, 2.3899308220586457, 3, 1},
          {1.0, 1.0, 4.0, 4.0, 4, 1},
          {0.28, 0.280001, 1e4, 1.0000001e4, 73, 1}}) {
        const Cells cells = cells_of(rho_lo, rho_hi, q_lo, q_hi);
        CHECK((cells.is_decided() && cells.lower == n && cells.cells <= strips));
    }
    const Cells across = cells_of(0.1, 0.9, 8, 100);
    CHECK((!across.is_decided() && across.lower == 3 && across.upper == 15 && across.cells == 1));
}

TEST_CASE(
    "A share that is wanted is reached, by one tree whatever the threads, which what is cut off keeps") {
    const Rectangle bodies{{exact(0.25), 1}, {2, 20}};
    const auto cells = [&](int jobs, const Interrupted& interrupted) {
        return with_threads(jobs, [&] { return prove_cells(bodies, 0.8, interrupted); });
    };
    const Cells found = cells(1, never);
    CHECK((found.share >= 0.8 && found.share < 0.95));
    CHECK(cells(3, never).certificate.sha256 == found.certificate.sha256);
    std::atomic<int> asked = 0;
    const Cells less = cells(1, [&] { return ++asked > 4'000; });
    CHECK((less.share > 0 && less.share < 0.8 && less.cells > 0));
}
