// The public IEEE 1788 vectors: itf1788.tsv. They are data under other licences: itf1788.md.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "attacks/interval/layers.hpp"
#include "catch.hpp"
#include "tightest.hpp"

using namespace dumbbell;
using namespace dumbbell_test;

namespace {

/// An argument or an expected result: an interval, which `empty` says is none, or an integer.
struct Operand {
    Interval set;
    bool empty = false;
    int integer = 0;
};

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream stream(text);
    for (std::string part; std::getline(stream, part, separator);) {
        parts.push_back(part);
    }
    return parts;
}

Operand parse(const std::string& text) {
    if (text == "entire") {
        return {Interval(-HUGE_VAL, HUGE_VAL)};
    }
    if (text == "empty") {
        return {Interval(0), true};
    }
    if (text.starts_with("i:")) {
        return {Interval(0), false, std::stoi(text.substr(2))};
    }
    const auto ends = split(text, ',');
    REQUIRE(ends.size() == 2);
    return {Interval(std::strtod(ends[0].c_str(), nullptr), std::strtod(ends[1].c_str(), nullptr))};
}

/// The operations of a layer, and some that are put together of them, on arguments that are not empty.
template <class L>
class Operations {
  public:
    using I = typename L::I;
    using Arguments = std::vector<Operand>;
    using Operation = std::function<I(const std::vector<I>&, int)>;

    static const std::map<std::string, Operation>& all() {
        static const std::map<std::string, Operation> table = make();
        return table;
    }
    static bool is_composed(const std::string& name) {
        return name == "fma" || name == "pown" || name == "tan" || name == "acos";
    }

  private:
    static I power(const I& x, int n) {
        if (n < 0) {
            return I(1) / power(x, -n);
        }
        if (n <= 1) {
            return n == 0 ? I(1) : x;
        }
        const I root = power(x, n / 2);
        return n % 2 == 0 ? L::square(root) : L::square(root) * x;
    }
    static std::map<std::string, Operation> make() {
        using X = const std::vector<I>&;
        std::map<std::string, Operation> table = {
            {"add", [](X x, int) { return x.at(0) + x.at(1); }},
            {"sub", [](X x, int) { return x.at(0) - x.at(1); }},
            {"mul", [](X x, int) { return x.at(0) * x.at(1); }},
            {"div", [](X x, int) { return x.at(0) / x.at(1); }},
            {"recip", [](X x, int) { return I(1) / x.at(0); }},
            {"neg", [](X x, int) { return -x.at(0); }},
            {"sqr", [](X x, int) { return L::square(x.at(0)); }},
            {"fma", [](X x, int) { return x.at(0) * x.at(1) + x.at(2); }},
            {"pown", [](X x, int n) { return power(x.at(0), n); }},
            {"convexHull", [](X x, int) { return L::join(x.at(0), x.at(1)); }},
            {"sin", [](X x, int) { return L::sine(x.at(0)); }},
            {"cos", [](X x, int) { return L::cosine(x.at(0)); }},
            {"tan", [](X x, int) { return L::sine(x.at(0)) / L::cosine(x.at(0)); }}};
        if constexpr (L::has_roots) {
            table["sqrt"] = [](X x, int) { return sqrt(x.at(0)); };
            table["min"] = [](X x, int) { return min(x.at(0), x.at(1)); };
            table["max"] = [](X x, int) { return max(x.at(0), x.at(1)); };
            table["asin"] = [](X x, int) { return asin(x.at(0)); };
            table["acos"] = [](X x, int) { return half_pi<I>() - asin(x.at(0)); };
        }
        if constexpr (std::is_same_v<L, ProgramDouble>) {
            table["abs"] = [](X x, int) { return abs(x.at(0)); };
        }
        return table;
    }
};

/// The results of one operation, by the excess in doubles of the worse end.
struct Tally {
    int rows = 0;
    int empty = 0;  ///< empty in or out: outside the domain that the layers document, and held by anything
    int failures = 0;
    std::array<int, 5> by_excess{};  ///< 0, 1, 2 to 16, more, unbounded
    std::int64_t greatest = 0;       ///< that is bounded

    void add(const Interval& ours, const Tightest& exact) {
        const std::int64_t ulps = excess(ours, exact);
        const bool unbounded = ulps > 1 && ((std::isinf(ours.lo()) && !std::isinf(exact.lo)) ||
                                            (std::isinf(ours.hi()) && !std::isinf(exact.hi)));
        ++by_excess.at(unbounded ? 4 : ulps == 0 ? 0 : ulps == 1 ? 1 : ulps <= 16 ? 2 : 3);
        if (!unbounded) {
            greatest = std::max(greatest, ulps);
        }
    }
};

