// Any bytes as a file for the verifier: they get a verdict; what it accepts is true, is accepted plain and
// compressed, with its own claim as the demand but with no stronger one, and has the one canonical spelling.
#include <algorithm>
#include <cmath>
#include <new>

#include "adiabatic/writer.hpp"
#include "choices.hpp"
#include "collisions/reader.hpp"
#include "collisions/writer.hpp"
#include "file_text.hpp"
#include "page/any_certificate.hpp"
#include "rooms/verify/core/make_certificate.hpp"
#include "scratch.hpp"
#include "start_truth.hpp"
#include "starts/answer/writer.hpp"
#include "target.hpp"
#include "truth.hpp"
#include "verify/program/verify.hpp"
#include "verify/wings/adiabatic/claim.hpp"
#include "verify/wings/adiabatic/grammar.hpp"
#include "verify/wings/starts/claim.hpp"

namespace {

using namespace dumbbell_fuzz;
using dumbbell_verify::Collisions, dumbbell_verify::Failure, dumbbell_verify::Verified,
    dumbbell_verify::Request, dumbbell_verify::Verdict;

constexpr unsigned most_bits = 128;  ///< more are refused, as by --max-bits: each bit costs time

/// The failure's message comes from the verifier, not from the standard library.
void must_be_meant(const Failure& failure) {
    if (failure.text.find("::") != std::string::npos || failure.text.starts_with("sto"))
        trap("a verdict by accident: " + failure.text);
}

/// What the verifier makes of a file; nothing if it does not accept it. Other exceptions end the program.
std::optional<Verified> proof_of(const std::string& bytes, const Request& settings) {
    static MemoryFile file;
    try {
        return dumbbell_verify::verify(file.holding(bytes), settings);
    } catch (const Failure& failure) {
        must(failure.verdict != Verdict::verified, "a failure is none");
        must_be_meant(failure);
    } catch (const std::bad_alloc&) {
    }
    return std::nullopt;
}

bool is_accepted(const std::string& bytes, Request settings, const Collisions& demand) {
    settings.demand = demand;
    return proof_of(bytes, settings).has_value();
}

/// Others only the verifiers read.
bool is_of_one_rho(const Collisions& claim) { return !claim.rho || claim.rho->first == claim.rho->second; }

void check_claim(const Verified& proof, const std::string& text, const Request& settings) {
    const Collisions& claim = proof.claim;
    static MemoryFile file;
    const auto read = dumbbell::collisions::read_certificate(file.holding(text));
    const auto& pieces = read.pieces;
    must(mpq_class(read.q_lo().raw()) == claim.lo && mpq_class(read.q_hi().raw()) == claim.hi,
         "the pieces are the claim");
    for (const auto& piece : pieces) must_be_true(piece, read.system.rho);

    Collisions demand;
    demand.ratios.emplace(claim.lo, claim.hi);
    demand.least = claim.lower;
    demand.most = claim.upper;
    must(is_accepted(text, settings, demand), "accepted with its own claim as the demand");
    // A single ratio between two pieces is covered by them, too: whether it counts is their affair.
    if (pieces.size() == 1 || std::ranges::none_of(pieces, [](const auto& p) { return p.q_lo == p.q_hi; })) {
        demand.least = claim.lower + 1;
        must(!is_accepted(text, settings, demand), "refused if more collisions are demanded");
        demand.least.reset();
        demand.most = claim.upper ? std::max(*claim.upper, mpz_class(1)) - 1 : mpz_class(1'000'000);
        must(!is_accepted(text, settings, demand), "refused if fewer collisions are demanded");
    }
    demand.least.reset();
    demand.most.reset();
    demand.ratios->second += 1;
    must(!is_accepted(text, settings, demand), "refused if more ratios are demanded");
}

/// A start of the section of all incoming trajectories: format-initial.md, section 8.
Start coming_in(const Start& point) {
    constexpr Real half_turn = 3.14159265358979323846264338327950288L, height = 1 + 0x1p-20L;
    const Real s = point[1], q = point[4], fall = q / (1 + q);
    return {point[0] * half_turn, s * std::sqrt(q / (1 - s * s)), height * fall, -fall, q};
}

void check_initial(const dumbbell_verify::starts::Claim& claim, const std::string& text) {
    must(!claim.most || claim.least <= *claim.most, "bounds in order");
    Choices choices(reinterpret_cast<const std::uint8_t*>(text.data()), text.size());
    constexpr int samples = 3;
    for (int i = 0; i < samples; ++i) {
        Start start{};
        for (std::size_t k = 0; k < start.size(); ++k) {
            const Real lo = claim.box.lo.at(k).get_d(), hi = claim.box.hi.at(k).get_d();
            start.at(k) = lo + static_cast<Real>(choices.sample()) * (hi - lo);
        }
        if (claim.incoming) start = coming_in(start);
        if (const auto run = simulated(start)) must_be_between(*run, claim.least, claim.most, start);
    }
}

/// What is attained is within the bound.
void check_invariant(const dumbbell_verify::adiabatic::Claim& claim) {
    for (std::size_t i = 0; i < claim.bounds.size(); ++i)
        must(claim.attained.at(i).value <= claim.bounds[i], "a bound that is not exceeded");
}

/// What the verifier accepts the program can read, and would write in the same way.
void check_spelling(const std::string& text) {
    static MemoryFile file;
    const std::string& path = file.holding(text);
    const auto read = dumbbell::page::read_any_certificate(path);
    const auto again = std::visit([](const auto& certificate) { return render(certificate); }, read);
    must(again.text == text, "there is one spelling");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes = text_of(data, size);
    const auto text = plain_text(bytes);
    if (!text || !is_little_work(*text)) return 0;
    Request settings;
    settings.max_bits = most_bits;
    const std::string kind = value_of(*text, "claim");
    const bool initial = kind == "initial-conditions" || kind == "incoming";
    const bool about_invariant = std::ranges::any_of(dumbbell_verify::adiabatic::claim_kinds(),
                                                     [&](const auto& row) { return row.name == kind; });
    if (about_invariant) settings.budget = dumbbell_verify::units_per_second / 10;
    if (const std::string scene = value_of(*text, "scene"); !scene.empty()) settings.scene = scene;

    const auto proof = proof_of(bytes, settings);
    if (!proof) return 0;
    must(is_accepted(is_gzip(bytes) ? *text : make::gzipped(bytes), settings, settings.demand),
         "plain and compressed are the same");
    if (initial) {
        const auto* claim = dynamic_cast<const dumbbell_verify::starts::Claim*>(proof->other.get());
        must(claim != nullptr, "a claim about initial conditions");
        check_initial(*claim, *text);
    } else if (about_invariant) {
        const auto* claim = dynamic_cast<const dumbbell_verify::adiabatic::Claim*>(proof->other.get());
        must(claim != nullptr, "a claim about the invariant");
        check_invariant(*claim);
        check_spelling(*text);
    } else if (value_of(*text, "section") != "cells" && is_of_one_rho(proof->claim)) {
        check_claim(*proof, *text, settings);
        check_spelling(*text);
    }
    return 0;
}
