#include "commands/plot_pictures.hpp"

#include <fmt/core.h>

#include <filesystem>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "base/error.hpp"
#include "cli/commands/verify.hpp"
#include "cli/terminal/standard_input.hpp"
#include "collisions/cell_reader.hpp"
#include "collisions/certify.hpp"
#include "collisions/reader.hpp"
#include "collisions/section.hpp"
#include "number/decimal.hpp"
#include "number/ratio_argument.hpp"
#include "page/any_certificate.hpp"
#include "pictures/body_map.hpp"
#include "pictures/orbit.hpp"
#include "pictures/phase.hpp"
#include "pictures/staircase.hpp"

namespace dumbbell::cli {

using collisions::Certificate;
using collisions::Piece;

namespace {

const Rational greatest_drawn_ratio = 100'000'000;  // about 9,000 collisions

const char* what_it_is(const page::AnyCertificate& certificate) {
    return std::holds_alternative<Certificate>(certificate) ? "about mass ratios (dumbbell certify)"
           : std::holds_alternative<starts::Certificate>(certificate)
               ? "about initial conditions (dumbbell trace)"
               : "about the adiabatic invariant";
}

/// The certificate, if it is of this kind. Throws InputError, saying what to run (`make`), if it is of
/// another.
template <class Kind>
Kind certificate_for(const std::string& file, const char* picture, const char* make) {
    page::AnyCertificate any = page::read_any_certificate(file);
    Kind* certificate = std::get_if<Kind>(&any);
    if (certificate == nullptr) {
        throw InputError(fmt::format("'{}' is {}; plot {} needs a certificate by {}", file, what_it_is(any),
                                     picture, make));
    }
    return std::move(*certificate);
}

/// The mass ratio that is asked for, or the only one that there is.
Rational ratio_of(const std::string& asked, const std::string& file, const Certificate& certificate) {
    if (asked.empty()) {
        if (certificate.q_lo() != certificate.q_hi()) {
            throw InputError(
                fmt::format("'{}' is about the mass ratios {} to {}: choose one of them with --ratio", file,
                            exact_text(certificate.q_lo()), exact_text(certificate.q_hi())));
        }
        return certificate.q_lo();
    }
    const RatioArgument ratio = parse_ratio_argument(asked);
    if (ratio.lo != ratio.hi) {
        throw InputError("--ratio takes a single mass ratio");
    }
    return ratio.lo;
}

/// The piece with the mass ratio; of two that share it one that is decided. Throws InputError if there is
/// none.
const Piece& piece_at(const std::string& file, const Certificate& certificate, const Rational& q) {
    const Piece* found = nullptr;
    for (const Piece& piece : certificate.pieces) {
        if (piece.q_lo <= q && q <= piece.q_hi &&
            (found == nullptr || piece.status() == collisions::Status::exact)) {
            found = &piece;
        }
    }
    if (found == nullptr) {
        throw InputError(fmt::format("'{}' says nothing about the mass ratio {}", file, exact_text(q)));
    }
    return *found;
}

/// Then it is drawn.
void require_verified(const std::string& file, const std::string& sha256, Observer& observer,
                      const collisions::System& system = {}) {
    (void)verified(file, sha256, system, observer);
    observer.enter("drawing", "");
}

/// One with orbits of the dumbbell.
Certificate verified_dumbbell(const std::string& file, Observer& observer) {
    auto certificate = certificate_for<Certificate>(file, "orbit", "dumbbell certify RATIO --out FILE");
    const collisions::SectionRow& row = row_of(certificate.system.section);
    if (!row.has_orbits) {
        throw InputError(
            fmt::format("'{}' is about the scene {}: plot orbit draws the dumbbell", file, row.scene));
    }
    require_verified(file, certificate.sha256, observer, certificate.system);
    return certificate;
}

/// The mass ratios, unless it is the name of a file. Throws InputError if it is neither, but begins like a
/// number.
std::optional<RatioArgument> ratios_of(const std::string& text) {
    try {
        return parse_ratio_argument(text);
    } catch (const InputError&) {
        const bool like_number = text.find_first_of("0123456789") <= 1;  // -1 and .5, too
        if (like_number && !std::filesystem::exists(text)) {
            throw;
        }
        return std::nullopt;
    }
}

/// Proves the greatest number of collisions at one mass ratio.
Piece proved_piece(const Rational& q, Observer& observer) {
    observer.enter("proving", "boxes");
    collisions::CertifyRequest single;
    single.claim.range = {q, q};
    single.observer = &observer;
    std::vector<collisions::ProvedPiece> pieces = certify(single);
    return std::move(pieces.front().piece);
}

}  // namespace

std::string draw_staircase(const Given& given, Observer& observer) {
    const std::string file = input_file(given.text("FILE"));
    const auto certificate =
        certificate_for<Certificate>(file, "staircase", "dumbbell certify LO:HI --out FILE");
    if (certificate.system.rho) {
        throw InputError(
            fmt::format("'{}' is about rigid bodies: a staircase is drawn of mass ratios", file));
    }
    if (certificate.q_lo() == certificate.q_hi()) {
        throw InputError("a staircase needs a range of mass ratios: this certificate holds a single one");
    }
    require_verified(file, certificate.sha256, observer, certificate.system);
    return pictures::staircase_svg(certificate);
}

std::string draw_orbit(const Given& given, Observer& observer) {
    const std::string file = input_file(given.text("FILE"));
    const std::string asked = given.text("--ratio");
    Piece piece;
    Rational q;
    if (const auto ratio = ratios_of(file)) {
        if (ratio->lo != ratio->hi || !asked.empty()) {
            throw InputError(
                "an orbit has one mass ratio: plot orbit RATIO, or plot orbit FILE --ratio RATIO");
        }
        q = ratio->lo;
        if (q > greatest_drawn_ratio) {
            throw InputError("beyond the mass ratio 10^8 an orbit has too many collisions for a picture");
        }
        piece = proved_piece(q, observer);
        observer.enter("drawing", "");
    } else {
        const Certificate certificate = verified_dumbbell(file, observer);
        q = ratio_of(asked, file, certificate);
        piece = piece_at(file, certificate, q);
    }
    return pictures::orbit_svg(piece, q);
}

std::string draw_phase(const Given& given, Observer& observer) {
    const std::string file = input_file(given.text("FILE"));
    const auto certificate = certificate_for<starts::Certificate>(
        file, "phase", "dumbbell trace RATIO ... --subdivide --out FILE");
    require_verified(file, certificate.sha256, observer);
    return pictures::phase_svg(certificate);
}

std::string draw_bodies(const Given& given, Observer& observer) {
    const std::string file = input_file(given.text("FILE"));
    const collisions::CellFile read = collisions::read_cells(file);
    require_verified(file, read.sha256, observer, collisions::Section::body);
    return pictures::body_map_svg(read.cells);
}

}  // namespace dumbbell::cli
