#include "audit/audit.hpp"

#include "catch.hpp"
#include "collisions/certify.hpp"
#include "rooms/collisions/random_tree.hpp"

using namespace dumbbell_test;
using namespace dumbbell::collisions;
using dumbbell::audit::Audit;

namespace {

Piece piece_of(const Rational& lo, const Rational& hi, std::vector<ChartTree> charts) {
    Piece piece;
    piece.q_lo = lo;
    piece.q_hi = hi;
    piece.upper = 4;
    piece.cover.charts = std::move(charts);
    return piece;
}

Certificate example() {
    return certificate_of(
        {piece_of(2, 3, {{Chart::bridge, random_tree(20, three_axes, 1)}, {Chart::light, {leaf()}}}),
         piece_of(3, 3, {{Chart::bridge, {leaf()}}, {Chart::light, random_tree(9, plane_axes, 2)}})});
}

Audit audit_of(const Certificate& certificate) {
    return audit::audit(certificate, {certificate.q_lo(), certificate.q_hi()});
}

/// Whether there is one fault, with these words in it.
bool only_fault(const Audit& result, const std::string& words) {
    CAPTURE(result.faults);
    return result.faults.size() == 1 && result.faults[0].find(words) != std::string::npos;
}

}  // namespace

TEST_CASE("certificates of the prover tile") {
    for (const Section section : {Section::turning, Section::full, Section::plain}) {
        CertifyRequest request;
        request.claim.range = section == Section::plain ? Range{10, 10} : Range{2, 3};
        request.claim.gap = Rational(1, 1000);
        request.claim.system.section = section;
        Certificate certificate;
        certificate.system.section = section;
        for (const ProvedPiece& proved : certify(request)) {
            certificate.pieces.push_back(proved.piece);
        }
        const Audit result = audit_of(certificate);
        CAPTURE(result.faults);
        CHECK(result.tiles());
        CHECK(result.leaves >= result.charts);
        CHECK(result.charts > 0);
    }
}

TEST_CASE("what is counted") {
    const Audit result = audit_of(example());
    CHECK(result.tiles());
    CHECK(result.pieces == 2);
    CHECK(result.charts == 4);
    CHECK(result.leaves == 31);
    CHECK(result.pairs > 20);
}

TEST_CASE("pieces without boxes") {
    Piece equal = piece_of(1, 1, {});
    equal.cover.equal_masses = true;
    Piece open = piece_of(1, 2, {});
    open.upper = std::nullopt;
    const Audit result = audit_of(certificate_of({equal, open}));
    CHECK(result.tiles());
    CHECK(result.equal_masses == 1);
    CHECK(result.without_cover == 1);

    equal.q_hi = 2;
    CHECK(only_fault(audit_of(certificate_of({equal})), "piece 1: equal-masses"));
}

TEST_CASE("the message names piece, chart and leaves") {
    Certificate certificate = example();
    certificate.pieces[1].cover.charts[1].tree = {split(Axis::ratio), leaf(), leaf()};
    CHECK(only_fault(audit_of(certificate),
                     "piece 2, chart light: leaf 1 (e 0/1..2/1, lambda 0/1..4/1, q 3/1..3/1) and leaf 2 ("));
}

TEST_CASE("the message names the missing area") {
    Certificate certificate = example();
    certificate.pieces[1].cover.charts[1].tree = {split(Axis::slope), leaf()};
    CHECK(
        only_fault(audit_of(certificate), "piece 2, chart light: area 4/1 of the root's 8/1 is in no leaf"));
}

TEST_CASE("a chart that lacks, or is not the section's") {
    Certificate certificate = example();
    certificate.pieces[0].cover.charts.pop_back();
    CHECK(only_fault(audit_of(certificate), "piece 1: its cover lacks a chart"));
    certificate = example();
    certificate.system.section = Section::full;
    CHECK(audit_of(certificate).faults.size() == 2);
}

TEST_CASE("pieces tile the range") {
    Certificate certificate = example();
    CHECK(only_fault(audit::audit(certificate, {1, 3}), "piece 1 begins at ratio 2/1, not at 1/1"));
    CHECK(only_fault(audit::audit(certificate, {2, 4}), "the pieces end at ratio 3/1, not at 4/1"));
    certificate.pieces[0].q_hi = Rational(5, 2);
    CHECK(only_fault(audit_of(certificate), "piece 2 begins at ratio 3/1, not at 5/2"));
    Piece there = piece_of(1, 2, {});
    Piece back = piece_of(2, 1, {});
    there.upper = back.upper = std::nullopt;
    CHECK(only_fault(audit_of(certificate_of({there, back})), "piece 2 ends before it begins"));
}

TEST_CASE("progress ends with all leaves") {
    struct Told : Observer {
        void update(std::size_t done, std::size_t total, std::optional<long>) override {
            CHECK(done > 0);
            CHECK(done <= total);
            steps.push_back(done);
        }
        std::vector<std::size_t> steps;
    } told;
    (void)audit::audit(example(), {2, 3}, told);
    CHECK(std::is_sorted(told.steps.begin(), told.steps.end()));
    CHECK(told.steps.front() < 20);  // also within a chart
    CHECK(told.steps.back() == 31);
}
