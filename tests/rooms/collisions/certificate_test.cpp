#include "collisions/certificate.hpp"

#include "catch.hpp"
#include "example.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;

TEST_CASE("leaves are counted over both charts, splits are not") {
    CHECK(every_kind_of_line().pieces[1].cover.leaves() == 6);
    CHECK(equal_masses().cover.leaves() == 0);
    CHECK(open_piece(1, 2).cover.leaves() == 0);
}

TEST_CASE("a piece is exact, a gap of one, or open") {
    CHECK(piece(2, 3, 4, 4).status() == Status::exact);
    CHECK(piece(2, 3, 4, 3).status() == Status::gap);
    CHECK(piece(2, 3, 5, 3).status() == Status::open);
    CHECK(piece(2, 3, 5, 0).status() == Status::open);
    CHECK(open_piece(2, 3).status() == Status::open);
}

TEST_CASE("a certificate reaches from its first piece's beginning to its last one's end") {
    const Certificate certificate = every_kind_of_line();
    CHECK(certificate.q_lo() == 1);
    CHECK(certificate.q_hi() == Rational(14, 3));
}
