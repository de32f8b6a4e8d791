// Ratios that may be 0, or negative.
#pragma once
#include "verify/core/text.hpp"

namespace dumbbell_verify::starts {

/// Field i, a ratio or 0.
inline mpq_class level(const Text& text, std::size_t i) {
    return text.fields[i] == "0/1" ? mpq_class(0) : text.ratio(i);
}
inline mpq_class signed_ratio(const Text& text, std::size_t i) {
    const std::string_view field = text.fields[i];
    return field.starts_with('-') ? mpq_class(-text.ratio(field.substr(1))) : level(text, i);
}

}  // namespace dumbbell_verify::starts
