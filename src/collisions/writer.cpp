#include "collisions/writer.hpp"

#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "collisions/claim.hpp"
#include "collisions/names.hpp"
#include "collisions/piece_lines.hpp"
#include "collisions/section.hpp"

namespace dumbbell::collisions {
namespace {

/// The kinds of lines that the trailer counts, in its order.
std::vector<std::string_view> kinds_of(const SectionRow& row) {
    std::vector<std::string_view> kinds{"split",          "count",           "outside", "meets",
                                        "meets-reversed", equal_masses_word, "witness"};
    if (!row.kind_in_totals.empty()) {
        kinds.push_back(row.kind_in_totals);
    }
    kinds.push_back("open");
    return kinds;
}

class Writer : PieceLines {
  public:
    void header(const Certificate& frame, const std::vector<const Piece*>& pieces) {
        const SectionRow& row = row_of(frame.system.section);
        head(frame.generator, row.lemmas, row.scene, row.section_in_file, "collisions");
        line("ratio {} {}", to_fraction(pieces.front()->q_lo), to_fraction(pieces.back()->q_hi));
        if (const auto& rho = frame.system.rho) {
            line("rho {} {}", to_fraction(*rho), to_fraction(*rho));
        }
        line("pieces {}", pieces.size());
    }

    void piece(const Piece& piece) {
        line("piece {} {}", to_fraction(piece.q_lo), to_fraction(piece.q_hi));
        proof(piece);
    }

    SealedText finish(const Certificate& frame) && {
        totals(kinds_of(row_of(frame.system.section)));
        return std::move(*this).sealed();
    }
};

}  // namespace

SealedText render(const Certificate& certificate) { return render(certificate, pieces_of(certificate)); }

SealedText render(const Certificate& frame, const std::vector<const Piece*>& pieces) {
    require(!pieces.empty(), "certificate: no pieces");
    Writer writer;
    writer.header(frame, pieces);
    const Rational* end = &pieces.front()->q_lo;
    for (const Piece* piece : pieces) {
        require(piece->q_lo == *end && piece->q_lo <= piece->q_hi,
                "certificate: the pieces do not follow one another");
        end = &piece->q_hi;
        writer.piece(*piece);
    }
    return std::move(writer).finish(frame);
}

}  // namespace dumbbell::collisions
