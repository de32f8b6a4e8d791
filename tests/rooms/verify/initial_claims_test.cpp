// False claims about initial conditions, spelt correctly and with a fitting trailer, are refused.
#include <catch2/catch.hpp>

#include "make_initial.hpp"

using make::closed_initial;
using make::falling;
using make::initial_header;
using make::mutated_initial;
using make::outcome;

namespace {

/// The lines of the tree of `falling()`, in order.
std::vector<std::string> tree_lines() {
    const std::string& text = falling();
    const std::size_t begin = text.find('\n', text.find("\nbetween ") + 1) + 1;
    std::istringstream in(text.substr(begin, text.find("total ") - begin));
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

/// `falling()` with another tree; the bounds in the header fit it.
std::string with_tree(const std::vector<std::string>& lines) {
    long least = 99, most = 0;
    std::string tree;
    for (const std::string& line : lines) {
        tree += line + "\n";
        std::istringstream words(line);
        std::string kind;
        long a = 0, b = 0;
        words >> kind >> a;
        if (kind == "split") continue;
        if (kind == "exactly" || !(words >> b)) b = a;
        least = std::min(least, a);
        most = std::max(most, b);
    }
    const std::string head = falling().substr(0, falling().find("\nbetween ") + 1);
    return closed_initial(head + "between " + std::to_string(least) + " " + std::to_string(most) + "\n" +
                          tree);
}

}  // namespace

TEST_CASE("another number of collisions is refused in every leaf") {
    const auto lines = tree_lines();
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (!lines[i].starts_with("exactly ")) continue;
        const int k = lines[i][8] - '0';
        for (const int wrong : {k - 1, k + 1, k + 2, 99}) {
            auto changed = lines;
            changed[i] = wrong == 0 ? "exactly 0" : "exactly " + std::to_string(wrong) + lines[i].substr(9);
            INFO(changed[i]);
            CHECK(outcome(with_tree(changed)) == "exactly");
        }
        auto wider = lines;  // true, though less than is known
        wider[i] = "between 1 9" + lines[i].substr(9);
        CHECK(outcome(with_tree(wider)) == "verified");
        wider[i] = "between 1 9";
        CHECK(outcome(with_tree(wider)) == "verified");
    }
}

TEST_CASE("the same tree says nothing of another box") {
    for (const auto& [from, to] : {std::pair{"phi -1/1 1/1", "phi -3/2 1/1"},
                                   {"phi -1/1 1/1", "phi -1/1 5/4"},
                                   {"phi -1/1 1/1", "phi 2/1 4/1"},
                                   {"phidot 1/100 1/100", "phidot -1/1 1/100"},
                                   {"phidot 1/100 1/100", "phidot 1/100 1/1"},
                                   {"y 3/2 3/2", "y 3/2 2/1"},
                                   {"y 3/2 3/2", "y 1/1 3/2"},
                                   {"ydot -1/1 -1/1", "ydot -2/1 -1/1"},
                                   {"ydot -1/1 -1/1", "ydot -1/1 -1/2"},
                                   {"ydot -1/1 -1/1", "ydot 1/1 1/1"},
                                   {"ratio 10/1 10/1", "ratio 2/1 10/1"},
                                   {"ratio 10/1 10/1", "ratio 10/1 20/1"}}) {
        const std::string code = outcome(mutated_initial(falling(), from, to));
        INFO(to << ": " << code);
        CHECK((code == "exactly" || code == "between"));
    }
}

TEST_CASE("`exactly 0` is for starts that leave") {
    const auto zero = [](const std::string& phidot, const std::string& y, const std::string& ydot) {
        return outcome(closed_initial(initial_header("10/1 10/1", "1/1 2/1", phidot, y, ydot) +
                                      "between 0 0\nexactly 0\n"));
    };
    CHECK(zero("-1/1 1/1", "1/1 1/1", "1/1 2/1") == "verified");  // steep (the slope is ydot (1 + r))
    CHECK(zero("-9/10 1/2", "1/5 1/5", "9/10 1/1") == "verified");
    CHECK(zero("2/1 2/1", "1/5 1/5", "1/2 1/1") == "exactly");    // flat and low
    CHECK(zero("2/1 2/1", "1/1 1/1", "0/1 1/1") == "verified");   // above all walls
    CHECK(zero("2/1 2/1", "9/10 1/1", "0/1 1/1") == "exactly");   // a part of the box is above
    CHECK(zero("2/1 2/1", "9/10 9/10", "0/1 1/1") == "exactly");  // height 0.99
    CHECK(zero("2/1 2/1", "1/1 1/1", "-1/1000000 1/1") == "exactly");
    CHECK(zero("-1/1 -1/1", "9/10 9/10", "1/10 1/10") == "verified");  // over the peak of the light wall
    CHECK(zero("-1/1 -1/1", "1/2 1/2", "1/10 1/10") == "exactly");     // into that wall
}

TEST_CASE("numbers beyond all bounds are refused without harm") {
    const std::string huge(2000, '9'), tiny = "1/" + huge;
    for (const auto& [from, to] : {std::pair{std::string("ratio 10/1 10/1"), "ratio 10/1 " + huge + "/1"},
                                   {"ratio 10/1 10/1", "ratio " + huge + "/1 " + huge + "/1"},
                                   {"phi -1/1 1/1", "phi " + huge + "/1 " + huge + "/1"},
                                   {"phi -1/1 1/1", "phi -" + huge + "/1 -" + huge + "/1"},
                                   {"phidot 1/100 1/100", "phidot -" + huge + "/1 " + huge + "/1"},
                                   {"y 3/2 3/2", "y 3/2 " + huge + "/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + huge + "/1 -1/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + huge + "/1 -" + huge + "/1"},
                                   {"ydot -1/1 -1/1", "ydot -" + tiny + " -" + tiny},
                                   {"exactly 1 heavy", "exactly 999999999999999999 heavy"},
                                   {"between 1 2 heavy", "between 1 999999999999999999 heavy"},
                                   {"91b-6 373b-8", "91b-400 373b-8"},
                                   {"91b-6 373b-8", "91b-6 373b400"}}) {
        for (const unsigned precision : {0U, 100U}) {
            dumbbell_verify::Settings settings;
            settings.precision = precision;
            // The clearance falls from the beginning on: an early t0 is no lie.
            const bool true_claim = to.starts_with("between 1 9999") || to.starts_with("91b-400");
            std::string text = mutated_initial(falling(), from, to);
            if (to.find("99999999999 heavy") != std::string::npos)
                text = mutated_initial(text, "between 1 5\n", "between 1 999999999999999999\n");
            INFO(to.substr(0, 60));
            CHECK((outcome(text, settings) == "verified") == true_claim);
        }
    }
}
