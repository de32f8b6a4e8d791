#pragma once

#include <pybind11/pybind11.h>

#include <dumbbell/interval.hpp>
#include <dumbbell/mass_ratio.hpp>
#include <optional>
#include <string>

/// Numbers between Python and the library, exactly: as text.
namespace dumbbell::python {

/// What is text already, as it stands; a pair (lo, hi) as `lo:hi`; an int, a Fraction, a Decimal, a float and
/// numpy's numbers as the fraction that they are. Throws TypeError for anything else.
[[nodiscard]] std::string exact_text(const pybind11::handle& number);

/// What text such as `9/2` or a decimal says, as Fraction, Decimal or int.
[[nodiscard]] pybind11::object fraction(const std::string& text);
[[nodiscard]] pybind11::object decimal(const std::string& text);
[[nodiscard]] pybind11::object whole(const std::string& digits);

[[nodiscard]] inline api::MassRatio mass_ratio(const pybind11::handle& q) {
    return api::MassRatio(exact_text(q));
}

/// An enclosure as the pair of its ends.
[[nodiscard]] inline pybind11::tuple pair(const api::Interval& x) { return pybind11::make_tuple(x.lo, x.hi); }

}  // namespace dumbbell::python
