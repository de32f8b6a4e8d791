// Every rule of format-law.md has here a file that breaks it and nothing else.
#include <random>

#include "catch.hpp"
#include "make_file.hpp"
#include "scale.hpp"
#include "verify/core/outside.hpp"
#include "verify/wings/law/steps.hpp"

using make::law_file;
using make::law_line;
using make::mutated_law;
using make::outcome;

namespace {

/// What is said of the first steps with such a change: "number", for the step after them, if it may be made.
std::string step_mutant(const std::string& from, const std::string& to) {
    static const std::string first_steps =
        mutated_law(law_file().substr(law_file().find("step 10 ")), "step 11 1/1 2/1\n");
    return outcome(make::replaced(first_steps, from, to));
}

}  // namespace

TEST_CASE("law: words and numbers of its first lines have one spelling") {
    for (const auto& [from, to, code] : {std::tuple{"claim law", "claim laws", "unsupported"},
                                         {"section turning", "section none", "unsupported"},
                                         {"section turning", "section full", "unsupported"},
                                         {"scene dumbbell", "scene body", "unsupported"},
                                         {"steps 3 902", "steps 3 901", "number"},
                                         {"steps 3 902", "steps 9 902", "number"},
                                         {"steps 3 902", "steps 3", "syntax"},
                                         {"steps 3 902", "pieces 900", "syntax"},
                                         {"upper 2\n", "upper 3\n", "number"},
                                         {"upper 2\n", "upper none\n", "number"},
                                         {"lower 3\n", "lower 2\n", "number"},
                                         {"bits 53\n", "bits 52\n", "number"},
                                         {"bits 53\n", "bits 4096\n", "limit"},
                                         {"equal-masses\n", "equal-masses 1\n", "syntax"},
                                         {"lower 3\nwitness bridge", "lower 3\nwitness light", "syntax"}}) {
        INFO(from << " -> " << to);
        CHECK(step_mutant(from, to) == code);
    }
    for (const char* step : {"step 4 1/1 8/7", "step 3 8/7 1/1", "step 3 8/7 8/7", "step 3 1/2 8/7",
                             "step 3 2/2 8/7", "step 3 1/1 1/1"}) {
        INFO(step);
        CHECK(step_mutant(law_line("step 3 "), step) == "number");
    }
}

TEST_CASE("law: a step that is false, or where the law would not hold, is refused") {
    // The cover is one at A, the witness one at B: not beyond q_c(4) = 4.6..., not before it.
    CHECK(step_mutant(law_line("step 4 "), "step 4 19/4 24/5") == "count");
    CHECK(step_mutant(law_line("step 4 "), "step 4 32/7 459/100") == "witness");
    CHECK(step_mutant(law_line("step 4 "), "step 4 23/5 24/5") == "number");
    CHECK(step_mutant(law_line("step 3 "), "step 3 101/100 8/7") == "equal-masses");
    // True, but too far from q_c(N): C sqrt A - (N - 2), C sqrt B - (N - 2).
    CHECK(step_mutant(law_line("step 4 "), "step 4 4/1 24/5") == "step");
    CHECK(step_mutant(law_line("step 4 "), "step 4 32/7 53/10") == "step");
    CHECK(step_mutant(law_line("step 9 "), "step 9 62/1 63/1") == "step");
    CHECK(step_mutant(law_line("step 9 "), "step 9 313/5 64/1") == "step");
    const dumbbell_verify::law::StepPlaces<double> places;
    const auto check = [&](std::uint64_t n, const mpq_class& a, const mpq_class& b) {
        const char* missing = places.check(n, a, b);
        return std::string(missing ? missing : "");
    };
    CHECK(check(3, 1, mpq_class(8, 7)).empty());
    CHECK(check(3, mpq_class(997, 1000), 1).ends_with("> -0.115"));
    CHECK(check(3, 1, mpq_class(4, 3)).ends_with("< 0.02"));
    CHECK(check(9, mpq_class(1249, 20), mpq_class(251, 4)).ends_with("A - (N - 2) > 0"));
    CHECK(check(902, 1032805, 1032809).empty());
    CHECK(check(902, 1032795, 1032809).ends_with("A - (N - 2) > 0"));
    CHECK(check(902, 1032805, 1032820).ends_with("c0 B^(-1/4)"));
    // delta_902 = 0.00564, and c0 q^(-1/4) = 0.00646: between them a smaller c0 would show.
    CHECK(check(902, 1032805, mpq_class(10328098, 10)).empty());
    CHECK(check(902, 1032805, mpq_class(10328112, 10)).ends_with("c0 B^(-1/4)"));
}

TEST_CASE("law: a precision that is asked for is worked in") {
    const auto with_bits = [](unsigned bits) {
        dumbbell_verify::Request settings;
        settings.precision = bits;
        dumbbell_verify::Big::precision = 53;
        return make::failure(make::law_that_doubles_do_not_decide(), settings);
    };
    CHECK(with_bits(0).code == "step");
    CHECK(with_bits(53).code == "step");
    CHECK(with_bits(300).code == "number");
}

TEST_CASE("law: a cover that does not close, or is not one, is refused") {
    // Each file has all steps, which are a third of a second.
    std::vector<std::pair<std::string, std::string>> layers{{"cover layer\noutside\n", "opcode"}};
    if (scaled(1) >= 20)
        layers.insert(layers.end(), {{"cover layers\n", "syntax"},
                                     {"cover layer 1\n", "syntax"},
                                     {"cover layer\nsplit q\n", "syntax"},
                                     {"cover layer\nslope 1\n", "syntax"},
                                     {"cover layer\nslope\n", "slope"},
                                     {"cover layer\ndirect\n", "opcode"},
                                     {"cover layer\nbeyond\n", "beyond"}});
    for (const auto& [cover, code] : layers) {
        INFO(cover);
        CHECK(outcome(make::closed(make::law_steps() + cover)) == code);
    }
    dumbbell_verify::Request of_ratios;
    of_ratios.demand.most = 5;
    CHECK(make::failure(law_file(), of_ratios).line == 0);  // it is about no line
    if (scaled(1) < 20) return;  // each of the other files is verified nearly whole: seconds
    for (const auto& [from, to, code] : {std::tuple{"bulk 6000 1000 2000", "bulk 6000 1000 200", "bulk"},
                                         {"bulk 6000 1000 2000", "bulk 0 1000 2000", "number"},
                                         {"cover end 1500", "cover end 20", "end"}}) {
        INFO(from << " -> " << to);
        CHECK(outcome(mutated_law(from, to)) == code);
    }
    using dumbbell_verify::Watched;
    const std::uint64_t read = Watched::read, all = Watched::pieces;
    const make::File file(law_file());
    dumbbell_verify::Request settings;
    settings.budget = dumbbell_verify::verify(file.path(), settings).work;
    CHECK(Watched::read - read == 903);  // 900 steps and three covers
    CHECK(Watched::pieces - all == 903);
    // So many parts are allowed; they would only take long.
    CHECK(outcome(mutated_law("cover end 1500", "cover end 100000"), settings) == "limit");
}

TEST_CASE("law: a file that is cut or damaged anywhere in its first lines is not verified") {
    std::mt19937 random(20);
    for (int i = 0; i < 300; ++i) {
        std::string text = law_file();
        const std::size_t at = random() % 2000;
        if (i % 2 == 0)
            text.resize(at);
        else
            text[at] = static_cast<char>(random());
        INFO("damage " << i << " at " << at);
        if (text == law_file()) continue;
        REQUIRE(outcome(text) != "verified");
    }
}
