#pragma once

// Presence: the announcements of workers and coordinators every kHelloEvery, as JSON.

#include "cluster/messages/proof_set.h"
#include "core/result.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cambrian {

inline constexpr double kHelloEvery = 2.0;  // s

struct Refusal {
    std::uint64_t worker = 0;  // id
    std::string reason;        // message for users

    friend bool operator==(const Refusal&, const Refusal&) = default;
};

struct Hello {
    enum class Role : std::uint8_t { kWorker, kCoordinator };

    Role role = Role::kWorker;
    std::uint64_t id = 0;  // of the worker, or of the run
    std::string name;      // displayed; at most 40 bytes, no control characters
    int cores = 0;
    std::string simulator;  // version
    std::uint64_t proof = 0;
    int busy = 0;                   // cores that are computing now
    bool leaving = false;           // the member is leaving
    double units_per_second = 0.0;  // over the last 10 s
    double creatures_per_second = 0.0;
    double work_per_second = 0.0;    // evaluations of accelerations
    std::string refused;             // why it works for no run now; empty if it does
    std::vector<Refusal> refusals;   // of a coordinator, at most 10
    std::vector<ProofTrial> trials;  // of a coordinator, the digests behind its proof

    friend bool operator==(const Hello&, const Hello&) = default;
};

const std::string& role_word(Hello::Role role);  // "worker", "coordinator"

// Returns an announcement with this build's version of the simulator.
Hello introduction(Hello::Role role, std::uint64_t id, const std::string& name, std::size_t cores,
                   std::uint64_t proof);

// Longer names and reasons are truncated.
std::string hello_text(const Hello& hello);
Result<Hello> parse_hello(std::string_view text);

}  // namespace cambrian
