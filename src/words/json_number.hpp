#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "number/interval.hpp"
#include "number/rational.hpp"

namespace dumbbell {

/// x as it is printed: 0 has no sign, whatever the arithmetic gave it.
[[nodiscard]] constexpr double unsigned_zero(double x) { return x == 0 ? 0.0 : x; }

/// An object as `--json` prints it: ASCII alone, whatever bytes a name in it has.
[[nodiscard]] inline std::string json_text(const nlohmann::ordered_json& json) {
    return json.dump(2, ' ', true, nlohmann::ordered_json::error_handler_t::replace) + '\n';
}

/// The ends of an enclosure, exactly, as a pair of numbers.
[[nodiscard]] inline nlohmann::ordered_json ends_json(const Interval& x) {
    return {unsigned_zero(x.lo()), unsigned_zero(x.hi())};
}

/// Null for what is not known.
template <class T>
[[nodiscard]] nlohmann::ordered_json json_or_null(const std::optional<T>& x) {
    return x ? nlohmann::ordered_json(*x) : nlohmann::ordered_json(nullptr);
}

/// What an undecided share leaves, as a number that does not exceed it: 1 only if that is all.
[[nodiscard]] inline double decided_fraction(const Rational& undecided) {
    return undecided == 0 ? 1.0 : enclose<Interval>(Rational(1) - undecided).lo();
}

}  // namespace dumbbell
