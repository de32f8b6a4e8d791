#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace dumbbell {

/// Who is told how far a long computation is, from any thread. This one does not listen.
class Observer {
  public:
    Observer() = default;
    Observer(const Observer&) = delete;
    Observer& operator=(const Observer&) = delete;
    virtual ~Observer() = default;

    /// Another phase begins, unless the work is in it; `unit`: what is counted in it, in the plural.
    virtual void enter(std::string_view /*phase*/, std::string_view /*unit*/) {}

    /// The parts that are done, of how many; `count`: the number of collisions N that the last one was about.
    virtual void update(std::size_t /*done*/, std::size_t /*total*/, std::optional<long> /*count*/) {}

    /// In work of unknown size: the parts that were done since the last call.
    virtual void advance(std::size_t /*more*/) {}

    /// What the user should know: a line.
    virtual void note(const std::string& /*line*/) {}
};

inline Observer nobody;

}  // namespace dumbbell
