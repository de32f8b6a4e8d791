// Rays at the edge of what few bits decide (near_rays.tsv): a formula, a pad or an end of an interval that is
// wrong moves a bound or a count there. The rays were found by random search among those that tell a mutant
// of the step from the step (tests/attacks/source_mutation/README.md).
#include <fstream>
#include <sstream>

#include "catch.hpp"
#include "flight/count.hpp"
#include "rays.hpp"

using namespace dumbbell;
using namespace dumbbell::flight;
using namespace dumbbell_test;

namespace {

constexpr long near_rays_cap = 30;

struct Row {
    int bits;
    DoubleRay ray;
    std::string found;
};

std::vector<Row> rows() {
    std::ifstream in(DUMBBELL_PROJECT "/tests/data/near_rays.tsv");
    std::vector<Row> table;
    for (std::string line; std::getline(in, line);) {
        if (line[0] == '#') {
            continue;
        }
        const std::size_t tab = line.find('\t');
        std::istringstream words(line.substr(0, tab));
        Row row{0, {}, line.substr(tab + 1)};
        words >> row.bits;
        for (double* x : {&row.ray.c, &row.ray.kappa, &row.ray.r}) {
            std::string word;
            words >> word;
            *x = std::stod(word);  // hexadecimal, exactly
        }
        table.push_back(row);
    }
    return table;
}

std::string show(const std::optional<Contact<BigInterval>>& at) {
    std::ostringstream out;
    if (!at) {
        return "none";
    }
    out << std::hexfloat << at->x.lo() << "," << at->sin_x.lo() << "," << at->cos_x.lo();
    return out.str();
}

}  // namespace

TEST_CASE("Rays near the edge of few bits have the same bounds and counts as before") {
    REQUIRE(rows().size() > 50);
    for (const auto& [bits, ray, expected] : rows()) {
        const PrecisionScope scope(bits);
        const BigInterval c(ray.c), kappa(ray.kappa);
        const std::string found = count_at_least(as<BigInterval>(ray), near_rays_cap).str() + " " +
                                  count_at_most(as<BigInterval>(ray), near_rays_cap).str() + " " +
                                  show(lowest_contact(c, kappa)) + " " + show(highest_contact(c, kappa));
        if (found != expected) {
            FAIL(bits << " bits, " << dumbbell_test::show(ray) << "\n  expected: " << expected
                      << "\n  found: " << found);
        }
    }
}
