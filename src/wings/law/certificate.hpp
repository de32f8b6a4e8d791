#pragma once

#include <string_view>
#include <vector>

#include "collisions/certificate.hpp"
#include "file/lines.hpp"
#include "law/layer_cover.hpp"
#include "law/ranges.hpp"

namespace dumbbell::law {

/// The steps that the certificate encloses one by one; beyond, the covers hold.
inline constexpr long first_step = 3, last_step = 902;

/// Its certificate among those that are shipped, and the SHA-256 in the last line of that.
inline constexpr std::string_view certificate_name = "law.dbc.gz";
inline constexpr std::string_view certificate_sha256 =
    "c580c4b44d898678234f3f949a84c81d9802c3d4b1599f7dc33925b17738b8c2";

/// The certificate of the law as data (docs/reference/format-law.md).
struct LawCertificate {
    Generator generator{};
    /// first_step, ..., last_step in order: N - 1 is proved at q_lo alone, N at q_hi alone.
    std::vector<collisions::Piece> steps;
    LayerTree layer;
    Parts parts;
};

/// The ratios A < B of a step to n: n - 1 is proved at A, n at B, and q_c(n) lies in [A, B).
struct StepEnds {
    Rational below, above;
};

/// Of all steps of such a certificate, first_step at first. No verification; throws InputError if the file
/// cannot be read as one.
[[nodiscard]] std::vector<StepEnds> read_steps(const NamedFile& source);

}  // namespace dumbbell::law
