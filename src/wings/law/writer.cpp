#include "law/writer.hpp"

#include "base/error.hpp"
#include "collisions/piece_lines.hpp"

namespace dumbbell::law {
namespace {

constexpr std::array<std::string_view, 9> kinds{
    "split", "count", "outside", "meets", "meets-reversed", "equal-masses", "witness", "slope", "beyond"};

const char* word(LayerLeaf leaf) { return leaf == LayerLeaf::slope ? "slope" : "beyond"; }

class Writer : collisions::PieceLines {
  public:
    void header(const LawCertificate& certificate) {
        head(certificate.generator, "1", "dumbbell", "turning", "law");
        line("steps {} {}", first_step, last_step);
    }

    void step(long n, const collisions::Piece& piece) {
        line("step {} {} {}", n, to_fraction(piece.q_lo), to_fraction(piece.q_hi));
        proof(piece);
    }

    void layer(const LayerTree& tree) {
        line("cover layer");
        for (const LayerNode& node : tree) {
            if (node.split) {
                line("split {}", *node.split == LayerAxis::U ? "U" : "rho");
                count("split");
            } else {
                line("{}", word(node.leaf));
                count(word(node.leaf));
            }
        }
    }

    SealedText finish(const Parts& parts) && {
        line("cover bulk {} {} {}", parts.bulk[0], parts.bulk[1], parts.bulk[2]);
        line("cover end {}", parts.end);
        totals(kinds);
        return std::move(*this).sealed();
    }
};

}  // namespace

SealedText render(const LawCertificate& certificate) {
    require(std::ssize(certificate.steps) == last_step - first_step + 1, "the law: a step is missing");
    Writer writer;
    writer.header(certificate);
    long n = first_step;
    for (const collisions::Piece& step : certificate.steps) {
        writer.step(n++, step);
    }
    writer.layer(certificate.layer);
    return std::move(writer).finish(certificate.parts);
}

}  // namespace dumbbell::law
