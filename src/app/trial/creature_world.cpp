#include "app/trial/creature_world.h"

#include "persist/settings/settings_file.h"

namespace cambrian {

Result<ExperimentSettings> world_of(const CreatureDocument& document,
                                    const std::string& environment, const EvolutionKinds& kinds) {
    if (!environment.empty()) return load_settings(environment, kinds);
    return document.settings();
}

}  // namespace cambrian
