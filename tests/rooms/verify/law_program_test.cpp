// Files about the law as a script sees them: words, last line, exit code, options.
#include <catch2/catch.hpp>

#include "make_law.hpp"
#include "run_program.hpp"

using make::run;

TEST_CASE("law: the verdict states the law, and nothing of single ratios") {
    const make::File file(make::law_file()), list(file.path() + "\t--claim law\n"),
        bare(file.path() + "\t--claim collisions\n");
    const std::string step = make::law_line("step 9 "), a = step.substr(7, step.rfind(' ') - 7),
                      b = step.substr(step.rfind(' ') + 1);
    const make::Run verified = run("--claim law " + file.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() ==
          "s VERIFIED claim=law steps=3:902 from=" + a + ":" + b +
              " least=0.980 most=2.115 sha256=" + make::law_file().substr(make::law_file().size() - 65, 64));
    CHECK(has(verified, "  2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q),\n"));
    if (make::sanitized) return;  // each run below verifies the law: a minute
    CHECK(run("--quiet --claims " + list.path()).last().starts_with("s VERIFIED claim=law "));
    CHECK(run("--claims " + bare.path()).code == 2);
    const make::Run json = run("--json " + file.path());
    CHECK(has(json, "\"claim\":{\"kind\":\"law\",\"steps\":{\"first\":3,\"last\":902},\"from\":{\"lo\":\"" +
                        a + "\",\"hi\":\"" + b + "\"},\"excess\":{\"lo\":\"49/50\",\"hi\":\"423/200\"}}"));
    CHECK(run("--claim collisions " + file.path()).code == 1);
    CHECK(run("--claim laws " + file.path()).code == 2);
    CHECK(run("--budget 0.5s " + file.path()).code == 4);
    for (const char* demand :
         {"--max 5", "--min 1", "--exactly 2", "--ratio 399", "--claim law --ratio 1e7", "--shards 1-2"}) {
        INFO(demand);
        CHECK(run(std::string(demand) + " " + file.path()).code == 2);
    }
    CHECK(run("--lemma 4.1 " + file.path() + " " + file.path()).code == 2);
}

TEST_CASE("law: one leaf of each cover in numbers") {
    const make::File file(make::law_file());
    for (const auto& [leaf, line] :
         {std::pair{"9:witness", "  V <= 1 + a + b: holds\n"},
          {"bulk3.17", "  D/((eps/2) (alpha' - alpha)) in its range: holds\n"},
          {"end.17", "  -0.23 <= (e_end - k0 sqrt(eps))/eps <= -0.0885: holds\n"}}) {
        const make::Run shown = run("--explain " + std::string(leaf) + " " + file.path());
        INFO(leaf);
        CHECK(shown.code == 0);
        CHECK(has(shown, line));
        CHECK(has(shown, "  certified\n"));
    }
    CHECK(run("--explain end.1501 " + file.path()).last().find("there is no leaf end.1501") !=
          std::string::npos);
}
