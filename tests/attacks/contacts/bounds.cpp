// The verifier's bounds about single rays, for contacts.py. A line in: BITS (0: double) C KAPPA Z RHO,
// hexadecimal fractions, RHO 0 for a light wall, else the bridge's; Z is one more guess. A line out: words,
// and bounds x,sine,cosine.
#include <iostream>

#include "verify/functions/exact_value.hpp"
#include "verify/sections/flights.hpp"
#include "verify/wings/starts/ray.hpp"

using namespace dumbbell_verify;

namespace {

void say(const char* word, bool certified) {
    if (certified) std::cout << ' ' << word;
}
template <class N>
void show(const char* name, const N& x, const N& sine, const N& cosine) {
    for (const N& y : {x, sine, cosine})
        if (!std::isfinite(to_double(down, y))) return;
    std::cout << ' ' << name << '=' << exact_value(x).get_str(16) << ',' << exact_value(sine).get_str(16)
              << ',' << exact_value(cosine).get_str(16);
}

/// What a leaf about initial conditions asks.
template <class N>
struct OfStart : starts::Departures<N> {
    using I = Interval<N>;
    using starts::Departures<N>::Departures;
    void show_contacts(bool light, const I& c, const I& kappa) const try {
        const auto at = light ? this->contacts(c, kappa) : this->bridge_contacts(c, kappa);
        say("meets", at.has_value());
        if (!at) return;
        show("first", at->x.lo, at->sine.lo, at->cosine.hi);
        show("last", at->x.hi, at->sine.hi, at->cosine.lo);
    } catch (const Excluded&) {
    }
};

template <class N>
void light_wall(const N& c, const N& kappa, const N& other) {
    OfStart<N> rays(N(1), nullptr);
    say("misses", rays.misses({c, kappa, rays.one}));
    if (!(kappa < rays.one)) return;
    N guess = rays.zero;
    guess_root(c, kappa, guess);
    for (const N& z : {guess, other}) {
        const auto first = rays.earliest({c, kappa, rays.one}, z);
        show("first", first.x, first.sine, first.cosine);
        const auto last = rays.latest({c, kappa, rays.one}, z);
        say("meets", last.has_value());
        if (last) show("last", last->x, last->sine, last->cosine);
    }
    rays.show_contacts(true, c, kappa);
}

template <class N>
struct OfBody : Flights<N> {
    using I = Interval<N>;
    explicit OfBody(const Leaf& leaf) : Flights<N>(leaf, body(), nullptr) {}
    void show_bridge(const N& c, const N& kappa, const N& other) try {
        say("clears", this->certainly_above(c, kappa));
        say("below", this->certainly_below(c, kappa, other));
        const auto met = this->Bridge<N>::contacts(kappa, c, kappa);
        say("meets", met.all);
        show("last", met.last, N(1), N(-1));
        show("first", this->rebound(I(c), I(kappa), this->half_turn.hi).t.lo, N(-1), N(1));
    } catch (const Excluded&) {
    }
};

template <class N>
void bridge(const mpq_class& rho, const N& c, const N& kappa, const N& other) {
    Leaf leaf;
    leaf.box.lo = leaf.box.hi = {0, 0, 4 / rho, rho};
    OfBody<N>(leaf).show_bridge(c, kappa, other);
    const Interval<N> r(bound(down, rho, N(0)), bound(up, rho, N(0)));
    OfStart<N> rays(r, nullptr);
    say("passes", rays.passes_bridge({true, c, kappa}));
    rays.show_contacts(false, Interval<N>(c) / r, Interval<N>(kappa) / r);
}

template <class N>
void ray(const mpq_class (&numbers)[4]) {
    const auto number = [&](int i) { return bound(down, numbers[i], N(0)); };
    if (numbers[3] == 0)
        light_wall(number(0), number(1), number(2));
    else
        bridge(numbers[3], number(0), number(1), number(2));
}

}  // namespace

int main() {
    std::string bits, words[4];
    while (std::cin >> bits >> words[0] >> words[1] >> words[2] >> words[3]) {
        mpq_class numbers[4];
        for (int i = 0; i < 4; ++i) numbers[i] = mpq_class(words[i], 16);
        for (mpq_class& x : numbers) x.canonicalize();
        if (bits != "0") Big::precision = std::stoi(bits);
        bits == "0" ? ray<double>(numbers) : ray<Big>(numbers);
        std::cout << '\n';
    }
}
