// The edges of the lexical classes, and what a proof says of its leaves.
#include "catch.hpp"
#include "rooms/verify/wings/adiabatic/make_file.hpp"
#include "verify/machine/decimals.hpp"
#include "verify/program/arguments.hpp"
#include "verify/program/json.hpp"

using namespace dumbbell_verify;
using make::closed;
using make::File;

namespace {

std::string outcome_of(const std::string& text) { return make::outcome(text); }

/// Nothing is claimed of this one ratio.
std::string claims_nothing(const std::string& ratio) {
    return closed(make::header(ratio, ratio, 1) + "piece " + ratio + " " + ratio +
                  "\nbits 53\nupper none\nlower 0\n");
}
double covered(const Proof& proof) {
    double sum = 0;
    for (const Tally& tally : proof.tallies)
        if (tally.name != "witness") sum += tally.covered;
    return sum;
}

}  // namespace

TEST_CASE("edges: words begin with a to z, versions with 0 to 9, too") {
    const std::string text = claims_nothing("2/1");
    const auto with = [&](const std::string& generator) {
        const std::string body = text.substr(0, text.find("total split"));
        return outcome_of(closed(make::replaced(body, "generator test 1.0", "generator " + generator)));
    };
    CHECK(with("zz-9. 9.0z") == "verified");
    CHECK(with("aa 0a") == "verified");
    CHECK(with("0a 0a") == "word");
    CHECK(with("9a 0a") == "word");
    CHECK(with("-a 0a") == "word");
    CHECK(with("a -1") == "word");
    CHECK(with("a .1") == "word");
    CHECK(with(std::string(32, 'a') + " 1") == "verified");
    CHECK(with(std::string(33, 'a') + " 1") == "word");
}

TEST_CASE("edges: a numerator has up to 2100 digits") {
    const auto up_to = [](std::size_t digits) {
        const std::string hi = "1" + std::string(digits - 1, '0') + "/1";
        return outcome_of(
            closed(make::header("1/1", hi, 1) + "piece 1/1 " + hi + "\nbits 53\nupper none\nlower 0\n"));
    };
    CHECK(up_to(2100) == "verified");
    CHECK(up_to(2101) == "number");
}

TEST_CASE("edges: a line has up to 4096 bytes") {
    const auto with_line_of = [](std::size_t size) {
        const std::string hi = "1" + std::string(2099, '0') + "/1" + std::string(size - 2114, '0') + "1";
        return outcome_of(
            closed(make::header("1/1", hi, 1) + "piece 1/1 " + hi + "\nbits 53\nupper none\nlower 0\n"));
    };
    CHECK(with_line_of(4096) == "verified");
    CHECK(with_line_of(4097) == "line");
}

TEST_CASE("edges: every byte of a file that is read is work, and nothing else where nothing is checked") {
    const std::string text = claims_nothing("2/1"), last = text.substr(text.rfind("sha256"));
    CHECK(verify(File(text).path(), {}).work == 128 * (text.size() - last.size()));
}

TEST_CASE("edges: what one piece says of its bounds") {
    const auto said = [](std::uint64_t upper, std::uint64_t lower) {
        Collisions claim;
        claim.add(1, 2, upper, lower);
        return std::array<std::uint64_t, 4>{claim.upper.value().get_ui(), claim.lower.get_ui(), claim.gaps,
                                            claim.open};
    };
    using Said = std::array<std::uint64_t, 4>;
    CHECK((said(0, 0) == Said{0, 0, 0, 0}));
    CHECK((said(3, 3) == Said{3, 3, 0, 0}));
    CHECK((said(4, 3) == Said{4, 3, 1, 0}));
    CHECK((said(5, 3) == Said{5, 3, 0, 1}));
    CHECK(json_count(mpz_class("9007199254740991")) == "9007199254740991");
    CHECK(json_count(mpz_class("9007199254740992")) == "\"9007199254740992\"");
    CHECK(json_count(mpz_class("9223372036854775808")) == "\"9223372036854775808\"");
}

TEST_CASE("edges: the leaves of a proof fill its root boxes") {
    const Verified stairs = verify(DUMBBELL_PROJECT "/certificates/stairs-1-100.dbc", {});
    CHECK(stairs.roots > 2);
    CHECK(covered(stairs) == Approx(stairs.roots));
    const File file(make::falling());
    const Verified starts = verify(file.path(), {});
    CHECK(starts.roots == 1);
    CHECK(covered(starts) == Approx(1));
    const File errors(make::bounce());
    const Proof bounces = verify(errors.path(), {});
    CHECK(bounces.roots == 1);
    CHECK(covered(bounces) == Approx(1));
}

TEST_CASE("edges: behind -- there are no options") {
    Arguments words({"-x=1", "--", "-y", "--"});
    CHECK(words.next());
    CHECK(words.option == "-x");
    for (const char* file : {"-y", "--"}) {
        CHECK(words.next());
        CHECK(words.option.empty());
        CHECK(words.word == file);
    }
    CHECK_FALSE(words.next());
}

TEST_CASE("edges: decimals are rounded to the side that was asked for, whatever their number") {
    const mpq_class third(1, 3), half(5, 2), whole = 7;
    CHECK(decimals(third, false, 0) == "0");
    CHECK(decimals(third, true, 0) == "1");
    CHECK(decimals(half, false, 0) == "2");
    CHECK(decimals(half, false, 1) == "2.5");
    CHECK(decimals(half, true, 1) == "2.5");
    CHECK(decimals(third, false, 2) == "0.33");
    CHECK(decimals(third, true, 2) == "0.34");
    CHECK(decimals(whole, true) == "7.000000");
}

TEST_CASE("edges: the numbers and times that an option takes") {
    const auto number = [](const std::string& text) {
        Arguments words({"--jobs=" + text});
        words.next();
        return words.number(2, 1024);
    };
    CHECK(number("2") == 2);
    CHECK(number("1024") == 1024);
    for (const char* bad : {"1", "1025", "02", "", "-2", "2x", "9999999999999999999", "99999999999999999999"})
        CHECK_THROWS_AS(number(bad), std::invalid_argument);
    const auto time = [](const std::string& text) {
        Arguments words({"--budget", text});
        words.next();
        return words.time();
    };
    CHECK(time("0s") == 0);
    CHECK(time("30s") == 30 * units_per_second);
    CHECK(time("2m") == 120 * units_per_second);
    CHECK(time("1.5h") == 5400 * units_per_second);
    CHECK(time("0.001s") == units_per_second / 1000);
    CHECK(time("1.02s") == units_per_second / 100 * 102);
    CHECK(time("100000h") == 100'000 * 3600 * units_per_second);
    CHECK(time("1e1s") == 10 * units_per_second);
    CHECK(time("1e300h") == std::uint64_t{1} << 63);
    for (const char* bad : {"", "s", "5", "5.", "5.s", ".5s", "5d", "5ss", "5 s", "-5s", "1.2.3s"})
        CHECK_THROWS_WITH(time(bad),
                          "--budget needs a time such as 30s, 10m or 2h, not `" + std::string(bad) + "`");
}
