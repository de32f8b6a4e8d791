// Certificates with something false in them and a checksum that fits: each must be rejected.
#include <catch2/catch.hpp>

#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using Catch::Matchers::StartsWith;
using dumbbell::Certificate;
using dumbbell::Piece;
using dumbbell::Rational;

namespace {

template <class Change>
void check_rejected_after(const std::string& ratio, Change change) {
    const TemporaryFolder folder;
    Certificate certified = dumbbell::read_certificate(certificate(folder, ratio));
    write_file(folder / "honest.dbc", render(certified).text);
    REQUIRE(verifier({folder / "honest.dbc"}).code == 0);
    change(certified);
    write_file(folder / "tampered.dbc", render(certified).text);
    const Outcome result = verifier({folder / "tampered.dbc"});
    CAPTURE(ratio, result.out, result.err);
    CHECK(result.code == 1);
    CHECK_THAT(last_line(result.out), StartsWith("s REJECTED "));
}

dumbbell::Tree& bridge_tree(Piece& piece) { return piece.cover.charts.front().tree; }

}  // namespace

TEST_CASE("N-1 claimed with the same tree") {
    for (const char* ratio : {"10", "100", "1e4"}) {
        check_rejected_after(ratio, [](Certificate& c) {
            c.pieces[0].upper = *c.pieces[0].upper - 1;
            c.pieces[0].lower = 0;
            c.pieces[0].witness.reset();
        });
    }
}

TEST_CASE("N-1 claimed with smaller hints") {
    for (const char* ratio : {"10", "100", "1e4"}) {
        for (const bool forward : {true, false}) {
            check_rejected_after(ratio, [&](Certificate& c) {
                c.pieces[0].upper = *c.pieces[0].upper - 1;
                c.pieces[0].lower = 0;
                c.pieces[0].witness.reset();
                for (dumbbell::Node& node : bridge_tree(c.pieces[0])) {
                    --(forward ? node.leaf.forward : node.leaf.backward);
                }
            });
        }
    }
}

TEST_CASE("a piece that straddles a critical ratio claimed with one N") {
    check_rejected_after("5:11", [](Certificate& c) { c.pieces[0].q_hi = 12; });
    check_rejected_after("12:20", [](Certificate& c) { c.pieces[0].q_lo = 11; });
}

TEST_CASE("a leaf replaced by one without reason") {
    for (const auto reason :
         {dumbbell::Reason::outside, dumbbell::Reason::meets, dumbbell::Reason::meets_reversed}) {
        check_rejected_after("10", [&](Certificate& c) { bridge_tree(c.pieces[0])[0].leaf = {reason}; });
    }
}

TEST_CASE("a leaf removed, or lifted to its parent") {
    const char* split = "11.3622592";  // just below a critical ratio: the light chart is split
    const auto light = [](Certificate& c) -> dumbbell::Tree& { return c.pieces[0].cover.charts.back().tree; };
    check_rejected_after(split, [&](Certificate& c) {
        REQUIRE(light(c).size() > 1);
        light(c).pop_back();
    });
    check_rejected_after(split, [&](Certificate& c) {
        auto& tree = light(c);
        for (std::size_t i = 0; i + 2 < tree.size(); ++i) {
            if (tree[i].split && !tree[i + 1].split && !tree[i + 2].split) {
                tree.erase(tree.begin() + static_cast<std::ptrdiff_t>(i));
                tree.erase(tree.begin() + static_cast<std::ptrdiff_t>(i));
                return;
            }
        }
        FAIL("no two leaves under one parent");
    });
}

TEST_CASE("a witness that claims N+1, forwards or backwards") {
    for (const char* ratio : {"1", "10", "100", "1e4"}) {
        for (const bool forward : {true, false}) {
            check_rejected_after(ratio, [&](Certificate& c) {
                auto& piece = c.pieces[0];
                ++(forward ? piece.witness->forward : piece.witness->backward);
                ++piece.lower;
                ++*piece.upper;
            });
        }
    }
}

TEST_CASE("a lower bound beyond its witness") {
    check_rejected_after("10", [](Certificate& c) {
        ++c.pieces[0].lower;
        ++*c.pieces[0].upper;
    });
}

TEST_CASE("a witness in the corner, beyond the peak, tangential, or through the bridge") {
    check_rejected_after("10", [](Certificate& c) { c.pieces[0].witness->e = 0; });
    check_rejected_after("10", [](Certificate& c) { c.pieces[0].witness->e = 2; });
    check_rejected_after("10", [](Certificate& c) { c.pieces[0].witness->eta = 0; });
    check_rejected_after("10", [](Certificate& c) { c.pieces[0].witness->eta = 16; });
}

TEST_CASE("lemma L7 used away from equal masses") {
    check_rejected_after("1.1", [](Certificate& c) {
        c.pieces[0].cover = {};
        c.pieces[0].cover.equal_masses = true;
    });
}
