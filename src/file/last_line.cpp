#include "file/last_line.hpp"

namespace dumbbell {

std::string_view last_line(std::string_view text) {
    constexpr std::string_view blank = " \t\r\n";
    const std::size_t last = text.find_last_not_of(blank);
    if (last == std::string_view::npos) {
        return {};
    }
    text = text.substr(0, last + 1);
    const std::size_t before = text.find_last_of("\r\n");
    const std::string_view line = before == std::string_view::npos ? text : text.substr(before + 1);
    return line.substr(line.find_first_not_of(blank));
}

}  // namespace dumbbell
