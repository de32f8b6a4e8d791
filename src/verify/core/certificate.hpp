// Certificates: their first lines, which say what is to be read (format.md, section 2), and those of the
// claim kind `collisions` (section 3).
#pragma once
#include "verify/core/section.hpp"
#include "verify/core/settings.hpp"
#include "verify/core/text.hpp"

namespace dumbbell_verify {

struct Header {
    const Section* section = nullptr;  ///< of a file about mass ratios
    std::string claim;                 ///< the kind; it may be unknown
};

/// Reads up to the line `claim`. Throws the Failure of a line that is wrong, or says what is not supported.
Header read_header(Text& text);

/// Reads on after the line `claim`; returns only if all that the file and the demand say is certified; else
/// throws the Failure of the least line.
Proof collisions(Text& text, const Settings& settings, const Section& section);

}  // namespace dumbbell_verify
