#pragma once

#include <string>
#include <vector>

#include "file/descriptor.hpp"

namespace dumbbell::campaign {

/// What happened to a shard, or to the campaign.
struct JournalEntry {
    enum class What {
        begin,     ///< a run began; `text`: the plan's checksum
        end,       ///< it came to its end; `text`: why
        done,      ///< a result was accepted, after `seconds` of work by `worker`
        again,     ///< one that was there already came once more
        rejected,  ///< a result was not accepted; `text`: why
        failed,    ///< no result; `text`: why
        split,     ///< too big
        state      ///< now and then; `text`: figures of the engine
    };
    double time = 0;  ///< seconds since 1970
    What what = What::state;
    std::string id;
    std::string worker;
    double seconds = 0;
    std::string text;

    friend bool operator==(const JournalEntry&, const JournalEntry&) = default;
};

/// Seconds since 1970, as events have them.
[[nodiscard]] double seconds_since_1970();

/// A file to which events are appended, a line each, for people and for `status`. No proof rests on it: a
/// line that is damaged, as the last one may be after a crash, is passed over.
class Journal {
  public:
    explicit Journal(std::string path) : path_(std::move(path)) {}

    /// The present time is put in. Throws InputError if it cannot be written.
    void append(JournalEntry event);

    /// All events, in order; none if there is no such file. Throws InputError if it cannot be read.
    [[nodiscard]] std::vector<JournalEntry> read() const;

  private:
    std::string path_;
    Descriptor file_;
};

}  // namespace dumbbell::campaign
