#include "campaign/work_queue_manager.hpp"

#include <arpa/inet.h>
#include <fmt/core.h>
#include <nettle/memops.h>
#include <nettle/sha1.h>

#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <ctime>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "base/error.hpp"
#include "base/hexadecimal.hpp"
#include "campaign/password.hpp"
#include "campaign/work_queue_api.hpp"

namespace dumbbell::campaign {
namespace {

/// Where the queue that is being made is to listen, and what came of it: work_queue_create cannot be told.
struct Listening {
    const std::string& address;
    int port;
    int error = 0;
};
Listening* listening = nullptr;  // of the one thread that makes a queue

/// The peer's next line; nothing if none came in time.
std::optional<std::string> read_line(Link* peer, std::time_t until) {
    std::array<char, 1024> line{};
    if (link_readline(peer, line.data(), line.size(), until) == 0) {
        return {};
    }
    return std::string(line.data());
}

bool write_line(Link* peer, const std::string& text, std::time_t until) {
    const std::string line = text + '\n';
    return link_putlstring(peer, line.data(), line.size(), until) == static_cast<ssize_t>(line.size());
}

/// What shows that one has the password, as the workers' side of the library computes it.
std::string answer_to(const std::string& challenge, const char* password) {
    const std::string text = fmt::format("{} {}", password, challenge);
    std::array<std::uint8_t, SHA1_DIGEST_SIZE> digest{};
    sha1_ctx context{};
    sha1_init(&context);
    sha1_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
    sha1_digest(&context, digest.size(), digest.data());
    return hexadecimal(digest.data(), digest.size());
}

/// Whether the peer has the password, by the library's lines in an order of our own.
bool has_password(Link* peer, const char* password, std::time_t until) {
    const std::string method = "auth password sha1";
    const std::string challenge = random_digits();
    if (!write_line(peer, method, until) || read_line(peer, until) != method ||
        !write_line(peer, challenge, until)) {
        return false;
    }
    const auto challenge_of_peer = read_line(peer, until);
    const auto answer_of_peer = read_line(peer, until);
    if (!challenge_of_peer || !answer_of_peer) {
        return false;
    }
    const std::string expected = answer_to(challenge, password);
    if (answer_of_peer->size() != expected.size() ||
        memeql_sec(answer_of_peer->data(), expected.data(), expected.size()) == 0) {
        return false;
    }
    // Only now: a peer that has not shown the password gets nothing that was made with it.
    return write_line(peer, answer_to(*challenge_of_peer, password), until) &&
           write_line(peer, "ok", until) && read_line(peer, until) == "ok";
}

bool is_numeric(const std::string& address) {
    std::array<unsigned char, sizeof(in6_addr)> ignored{};
    return ::inet_pton(AF_INET, address.c_str(), ignored.data()) == 1 ||
           ::inet_pton(AF_INET6, address.c_str(), ignored.data()) == 1;
}

[[noreturn]] void cannot_listen(const Listening& where) {
    switch (where.error) {
        case EADDRINUSE:
            throw InputError(
                fmt::format("port {} is in use: is another campaign running here? choose another "
                            "with --port, or --port 0 for any free one",
                            where.port));
        case EACCES:
            throw InputError(
                fmt::format("no permission to listen on port {}: choose one above 1023 with --port, "
                            "or --port 0 for any free one",
                            where.port));
        case EADDRNOTAVAIL:
            throw InputError(
                fmt::format("'{}' is not an address of this machine: choose one of those that  ip addr  "
                            "shows, or 127.0.0.1",
                            where.address));
        default:
            throw InputError(fmt::format("cannot listen on {} port {}: {}", where.address, where.port,
                                         std::strerror(where.error)));
    }
}

}  // namespace

void WorkQueueDeleter::operator()(work_queue* queue) const { work_queue_delete(queue); }

WorkQueueManager make_work_queue_manager(const std::string& address, int port, const std::string& password) {
    if (!is_numeric(address)) {
        throw InputError(fmt::format(
            "'{}' is not an IP address: write numbers, such as 127.0.0.1, or 0.0.0.0 for all of this machine",
            address));
    }
    if (port < 0 || port > 65535) {
        throw InputError(
            fmt::format("{} is not a port: choose one from 1024 to 65535, or 0 for any free one", port));
    }
    cctools_debug_flags_clear();
    cctools_debug_flags_restore(D_FATAL);  // the last words of a program that runs out of memory
    Listening where{address, port};
    listening = &where;
    WorkQueueManager queue(work_queue_create(port));
    listening = nullptr;
    if (!queue) {
        cannot_listen(where);
    }
    work_queue_specify_password(queue.get(), password.c_str());
    return queue;
}

}  // namespace dumbbell::campaign

// The linker puts these in the place of the library's functions (cmake/work_queue.cmake).
extern "C" {
Link* listen_as_told(int port) __asm__("__wrap_link_serve");
int let_in(Link* peer, const char* password, std::time_t until) __asm__("__wrap_link_auth_password");
void say_nothing(std::int64_t flags, const char* format, ...) __asm__("__wrap_cctools_warn");
void keep_quiet(std::int64_t flags, const char* format, ...) __asm__("__wrap_cctools_notice");
int library_next_key(hash_table* table, char** key, void** value) __asm__("__real_hash_table_nextkey");
int next_key_kept(hash_table* table, char** key, void** value) __asm__("__wrap_hash_table_nextkey");

/// The port that the library asks for may come from its environment: ours does not.
Link* listen_as_told(int /*port*/) {
    auto* where = dumbbell::campaign::listening;
    Link* made = link_serve_address(where->address.c_str(), where->port);
    where->error = made == nullptr ? errno : 0;
    return made;
}

int let_in(Link* peer, const char* password, std::time_t until) {
    return dumbbell::campaign::has_password(peer, password, until) ? 1 : 0;
}

// Advice to the author of the tasks, on stderr whatever the flags say.
void say_nothing(std::int64_t /*flags*/, const char* /*format*/, ...) {}
void keep_quiet(std::int64_t /*flags*/, const char* /*format*/, ...) {}

// A worker's entry goes, key and all, when the connection ends while its results are fetched; the library
// then uses the key again. So it gets a copy, which lives until the next key of this table is asked for.
int next_key_kept(hash_table* table, char** key, void** value) {
    static std::map<const hash_table*, std::string> keys;  // a queue is used by one thread
    if (library_next_key(table, key, value) == 0) {
        return 0;
    }
    *key = keys.insert_or_assign(table, *key).first->second.data();
    return 1;
}
}
