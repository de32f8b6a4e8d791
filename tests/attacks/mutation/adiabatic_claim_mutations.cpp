#include <fmt/format.h>

#include <algorithm>

#include "adiabatic/writer.hpp"
#include "mutations.hpp"

namespace dumbbell_mutation {
namespace {

using namespace dumbbell;
using namespace dumbbell::adiabatic;

/// Numbers a little and much greater and less.
class AdiabaticClaims {
  public:
    AdiabaticClaims(const adiabatic::Certificate& data, const Sink& sink) : data_(data), sink_(sink) {}

    void run() {
        for (const int side : {0, 1}) {
            moved("other delta", fmt::format("end {}", side), [side](adiabatic::Certificate& c) {
                return std::vector{side == 0 ? &c.hypotheses.delta.first : &c.hypotheses.delta.second};
            });
            moved("other heights", fmt::format("end {}", side), [side](adiabatic::Certificate& c) {
                return std::vector{side == 0 ? &c.hypotheses.heights.first : &c.hypotheses.heights.second};
            });
        }
        moved("other delta", "of all", [](adiabatic::Certificate& c) {
            std::vector<Rational*> all = {&c.hypotheses.delta.first, &c.hypotheses.delta.second};
            for (adiabatic::State& state : c.attained) all.push_back(&state.delta);
            return all;
        });
        moved("other margin", "",
              [](adiabatic::Certificate& c) { return std::vector{&c.hypotheses.margin}; });
        for (std::size_t i = 0; i < data_.bounds.size(); ++i)
            moved("other bound", fmt::format("{}", i),
                  [i](adiabatic::Certificate& c) { return std::vector{&c.bounds[i]}; });
        for (std::size_t i = 0; i < data_.classes.size(); ++i) of_class(i);
        for (std::size_t i = 0; i < data_.attained.size(); ++i) of_state(i);
        for (int k = 0; k <= 16; ++k)
            give("exponent", fmt::format("{}", k),
                 [k](adiabatic::Certificate& c) { c.hypotheses.exponent = k; });
        for (const int bits : bit_counts)
            give("bits", std::to_string(bits), [bits](adiabatic::Certificate& c) { c.bits = bits; });
        for (const auto claim : {adiabatic::Claim::run, adiabatic::Claim::scattering})
            if (!data_.classes.empty())
                give("other claim", "", [claim](adiabatic::Certificate& c) { c.hypotheses.claim = claim; });
    }

  private:
    template <class Change>
    void give(std::string_view kind, const std::string& what, Change change) {
        adiabatic::Certificate changed = data_;
        change(changed);
        sink_({kind, what, render(changed).text});
    }
    /// The numbers that `chosen` names, all by the same factor.
    template <class Chosen>
    void moved(std::string_view kind, const std::string& what, Chosen chosen) {
        for (const char* step : steps)
            for (const bool up : {true, false})
                give(kind, fmt::format("{} {} {}", what, up ? "more" : "less", step),
                     [&](adiabatic::Certificate& c) {
                         const Rational factor = 1 + parse_rational(step);
                         for (Rational* x : chosen(c))
                             *x = up ? Rational(*x * factor) : Rational(*x / factor);
                     });
    }

    void of_class(std::size_t i) {
        moved("class: other J", fmt::format("{}", i),
              [i](adiabatic::Certificate& c) { return std::vector{&c.classes[i].least_share}; });
        moved("class: other density", fmt::format("{}, all", i), [i](adiabatic::Certificate& c) {
            std::vector<Rational*> all;
            for (auto& cell : c.classes[i].cells) all.push_back(&cell.v);
            return all;
        });
        for (std::size_t j = 0; j < data_.classes[i].cells.size(); ++j) {
            const std::string what = fmt::format("{}, cell {}", i, j);
            give("class: other density", what + " none",
                 [&](adiabatic::Certificate& c) { c.classes[i].cells[j].v = 0; });
            give("class: cell deleted", what, [&](adiabatic::Certificate& c) {
                auto& cells = c.classes[i].cells;
                cells.erase(cells.begin() + static_cast<std::ptrdiff_t>(j));
            });
        }
    }
    void of_state(std::size_t i) {
        const auto number = [&](std::string_view kind, Rational adiabatic::State::*x) {
            moved(kind, fmt::format("{}", i),
                  [i, x](adiabatic::Certificate& c) { return std::vector{&(c.attained[i].*x)}; });
        };
        number("attained: other value", &adiabatic::State::value);
        number("attained: other u", &adiabatic::State::u);
        number("attained: other s", &adiabatic::State::s);
        number("attained: other delta", &adiabatic::State::delta);
        for (const long more : {-2L, -1L, 1L, 2L})
            give("attained: other n", fmt::format("{} {}", i, more),
                 [&](adiabatic::Certificate& c) { c.attained[i].n = std::max(0L, c.attained[i].n + more); });
    }

    const adiabatic::Certificate& data_;
    const Sink& sink_;
};

}  // namespace

void adiabatic_claim_mutations(const adiabatic::Certificate& data, const Sink& sink) {
    AdiabaticClaims(data, sink).run();
}

}  // namespace dumbbell_mutation
