#pragma once

#include <pybind11/stl.h>

#include <algorithm>
#include <array>
#include <concepts>
#include <dumbbell/certify.hpp>
#include <dumbbell/error.hpp>
#include <dumbbell/verify.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

/// What goes between Python and the library: numbers exactly, as text.
namespace dumbbell::python {

/// A name as an argument of a template.
template <std::size_t size>
struct Text {
    char letters[size];
    consteval Text(const char (&text)[size]) { std::ranges::copy(text, letters); }
};

/// What a function may be given, which its signature calls `name`: the function `how` of _given.py takes it,
/// or raises InputError.
template <class T, Text how, Text name>
struct Given {
    T value;

    /// The nearest number of the type.
    template <std::integral To>
    requires std::integral<T>
    operator To() const {
        return std::in_range<To>(value) ? static_cast<To>(value)
               : value < 0              ? std::numeric_limits<To>::min()
                                        : std::numeric_limits<To>::max();
    }
};
using Number = Given<std::string, "number", "Ratio">;  ///< `9/2`, or of a pair `1:100`
using Numbers = Given<std::vector<std::string>, "numbers", "Iterable[Ratio]">;
using Whole = Given<long, "whole", "int">;
using Seconds = Given<double, "seconds", "float">;
using Truth = Given<bool, "truth", "bool">;
using Path = Given<std::string, "path", "Path">;  ///< the bytes of a name of a file
/// The bytes of a certificate, given as they are or by the name of their file.
using Content = Given<std::string, "content", "Union[bytes, Path]">;
using Budget = std::optional<Seconds>;

/// What the function of _given.py of that name makes of it.
template <class T, class... Given>
T taken(const char* how, const Given&... given) {
    return pybind11::module_::import("dumbbell._given").attr(how)(given...).template cast<T>();
}

/// The values of an enumeration that have a word in Python, in their order.
template <class Value>
inline constexpr std::array<const char*, 0> words{};
template <>
inline constexpr std::array words<api::Verdict>{"verified",   "rejected", "unsupported",
                                                "unreadable", "limit",    "open"};
static_assert(words<api::Verdict>.size() == std::size_t(api::Verdict::open) + 1);
template <>
inline constexpr std::array words<api::Scene>{"dumbbell", "body"};
static_assert(words<api::Scene>.size() == std::size_t(api::Scene::body) + 1);
template <>
inline constexpr std::array words<api::Section>{"turning", "full", "plain"};
static_assert(words<api::Section>.size() == std::size_t(api::Section::plain) + 1);

/// What text such as `9/2` or a decimal says, as Fraction or Decimal.
inline pybind11::object fraction(const std::string& text) {
    return pybind11::module_::import("fractions").attr("Fraction")(text);
}
inline pybind11::object decimal(const std::string& text) {
    return pybind11::module_::import("decimal").attr("Decimal")(text);
}

}  // namespace dumbbell::python

namespace pybind11::detail {

template <class T, dumbbell::python::Text how, dumbbell::python::Text name_of_it>
class type_caster<dumbbell::python::Given<T, how, name_of_it>> {
    using Taken = dumbbell::python::Given<T, how, name_of_it>;
    PYBIND11_TYPE_CASTER(Taken, const_name(name_of_it.letters));
    bool load(handle given, bool) {
        value.value = dumbbell::python::taken<T>(how.letters, given);
        return true;
    }
};

template <class Value>
requires(!dumbbell::python::words<Value>.empty()) class type_caster<Value> {
    PYBIND11_TYPE_CASTER(Value, const_name("str"));
    bool load(handle given, bool) {
        value =
            static_cast<Value>(dumbbell::python::taken<int>("place", given, dumbbell::python::words<Value>));
        return true;
    }
    static handle cast(Value value, return_value_policy, handle) {
        return str(dumbbell::python::words<Value>.at(static_cast<std::size_t>(value))).release();
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
