#include "page/page.hpp"

#include "base/error.hpp"

namespace dumbbell::page {
namespace {

/// Where the data goes: once in the template.
constexpr std::string_view place = "@DUMBBELL_DATA@";

}  // namespace

std::string html_page(const Json& data) {
    const std::string_view page = page_template();
    const std::size_t at = page.find(place);
    require(at != std::string_view::npos && page.find(place, at + 1) == std::string_view::npos,
            "report: the page does not have exactly one place for its data");
    std::string result(page.substr(0, at));
    for (const char c : data.text()) {
        if (c == '<') {
            result += "\\u003c";
        } else {
            result += c;
        }
    }
    return result.append(page.substr(at + place.size()));
}

}  // namespace dumbbell::page
