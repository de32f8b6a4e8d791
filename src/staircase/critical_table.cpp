#include "staircase/critical_table.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "file/unpacked_text.hpp"
#include "number/count_argument.hpp"
#include "number/decimal.hpp"
#include "number/parallel.hpp"

namespace dumbbell::staircase {
namespace {

constexpr std::string_view first_words = "# Critical mass ratios";

/// The significant digits of a number as it is printed.
int digits_in(std::string_view number) {
    const std::string_view mantissa = number.substr(0, number.find('e'));
    return static_cast<int>(std::ranges::count_if(mantissa, [](char c) { return c >= '0' && c <= '9'; }));
}

/// The enclosure that a row states: of the numbers with these digits those that are no more than the radius
/// above. (A radius of a whole unit of the last digit was rounded up to that: the digits end before it.)
/// Nothing if the digits are none.
std::optional<collisions::CriticalRatio> stated(long n, std::string_view digits, std::string_view radius,
                                                int bits) {
    static const Rational nearly_one = 1 - parse_rational("1e-30");
    constexpr std::size_t longest = collisions::most_critical_digits + 10;
    const Rational q_lo = parse_rational(digits, longest);
    const int shown = digits_in(digits);
    if (q_lo < 1 || shown > collisions::most_critical_digits) {
        return std::nullopt;
    }
    const Decimal value = cut_down(q_lo, shown);
    const Rational unit = exact(Decimal{1, value.exponent});
    return exact(value) != q_lo
               ? std::nullopt
               : std::optional(collisions::CriticalRatio{
                     n, q_lo, q_lo + std::min(parse_rational(radius), unit * nearly_one), bits});
}

/// Nothing if it is none. Numbers may be spelled in other ways than a table spells them.
std::optional<CriticalRow> row_from(std::string_view line) try {
    const auto fields = split(line, '\t');
    const auto n = number_of<long>(fields.front());
    if (fields.size() != 6 || !n || *n < 3 || *n > greatest_count) {
        return std::nullopt;
    }
    if (fields[1] == "open") {
        return CriticalRow{*n, {}};
    }
    const auto bits = number_of<int>(fields[3]);
    if (!bits || *bits < 53 || *bits > collisions::most_critical_bits) {
        return std::nullopt;
    }
    const auto ratio = stated(*n, fields[1], fields[2], *bits);
    const bool fits = ratio && (*n > 3 || (ratio->q_lo == 1 && ratio->q_hi == 1));
    return fits ? std::optional(CriticalRow{*n, ratio}) : std::nullopt;
} catch (const InputError&) {
    return std::nullopt;
}

[[noreturn]] void fail(const std::string& path, long line) {
    throw InputError(fmt::format(
        "'{}' is not a table of critical ratios as dumbbell critical --out writes it (line {})", path, line));
}

}  // namespace

bool is_critical_table(const std::string& path) try {
    return UnpackedText(path).next_line().starts_with(first_words);
} catch (const InputError&) {
    return false;
}

CriticalReport read_critical_table(const std::string& path) {
    UnpackedText lines(path);
    CriticalReport table;
    int digits = 0;  // of all rows but that of q_c(3) = 1, which has one
    std::string text;
    long number = 0;
    for (std::string_view line = lines.next_line(); !line.empty(); line = lines.next_line()) {
        ++number;
        text += line;
        if (line.starts_with('#')) {
            continue;
        }
        const auto row = line.ends_with('\n') ? row_from(line.substr(0, line.size() - 1)) : std::nullopt;
        if (!row || (!table.rows.empty() && row->n != table.rows.back().n + 1)) {
            fail(path, number);
        }
        if (row->ratio && row->n > 3) {
            const int shown = digits_in(split(line, '\t')[1]);
            digits = digits == 0 ? shown : digits;
            if (shown != digits) {
                fail(path, number);
            }
        }
        table.rows.push_back(*row);
    }
    if (table.rows.empty()) {
        fail(path, number + 1);
    }
    table.request.first = table.rows.front().n;
    table.request.last = table.rows.back().n;
    table.request.digits = std::max(digits, 1);
    const std::string right = to_tsv(table);
    table.request.digits = digits;
    const auto [ours, its] = std::ranges::mismatch(right, text);
    if (ours != right.end() || its != text.end()) {
        fail(path, 1 + std::count(text.cbegin(), std::string::const_iterator(its), '\n'));
    }
    return table;
}

std::string objection(const CriticalReport& table, const Interrupted& interrupted) {
    std::vector<char> certain(table.rows.size());
    in_parallel(table.rows.size(), [&](std::size_t i) {
        const auto& ratio = table.rows[i].ratio;
        certain[i] = !ratio || certainly_encloses(*ratio, interrupted) ? 1 : 0;
    });
    const auto doubtful = std::ranges::find(certain, 0);
    return doubtful == certain.end()
               ? ""
               : fmt::format("q_c({}) is not certain to lie where it says",
                             table.rows[static_cast<std::size_t>(doubtful - certain.begin())].n);
}

}  // namespace dumbbell::staircase
