// Bodies with mass between their contacts (body.md): what is proved of them.
#include <algorithm>
#include <tuple>
#include <vector>

#include "catch.hpp"
#include "collisions/certify.hpp"
#include "collisions/writer.hpp"
#include "flight/paper_bound.hpp"
#include "reference.hpp"
#include "scale.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell_test;

namespace {

CertifyRequest of_body(const Rational& rho, const Rational& q_lo, const Rational& q_hi) {
    return {.claim = {.range = {q_lo, q_hi}, .system = {Section::body, rho}}};
}

Piece proved(const Rational& rho, const Rational& q, bool by_plain = false) {
    auto request = of_body(rho, q, q);
    if (by_plain) {
        request.claim = by_plain_covers(request.claim);
    }
    const auto pieces = certify(request);
    REQUIRE(pieces.size() == 1);
    return pieces.front().piece;
}

long maximum(const Piece& piece) { return piece.status() == Status::exact ? as_long(piece.lower) : 0; }

}  // namespace

TEST_CASE("A coin has 4 collisions, a uniform rod 3, equal masses 2, by orbits and by a lemma") {
    for (const auto& [q, n] : {std::pair(4, 4L), {3, 3L}, {1, 2L}}) {
        for (const bool by_plain : {false, true}) {
            const Piece piece = proved(1, q, by_plain);
            CHECK(maximum(piece) == n);
            CHECK(piece.cover.symmetric == by_plain);
            CHECK(piece.witness->place == Place::corner);
        }
    }
}

TEST_CASE("Symmetric bodies step as the source paper's bound does, at both ends of every exact piece") {
    const auto pieces = certify(of_body(1, 1, 100));
    CHECK(undecided_share(pieces) < Rational(1, 10000));
    for (const ProvedPiece& proved : pieces) {
        const Piece& piece = proved.piece;
        CAPTURE(piece.q_lo, piece.q_hi);
        REQUIRE(piece.upper.has_value());
        CHECK(*piece.upper - piece.lower <= 1);
        CHECK(flight::paper_bound(piece.q_lo) - 1 == piece.lower);
        CHECK(flight::paper_bound(piece.q_hi) - 1 == *piece.upper);
    }
}

TEST_CASE("The certificate of the coin says which body it is about, and by what it is proved") {
    const auto has = [](const Claim& claim, std::initializer_list<const char*> lines) {
        const auto piece = certify({.claim = claim}).front().piece;
        const std::string text = render({.pieces = {piece}, .system = claim.system}).text;
        for (const char* line : lines) {
            CHECK(text.find(line) != std::string::npos);
        }
    };
    const Claim coin = of_body(1, 4, 4).claim;
    has(coin, {"lemmas body\nscene body\nsection perpendicular\n", "\nratio 4/1 4/1\nrho 1/1 1/1\npieces 1\n",
               "\nupper 4\norbits 2\nlower 4\nwitness corner 0b0 0b0 3 0\n"});
    has(by_plain_covers(coin), {"lemmas body\nscene body\nsection full\n",
                                "\nupper 4\nsymmetric\nlower 4\nwitness corner 0b0 0b0 3 0\n",
                                "\ntotal witness 1\ntotal symmetric 1\ntotal open 0\n"});
}

TEST_CASE("Of any body N is found: ties of the corner, no ray from it, mass beyond the contacts, great Q") {
    const std::vector<std::tuple<Rational, Rational, long>> known{
        {Rational(2, 3), 9, 4},
        {Rational(3, 10), 12, 5},
        {Rational(1, 2), 9, 5},
        {Rational(1, 2), Rational(1, 2), 3},
        {Rational(707'896, 1'000'000), Rational(31'097'847, 1'000'000), 8},
        {Rational(887'327, 1'000'000), Rational(287'139'114, 1'000'000), 26},
        {Rational(107'891, 1'000'000), Rational(2'369'019'256, 1'000'000), 43},
        {Rational(28, 100), 10'000, 73}};
    for (const auto& [rho, q, n] : known) {
        CAPTURE(rho, q);
        CHECK(maximum(proved(rho, q)) == n);
    }
}

TEST_CASE("Theorem B: plain covers prove the same of random bodies, as many as they decide with few boxes") {
    Random choices(464);
    long open = 0;
    for (long same = 0; same < scaled(2);) {
        const Rational rho = exact(choices.uniform(0.1, 1));
        const Rational q = exact(choices.uniform(1.01, 12));
        if (q * rho <= 1) {
            continue;
        }
        PieceOptions options = piece_options({Section::plain_body, rho});
        options.max_nodes = 100'000;
        const long by_plain = maximum(prove_single(q, options).piece);
        CAPTURE(rho, q);
        if (by_plain == 0) {
            ++open;  // too close to a step
        } else {
            REQUIRE(by_plain == maximum(proved(rho, q)));
            ++same;
        }
    }
    CHECK(open <= 3 * scaled(2));
}

TEST_CASE("On the edge, without mass between the contacts, bodies have what dumbbells have") {
    Random choices(463);
    for (int i = 0; i < scaled(5); ++i) {
        const Rational q = exact(choices.log_uniform(1.01, 20));
        CertifyRequest dumbbell;
        dumbbell.claim.range = {q, q};
        const Piece expected = certify(dumbbell).front().piece;
        const Piece piece = proved(1 / q, q);
        CAPTURE(q);
        REQUIRE(maximum(piece) == maximum(expected));
    }
}

TEST_CASE("A range of plain covers goes on with what an earlier run has kept, on any number of threads") {
    const dumbbell_test::TemporaryFolder folder;
    const auto until = [](const Rational& q) {
        auto request = of_body(Rational(1, 2), Rational(12, 5), q);
        request.claim = by_plain_covers(request.claim);
        return request;
    };
    auto request = until(Rational(13, 5));
    CHECK(certify(request).size() == 1);
    const PieceStore store(folder / "pieces", request.claim);
    const Piece half = certify(until(Rational(5, 2))).front().piece;
    store.keep(half);
    request.store = &store;
    for (request.jobs = 1; request.jobs < 3; ++request.jobs) {
        const auto pieces = certify(request);
        REQUIRE(pieces.size() == 2);  // the whole seems to have failed
        CHECK(pieces.front().piece.cover.leaves() == half.cover.leaves());
        CHECK((maximum(pieces.front().piece) == 3 && maximum(pieces.back().piece) == 3));
        CHECK(store.kept().size() == 2);
    }
}

TEST_CASE("A range of Q has one piece between two steps, and narrow gaps, over which N may leap by 2") {
    for (const char* gap : {"1e-3", "1e-6", "1e-12", "1e-30"}) {
        auto request = of_body(Rational(1, 4), 4, 30);
        request.claim.gap = parse_rational(gap);
        const auto pieces = certify(request);
        REQUIRE(pieces.size() == 5);
        CHECK((pieces[0].piece.q_lo == 4 && pieces[4].piece.q_hi == 30));
        for (std::size_t i = 0; i < 5; ++i) {
            CAPTURE(gap, i);
            const Piece& piece = pieces[i].piece;
            const long before = i < 2 ? 3 : i < 4 ? 5 : 7;
            CHECK(piece.status() == (i % 2 == 0 ? Status::exact : Status::gap));
            CHECK((piece.lower == before && piece.upper == before + (i % 2 == 0 ? 0 : 2)));
            CHECK((i == 0 || piece.q_lo == pieces[i - 1].piece.q_hi));
            CHECK((i % 2 == 0 || piece.q_hi - piece.q_lo <= request.claim.gap * piece.q_lo));
        }
    }
}
