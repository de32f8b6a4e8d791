#include "examine.hpp"

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "text.hpp"
#include "verify/program/summary.hpp"

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
    const std::string text = dumbbell_verify::claim_text(proof);
    return text.substr(text.starts_with("scene=") ? text.find(' ') + 1 : 0);
}

}  // namespace dumbbell_mutation
