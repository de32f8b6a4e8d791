#pragma once

#include <fmt/core.h>

#include <compare>
#include <concepts>
#include <iosfwd>
#include <string>
#include <utility>

#include "number/integer.hpp"

namespace dumbbell {

/// A number of collisions, of any size. Where only those are meant that are followed one by one, listed or
/// drawn it becomes a long by itself; InputError if it does not fit.
class Count {
  public:
    Count() = default;
    template <std::integral T>
    Count(T value) : value_(value) {}  // NOLINT(google-explicit-constructor): no value is lost
    explicit Count(Integer value) : value_(std::move(value)) {}
    /// Towards zero. Precondition: it is finite.
    explicit Count(double value) { mpz_set_d(value_.raw(), value); }

    operator long() const;  // NOLINT(google-explicit-constructor): see above
    explicit operator double() const;
    [[nodiscard]] const Integer& integer() const { return value_; }
    [[nodiscard]] std::string str() const { return value_.str(); }

    Count& operator+=(const Count& y) {
        value_ += y.value_;
        return *this;
    }
    Count& operator-=(const Count& y) {
        value_ -= y.value_;
        return *this;
    }
    Count& operator++() { return *this += 1; }
    Count& operator--() { return *this -= 1; }

    friend Count operator+(Count x, const Count& y) { return x += y; }
    friend Count operator-(Count x, const Count& y) { return x -= y; }
    /// Precondition: x >= 0, y > 0.
    friend long operator%(const Count& x, long y) {
        return static_cast<long>(mpz_fdiv_ui(x.value_.raw(), static_cast<unsigned long>(y)));
    }
    friend bool operator==(const Count& x, const Count& y) { return x.value_ == y.value_; }
    friend std::strong_ordering operator<=>(const Count& x, const Count& y) { return x.value_ <=> y.value_; }
    // With built-in integers these fit better than the conversion above.
    friend Count operator+(Count x, std::integral auto y) { return x += y; }
    friend Count operator+(std::integral auto x, Count y) { return y += x; }
    friend Count operator-(Count x, std::integral auto y) { return x -= y; }
    friend bool operator==(const Count& x, std::integral auto y) { return x.value_ == Integer(y); }
    friend std::strong_ordering operator<=>(const Count& x, std::integral auto y) {
        return x.value_ <=> Integer(y);
    }
    friend std::ostream& operator<<(std::ostream& out, const Count& x);

  private:
    Integer value_;
};

}  // namespace dumbbell

namespace fmt {

template <>
struct formatter<dumbbell::Count> : formatter<string_view> {
    format_context::iterator format(const dumbbell::Count& x, format_context& context) const;
};

}  // namespace fmt
