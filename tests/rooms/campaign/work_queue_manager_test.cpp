#include "campaign/work_queue_manager.hpp"

#include <arpa/inet.h>
#include <nettle/sha1.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <cstring>
#include <fstream>
#include <functional>
#include <future>
#include <sstream>

#include "base/error.hpp"
#include "base/hexadecimal.hpp"
#include "campaign/work_queue_api.hpp"

using Catch::Matchers::Contains;
using dumbbell::InputError;
using dumbbell::campaign::make_work_queue_manager;

namespace {

const std::string password = "0123456789abcdef";

// The addresses that this machine listens on with this port, as /proc/net/tcp and tcp6 write them.
std::vector<std::string> listening_on(int port) {
    std::vector<std::string> addresses;
    for (const char* table : {"/proc/net/tcp", "/proc/net/tcp6"}) {
        std::ifstream in(table);
        std::string line;
        while (std::getline(in, line)) {
            std::string number;
            std::string local;
            std::string remote;
            std::string state;
            std::istringstream(line) >> number >> local >> remote >> state;
            const std::size_t colon = local.find(':');
            if (state == "0A" && std::stoi(local.substr(colon + 1), nullptr, 16) == port) {
                addresses.push_back(local.substr(0, colon));
            }
        }
    }
    return addresses;
}

// Somebody who connects without knowing the password.
class Stranger {
  public:
    explicit Stranger(int port) : socket_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
        sockaddr_in where{};
        where.sin_family = AF_INET;
        where.sin_port = htons(static_cast<std::uint16_t>(port));
        where.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        if (::connect(socket_, reinterpret_cast<const sockaddr*>(&where), sizeof where) != 0) {
            throw std::runtime_error("cannot connect");
        }
        const timeval patience{60, 0};
        ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof patience);
    }
    ~Stranger() { ::close(socket_); }
    Stranger(const Stranger&) = delete;
    Stranger& operator=(const Stranger&) = delete;

    // Empty if there is none.
    [[nodiscard]] std::string hear() const {
        std::string line;
        for (char c = 0; ::recv(socket_, &c, 1, 0) == 1 && c != '\n';) {
            line += c;
        }
        return line;
    }
    void say(const std::string& line) const {
        ::send(socket_, (line + "\n").data(), line.size() + 1, MSG_NOSIGNAL);
    }

  private:
    int socket_;
};

// What a stranger hears of a manager; it is no worker afterwards.
std::string visit(const std::function<std::string(const Stranger&)>& talk) {
    const auto queue = make_work_queue_manager("127.0.0.1", 0, password);
    auto heard = std::async(std::launch::async, [&, port = work_queue_port(queue.get())] {
        const Stranger stranger(port);
        return talk(stranger);
    });
    while (heard.wait_for(std::chrono::seconds(0)) != std::future_status::ready) {
        CHECK(work_queue_wait(queue.get(), 1) == nullptr);
    }
    work_queue_stats stats{};
    work_queue_get_stats(queue.get(), &stats);
    CHECK(stats.workers_connected == 0);
    return heard.get();
}

std::string sha1(const std::string& text) {
    std::array<std::uint8_t, SHA1_DIGEST_SIZE> digest{};
    sha1_ctx context{};
    sha1_init(&context);
    sha1_update(&context, text.size(), reinterpret_cast<const std::uint8_t*>(text.data()));
    sha1_digest(&context, digest.size(), digest.data());
    return dumbbell::hexadecimal(digest.data(), digest.size());
}

}  // namespace

TEST_CASE("the manager listens on the address that it is told, and nowhere else") {
    // Another program may listen on the same port of another address.
    const auto listens = [](const char* address, const std::string& hexadecimal, bool everywhere) {
        const auto queue = make_work_queue_manager(address, 0, password);
        const auto found = listening_on(work_queue_port(queue.get()));
        const auto count = [&](const std::string& one) {
            return std::count(found.begin(), found.end(), one);
        };
        CAPTURE(address, found);
        CHECK(count(hexadecimal) == 1);
        CHECK(count("00000000") == (everywhere ? 1 : 0));
    };
    listens("127.0.0.1", "0100007F", false);
    listens("127.0.0.2", "0200007F", false);
    listens("0.0.0.0", "00000000", true);
}

