#include "law/certificate.hpp"

#include "base/error.hpp"
#include "file/lines.hpp"

namespace dumbbell::law {

bool is_law_certificate(const std::string& path) try {
    constexpr int before = 5;
    Lines lines(path);
    for (int i = 0; i < before; ++i) {
        lines.next();
    }
    return lines.expect("claim", 2)[1] == "law";
} catch (const InputError&) {
    return false;
}

}  // namespace dumbbell::law
