// The folder of finished pieces: any piece that is kept is found again, as it was; with any bytes in its
// file, or in the file `claim`, there is that piece, or none, or one message for the user.
#include <algorithm>

#include "base/error.hpp"
#include "certificates.hpp"
#include "collisions/piece_store.hpp"
#include "collisions/section.hpp"
#include "collisions/writer.hpp"
#include "file/sha256.hpp"
#include "target.hpp"
#include "temporary_folder.hpp"

namespace {

using namespace dumbbell_fuzz;
using namespace dumbbell;
using namespace dumbbell::collisions;
using dumbbell_test::contents, dumbbell_test::write_file;
namespace fs = std::filesystem;

/// A mass ratio of the command line: up to 1,000 digits after the point.
Rational any_ratio(Choices& choices) {
    const std::size_t digits = choices.below(4) == 0 ? choices.below(999) : choices.below(20);
    std::string text = std::to_string(1 + choices.below(1000)) + ".";
    for (std::size_t i = 0; i < digits; ++i)
        text += i % 7 == 3 ? static_cast<char>('0' + choices.below(10)) : '5';
    return parse_rational(text.substr(0, 999) + "1");
}

Rational any_dyadic(Choices& choices) {
    return Rational(static_cast<long>(choices.below(65536))) * power_of_two(choices.between(-300, 300));
}

/// A piece as the program may have it: what it says need not be true.
Piece any_piece(Choices& choices, const Claim& claim) {
    Piece piece;
    piece.q_lo = any_ratio(choices);
    piece.q_hi = std::max(piece.q_lo, any_ratio(choices));
    piece.bits = choices.coin() ? 53 : static_cast<int>(choices.between(53, 4096));
    piece.upper = choices.between(1, 20);
    for (const Chart chart : row_of(claim.system.section).charts) {
        piece.cover.charts.push_back({chart, {}});
        grow_any_tree(choices, 12, piece.cover.charts.back().tree);
    }
    piece.lower = choices.between(0, as_long(*piece.upper));
    if (piece.lower > 0) {
        const Rational e = any_dyadic(choices);
        piece.witness = Witness{e, any_dyadic(choices), choices.between(0, 20), choices.between(0, 20)};
    }
    return piece;
}

Claim any_claim(Choices& choices) {
    constexpr Section sections[] = {Section::turning, Section::full, Section::plain};
    return {.range = {1, 1000}, .system = {sections[choices.below(3)]}, .gap = Rational(1, 1000)};
}

/// As text: the one spelling, so that equal text is equal data.
std::string text_of(const Piece& piece, const Claim& claim) {
    return render({{"test", "1"}, {piece}, claim.system}).text;
}

fs::path file_of_piece(const fs::path& folder) {
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".dbc") return entry.path();
    trap("no file of the piece that was kept");
}

/// The rest of the input, in place of the text or of a part of it; mostly with a checksum that fits.
std::string damaged(const std::string& whole, Choices& choices) {
    std::string text = whole.substr(0, whole.rfind("sha256 "));
    const bool checksum = choices.below(4) > 0;
    const std::size_t at = choices.coin() ? choices.below(std::min<std::size_t>(text.size(), 65536)) : 0;
    const std::string bytes = choices.rest();
    text.replace(at, at == 0 ? text.size() : bytes.size(), bytes);
    return checksum ? text + "sha256 " + sha256_hex(text) + "\n" : text;
}

bool opens(const fs::path& folder, const Claim& claim) {
    try {
        const PieceStore store(folder.string(), claim);
        return true;
    } catch (const InputError&) {
        return false;
    }
}

void check_find(const PieceStore& store, const Piece& piece, const Claim& claim, bool must_be_there) {
    const auto found = store.find({piece.q_lo, piece.q_hi, as_long(*piece.upper), as_long(piece.lower)});
    must(found.has_value() || !must_be_there, "a piece that was kept is found");
    if (!found) return;
    must(found->q_lo == piece.q_lo && found->q_hi == piece.q_hi && found->upper == piece.upper &&
             found->lower == piece.lower,
         "a piece that is found is the one that was asked for");
    const std::string text = text_of(*found, claim);
    must(!must_be_there || text == text_of(piece, claim), "a piece that is found is as it was");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const dumbbell_test::TemporaryFolder scratch;
    const fs::path folder = scratch / "pieces";
    Choices choices(data, size);
    const bool whole = choices.coin();
    const Claim claim = any_claim(choices);
    const Piece piece = any_piece(choices, claim);
    {
        const PieceStore store(folder.string(), claim);
        store.keep(piece);
        check_find(store, piece, claim, true);
        if (!whole) {
            write_file(file_of_piece(folder), damaged(text_of(piece, claim), choices));
            check_find(store, piece, claim, false);
        }
    }
    const std::string own = contents(folder / "claim"), other = whole ? own : choices.rest();
    write_file(folder / "claim", other);
    const bool open = opens(folder, claim);
    must(open || other != own, "a folder opens for its own claim");
    must(contents(folder / "claim") == (open ? own : other), "a damaged claim is made again, or left alone");
    if (whole) {
        Claim another = claim;
        another.range.hi += 1;
        must(!opens(folder, another), "a folder that has a piece of one claim is not another's");
    }
    fs::remove_all(folder);
    return 0;
}
