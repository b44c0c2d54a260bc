#pragma once

// The known workers, from their hellos and results. The caller gives the time, in seconds of any
// monotonic clock.

#include "cluster/messages/hello_text.h"
#include "cluster/units/recent_work.h"
#include "evolution/evaluation/backend_status.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cambrian {

class Trust;

class WorkerRoll {
public:
    // The coordinator's own build; a worker with another build gets no units.
    struct Build {
        std::string simulator;
        std::uint64_t proof = 0;
    };
    WorkerRoll(Build build, std::string own_name, std::size_t own_cores);

    void hear(const Hello& hello, double now);
    void worked(std::uint64_t worker, std::uint64_t creatures, std::uint64_t work, double now);
    void worked_at_home(std::uint64_t creatures, std::uint64_t work, double now);

    // Records that a unit is late which was published at that time. Workers that were silent since
    // then may have vanished with it; they get no units until they are heard again.
    void doubt_silent(double since);
    // Cores of workers that were heard lately and may be given units.
    std::size_t cores(double now, const Trust& trust) const;
    struct View {
        bool own_busy = false;
        bool reachable = false;  // whether the workers are, at this moment
    };
    std::vector<WorkerStatus> rows(double now, const Trust& trust, const View& view) const;

private:
    struct Member {
        Hello hello;
        double heard = 0.0;
        bool doubted = false;
        RecentWork recent;
    };
    std::string refusal(const Member& member, const Trust& trust) const;
    void forget_silent(double now);

    Build build_;
    std::string own_name_;
    std::size_t own_cores_;
    RecentWork own_;
    std::map<std::uint64_t, Member> members_;
};

}  // namespace cambrian
