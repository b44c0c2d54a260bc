#include "evolution/evaluation/probe.h"

#include "core/random.h"
#include "creature/placement.h"
#include "evolution/evaluation/trials.h"
#include "math/elementary.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kFiner = 0.5;          // factor of the contact step
constexpr std::uint64_t kWorlds = 101;  // index that keeps these seeds apart from those of jitter

}  // namespace

std::vector<Probe> probes_of(const ExperimentSettings& settings, std::uint32_t generation,
                             int count) {
    std::vector<Probe> probes;
    probes.reserve(static_cast<std::size_t>(count));
    for (int world = 0; world < count; ++world) {
        probes.push_back({stream_seed({trial_seed(settings), kWorlds, generation,
                                       static_cast<std::uint64_t>(world)}),
                          world == 0});
    }
    return probes;
}

ExperimentSettings probed_world(const Probe& probe, const ExperimentSettings& settings,
                                Genome& creature) {
    RandomStream stream(probe.seed);
    const double share = settings.selection.confirm_jitter;
    ExperimentSettings changed = settings;
    Environment& world = changed.world.environment;
    for (double* number :
         {&world.gravity, &world.friction, &world.viscosity_linear, &world.viscosity_quadratic})
        *number *= 1.0 + share * stream.uniform(-1.0, 1.0);
    const double turn = share * stream.uniform(-1.0, 1.0);
    if (world.has_ground)
        changed.world.tilt = settings.selection.confirm_tilt * stream.uniform(-1.0, 1.0);
    turn_root(creature, turn, stream.uniform(-kPi, kPi));
    double& step = changed.world.scene.contact_step;
    if (probe.finer) step = std::max(std::min(step, kLeastContactStep), kFiner * step);
    return changed;
}

}  // namespace cambrian
