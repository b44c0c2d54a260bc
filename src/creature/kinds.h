#pragma once

// Every registry a phenotype can draw from; filled once by the application before any thread
// starts, then shared by const reference for the life of the program.

#include "brain/neuron_function.h"
#include "effectors/effector.h"
#include "genome/kind_catalog.h"
#include "sensors/sensor.h"
#include "world/scene_kind.h"

namespace cambrian {

struct Kinds {
    NeuronFunctionRegistry functions;
    SensorRegistry sensors;
    EffectorRegistry effectors;
    SceneKind scene;
    KindCatalog catalog;  // of the above, for genes
};

// Fills the catalog from the registries.
Kinds make_kinds(NeuronFunctionRegistry functions, SensorRegistry sensors,
                 EffectorRegistry effectors, SceneKind scene);

}  // namespace cambrian
