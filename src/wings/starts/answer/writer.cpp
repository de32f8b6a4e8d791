#include "starts/answer/writer.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "file/dyadic.hpp"
#include "number/decimal.hpp"

namespace dumbbell::starts {
namespace {

std::string contact_text(const std::optional<FirstContact>& first) {
    return first ? fmt::format(" {} {} {}", first->heavy ? "heavy" : "light", to_dyadic(first->from),
                               to_dyadic(first->until))
                 : "";
}

/// The numbers of the body's lines, and what all leaves together say.
class Totals {
  public:
    void add(const Node& node) {
        if (node.split) {
            ++splits_;
        } else if (!node.leaf.most) {
            ++open_;
        } else {
            const auto& [least, most, first] = node.leaf;
            const bool any = exactly_ + between_ > 0;
            least_ = any ? std::min(least_, least) : least;
            most_ = any ? std::max(most_, *most) : *most;
            ++(least == *most ? exactly_ : between_);
        }
    }

    [[nodiscard]] bool complete() const { return exactly_ + between_ + open_ == splits_ + 1; }
    [[nodiscard]] std::string bounds() const {
        return fmt::format("between {} {}\n", open_ > 0 ? 0 : least_,
                           open_ > 0 ? "none" : fmt::format("{}", most_));
    }
    [[nodiscard]] std::string lines() const {
        return fmt::format("total split {}\ntotal exactly {}\ntotal between {}\ntotal open {}\n", splits_,
                           exactly_, between_, open_);
    }

  private:
    long splits_ = 0, exactly_ = 0, between_ = 0, open_ = 0;
    long least_ = 0, most_ = 0;
};

std::string line_of(const Node& node, const decltype(axis_names)& names) {
    const auto& [least, most, first] = node.leaf;
    return node.split       ? fmt::format("split {}\n", names[static_cast<std::size_t>(*node.split)])
           : !most          ? "open\n"
           : least == *most ? fmt::format("exactly {}{}\n", least, contact_text(first))
                            : fmt::format("between {} {}{}\n", least, *most, contact_text(first));
}

/// `for_each`: does something with each node of the tree, which it visits twice.
template <class ForEach>
SealedText render(const Certificate& certificate, const ForEach& for_each, SealedLines out) {
    Totals totals;
    for_each([&](const Node& node) { totals.add(node); });
    require(totals.complete(), "certificate: the tree of initial conditions is not complete");
    require(!certificate.box.rho, "there are no certificates about starts of bodies");
    const auto& lo = certificate.box.lo;
    const auto& hi = certificate.box.hi;
    out.head(certificate.generator, "1", "dumbbell", "none",
             certificate.incoming ? "incoming" : "initial-conditions");
    out.line("ratio {} {}", to_fraction(lo[4]), to_fraction(hi[4]));
    for (std::size_t i = 0; i < 4 && !certificate.incoming; ++i) {
        out.line("{} {} {}", axis_names[i], to_fraction(lo[i]), to_fraction(hi[i]));
    }
    out.line("bits {}", certificate.bits);
    out.lines(totals.bounds());
    const auto& names = certificate.incoming ? incoming_names : axis_names;
    for_each([&](const Node& node) { out.lines(line_of(node, names)); });
    out.lines(totals.lines());
    return std::move(out).sealed();
}

}  // namespace

SealedText render(const Certificate& certificate) {
    return render(
        certificate, [&](const auto& use) { std::ranges::for_each(certificate.tree, use); }, SealedLines());
}

std::string render(const Certificate& certificate, const PackedTree& tree, const Sink& sink) {
    return render(
               certificate, [&](const auto& use) { tree.for_each(use); }, SealedLines(sink))
        .sha256;
}

std::string claim_options(bool incoming, const Box& box, long least, std::optional<long> most,
                          const Rational& decided) {
    constexpr int share_digits = 12;
    std::string text = fmt::format("--claim {}", claim_kind(incoming));
    for (std::size_t i = incoming ? 4 : 0; i < axis_count; ++i) {
        text +=
            fmt::format(" --{} {}", i == 4 ? "ratio" : axis_names.at(i), spelled(box.lo.at(i), box.hi.at(i)));
    }
    if (most == least) {
        return text + fmt::format(" --exactly {}", least);
    }
    text += most ? fmt::format(" --max {}", *most) : "";
    text += least > 0 ? fmt::format(" --min {}", least) : "";
    return text +
           (decided > 0 ? " --decided " + to_text(without_zeros(cut_down(decided, share_digits))) : "");
}

}  // namespace dumbbell::starts
