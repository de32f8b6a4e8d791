#include "campaign.hpp"

#include <csignal>
#include <functional>
#include <sstream>
#include <unordered_set>
#include <utility>

#include "adiabatic_argument.hpp"
#include "apart.hpp"
#include "demands.hpp"
#include "mutations.hpp"

namespace dumbbell_mutation {
namespace {

constexpr std::size_t stale_sample = 8;  ///< one in this number is also tried with the old checksum

/// Texts that were not seen before.
class Collector {
  public:
    explicit Collector(const Base& base) : trailer_(base.text.substr(body_of(base.text).size())) {
        seen_.insert(hash_(base.text));
    }

    void add(const Mutant& mutant) {
        if (mutant.as_it_is) return add(mutant, "", mutant.text);
        add(mutant, "", closed(mutant.text));
        if (mutant.text.find("\ntotal ") != std::string::npos)
            add(mutant, ", totals as they are", hashed(mutant.text));
    }
    std::vector<Trial> trials;

  private:
    void add(const Mutant& mutant, const char* how, std::string text) {
        if (!seen_.insert(hash_(text)).second) return;
        const std::string stale = mutant.as_it_is ? "" : body_of(mutant.text) + trailer_;
        const bool tried = stale == text || seen_.contains(hash_(stale));
        trials.push_back({mutant.kind, mutant.what + how, std::move(text), tried ? "" : stale, {}});
    }

    std::string trailer_;  ///< the base's
    std::hash<std::string> hash_;
    std::unordered_set<std::size_t> seen_;
};

std::vector<Trial> thinned(std::vector<Trial> trials, std::size_t most) {
    if (trials.size() <= most) return trials;
    std::vector<Trial> result;
    for (std::size_t i = 0; i < most; ++i) result.push_back(std::move(trials[i * trials.size() / most]));
    return result;
}

/// A result on one line, and back.
std::string packed(const Result& r) {
    std::string line;
    for (const std::string& field :
         {std::to_string(static_cast<int>(r.fate)), std::to_string(r.stale_tried ? 1 : 0),
          std::to_string(static_cast<int>(r.verdict)), std::to_string(r.line), r.code, r.text, r.argument})
        (line += line.empty() ? "" : "\t") += field;
    return line;
}
Result unpacked(const std::string& line) {
    std::vector<std::string> fields;
    std::istringstream in(line);
    for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
    fields.resize(7);
    return {static_cast<Fate>(std::stoi(fields[0])),
            fields[1] == "1",
            static_cast<dumbbell_verify::Verdict>(std::stoi(fields[2])),
            std::stoul(fields[3]),
            fields[4],
            fields[5],
            fields[6]};
}

Result verified(const Scratch& file, const Trial& trial) {
    file.write(trial.text);
    const Outcome outcome = examine(file.path(), trial.settings);
    Result result{Fate::rejected, false, outcome.verdict, outcome.line, outcome.code, outcome.text, ""};
    if (trial.demand) {
        const bool right = trial.fitting ? outcome.accepted() == trial.proved &&
                                               (outcome.accepted() || outcome.code == "claim-not-proved")
                                         : outcome.verdict == dumbbell_verify::Verdict::unreadable;
        result.fate = !right ? Fate::wrong_demand : outcome.accepted() ? Fate::accepted : Fate::rejected;
        if (right && outcome.accepted()) result.argument = "the base's own pieces prove it";
    } else if (outcome.accepted()) {
        result.fate = Fate::accepted;
        if (const auto* claim =
                dynamic_cast<const dumbbell_verify::adiabatic::Claim*>(outcome.proof->other.get())) {
            const Argument argument = adiabatic_argument(file.path(), claim);
            if (!argument.holds) result.fate = Fate::unexplained;
            result.argument = argument.text;
        }
    }
    if (outcome.accepted()) result.text = claim_without_scene(*outcome.proof);
    return result;
}

/// With the old totals and checksum nothing may be accepted; what is else accepted must fail by them.
bool is_unmasked(const Scratch& file, const Trial& trial, bool accepted) {
    file.write(trial.stale);
    const Outcome outcome = examine(file.path(), trial.settings);
    return outcome.accepted() ||
           (accepted && outcome.code != "sha256" && outcome.code != "total" && outcome.code != "between");
}

}  // namespace

std::vector<Trial> trials_of(const Base& base, const Options& options) {
    Collector collector(base);
    const Sink sink = [&](const Mutant& mutant) { collector.add(mutant); };
    const std::size_t most = options.most / base.cost;
    std::vector<Trial> trials;
    const auto keep = [&](std::size_t n) {
        for (Trial& trial : thinned(std::exchange(collector.trials, {}), n))
            trials.push_back(std::move(trial));
    };
    claim_mutations(base, sink);
    if (base.cost > 1)
        keep(most / 3 * options.scale);  // what is spelled otherwise is the others' business, too
    tree_mutations(base.text, sink);
    if (base.cost > 1) keep(most / 3 * options.scale);
    word_mutations(base.text, sink);
    line_mutations(base.text, sink);
    if (base.cost == 1) byte_mutations(base.text, sink);
    keep(most * options.scale - trials.size());
    if (options.scale > 1) {
        random_mutations(base.text, 1, most * (options.scale - 1) / 2, sink);
        keep(collector.trials.size());
    }
    std::vector<Trial> demands;
    for (const Demand& demand : demands_of(base))
        demands.push_back(
            {"demand", demand.what, base.text, "", demand.settings, true, demand.proved, demand.fitting});
    for (Trial& demand : thinned(std::move(demands), most / 10 * options.scale))
        trials.push_back(std::move(demand));
    return trials;
}

std::vector<Result> run(const std::vector<Trial>& trials, const Options& options) {
    const auto work = [&](std::size_t i) {
        const Scratch file;
        const Trial& trial = trials[i];
        Result result = verified(file, trial);
        const bool accepted = result.fate != Fate::rejected;
        if (!trial.demand && !trial.stale.empty() && (accepted || i % stale_sample == 0)) {
            result.stale_tried = true;
            if (is_unmasked(file, trial, accepted)) result.fate = Fate::unmasked;
        }
        return packed(result);
    };
    std::vector<Result> results;
    for (const Ended& ended : run_apart(trials.size(), options.jobs, options.seconds, work)) {
        Result result;
        if (ended.signal != 0) {
            result.fate = ended.signal == SIGPROF ? Fate::hang : Fate::crash;
            result.argument = "signal " + std::to_string(ended.signal);
        } else {
            result = unpacked(ended.result);
        }
        results.push_back(std::move(result));
    }
    return results;
}

}  // namespace dumbbell_mutation
