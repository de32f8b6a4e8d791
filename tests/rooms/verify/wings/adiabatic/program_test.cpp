// Files about the adiabatic invariant as a script sees them: words, last line, exit code, options.
#include "catch.hpp"
#include "make_file.hpp"
#include "rooms/verify/program/run_program.hpp"

using namespace make;
using make::run;

namespace {
std::string digest(const std::string& text) { return text.substr(text.size() - 65, 64); }
}  // namespace

TEST_CASE("adiabatic: the verdict states the claim, C and C/B rounded up, B rounded down") {
    Adiabatics exact = small_run();
    exact.terms.claim.bounds = {mpq_class(200000001, 10000000)};          // 20.0000001
    exact.terms.claim.attained[0].value = mpq_class(93000009, 10000000);  // 9.3000009
    const std::string text = exact.file();
    const File good(text), bad(mutated(text, "bound 200000001/10000000", "bound 9/1"));
    const Run verified = run(good.path());
    CHECK(verified.code == 0);
    CHECK(verified.last() ==
          "s VERIFIED claim=adiabatic-run delta=1/20:1/20 heights=3/5:9/10 margin=1/2 C=20.000001 B=9.300000 "
          "ratio=2.150538 sha256=" +
              digest(text));
    CHECK(has(verified, "|I_n - I_0| <= C delta for every number n of further collisions, C = 20.000001;"));
    CHECK(has(verified, "C/B <= 2.150538.\n"));
    CHECK(run(bad.path()).code == 1);
    CHECK(run(bad.path()).last().starts_with("s REJECTED line="));
    CHECK(run(bad.path()).last().ends_with(" code=bound not certified: |I_n - I_0|/delta <= C"));
    CHECK_FALSE(has(run(bad.path()), "<= C delta for every"));
    CHECK(run("--jobs 1 " + good.path()).out == run("--jobs 7 " + good.path()).out);

    const File of_bounce(bounce());
    CHECK(has(run(of_bounce.path()), "<= C1 delta, C1 = 2.500000,\n"));
    CHECK(has(run(of_bounce.path()), "<= 2 C2 delta^(3/2), C2 = 10.000000.\n"));
    CHECK(
        has(run(of_bounce.path()), " margin=1/1 exponent=8/16 C1=2.500000 B1=1.940000 ratio1=1.288660 C2="));
}

TEST_CASE("adiabatic: over a range of delta the verdict says at which of them a value is attained") {
    dumbbell_verify::adiabatic::Claim claim = small_run().terms.claim;
    CHECK_FALSE(has(claim.text(), " at="));
    claim.delta_lo = 0;
    CHECK(has(claim.text(), " B=9.300000 at=1/20 ratio="));
    claim = small_bounce().terms.claim;
    claim.delta_lo = mpq_class(1, 25);
    CHECK(has(claim.text(), " at1=1/20 "));
    CHECK(has(claim.text(), " at2=1/20 "));
}

TEST_CASE("adiabatic: a value of 0 has no ratio") {
    Adiabatics low = small_bounce();
    low.terms.claim.attained[0].value = 0;
    const File file(low.file());
    CHECK(run(file.path()).code == 0);
    CHECK(has(run(file.path()), " B1=0.000000 C2=10.000000 "));
    CHECK(has(run("--json " + file.path()), "\"value\":\"0/1\",\"ratio\":null}"));
}

TEST_CASE("adiabatic: such a file is no answer to a question about numbers of collisions") {
    const File file(run_file());
    const auto code = [&](const std::string& options) { return run(options + " " + file.path()).code; };
    for (const char* demand : {"--max 5", "--min 1", "--exactly 2", "--ratio 399"}) {
        CHECK(code(demand) == 2);
        CHECK(has(run(std::string(demand) + " " + file.path()).last(), "this file's claim is adiabatic-run"));
    }
    CHECK(code("--claim initial-conditions --max 3") == 2);
    CHECK(code("--claim adiabatic-run --max 3") == 2);
    CHECK(run("--max 5 " + file.path())
              .last()
              .starts_with("s UNREADABLE what is demanded is about all trajectories, "));  // of no line
    CHECK(code("--claim adiabatic-run") == 0);
    CHECK(code("--claim adiabatic-scattering") == 1);
    CHECK(code("--claim collisions") == 1);
    CHECK(code("--claim initial-conditions") == 1);
    CHECK(code("--claim adiabatic") == 2);
    CHECK(code("--scene body") == 1);
    const File list(file.path() + "\t--ratio 399 --max 20\n");
    CHECK(run("--claims " + list.path()).code == 2);
    const File ten(make::ten());
    CHECK(run("--claim adiabatic-run " + ten.path()).code == 1);
    CHECK(run("--claim adiabatic-run --delta 1/20 --constant 20 " + ten.path()).code == 1);
    const std::string whole = "--delta 0.05 --heights 0.6:0.9 --margin 1/2 --constant 20 --attained 9.3";
    CHECK(run("--claim adiabatic-run " + whole + " " + file.path())
              .last()
              .ends_with(" demanded-claim=adiabatic-run demanded-delta=1/20:1/20 demanded-heights=3/5:9/10 "
                         "demanded-margin=1/2 demanded-constant=20/1 demanded-attained=93/10"));
    CHECK(has(run("--claim adiabatic-run --constant 19.99 " + file.path()), "claim-not-proved"));
    CHECK(has(run("--claim adiabatic-run --constant 20 " + file.path()),
              "  Not demanded: delta, heights, margin, attained.\n"));
    const auto listed = [&](const std::string& claim) {
        const File row(file.path() + "\t" + claim + "\n");
        return run("--claims " + row.path()).code;
    };
    CHECK(listed("--claim adiabatic-run " + whole) == 0);
    CHECK(listed("--claim adiabatic-run --delta 0.05 --constant 19") == 1);
    CHECK(listed("--claim adiabatic-run --delta 0.05") == 2);
    CHECK(listed("--claim adiabatic-run --constant 20") == 2);
}

TEST_CASE("adiabatic: --json and --explain") {
    const File file(run_file());
    const Run json = run("--json " + file.path());
    CHECK(json.code == 0);
    CHECK(
        has(json,
            "\"claim\":{\"kind\":\"adiabatic-run\",\"delta\":{\"lo\":\"1/20\",\"hi\":\"1/20\"},\"heights\":{"
            "\"lo\":\"3/5\",\"hi\":\"9/10\"},\"margin\":\"1/2\",\"exponent\":null,\"bounds\":[\"20/1\"],"
            "\"attained\":[{\"u\":\"63/125\",\"s\":\"97/100\",\"delta\":\"1/20\",\"collisions\":10,"
            "\"value\":\"93/10\",\"ratio\":\"2.150538\"}]}"));
    const Run root = run("--explain class0.0 " + file.path());
    CHECK(run("--explain box " + file.path()).code == 2);
    CHECK(root.code == 2);  // no leaf, but a split
    const Run state = run("--explain attained1 " + file.path());
    CHECK(state.code == 0);
    CHECK(has(state, ": attained 63/125 97/100 1/20 10 93/10\n"));
    CHECK(has(state, "the value is attained: holds"));
    CHECK(has(state, "  certified\n"));
    const Run leaf = run("--explain box.1 " + file.path());
    CHECK(has(leaf,
              "  u in [1/1, 2/1]\n  s in [0/1, 1/1]\n  v in [0/1, 2/1]\n  delta in [1/20, 1/20]\n"
              "  sigma in [0/1, 0/1]\n"));
    CHECK(has(leaf, "u beyond pi/2"));
}
