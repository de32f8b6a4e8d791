#include "simulate.hpp"

#include <algorithm>
#include <stdexcept>

#include "contact_time.hpp"
#include "scalar.hpp"

namespace dumbbell_oracle {
namespace {

template <class S>
void count(Total<S>& total, const Run<S>& run) {
    for (const Collision<S>& collision : run.collisions) {
        ++(collision.mass == Mass::light ? total.light : total.heavy);
    }
    total.collisions = total.light + total.heavy;
    total.care.include(run.care);
}

}  // namespace

template <class S>
void Care<S>::include(const Care& more) {
    least_sine = std::min(least_sine, more.least_sine);
    least_clearance = std::min(least_clearance, more.least_clearance);
    least_gap = std::min(least_gap, more.least_gap);
}

template <class S>
Run<S> simulate(const Dumbbell<S>& body, State<S> state, Mass touching, std::size_t limit) {
    using std::abs;
    using std::sin;
    Run<S> run;
    S time = 0;
    for (;;) {
        const auto light = next_contact(body, Mass::light, state, touching == Mass::light);
        const auto heavy = next_contact(body, Mass::heavy, state, touching == Mass::heavy);
        if (!light.time && !heavy.time) {
            run.care.least_clearance =
                std::min(run.care.least_clearance, S(std::min(light.clearance, heavy.clearance)));
            break;
        }
        const Mass mass =
            light.time && (!heavy.time || *light.time < *heavy.time) ? Mass::light : Mass::heavy;
        const auto& first = mass == Mass::light ? light : heavy;
        const auto& second = mass == Mass::light ? heavy : light;
        // A clearance counts only where it was passed before the contact.
        run.care.least_clearance = std::min(run.care.least_clearance, first.clearance);
        if (!second.time) run.care.least_clearance = std::min(run.care.least_clearance, second.clearance);

        State<S> before = state;
        before.phi = state.phi + state.phidot * *first.time;
        before.y = -body.arm(mass) * sin(before.phi);  // on the floor exactly: no drift
        time += *first.time;
        const State<S> after = body.bounce(mass, before);
        run.collisions.push_back({time, mass, before, after});
        run.care.least_sine = std::min(run.care.least_sine, body.grazing_sine(mass, before));
        run.care.least_gap = std::min(run.care.least_gap, S(abs(body.height(other(mass), before))));
        if (run.collisions.size() > limit) throw std::runtime_error("oracle: too many collisions");
        state = after;
        touching = mass;
    }
    run.last = state;
    return run;
}

template <class S>
Total<S> total_collisions(const Dumbbell<S>& body, const Contact<S>& contact) {
    using std::abs;
    Total<S> total;
    ++(contact.mass == Mass::light ? total.light : total.heavy);
    total.care.least_sine = body.grazing_sine(contact.mass, contact.after);
    total.care.least_gap = abs(body.height(other(contact.mass), contact.after));
    // Reflection is an involution: the velocities before the contact are the reflected velocities after it.
    const State<S> before = body.bounce(contact.mass, contact.after);
    count(total, simulate(body, contact.after, contact.mass));
    count(total, simulate(body, reversed(before), contact.mass));
    return total;
}

template <class S>
Total<S> total_collisions(const Dumbbell<S>& body, const State<S>& flight) {
    Total<S> total;
    count(total, simulate(body, flight));
    count(total, simulate(body, reversed(flight)));
    return total;
}

template <class S>
std::vector<Collision<S>> whole_trajectory(const Dumbbell<S>& body, const Contact<S>& contact,
                                           bool with_earlier, bool with_later) {
    const State<S> before = body.bounce(contact.mass, contact.after);
    std::vector<Collision<S>> all;
    if (with_earlier) all = simulate(body, reversed(before), contact.mass).collisions;
    std::reverse(all.begin(), all.end());
    for (Collision<S>& collision : all) {
        collision.time = -collision.time;
        std::swap(collision.before, collision.after);
        collision.before = reversed(collision.before);
        collision.after = reversed(collision.after);
    }
    all.push_back({S(0), contact.mass, before, contact.after});
    if (!with_later) return all;
    const auto later = simulate(body, contact.after, contact.mass).collisions;
    all.insert(all.end(), later.begin(), later.end());
    return all;
}

#define DUMBBELL_ORACLE_INSTANTIATE(S)                                         \
    template void Care<S>::include(const Care<S>&);                            \
    template Run<S> simulate(const Dumbbell<S>&, State<S>, Mass, std::size_t); \
    template Total<S> total_collisions(const Dumbbell<S>&, const Contact<S>&); \
    template Total<S> total_collisions(const Dumbbell<S>&, const State<S>&);   \
    template std::vector<Collision<S>> whole_trajectory(const Dumbbell<S>&, const Contact<S>&, bool, bool);
DUMBBELL_ORACLE_INSTANTIATE(long double)
DUMBBELL_ORACLE_INSTANTIATE(Digits80)
#undef DUMBBELL_ORACLE_INSTANTIATE

}  // namespace dumbbell_oracle
