#pragma once

#include <algorithm>
#include <string>

namespace dumbbell::api {

/// A sentence of the programs as a caller reads it: names without the dashes of options, and no command at
/// its end.
inline std::string without_dashes(std::string text) {
    text.erase(std::min(text.find(": dumbbell "), text.size()));
    for (std::size_t at = 0; (at = text.find("--", at)) != std::string::npos;) {
        text.erase(at, 2);
    }
    return text;
}

}  // namespace dumbbell::api
