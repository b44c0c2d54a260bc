#include "app/builtin_kinds.h"

#include "dynamics/planar_scene.h"

namespace cambrian {

EvolutionKinds builtin_kinds() {
    return {.creature = make_kinds(builtin_neuron_functions(), builtin_sensors(),
                                   builtin_effectors(), planar_scene_kind()),
            .mutations = builtin_mutations(),
            .breeding = builtin_breeding(),
            .goals = builtin_goals(),
            .selections = builtin_selections()};
}

}  // namespace cambrian
