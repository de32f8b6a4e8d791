#pragma once

#include <string>

#include "file/sealed_lines.hpp"
#include "starts/certificate.hpp"
#include "starts/packed_tree.hpp"

namespace dumbbell::starts {

/// The one canonical spelling (format-initial.md). Throws BrokenInvariant if the tree is not complete.
[[nodiscard]] SealedText render(const Certificate& certificate);
/// With this tree instead of the certificate's, to a sink; returns its SHA-256.
std::string render(const Certificate& certificate, const PackedTree& tree, const Sink& sink);

}  // namespace dumbbell::starts
