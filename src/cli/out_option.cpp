#include "cli/out_option.hpp"

#include <CLI/CLI.hpp>

namespace dumbbell {

CLI::Option* add_out_option(CLI::App& command, std::string& file, const char* text) {
    return command.add_option("--out", file, text)
        ->check([](const std::string& name) { return name.empty() ? "the file name is empty" : ""; })
        ->type_name("FILE");
}

}  // namespace dumbbell
