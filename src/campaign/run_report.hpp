#pragma once

#include <string>
#include <string_view>

#include "campaign/campaign.hpp"
#include "words/json.hpp"

namespace dumbbell::campaign {

/// What a run of a campaign tells its user.
[[nodiscard]] std::string to_text(const CampaignRun& run);
[[nodiscard]] Json to_json(const CampaignRun& run, std::string_view engine);

/// One sentence.
[[nodiscard]] std::string verdict(const CampaignRun& run);

}  // namespace dumbbell::campaign
