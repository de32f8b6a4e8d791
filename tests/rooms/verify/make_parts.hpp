// Certificates that are verified in parts, for tests.
#pragma once
#include <optional>
#include <random>

#include "make_certificate.hpp"
#include "verify/program/combine.hpp"
#include "verify/program/examine.hpp"
#include "verify/program/summary.hpp"

namespace make {

using dumbbell_verify::all_pieces;
using dumbbell_verify::Job;
using dumbbell_verify::Pieces;
using dumbbell_verify::Verdict;

/// Of a shipped certificate, or one of tests/attacks/false_claims.
inline std::string shipped(const std::string& name) { return DUMBBELL_PROJECT "/certificates/" + name; }
inline const std::string stairs_to_100 = shipped("stairs-1-100.dbc");
inline constexpr std::uint64_t stairs_pieces = 17;
inline std::string contents(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

inline Job job_for(const std::string& path, const std::string& scene = "dumbbell") {
    Job job{path, {}};
    job.settings.scene = scene;
    return job;
}
inline std::string last_line(const Job& job) { return verdict_line(examine(job)); }

/// What the whole file is said to be.
inline std::string whole(const std::string& path, const std::string& scene = "dumbbell") {
    return last_line(job_for(path, scene));
}
/// What --shards prints of these pieces.
inline std::string shard(const std::string& path, const Pieces& pieces, unsigned precision = 0,
                         const std::string& scene = "dumbbell") {
    Job job = job_for(path, scene);
    job.settings.check = job.settings.demand.keep = pieces;
    job.settings.precision = precision;
    return last_line(job);
}
/// What --combine prints; PARTS has these bytes.
inline std::string combined(const std::string& path, const std::string& lines, unsigned precision = 0,
                            const std::string& scene = "dumbbell") {
    const File parts(lines);
    Job job = job_for(path, scene);
    job.parts = parts.path();
    job.settings.check = {};
    job.settings.demand.keep = all_pieces;
    job.settings.precision = precision;
    std::string line = last_line(job);
    if (const std::size_t at = line.find(parts.path()); at != std::string::npos)
        line.replace(at, parts.path().size(), "PARTS");
    return line;
}

/// 1 to n, cut at random places; none is empty.
inline std::vector<Pieces> random_cut(std::uint64_t n, std::mt19937& random) {
    std::vector<Pieces> parts;
    const std::uint64_t longest = 1 + random() % n;
    for (std::uint64_t first = 1; first <= n; first = parts.back().last + 1)
        parts.push_back({first, std::min<std::uint64_t>(n, first + random() % longest)});
    return parts;
}

/// Four pieces: two without a cover in the middle, the last one closed at one ratio.
inline const std::string& four_pieces() {
    static const auto open = [](const std::string& a, const std::string& b) {
        return "piece " + a + " " + b + "\nbits 53\nupper none\nlower 0\n";
    };
    static const std::string text =
        closed(header("10/1", "12/1", 4) + piece(10, mpq_class(21, 2), 4, 0, "") + open("21/2", "11/1") +
               open("11/1", "12/1") + piece(12, 12, 5, 0, ""));
    return text;
}

}  // namespace make
