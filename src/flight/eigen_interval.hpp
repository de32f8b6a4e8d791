#pragma once

#include <Eigen/Core>

#include "number/big_interval.hpp"
#include "number/interval.hpp"

/// Eigen's vectors and matrices with entries that are enclosures. Only sums and products are formed of them,
/// never a decomposition: those compare entries, which intervals do not allow.
namespace Eigen {

namespace detail {

template <class I>
struct EnclosureTraits : GenericNumTraits<I> {
    using Real = I;
    using NonInteger = I;
    using Nested = I;
    using Literal = double;
    enum {
        IsComplex = 0,
        IsInteger = 0,
        IsSigned = 1,
        RequireInitialization = 1,
        ReadCost = 2,
        AddCost = 4,
        MulCost = 16
    };
};

}  // namespace detail

template <>
struct NumTraits<dumbbell::Interval> : detail::EnclosureTraits<dumbbell::Interval> {};
template <>
struct NumTraits<dumbbell::BigInterval> : detail::EnclosureTraits<dumbbell::BigInterval> {};

}  // namespace Eigen
