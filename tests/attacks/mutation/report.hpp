// What a run of the driver found, as two tables.
#pragma once
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "campaign.hpp"

namespace dumbbell_mutation {

class Report {
  public:
    void add(const Base& base, const std::vector<Trial>& trials, const std::vector<Result>& results);

    /// By base and kind of mutation: how many were tried, refused (and of these with another verdict than
    /// REJECTED), accepted, and what must not be.
    [[nodiscard]] std::string summary() const;
    /// One line for each accepted mutant: base, kind, change, claim, and of the adiabatic invariant how it
    /// was shown.
    [[nodiscard]] const std::string& accepted() const { return accepted_; }
    /// One line for each defect found.
    [[nodiscard]] const std::string& defects() const { return defects_; }
    /// Totals in a sentence.
    [[nodiscard]] std::string sentence() const;
    [[nodiscard]] std::size_t tried() const;

  private:
    struct Row {
        std::map<Fate, std::size_t> fates;
        std::size_t other_verdicts = 0, stale = 0;
        [[nodiscard]] std::size_t tried() const;
        void add(const Row& other);
        [[nodiscard]] std::string text() const;
    };
    [[nodiscard]] Row sum() const;

    std::map<std::pair<std::string, std::string_view>, Row> rows_;
    std::string accepted_, defects_;
};

}  // namespace dumbbell_mutation
