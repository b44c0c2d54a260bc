#pragma once

// All registries on which a phenotype depends. The application fills them before any thread starts;
// afterwards they are shared by const reference.

#include "brain/neuron_function.h"
#include "creature/placement.h"
#include "effectors/effector.h"
#include "genome/kind_catalog.h"
#include "organs/organ.h"
#include "sensors/sensor.h"
#include "world/scene_kind.h"

namespace cambrian {

struct Kinds {
    NeuronFunctionRegistry functions;
    SensorRegistry sensors;
    EffectorRegistry effectors;
    OrganRegistry organs;
    SceneKind scene;
    Placement placement;  // of parts at each other, in as many dimensions as the scene
    KindCatalog catalog;  // the kinds of the registries above, as genes use them
};

// Returns the registries with a catalog filled from them.
Kinds make_kinds(NeuronFunctionRegistry functions, SensorRegistry sensors,
                 EffectorRegistry effectors, OrganRegistry organs, SceneKind scene);

}  // namespace cambrian
