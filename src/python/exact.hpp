#pragma once

#include <pybind11/stl.h>

#include <concepts>
#include <dumbbell/interval.hpp>
#include <dumbbell/mass_ratio.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What goes between Python and the library: numbers exactly, as text.
namespace dumbbell::python {

// What a function may be given: `how` is the function of _given.py that takes it, or raises InputError.

/// `9/2`, or of a pair `1:100`.
struct Number {
    static constexpr auto name = pybind11::detail::const_name("Ratio");
    static constexpr const char* how = "number";
    std::string value;
};
struct Numbers {
    static constexpr auto name = pybind11::detail::const_name("Iterable[Ratio]");
    static constexpr const char* how = "numbers";
    std::vector<std::string> value;
};
struct Whole {
    static constexpr auto name = pybind11::detail::const_name("int");
    static constexpr const char* how = "whole";
    long value;

    /// The nearest number of the type.
    template <std::integral T>
    operator T() const {
        return std::in_range<T>(value) ? static_cast<T>(value)
               : value < 0             ? std::numeric_limits<T>::min()
                                       : std::numeric_limits<T>::max();
    }
};
struct Seconds {
    static constexpr auto name = pybind11::detail::const_name("float");
    static constexpr const char* how = "seconds";
    double value;
};
struct Word {
    static constexpr auto name = pybind11::detail::const_name("str");
    static constexpr const char* how = "word";
    std::string value;
};
/// The bytes of a name of a file.
struct Path {
    static constexpr auto name = pybind11::detail::const_name("Path");
    static constexpr const char* how = "path";
    std::string value;
};
/// The bytes of a certificate, given as they are or by the name of their file.
struct Content {
    static constexpr auto name = pybind11::detail::const_name("Union[bytes, Path]");
    static constexpr const char* how = "content";
    std::string value;
};
using Budget = std::optional<Seconds>;

template <class T>
concept Given = std::same_as<decltype(T::how), const char* const>;

/// What text such as `9/2` or a decimal says, as Fraction, Decimal or int.
[[nodiscard]] pybind11::object fraction(const std::string& text);
[[nodiscard]] pybind11::object decimal(const std::string& text);
[[nodiscard]] pybind11::object whole(const std::string& digits);

}  // namespace dumbbell::python

namespace pybind11::detail {

template <dumbbell::python::Given T>
class type_caster<T> {
    PYBIND11_TYPE_CASTER(T, T::name);
    bool load(handle given, bool) {
        value.value =
            module_::import("dumbbell._given").attr(T::how)(given).template cast<decltype(T::value)>();
        return true;
    }
};

/// An enclosure is the pair of its ends.
template <>
class type_caster<dumbbell::api::Interval> {
    PYBIND11_TYPE_CASTER(dumbbell::api::Interval, const_name("Tuple[float, float]"));
    bool load(handle given, bool) {
        std::tie(value.lo, value.hi) = given.cast<std::pair<double, double>>();
        return true;
    }
    static handle cast(const dumbbell::api::Interval& x, return_value_policy, handle) {
        return make_tuple(x.lo, x.hi).release();
    }
};

}  // namespace pybind11::detail
