#include "examine.hpp"

#include <unistd.h>

#include <filesystem>

#include "text.hpp"

namespace dumbbell_mutation {

using namespace dumbbell_verify;

Scratch::Scratch()
    : path_(std::filesystem::temp_directory_path() / ("dumbbell_mutant_" + std::to_string(getpid()))) {}
Scratch::~Scratch() { unlink(path_.c_str()); }

void Scratch::write(const std::string& text) const { write_file(path_, text); }

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

std::string claim_without_scene(const Verified& proof) {
    const std::string text = dumbbell_verify::claim_text(proof);
    return text.substr(text.starts_with("scene=") ? text.find(' ') + 1 : 0);
}

}  // namespace dumbbell_mutation
