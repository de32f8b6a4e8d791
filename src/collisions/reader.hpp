#pragma once

#include <cstddef>
#include <string>

#include "base/interrupted.hpp"
#include "collisions/certificate.hpp"
#include "file/lines.hpp"

namespace dumbbell::collisions {

enum class Trees { kept, passed_over };

/// A certificate about collisions (plain or gzip), one piece at a time: a caller that keeps none needs no
/// more memory than the longest piece, or a line where trees are passed over, however large the file is,
/// unpacked. Throws InputError as read_certificate does, and EndedEarly if it is interrupted.
class PieceReader {
  public:
    PieceReader(const std::string& path, Trees trees, Interrupted interrupted = never);

    /// All but the pieces.
    [[nodiscard]] const Certificate& head() const { return head_; }
    /// The range, as the file says.
    [[nodiscard]] const Rational& q_lo() const { return q_lo_; }
    [[nodiscard]] const Rational& q_hi() const { return q_hi_; }
    /// How many there are, as the file says.
    [[nodiscard]] std::size_t pieces() const { return pieces_; }
    /// The next one; without trees its cover is nothing but its charts. Precondition: there is one.
    [[nodiscard]] Piece next();
    /// Lines::digest. Precondition: all pieces were read.
    [[nodiscard]] std::string digest() { return lines_.digest(); }

  private:
    Lines lines_;
    Trees trees_;
    Interrupted interrupted_;
    Certificate head_;
    Rational q_lo_, q_hi_;
    std::size_t pieces_ = 0;
};

/// How many pieces a certificate has, as its head says; 0 if it is none about collisions.
[[nodiscard]] std::size_t claimed_pieces(const std::string& path);

/// Reads a certificate file (plain or gzip) back into data, for pictures and reports. This is no
/// verification: it checks the syntax as far as it needs it, and none of the mathematics. Throws InputError
/// (naming file and line) if the file is missing or is no certificate.
[[nodiscard]] Certificate read_certificate(const std::string& path);

}  // namespace dumbbell::collisions
