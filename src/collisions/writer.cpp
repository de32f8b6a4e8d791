#include "collisions/writer.hpp"

#include <fmt/core.h>

#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "base/error.hpp"
#include "collisions/names.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::collisions {
namespace {

/// The kinds of lines that the trailer counts, in its order.
std::vector<std::string_view> kinds_of(Section section) {
    std::vector<std::string_view> kinds{"split",          "count",        "outside", "meets",
                                        "meets-reversed", "equal-masses", "witness"};
    if (section != Section::turning) {
        kinds.push_back(name(Reason::once));
    }
    kinds.push_back("open");
    return kinds;
}

class Writer : SealedLines {
  public:
    void header(const Certificate& certificate) {
        line("dumbbell-certificate 1");
        line("generator {} {}", certificate.program, certificate.version);
        line("lemmas {}", lemma_set(certificate.section));
        line("scene {}", name(certificate.scene));
        line("section {}", name(certificate.section));
        line("claim collisions");
        line("ratio {} {}", to_fraction(certificate.q_lo()), to_fraction(certificate.q_hi()));
        line("pieces {}", certificate.pieces.size());
    }

    void piece(const Piece& piece) {
        line("piece {} {}", to_fraction(piece.q_lo), to_fraction(piece.q_hi));
        line("bits {}", piece.bits);
        if (piece.upper) {
            line("upper {}", *piece.upper);
            cover(piece.cover);
        } else {
            line("upper none");
            ++totals_["open"];
        }
        line("lower {}", piece.lower);
        if (piece.lower > 0) {
            require(piece.witness.has_value(), "certificate: a lower bound needs a witness");
            const Witness& w = *piece.witness;
            line("witness {} {} {} {} {}", name(w.chart), to_dyadic(w.e), to_dyadic(w.eta), w.forward,
                 w.backward);
            ++totals_["witness"];
        }
    }

    SealedText finish(Section section) && {
        for (const std::string_view kind : kinds_of(section)) {
            line("total {} {}", kind, totals_[kind]);
        }
        return std::move(*this).sealed();
    }

  private:
    void cover(const Cover& cover) {
        if (cover.equal_masses) {
            line("equal-masses");
            ++totals_["equal-masses"];
            return;
        }
        for (const ChartTree& part : cover.charts) {
            line("chart {}", name(part.chart));
            for (const Node& node : part.tree) {
                if (node.split) {
                    line("split {}", axis_name(part.chart, *node.split));
                    ++totals_["split"];
                } else {
                    leaf(part.chart, node.leaf);
                }
            }
        }
    }

    void leaf(Chart chart, const Leaf& leaf) {
        const std::string_view word = name(leaf.reason);
        ++totals_[word];
        if (leaf.reason != Reason::count) {
            line("{}", word);
        } else if (counts_both_ways(chart)) {
            line("{} {} {}", word, leaf.forward, leaf.backward);
        } else {
            line("{} {}", word, leaf.forward);
        }
    }

    std::map<std::string_view, long> totals_;
};

}  // namespace

SealedText render(const Certificate& certificate) {
    require(!certificate.pieces.empty(), "certificate: no pieces");
    Writer writer;
    writer.header(certificate);
    const Rational* end = &certificate.q_lo();
    for (const Piece& piece : certificate.pieces) {
        require(piece.q_lo == *end && piece.q_lo <= piece.q_hi,
                "certificate: the pieces do not follow one another");
        end = &piece.q_hi;
        writer.piece(piece);
    }
    return std::move(writer).finish(certificate.section);
}

}  // namespace dumbbell::collisions