template <class L>
Interval seen(const typename L::I& x) {
    Mpfr lo(L::bits(), 0);
    Mpfr hi(L::bits(), 0);
    L::low(lo, x);
    L::high(hi, x);
    return {mpfr_get_d(lo, MPFR_RNDD), mpfr_get_d(hi, MPFR_RNDU)};
}

/// The tally of one row of the table; nothing if the layer does not have its operation.
template <class L>
void test_row(const std::string& line, std::map<std::string, Tally>& tallies,
              std::map<std::string, int>& absent) {
    const auto fields = split(line, '\t');
    REQUIRE(fields.size() >= 3);
    const auto operation = Operations<L>::all().find(fields[0]);
    if (operation == Operations<L>::all().end()) {
        ++absent[fields[0]];
        return;
    }
    Tally& tally = tallies[fields[0]];
    ++tally.rows;
    const Operand expected = parse(fields[2]);
    bool empty = expected.empty;
    std::vector<typename L::I> arguments;
    int integer = 0;
    for (const auto& argument : split(fields[1], ';')) {
        const Operand operand = parse(argument);
        empty = empty || operand.empty;
        integer = operand.integer;
        arguments.push_back(L::make(Mpfr(operand.set.lo()), Mpfr(operand.set.hi())));
    }
    if (empty) {
        ++tally.empty;
        return;
    }
    const Interval ours = seen<L>(operation->second(arguments, integer));
    const Tightest exact{expected.set.lo(), expected.set.hi()};
    if (!encloses(ours, exact)) {
        ++tally.failures;
        FAIL_CHECK(L::name << ": " << line << " gives " << show(ours));
        return;
    }
    tally.add(ours, exact);
}

/// What a layer promises where its results are finite, in doubles: 0, 1, or nothing.
template <class L>
bool keeps_its_promise(const std::string& operation, const Tally& tally) {
    const auto& n = tally.by_excess;
    const bool exact = operation == "neg" || operation == "abs" || operation == "min" || operation == "max" ||
                       operation == "convexHull";
    const bool near = L::has_roots && (operation == "add" || operation == "sub" || operation == "mul" ||
                                       operation == "recip" || operation == "sqr" || operation == "sqrt");
    const int loose = n[2] + n[3] + (operation == "recip" ? 0 : n[4]);
    return exact ? n[1] + loose == 0 : !near || loose == 0;
}

}  // namespace

TEMPLATE_TEST_CASE("Every result of the IEEE 1788 vectors is enclosed", "", ProgramDouble, ProgramBig,
                   VerifierDouble, VerifierBig) {
    using L = TestType;
    std::ifstream table(DUMBBELL_CONFORMANCE);
    REQUIRE(table);
    std::map<std::string, Tally> tallies;
    std::map<std::string, int> absent;
    const WorkingBits scope(53);
    for (std::string line; std::getline(table, line);) {
        if (!line.starts_with('#')) {
            test_row<L>(line, tallies, absent);
        }
    }
    std::printf("%-18s %-10s %5s %5s %8s %8s %6s %8s %6s %9s %8s\n", "layer", "operation", "rows", "empty",
                "failures", "excess 0", "1 ulp", "2 to 16", "more", "unbounded", "greatest");
    int tested = 0;
    for (const auto& [name, tally] : tallies) {
        const auto& n = tally.by_excess;
        std::printf("%-18s %-10s %5d %5d %8d %8d %6d %8d %6d %9d %8.3g\n", L::name, name.c_str(), tally.rows,
                    tally.empty, tally.failures, n[0], n[1], n[2], n[3], n[4],
                    static_cast<double>(tally.greatest));
        CAPTURE(name);
        CHECK(tally.rows > tally.empty);
        CHECK((Operations<L>::is_composed(name) || keeps_its_promise<L>(name, tally)));
        tested += tally.rows - tally.empty;
    }
    std::printf("%s: %d vectors tested; operations that it does not have:", L::name, tested);
    for (const auto& [name, rows] : absent) {
        std::printf(" %s (%d)", name.c_str(), rows);
    }
    std::printf("\n");
    CHECK(tallies.size() == Operations<L>::all().size());
}
