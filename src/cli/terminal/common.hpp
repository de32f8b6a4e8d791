#pragma once

#include <chrono>
#include <optional>
#include <string>

#include "cli/options/given.hpp"
#include "cli/terminal/output.hpp"
#include "cli/terminal/progress.hpp"
#include "file/sealed_lines.hpp"
#include "words/json.hpp"

/// What the commands have in common, from the options that many of them have to what they print.
namespace dumbbell::cli {

/// --jobs, or the cores of this machine.
[[nodiscard]] int jobs_of(const Given& given);

/// --budget, if it was given. Throws InputError.
[[nodiscard]] std::optional<std::chrono::duration<double>> budget_of(const Given& given);

/// No progress with --quiet.
[[nodiscard]] Verbosity verbosity_of(const Given& given);

class Stopwatch {
  public:
    [[nodiscard]] double seconds() const {
        return std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    }

  private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A report as --json or --quiet wants it, or as text.
template <class Report>
[[nodiscard]] std::string shown(const Report& report, const Given& given) {
    return given.has("--json")    ? json_text(to_json(report))
           : given.has("--quiet") ? verdict(report)
                                  : to_text(report);
}

/// Writes a certificate, and says in the report where it is.
template <class Report>
void write(const SealedText& certificate, const Output& output, Report& report) {
    output.commit(certificate.text);
    report.out = output.file();
    report.sha256 = certificate.sha256;
}

}  // namespace dumbbell::cli
