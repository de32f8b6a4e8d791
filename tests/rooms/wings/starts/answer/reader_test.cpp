#include "starts/answer/reader.hpp"

#include "base/error.hpp"
#include "catch.hpp"
#include "programs/cli/process.hpp"
#include "starts/answer/writer.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;
using namespace dumbbell_test;

namespace {

// Every kind of line.
const std::string& good() {
    static const std::string text = [] {
        const FirstContact heavy{true, Rational(1, 2), Rational(5, 8)};
        const FirstContact light{false, Rational(3), Rational(4)};
        Certificate certificate{{"dumbbell", "0.1.0"}, {}, 100, {}};
        certificate.box.lo = {Rational(-1, 3), 0, 3, Rational(-1, 2), 10};
        certificate.box.hi = {Rational(1, 3), 1, 3, Rational(-1, 2), 10};
        certificate.tree = {{Axis::phi, {}},     {Axis::phidot, {}}, {{}, {0, 0, {}}},
                            {{}, {2, 2, heavy}}, {Axis::phi, {}},    {{}, {1, 3, light}},
                            {Axis::phidot, {}},  {{}, {0, 4, {}}},   {{}, {0, std::nullopt, {}}}};
        return render(certificate).text;
    }();
    return text;
}

Certificate read_text(const std::string& text) {
    const TemporaryFolder folder;
    write_file(folder / "file.dbc", text);
    return read_certificate(folder / "file.dbc");
}

}  // namespace

TEST_CASE("initial conditions that were written and read are written the same again") {
    CHECK(render(read_text(good())).text == good());
}

TEST_CASE("initial conditions are claimed to have as few and as many collisions as their leaves") {
    CHECK_THAT(good(), Contains("\nbetween 0 none\n"));
    Certificate decided = read_text(good());
    decided.tree = {{Axis::phi, {}}, {{}, {2, 2, {}}}, {{}, {1, 3, FirstContact{false, 3, 4}}}};
    CHECK_THAT(render(decided).text, Contains("\nbetween 1 3\n"));
}

TEST_CASE("the box is read with its signs, the ratio from its own place") {
    const Certificate read = read_text(good());
    CHECK(read.box.lower(Axis::phi) == Rational(-1, 3));
    CHECK(read.box.upper(Axis::phidot) == 1);
    CHECK(read.box.lower(Axis::ratio) == 10);
    CHECK(read.bits == 100);
    CHECK(read.tree.size() == 9);
}

TEST_CASE("what is no certificate of initial conditions is refused with file and line") {
    const std::vector<std::pair<std::string, std::string>> changes{
        {"claim initial-conditions", "claim collisions"},
        {"phi -1/3 1/3", "phi 1/3 -1/3"},
        {"phi -1/3 1/3", "phi --1/3 1/3"},
        {"exactly 2 heavy 1b-1 5b-3", "exactly 2 middle 1b-1 5b-3"},
        {"exactly 2 heavy 1b-1 5b-3", "exactly 2 heavy 1b-1"},
        {"exactly 2 heavy 1b-1 5b-3", "exactly 2 heavy 1/2 5b-3"},
        {"exactly 0\n", "exactly -1\n"},
        {"exactly 0\n", "exactly\n"},
        {"exactly 0\n", "never\n"},
        {"exactly 0\n", "split psi\n"},
        {"bits 100", "bits many"},
    };
    for (const auto& [from, to] : changes) {
        CAPTURE(from, to);
        CHECK_THROWS_WITH(read_text(replaced(good(), from, to)), Contains("file.dbc") && Contains("line"));
    }
}

TEST_CASE("a file of initial conditions that ends early is refused") {
    for (std::size_t length = 0; length < good().find("total"); length += 7) {
        CAPTURE(length);
        CHECK_THROWS_AS(read_text(good().substr(0, length)), InputError);
    }
}
