#pragma once

// Hand-made creatures for tests of trials and goals.

#include "genome/genome.h"
#include "support/catch.h"

#include <algorithm>
#include <string_view>

namespace cambrian::test {

class CreatureBuilder {
public:
    explicit CreatureBuilder(const KindCatalog& catalog) : catalog_(catalog) {}

    // Adds a part and returns its node index; the first part is the root.
    std::uint8_t part(double length, double width, std::string_view joint = "rotary") {
        NodeGene node;
        node.length = length;
        node.width = width;
        node.joint = index_of(catalog_.joints, joint);
        genome_.nodes.push_back(node);
        return static_cast<std::uint8_t>(genome_.nodes.size() - 1);
    }
    void attach(std::uint8_t parent, std::uint8_t child, double position, double angle = 0.0) {
        EdgeGene edge;
        edge.target = child;
        edge.position = position;
        edge.angle = angle;
        genome_.nodes[parent].edges.push_back(edge);
    }
    // Adds a neuron with constant inputs to a part and returns its index there.
    std::uint8_t neuron(std::uint8_t node, std::string_view function,
                        std::vector<InputGene> inputs) {
        auto& neurons = genome_.nodes[node].neurons;
        neurons.push_back({index_of(catalog_.functions, function), std::move(inputs)});
        return static_cast<std::uint8_t>(neurons.size() - 1);
    }
    // The part's joint follows one of its own neurons.
    void drive(std::uint8_t node, std::uint8_t neuron, double weight) {
        genome_.nodes[node].effector = {from(neuron).source, weight};
    }
    // The part's joint follows a sine.
    void swing(std::uint8_t node, double frequency, double phase, double amplitude) {
        drive(node, neuron(node, "oscillate-wave", {constant(frequency), constant(phase)}),
              amplitude);
    }
    // Adds an organ that follows one of the part's own neurons.
    void organ(std::uint8_t node, std::string_view kind, std::uint8_t neuron, double weight,
               double parameter = 0.0) {
        const std::uint8_t index = index_of(catalog_.organs, kind);
        genome_.nodes[node].organs.push_back(
            {index, {from(neuron).source, weight}, {parameter, 0.0}});
    }
    void limits(std::uint8_t node, double low, double high) {
        genome_.nodes[node].limit_low = low;
        genome_.nodes[node].limit_high = high;
    }
    void stand_at(double angle) { genome_.root_angle = angle; }

    static InputGene constant(double value) { return {{}, value}; }
    static InputGene from(std::uint8_t neuron) {
        return {{.kind = SourceKind::kLocalNeuron, .index = neuron}, 1.0};
    }

    GenomePtr build() const {
        const auto faults = validate(genome_, catalog_);
        INFO((faults.empty() ? std::string() : faults.front()));
        REQUIRE(faults.empty());
        return std::make_shared<const Genome>(genome_);
    }

    template <class Entries>
    static std::uint8_t index_of(const Entries& entries, std::string_view id) {
        const auto found = std::find_if(entries.begin(), entries.end(),
                                        [&](const auto& entry) { return entry.id == id; });
        REQUIRE(found != entries.end());
        return static_cast<std::uint8_t>(found - entries.begin());
    }

private:
    const KindCatalog& catalog_;
    Genome genome_;
};

constexpr double kHalfPi = 1.5707963267948966;

// Returns a body with a sine-driven leg at each end, a quarter period apart.
inline GenomePtr crawler(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.8, 0.2);
    const auto front = builder.part(0.4, 0.14);
    const auto back = builder.part(0.4, 0.14);
    builder.attach(body, front, 0.12, -1.3);
    builder.attach(body, back, 0.63, 1.3);
    builder.swing(front, 0.7, 0.0, 1.0);
    builder.swing(back, 0.7, 0.25, 1.0);
    return builder.build();
}

// Returns two boxes, one on the other, with a rigid joint.
inline GenomePtr rigid_tower(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto base = builder.part(1.2, 0.2);
    const auto top = builder.part(1.0, 0.2, "rigid");
    builder.attach(base, top, 0.125);
    builder.stand_at(kHalfPi);
    return builder.build();
}

