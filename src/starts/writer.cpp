#include "starts/writer.hpp"

#include <fmt/core.h>

#include <algorithm>

#include "base/error.hpp"
#include "file/dyadic.hpp"

namespace dumbbell::starts {
namespace {

constexpr decltype(axis_names) incoming_names{"phi", "s", "", "", ""};

std::string contact_text(const std::optional<FirstContact>& first) {
    return first ? fmt::format(" {} {} {}", first->heavy ? "heavy" : "light", to_dyadic(first->from),
                               to_dyadic(first->until))
                 : "";
}

/// The body's lines and their numbers.
class Body {
  public:
    explicit Body(const decltype(axis_names)& names) : names_(names) {}

    void node(const Node& node) {
        if (node.split) {
            line(fmt::format("split {}", names_[static_cast<std::size_t>(*node.split)]));
            ++splits_;
        } else {
            leaf(node.leaf);
        }
    }

    [[nodiscard]] bool complete() const { return exactly_ + between_ + open_ == splits_ + 1; }
    [[nodiscard]] std::string bounds() const {
        return fmt::format("between {} {}\n", open_ > 0 ? 0 : least_,
                           open_ > 0 ? "none" : fmt::format("{}", most_));
    }
    [[nodiscard]] const std::string& lines() const { return text_; }
    [[nodiscard]] std::string totals() const {
        return fmt::format("total split {}\ntotal exactly {}\ntotal between {}\ntotal open {}\n", splits_,
                           exactly_, between_, open_);
    }

  private:
    void leaf(const Leaf& leaf) {
        if (!leaf.most) {
            line("open");
            ++open_;
            return;
        }
        const bool any = exactly_ + between_ > 0;
        least_ = any ? std::min(least_, leaf.least) : leaf.least;
        most_ = any ? std::max(most_, *leaf.most) : *leaf.most;
        if (leaf.least == *leaf.most) {
            line(fmt::format("exactly {}{}", leaf.least, contact_text(leaf.first)));
            ++exactly_;
        } else {
            line(fmt::format("between {} {}{}", leaf.least, *leaf.most, contact_text(leaf.first)));
            ++between_;
        }
    }

    void line(const std::string& words) { text_ += words + '\n'; }

    const decltype(axis_names)& names_;
    std::string text_;
    long splits_ = 0, exactly_ = 0, between_ = 0, open_ = 0;
    long least_ = 0, most_ = 0;
};

Body body_of(const Certificate& certificate) {
    return Body(certificate.incoming ? incoming_names : axis_names);
}

SealedText render(const Certificate& certificate, const Body& body) {
    require(body.complete(), "certificate: the tree of initial conditions is not complete");
    const auto& [lo, hi] = certificate.box;
    SealedLines out;
    out.head(certificate.generator, "1", "dumbbell", "none",
             certificate.incoming ? "incoming" : "initial-conditions");
    out.line("ratio {} {}", to_fraction(lo[4]), to_fraction(hi[4]));
    for (std::size_t i = 0; i < 4 && !certificate.incoming; ++i) {
        out.line("{} {} {}", axis_names[i], to_fraction(lo[i]), to_fraction(hi[i]));
    }
    out.line("bits {}", certificate.bits);
    out.lines(body.bounds());
    out.lines(body.lines());
    out.lines(body.totals());
    return std::move(out).sealed();
}

}  // namespace

SealedText render(const Certificate& certificate) {
    Body body = body_of(certificate);
    for (const Node& node : certificate.tree) {
        body.node(node);
    }
    return render(certificate, body);
}

SealedText render(const Certificate& certificate, const PackedTree& tree) {
    Body body = body_of(certificate);
    tree.for_each([&](const Node& node) { body.node(node); });
    return render(certificate, body);
}

}  // namespace dumbbell::starts
