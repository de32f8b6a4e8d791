// A small set of files with verdicts, chosen so that as many different reasons as possible occur: quick to
// verify again, to see whether a changed verifier still says the same.
#pragma once
#include <cstddef>
#include <map>
#include <random>
#include <string>
#include <vector>

#include "campaign.hpp"
#include "manifest.hpp"

namespace dumbbell_mutation {

class Corpus {
  public:
    void add(const Base& base, const std::vector<Trial>& trials, const std::vector<Result>& results);
    /// Writes `most` files, in turn one of each base, verdict and reason, and their table manifest.tsv.
    /// Deterministic. Throws std::runtime_error if the folder cannot be written, or is not empty.
    void write(const std::string& folder, std::size_t most) const;

  private:
    struct Candidate {
        std::string text;
        Entry entry;
    };
    /// A random sample, in random order, of the mutants of one base with one verdict and reason.
    struct Group {
        std::size_t seen = 0;
        std::vector<Candidate> sample;
    };
    std::map<std::string, Group> groups_;
    std::mt19937_64 random_;  ///< the same at each run
};

}  // namespace dumbbell_mutation
