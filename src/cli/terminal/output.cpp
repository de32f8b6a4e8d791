#include "cli/terminal/output.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string_view>

#include "base/error.hpp"
#include "cli/terminal/messages.hpp"

namespace dumbbell::cli {
namespace {

constexpr std::string_view standard_stream = "-";

struct Names {
    const char* what;
    std::vector<std::string_view> endings;
};

Names names_of(Content content) {
    switch (content) {
        case Content::certificate:
            return {"a certificate", {".dbc", ".dbc.gz"}};
        case Content::table:
            return {"a table", {".tsv", ".tsv.gz"}};
        case Content::picture:
            return {"a picture", {".svg"}};
        case Content::page:
            return {"a page", {".html"}};
    }
    throw BrokenInvariant("unknown content");
}

/// `.dbc` alone is no name.
bool ends_in(const std::string& file, std::string_view ending) {
    const std::string name = std::filesystem::path(file).filename().string();
    return name.size() > ending.size() && name.ends_with(ending);
}

bool same_file(const std::string& output, const std::string& input) {
    struct stat out {};
    struct stat in {};
    const bool both =
        ::stat(output.c_str(), &out) == 0 &&
        (input == standard_stream ? ::fstat(STDIN_FILENO, &in) : ::stat(input.c_str(), &in)) == 0;
    return both && out.st_dev == in.st_dev && out.st_ino == in.st_ino;
}

}  // namespace

std::string fault_of_name(const std::string& name, std::optional<Content> content) try {
    if (name.empty()) {
        return "the file name is empty";
    }
    if (name == standard_stream) {
        return "";
    }
    const std::string target = output_target(name);
    std::error_code unreadable;
    if (std::filesystem::is_directory(target, unreadable)) {
        return fmt::format("'{}' is a directory; give a file name", name);
    }
    if (!content) {
        return "";
    }
    const auto [what, endings] = names_of(*content);
    if (std::ranges::any_of(endings, [&](auto ending) { return ends_in(target, ending); })) {
        return "";
    }
    const bool is_bare =
        std::ranges::find(endings, std::filesystem::path(target).filename().string()) != endings.end();
    return fmt::format("the name of {} ends in {} ('{}' {})", what, fmt::join(endings, " or "), target,
                       is_bare ? "has nothing before that" : "does not");
} catch (const InputError& error) {
    return error.what();
}

void require_name_of(const std::string& file, Content content) {
    if (const std::string fault = fault_of_name(file, content); !fault.empty()) {
        throw InputError("--out: " + fault);
    }
}

Output::Output(const std::string& file, const std::vector<std::string>& inputs, const char* other)
    : name_(file) {
    if (file.empty()) {
        return;
    }
    if (file == standard_stream) {
        if (other != nullptr) {
            throw InputError(fmt::format(
                "--out - and {0} both write to the standard output: give --out a file name, or leave {0} out",
                other));
        }
        return;
    }
    const std::string target = output_target(file);
    for (const std::string& input : inputs) {
        if (same_file(target, input)) {
            throw InputError(
                fmt::format("--out '{}' would replace '{}', which is read: give another name", file, input));
        }
    }
    file_.emplace(target);
}

void Output::commit(const Writing& write) const {
    if (file_) {
        file_->commit(write);
    } else if (is_wanted()) {
        const auto require_printed = [](bool printed) {
            if (!printed) {
                throw InputError(not_printed);
            }
        };
        write([&](std::string_view part) {
            require_printed(std::fwrite(part.data(), 1, part.size(), stdout) == part.size());
        });
        require_printed(std::fflush(stdout) == 0);
    }
}

}  // namespace dumbbell::cli
