#include "dumbbell/verify.hpp"

#include <stdexcept>
#include <system_error>

#include "api/stack.hpp"
#include "verify/machine/environment.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/examine.hpp"
#include "verify/program/summary.hpp"

namespace dumbbell::api {
inline namespace DUMBBELL_ABI {
namespace {

dumbbell_verify::Job job_of(const std::string& file, const Claim& claim, unsigned jobs,
                            const std::string& budget) {
    if (jobs < 1 || jobs > 1024) {
        throw std::invalid_argument("jobs is out of range: give a number of threads from 1 to 1024");
    }
    std::vector<std::string> options{"--claim", "collisions", "--ratio", claim.ratio};
    if (claim.most) {
        options.insert(options.end(), {"--max", std::to_string(*claim.most)});
    }
    if (claim.least) {
        options.insert(options.end(), {"--min", std::to_string(*claim.least)});
    }
    dumbbell_verify::Job job{file, {}};
    job.settings.jobs = jobs;
    dumbbell_verify::Arguments time({"--budget", budget});
    time.next();
    job.settings.budget = time.time();
    dumbbell_verify::Arguments claimed(std::move(options));
    while (claimed.next()) {
        claim_option(claimed, job.settings);
    }
    return job;
}

Verdict given(dumbbell_verify::Verdict verdict) {
    switch (verdict) {
        case dumbbell_verify::Verdict::verified:
            return Verdict::verified;
        case dumbbell_verify::Verdict::open:
            return Verdict::open;
        case dumbbell_verify::Verdict::unreadable:
            return Verdict::unreadable;
        case dumbbell_verify::Verdict::unsupported:
            return Verdict::unsupported;
        case dumbbell_verify::Verdict::limit:
            return Verdict::limit;
        case dumbbell_verify::Verdict::rejected:
            break;
    }
    return Verdict::rejected;
}

}  // namespace

Verification verify(const std::string& file, const Claim& claim, unsigned jobs, const std::string& budget) {
    Verification verification;
    const auto work = [&] {
        const dumbbell_verify::DefaultEnvironment environment;
        const dumbbell_verify::Job job = job_of(file, claim, jobs, budget);
        const dumbbell_verify::Result result = examine(job);
        verification = {given(result.why.verdict), result_text(result), result.proof.digest};
    };
    try {
        with_stack(work, mpfr_free_cache);
    } catch (const std::system_error& error) {
        return {Verdict::limit, error.what(), ""};
    }
    return verification;
}

}  // namespace DUMBBELL_ABI
}  // namespace dumbbell::api
