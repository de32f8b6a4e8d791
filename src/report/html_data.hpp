#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "certificate/any_reader.hpp"

/// What the page of `dumbbell report` shows, as one JSON object: certificates, and nothing that they do not
/// claim. web/README.md describes it.
namespace dumbbell {

struct ReportedFile {
    std::string path;    ///< as the user wrote it, for the command that verifies it
    std::string sha256;  ///< sealed_digest
    AnyCertificate certificate;
};

/// Boxes of all covers together that a page draws; beyond, trees are thinned out.
inline constexpr std::size_t default_most_boxes = 200'000;

/// Pieces of all files together; a page with more would not open. Throws InputError beyond.
inline constexpr std::size_t most_pieces = 100'000;

[[nodiscard]] nlohmann::ordered_json page_data(const std::vector<ReportedFile>& files,
                                               std::size_t most_boxes);

/// How many leaves the trees of the certificate have.
[[nodiscard]] std::size_t leaves_of(const AnyCertificate& certificate);

}  // namespace dumbbell
