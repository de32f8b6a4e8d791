#pragma once

#include <string>
#include <string_view>

#include "words/json.hpp"

namespace dumbbell::page {

/// The built page (web/dist/report.html) without data: one HTML file that asks for nothing else.
[[nodiscard]] std::string_view page_template();

/// The page with the data in it. No data can end the script element that holds it: `<` is written as an
/// escape, and bytes that are no UTF-8 as U+FFFD.
[[nodiscard]] std::string html_page(const Json& data);

}  // namespace dumbbell::page
