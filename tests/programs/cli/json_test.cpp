// docs/reference/json.md against the programs: the fields that it names are the fields that they print.
#include <map>
#include <set>
#include <sstream>

#include "catch.hpp"
#include "programs.hpp"

using namespace dumbbell_test;
using OrderedJson = nlohmann::ordered_json;

namespace {

using Types = std::set<std::string>;
using Fields = std::map<std::string, Types>;

// From 2^53 = 9007199254740992 on an integer is a string.
bool is_great_integer(const OrderedJson& value) {
    static const std::string limit = "9007199254740992";
    const std::string text = value.is_string() ? value.get<std::string>() : "";
    return text.find_first_not_of("0123456789") == std::string::npos &&
           (text.size() > limit.size() || (text.size() == limit.size() && text >= limit));
}

std::string type_of(const OrderedJson& value) {
    return value.is_null()             ? "null"
           : value.is_boolean()        ? "boolean"
           : is_great_integer(value)   ? "digits"
           : value.is_string()         ? "string"
           : value.is_number_integer() ? "integer"
           : value.is_number()         ? "number"
           : value.is_array()          ? "list"
                                       : "object";
}

// Objects whose names are words of the certificate, the kinds of its lines, or options.
bool is_tally(const std::string& path) {
    return path == "leaves" || path == "coverage" || path == "demand.numbers";
}

// The fields of an object and of all that is in it. Elements of a list are objects, or belong to its meaning.
void collect(const OrderedJson& object, const std::string& before, Fields& fields) {
    for (const auto& [key, value] : object.items()) {
        const std::string path = before + key;
        fields[path].insert(type_of(value));
        if (value.is_object() && !is_tally(path)) {
            collect(value, path + ".", fields);
        }
        if (value.is_array()) {
            for (const OrderedJson& element : value) {
                if (element.is_object()) {
                    collect(element, path + "[].", fields);
                }
            }
        }
    }
}

std::string between(const std::string& text, const std::string& begin, const std::string& end) {
    const std::size_t at = text.find(begin);
    if (at == std::string::npos) {
        throw std::runtime_error("not in docs/reference/json.md: " + begin);
    }
    const std::size_t from = at + begin.size();
    return text.substr(from, text.find(end, from) - from);
}

// "integer or null"
Types types_in(const std::string& cell) {
    std::istringstream words(cell);
    Types types{std::istream_iterator<std::string>(words), {}};
    types.erase("or");
    if (types.contains("integer") || types.contains("string")) {
        types.insert("digits");  // an integer from 2^53 on, or a decimal without a point
    }
    return types;
}

// The rows "| `field` | type | meaning |" of the section "## command: `schema`".
Fields documented(const std::string& command, const std::string& schema) {
    const std::string page = contents(DUMBBELL_PROJECT "/docs/reference/json.md");
    Fields fields;
    for (const std::string& line :
         lines_of(between(page, "## " + command + ": `" + schema + "`\n", "\n## "))) {
        if (!line.starts_with("| `")) {
            continue;
        }
        const std::string name = between(line, "| `", "` |");
        CAPTURE(name);
        CHECK(fields.emplace(name, types_in(between(line, "` | ", " |"))).second);
    }
    return fields;
}

OrderedJson printed(const Outcome& result) {
    CAPTURE(result.out, result.err);
    return OrderedJson::parse(result.out);
}

// Everything that these runs print is documented, with its type, and everything documented is printed by one
// of them.
void check_documented(const std::string& command, const std::vector<OrderedJson>& objects) {
    const std::string schema = objects.front().at("schema").get<std::string>();
    const Fields page = documented(command, schema);
    Fields found;
    for (const OrderedJson& object : objects) {
        CHECK(object.at("schema") == schema);
        collect(object, "", found);
    }
    for (const auto& [field, types] : found) {
        CAPTURE(field, types);
        const auto row = page.find(field);
        CHECK(row != page.end());
        if (row != page.end()) {
            CHECK(std::includes(row->second.begin(), row->second.end(), types.begin(), types.end()));
        }
    }
    for (const auto& row : page) {
        CAPTURE(row.first);
        CHECK(found.contains(row.first));
    }
}

std::vector<OrderedJson> printed_by(const std::vector<Words>& commands, const TemporaryFolder& folder) {
    std::vector<OrderedJson> objects;
    for (Words words : commands) {
        words.emplace_back("--json");
        const Outcome result = dumbbell(words, folder.path());
        CHECK(result.out.find("-0.0\n") == std::string::npos);
        CHECK(result.out.find("-0.0,") == std::string::npos);
        objects.push_back(printed(result));
    }
    return objects;
}

Words falling(Words options) {
    options.insert(options.begin(), {"trace", "10", "--y", "3", "--ydot", "-1"});
    return options;
}

}  // namespace

