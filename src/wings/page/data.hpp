#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "collisions/certificate.hpp"
#include "starts/cover/certificate.hpp"
#include "words/json.hpp"

/// What the page of `dumbbell report` shows, as one JSON object: certificates, and nothing that they do not
/// claim (web/README.md describes it); and the page with it.
namespace dumbbell::page {

/// What the page shows.
using Reported = std::variant<collisions::Certificate, starts::Certificate>;

struct ReportedFile {
    std::string path;    ///< as the user wrote it, for the command that verifies it
    std::string sha256;  ///< sealed_digest
    Reported content;
    std::string bytes{};  ///< the file as it is, if the page is to verify it
};

/// Reads a certificate of one of these kinds, whose checksum must be right, from the bytes of its file; and
/// keeps them if they are wanted. Throws InputError (naming the file) for anything else.
[[nodiscard]] ReportedFile read_reported(const std::string& path, std::string bytes, bool with_bytes);

/// Pieces of all files together; a page with more would not open.
inline constexpr std::size_t most_pieces = 100'000;

/// Throws InputError if the files have more, by what their heads say: before they are read, which takes
/// memory.
void require_few_pieces(const std::vector<std::string>& paths);

/// Throws InputError if the files have more than `most_pieces`.
[[nodiscard]] Json page_data(const std::vector<ReportedFile>& files, std::size_t most_boxes);

[[nodiscard]] std::size_t leaves_of(const Reported& content);

/// The built page (web/dist/dumbbell.html) without data: one HTML file that asks for nothing else.
[[nodiscard]] std::string_view page_template();

/// The page with the data in it, and the bytes of the verifier that it is to run, if there are any. No data
/// can end the script element that holds it: `<` is written as an escape, and bytes that are no UTF-8 as
/// U+FFFD.
[[nodiscard]] std::string html_page(const Json& data, std::string_view verifier = {});

/// As RFC 4648 says, with padding.
[[nodiscard]] std::string base64(std::string_view bytes);

}  // namespace dumbbell::page
