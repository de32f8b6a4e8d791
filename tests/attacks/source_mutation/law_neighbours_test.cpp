// The verifier's law with one wrong sign or constant, for every one of them: the shipped certificate does not
// verify by it (law_neighbours.tsv).
#include <zlib.h>

#include <catch2/catch.hpp>
#include <sstream>
#include <vector>

#include "verify/law/leaf.hpp"
#include "verify/law/steps.hpp"

namespace patches {
extern int active;
int active = 0;
}  // namespace patches

namespace {

using namespace dumbbell_verify;

struct Neighbour {
    std::string cover, place, reason;  ///< the cover that is tried first; why none refuses it, or nothing
};
const std::vector<Neighbour> neighbours{
#include "neighbours.inc"
};

/// The steps and leaves of the shipped certificate.
struct Shipped {
    struct Step {
        std::uint64_t n;
        mpq_class a, b;
    };
    std::vector<Step> steps;
    std::vector<LawLeaf> layer, bulk, end;

    Shipped() {
        std::istringstream in(text());
        std::string line;
        while (std::getline(in, line) && line != "cover layer") {
            std::istringstream words(line);
            std::uint64_t n = 0;
            std::string a, b;
            if (line.starts_with("step ") && words >> line >> n >> a >> b)
                steps.push_back({n, mpq_class(a), mpq_class(b)});
        }
        tree(in, {{0, 0}, {mpq_class(9, 10), mpq_class(1, 5)}});
        const std::array<mpq_class, 4> ends{0, mpq_class(3, 5), mpq_class(7, 10), mpq_class(993, 1250)};
        for (std::string word; in >> word && word != "total";) {
            if (word != "cover") continue;
            in >> word;
            const bool is_end = word == "end";
            for (std::size_t range = 0; range < (is_end ? 1 : 3); ++range) {
                LawLeaf leaf;
                leaf.rule = is_end ? LawLeaf::end : LawLeaf::bulk;
                leaf.range = range;
                int n = 0;
                in >> n;
                const mpq_class lo = is_end ? mpq_class(0) : ends.at(range),
                                hi = is_end ? mpq_class(9, 100) : ends.at(range + 1);
                for (int i = 0; i < n; ++i) {
                    leaf.box.lo = {lo + (hi - lo) * i / n, 0};
                    leaf.box.hi = {lo + (hi - lo) * (i + 1) / n, 0};
                    (is_end ? end : bulk).push_back(leaf);
                }
            }
        }
    }

  private:
    static std::string text() {
        gzFile file = gzopen(DUMBBELL_PROJECT "/certificates/law.dbc.gz", "rb");
        std::string all(4'000'000, '\0');
        const int size = file ? gzread(file, all.data(), static_cast<unsigned>(all.size())) : 0;
        if (file) gzclose(file);
        all.resize(static_cast<std::size_t>(std::max(0, size)));
        return all;
    }
    void tree(std::istream& in, const LawBox& box) {
        std::string word;
        in >> word;
        if (word != "split") {
            LawLeaf leaf;
            leaf.box = box;
            leaf.rule = word == "slope"    ? LawLeaf::slope
                        : word == "direct" ? LawLeaf::direct
                                           : LawLeaf::beyond;
            return layer.push_back(leaf);
        }
        in >> word;
        const std::size_t axis = word == "U" ? 0 : 1;
        LawBox lower = box, upper = box;
        lower.hi.at(axis) = upper.lo.at(axis) = (box.lo.at(axis) + box.hi.at(axis)) / 2;
        tree(in, lower);
        tree(in, upper);
    }
};

const Shipped& shipped() {
    static const Shipped all;
    return all;
}

/// All leaves hold. They are taken in an order that soon has been everywhere.
template <class Check>
bool all_hold(const std::vector<LawLeaf>& leaves, const Check& check) {
    const std::size_t n = leaves.size(), stride = 7919;  // a prime that divides none of the numbers of leaves
    for (std::size_t i = 0; i < n; ++i)
        if (check(leaves[i * stride % n], nullptr)) return false;
    return true;
}

bool holds(const std::string& cover) {
    if (cover == "steps") {
        const StepPlaces<double> places;
        for (const auto& [n, a, b] : shipped().steps)
            if (places.check(n, a, b)) return false;
        return true;
    }
    if (cover == "layer")
        return !check_law_constant(53, false, nullptr) && all_hold(shipped().layer, check_law_layer);
    if (cover == "bulk")
        return !check_law_bulk_window(53, false, nullptr) && all_hold(shipped().bulk, check_law_bulk);
    return all_hold(shipped().end, check_law_end);
}

/// The cover that is named first, and then the others: whether all of them hold.
bool all_covers_hold(const std::string& first) {
    if (!holds(first)) return false;
    for (const char* cover : {"steps", "end", "bulk", "layer"})
        if (cover != first && !holds(cover)) return false;
    return true;
}

}  // namespace

TEST_CASE("every false neighbour of the law makes a cover of the shipped certificate fail") {
    REQUIRE(shipped().steps.size() == 900);
    REQUIRE(shipped().layer.size() == 52'301);
    REQUIRE(shipped().bulk.size() == 10'000);
    REQUIRE(shipped().end.size() == 1'500);
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        if (!neighbours[i].reason.empty()) continue;
        patches::active = static_cast<int>(i) + 1;
        INFO(neighbours[i].place);
        CHECK_FALSE(all_covers_hold(neighbours[i].cover));
    }
    patches::active = 0;
}

TEST_CASE("without a change all covers hold, and with those that the table says hold", "[.]") {
    patches::active = 0;
    CHECK(all_covers_hold("end"));
    for (std::size_t i = 0; i < neighbours.size(); ++i) {
        if (neighbours[i].reason.empty()) continue;
        patches::active = static_cast<int>(i) + 1;
        INFO(neighbours[i].place);
        CHECK(holds(neighbours[i].cover));
    }
    patches::active = 0;
}
