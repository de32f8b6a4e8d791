// Files about the law as a script sees them: words, last line, exit code, options.
#include <algorithm>

#include "catch.hpp"
#include "make_file.hpp"
#include "rooms/verify/program/run_program.hpp"
#include "scale.hpp"
#include "verify/wings/law/claim.hpp"
#include "verify/wings/law/leaf.hpp"

using make::run;

TEST_CASE("law: the verdict states the law, and nothing of single ratios") {
    dumbbell_verify::law::Claim claim;
    claim.from = {mpq_class(313, 5), mpq_class(251, 4)};
    CHECK(claim.text() == "claim=law steps=3:902 from=313/5:251/4 least=0.980 most=2.115");
    CHECK(
        claim.paragraph() ==
        "  N*(q) is the greatest number of collisions at the mass ratio q, q_c(N) the ratio beyond which it "
        "is\n  at least N. For every q >= q_c(9):\n"
        "  2 + floor(C sqrt q - c0 q^(-1/4)) <= N*(q) <= 2 + floor(C sqrt q),\n"
        "  C = 0.885595..., c0 = 0.205811...; and 0.980 <= N*(q) - C sqrt q <= 2.115 for every q >= 1.\n");
    CHECK(claim.json() ==
          R"({"kind":"law","steps":{"first":3,"last":902},"from":{"lo":"313/5","hi":"251/4"},"excess":{"lo":)"
          R"("49/50","hi":"423/200"}})");
    const make::File file(make::law_file()), bare(file.path() + "\t--claim collisions\n");
    CHECK(run("--claim laws " + file.path()).code == 2);
    CHECK(run("--budget 0.05s " + file.path()).code == 4);
    for (const char* demand :
         {"--max 5", "--min 1", "--exactly 2", "--ratio 399", "--claim law --ratio 1e7"}) {
        INFO(demand);
        CHECK(run(std::string(demand) + " " + file.path()).code == 2);
    }
    if (scaled(1) < 20 || make::sanitized) return;  // each run below verifies the law: seconds, or a minute
    const make::Run verified = run("--claim law --leaves " + file.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() == "s VERIFIED " + claim.text() +
                                 " sha256=" + make::law_file().substr(make::law_file().size() - 65, 64) +
                                 " demanded-claim=law");
    CHECK(has(verified, claim.paragraph()));
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
    CHECK(has(run("--json " + file.path()), "\"claim\":" + claim.json()));
    CHECK(run("--claims " + bare.path()).code == 2);
    CHECK(run("--claim collisions " + file.path()).code == 1);
    CHECK(has(run("--explain end.1501 " + file.path()), "there is no leaf end.1501"));
}

namespace {
/// No cover closes, and all are read.
const std::string& open_covers() {
    static const std::string text =
        make::closed(make::law_steps() + "cover layer\nslope\ncover bulk 1 1 1\ncover end 1\n");
    return text;
}
std::string changed_covers(const std::string& from, const std::string& to) {
    return make::closed(make::replaced(open_covers().substr(0, open_covers().find("total split")), from, to));
}
std::string line_of(const std::string& words) {
    const auto& text = open_covers();
    const auto at = static_cast<std::ptrdiff_t>(text.find("\n" + words + "\n") + 1);
    return ", line " + std::to_string(1 + std::count(text.begin(), text.begin() + at, '\n')) + ": " + words +
           "\n";
}
}  // namespace

TEST_CASE("law: the covers are those of the claim, whole: one leaf of each in numbers") {
    const make::File file(open_covers());
    const std::string bulk = line_of("cover bulk 1 1 1"),
                      p = "  |D/((eps/2) (alpha' - alpha)) - p(th)| <= 0.006 + 0.75 th^8: does NOT hold\n";
    std::vector<std::tuple<std::string, std::string, std::string>> leaves{
        {"bulk3.1", bulk + "  th in [7/10, 993/1250]\n  Q/cos", p},
        {"end.1", line_of("cover end 1") + "  d in [0/1, 9/100]\n  [0.0009",
         "  |(e_end - k0 sqrt(eps))/eps + 0.1657| <= 0.003 + 0.5 d: does NOT hold\n"}};
    if (scaled(1) >= 20) {
        leaves.emplace_back("bulk1.1", bulk + "  th in [0/1, 3/5]\n  Q/cos", p);
        leaves.emplace_back("bulk2.1", bulk + "  th in [3/5, 7/10]\n  Q/cos", p);
    }
    for (const auto& [leaf, begin, fact] : leaves) {
        const make::Run shown = run("--explain " + leaf + " " + file.path());
        INFO(leaf << "\n" << shown.out);
        CHECK(shown.code == 1);
        CHECK(shown.out.starts_with(leaf + begin));
        CHECK(has(shown, fact));
    }
}

TEST_CASE("law: what doubles do not decide is tried again: a step with its own bits, a cover with 53") {
    const make::File near(
        changed_covers("step 9 313/5 251/4\nbits 53\n", "step 9 313/5 626001/10000\nbits 64\n"));
    const make::Run twice = run("--explain 9:witness " + near.path());
    CHECK(has(twice, "\n  53 bits, claimed 9\n"));
    CHECK(has(twice, "\n  64 bits, claimed 9\n"));
    CHECK(has(twice, "  NOT certified\n"));
    const make::Run before = run("--explain 8:witness " + near.path());
    CHECK(has(before, "  V <= 1 + a + b: holds\n"));
    CHECK(has(before, "  certified\n"));
    const make::Run precise = run("--precision 64 --explain 8:witness " + near.path());
    CHECK(has(precise, "\n  64 bits, claimed 8\n"));
    CHECK_FALSE(has(precise, "53 bits"));
    // Of a cover these are 53 whatever the last step has.
    const std::string last = make::law_line("step 902 ");
    const make::File long_last(changed_covers(last + "\nbits 53\n", last + "\nbits 64\n"));
    dumbbell_verify::law::Leaf leaf;
    leaf.rule = dumbbell_verify::law::Leaf::slope;
    leaf.box.hi = {mpq_class(9, 10), mpq_class(1, 5)};
    dumbbell_verify::Log log;
    CHECK(dumbbell_verify::law::check_layer(leaf, &log) != nullptr);
    const make::Run layer = run("--explain layer " + long_last.path());
    INFO(layer.out);
    CHECK(layer.code == 1);
    CHECK(layer.out.starts_with("layer" + line_of("slope") + "  U in [0/1, 9/10]\n  rho in [0/1, 1/5]\n" +
                                log.text + "  NOT certified\n"));
}