TEST_CASE("docs/reference/json.md describes the JSON of certify, in which null says nothing", "[wings]") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n");
    const auto objects = printed_by({{"certify", "1:5", "--witness"},
                                     {"certify", "10", "--section", "full", "--out", "ten.dbc"},
                                     {"certify", "--coin"},
                                     {"certify", "10", "--budget", "0s"},
                                     {"certify", "1:20", "--part", "1/2"},
                                     {"certify", "--list", "list"}},
                                    folder);
    check_documented("certify", objects);
    CHECK(objects[0].at("heavy_at_most_once").is_null());
    CHECK(objects[1].at("heavy_at_most_once") == true);
    CHECK(objects[2].at("pieces").at(0).at("paper_bound").is_null());
    for (const char* field : {"margin", "width"}) {
        CHECK(objects[1].at("pieces").at(0).at(field).is_number());
        CHECK(objects[2].at("pieces").at(0).at(field).is_null());
        CHECK(objects[3].at("pieces").at(0).at(field).is_null());
    }
}

TEST_CASE("docs/reference/json.md describes the JSON of critical") {
    const TemporaryFolder folder;
    check_documented("critical", printed_by({{"critical", "3:4", "--out", "ratios.tsv"},
                                             {"critical", "5", "--rho", "1/4"},
                                             {"critical", "--ratio", "10", "--rod-mass"},
                                             {"critical", "100", "--budget", "0s"}},
                                            folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of join") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "2:12", "--out", "stairs.dbc"}, folder.path()).code == 0);
    check_documented("join",
                     printed_by({{"join", "stairs.dbc", "--range", "2:12", "--out", "whole.dbc"}}, folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of law", "[wings]") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n");
    check_documented("law", printed_by({{"law"}, {"law", "--prove", "--out", "law.dbc"}}, folder));
    check_documented(
        "law --ratio",
        printed_by({{"law", "--ratio", "1e100"}, {"law", "--ratio", "63"}, {"law", "--list", "list"}},
                   folder));
    check_documented("law --count", printed_by({{"law", "--count", "1e50"}}, folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of a bad line of a list") {
    const TemporaryFolder folder;
    write_file(folder / "list", "ten 10\n");
    check_documented("--list", printed_by({{"certify", "--list", "list"}}, folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of trace", "[wings]") {
    const TemporaryFolder folder;
    write_file(folder / "list", "10\n");
    const Words part{"--phi",       "0:0.5", "--phidot", "0",       "--subdivide",
                     "--max-boxes", "20",    "--out",    "box.dbc", "--shares"};
    check_documented(
        "trace",
        printed_by({falling({"--phi", "0.3", "--phidot", "0"}),
                    falling({"--phi", "0.3", "--phidot", "0", "--digits", "20"}),
                    falling({"--phi", "0.3:0.31", "--phidot", "0"}),
                    falling({"--phi", "0", "--phidot", "0"}),
                    falling({"--phi", "pi/6", "--phidot", "0"}),
                    falling(part),
                    {"trace", "--list", "list", "--phi", "0.3", "--phidot", "0", "--y", "3", "--ydot", "-1"},
                    {"trace", "--coin", "--phi", "0.3", "--phidot", "0", "--y", "3", "--ydot", "-1"},
                    {"trace", "10", "--incoming", "--subdivide", "--max-boxes", "20", "--shares"}},
                   folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of adiabatic", "[wings]") {
    const TemporaryFolder folder;
    check_documented(
        "adiabatic",
        printed_by({{"adiabatic", "--delta", "0.01", "--theorem", "lemma3.1", "--out", "lemma.dbc"},
                    {"adiabatic", "--delta", "0.01", "--theorem", "thm3.5"},
                    {"adiabatic", "--delta", "0.01", "--theorem", "thm3.5", "--budget", "0s"}},
                   folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of audit", "[wings]") {
    const TemporaryFolder folder;
    REQUIRE(dumbbell({"certify", "2:3", "--out", "two.dbc"}, folder.path()).code == 0);
    check_documented("audit", printed_by({{"audit", "two.dbc"}}, folder));
}

TEST_CASE("docs/reference/json.md describes the JSON of verify", "[wings]") {
    const TemporaryFolder folder;
    const auto make = [&](Words words) { REQUIRE(dumbbell(words, folder.path()).code == 0); };
    make({"certify", "10", "--section", "full", "--out", "ten.dbc"});
    make({"certify", "--coin", "--out", "coin.dbc"});
    Words words = falling({"--phi", "0.3:0.31", "--phidot", "0", "--subdivide", "--out", "box.dbc"});
    make(words);
    make({"adiabatic", "--delta", "0.05", "--theorem", "lemma3.1", "--out", "bounce.dbc"});
    make({"trace", "10", "--incoming", "--subdivide", "--max-boxes", "20", "--out", "incoming.dbc"});
    write_file(folder / "bad.dbc", "no certificate\n");

    std::vector<OrderedJson> objects;
    for (const Words& options : std::vector<Words>{
             {"ten.dbc", "box.dbc", "bounce.dbc", "bad.dbc", DUMBBELL_PROJECT "/certificates/law.dbc.gz"},
             {"--ratio", "10", "--exactly", "4", "ten.dbc"},
             {"--coin", "--gap", "0", "coin.dbc"},
             {"--shares", "box.dbc"},
             {"--claim", "initial-conditions", "--y", "1.5", "box.dbc"},
             {"--shares", "incoming.dbc"}}) {
        words = options;
        words.insert(words.begin(), {"verify", "--json"});
        for (const OrderedJson& object : printed(dumbbell(words, folder.path()))) {
            objects.push_back(object);
        }
    }
    check_documented("verify", objects);
}
