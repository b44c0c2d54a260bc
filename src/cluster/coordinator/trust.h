#pragma once

// Decides which workers are trusted, and which of their results this machine computes again as a
// check. The choice depends on a secret of the run, so that no worker knows which results are
// checked. Results do not depend on it (cluster/README.md 2).

#include "cluster/messages/hello_text.h"

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace cambrian {

class Trust {
public:
    explicit Trust(std::uint64_t secret) : secret_(secret) {}

    // Returns whether a worker's next result is checked. Its first 16 always are; the n-th of the
    // following ones is with probability 16/n. The probability is never below `least`.
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
