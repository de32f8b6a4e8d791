#include "collisions/writer.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "example.hpp"
#include "file/dyadic.hpp"
#include "file/sha256.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;

namespace {

constexpr const char* ten_dbc = R"(dumbbell-certificate 1
generator dumbbell 0.1.0
lemmas 1
scene dumbbell
section turning
claim collisions
ratio 10/1 10/1
pieces 1
piece 10/1 10/1
bits 53
upper 4
chart bridge
count 1 2
chart light
count 1 1
lower 4
witness bridge 1b-1 1b-1 1 2
total split 0
total count 2
total outside 0
total meets 0
total meets-reversed 0
total equal-masses 0
total witness 1
total open 0
sha256 c6e26b8f09cbafe3452ad41c7d4c3167c4ede7d97dd806ec1cba74179367c5a1
)";

constexpr const char* every_kind = R"(ratio 1/1 14/3
pieces 3
piece 1/1 1/1
bits 53
upper 2
equal-masses
lower 2
witness bridge 1b-1 1b-1 1 0
piece 1/1 9/2
bits 128
upper 4
chart bridge
split e
count 1 2
split eta
count 0 3
outside
chart light
split lambda
split q
meets
meets-reversed
count 3 0
lower 3
witness bridge 3b-3 1b-10 1 1
piece 9/2 14/3
bits 53
upper none
lower 0
total split 4
total count 3
total outside 1
total meets 1
total meets-reversed 1
total equal-masses 1
total witness 2
total open 1
)";

Rational power_of_two(unsigned n) { return Rational(Integer(1) << n); }

}  // namespace

TEST_CASE("the certificate of q = 10 is spelled like this") {
    CHECK(render(certificate_of({piece(10, 10, 4, 4)})).text == ten_dbc);
}

TEST_CASE("every kind of line has its one spelling, and the totals count them") {
    const std::string text = render(every_kind_of_line()).text;
    const std::size_t body = text.find("ratio ");
    const std::size_t hash = text.find("sha256 ");
    CHECK(text.substr(body, hash - body) == every_kind);
}

TEST_CASE("SHA-256 of known texts") {
    CHECK(sha256_hex("") == "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    CHECK(sha256_hex("abc") == "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
    CHECK(sha256_hex(std::string(1'000'000, 'a')) ==
          "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

TEST_CASE("a dyadic has an odd numerator and no sign but the exponent's") {
    CHECK(to_dyadic(0) == "0b0");
    CHECK(to_dyadic(1) == "1b0");
    CHECK(to_dyadic(2) == "1b1");
    CHECK(to_dyadic(12) == "3b2");
    CHECK(to_dyadic(Rational(1, 2)) == "1b-1");
    CHECK(to_dyadic(Rational(6, 16)) == "3b-3");
    CHECK(to_dyadic(power_of_two(400)) == "1b400");
    CHECK(to_dyadic(1 / power_of_two(400)) == "1b-400");
    CHECK(to_dyadic(power_of_two(most_binary_places)) == "1b4096");
    CHECK(to_dyadic(3 / power_of_two(most_binary_places)) == "3b-4096");
    CHECK(to_dyadic(exact(1.5707963267948966)) == "884279719003555b-49");
}

TEST_CASE("what is no dyadic is refused") {
    CHECK_THROWS_AS(to_dyadic(Rational(1, 3)), BrokenInvariant);
    CHECK_THROWS_AS(to_dyadic(Rational(1, 10)), BrokenInvariant);
    CHECK_THROWS_AS(to_dyadic(power_of_two(most_binary_places + 1)), BrokenInvariant);
    CHECK_THROWS_AS(to_dyadic(1 / power_of_two(most_binary_places + 1)), BrokenInvariant);
    Piece bad = piece(10, 10, 4, 4);
    bad.witness->eta = Rational(1, 10);
    CHECK_THROWS_AS(render(certificate_of({bad})), BrokenInvariant);
}

TEST_CASE("ratios are in lowest terms, integers with /1") {
    const std::string text = render(certificate_of({piece(Rational(10, 4), Rational(20, 2), 4, 4)})).text;
    CHECK_THAT(text, Contains("ratio 5/2 10/1\n"));
    CHECK_THAT(text, Contains("piece 5/2 10/1\n"));
}

TEST_CASE("a piece without a lower bound has no witness line") {
    Piece upper_only = piece(10, 10, 4, 0);
    upper_only.witness.reset();
    const std::string text = render(certificate_of({upper_only})).text;
    CHECK_THAT(text, Contains("lower 0\ntotal split"));
    CHECK_THAT(text, Contains("total witness 0\n"));
}

TEST_CASE("pieces that do not follow one another are refused") {
    CHECK_THROWS_AS(render(certificate_of({})), BrokenInvariant);
    CHECK_THROWS_AS(render(certificate_of({piece(2, 3, 3, 3), piece(4, 5, 4, 4)})), BrokenInvariant);
    CHECK_THROWS_AS(render(certificate_of({piece(2, 4, 3, 3), piece(3, 5, 4, 4)})), BrokenInvariant);
    CHECK_THROWS_AS(render(certificate_of({piece(3, 2, 3, 3)})), BrokenInvariant);
    CHECK_NOTHROW(render(certificate_of({piece(2, 3, 3, 3), piece(3, 3, 3, 3), piece(3, 5, 4, 4)})));
}

TEST_CASE("a lower bound without a witness is refused") {
    Piece bad = piece(10, 10, 4, 4);
    bad.witness.reset();
    CHECK_THROWS_AS(render(certificate_of({bad})), BrokenInvariant);
}
