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

OrganEntry catalog_entry(const OrganKind& organ) {
    OrganEntry entry{
        .id = organ.id, .label = organ.label, .parameters = {}, .single = organ.shape != nullptr};
    for (const OrganParameter& each : organ.parameters) {
        // A step has the size that the parameter's range gives it, wherever in it the value is.
        const double range = each.high - each.low;
        entry.parameters.push_back({.name = each.name,
                                    .key = each.key,
                                    .low = each.low,
                                    .high = each.high,
                                    .fallback = each.fallback,
                                    .step = {.relative = 0.2, .floor = range},
                                    .unit = each.unit,
                                    .whole = each.whole,
                                    .help = each.help});
    }
    return entry;
}

}  // namespace

Kinds make_kinds(NeuronFunctionRegistry functions, SensorRegistry sensors,
                 EffectorRegistry effectors, OrganRegistry organs, SceneKind scene) {
    KindCatalog catalog;
    catalog.dimensions = scene.dimensions;
    for (const NeuronFunctionKind& function : functions.all())
        catalog.functions.push_back(catalog_entry(function));
    for (const JointKind& joint : scene.joints.all())
        catalog.joints.push_back({joint.id, joint.label, joint.degrees_of_freedom(), joint.usual});
    for (const EffectorKind& effector : effectors.all())
        catalog.effectors.push_back({effector.id, effector.label});
    for (const OrganKind& organ : organs.all())
        catalog.organs.push_back(catalog_entry(organ));
    for (const SensorKind& sensor : sensors.all()) {
        for (const SensorChannel& channel : sensor.channels)
            catalog.channels.push_back({channel.id, channel.label, sensor.usual, sensor.group});
    }
    const Placement& placement = scene.dimensions == 3 ? spatial_placement() : planar_placement();
    return {std::move(functions), std::move(sensors), std::move(effectors), std::move(organs),
            std::move(scene),     placement,          std::move(catalog)};
}

}  // namespace cambrian
