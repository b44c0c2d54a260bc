#include "cluster/coordinator/disagreement.h"

#include "cluster/messages/text_for_people.h"

#include <fmt/core.h>

#include <set>

namespace cambrian {
namespace {

// Number of workers, of as many logins, whose bits differ that ends a run.
constexpr std::size_t kDisagreements = 2;

}  // namespace

Disagreement judge_disagreement(std::span<const std::uint64_t> workers,
                                const WorkerRoster& roster) {
    if (workers.size() < kDisagreements) return {};
    std::set<std::string> logins;
    for (const std::uint64_t worker : workers)
        logins.insert(roster.login_of(worker));
    if (logins.size() >= kDisagreements)
        return {.failure =
                    "results of two workers differed from this machine's, although all passed the "
                    "proof trials: this machine or this build is more likely at fault than both of "
                    "them; the run stops here",
                .complaint = {}};
    return {.failure = {},
            .complaint = fmt::format(
                "results of several workers with the login {} differed from this machine's, "
                "although all passed the proof trials: either that login is in wrong hands, or "
                "this machine or this build is at fault",
                text_for_people(*logins.begin(), kLongestName))};
}

}  // namespace cambrian
