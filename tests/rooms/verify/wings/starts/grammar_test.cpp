// Every rule of format-initial.md, section 2, has here a file that breaks it and nothing else.
#include "catch.hpp"
#include "make_file.hpp"
#include "scale.hpp"
#include "verify/wings/starts/claim.hpp"

using make::closed;
using make::falling;
using make::initial_header;
using make::mutated;
using make::outcome;
using make::replaced;

namespace {

/// Starts that leave: steeply, with phi in [0, 1].
std::string leaving(const std::string& tree, const std::string& bounds = "between 0 0") {
    return closed(initial_header("2/1 3/1", "0/1 1/1", "1/2 1/1", "1/1 2/1", "1/1 2/1") + bounds + "\n" +
                  tree);
}
std::string initial_mutant(const std::string& from, const std::string& to) {
    return outcome(mutated(falling(), from, to));
}

}  // namespace

TEST_CASE("files about initial conditions are verified, plain and compressed") {
    CHECK(outcome(falling()) == "verified");
    CHECK(outcome(make::gzipped(falling())) == "verified");
    CHECK(outcome(leaving("exactly 0\n")) == "verified");
    CHECK(outcome(leaving("open\n", "between 0 none")) == "verified");
    CHECK(outcome(leaving("split q\nexactly 0\nopen\n", "between 0 none")) == "verified");
    CHECK(outcome(leaving("split y\nsplit ydot\nexactly 0\nexactly 0\nexactly 0\n")) == "verified");
}

TEST_CASE("unknown words make a file about initial conditions unsupported") {
    for (const auto& [from, to] : {std::pair{"claim initial-conditions", "claim initial-states"},
                                   {"claim initial-conditions", "claim collisions"},
                                   {"section none", "section nothing"},
                                   {"section none", "section turning"},
                                   {"lemmas 1", "lemmas minimal"},
                                   {"lemmas 1", "lemmas 2"},
                                   {"scene dumbbell", "scene body"},
                                   {"dumbbell-certificate 1", "dumbbell-certificate 2"}}) {
        INFO(to);
        CHECK(initial_mutant(from, to) == "unsupported");
    }
}

TEST_CASE("each value has one spelling") {
    for (const char* value : {"-0/1", "0/2", "+1/1", "--1/1", "-2/2", "-1", "-1/0", "-1/01", "1/-1", "-1.0",
                              "-1b0", "-01/1", "-/1", "-1/"}) {
        INFO(value);
        CHECK(initial_mutant("phi -1/1", std::string("phi ") + value) == "number");
    }
    CHECK(initial_mutant("ratio 10/1 10/1", "ratio -10/1 10/1") == "number");
    CHECK(initial_mutant("ratio 10/1 10/1", "ratio 1/2 10/1") == "number");
    CHECK(initial_mutant("ratio 10/1 10/1", "ratio 11/1 10/1") == "number");
    CHECK(initial_mutant("phi -1/1 1/1", "phi 1/1 -1/1") == "number");
    CHECK(initial_mutant("phi -1/1 1/1", "phi -1/1") == "syntax");
    CHECK(initial_mutant("phi -1/1 1/1", "psi -1/1 1/1") == "syntax");
    CHECK(initial_mutant("phi -1/1 1/1", "phi -4/1 4/1") == "number");
    const auto wide = [](const std::string& phi) {
        return outcome(closed(initial_header("2/1 2/1", phi, "1/2 1/1", "1/1 2/1", "1/1 2/1") +
                              "between 0 none\nopen\n"));
    };
    CHECK(wide("-3/1 4/1") == "verified");
    CHECK(wide("-3/1 4000001/1000000") == "number");
    CHECK(initial_mutant("bits 53", "bits 52") == "number");
    CHECK(initial_mutant("bits 53", "bits 4097") == "number");
    CHECK(initial_mutant("bits 53", "bits 2049") == "limit");
    CHECK(initial_mutant("bits 53", "bits 300") == "verified");
}

TEST_CASE("each line has one spelling, and a place") {
    for (const auto& [line, code] : {std::pair{"exactly 1", "syntax"},
                                     {"exactly 1 heavy 91b-6", "syntax"},
                                     {"exactly 1 heavy 91b-6 373b-8 0b0", "syntax"},
                                     {"exactly 1 medium 91b-6 373b-8", "syntax"},
                                     {"exactly 0 heavy 91b-6 373b-8", "number"},
                                     {"exactly 1 heavy 373b-8 91b-6", "number"},
                                     {"exactly 1 heavy 91b-6 91b-6", "number"},
                                     {"exactly 1 heavy 0b0 373b-8", "number"},
                                     {"exactly 1 heavy 182b-7 373b-8", "number"},
                                     {"exactly 1 heavy 91b-6 373/256", "number"},
                                     {"exactly 01 heavy 91b-6 373b-8", "number"},
                                     {"exactly -1 heavy 91b-6 373b-8", "number"},
                                     {"between 1 1 heavy 91b-6 373b-8", "number"},
                                     {"between 2 1 heavy 91b-6 373b-8", "number"},
                                     {"between 0 5 heavy 91b-6 373b-8", "number"},
                                     {"between 1 none", "number"},
                                     {"between 5", "syntax"},
                                     {"open 1", "opcode"},
                                     {"sometimes", "opcode"},
                                     {"sometimes 1", "opcode"},
                                     {"count 1 2", "opcode"},
                                     {"split r", "syntax"},
                                     {"split", "syntax"},
                                     {"split phi phi", "syntax"},
                                     {"split ratio", "syntax"},
                                     {"total split 0", "opcode"}}) {
        INFO(line);
        CHECK(initial_mutant("exactly 1 heavy 91b-6 373b-8", line) == code);
    }
}

