#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <string>

namespace dumbbell::pages {

/// The --help of a command: its options in the words of the man page, in lines of at most 120 columns.
class HelpFormat : public CLI::Formatter {
  public:
    HelpFormat();
    [[nodiscard]] std::string make_option(const CLI::Option* option, bool is_argument) const override;
};

}  // namespace dumbbell::pages
