#pragma once

#include <string>

#include "cli/pages/help_format.hpp"

namespace dumbbell::pages {

/// The --help of a command that is nothing but its commands: on one screen, each in one line, below their
/// groups. The first line of a description is what it is for; the whole of it stands in the manual and in the
/// help of each command. Of other commands that of HelpFormat.
class OneScreen : public HelpFormat {
  public:
    [[nodiscard]] std::string make_help(const CLI::App* app, std::string name,
                                        CLI::AppFormatMode mode) const override;
};

}  // namespace dumbbell::pages
