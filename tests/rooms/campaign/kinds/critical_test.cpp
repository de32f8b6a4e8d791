#include <catch2/catch.hpp>
#include <fstream>

#include "base/error.hpp"
#include "campaign/kinds/kinds.hpp"
#include "collisions/writer.hpp"
#include "file/sha256.hpp"
#include "rooms/campaign/place.hpp"
#include "rooms/campaign/scripted_engine.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;
using Catch::Matchers::Contains;

namespace {

const Order three_ratios{"prove critical\ndigits 10\n", {"ratio 3", "ratio 4", "ratio 5"}};

Judgement judged(const Place& place, const std::string& bytes) {
    std::ofstream(place.path, std::ios::binary) << bytes;
    return critical_kind().judge(three_ratios, ".", place.string(), Scrutiny::proof);
}

std::string result() { return *critical_kind().work(three_ratios, ".", never); }

/// The result with one row replaced, and its checksum made right.
std::string with_row(const std::string& number, const std::string& row) {
    std::string text = result();
    text.erase(text.rfind("sha256 "));
    const auto from = text.find("ratio " + number + " ");
    text.replace(from, text.find('\n', from) - from, row);
    return text + "sha256 " + sha256_hex(text) + "\n";
}

}  // namespace

TEST_CASE("what was worked out is accepted, and depends on the order alone") {
    const Place place;
    CHECK(judged(place, result()).verdict == Judgement::Verdict::proved);
    CHECK(result() == result());
}

TEST_CASE("a row that does not enclose the critical ratio is rejected, whatever the checksum") {
    const Place place;
    const auto rejected = [&](const std::string& row) {
        const Judgement judgement = judged(place, with_row("4", row));
        CAPTURE(row, judgement.reason);
        CHECK(judgement.verdict == Judgement::Verdict::wrong);
    };
    // q_c(4) = 4.60333884875170...
    CHECK(judged(place, with_row("4", "ratio 4 460333884875/100000000000 460333884876/100000000000 128"))
              .verdict == Judgement::Verdict::proved);
    rejected("ratio 4 460333884876/100000000000 460333884877/100000000000 128");
    rejected("ratio 4 460333884874/100000000000 460333884875/100000000000 128");
    rejected("ratio 4 4/1 5/1 128");
    rejected("ratio 4 460333884876/100000000000 460333884875/100000000000 128");
    rejected("ratio 5 460333884875/100000000000 460333884876/100000000000 128");
    rejected("ratio 4 460333884875/100000000000 460333884876/100000000000 1");
    rejected("ratio 4 460333884875/100000000000 460333884876/100000000000 99999999");
    rejected("ratio 4 1/0 1/0 128");
    rejected("ratio 4");
    rejected("");
}

TEST_CASE("a table with too few or too many rows is rejected") {
    const Place place;
    std::string text = result();
    CHECK(judged(place, "").verdict == Judgement::Verdict::wrong);
    CHECK(judged(place, text + text).verdict == Judgement::Verdict::wrong);
    const Order fewer{three_ratios.head, {"ratio 3", "ratio 4"}};
    CHECK(judged(place, *critical_kind().work(fewer, ".", never)).verdict == Judgement::Verdict::wrong);
}

TEST_CASE("rows beyond those that were ordered are not even read") {
    const Place place;
    std::string text = result();
    text.erase(text.rfind("sha256 "));
    text += text.substr(text.rfind("ratio "));
    CHECK_THAT(judged(place, text + "sha256 " + sha256_hex(text) + "\n").reason, Contains("is not a table"));
}

TEST_CASE("results are not merged under a claim that they do not prove") {
    const Place place;
    Plan plan = small_plan();
    const auto files = results(critical_kind(), plan, place);
    CHECK_THAT(critical_kind().merge(plan, ".", files).text, Contains("\n14\t"));
    for (const char* claim : {"critical 3:15 --digits 10", "critical 3:14 --digits 11", ""}) {
        plan.claim = claim;
        CHECK_THROWS_WITH(critical_kind().merge(plan, ".", files), Contains("do not tile the claim"));
    }
}

TEST_CASE("orders about critical ratios that no plan makes are refused before any work") {
    CHECK_THROWS_AS(critical_kind().work({"prove critical\ndigits 0\n", {"ratio 4"}}, ".", never),
                    InputError);
    CHECK_THROWS_AS(critical_kind().work({"prove critical\ndigits 99999\n", {"ratio 4"}}, ".", never),
                    InputError);
    CHECK_THROWS_AS(critical_kind().work({"prove critical\n", {"ratio 4"}}, ".", never), InputError);
    CHECK_THROWS_AS(critical_kind().work({three_ratios.head, {"ratio 2"}}, ".", never), InputError);
    CHECK_THROWS_AS(critical_kind().work({three_ratios.head, {"ratio 4 4"}}, ".", never), InputError);
    CHECK_THROWS_AS(critical_kind().work({three_ratios.head, {"ratio x"}}, ".", never), InputError);
}

TEST_CASE("an order about critical ratios that is interrupted has no result") {
    CHECK_FALSE(critical_kind().work(three_ratios, ".", [] { return true; }).has_value());
}

TEST_CASE("a single critical ratio needs no campaign") {
    staircase::CriticalRequest request;
    request.first = request.last = 5;
    CHECK_THROWS_WITH(plan_critical(request, std::nullopt), Contains("use dumbbell critical"));
}
