#include "creature/lesion.h"

#include "core/assert.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <functional>

namespace cambrian {
namespace {

constexpr std::array<std::string_view, kLesionKindCount> kLesionIds = {
    "limp-part", "lost-part",   "locked-joint", "silent-neuron",
    "cut-link",  "held-sensor", "still-organ"};

constexpr int kGone = -1;

// Returns for each part whether it is the first one or beyond it.
std::vector<bool> from_outwards(const Phenotype& phenotype, std::size_t first) {
    std::vector<bool> covered(phenotype.parts.size(), false);
    for (std::size_t i = first; i < covered.size(); ++i) {
        const int parent = phenotype.parts[i].parent;
        covered[i] = i == first || (parent >= 0 && covered[static_cast<std::size_t>(parent)]);
    }
    return covered;
}

void weaken(PlannedPart& part) {
    part.max_effort = 0.0;
    for (DegreeLimits& degree : part.further)
        degree.max_effort = 0.0;
    if (part.stretch) part.stretch->max_effort = 0.0;
}

void make_limp(Phenotype& phenotype, std::size_t first) {
    const std::vector<bool> covered = from_outwards(phenotype, first);
    for (std::size_t i = 0; i < covered.size(); ++i)
        if (covered[i]) weaken(phenotype.plan.parts[i]);
}

void silence(Phenotype& phenotype, std::size_t neuron) {
    Network& network = phenotype.network;
    const Slot silent = network.neuron_slot(neuron);
    for (NetworkNeuron& reader : network.neurons)
        for (NetworkInput& input : reader.inputs)
            if (input.slot == silent) input.slot = network.zero_slot();
    for (NetworkInput& output : network.outputs)
        if (output.slot == silent) output.slot = network.zero_slot();
}

// Drops the effectors and organs whose part is one of those, with their outputs.
void drop_muscles(Phenotype& phenotype, const std::vector<bool>& parts) {
    Phenotype kept;
    std::vector<NetworkInput> outputs;
    for (std::size_t i = 0; i < phenotype.effectors.size(); ++i) {
        if (parts[phenotype.effectors[i].part]) continue;
        kept.effectors.push_back(phenotype.effectors[i]);
        kept.effector_kinds.push_back(phenotype.effector_kinds[i]);
        outputs.push_back(phenotype.network.outputs[i]);
    }
    const auto organs =
        phenotype.network.outputs.begin() + static_cast<std::ptrdiff_t>(phenotype.effectors.size());
    outputs.insert(outputs.end(), organs, phenotype.network.outputs.end());
    phenotype.effectors = std::move(kept.effectors);
    phenotype.effector_kinds = std::move(kept.effector_kinds);
    phenotype.network.outputs = std::move(outputs);
}

void drop_organs(Phenotype& phenotype, const std::vector<bool>& parts) {
    std::vector<GrownOrgan> organs;
    std::vector<NetworkInput> outputs = phenotype.network.outputs;
    outputs.resize(phenotype.effectors.size());
    for (std::size_t i = 0; i < phenotype.organs.size(); ++i) {
        if (parts[phenotype.organs[i].part]) continue;
        organs.push_back(phenotype.organs[i]);
        outputs.push_back(phenotype.network.outputs[phenotype.effectors.size() + i]);
    }
    phenotype.organs = std::move(organs);
    phenotype.network.outputs = std::move(outputs);
}

void lock_joint(Phenotype& phenotype, std::size_t joint) {
    std::vector<bool> locked(phenotype.parts.size(), false);
    locked[joint] = true;
    drop_muscles(phenotype, locked);
    phenotype.plan.parts[joint].motion = JointMotion::kFixed;
}

// Sensors of lost parts read 0, and their neurons are silent.
void lose_part(Phenotype& phenotype, std::size_t first) {
    const std::vector<bool> lost = from_outwards(phenotype, first);
    drop_muscles(phenotype, lost);
    drop_organs(phenotype, lost);
    std::vector<int> place(lost.size(), kGone);
    std::vector<BodyPart> parts;
    std::vector<PlannedPart> planned;
    for (std::size_t i = 0; i < lost.size(); ++i) {
        const BodyPart& part = phenotype.parts[i];
        if (lost[i]) {
            for (std::uint32_t n = 0; n < part.neuron_count; ++n)
                silence(phenotype, part.first_neuron + n);
            continue;
        }
        place[i] = static_cast<int>(parts.size());
        parts.push_back(part);
        planned.push_back(phenotype.plan.parts[i]);
        if (part.parent < 0) continue;
        parts.back().parent = place[static_cast<std::size_t>(part.parent)];
        planned.back().parent = parts.back().parent;
    }
    const auto moved = [&](std::uint16_t& part) { part = static_cast<std::uint16_t>(place[part]); };
    for (JointDegree& effector : phenotype.effectors)
        moved(effector.part);
    for (GrownOrgan& organ : phenotype.organs)
        moved(organ.part);
    for (WiredSensor& sensor : phenotype.sensors) {
        if (lost[sensor.part]) {
            sensor.held = 0.0;
            sensor.part = 0;
        }
        moved(sensor.part);
    }
    phenotype.parts = std::move(parts);
    phenotype.plan.parts = std::move(planned);
}

NetworkInput& link_of(const Lesion& lesion, Network& network) {
    if (lesion.index < network.neurons.size())
        return network.neurons[lesion.index].inputs[lesion.input];
    return network.outputs[lesion.index - network.neurons.size()];
}

// Inflicts what changes no index.
void inflict_one(const Lesion& lesion, Phenotype& phenotype) {
    Network& network = phenotype.network;
    switch (lesion.kind) {
        case LesionKind::kLimpPart:
            return make_limp(phenotype, lesion.index);
        case LesionKind::kSilentNeuron:
            return silence(phenotype, lesion.index);
        case LesionKind::kCutLink:
            link_of(lesion, network).slot = network.zero_slot();
            return;
        case LesionKind::kHeldSensor:
            phenotype.sensors[lesion.index].held = lesion.constant;
            return;
        case LesionKind::kStillOrgan:
            network.outputs[phenotype.effectors.size() + lesion.index].slot = network.zero_slot();
            return;
        case LesionKind::kLostPart:
        case LesionKind::kLockedJoint:
            return;
    }
}

// The part that owns a neuron, or the number of parts for the central brain.
std::size_t owner_of_neuron(std::size_t neuron, const Phenotype& phenotype) {
    const auto owner =
        std::find_if(phenotype.parts.begin(), phenotype.parts.end(), [&](const BodyPart& part) {
            return neuron >= part.first_neuron && neuron < part.first_neuron + part.neuron_count;
        });
    return static_cast<std::size_t>(owner - phenotype.parts.begin());
}

std::string neuron_words(std::size_t neuron, const Phenotype& phenotype, const Kinds& kinds) {
    const std::string& function = kinds.functions[phenotype.network.neurons[neuron].function].id;
    const std::size_t owner = owner_of_neuron(neuron, phenotype);
    if (owner == phenotype.parts.size())
        return fmt::format("{} {} of the brain", function, neuron - phenotype.first_brain_neuron);
    return fmt::format("{} {} of part {}", function, neuron - phenotype.parts[owner].first_neuron,
                       owner);
}

std::string sensor_words(std::size_t sensor, const Phenotype& phenotype, const Kinds& kinds) {
    const WiredSensor& wired = phenotype.sensors[sensor];
    return fmt::format("{} of part {}", kinds.sensors[wired.kind].channels[wired.channel].id,
                       wired.part);
}

std::string output_words(std::size_t output, const Phenotype& phenotype, const Kinds& kinds) {
    if (output >= phenotype.effectors.size()) {
        const GrownOrgan& organ = phenotype.organs[output - phenotype.effectors.size()];
        return fmt::format("{} of part {}", kinds.organs[organ.kind].id, organ.part);
    }
    const JointDegree& effector = phenotype.effectors[output];
    const std::size_t degrees = degrees_of(phenotype.plan.parts[effector.part]);
    return fmt::format("joint{} of part {}",
                       degrees > 1 ? fmt::format(" degree {}", effector.degree + 1) : "",
                       effector.part);
}

std::string link_words(const Lesion& lesion, const Phenotype& phenotype, const Kinds& kinds) {
    Network network = phenotype.network;
    const Slot from = link_of(lesion, network).slot;
    const std::string source = from < network.sensor_count
                                   ? sensor_words(from, phenotype, kinds)
                                   : neuron_words(from - network.neuron_slot(0), phenotype, kinds);
    const std::string reader =
        lesion.index < network.neurons.size()
            ? neuron_words(lesion.index, phenotype, kinds)
            : output_words(lesion.index - network.neurons.size(), phenotype, kinds);
    return fmt::format("link from {} to {} cut", source, reader);
}

}  // namespace

std::string_view lesion_id(LesionKind kind) {
    return kLesionIds[static_cast<std::size_t>(kind)];
}

std::vector<Lesion> lesions_of(const Phenotype& phenotype) {
    const Network& network = phenotype.network;
    std::vector<Lesion> all;
    const auto add = [&](LesionKind kind, std::size_t index, std::size_t input = 0) {
        all.push_back({kind, static_cast<std::uint32_t>(index), static_cast<std::uint8_t>(input)});
    };
    const auto is_link = [&](const NetworkInput& input) {
        return input.slot < network.sensor_count || input.slot >= network.neuron_slot(0);
    };
    for (const LesionKind kind : {LesionKind::kLostPart, LesionKind::kLimpPart})
        for (std::size_t i = 1; i < phenotype.parts.size(); ++i)
            add(kind, i);
    for (std::size_t i = 1; i < phenotype.parts.size(); ++i)
        if (degrees_of(phenotype.plan.parts[i]) > 0) add(LesionKind::kLockedJoint, i);
    for (const std::uint32_t neuron : network.order)
        add(LesionKind::kSilentNeuron, neuron);
    for (const std::uint32_t neuron : network.order)
        for (std::size_t input = 0; input < network.neurons[neuron].arity; ++input)
            if (is_link(network.neurons[neuron].inputs[input]))
                add(LesionKind::kCutLink, neuron, input);
    for (std::size_t i = 0; i < network.outputs.size(); ++i)
        if (is_link(network.outputs[i])) add(LesionKind::kCutLink, network.neurons.size() + i);
    for (std::size_t i = 0; i < phenotype.sensors.size(); ++i)
        add(LesionKind::kHeldSensor, i);
    for (std::size_t i = 0; i < phenotype.organs.size(); ++i)
        add(LesionKind::kStillOrgan, i);
    return all;
}

void inflict(std::span<const Lesion> lesions, Phenotype& phenotype) {
    std::vector<std::size_t> locked, lost;
    for (const Lesion& lesion : lesions) {
        inflict_one(lesion, phenotype);
        if (lesion.kind == LesionKind::kLockedJoint) locked.push_back(lesion.index);
        if (lesion.kind == LesionKind::kLostPart) lost.push_back(lesion.index);
    }
    for (const std::size_t joint : locked)
        lock_joint(phenotype, joint);
    // Losing a part moves only the parts behind it.
    std::sort(lost.begin(), lost.end(), std::greater());
    for (const std::size_t part : lost)
        lose_part(phenotype, part);
}

int part_of(const Lesion& lesion, const Phenotype& intact) {
    const auto owner = [&](std::size_t neuron) {
        const std::size_t part = owner_of_neuron(neuron, intact);
        return part == intact.parts.size() ? kGone : static_cast<int>(part);
    };
    switch (lesion.kind) {
        case LesionKind::kSilentNeuron:
            return owner(lesion.index);
        case LesionKind::kHeldSensor:
            return intact.sensors[lesion.index].part;
        case LesionKind::kStillOrgan:
            return intact.organs[lesion.index].part;
        case LesionKind::kCutLink: {
            if (lesion.index < intact.network.neurons.size()) return owner(lesion.index);
            const std::size_t output = lesion.index - intact.network.neurons.size();
            if (output < intact.effectors.size()) return intact.effectors[output].part;
            return intact.organs[output - intact.effectors.size()].part;
        }
        case LesionKind::kLimpPart:
        case LesionKind::kLostPart:
        case LesionKind::kLockedJoint:
            break;
    }
    return static_cast<int>(lesion.index);
}

std::string words_of(const Lesion& lesion, const Phenotype& intact, const Kinds& kinds) {
    switch (lesion.kind) {
        case LesionKind::kLimpPart:
            return fmt::format("part {} limp", lesion.index);
        case LesionKind::kLostPart:
            return fmt::format("part {} lost", lesion.index);
        case LesionKind::kLockedJoint:
            return fmt::format("joint of part {} locked", lesion.index);
        case LesionKind::kSilentNeuron:
            return neuron_words(lesion.index, intact, kinds) + " silent";
        case LesionKind::kCutLink:
            return link_words(lesion, intact, kinds);
        case LesionKind::kHeldSensor:
            return sensor_words(lesion.index, intact, kinds) +
                   (lesion.constant == 0.0 ? " silent"
                                           : fmt::format(" at {:.3g}", lesion.constant));
        case LesionKind::kStillOrgan:
            return output_words(intact.effectors.size() + lesion.index, intact, kinds) + " still";
    }
    return {};
}

std::string words_of(std::span<const Lesion> lesions, const Phenotype& intact, const Kinds& kinds) {
    std::string words;
    for (const Lesion& lesion : lesions)
        words += (words.empty() ? "" : " and ") + words_of(lesion, intact, kinds);
    return words;
}

}  // namespace cambrian
