#include "campaign/journal.hpp"

#include <catch2/catch.hpp>
#include <fstream>

#include "base/error.hpp"
#include "place.hpp"

using namespace dumbbell;
using namespace dumbbell::campaign;
using namespace dumbbell_test;

namespace {

std::vector<JournalEntry> without_time(std::vector<JournalEntry> events) {
    for (JournalEntry& event : events) {
        event.time = 0;
    }
    return events;
}

}  // namespace

TEST_CASE("events are read back in order, with the time put in") {
    const Place place;
    Journal journal(place.string());
    const std::vector<JournalEntry> events{
        {0, JournalEntry::What::begin, "", "", 0, "abc"},
        {0, JournalEntry::What::done, "0123", "host.example:9123", 1.5, ""},
        {0, JournalEntry::What::state, "", "", 2, "workers=1 running=2"}};
    for (const JournalEntry& event : events) {
        journal.append(event);
    }
    const auto found = Journal(place.string()).read();
    CHECK(without_time(found) == events);
    CHECK(found.front().time > 1.7e9);
    CHECK(found.back().time >= found.front().time);
}

TEST_CASE("there is nothing in a journal that is not there") {
    const Place place;
    CHECK(Journal(place.string()).read().empty());
}

TEST_CASE("what a worker says cannot add lines or fields to the journal, nor reach a terminal") {
    const Place place;
    Journal journal(place.string());
    journal.append({0, JournalEntry::What::failed, "id", "a\tb\n", 0, "no\n9.0\tdone\tx\t\t0\t\x1b[2J"});
    const auto found = journal.read();
    REQUIRE(found.size() == 1);
    CHECK(found[0].worker == "a?b?");
    CHECK(found[0].text == "no?9.0?done?x??0??[2J");
}

TEST_CASE("a line that a crash cut off is passed over, and the next one stands alone") {
    const Place place;
    {
        Journal journal(place.string());
        journal.append({0, JournalEntry::What::done, "first", "", 1, ""});
    }
    std::ofstream(place.path, std::ios::app) << "1234.5\tdone\tsec";
    {
        Journal journal(place.string());
        journal.append({0, JournalEntry::What::done, "third", "", 1, ""});
    }
    std::ofstream(place.path, std::ios::app) << "x\tdone\ta\tb\t1\t\nlost\n1\tnothing\ta\tb\t1\tc\n";
    const auto found = Journal(place.string()).read();
    REQUIRE(found.size() == 2);
    CHECK(found[0].id == "first");
    CHECK(found[1].id == "third");
}

TEST_CASE("a journal that cannot be read is not called empty") {
    const Place place;
    std::filesystem::create_directory(place.path);
    CHECK_THROWS_WITH(Journal(place.string()).read(),
                      "cannot read '" + place.string() + "': it is a directory");
    CHECK(Journal(place.string() + "/missing").read().empty());
}

TEST_CASE("a journal that cannot be written is an error that says where") {
    Journal journal("/nowhere/at/all");
    CHECK_THROWS_AS(journal.append({}), InputError);
}
