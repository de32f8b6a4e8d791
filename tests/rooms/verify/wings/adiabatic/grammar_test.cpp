// Every rule of format-adiabatic.md, section 2, has here a file that breaks it and nothing else.
#include "catch.hpp"
#include "make_file.hpp"

using namespace make;
using dumbbell_verify::Request;

TEST_CASE("adiabatic grammar: unknown words make a file unsupported") {
    for (const auto& [from, to] : {std::pair{"claim adiabatic-run", "claim adiabatic-walk"},
                                   {"claim adiabatic-run", "claim adiabatic"},
                                   {"claim adiabatic-run", "claim adiabatic-printed"},
                                   {"section none", "section turning"},
                                   {"lemmas 1", "lemmas minimal"},
                                   {"scene dumbbell", "scene body"},
                                   {"dumbbell-certificate 1", "dumbbell-certificate 2"}}) {
        INFO(to);
        CHECK(mutant(run_file(), from, to) == "unsupported");
    }
    CHECK(mutant(run_file(), "claim adiabatic-run", "claim initial-conditions") == "syntax");
}

TEST_CASE("adiabatic grammar: the header") {
    for (const char* value : {"0/1 1/20", "1/20 1/2", "1/20 0/1", "1/19 1/20", "1/20 2/40", "-1/20 1/20",
                              "1/20", "0 1/20", "0/1 1/20"}) {
        INFO(value);
        CHECK(mutant(bounce(), "delta 1/20 1/20", std::string("delta ") + value) ==
              (std::string(value) == "1/20" ? "syntax" : "number"));
    }
    CHECK(mutant(run_file(), "delta 1/20 1/20", "delta 0/1 0/1") == "number");
    for (const char* value : {"3/5 3/5", "9/10 3/5", "3/5 11/10", "-1/5 9/10"})
        CHECK(mutant(run_file(), "heights 3/5 9/10", std::string("heights ") + value) == "number");
    CHECK(mutant(scattering(), "margin 1/1\n", "heights 0/1 1/1\nmargin 1/1\n") == "syntax");
    for (const char* value : {"0/1", "-1/2", "11/10", "1/0", "2/2", "1"})
        CHECK(mutant(bounce(), "margin 1/1", std::string("margin ") + value) == "number");
    CHECK(mutant(bounce(), "exponent 8", "exponent 17") == "number");
    CHECK(mutant(bounce(), "exponent 8\n", "") == "syntax");
    CHECK(mutant(run_file(), "bits 53\n", "exponent 8\nbits 53\n") == "syntax");
    CHECK(mutant(bounce(), "bits 53", "bits 52") == "number");
    CHECK(mutant(bounce(), "bits 53", "bits 4097") == "number");
    CHECK(mutant(bounce(), "bits 53", "bits 2049") == "limit");
    CHECK(mutant(bounce(), "bits 53", "bits 200") == "verified");
    CHECK(mutant(bounce(), "bound 5/2 10/1", "bound 5/2") == "syntax");
    CHECK(mutant(run_file(), "bound 20/1", "bound 20/1 20/1") == "syntax");
    // Refused at once, before what is wrong behind it.
    CHECK(mutant(mutated(bounce(), "exponent 8\n", ""), "delta 1/20 1/20", "delta 1/19 1/20") == "number");
}

TEST_CASE("adiabatic grammar: classes and cells") {
    for (const char* value : {"0", "65", "01"})
        CHECK(mutant(run_file(), "classes 1", std::string("classes ") + value) == "number");
    CHECK(mutant(run_file(), "classes 1", "classes 2") == "syntax");
    for (const char* value : {"13/10 0", "13/10 4097", "-13/10 40"})
        CHECK(mutant(run_file(), "class 13/10 40", std::string("class ") + value) == "number");
    CHECK(mutant(run_file(), "class 13/10 40", "class 13/10 41") == "syntax");
    CHECK(mutant(run_file(), "class 13/10 40", "class 13/10 39") == "opcode");
    const std::size_t first = run_file().find("cell ");
    const std::string cell = run_file().substr(first, run_file().find('\n', first) - first);
    CHECK(mutant(run_file(), cell, "cell 11/7 1/1") == "number");
    CHECK(mutant(run_file(), cell, "cell 1/10 1/1") == "number");  // the next one is higher
    CHECK(mutant(run_file(), cell, cell.substr(0, cell.rfind(' ')) + " -1/1") == "number");
    CHECK(mutant(run_file(), "\nend\n", "\n") == "syntax");
    CHECK(mutant(run_file(), "\nend\n", "\nend 1\n") == "syntax");
}

TEST_CASE("adiabatic grammar: a leaf of a run is checked with the class that it names") {
    const std::size_t first = run_file().find("class 13/10"), end = run_file().find("\nend\n") + 1;
    // The second class is about so fast flights alone that nothing follows from it here.
    const std::string second =
        replaced(run_file().substr(first, end - first), "class 13/10 40", "class 3/1 40");
    std::string two = run_file().substr(0, end) + second + run_file().substr(end);
    two = mutated(two, "classes 1", "classes 2");
    CHECK(outcome(two) == "verified");
    CHECK(mutant(two, "\nbound 0\n", "\nbound 1\n") == "bound");
    CHECK(mutant(two, "\nbound 0\n", "\nbound 2\n") == "number");
}

