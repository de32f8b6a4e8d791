#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "campaign/kinds/kinds.hpp"
#include "file/file_contents.hpp"
#include "file/sealed_lines.hpp"
#include "number/count_argument.hpp"
#include "number/decimal.hpp"
#include "staircase/critical_report.hpp"

namespace dumbbell::campaign {

using collisions::CriticalRatio;

namespace {

constexpr std::string_view first_line = "dumbbell-critical-rows 1";

std::string head_of(int digits) { return fmt::format("prove critical\ndigits {}\n", digits); }

std::string claim_of(long first, long last, int digits) {
    return fmt::format("critical {}:{} --digits {}", first, last, digits);
}

int digits_of(const Order& order) {
    const std::size_t digits = parse_size(head_values(order, {"prove", "digits"})[1]);
    if (digits < 1 || digits > collisions::most_critical_digits ||
        order.head != head_of(static_cast<int>(digits))) {
        throw InputError("the order asks for digits that this program does not give");
    }
    return static_cast<int>(digits);
}

long parse_count(const std::string& unit) {
    const auto fields = split(unit, ' ');
    const std::size_t n = fields.size() == 2 && fields[0] == "ratio" ? parse_size(fields[1]) : 0;
    if (n < 3 || n > std::size_t{greatest_count}) {
        throw InputError("the order has a critical ratio that is none");
    }
    return static_cast<long>(n);
}

std::string render(const std::vector<CriticalRatio>& ratios) {
    SealedLines out;
    out.line("{}", first_line);
    for (const CriticalRatio& ratio : ratios) {
        out.line("ratio {} {} {} {}", ratio.n, to_fraction(ratio.q_lo), to_fraction(ratio.q_hi), ratio.bits);
    }
    return std::move(out).sealed().text;
}

CriticalRatio parse_ratio(SealedReader& in) {
    constexpr std::size_t most_bits = 16384;
    constexpr std::size_t longest = 20'000;  // digits of a fraction with this many binary places, and more
    const auto fields = split(in.value("ratio"), ' ');
    if (fields.size() != 4) {
        in.fail();
    }
    const CriticalRatio ratio{static_cast<long>(parse_size(fields[0])), parse_rational(fields[1], longest),
                              parse_rational(fields[2], longest), static_cast<int>(parse_size(fields[3]))};
    if (ratio.q_lo < 1 || ratio.q_lo > ratio.q_hi || ratio.bits < 53 ||
        ratio.bits > static_cast<int>(most_bits)) {
        in.fail();
    }
    return ratio;
}

/// Of a file with at most `most` of them.
std::vector<CriticalRatio> read_rows(const std::string& file, std::size_t most) {
    const std::string text = file_contents(file);
    SealedReader in(text, "a table of critical ratios");
    if (in.line() != first_line) {
        in.fail();
    }
    std::vector<CriticalRatio> ratios;
    while (!in.ahead().empty()) {
        if (ratios.size() == most) {
            in.fail();
        }
        ratios.push_back(parse_ratio(in));
    }
    in.end();
    return ratios;
}

/// Empty if these are the ratios of the order, with its digits.
std::string objection(const Order& order, const std::vector<CriticalRatio>& ratios) {
    const int digits = digits_of(order);
    const bool fits =
        std::equal(ratios.begin(), ratios.end(), order.units.begin(), order.units.end(),
                   [](const CriticalRatio& r, const std::string& unit) { return r.n == parse_count(unit); });
    if (!fits) {
        return "it has other ratios";
    }
    for (const CriticalRatio& ratio : ratios) {
        if (!shared_digits(ratio.q_lo, ratio.q_hi, digits)) {
            return fmt::format("q_c({}) has fewer digits", ratio.n);
        }
    }
    return "";
}

class CriticalKind : public Kind {
  public:
    [[nodiscard]] Evidence evidence() const override { return Evidence::results; }

    [[nodiscard]] std::optional<std::string> work(const Order& order, const std::string& /*folder*/,
                                                  const Interrupted& interrupted) const override {
        const collisions::CriticalOptions options{.digits = digits_of(order), .interrupted = interrupted};
        std::vector<CriticalRatio> ratios;
        for (const std::string& unit : order.units) {
            const long n = parse_count(unit);
            auto ratio = enclose_critical_ratio(n, options);
            if (!ratio && !interrupted()) {
                throw InputError(fmt::format("q_c({}) could not be enclosed", n));
            }
            if (!ratio) {
                return std::nullopt;
            }
            ratios.push_back(std::move(*ratio));
        }
        return render(ratios);
    }

    [[nodiscard]] Merged merge(const Plan& plan, const std::string& /*folder*/,
                               const std::vector<std::string>& files) const override {
        staircase::CriticalReport report;
        report.request.digits = digits_of(plan.whole);
        for (const std::string& file : files) {
            for (CriticalRatio& ratio : read_rows(file, plan.whole.units.size())) {
                const long n = ratio.n;
                report.rows.push_back({n, std::move(ratio), {}});
            }
        }
        const auto& units = plan.whole.units;
        const bool tiles = std::equal(report.rows.begin(), report.rows.end(), units.begin(), units.end(),
                                      [](const staircase::CriticalRow& row, const std::string& unit) {
                                          return row.n == parse_count(unit);
                                      });
        require_tiling(tiles);
        report.request.first = report.rows.front().n;
        report.request.last = report.rows.back().n;
        require_tiling(plan.claim ==
                       claim_of(report.request.first, report.request.last, report.request.digits));
        return {to_tsv(report), false};
    }

  private:
    [[nodiscard]] Judgement form(const Order& order, const std::string& file) const override {
        const std::string reason = objection(order, read_rows(file, order.units.size()));
        return {reason.empty() ? Judgement::Verdict::proved : Judgement::Verdict::wrong, reason};
    }

    [[nodiscard]] std::string refutation(const Order& order, const std::string& /*folder*/,
                                         const std::string& file) const override {
        for (const CriticalRatio& ratio : read_rows(file, order.units.size())) {
            if (!certainly_encloses(ratio)) {
                return fmt::format("q_c({}) is not certain to be where it says", ratio.n);
            }
        }
        return "";
    }
};

}  // namespace

const Kind& critical_kind() {
    static const CriticalKind kind;
    return kind;
}

Plan plan_critical(const staircase::CriticalRequest& request, std::optional<std::size_t> shards) {
    if (request.first == request.last) {
        throw InputError(
            "a single critical ratio is one shard: use dumbbell critical, or give a range N1:N2");
    }
    constexpr std::size_t flights_per_shard = 200'000;  // some seconds at 30 digits
    Plan plan{claim_of(request.first, request.last, request.digits), {head_of(request.digits), {}}, {}, {}};
    std::vector<std::size_t> costs;
    for (long n = request.first; n <= request.last; ++n) {
        plan.whole.units.push_back(fmt::format("ratio {}", n));
        costs.push_back(static_cast<std::size_t>(n));
    }
    plan.shards = cut(costs, shards, flights_per_shard);
    return plan;
}

}  // namespace dumbbell::campaign
