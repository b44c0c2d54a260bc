#pragma once

// What the benchmarks ask of a physics engine, ours or another. One creature, one engine.

#include "bench/bench_creature.h"
#include "world/environment.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cambrian::bench {

// A part at its centre.
struct PartMotion {
    double x = 0.0, y = 0.0, angle = 0.0;                   // m, rad
    double velocity_x = 0.0, velocity_y = 0.0, spin = 0.0;  // m/s, rad/s
};

// Whether works are summed at every step; timed runs of other engines do without.
enum class WorkAudit : bool { kOff, kOn };

class BenchEngine {
public:
    virtual ~BenchEngine() = default;

    virtual void set_target(std::size_t part, double target) = 0;  // as PhysicsScene's
    virtual void advance_tick() = 0;

    // In the order of the plan's parts.
    virtual void read_motion(std::vector<PartMotion>& parts) = 0;

    // J; work of all forces but gravity since the start, as far as the engine tells (contacts
    // only where the kind says so). 0 without an audit.
    virtual double explained_work() const = 0;
};

struct EngineKind {
    std::string id;
    std::string label;            // with version and settings
    bool audits_contacts = true;  // explained_work() includes contacts
    std::function<std::unique_ptr<BenchEngine>(const BodyPlan&, const Environment&, WorkAudit)>
        make;
};

}  // namespace cambrian::bench
