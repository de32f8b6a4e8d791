#pragma once

#include <string>

#include "file/sealed_lines.hpp"
#include "starts/cover/certificate.hpp"
#include "starts/cover/packed_tree.hpp"

namespace dumbbell::starts {

/// The one canonical spelling (format-initial.md). Throws BrokenInvariant if the tree is not complete.
[[nodiscard]] SealedText render(const Certificate& certificate);
/// With this tree instead of the certificate's, to a sink; returns its SHA-256.
std::string render(const Certificate& certificate, const PackedTree& tree, const Sink& sink);

/// The claim's word in the file.
[[nodiscard]] constexpr std::string_view claim_kind(bool incoming) {
    return incoming ? "incoming" : "initial-conditions";
}

/// Words for the command line of the verifier, with which it is asked for all that a file about these starts
/// proves; `decided`: the share whose number is known.
[[nodiscard]] std::string claim_options(bool incoming, const Box& box, long least, std::optional<long> most,
                                        const Rational& decided);

}  // namespace dumbbell::starts
