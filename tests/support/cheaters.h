#pragma once

// Hand-made creatures that once scored without the behaviour that the goal rewards, one trick each.

#include "math/elementary.h"
#include "support/creatures.h"

namespace cambrian::test {

// Returns a body on two long legs that it pulls up beside itself once, `delay` seconds after birth.
// It then falls with its feet in the air.
inline GenomePtr feet_puller(const KindCatalog& catalog, double delay) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.5, 0.3);
    for (const double side : {-1.0, 1.0}) {
        const auto leg = builder.part(0.6, 0.2);
        builder.attach(body, leg, 0.875 + 0.1 * side, 0.5 * side);
        builder.limits(leg, -2.0, 2.0);
        builder.drive(leg, alarm(builder, leg, delay, 1.8), side);
    }
    return builder.build();
}

// Returns a body that rises on two wings and sinks again without leaving the ground.
inline GenomePtr stander_up(const KindCatalog& catalog) {
    return flapper(catalog, 0.2, 1.4);
}

// Returns a body that throws a long arm from its back to its front once, `delay` seconds after
// birth.
inline GenomePtr limb_thrower(const KindCatalog& catalog, double delay) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.5, 0.4);
    const auto arm = builder.part(0.9, 0.25);
    builder.attach(body, arm, 0.4, 1.2);
    builder.limits(arm, -2.6, 2.6);
    builder.drive(arm, alarm(builder, arm, delay, 2.5), -1.0);
    return builder.build();
}

// Returns a body that slowly draws in a long tail during the trial, so that its rear end moves
// forward.
inline GenomePtr slow_sinker(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.5);
    const auto tail = builder.part(0.8, 0.3);
    builder.attach(body, tail, 0.625);
    builder.limits(tail, -1.6, 1.6);
    const auto clock =
        builder.neuron(tail, "oscillate-saw",
                       {CreatureBuilder::constant(1.0 / 30.0), CreatureBuilder::constant(0.0)});
    const auto begun = builder.neuron(tail, "sum",
                                      {CreatureBuilder::from(clock), CreatureBuilder::constant(1.0),
                                       CreatureBuilder::constant(0.0)});
    builder.drive(tail, begun, -1.5);
    return builder.build();
}

// Returns the fish with its tail bent to one side, so that it swims in circles.
inline GenomePtr circler(const KindCatalog& catalog) {
    return fish(catalog, 0.7);
}

// Returns a body that shakes two wings much faster than joints should move.
inline GenomePtr vibrator(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.4);
    for (const double side : {-1.0, 1.0}) {
        const auto wing = builder.part(0.3, 0.3);
        builder.attach(body, wing, 0.375 - 0.25 * side);
        // The product of two waves that differ by a quarter period has twice their frequency.
        std::vector<InputGene> waves;
        for (const double phase : {0.0, 0.25}) {
            waves.push_back(CreatureBuilder::from(builder.neuron(
                wing, "oscillate-wave",
                {CreatureBuilder::constant(3.5), CreatureBuilder::constant(phase)})));
        }
        builder.drive(wing, builder.neuron(wing, "product", waves), 4.0 * side);
    }
    return builder.build();
}

// Returns a spiral of boxes with rigid joints and one arm that tips it over, `delay` seconds after
// birth. It then rolls along its own shape.
inline GenomePtr roller(const KindCatalog& catalog, double delay) {
    CreatureBuilder builder(catalog);
    const auto foot = builder.part(0.5, 0.14);
    const auto arm = builder.part(0.8, 0.3);
    builder.attach(foot, arm, 0.375);
    builder.limits(arm, -2.0, 2.0);
    auto last = foot;
    for (int i = 0; i < 5; ++i) {
        const auto next = builder.part(0.5, 0.14, "rigid");
        builder.attach(last, next, 0.125, -0.8);
        last = next;
    }
    builder.drive(arm, alarm(builder, arm, delay, 1.9), -1.0);
    return builder.build();
}

// Returns a ring of boxes with rigid joints, all but round, and a light flap inside that trembles.
inline GenomePtr wheel(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    constexpr double kTurn = 2.0 * kPi / 15.0;
    const auto first = builder.part(0.2, 0.6);
    auto front = first;
    auto back = first;
    for (int i = 0; i < 7; ++i) {
        const auto next_front = builder.part(0.2, 0.6, "rigid");
        const auto next_back = builder.part(0.2, 0.6, "rigid");
        builder.attach(front, next_front, 0.125, kTurn);
        builder.attach(back, next_back, i == 0 ? 0.625 : 0.125, -kTurn);
        front = next_front;
        back = next_back;
        if (i > 0) continue;
        const auto flap = builder.part(gene_range::kMinSize, gene_range::kMinSize);
        builder.attach(first, flap, 0.375);
        builder.swing(flap, 0.2, 0.0, 0.05);
    }
    return builder.build();
}

// Returns a tower that leans to the right, so that it falls before anything drives it.
inline GenomePtr leaning_tower(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto tower = builder.part(1.6, 0.3);
    const auto flap = builder.part(0.1, 0.1);
    builder.attach(tower, flap, 0.125);
    builder.stand_at(kHalfPi - 0.4);
    builder.swing(flap, 0.2, 0.0, 0.02);
    return builder.build();
}

// Returns a low plate that only trembles.
inline GenomePtr still_plate(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto plate = builder.part(1.0, 0.3);
    const auto flap = builder.part(0.1, 0.1);
    builder.attach(plate, flap, 0.125);
    builder.swing(flap, 0.2, 0.0, 0.02);
    return builder.build();
}

// Returns a tower that stands still.
inline GenomePtr still_tower(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto tower = builder.part(1.6, 0.5);
    const auto flap = builder.part(0.1, 0.1);
    builder.attach(tower, flap, 0.375);
    builder.stand_at(kHalfPi);
    builder.swing(flap, 0.2, 0.0, 0.02);
    return builder.build();
}

// Returns four links that lie in a square and open to a line once.
inline GenomePtr unfolder(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    auto last = builder.part(0.6, 0.1);
    for (int i = 0; i < 3; ++i) {
        const auto next = builder.part(0.6, 0.1);
        builder.attach(last, next, 0.125, 1.4);
        builder.limits(next, -2.6, 2.6);
        builder.drive(next, alarm(builder, next, 0.5, 1.4), -1.0);
        last = next;
    }
    return builder.build();
}

// Returns the drifter as it begins across the axes, where its bounds are smallest.
inline GenomePtr oblique_drifter(const KindCatalog& catalog) {
    Genome genome = *drifter(catalog);
    genome.root_angle = 0.5 * kHalfPi;
    return std::make_shared<const Genome>(std::move(genome));
}

// Returns a body that stays in place while a heavy arm swings to and fro.
inline GenomePtr rocker(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.8, 0.4);
    const auto arm = builder.part(0.9, 0.3);
    builder.attach(body, arm, 0.375);
    builder.limits(arm, -1.6, 1.6);
    builder.swing(arm, 0.4, 0.0, 1.5);
    return builder.build();
}

}  // namespace cambrian::test
