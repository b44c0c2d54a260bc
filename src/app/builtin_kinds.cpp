#include "app/builtin_kinds.h"

#include "dynamics/planar_scene.h"

namespace cambrian {

EvolutionKinds builtin_kinds() {
    return make_evolution_kinds(
        make_kinds(builtin_neuron_functions(), builtin_sensors(), builtin_effectors(),
                   builtin_organs(), planar_scene_kind()),
        builtin_mutations(), builtin_breeding(), builtin_goals(), builtin_selections());
}

}  // namespace cambrian
