#include "campaign/worker_commands.hpp"

#include <catch2/catch.hpp>

using Catch::Matchers::Contains;
using dumbbell::campaign::ManagerPlace;
using dumbbell::campaign::reached_as;
using dumbbell::campaign::worker_command;
using dumbbell::campaign::worker_examples;

TEST_CASE("the line that starts a worker names password, host and port") {
    CHECK(worker_command({"127.0.0.1", 9123, "c/password"}, "127.0.0.1") ==
          "work_queue_worker --password c/password --cores 0 127.0.0.1 9123");
    CHECK(worker_command({"0.0.0.0", 4000, "it's mine/$HOME"}, "head") ==
          "work_queue_worker --password 'it'\\''s mine/$HOME' --cores 0 head 4000");
}

TEST_CASE("the line that starts a worker is one line of text whatever its folder is called") {
    CHECK(worker_command({"127.0.0.1", 9123, "/my\tcampaigns\n/c/password"}, "127.0.0.1") ==
          "work_queue_worker --password $'/my\\011campaigns\\012/c/password' --cores 0 127.0.0.1 9123");
}

TEST_CASE("a manager on the loopback address is reached through tunnels") {
    const std::string text = worker_examples({"127.0.0.1", 9123, "c/password"}, "head");
    CHECK_THAT(text, Contains("\nwork_queue_worker --password c/password --cores 0 127.0.0.1 9123\n"));
    CHECK_THAT(text, Contains("ssh -o ExitOnForwardFailure=yes -R 9123:127.0.0.1:9123 OTHER "
                              "work_queue_worker --password dumbbell-password "
                              "--cores 0 127.0.0.1 9123\n"));
    CHECK_THAT(text, Contains("--wrap 'port=$((20000 + SLURM_ARRAY_TASK_ID)); ssh -f -N -o "
                              "ExitOnForwardFailure=yes -L $port:127.0.0.1:9123 head && work_queue_worker "
                              "--password c/password --cores 4 127.0.0.1 $port'\n"));
}

TEST_CASE("a manager on another address is reached there") {
    CHECK(reached_as({"0.0.0.0", 9123, "p"}, "head") == "head");
    CHECK(reached_as({"::", 9123, "p"}, "head") == "head");
    CHECK(reached_as({"10.0.0.1", 9123, "p"}, "head") == "10.0.0.1");
    const std::string text = worker_examples({"0.0.0.0", 9123, "c/password"}, "head");
    CHECK_THAT(text, Contains("\nwork_queue_worker --password c/password --cores 0 127.0.0.1 9123\n"));
    CHECK_THAT(text, Contains("--wrap 'work_queue_worker --password c/password --cores 4 head 9123'\n"));
    CHECK_THAT(worker_examples({"::1", 9123, "p"}, "head"), Contains("-R 9123:[::1]:9123"));
}
