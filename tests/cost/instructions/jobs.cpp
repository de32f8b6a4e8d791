// Small fixed jobs, one a call, in one thread: what tests/cost/instructions/run counts the instructions of.
// usage: instruction_jobs JOB

#include <cstdio>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "collisions/certify.hpp"
#include "critical/enclose.hpp"
#include "flight/count.hpp"

using namespace dumbbell;
using namespace dumbbell::collisions;
using namespace dumbbell::flight;

namespace {

/// Proves it; gives the number of pieces.
std::size_t pieces(const Rational& q_lo, const Rational& q_hi, Section section = Section::turning) {
    return certify({.claim = {.range = {q_lo, q_hi}, .system = {section}}}).size();
}

/// The sum of the bounds on the counts of 8192 rays, flat to steep, at the ratio 1000.
template <class Count>
std::size_t counts(const Count& count) {
    std::size_t sum = 0;
    for (int i = 0; i < 8192; ++i) {
        const Ray<Interval> ray{Interval(i * 0x1p-14), Interval((i - 4096) * 0x1p-24), Interval(0x1p-10)};
        sum += static_cast<std::size_t>(count(ray));
    }
    return sum;
}

const std::map<std::string, std::function<std::size_t()>> jobs = {
    {"start", [] { return std::size_t{1}; }},
    {"counts-at-most",
     [] { return counts([](const auto& ray) { return count_at_most<Interval>(ray, 1000); }); }},
    {"counts-at-least",
     [] { return counts([](const auto& ray) { return count_at_least<Interval>(ray, 1000); }); }},
    {"certify-1e6", [] { return pieces(1'000'000, 1'000'000); }},
    {"certify-1:20", [] { return pieces(1, 20); }},
    {"certify-100-full", [] { return pieces(100, 100, Section::full); }},
    {"critical-7",
     [] {
         critical::Options options;
         options.digits = 50;
         return static_cast<std::size_t>(critical::enclose_ratio(7, options).has_value());
     }},
};

}  // namespace

int main(int argc, char** argv) {
    const auto job = jobs.find(argc == 2 ? argv[1] : "");
    if (job == jobs.end()) {
        std::fputs("usage: instruction_jobs JOB, with JOB one of", stderr);
        for (const auto& [name, run] : jobs) {
            std::fprintf(stderr, " %s", name.c_str());
        }
        std::fputs("\n", stderr);
        return 2;
    }
    const std::size_t result = job->second();
    std::printf("%zu\n", result);
    return result == 0 ? 1 : 0;
}
