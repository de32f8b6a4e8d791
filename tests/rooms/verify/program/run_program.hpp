// dumbbell-verify as a script sees it.
#pragma once
#include <sys/wait.h>

#include <cstdlib>

#include "rooms/verify/core/make_certificate.hpp"
#include "rooms/verify/program/shipped.hpp"

namespace make {

/// With sanitizers the program is slow, and maps terabytes.
#if defined(__SANITIZE_ADDRESS__)
constexpr bool sanitized = true;
#elif defined(__has_feature)
constexpr bool sanitized = __has_feature(address_sanitizer);
#else
constexpr bool sanitized = false;
#endif

struct Run {
    int code;
    std::string out, err;
    [[nodiscard]] std::string last() const {
        const std::size_t end = out.size() - 1;
        return out.empty() ? ""
                           : out.substr(out.rfind('\n', end - 1) + 1, end - out.rfind('\n', end - 1) - 1);
    }
};

inline Run run(const std::string& arguments, const std::string& before = "") {
    const File out(""), err("");
    const std::string command =
        before + DUMBBELL_VERIFY_BIN " " + arguments + " >" + out.path() + " 2>" + err.path();
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), contents(out.path()),
            contents(err.path())};
}

inline bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}
inline bool has(const Run& result, const std::string& text) { return has(result.out, text); }

}  // namespace make
