#pragma once
// Threads that work through the same function side by side and wait for each other in it, thousands of times a second:
// passes over coloured blocks of some microseconds each. A parallel loop per pass would cost more than the pass, and
// oneTBB (sim/core/parallel) may run the parts of a loop one after the other, where they could not wait for each other.
//
// What a member writes before wait() all members see after it. Who does which part must follow from the numbers alone,
// so that the result has the same bits for any number of members.
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>

namespace selvedge {

// One of those that work; alone, it waits for nobody.
class TeamMember {
 public:
    TeamMember() = default;
    std::size_t index() const { return index_; }
    std::size_t count() const { return count_; }
    bool is_first() const { return index_ == 0; }

    // A member's part of 0..size; parts begin at multiples of `grain`.
    struct Part {
        std::size_t begin, end;
    };
    Part part_of(std::size_t size, std::size_t grain = 1) const {
        const std::size_t grains = (size + grain - 1) / grain;
        const auto edge = [&](std::size_t i) {
            const std::size_t at = grains * i / count_ * grain;
            return at < size ? at : size;
        };
        return {edge(index_), edge(index_ + 1)};
    }

    // Until all members have come here.
    void wait() {
        if (count_ > 1) wait_for_others();
    }

 private:
    friend class Team;
    struct Barrier {
        alignas(64) std::atomic<std::uint32_t> arrived{0};
        alignas(64) std::atomic<std::uint32_t> round{0};
    };
    void wait_for_others();

    std::size_t index_ = 0;
    std::size_t count_ = 1;
    Barrier* barrier_ = nullptr;
};

class Team {
 public:
    // Pre: threads >= 1. The caller of run() is one of them.
    explicit Team(int threads);
    ~Team();
    Team(const Team&) = delete;
    Team& operator=(const Team&) = delete;

    // Calls work once on each thread, with its member, and comes back when all are done. Pre: it throws nothing; one
    // caller at a time.
    void run(const std::function<void(TeamMember&)>& work);

 private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

// Calls work on a team of at most `most` threads: the process' own if it is free, else the caller alone.
void run_on_team(int most, const std::function<void(TeamMember&)>& work);

// Whether a team does a work, that comes again and again and gives the same either way, in less time than one thread:
// processors that share their units, or are at other work, make it slower. Tries both from time to time.
class TeamTrial {
 public:
    bool is_better() const;     // asked before each work ...
    void note(double seconds);  // ... what it took

 private:
    static constexpr int kTried = 4, kPeriod = 128;
    int count_ = 0;
    double together_ = 0, alone_ = 0;  // s
};

}  // namespace selvedge
