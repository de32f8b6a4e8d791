#include <algorithm>

#include "catch.hpp"
#include "file/sha256.hpp"
#include "rooms/wings/starts/box.hpp"
#include "starts/answer/writer.hpp"
#include "starts/cover/subdivide.hpp"
#include "temporary_folder.hpp"

using namespace dumbbell;
using namespace dumbbell::starts;

namespace {

/// phi in [0, 3], phidot in [-1/2, 1/2], y = 3/2, ydot = -1.
Box falling() {
    return {{Rational(0), Rational(-1, 2), Rational(3, 2), Rational(-1), Rational(10)},
            {Rational(3), Rational(1, 2), Rational(3, 2), Rational(-1), Rational(10)}};
}

Certificate certificate_of(const Box& box, const Subdivision& parts) {
    return {.generator = {"dumbbell", "0.1.0"}, .box = box, .bits = 53, .tree = parts.tree.nodes()};
}

long lines_with(const std::vector<std::string>& lines, const std::string& begin) {
    return std::count_if(lines.begin(), lines.end(),
                         [&](const std::string& l) { return l.rfind(begin, 0) == 0; });
}

}  // namespace

TEST_CASE("A certificate of initial conditions is spelt as its page says") {
    const auto parts = subdivide(falling(), {.max_boxes = 300, .jobs = 2});
    const SealedText written = render(certificate_of(falling(), parts));
    const auto lines = dumbbell_test::lines_of(written.text);
    const std::vector<std::string> header{"dumbbell-certificate 1",
                                          "generator dumbbell 0.1.0",
                                          "lemmas 1",
                                          "scene dumbbell",
                                          "section none",
                                          "claim initial-conditions",
                                          "ratio 10/1 10/1",
                                          "phi 0/1 3/1",
                                          "phidot -1/2 1/2",
                                          "y 3/2 3/2",
                                          "ydot -1/1 -1/1",
                                          "bits 53"};
    REQUIRE(lines.size() > header.size());
    CHECK(std::equal(header.begin(), header.end(), lines.begin()));
    CHECK(lines[12] == "between " + std::to_string(parts.least) + " " + std::to_string(*parts.most));
    CHECK(lines_with(lines, "split ") == 299);
    CHECK(lines_with(lines, "exactly ") + lines_with(lines, "between ") - 1 == 300);
    CHECK(lines.back() == "sha256 " + written.sha256);
    const std::string body = written.text.substr(0, written.text.rfind("sha256 "));
    CHECK(sha256_hex(body) == written.sha256);
}

TEST_CASE("A subdivision's shares add up to the whole, exactly") {
    const auto parts = subdivide(falling(), {.max_boxes = 500, .jobs = 2});
    Rational sum = parts.undecided.share;
    for (const auto& [count, part] : parts.exact) {
        sum += part.share;
    }
    CHECK(sum == 1);
}

TEST_CASE(
    "A subdivision, with generations that are judged in parts too, does not depend on the number of "
    "threads") {
    const auto one = subdivide(falling(), {.max_boxes = 11'000, .jobs = 1});
    const auto two = subdivide(falling(), {.max_boxes = 11'000, .jobs = 2});
    CHECK(one.undecided.boxes > 4096);  // that are judged at a time
    CHECK(one.undecided.share < Rational(1, 100));
    CHECK(one.least == 1);
    CHECK(render(certificate_of(falling(), one)).text == render(certificate_of(falling(), two)).text);
}

TEST_CASE("A box with one number of collisions is a single leaf") {
    Box box = falling();
    box.lo = {Rational(1, 2), Rational(9, 10), Rational(2), Rational(1), Rational(10)};
    box.hi = {Rational(6, 10), Rational(1), Rational(3), Rational(2), Rational(11)};
    const auto parts = subdivide(box, {});
    REQUIRE(parts.tree.size() == 1);
    CHECK(parts.most == 0);
    CHECK(render(certificate_of(box, parts)).text.find("between 0 0\nexactly 0\n") != std::string::npos);
}

TEST_CASE("An interrupted subdivision is complete and says what it has not decided") {
    const auto parts = subdivide(falling(), {.jobs = 2, .interrupted = [] { return true; }});
    CHECK(parts.tree.size() == 1);
    CHECK(parts.undecided.share == 1);
    CHECK_NOTHROW(render(certificate_of(falling(), parts)));
}