TEST_CASE("only axes of positive width are halved, at most 400 times each") {
    for (const char* axis : {"phidot", "y", "ydot", "q"}) {
        const std::string halved = "exactly 1 heavy 91b-6 373b-8\n";
        CHECK(initial_mutant(halved, "split " + std::string(axis) + "\n" + halved + halved) == "split");
    }
    const auto chain = [](int depth) {
        std::string tree;
        for (int i = 0; i < depth; ++i) tree += "split phi\n";
        for (int i = 0; i <= depth; ++i) tree += "exactly 0\n";
        return tree;
    };
    CHECK(outcome(leaving(chain(400))) == "verified");
    CHECK(outcome(leaving(chain(401))) == "depth");
    std::string deep;  // 400 splits of each axis
    for (int i = 0; i < 400; ++i)
        for (const char* axis : {"phi", "phidot", "y", "ydot", "q"})
            deep += std::string("split ") + axis + "\n";
    for (int i = 0; i <= 2000; ++i) deep += "exactly 0\n";
    CHECK(outcome(leaving(deep)) == "verified");
}

TEST_CASE("bounds and totals are those of the leaves") {
    for (const char* bounds :
         {"between 0 5", "between 1 4", "between 1 6", "between 2 5", "between 1 none", "between 0 none"})
        CHECK(initial_mutant("between 1 5\n", std::string(bounds) + "\n") == "between");
    CHECK(initial_mutant("between 1 5\n", "between 1\n") == "syntax");
    CHECK(initial_mutant("between 1 5\n", "between none 5\n") == "number");
    CHECK(outcome(leaving("open\n", "between 0 0")) == "between");
    CHECK(outcome(leaving("open\n", "between 1 none")) == "between");
    for (const char* total : {"total split 1", "total exactly ", "total between ", "total open "}) {
        const std::size_t at = falling().rfind(total);
        std::string text = falling().substr(0, falling().rfind("sha256"));
        text.insert(at + std::string(total).size(), "1");
        CHECK(outcome(make::hashed(text)) == "total");
    }
    std::string other_hash = falling();
    other_hash[other_hash.size() - 2] ^= 1;
    CHECK(outcome(other_hash) == "sha256");
    CHECK(outcome(falling() + "\n") == "trailing");
    CHECK(outcome(make::hashed(
              replaced(falling().substr(0, falling().rfind("sha256")), "total open 0\n", ""))) == "syntax");
}

TEST_CASE("the shares of a file are those of its leaves") {
    dumbbell_verify::Request settings;
    settings.shares = true;
    const make::File file(leaving("split phi\nsplit y\nexactly 0\nopen\nopen\n", "between 0 none"));
    const auto proof = dumbbell_verify::verify(file.path(), settings);
    const auto claim = dynamic_cast<const dumbbell_verify::starts::Claim&>(*proof.other);
    CHECK((claim.decided == mpq_class(1, 4)));
    CHECK((claim.shares.value().open == mpq_class(3, 4)));
    CHECK((claim.shares.value().counts.at(0).exact == mpq_class(1, 4)));
    const auto rows = claim.shares.value().rows();
    REQUIRE(rows.size() == 2);
    CHECK((rows[0].least == 0 && rows[0].most == 0U && rows[0].lo == mpq_class(1, 4) && rows[0].hi == 1));
    CHECK((rows[1].least == 1 && !rows[1].most && rows[1].lo == 0 && rows[1].hi == mpq_class(3, 4)));
    const auto without = dumbbell_verify::verify(file.path(), {});
    CHECK_FALSE(dynamic_cast<const dumbbell_verify::starts::Claim&>(*without.other).shares.has_value());
}

TEST_CASE("boxes at rest or in the floor are refused") {
    CHECK(initial_mutant("ydot -1/1 -1/1", "ydot -1/1 0/1") != "verified");
    CHECK(outcome(mutated(mutated(falling(), "phidot 1/100 1/100", "phidot 0/1 1/100"), "ydot -1/1 -1/1",
                          "ydot -1/1 0/1")) == "rest");
    const auto still = [](const std::string& phi, const std::string& phidot) {
        return outcome(closed(initial_header("10/1 10/1", phi, phidot, "1/1 1/1", "0/1 0/1") +
                              "between 0 none\nopen\n"));
    };
    CHECK(still("1/1 2/1", "0/1 0/1") == "rest");
    CHECK(still("0/1 0/1", "1/2 1/2") == "verified");
    CHECK(initial_mutant("y 3/2 3/2", "y 1/2 3/2") == "floor");  // the light mass, at phi = -1
    CHECK(initial_mutant("y 3/2 3/2", "y 1/100 1/100") == "floor");
    CHECK(initial_mutant("y 3/2 3/2", "y -3/2 3/2") == "floor");
    const auto upright = [](const std::string& y) {  // the heavy mass is lowest, at height y - sin(phi)/11
        return closed(initial_header("10/1 10/1", "1/1 2/1", "1/2 1/1", y + " 2/1", "1/1 2/1") +
                      "between 0 0\nexactly 0\n");
    };
    CHECK(outcome(upright("1/11")) == "floor");
    CHECK(outcome(upright("1/10")) == "verified");
    // Exactly on the floor, and above it by less than a double tells.
    const auto level = [](const std::string& y) {
        return closed(initial_header("10/1 10/1", "0/1 0/1", "1/2 1/2", y + " 1/1", "1/1 1/1") +
                      "between 0 none\nopen\n");
    };
    CHECK(outcome(level("0/1")) == "floor");
    CHECK(outcome(level("1/100000000000000000000000000000000000000000000000000")) == "verified");
}
