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

class WorkerRoster {
public:
    // The coordinator's own build; a worker with another build gets no units.
    struct Build {
        std::string simulator;
        std::uint64_t proof = 0;
    };
    WorkerRoster(Build build, std::string own_name, std::size_t own_cores);

    // `login` is that of the sender. A worker that leaves is no longer listed, unless it was
    // refused. An id belongs to the login that announced it first.
    void hear(const Hello& hello, const std::string& login, double now, const Trust& trust);
    // Whether a result of that worker and login counts: the worker has announced itself, with this
    // build's version and proof.
    bool counts(std::uint64_t worker, const std::string& login) const;
    // Returns the login of a listed worker; empty for others.
    std::string login_of(std::uint64_t worker) const;
    void worked(std::uint64_t worker, std::uint64_t creatures, std::uint64_t work, double now);
    void worked_at_home(std::uint64_t creatures, std::uint64_t work, double now);

    // Must be called when a unit that was published at that time is late. Workers that have been
    // silent since then may have crashed with it; they get no units until their next message.
    void doubt_silent(double since);
    // Returns the cores of workers that sent a message recently and may get units.
    std::size_t cores(double now, const Trust& trust) const;
    struct View {
        bool own_busy = false;
        bool reachable = false;  // whether the workers can be reached now
    };
    std::vector<WorkerStatus> rows(double now, const Trust& trust, const View& view) const;

private:
    struct Member {
        Hello hello;
        std::string login;
        double heard = 0.0;
        bool doubted = false;
        RecentWork recent;
    };
    std::string refusal(const Member& member, const Trust& trust) const;
    bool has_room_for(const std::string& login) const;
    void forget_silent(double now);

    Build build_;
    std::string own_name_;
    std::size_t own_cores_;
    RecentWork own_;
    std::map<std::uint64_t, Member> members_;
};

}  // namespace cambrian
