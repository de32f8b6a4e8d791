#pragma once

#include <string_view>

namespace dumbbell::api {

/// The bytes of certificates/law.dbc.gz.
std::string_view law_certificate();

}  // namespace dumbbell::api
