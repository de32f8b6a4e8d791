#pragma once

#include <string>

#include "collisions/certificate.hpp"
#include "page/tree.hpp"
#include "starts/cover/certificate.hpp"
#include "words/json.hpp"

/// One file of the page's data, by claim kind: its claim, trees and starting states, and the options with
/// which the verifier is asked for exactly that claim.
namespace dumbbell::page {

[[nodiscard]] Json file_json(const collisions::Certificate& certificate, const BoxBudget& budget);
[[nodiscard]] Json file_json(const starts::Certificate& certificate, const BoxBudget& budget);

/// Words for the command line, e.g. `--ratio 1:100 --max 10 --min 2`.
[[nodiscard]] std::string claim_options(const collisions::Certificate& certificate);
[[nodiscard]] std::string claim_options(const starts::Certificate& certificate);

}  // namespace dumbbell::page
