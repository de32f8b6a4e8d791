#include "verify/program/options.hpp"

#include <algorithm>
#include <sstream>
#include <thread>

#include "verify/program/claim_list.hpp"
#include "verify/program/claim_options.hpp"
#include "verify/program/option_table.hpp"

namespace dumbbell_verify {
namespace {

/// The present option. A value may follow its name with `=`, but one that has none is the whole word.
const Option& option_of(const Arguments& given) {
    for (const Option& option : option_table()) {
        const std::string& word = option.value.empty() ? given.word : given.option;
        if (option.name == word || option.name.starts_with(word + ", ") || option.name.ends_with(", " + word))
            return option;
    }
    throw std::invalid_argument("unknown option " + given.word + "; see --help");
}

/// Not all options and files can be given with each other.
void require_fitting(const Arguments& given, const Asked& asked) {
    for (const Option& option : option_table()) {
        const std::string name(option.name);
        std::istringstream excluded{std::string(option.excludes)};
        for (std::string other; excluded >> other;)
            if (given.seen(name) && given.seen(other))
                throw std::invalid_argument(name + " and " + other + " exclude each other; see --help");
    }
    const std::size_t files = asked.options.jobs.size();
    const bool is_list = given.seen("--claims");
    if (is_list && !asked.claim.empty())
        throw std::invalid_argument("--claims and " + asked.claim.begin()->first +
                                    " exclude each other; see --help");
    if (is_list && files > 0) throw std::invalid_argument("--claims names the files: give no other FILE");
    for (const char* option : {"--shares", "--leaves"})
        if (given.seen(option) && files != 1)
            throw std::invalid_argument(std::string(option) + " is about one FILE");
    if (!is_list && files == 0) throw std::invalid_argument("no FILE; see --help");
}

}  // namespace

Options parse_options(const std::vector<std::string>& arguments) {
    Asked asked;
    Options& result = asked.options;
    Request& settings = asked.settings;
    settings.jobs = std::max(1U, std::thread::hardware_concurrency());
    Arguments given(arguments);
    while (given.next()) {
        if (given.option.empty())
            result.jobs.push_back({given.word, {}});  // its settings: below
        else
            option_of(given).read(given, asked);
    }
    if (!result.answer.empty()) return result;
    require_fitting(given, asked);
    state_claim(asked.claim, settings);
    for (Job& job : result.jobs) job.settings = settings;
    if (given.seen("--claims")) result.jobs = read_claims(asked.claims, settings);
    // A leaf that is explained is printed while it is checked: one file after the other.
    if (settings.explain.empty())
        result.at_once = static_cast<unsigned>(std::min<std::size_t>(settings.jobs, result.jobs.size()));
    for (Job& job : result.jobs) job.settings.jobs = settings.jobs / result.at_once;
    return result;
}

}  // namespace dumbbell_verify
