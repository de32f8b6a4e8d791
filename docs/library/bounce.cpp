// Encloses one bounce of the light mass, then certifies one mass ratio and has the independent verifier check
// it.
#include <dumbbell/bounce.hpp>
#include <dumbbell/certify.hpp>
#include <dumbbell/error.hpp>
#include <dumbbell/verify.hpp>
#include <iostream>

namespace db = dumbbell::api;

int main() try {
    const db::MassRatio q("10");
    std::cout.precision(17);
    // Every flight that leaves a light wall 0.1 to 0.1001 from the corner with slope 0.05.
    const db::Bounce bounce = db::enclose_bounce(q, db::ray_from_light_wall({0.1, 0.1001}, {0.05, 0.05}));
    if (bounce.outcome == db::Outcome::flies_on) {
        std::cout << "hits the other wall at [" << bounce.x.lo << ", " << bounce.x.hi
                  << "], flies on with slope [" << bounce.ray.kappa.lo << ", " << bounce.ray.kappa.hi
                  << "]\n";
    }

    const db::Proof proof = db::certify(q);
    save(proof, "ten.dbc");
    const db::Verification result = db::verify("ten.dbc", {.ratio = "10", .most = 4, .least = 4});
    std::cout << (result ? "verified: " : "not verified: ") << result.text << '\n';
    return result ? 0 : 1;
} catch (const db::InputError& error) {
    std::cerr << error.what() << '\n';
    return 2;
}
