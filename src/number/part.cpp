#include "number/part.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>

#include "base/error.hpp"
#include "base/fields.hpp"
#include "number/rational.hpp"

namespace dumbbell {
namespace {

constexpr long most_parts = 1'000'000;

/// Twice what the steps before x cost.
Integer work_before(const Integer& x, const Steps& steps) { return x * (x + 2 * steps.fixed); }

/// Where so many of all parts end.
Integer end_of(long parts, long of, const Steps& steps) {
    const Integer begin = work_before(steps.first, steps), all = work_before(steps.end, steps) - begin;
    return sqrt(Integer(steps.fixed) * steps.fixed + begin + all * parts / of) - steps.fixed;
}

}  // namespace

Part parse_part(const std::string& text) {
    const std::size_t slash = text.find('/');
    const auto number = number_of<long>(std::string_view(text).substr(0, slash));
    const auto of =
        slash == std::string::npos ? std::nullopt : number_of<long>(std::string_view(text).substr(slash + 1));
    if (!number || !of || *number < 1 || *number > *of || *of > most_parts) {
        throw InputError(fmt::format(
            "--part '{}' is not a part: write K/N, 1 <= K <= N <= 10^6, for example 7/64", shortened(text)));
    }
    return {*number, *of};
}

Integer sqrt(const Integer& x) {
    Integer root;
    mpz_sqrt(root.raw(), x.raw());
    return root;
}

std::pair<Integer, Integer> steps_of(const Part& part, const Steps& steps) {
    // The last step costs most.
    const Integer all = work_before(steps.end, steps) - work_before(steps.first, steps);
    const Integer last = work_before(steps.end, steps) - work_before(steps.end - 1, steps);
    const Integer most = std::max(all / last, Integer(1));
    if (part.of > most) {
        throw InputError(fmt::format(
            "--part: the range has too few steps for {} parts: cut it into at most {}", part.of, most.str()));
    }
    return {end_of(part.number - 1, part.of, steps), end_of(part.number, part.of, steps)};
}

}  // namespace dumbbell
