// What --explain shows.
#include <cstdio>

#include "verify/core/outside.hpp"
#include "verify/core/section.hpp"

namespace dumbbell_verify {
namespace {

std::string text_of(const Interval<double>& x) {
    char text[80];
    std::snprintf(text, sizeof text, x.lo < x.hi ? "[%.17g, %.17g]" : "%.17g", x.lo, x.hi);
    return text;
}
std::string text_of(Log::Line numbers) {
    std::string text;
    for (const Log::Shown& shown : numbers) text += shown.name + text_of(shown.number);
    return text;
}

}  // namespace

void Log::box(const Leaf& leaf, const Chart& chart, long bits) {
    text += "  " + std::to_string(bits) + " bits, claimed " + leaf.claimed.get_str() + "\n";
    for (std::size_t i = 0; i < chart.axes.size(); ++i) {
        const mpq_class &lo = leaf.box.lo[i], &hi = leaf.box.hi[i];
        text += "  " + std::string(chart.axes[i]) + " in [" + lo.get_str() + ", " + hi.get_str() +
                "] within " + text_of({bound(down, lo, 0.0), bound(up, hi, 0.0)}) + "\n";
    }
}
void Log::line(Line numbers) { text += text_of(numbers) + "\n"; }

/// Of the rays before it the first twenty lines and the last twenty.
void Log::fact(const char* what, bool holds) {
    if (ray_.size() > 40) ray_.erase(ray_.begin() + 20, ray_.end() - 20);
    for (const std::string& line : ray_) text += line + "\n";
    ray_.clear();
    text += std::string("  ") + what + (holds ? ": holds\n" : ": does NOT hold\n");
}
void Log::ray(const mpz_class& collisions, Line numbers) {
    if (collisions == 0) ray_.clear();  // it begins, perhaps once more
    ray_.push_back("    " + collisions.get_str() + text_of(numbers));
}
void Log::there(Line numbers) {
    if (!ray_.empty()) ray_.back() += text_of(numbers);
}
void Log::leap(const mpz_class& collisions) {
    ray_.push_back("    " + collisions.get_str() + " collisions by L42");
}
void Log::show(bool certified) {
    std::fputs((text + (certified ? "  certified\n" : "  NOT certified\n")).c_str(), stdout);
}

}  // namespace dumbbell_verify
