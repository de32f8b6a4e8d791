// Files about the law as a script sees them: words, last line, exit code, options.
#include <algorithm>

#include "catch.hpp"
#include "make_file.hpp"
#include "rooms/verify/program/run_program.hpp"

using make::run;

TEST_CASE("law: the verdict states the law, and nothing of single ratios") {
    const make::File file(make::law_file()), bare(file.path() + "\t--claim collisions\n");
    const std::string step = make::law_line("step 9 "), a = step.substr(7, step.rfind(' ') - 7),
                      b = step.substr(step.rfind(' ') + 1);
    const make::Run verified = run("--claim law " + file.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() ==
          "s VERIFIED claim=law steps=3:902 from=" + a + ":" + b + " least=0.980 most=2.115 sha256=" +
              make::law_file().substr(make::law_file().size() - 65, 64) + " demanded-claim=law");
    CHECK(has(verified, "  2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q),\n"));
    if (make::sanitized) return;  // the runs below verify the law: a minute
    CHECK(run("--claims " + bare.path()).code == 2);
    const make::Run json = run("--json " + file.path());
    CHECK(has(json, "\"claim\":{\"kind\":\"law\",\"steps\":{\"first\":3,\"last\":902},\"from\":{\"lo\":\"" +
                        a + "\",\"hi\":\"" + b + "\"},\"excess\":{\"lo\":\"49/50\",\"hi\":\"423/200\"}}"));
    CHECK(run("--claim collisions " + file.path()).code == 1);
    CHECK(run("--claim laws " + file.path()).code == 2);
    CHECK(run("--budget 0.5s " + file.path()).code == 4);
    for (const char* demand :
         {"--max 5", "--min 1", "--exactly 2", "--ratio 399", "--claim law --ratio 1e7", "--together"}) {
        INFO(demand);
        CHECK(run(std::string(demand) + " " + file.path()).code == 2);
    }
}

TEST_CASE("law: the covers are those of the claim, whole: one leaf of each in numbers") {
    // No cover closes, and all are read.
    const std::string text =
        make::closed(make::law_steps() + "cover layer\nslope\ncover bulk 1 1 1\ncover end 1\n");
    const make::File file(text);
    const auto line = [&](const std::string& words) {
        const auto at = static_cast<std::ptrdiff_t>(text.find("\n" + words + "\n") + 1);
        return ", line " + std::to_string(1 + std::count(text.begin(), text.begin() + at, '\n')) + ": " +
               words + "\n";
    };
    for (const auto& [leaf, begin, fact] :
         {std::tuple{
              "layer", line("slope") + "  U in [0/1, 9/10]\n  rho in [0/1, 1/5]\n  -1.5",
              "  0 < ((1 + rho)^2 k1 - 2 rho ehat)/((1 - rho)^2 ehat/2): does NOT hold\n  NOT certified\n"},
          {"bulk1.1", line("cover bulk 1 1 1") + "  th in [0/1, 3/5]\n  Q/cos",
           "  |D/((eps/2) (alpha' - alpha)) - p(th)| <= 0.006 + 0.75 th^8: does NOT hold\n"},
          {"bulk2.1", line("cover bulk 1 1 1") + "  th in [3/5, 7/10]\n  Q/cos",
           "  |D/((eps/2) (alpha' - alpha)) - p(th)| <= 0.006 + 0.75 th^8: does NOT hold\n"},
          {"bulk3.1", line("cover bulk 1 1 1") + "  th in [7/10, 993/1250]\n  Q/cos",
           "  |D/((eps/2) (alpha' - alpha)) - p(th)| <= 0.006 + 0.75 th^8: does NOT hold\n"},
          {"end.1", line("cover end 1") + "  d in [0/1, 9/100]\n  [0.0009",
           "  |(e_end - k0 sqrt(eps))/eps + 0.1657| <= 0.003 + 0.5 d: does NOT hold\n"}}) {
        const make::Run shown = run("--explain " + std::string(leaf) + " " + file.path());
        INFO(leaf << "\n" << shown.out);
        CHECK(shown.code == 1);
        CHECK(shown.out.starts_with(leaf + begin));
        CHECK(has(shown, fact));
    }
    const make::Run shown = run("--explain 9:witness " + file.path());
    CHECK(has(shown, "  V <= 1 + a + b: holds\n"));
    CHECK(has(shown, "  certified\n"));
    // What doubles do not decide is tried again: a step with its own bits, a cover with 53, whatever the last
    // step has.
    const auto with = [&](const std::string& step, const std::string& changed) {
        return make::closed(make::replaced(text.substr(0, text.find("total split")), step, changed));
    };
    const make::File near(with("step 9 313/5 251/4\nbits 53\n", "step 9 313/5 626001/10000\nbits 64\n"));
    const make::Run twice = run("--explain 9:witness " + near.path());
    CHECK(has(twice, "\n  53 bits, claimed 9\n"));
    CHECK(has(twice, "\n  64 bits, claimed 9\n"));
    CHECK(has(twice, "  NOT certified\n"));
    const std::string last = make::law_line("step 902 ");
    const make::File long_last(with(last + "\nbits 53\n", last + "\nbits 64\n"));
    const auto layer = [](const make::File& in) {
        const std::string out = run("--explain layer " + in.path()).out;
        return out.substr(0, out.rfind("  NOT certified\n"));
    };
    CHECK(layer(file).find("does NOT hold\n") != std::string::npos);
    CHECK(layer(long_last) == layer(file));
    const make::Run precise = run("--precision 64 --budget 1s --explain 9:witness " + file.path());
    CHECK(precise.code == 4);
    CHECK(has(precise, "\n  64 bits, claimed 9\n"));
    CHECK_FALSE(has(precise, "53 bits"));
    const make::File whole(make::law_file());
    CHECK(run("--explain end.1501 " + whole.path()).last().find("there is no leaf end.1501") !=
          std::string::npos);
}

TEST_CASE("law: the shipped certificate is counted line by line") {
    const make::Run verified = run("--leaves " DUMBBELL_PROJECT "/certificates/law.dbc.gz");
    CHECK(verified.code == 0);
    CHECK(has(verified,
              "  split                 50409 line(s)    0.00000 % of the root boxes\n"
              "  count                  1937 line(s)   98.55470 % of the root boxes\n"
              "  outside                 446 line(s)    1.27873 % of the root boxes\n"
              "  meets                     0 line(s)    0.00000 % of the root boxes\n"
              "  meets-reversed            0 line(s)    0.00000 % of the root boxes\n"
              "  equal-masses              1 line(s)    0.11105 % of the root boxes\n"
              "  witness                 900 line(s)    0.00000 % of the root boxes\n"
              "  slope                 48811 line(s)    0.01680 % of the root boxes\n"
              "  beyond                 1014 line(s)    0.03872 % of the root boxes\n"));
}
