// The first lines of a certificate (format.md, section 2): they say what is to be read.
#pragma once
#include <string>

#include "verify/format/section.hpp"
#include "verify/format/text.hpp"

namespace dumbbell_verify {

struct Header {
    const Section* section = nullptr;  ///< of a file about mass ratios
    std::string claim;                 ///< the kind; it may be unknown
};

/// Reads up to the line `claim`. Throws the Failure of a line that is wrong, or says what is not supported.
Header read_header(Text& text);

}  // namespace dumbbell_verify
