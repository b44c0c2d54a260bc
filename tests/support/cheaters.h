#pragma once

// Hand-made creatures that once scored without the behaviour that the goal rewards, one trick each.

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