TEST_CASE("the environment has no say in where the manager listens") {
    ::setenv("WORK_QUEUE_PORT", "1", 1);
    const auto queue = make_work_queue_manager("127.0.0.1", 0, password);
    ::unsetenv("WORK_QUEUE_PORT");
    CHECK(work_queue_port(queue.get()) >= 1024);
}

TEST_CASE("a place where the manager cannot listen is refused, with what to do") {
    const auto first = make_work_queue_manager("127.0.0.1", 0, password);
    const int port = work_queue_port(first.get());
    CHECK_THROWS_WITH(make_work_queue_manager("127.0.0.1", port, password),
                      "port " + std::to_string(port) +
                          " is in use: is another campaign running here? choose another with --port, or "
                          "--port 0 for any free one");
    CHECK_THROWS_WITH(make_work_queue_manager("192.0.2.1", 0, password),
                      Contains("is not an address of this machine"));
    for (const char* address : {"", "localhost", "127.0.0", "127.0.0.1 ", "::1%lo"}) {
        CHECK_THROWS_WITH(make_work_queue_manager(address, 0, password), Contains("is not an IP address"));
    }
    for (const int bad : {-1, 65536}) {
        CHECK_THROWS_WITH(make_work_queue_manager("127.0.0.1", bad, password), Contains("is not a port"));
    }
}

TEST_CASE("who sends the manager's own challenge and answer back is not let in") {
    const auto heard = visit([](const Stranger& stranger) {
        stranger.say(stranger.hear());
        stranger.say(stranger.hear());
        const std::string answer = stranger.hear();  // of the library's own check, here: the right one
        stranger.say(answer);
        return answer + stranger.hear();
    });
    CHECK(heard.empty());
}

TEST_CASE(
    "who answers as the protocol wants, and has not the password, hears nothing that was made with it") {
    const auto answered = [](const std::function<std::string(const std::string&)>& answer) {
        return visit([&](const Stranger& stranger) {
            stranger.say(stranger.hear());
            const std::string challenge = stranger.hear();
            stranger.say(std::string(64, 'a'));
            stranger.say(answer(challenge));
            std::string heard = stranger.hear();
            return heard.empty() ? "turned away" : heard + " " + stranger.hear();
        });
    };
    const auto with = [](const std::string& secret) {
        return [secret](const std::string& challenge) { return sha1(secret + " " + challenge); };
    };
    // That this test speaks as a worker does: with the password it is let in.
    CHECK(answered(with(password)) == sha1(password + " " + std::string(64, 'a')) + " ok");
    CHECK(answered(with("0123456789abcdeg")) == "turned away");
    CHECK(answered(with("")) == "turned away");
    CHECK(answered([](const std::string&) { return std::string(40, '0'); }) == "turned away");
    CHECK(answered([](const std::string&) { return std::string(); }) == "turned away");
    CHECK(answered([&](const std::string& c) { return with(password)(c).substr(0, 39); }) == "turned away");
    CHECK(answered([&](const std::string& c) { return with(password)(c) + "0"; }) == "turned away");
    CHECK(answered([&](const std::string& c) { return with(password)(c.substr(1) + c[0]); }) ==
          "turned away");
}

TEST_CASE("a worker that goes away while its results are fetched is forgotten, and its key not used again") {
    const auto asked = visit([](const Stranger& worker) {
        worker.say(worker.hear());
        const std::string challenge = worker.hear();
        worker.say(std::string(64, 'a'));
        worker.say(sha1(password + " " + challenge));
        worker.say("ok");
        worker.say("workqueue 9 here Linux x86_64 9.9.9");
        worker.say("available_results");
        std::string heard = worker.hear();  // an answer to the challenge, "ok", and then
        while (!heard.empty() && heard.rfind("send_results", 0) != 0) {
            heard = worker.hear();
        }
        return heard;
    });
    CHECK_FALSE(asked.empty());  // sanitizers see what becomes of the key in the library
    hash_table* table = hash_table_create(0, nullptr);
    int value = 0;
    hash_table_insert(table, "the key of a worker", &value);
    hash_table_firstkey(table);
    char* key = nullptr;
    void* found = nullptr;
    REQUIRE(hash_table_nextkey(table, &key, &found) == 1);
    hash_table_remove(table, "the key of a worker");
    const bool kept =
        std::strcmp(key, "the key of a worker") == 0;  // at once: memory that is freed may be used again
    CHECK(kept);
    hash_table_delete(table);
}
