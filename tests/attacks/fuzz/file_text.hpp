// The text of a certificate file as far as the targets look at it without the verifier: what is compressed,
// which scene, how much work it is.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dumbbell_fuzz {

[[nodiscard]] bool is_gzip(std::string_view bytes);

/// The bytes, decompressed if they are gzip: as far as that goes. Nothing if it is more than `most` bytes.
[[nodiscard]] std::optional<std::string> plain_text(const std::string& bytes, std::size_t most = 1 << 16);

/// The first value of the first line with this keyword after the first line of the text; or nothing.
[[nodiscard]] std::string value_of(std::string_view text, std::string_view keyword);

/// Whether the verifier needs no more than about a tenth of a second, whatever it says. The bound is rough:
/// every line may be a leaf, with as many collisions as the greatest ratio of the text allows.
[[nodiscard]] bool is_little_work(const std::string& text);

/// The text up to its totals, with totals and checksum that fit.
[[nodiscard]] std::string with_fitting_trailer(const std::string& text);

}  // namespace dumbbell_fuzz
