#include "collisions/piece_store.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/error.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "collisions/writer.hpp"
#include "file/atomic_file.hpp"
#include "file/file_contents.hpp"
#include "file/sha256.hpp"

namespace dumbbell::collisions {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view first_line = "dumbbell-partial 1\n";

std::string text_of(const Claim& claim) {
    const SectionRow& row = row_of(claim.system.section);
    const auto& rho = claim.system.rho;
    return fmt::format("{}generator dumbbell {}\nscene {}\nsection {}\nratio {} {}\n{}gap {}\n", first_line,
                       DUMBBELL_VERSION, row.scene, row.section, to_fraction(claim.range.lo),
                       to_fraction(claim.range.hi),
                       rho ? fmt::format("rho {0} {0}\n", to_fraction(*rho)) : "", to_fraction(claim.gap));
}

constexpr std::size_t name_length = 32;  // of a piece, without extension

bool is_piece(const fs::directory_entry& entry) { return entry.path().extension() == ".dbc"; }

[[noreturn]] void is_in_the_way(const std::string& folder) {
    throw InputError(
        fmt::format("'{}' is in the way: it is not a folder with the finished pieces of a run; remove it, "
                    "or use another --out",
                    folder));
}

[[noreturn]] void holds_another_run(const std::string& folder) {
    throw InputError(
        fmt::format("'{}' holds the finished pieces of another run (see its file 'claim'): repeat that run, "
                    "remove the folder, or use another --out",
                    folder));
}

}  // namespace

PieceStore::PieceStore(std::string folder, const Claim& claim)
    : folder_(std::move(folder)), claim_(claim), text_(text_of(claim)) {
    std::error_code failed;
    if (fs::exists(fs::symlink_status(folder_, failed)) && !fs::is_directory(folder_, failed)) {
        is_in_the_way(folder_);
    }
    fs::create_directory(folder_, failed);
    if (failed) {
        throw InputError(fmt::format("cannot make the folder '{}': {}", folder_, failed.message()));
    }
    if (!lock_.take(folder_)) {
        throw InputError(
            fmt::format("'{}' is in use by another run: wait for it, or use another --out", folder_));
    }
    const std::string file = folder_ + "/claim";
    const fs::file_type type = fs::symlink_status(file).type();
    const bool is_file = type == fs::file_type::regular, is_missing = type == fs::file_type::not_found;
    const std::string found = is_file ? file_contents(file) : "";
    if (found != text_) {
        if ((!is_file && !is_missing) || !has_no_others_pieces(found)) {
            is_missing ? is_in_the_way(folder_) : holds_another_run(folder_);
        }
        write_atomically(file, text_);
    }
}

/// Whether the folder, with this in its file `claim`, is one of finished pieces in which whatever is whole
/// belongs to this store: then it is new, its claim is damaged, or nothing was finished for another one.
bool PieceStore::has_no_others_pieces(const std::string& claim) const {
    bool has_own = false;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        const std::string name = entry.path().filename().string();
        const bool is_temporary = name.ends_with(temporary_name(""));
        if (name == "claim" || is_temporary) {
            continue;
        }
        if (!is_piece(entry) || !entry.is_regular_file() ||
            entry.path().stem().string().size() != name_length) {
            return false;
        }
        const auto& [damaged, piece] = kept_in(entry.path().string());
        if (damaged) {
            continue;  // nobody's
        }
        if (!piece || entry.path() != file_of(planned_as(*piece))) {
            return false;
        }
        has_own = true;
    }
    return has_own || claim.empty() || claim.starts_with(first_line);
}

PieceStore::~PieceStore() {
    std::error_code ignored;
    const fs::directory_iterator entries(folder_, ignored);
    if (!ignored && std::none_of(begin(entries), end(entries), is_piece)) {
        remove();
    }
}

void PieceStore::require_none(const std::string& folder) {
    if (fs::exists(folder)) {
        holds_another_run(folder);
    }
}

