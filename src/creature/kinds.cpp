#include "creature/kinds.h"

#include <utility>

namespace cambrian {
namespace {

FunctionEntry catalog_entry(const NeuronFunctionKind& function) {
    FunctionEntry entry{function.id, function.label, function.arity, {}};
    for (const NeuronFunctionKind::InputHint& hint : function.input_hints)
        entry.founder_inputs.push_back({hint.probability, hint.low, hint.high});
    return entry;
}

}  // namespace

Kinds make_kinds(NeuronFunctionRegistry functions, SensorRegistry sensors,
                 EffectorRegistry effectors, SceneKind scene) {
    KindCatalog catalog;
    for (const NeuronFunctionKind& function : functions.all())
        catalog.functions.push_back(catalog_entry(function));
    for (const JointKind& joint : scene.joints.all())
        catalog.joints.push_back({joint.id, joint.label, joint.degrees_of_freedom(), joint.usual});
    for (const EffectorKind& effector : effectors.all())
        catalog.effectors.push_back({effector.id, effector.label});
    for (const SensorKind& sensor : sensors.all()) {
        for (const SensorChannel& channel : sensor.channels)
            catalog.channels.push_back({channel.id, channel.label, sensor.usual});
    }
    return {std::move(functions), std::move(sensors), std::move(effectors), std::move(scene),
            std::move(catalog)};
}

}  // namespace cambrian
