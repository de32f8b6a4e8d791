#include "campaign/judges.hpp"

#include <catch2/catch.hpp>
#include <set>
#include <stdexcept>

using namespace dumbbell;
using namespace dumbbell::campaign;

namespace {

/// Judges by the name of the file alone.
class NamedKind : public campaign::Kind {
  public:
    [[nodiscard]] Evidence evidence() const override { return Evidence::results; }
    [[nodiscard]] std::optional<std::string> work(const Order& /*order*/, const std::string& /*folder*/,
                                                  const Interrupted& /*interrupted*/) const override {
        return std::nullopt;
    }
    [[nodiscard]] Merged merge(const Plan& /*plan*/, const std::string& /*folder*/,
                               const std::vector<std::string>& /*files*/) const override {
        return {};
    }

  private:
    [[nodiscard]] Judgement form(const Order& /*order*/, const std::string& file) const override {
        if (file == "broken") {
            throw std::runtime_error("the judge is ill");
        }
        return {file == "bad" ? Judgement::Verdict::wrong : Judgement::Verdict::proved, file};
    }
    [[nodiscard]] std::string refutation(const Order& /*order*/, const std::string& /*folder*/,
                                         const std::string& file) const override {
        if (file == "bad") {
            throw std::runtime_error("the look at its form said enough");
        }
        return file == "false" ? "not verified" : "";
    }
};

const NamedKind named_kind;

}  // namespace

TEST_CASE("each question gets its own answer, whichever judge looks at it") {
    Judges judges(named_kind, ".", 3, Scrutiny::form);
    CHECK_FALSE(judges.answer());
    for (std::size_t i = 0; i < 100; ++i) {
        judges.ask({{}, i % 3 == 0 ? "good" : "bad", i});
    }
    std::set<std::size_t> answered;
    for (int i = 0; i < 100; ++i) {
        const Judges::Answer answer = judges.next_answer();
        answered.insert(answer.number);
        CHECK((answer.judgement.verdict == Judgement::Verdict::proved) == (answer.number % 3 == 0));
        CHECK(answer.seconds >= 0);
    }
    CHECK(answered.size() == 100);
    CHECK_FALSE(judges.answer());
}

TEST_CASE("what has the right form and is refuted is wrong, and what has another form is not asked about") {
    CHECK(named_kind.judge({}, ".", "good", Scrutiny::proof).verdict == Judgement::Verdict::proved);
    CHECK(named_kind.judge({}, ".", "false", Scrutiny::form).verdict == Judgement::Verdict::proved);
    const Judgement refuted = named_kind.judge({}, ".", "false", Scrutiny::proof);
    CHECK(refuted.verdict == Judgement::Verdict::wrong);
    CHECK(refuted.reason == "not verified");
    CHECK(named_kind.judge({}, ".", "bad", Scrutiny::proof).verdict == Judgement::Verdict::wrong);
}

TEST_CASE("what stops a judge reaches the caller that asks for the answer") {
    Judges judges(named_kind, ".", 1, Scrutiny::form);
    judges.ask({{}, "broken", 0});
    CHECK_THROWS_WITH(judges.next_answer(), "the judge is ill");
}

TEST_CASE("questions that nobody has looked at are forgotten at the end") {
    Judges judges(named_kind, ".", 1, Scrutiny::form);
    for (std::size_t i = 0; i < 1000; ++i) {
        judges.ask({{}, "good", i});
    }
}
