#include <sys/resource.h>

#include <catch2/catch.hpp>
#include <fstream>

#include "base/error.hpp"
#include "campaign/kinds/kinds.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "file/sha256.hpp"
#include "rooms/campaign/place.hpp"
#include "rooms/campaign/resealed.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell::collisions;
using namespace dumbbell_test;
using Catch::Matchers::Contains;
namespace fs = std::filesystem;

namespace {

CertifyRequest request(const Rational& lo, const Rational& hi) {
    CertifyRequest request;
    request.q_lo = lo;
    request.q_hi = hi;
    return request;
}

Plan planned(const CertifyRequest& request, std::size_t shards) {
    auto plan = plan_collisions(request, shards, never);
    REQUIRE(plan.has_value());
    return *plan;
}

/// Of this program, in bytes.
long peak_memory() {
    rusage usage{};
    ::getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss * 1024;
}

std::string in_one_go(const CertifyRequest& request) {
    Certificate certificate{.pieces = {}, .scene = request.scene, .section = request.section};
    for (const ProvedPiece& proved : certify(request)) {
        certificate.pieces.push_back(proved.piece);
    }
    return render(certificate).text;
}

}  // namespace

TEST_CASE("shards of any number, of every scene and section, merge to what one run proves, byte for byte") {
    CertifyRequest full = request(Rational(4), Rational(5));
    full.section = Section::full;
    full.gap = Rational(1, 100);
    CertifyRequest hybrid = request(Rational(1), Rational(20));
    hybrid.scene = Scene::hybrid;
    CertifyRequest wedge = hybrid;
    wedge.scene = Scene::wedge;
    for (const CertifyRequest& of : {request(Rational(1), Rational(60)), full, hybrid, wedge}) {
        const std::string expected = in_one_go(of);
        for (const std::size_t shards : {1, 3, 1000}) {
            const Place place;
            const Plan plan = planned(of, shards);
            const campaign::Kind::Merged merged =
                collisions_kind().merge(plan, ".", results(collisions_kind(), plan, place));
            CHECK(merged.text == expected);
            CHECK_FALSE(merged.is_open);
        }
    }
}

TEST_CASE("what does not tile the claim is not merged") {
    const Place place;
    const Plan plan = planned(request(Rational(1), Rational(60)), 5);
    const auto files = results(collisions_kind(), plan, place);
    const auto refused = [&](const Plan& of, std::vector<std::string> some) {
        CHECK_THROWS_WITH(collisions_kind().merge(of, ".", some), Contains("do not tile the claim"));
    };
    refused(plan, {files.begin(), files.end() - 1});
    refused(plan, {files.begin() + 1, files.end()});
    refused(plan, {files[0], files[2], files[1], files[3], files[4]});
    refused(plan, {files[0], files[1], files[1], files[3], files[4]});
    Plan other = plan;
    for (const char* claim :
         {"certify 1/1:61/1 --gap 1/1000000", "certify 1/1:60/1 --section full --gap 1/1000000"}) {
        other.claim = claim;  // that its units do not prove
        refused(other, files);
    }
    other = plan;
    other.whole.units.pop_back();
    refused(other, files);
}

TEST_CASE("a result has the pieces of its order with their bounds, and is no compressed file") {
    const Place place;
    const Plan plan = planned(request(Rational(4), Rational(6)), 1);
    const std::string file = results(collisions_kind(), plan, place).front();
    const std::string truth = file_contents(file);
    const auto look = [&](const std::string& text) {
        std::ofstream(file) << text;
        return collisions_kind().judge(plan.whole, ".", file, Scrutiny::form);
    };
    const auto refused = [&](const std::string& text) {
        return look(text).verdict == Judgement::Verdict::wrong;
    };
    CHECK(look(truth).verdict == Judgement::Verdict::proved);
    CHECK(refused(resealed(truth, "\nlower 3\n", "\nlower 2\n")));
    CHECK(refused(resealed(truth, "\nupper 4\n", "\nupper 5\n")));
    CHECK(refused(resealed(truth, "\npiece 4/1 ", "\npiece 5/1 ")));
    CHECK(refused(resealed(truth, "\npieces 3\n", "\npieces 2\n")));
    CHECK(refused(truth.substr(0, truth.size() - 1)));
    AtomicFile(file + ".gz").commit(truth);
    const Judgement packed = collisions_kind().judge(plan.whole, ".", file + ".gz", Scrutiny::form);
    CHECK(packed.verdict == Judgement::Verdict::wrong);
    CHECK_THAT(packed.reason, Contains("compressed"));
}

