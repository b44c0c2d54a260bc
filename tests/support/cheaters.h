#pragma once

// Hand-made creatures that earned scores without the deed; each builder makes one trick.

#include "support/creatures.h"

namespace cambrian::test {

// A body on two long legs that it pulls up beside itself, once, `delay` seconds after birth: it
// drops, with its feet in the air.
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

// A body that gets up on two wings and down again, without ever leaving the ground.
inline GenomePtr stander_up(const KindCatalog& catalog) {
    return flapper(catalog, 0.2, 1.4);
}

// A body that throws a long arm from behind over to its front, once, `delay` seconds after birth.
inline GenomePtr limb_thrower(const KindCatalog& catalog, double delay) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.5, 0.4);
    const auto arm = builder.part(0.9, 0.25);
    builder.attach(body, arm, 0.4, 1.2);
    builder.limits(arm, -2.6, 2.6);
    builder.drive(arm, alarm(builder, arm, delay, 2.5), -1.0);
    return builder.build();
}

// A body that draws in a long tail all the trial long, so that its rear end creeps forward.
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

// The fish with its tail held to one side: it swims in circles.
inline GenomePtr circler(const KindCatalog& catalog) {
    return fish(catalog, 0.7);
}

// A body that shivers with two wings far faster than joints can be expected to go.
inline GenomePtr vibrator(const KindCatalog& catalog) {
    CreatureBuilder builder(catalog);
    const auto body = builder.part(0.6, 0.4);
    for (const double side : {-1.0, 1.0}) {
        const auto wing = builder.part(0.3, 0.3);
        builder.attach(body, wing, 0.375 - 0.25 * side);
        // The product of two waves a quarter apart has twice their frequency.
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

// A spiral of boxes, stiff but for an arm that tips it over, `delay` seconds after birth: it rolls
// down its own shape.
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

// A heavy arm that swings to and fro on a body that stays where it is.
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
