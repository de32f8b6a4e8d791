#include "collisions/writer.hpp"

#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "collisions/names.hpp"
#include "collisions/piece_lines.hpp"

namespace dumbbell::collisions {
namespace {

/// The kinds of lines that the trailer counts, in its order.
std::vector<std::string_view> kinds_of(Scene scene, Section section) {
    std::vector<std::string_view> kinds{"split",          "count",        "outside", "meets",
                                        "meets-reversed", "equal-masses", "witness"};
    if (section != Section::turning) {
        kinds.push_back(scene == Scene::body ? symmetric_word : name(Reason::once));
    }
    kinds.push_back("open");
    return kinds;
}

class Writer : PieceLines {
  public:
    void header(const Certificate& frame, const std::vector<const Piece*>& pieces) {
        const SectionWords words = spelled(frame.section, frame.scene);
        head(frame.generator, words.lemmas, name(frame.scene), words.section, "collisions");
        line("ratio {} {}", to_fraction(pieces.front()->q_lo), to_fraction(pieces.back()->q_hi));
        if (frame.heights) {
            line("rho {} {}", to_fraction(frame.heights->lo), to_fraction(frame.heights->hi));
        }
        line("pieces {}", pieces.size());
    }

    void piece(const Piece& piece) {
        line("piece {} {}", to_fraction(piece.q_lo), to_fraction(piece.q_hi));
        proof(piece);
    }

    SealedText finish(const Certificate& frame) && {
        totals(kinds_of(frame.scene, frame.section));
        return std::move(*this).sealed();
    }
};

}  // namespace

SealedText render(const Certificate& certificate) {
    std::vector<const Piece*> pieces;
    pieces.reserve(certificate.pieces.size());
    for (const Piece& piece : certificate.pieces) {
        pieces.push_back(&piece);
    }
    return render(certificate, pieces);
}

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
