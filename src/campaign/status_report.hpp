#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "campaign/status.hpp"

namespace dumbbell {

[[nodiscard]] std::string to_text(const CampaignStatus& status);
[[nodiscard]] nlohmann::ordered_json to_json(const CampaignStatus& status);

/// One sentence.
[[nodiscard]] std::string verdict(const CampaignStatus& status);

}  // namespace dumbbell
