#pragma once

#include <string>

#include "campaign/status.hpp"
#include "words/json.hpp"

namespace dumbbell::campaign {

[[nodiscard]] std::string to_text(const CampaignStatus& status);
[[nodiscard]] Json to_json(const CampaignStatus& status);

/// One sentence.
[[nodiscard]] std::string verdict(const CampaignStatus& status);

}  // namespace dumbbell::campaign
