#include "adiabatic/writer.hpp"

#include <fmt/core.h>

#include "base/error.hpp"
#include "number/decimal.hpp"

namespace dumbbell::adiabatic {
namespace {

/// The body's lines and their numbers.
class Body : SealedLines {
  public:
    using SealedLines::head;
    using SealedLines::line;

    /// `with_class`: the leaves name the class that bounds them.
    void tree(const Tree& nodes, bool with_class) {
        long open = 1;
        for (const Node& node : nodes) {
            require(open > 0, "certificate: a tree goes on after its end");
            if (node.split) {
                line("split {}", axis_names[static_cast<std::size_t>(*node.split)]);
                ++splits_;
                ++open;
                continue;
            }
            --open;
            ++(node.outside ? outside_ : bound_);
            line("{}", node.outside ? "outside"
                       : with_class ? fmt::format("bound {}", node.by_class)
                                    : "bound");
        }
        require(open == 0, "certificate: a tree is not complete");
    }
    [[nodiscard]] SealedText finished() && {
        line("total split {}", splits_);
        line("total bound {}", bound_);
        line("total outside {}", outside_);
        return std::move(*this).sealed();
    }

  private:
    long splits_ = 0, bound_ = 0, outside_ = 0;
};

void write_header(Body& body, const Certificate& certificate) {
    const Hypotheses& of = certificate.hypotheses;
    body.head(certificate.generator, "1", "dumbbell", "none", name(of.claim));
    body.line("delta {} {}", to_fraction(of.delta.first), to_fraction(of.delta.second));
    if (of.claim == Claim::bounce || of.claim == Claim::run) {
        body.line("heights {} {}", to_fraction(of.heights.first), to_fraction(of.heights.second));
    }
    body.line("margin {}", to_fraction(of.margin));
    if (of.claim == Claim::bounce) {
        body.line("exponent {}", of.exponent);
    }
    body.line("bits {}", certificate.bits);
    std::string numbers;
    for (const Rational& bound : certificate.bounds) {
        numbers += ' ' + to_fraction(bound);
    }
    body.line("bound{}", numbers);
}

void write_classes(Body& body, const std::vector<Class>& classes) {
    body.line("classes {}", classes.size());
    for (const Class& one : classes) {
        body.line("class {} {}", to_fraction(one.least_share), one.cells.size());
        for (const auto& cell : one.cells) {
            body.line("cell {} {}", to_fraction(cell.u), to_fraction(cell.v));
        }
        body.tree(one.tree, false);
    }
    body.line("end");
}

}  // namespace

SealedText render(const Certificate& certificate) {
    require(certificate.complete(), "certificate: a bound or an orbit is missing");
    const bool by_classes = certificate.hypotheses.claim != Claim::bounce;
    Body body;
    write_header(body, certificate);
    if (by_classes) {
        write_classes(body, certificate.classes);
    }
    body.tree(certificate.tree, by_classes);
    for (const State& state : certificate.attained) {
        body.line("attained {} {} {} {} {}", to_fraction(state.u), to_fraction(state.s),
                  to_fraction(state.delta), state.n, to_fraction(state.value));
    }
    return std::move(body).finished();
}

std::string claim_options(const Hypotheses& of, const std::vector<Rational>& bounds,
                          const std::vector<State>& attained) {
    std::string text =
        fmt::format("--claim {} --delta {}", name(of.claim), spelled(of.delta.first, of.delta.second));
    if (of.claim != Claim::scattering) {
        text += " --heights " + spelled(of.heights.first, of.heights.second);
    }
    text += " --margin " + spelled(of.margin);
    if (of.claim == Claim::bounce) {
        text += " --exponent " + spelled(Rational(of.exponent, 16));
    }
    std::string constants, values;
    for (std::size_t i = 0; i < bounds.size(); ++i) {
        constants += (i == 0 ? " --constant " : ",") + spelled(bounds[i]);
        values += (i == 0 ? " --attained " : ",") + spelled(attained.at(i).value);
    }
    return text + constants + values;
}

}  // namespace dumbbell::adiabatic
