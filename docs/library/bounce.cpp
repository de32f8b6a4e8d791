// Encloses the bounces of one start, then certifies one mass ratio and has the independent verifier check it.
#include <dumbbell/certify.hpp>
#include <dumbbell/error.hpp>
#include <dumbbell/trace.hpp>
#include <dumbbell/verify.hpp>
#include <iostream>

namespace db = dumbbell::api;

int main() try {
    const db::MassRatio q("10");
    std::cout.precision(17);
    for (const db::Collision& c : db::trace(q, {"-1.4", "1", "1", "-0.8"}).collisions) {
        std::cout << (c.heavy ? "heavy" : "light") << " mass at time [" << c.time.lo << ", " << c.time.hi
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
