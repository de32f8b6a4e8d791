#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

#include "collisions/certificate.hpp"
#include "file/sealed_lines.hpp"

namespace dumbbell::collisions {

/// `E [x p]...`: format-sections.md, sections 5 and 6.
[[nodiscard]] std::string to_text(const UpperBound& bound);

/// Writes the proofs of pieces, and counts their lines for the trailer.
class PieceLines : public SealedLines {
  public:
    /// From `bits` to the witness.
    void proof(const Piece& piece);
    /// The trailer: how many lines there are of each of these kinds (format.md), which are all.
    void totals(std::span<const std::string_view> kinds);

  protected:
    /// One more line of this kind; the view outlives this.
    void count(std::string_view kind) { ++totals_[kind]; }

  private:
    void cover(const Cover& cover);
    void leaf(Chart chart, const Leaf& leaf);

    std::map<std::string_view, long> totals_;
};

}  // namespace dumbbell::collisions
