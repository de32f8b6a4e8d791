#include "file_text.hpp"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "rooms/verify/wings/starts/make_file.hpp"

namespace dumbbell_fuzz {
namespace {

struct Inflation {
    z_stream stream{};
    Inflation() {
        if (inflateInit2(&stream, 15 + 16) != Z_OK) throw std::bad_alloc();
    }
    ~Inflation() { inflateEnd(&stream); }
    Inflation(const Inflation&) = delete;
    Inflation& operator=(const Inflation&) = delete;
};

/// The greatest mass ratio that a line `ratio` or `piece` names, roughly; infinite if it is too long to say.
double greatest_ratio(const std::string& text) {
    double greatest = 1;
    std::istringstream in(text);
    for (std::string line; std::getline(in, line);) {
        if (!line.starts_with("ratio ") && !line.starts_with("piece ")) continue;
        for (std::size_t at = line.find(' '); at != std::string::npos; at = line.find(' ', at + 1)) {
            const std::size_t slash = line.find('/', at);
            const double top = std::strtod(line.c_str() + at, nullptr);
            const double bottom =
                slash == std::string::npos ? 1 : std::strtod(line.c_str() + slash + 1, nullptr);
            const double ratio = top / std::max(bottom, 1.0);
            if (!(ratio <= greatest)) greatest = std::isnan(ratio) ? HUGE_VAL : ratio;
        }
    }
    return greatest;
}

}  // namespace

bool is_gzip(std::string_view bytes) { return bytes.starts_with("\x1f\x8b"); }

std::optional<std::string> plain_text(const std::string& bytes, std::size_t most) {
    if (!is_gzip(bytes)) return bytes.size() <= most ? std::optional(bytes) : std::nullopt;
    Inflation inflation;
    std::string in = bytes, out(most + 1, '\0');
    inflation.stream.next_in = reinterpret_cast<Bytef*>(in.data());
    inflation.stream.avail_in = static_cast<uInt>(in.size());
    inflation.stream.next_out = reinterpret_cast<Bytef*>(out.data());
    inflation.stream.avail_out = static_cast<uInt>(out.size());
    inflate(&inflation.stream, Z_FINISH);
    if (inflation.stream.total_out > most) return std::nullopt;
    out.resize(inflation.stream.total_out);
    return out;
}

std::string value_of(std::string_view text, std::string_view keyword) {
    const std::string start = "\n" + std::string(keyword) + " ";
    const std::size_t at = text.find(start);
    if (at == std::string_view::npos) return "";
    const std::string_view rest = text.substr(at + start.size());
    return std::string(rest.substr(0, rest.find_first_of(" \n")));
}

bool is_little_work(const std::string& text) {
    if (value_of(text, "claim").starts_with("adiabatic-")) return true;  // the verifier's own budget
    // In about a microsecond each, without sanitizers.
    constexpr double most_steps = 50'000;
    const auto lines = static_cast<double>(std::count(text.begin(), text.end(), '\n'));
    const double q = greatest_ratio(text), ray = 10 + std::sqrt(q);
    const std::string section = value_of(text, "section");
    double leaf = ray;
    if (section == "full") leaf = 10 * q;           // every step of a flight may begin a ray
    if (section == "none") leaf = 1000 + 64 * ray;  // spans, and rays off the first steps
    const double multiple = text.find("\nbits 53\n") == std::string::npos ? 20 : 1;
    return lines * leaf * multiple <= most_steps;
}

std::string with_fitting_trailer(const std::string& text) {
    const std::size_t totals = text.find("\ntotal ");
    std::string body = text.substr(0, totals == std::string::npos ? text.find("\nsha256 ") : totals);
    if (!body.ends_with('\n')) body += '\n';
    return make::closed(body);
}

}  // namespace dumbbell_fuzz
