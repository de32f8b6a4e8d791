#include "examine.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "text.hpp"

namespace dumbbell_mutation {

using namespace dumbbell_verify;

Scratch::Scratch()
    : path_(std::filesystem::temp_directory_path() / ("dumbbell_mutant_" + std::to_string(getpid()))) {}
Scratch::~Scratch() { unlink(path_.c_str()); }

void Scratch::write(const std::string& text) const { write_file(path_, text); }

void write_file(const std::string& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    if (!file.flush()) throw std::runtime_error("cannot write " + path);
}

Outcome examine(const std::string& path, const Request& settings) {
    Outcome result;
    try {
        result.proof = verify(path, settings);
    } catch (const Failure& failure) {
        result.verdict = failure.verdict;
        result.line = failure.line;
        result.code = failure.code;
        result.text = failure.text;
    } catch (const std::exception& error) {  // as the program does
        result.verdict = Verdict::limit;
        result.code = "limit";
        result.text = error.what();
    }
    return result;
}

int exit_code(Verdict verdict) {
    switch (verdict) {
        case Verdict::verified:
            return 0;
        case Verdict::unreadable:
            return 2;
        case Verdict::unsupported:
            return 3;
        case Verdict::limit:
            return 4;
        default:
            return 1;
    }
}

std::string claim_text(const Verified& proof) {
    if (const auto text = proof.of_other([](const auto& it) { return it.text(); })) return *text;
    const Collisions& claim = proof.claim;
    return "ratio=" + dumbbell_verify::to_string(claim.lo, claim.hi) +
           (claim.rho ? " rho=" + dumbbell_verify::to_string(claim.rho->first, claim.rho->second) : "") +
           " upper=" + (claim.upper ? claim.upper->get_str() : "none") + " lower=" + claim.lower.get_str() +
           " gaps=" + std::to_string(claim.gaps) + " open=" + std::to_string(claim.open) +
           (proof.heavy_once ? " heavy-at-most=1" : "");
}

}  // namespace dumbbell_mutation
