#include "verify/program/combine.hpp"

#include <algorithm>

#include "verify/format/text.hpp"

namespace dumbbell_verify {
namespace {

[[noreturn]] void reject(const std::string& text) { throw Failure{Verdict::rejected, 0, "parts", text}; }

std::string named(const Pieces& pieces) {
    const std::string first = std::to_string(pieces.first), last = std::to_string(pieces.last);
    return first == last ? "piece " + first : "pieces " + first + "-" + last;
}

/// Whether the line is what must be printed of its pieces; where it is not, the first value that differs is
/// told.
void require_same(const PartLine& line, const Proof& proof, const Settings& settings, const PieceSums& sums,
                  const std::string& where) {
    if (line.values[digest_field] != proof.digest)
        reject(where + ": about another file, with the SHA-256 " + std::string(line.values[digest_field]) +
               "; this one has " + proof.digest);
    if (line.pieces.last > proof.claim.pieces)
        reject(where + ": " + named(line.pieces) + ", but the file has only " +
               std::to_string(proof.claim.pieces));
    Settings checked = settings;
    checked.precision = line.precision;
    const Part part = part_of(proof, checked, sums, line.pieces);
    if (line.text == part_text(part)) return;
    const Fields right = fields(part);
    for (std::size_t i = 0; i < right.size(); ++i)
        if (line.values[i] != right[i].value)
            reject(where + ": " + std::string(right[i].name) + "=" +
                   std::string(line.values[i].substr(0, 60)) + ", but the file has " +
                   right[i].value.substr(0, 60) + " for " + named(line.pieces));
    reject(where + ": not as dumbbell-verify --shards prints it");
}

/// What no part has of the pieces 1 to `of`: the first hole, and how many pieces in all.
void require_tiling(const std::vector<Pieces>& parts, std::uint64_t of) {
    Pieces hole;
    std::uint64_t next = 1, missing = 0;
    const auto arrive = [&](const Pieces& part) {
        if (part.first > next) {
            if (missing == 0) hole = {next, part.first - 1};
            missing += part.first - next;
        }
        next = std::max(next, part.last + 1);
    };
    for (const Pieces& part : parts) arrive(part);
    arrive({of + 1, of + 1});
    if (missing == 0) return;
    const bool one = hole == Pieces{hole.first, hole.first};
    reject(named(hole) + (one ? " is" : " are") + " not verified by any part" +
           (missing > hole.last - hole.first + 1 ? "; " + std::to_string(missing) + " pieces in all" : ""));
}

void sort_out(std::vector<Pieces>& parts) {
    std::sort(parts.begin(), parts.end(), [](const Pieces& a, const Pieces& b) {
        return std::pair(a.first, a.last) < std::pair(b.first, b.last);
    });
    parts.erase(std::unique(parts.begin(), parts.end()), parts.end());
}

}  // namespace

std::uint64_t combine(PartLines& lines, const Proof& proof, const Settings& settings) {
    const PieceSums sums(proof.claim);
    std::vector<Pieces> parts;
    std::size_t many = 1024;
    while (const PartLine* line = lines.next()) {
        require_same(*line, proof, settings, sums, lines.where());
        if (line->precision < settings.precision)
            reject(lines.where() + ": " + named(line->pieces) + " checked without --precision " +
                   std::to_string(settings.precision));
        parts.push_back(line->pieces);
        if (parts.size() < many) continue;
        sort_out(parts);  // the same again costs no memory
        many = 2 * parts.size() + 1024;
    }
    sort_out(parts);
    require_tiling(parts, proof.claim.pieces);
    return parts.size();
}

}  // namespace dumbbell_verify
