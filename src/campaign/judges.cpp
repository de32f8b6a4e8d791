#include "campaign/judges.hpp"

#include <fmt/core.h>

#include <chrono>
#include <exception>
#include <system_error>
#include <utility>

#include "base/error.hpp"
#include "number/big_interval.hpp"
#include "number/self_test.hpp"

namespace dumbbell::campaign {

Judges::Judges(const Kind& kind, std::string folder, int jobs, Scrutiny scrutiny)
    : kind_(kind), folder_(std::move(folder)), scrutiny_(scrutiny) {
    try {
        for (int i = 0; i < jobs; ++i) {
            crew_.emplace_back([this] {
                work();
                forget_thread_constants();
            });
        }
    } catch (const std::system_error& error) {
        stop();  // or those who came would wait for ever
        throw InputError(
            fmt::format("{} threads were to be started, and only {} could ({}): give fewer --jobs", jobs,
                        crew_.size(), error.code().message()));
    }
}

Judges::~Judges() { stop(); }

void Judges::stop() {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    changed_.notify_all();
}

void Judges::work() {
    using Clock = std::chrono::steady_clock;
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [&] { return ends_ || !questions_.empty(); });
        if (ends_) {
            return;
        }
        const Case question = std::move(questions_.front());
        questions_.pop_front();
        lock.unlock();
        const auto start = Clock::now();
        Answer answer{question.number, {}, 0};
        std::exception_ptr failure;
        try {
            require_sound_arithmetic();
            answer.judgement = kind_.judge(question.order, folder_, question.file, scrutiny_);
        } catch (...) {
            failure = std::current_exception();
        }
        answer.seconds = std::chrono::duration<double>(Clock::now() - start).count();
        lock.lock();
        if (failure) {
            failure_ = failure;
        }
        answers_.push_back(std::move(answer));
        changed_.notify_all();
    }
}

void Judges::ask(Case question) {
    const std::lock_guard lock(mutex_);
    questions_.push_back(std::move(question));
    changed_.notify_all();
}

Judges::Answer Judges::taken() {
    if (failure_) {
        std::rethrow_exception(std::exchange(failure_, nullptr));
    }
    Answer answer = std::move(answers_.front());
    answers_.pop_front();
    return answer;
}

std::optional<Judges::Answer> Judges::answer() {
    const std::lock_guard lock(mutex_);
    return answers_.empty() ? std::nullopt : std::optional(taken());
}

Judges::Answer Judges::next_answer() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !answers_.empty(); });
    return taken();
}

}  // namespace dumbbell::campaign
