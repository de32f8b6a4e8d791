// Files about the law for tests: the shipped certificate, and its mutants with a trailer that fits.
#pragma once
#include <stdexcept>

#include "rooms/verify/wings/starts/make_file.hpp"

namespace make {

inline const std::string& law_file() {
    static const std::string text = [] {
        gzFile file = gzopen(DUMBBELL_PROJECT "/certificates/law.dbc.gz", "rb");
        std::string all(4'000'000, '\0');
        const int size = file ? gzread(file, all.data(), static_cast<unsigned>(all.size())) : 0;
        if (file) gzclose(file);
        if (size <= 0) throw std::runtime_error("certificates/law.dbc.gz");
        return all.substr(0, static_cast<std::size_t>(size));
    }();
    return text;
}
/// All up to the line `cover layer`.
inline std::string law_steps() { return law_file().substr(0, law_file().find("cover layer\n")); }
inline std::string mutated_law(const std::string& from, const std::string& to) {
    return mutated(law_file(), from, to);
}
/// In step 9 A = 49/C^2 and a little, less than doubles can tell; the line after it is wrong, so that nothing
/// else is looked at.
inline std::string law_that_doubles_do_not_decide() {
    const std::string text =
        mutated_law("step 9 313/5 251/4", "step 9 6247778744831632773/100000000000000000 251/4");
    const std::size_t next = text.find("step 10 ");
    return hashed(text.substr(0, next) + "step 11" + text.substr(next + 7));
}
/// The line of the file that begins so.
inline std::string law_line(const std::string& begin) {
    const std::size_t at = law_file().find("\n" + begin) + 1;
    return law_file().substr(at, law_file().find('\n', at) - at);
}

}  // namespace make
