#pragma once

// The interface of a physics engine, ours or another, to the benchmarks. One object simulates one
// creature.

#include "bench/bench_creature.h"
#include "world/environment.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cambrian::bench {

// Position and velocity of a part at its centre.
struct PartMotion {
    double x = 0.0, y = 0.0, angle = 0.0;                   // m, rad
    double velocity_x = 0.0, velocity_y = 0.0, spin = 0.0;  // m/s, rad/s
};

// Whether works are summed at every step. Timed runs of other engines leave it out.
enum class WorkAudit : bool { kOff, kOn };

class BenchEngine {
public:
    virtual ~BenchEngine() = default;

    virtual void set_target(std::size_t part, double target) = 0;  // as PhysicsScene::set_target()
    virtual void advance_tick() = 0;

    // Returns the motion in the order of the plan's parts.
    virtual void read_motion(std::vector<PartMotion>& parts) = 0;

    // Returns the work, in J, of all forces but gravity since the start, as far as the engine
    // reports it (contacts only if the kind says so). It is 0 without an audit.
    virtual double explained_work() const = 0;
};

struct EngineKind {
    std::string id;
    std::string label;            // name with version and settings
    bool audits_contacts = true;  // explained_work() includes contacts
    std::function<std::unique_ptr<BenchEngine>(const BodyPlan&, const Environment&, WorkAudit)>
        make;
};

}  // namespace cambrian::bench
