// Text that another system has changed.
#pragma once
#include <string>
#include <string_view>

namespace dumbbell_verify {

/// What is foreign in a line of a text, and how to mend it; empty: nothing that has a name.
inline std::string foreign_text(std::string_view line, bool is_first) {
    if (is_first && (line.starts_with("\xff\xfe") || line.starts_with("\xfe\xff")))
        return "the text is UTF-16: mend it with iconv -f UTF-16 -t ASCII <OLD >NEW";
    if (is_first && line.starts_with("\xef\xbb\xbf"))
        return "the text begins with a byte-order mark of UTF-8: mend it with tail -c +4 <OLD >NEW";
    if (line.find('\r') < line.size())
        return "the text has line ends of Windows (CR LF): mend it with tr -d '\\r' <OLD >NEW";
    return "";
}

}  // namespace dumbbell_verify
