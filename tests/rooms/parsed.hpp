#pragma once

#include <nlohmann/json.hpp>

#include "words/json.hpp"

namespace dumbbell_test {

/// What a reader of JSON finds in it.
inline nlohmann::ordered_json parsed(const dumbbell::Json& json) {
    return nlohmann::ordered_json::parse(json.text());
}

}  // namespace dumbbell_test