// Adds neurons that give 0 until `delay` seconds after birth (0 to 15) and `value` from then on.
// Returns the last one's index.
inline std::uint8_t alarm(CreatureBuilder& builder, std::uint8_t node, double delay, double value) {
    const double frequency = 1.0 / 40.0;  // a slow saw tooth serves as a clock
    const auto clock =
        builder.neuron(node, "oscillate-saw",
                       {CreatureBuilder::constant(frequency), CreatureBuilder::constant(0)});
    const double threshold = 2.0 * frequency * delay - 1.0;
    const auto late = builder.neuron(
        node, "greater-than", {CreatureBuilder::from(clock), CreatureBuilder::constant(threshold)});
    return builder.neuron(node, "if",
                          {CreatureBuilder::from(late), CreatureBuilder::constant(value),
                           CreatureBuilder::constant(0.0)});
}

// Returns a tall tower that tips itself over with an arm, `delay` seconds after birth (0 to 15).
inline GenomePtr falling_tower(const KindCatalog& catalog, double delay) {
    CreatureBuilder builder(catalog);
    const auto tower = builder.part(1.6, 0.14);
    const auto arm = builder.part(0.7, 0.2);
    builder.attach(tower, arm, 0.125);
    builder.limits(arm, -2.0, 2.0);
    builder.stand_at(kHalfPi);
    builder.drive(arm, alarm(builder, arm, delay, 1.9), 1.0);
    return builder.build();
}

// Returns a body with two folded legs that it kicks down by an angle (rad) once, `delay` seconds
// after birth.
inline GenomePtr kicker(const KindCatalog& catalog, double delay, double angle = 1.35) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.4, 0.2);
    for (const double side : {-1.0, 1.0}) {
        const auto leg = builder.part(0.5, 0.2);
        builder.attach(body, leg, 0.875 + 0.075 * side, 1.35 * side);
        builder.limits(leg, -2.0, 2.0);
        builder.drive(leg, alarm(builder, leg, delay, angle), -side);
    }
    return builder.build();
}

// Returns a flat body that lifts an arm and stays on the ground.
inline GenomePtr arm_raiser(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(1.0, 0.3);
    const auto arm = builder.part(0.5, 0.1);
    builder.attach(body, arm, 0.02, 0.0);
    builder.limits(arm, -1.5, 1.5);
    builder.drive(arm, alarm(builder, arm, 2.0, 1.4), 1.0);
    return builder.build();
}

// Returns a body with two heavy wings on the ground beside it that beat together.
inline GenomePtr flapper(const KindCatalog& catalog, double frequency, double amplitude) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.6);
    for (const double side : {-1.0, 1.0}) {
        const auto wing = builder.part(1.0, 0.5);
        builder.attach(body, wing, 0.375 - 0.25 * side);
        builder.limits(wing, -1.5, 1.5);
        builder.swing(wing, frequency, 0.0, side * amplitude);
    }
    return builder.build();
}

// Returns a body with a tail of two links that beat one after the other.
inline GenomePtr fish(const KindCatalog& catalog, double bend = 0.0) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.16);
    const auto tail = builder.part(0.35, 0.1);
    const auto fin = builder.part(0.3, 0.08);
    builder.attach(body, tail, 0.125, bend);
    builder.attach(tail, fin, 0.125, bend);
    builder.swing(tail, 1.0, 0.0, 0.7);
    builder.swing(fin, 1.0, -0.25, 0.9);
    return builder.build();
}

// Returns the fish's body with a tail that beats once, 1 s after birth, and then stays still.
inline GenomePtr drifter(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.16);
    const auto tail = builder.part(0.35, 0.1);
    builder.attach(body, tail, 0.125);
    builder.limits(tail, -1.5, 1.5);
    builder.drive(tail, alarm(builder, tail, 1.0, 1.4), 1.0);
    return builder.build();
}

// Returns one box with an arm whose signal never changes.
inline GenomePtr dreamer(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.5, 0.2);
    builder.attach(body, builder.part(0.3, 0.1), 0.1);
    return builder.build();
}

}  // namespace cambrian::test
