#pragma once

// Which workers are trusted, and which of their results this machine computes again as a check. The
// choice depends on a secret of the run, so no worker knows which results are checked. No result
// depends on it (cluster/README.md 2).

#include "cluster/messages/hello_text.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cambrian {

class Trust {
public:
    explicit Trust(std::uint64_t secret) : secret_(secret) {}

    // Whether a worker's next result is to be checked: each of its first 16 is, of the following
    // ones the n-th with a chance of 16 in n, and `least` (0 to 1) at any time.
    bool draw_check(std::uint64_t worker, std::uint32_t generation, std::uint32_t slot,
                    double least);
    void pass(std::uint64_t worker) { ++workers_[worker].passed; }
    void refuse(std::uint64_t worker, std::string reason);

    bool refused(std::uint64_t worker) const;
    std::uint64_t checks_passed(std::uint64_t worker) const;
    std::string refusal(std::uint64_t worker) const;  // empty unless refused
    std::vector<Refusal> refusals() const;            // the latest last

private:
    struct Record {
        std::uint64_t results = 0;
        std::uint64_t passed = 0;
    };
    std::uint64_t secret_;
    std::map<std::uint64_t, Record> workers_;
    std::vector<Refusal> refusals_;
};

}  // namespace cambrian
