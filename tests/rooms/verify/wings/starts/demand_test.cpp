// A demanded part of a box of starts: what its leaves say of it, and what is missing.
#include "verify/wings/starts/demand.hpp"

#include <functional>
#include <random>

#include "catch.hpp"
#include "make_file.hpp"
#include "rooms/verify/program/run_program.hpp"

namespace starts = dumbbell_verify::starts;
using make::falling;
using make::File;
using make::has;
using make::run;

TEST_CASE("the shares of the leaves in a part of the box are those of a partition, also of points") {
    std::mt19937 random(58);
    const auto number = [&](unsigned below) { return mpq_class(static_cast<unsigned>(random() % below)); };
    for (int i = 0; i < 300; ++i) {
        const starts::Box file{{0, 0, 0, 0, 1}, {8, 8, 8, 8, 9}};
        starts::Box asked;
        for (std::size_t k = 0; k < 5; ++k) {
            const mpq_class a = file.lo[k] + number(25) / 3, b = file.lo[k] + number(9);
            const bool is_point = random() % 2 == 0;
            asked.lo[k] = is_point ? b : std::min(a, b), asked.hi[k] = is_point ? b : std::max(a, b);
        }
        mpq_class sum;
        const std::function<void(const starts::Box&, int)> add = [&](const starts::Box& box, int depth) {
            const mpq_class share = share_in(box, asked, file);
            const std::size_t k = random() % 5;
            if (depth == 0 || box.hi[k] - box.lo[k] < 2) {
                sum += share;
                return;
            }
            starts::Box lower = box, upper = box;
            lower.hi[k] = upper.lo[k] = (box.lo[k] + box.hi[k]) / 2;
            CHECK((share == share_in(lower, asked, file) + share_in(upper, asked, file)));
            add(lower, depth - 1);
            add(upper, depth - 1);
        };
        add(file, 9);
        CHECK((sum == 1));
    }
}

TEST_CASE("initial conditions: a part of the box has the bounds and the share of its own leaves") {
    const File file(falling());  // exactly 1 for phi >= 1/2, 5 of 8 leaves below are known
    const auto code = [&](const std::string& options) {
        return run("--claim initial-conditions " + options + " " + file.path()).code;
    };
    CHECK(code("--phi -1:1 --phidot 1/100 --y 1.5 --ydot -1 --decided 25/32 --ratio 10 --max 5 --min 1") ==
          0);
    CHECK(code("--decided 0.78125000001") == 1);
    CHECK(code("--phi 1/2:1 --exactly 1") == 0);
    CHECK(code("--phi 0.75:1 --decided 1") == 0);
    CHECK(code("--phi 0.499999:1 --exactly 1") == 1);
    CHECK(code("--phi 1/4:3/4 --decided 3/4 --max 2") == 0);  // half of it is above 1/2
    CHECK(code("--phi 1/2 --exactly 1") == 0);                // a point belongs to the upper leaf
    CHECK(code("--phi 1 --exactly 1") == 0);                  // but at the end
    CHECK(code("--phi -1 --decided 1") == 1);
    for (const char* outside : {"--phi -1.001:1", "--phi 1:1.001", "--phidot 0:0.01", "--y 1.6", "--ydot 1"})
        CHECK(code(outside) == 1);
    const std::string part =
        run("--claim initial-conditions --phi 1/2:1 --min 1 --ratio 10 " + file.path()).out;
    CHECK(has(part,
              "  Proved: for every start in the demanded part of the box the dumbbell hits the floor 1 "
              "time.\n  Not demanded: phidot, y, ydot, max, decided.\n"));
    CHECK(
        part.ends_with(" demanded-ratio=10/1:10/1 min=1 demanded-claim=initial-conditions "
                       "demanded-phi=1/2:1/1 not-demanded=phidot,y,ydot,max,decided\n"));
    const std::string whole = run("--claim initial-conditions --phi 0.5:1 --phidot 1e-2 --y 3/2 --ydot -1 "
                                  "--ratio 10 --exactly 1 " +
                                  file.path())
                                  .out;
    CHECK(
        whole.ends_with(" demanded-phi=1/2:1/1 demanded-phidot=1/100:1/100 demanded-y=3/2:3/2 "
                        "demanded-ydot=-1/1:-1/1\n"));
    CHECK(run("--scene dumbbell " + file.path())
              .last()
              .ends_with(" not-demanded=phi,phidot,y,ydot,ratio,max,min,decided"));
    CHECK_FALSE(has(run(file.path()).last(), "not-demanded"));
    const File open(
        make::closed(make::initial_header("10/1 10/1", "0/1 1/1", "1/1 1/1", "2/1 2/1", "-1/1 -1/1") +
                     "between 0 none\nsplit phi\nopen\nbetween 1 99\n"));
    CHECK(run("--claim initial-conditions --phi 0:1/2 " + open.path()).code == 3);
    CHECK(run("--claim initial-conditions --phi 1/2:1 --min 1 --max 99 " + open.path()).code == 0);
    CHECK(run("--claim initial-conditions --phi 0.4:1 --min 1 " + open.path()).code == 1);
}

TEST_CASE("options that do not fit the kind of claim, or are no numbers, are wrong usage in any order") {
    for (const auto& [options, message] : std::vector<std::pair<std::string, std::string>>{
             {"--phi 1 --claim incoming", "--phi is for --claim initial-conditions\n"},
             {"--decided 1 --claim law",
              "--decided is for --claim collisions (of bodies), initial-conditions or "},
             {"--max 1 --claim adiabatic-run", "--max is for --claim collisions, "},
             {"--exponent 1/2 --claim adiabatic-run", "--exponent is for --claim adiabatic-bounce\n"},
             {"--claim adiabatic-scattering --heights 0:1", "--heights is for --claim adiabatic-bounce or "},
             {"--constant 1,2 --claim adiabatic-run", "is for --claim adiabatic-bounce where it has two"},
             {"--delta 1 --claim collisions", "--delta is for --claim adiabatic-bounce, "},
             {"--claim initial-conditions --phi 2:1", "LO:HI needs LO <= HI: 2:1\n"},
             {"--claim initial-conditions --phi 1/0", "not a number: `1/0`\n"},
             {"--claim initial-conditions --phi 1:", "not a number: ``\n"},
             {"--claim initial-conditions --phi 1 --phi 2", "--phi is given twice\n"},
             {"--claim initial-conditions --decided 1.1", "--decided is a share from 0 to 1, not 1.1\n"},
         }) {
        const make::Run said = run(options + " no.dbc");
        INFO(options << ": " << said.err);
        CHECK(said.code == 2);
        CHECK(has(said.err, message));
    }
}
