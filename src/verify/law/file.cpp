#include "verify/law/file.hpp"

#include <exception>

#include "verify/format/header.hpp"
#include "verify/law/grammar.hpp"

namespace dumbbell_verify {

const Law& LawFile::verified(const std::string& digest, const Settings& settings) {
    std::call_once(once_, [&] { verify(settings); });
    if (why_) throw Failure(*why_);
    if (digest_ != digest)
        throw Failure{Verdict::unreadable, 0, "usage",
                      "--law " + path_ + " has sha256=" + digest_ +
                          ", and this file rests on the one with sha256=" + digest};
    return law_;
}

void LawFile::verify(const Settings& settings) try {
    Text text(path_, settings.budget);
    const Header header = read_header(text);
    if (header.section != &turning() || header.claim != "law")
        throw Failure{Verdict::unreadable, 0, "usage", "is not a file of the claim law"};
    Settings own;
    own.jobs = settings.jobs;
    own.max_bits = settings.max_bits;
    own.precision = settings.precision;
    auto [proof, claim] = law(text, own);
    digest_ = proof.digest;
    law_ = std::move(claim);
} catch (const Failure& failure) {
    const std::string line = failure.line > 0 ? " line " + std::to_string(failure.line) + ":" : "";
    why_ = Failure{failure.verdict, 0, "law", "--law " + path_ + ":" + line + " " + failure.text};
} catch (const std::exception& error) {  // out of memory, no more threads
    why_ = Failure{Verdict::limit, 0, "limit", "--law " + path_ + ": " + error.what()};
}

}  // namespace dumbbell_verify