std::string PieceStore::file_of(const PlannedPiece& planned) const {
    const std::string digest = sha256_hex(text_ + words_of(planned) + "\n");
    return fmt::format("{}/{}.dbc", folder_, digest.substr(0, name_length));
}

PieceStore::Kept PieceStore::kept_in(const std::string& file) const {
    if (!sealed_lines(file_contents(file))) {
        return {true, std::nullopt};
    }
    try {
        Certificate kept = read_certificate(file);
        const bool fits =
            kept.pieces.size() == 1 && kept.pieces.front().upper && kept.system == claim_.system;
        return {false, fits ? std::optional(std::move(kept.pieces.front())) : std::nullopt};
    } catch (const InputError&) {
        return {false, std::nullopt};  // a right checksum under something else
    }
}

std::optional<Piece> PieceStore::find(const PlannedPiece& planned, Observer& observer) const {
    const std::string file = file_of(planned);
    if (!fs::exists(file)) {
        return std::nullopt;
    }
    if (!fs::is_regular_file(file)) {  // which a reader might wait for
        throw InputError(fmt::format("'{}' is in the way: it is not a file; remove it, and try again", file));
    }
    auto piece = kept_in(file).piece;
    if (!piece || planned_as(*piece) != planned) {
        observer.note(fmt::format("'{}' is damaged: its piece is proved again", file));
        return std::nullopt;
    }
    return piece;
}

std::vector<Piece> PieceStore::kept() const {
    std::vector<Piece> kept;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_)) {
        if (!is_piece(entry) || !entry.is_regular_file()) {
            continue;
        }
        auto piece = kept_in(entry.path().string()).piece;
        if (piece && entry.path() == file_of(planned_as(*piece))) {
            kept.push_back(std::move(*piece));
        }
    }
    std::sort(kept.begin(), kept.end(), [](const Piece& a, const Piece& b) {
        return a.q_lo < b.q_lo || (a.q_lo == b.q_lo && a.q_hi < b.q_hi);
    });
    return kept;
}

std::vector<Piece> PieceStore::beginning() const {
    std::vector<Piece> kept = this->kept();
    // Where a step is known exactly a plan may begin with a piece for that ratio alone: the next piece begins
    // there too, and does not show that it is missing.
    const Rational& begin = claim_.range.lo;
    const bool may_begin_with_one_ratio = begin == 1 || begin == staircase_of(claim_.system).exact_step;
    if (may_begin_with_one_ratio && !kept.empty() && kept.front().q_lo < kept.front().q_hi) {
        return {};
    }
    Rational reached = begin;
    const auto end = std::find_if(kept.begin(), kept.end(), [&](const Piece& piece) {
        return piece.q_lo != std::exchange(reached, piece.q_hi);
    });
    kept.erase(end, kept.end());
    while (!kept.empty() && kept.back().status() == Status::exact && kept.back().q_hi < claim_.range.hi) {
        kept.pop_back();
    }
    return kept;
}

void PieceStore::keep(const Piece& piece) const {
    const Certificate alone{.pieces = {piece}, .system = claim_.system};
    // Not synced: thousands of small pieces would spend their time waiting for the disk, and one that a crash
    // of the machine damages is recognized by its checksum.
    write_atomically(file_of(planned_as(piece)), render(alone).text, Survives::program);
}

std::size_t PieceStore::size() const {
    std::error_code ignored;
    const fs::directory_iterator entries(folder_, ignored);
    return static_cast<std::size_t>(std::count_if(begin(entries), end(entries), is_piece));
}

void PieceStore::remove() {
    std::error_code ignored;
    // The claim last: should the program be killed here, what is left is still a folder of this run.
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_, ignored)) {
        if (entry.path().filename() != "claim") {
            fs::remove_all(entry, ignored);
        }
    }
    fs::remove_all(folder_, ignored);
}

}  // namespace dumbbell::collisions
