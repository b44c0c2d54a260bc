#include "app/builtin_kinds.h"

#include "planar/planar_scene.h"
#include "spatial/spatial_scene.h"

namespace cambrian {

EvolutionKinds builtin_kinds(int dimensions) {
    const bool in_space = dimensions == 3;
    return make_evolution_kinds(
        make_kinds(builtin_neuron_functions(), in_space ? spatial_sensors() : builtin_sensors(),
                   builtin_effectors(), builtin_organs(),
                   in_space ? spatial_scene_kind() : planar_scene_kind()),
        builtin_mutations(), builtin_breeding(), builtin_goals(), builtin_selections());
}

}  // namespace cambrian