TEST_CASE("a result of more pieces than were ordered is refused before they are read") {
    const Place place;
    const Plan plan = planned(request(Rational(4), Rational(6)), 1);
    const std::string file = results(collisions_kind(), plan, place).front();
    std::string many =
        "dumbbell-certificate 1\ngenerator dumbbell 0.1.0\nlemmas 1\nscene dumbbell\n"
        "section turning\nclaim collisions\nratio 1/1 1/1\npieces 1000000\n";
    for (int i = 0; i < 1'000'000; ++i) {
        many += "piece 1/1 1/1\nbits 53\nupper none\nlower 0\n";
    }
    std::ofstream(file) << many << "sha256 " << sha256_hex(many) << '\n';
    const auto before = peak_memory();
    CHECK(collisions_kind().judge(plan.whole, ".", file, Scrutiny::form).verdict ==
          Judgement::Verdict::wrong);
    CHECK(peak_memory() - before < 20'000'000);
}

TEST_CASE("the claim of a plan is the command that proves it in one go") {
    CertifyRequest of = request(Rational(3, 2), Rational(12));
    of.gap = Rational(1, 1000);
    of.section = Section::plain;
    CHECK(planned(of, 4).claim == "certify 3/2:12/1 --section full --lemmas none --gap 1/1000");
}

TEST_CASE("ratios as long as a command line may have them are planned and proved") {
    const Rational long_one = parse_rational("1." + std::string(990, '3'));
    const Plan plan = planned(request(Rational(1), long_one), 1);
    CHECK(collisions_kind().work(plan.whole, ".", never).has_value());
}

TEST_CASE("orders that no plan makes are refused before any work") {
    const Order order = planned(request(Rational(1), Rational(6)), 1).whole;
    const auto refused = [&](Order changed) {
        CHECK_THROWS_AS(collisions_kind().work(changed, ".", never), InputError);
    };
    for (const char* unit : {"piece 1/1 2/1 3", "piece 2/1 1/1 3 2", "piece 1/2 2/1 3 2", "piece 1/1 2/1 x 2",
                             "piece 1/1 2/1 3 -2", "piece 1/1 1/1 0 2", "piece 1/1 2/1 2 3",
                             "piece 1/1 2/1 3 0", "piece 2/2 2/1 3 2", "piece 1/1 1e17 3 2", ""}) {
        CAPTURE(unit);
        refused({order.head, {unit}});
    }
    refused({"prove collisions\nlemmas 2\nscene dumbbell\nsection turning\n", order.units});
    refused({"prove collisions\nlemmas 1\nscene wedge\n", order.units});
}

TEST_CASE("an order that is interrupted has no result") {
    const Order order = planned(request(Rational(1), Rational(6)), 1).whole;
    CHECK_FALSE(collisions_kind().work(order, ".", [] { return true; }).has_value());
}

TEST_CASE("a single ratio needs no campaign, and beyond reach there is none") {
    CHECK_THROWS_WITH(plan_collisions(request(Rational(5), Rational(5)), {}, never),
                      Contains("use dumbbell certify"));
    CHECK_THROWS_WITH(plan_collisions(request(parse_rational("1e36"), parse_rational("1e37")), {}, never),
                      Contains("beyond 10^36"));
    CHECK_FALSE(plan_collisions(request(Rational(5), Rational(50)), {}, [] { return true; }).has_value());
}