TEST_CASE("adiabatic grammar: trees") {
    CHECK(mutant(run_file(), "split sigma", "split s") == "syntax");
    CHECK(mutant(run_file(), "split sigma", "split delta") == "split");  // of width 0
    CHECK(mutant(bounce(), "split u", "split v") == "syntax");
    CHECK(mutant(bounce(), "split u", "split sigma") == "syntax");
    CHECK(mutant(bounce(), "split u", "split") == "syntax");
    CHECK(mutant(bounce(), "\nbound\n", "\nbound 0\n") == "syntax");
    CHECK(mutant(run_file(), "\nbound 0\n", "\nbound\n") == "syntax");
    CHECK(mutant(run_file(), "\nbound\n", "\nbound 0\n") == "syntax");
    CHECK(mutant(bounce(), "\noutside\n", "\noutside 0\n") == "syntax");
    CHECK(mutant(bounce(), "\nbound\n", "\nopen\n") == "opcode");
    std::string deep = small_bounce().header();
    for (int i = 0; i < 201; ++i) deep += "split u\n";
    CHECK(outcome(closed(deep)) == "depth");
}

TEST_CASE("adiabatic grammar: attained states, totals and the end") {
    const std::string state = "attained 1119/5000 1/1 1/20 1 97/50\n";
    CHECK(mutant(bounce(), "attained 1119/5000 1/1 1/20 1 857/100\n", "") == "syntax");
    CHECK(mutant(bounce(), state, state + state) == "syntax");
    CHECK(mutant(bounce(), "1/20 1 97/50", "1/20 1 -97/50") == "number");
    CHECK(mutant(bounce(), "1/20 1 97/50", "1/20 01 97/50") == "number");
    CHECK(mutant(bounce(), "1/20 1 97/50", "1/20 1") == "syntax");
    for (const char* kind : {"split", "bound", "outside"}) {
        const std::string line = "total " + std::string(kind) + " ";
        const std::size_t at = bounce().find(line);
        const std::string number =
            bounce().substr(at + line.size(), bounce().find('\n', at) - at - line.size());
        const std::string body = bounce().substr(0, bounce().find("sha256"));
        CHECK(outcome(hashed(replaced(body, line + number, line + number + "1"))) == "total");
    }
    CHECK(outcome(replaced(bounce(), "generator test", "generator tess")) == "sha256");
    CHECK(outcome(bounce() + "end\n") == "trailing");
    CHECK(outcome(bounce().substr(0, bounce().size() / 2)) == "truncated");
}

TEST_CASE("adiabatic grammar: the least and the greatest numbers are allowed") {
    // It is the next line that is missing.
    const std::string no_bits = mutated(bounce(), "bits 53\n", "");
    for (const char* value : {"0", "16"})
        CHECK(mutant(no_bits, "exponent 8", std::string("exponent ") + value) == "syntax");
    CHECK(mutant(run_file(), "classes 1", "classes 64") == "syntax");
    CHECK(mutant(bounce(), "attained 1119/5000 1/1 1/20 1 97/50", "attained 4/5 0/1 1/20 1 0/1") ==
          "verified");
    Request settings;
    settings.max_bits = 4096;
    const std::string precise = mutated(bounce(), "bits 53", "bits 4096");
    CHECK((dynamic_cast<const dumbbell_verify::adiabatic::Claim*>(
               dumbbell_verify::verify(File(precise).path(), settings).other.get()) != nullptr));
    // One cell is enough, and the 4096th is still one; it is the tree that is missing.
    const auto with_cells = [](int number) {
        std::string text = run_file().substr(0, run_file().find("cell "));
        text = replaced(text, " 40\n", " " + std::to_string(number) + "\n");
        for (int i = 1; i <= number; ++i) text += "cell " + fraction(mpq_class(9001 - i, 9001)) + " 0/1\n";
        return outcome(closed(text + "split q\n"));
    };
    CHECK(with_cells(1) == "syntax");
    CHECK(with_cells(4096) == "syntax");
    CHECK(with_cells(4097) == "number");
}

TEST_CASE("adiabatic grammar: an attained state may be anywhere between the ends of delta") {
    const std::string wide = mutated(mutated(bounce(), "delta 1/20 1/20", "delta 49999999/1000000000 1/20"),
                                     "bound 5/2 10/1", "bound 50/1 500/1");
    for (const char* delta : {"49999999/1000000000", "99999999/2000000000", "1/20"})
        CHECK(mutant(wide, "1/20 1 97/50", std::string(delta) + " 1 1/100") == "verified");
    for (const char* delta : {"24999999/500000000", "50000001/1000000000", "0/1"})
        CHECK(mutant(wide, "1/20 1 97/50", std::string(delta) + " 1 1/100") == "number");
}

TEST_CASE("adiabatic grammar: a leaf that is not certified goes before what is wrong after it") {
    const std::string narrow = mutated(bounce(), "bound 5/2 10/1", "bound 1/100 10/1");
    CHECK(outcome(narrow) == "bound");
    CHECK(mutant(narrow, "1/20 1 97/50", "1/20 1 -97/50") == "bound");
}

TEST_CASE("adiabatic: leaves are checked while the file is read") {
    const std::function<std::string(int)> halved = [&](int depth) {
        const std::string half = depth > 0 ? halved(depth - 1) : "";
        return depth > 0 ? "split u\n" + half + half : "bound\n";
    };
    const std::string file = closed(small_bounce().header() + halved(12));
    Request settings;
    settings.budget = file.size() / 2 * 384;  // units: less than half of what the text and its boxes cost
    CHECK(outcome(file, settings) == "bound");
}

TEST_CASE("adiabatic: the precision that is asked for is worked in, and its work is told") {
    const auto work = [](unsigned bits) {
        Request settings;
        settings.precision = bits;
        settings.max_bits = 4096;
        return dumbbell_verify::verify(File(bounce()).path(), settings).work;
    };
    const std::uint64_t of_100 = work(100), of_1000 = work(1000);
    CHECK(of_100 > 0);
    CHECK(of_1000 > 2 * of_100);
}
