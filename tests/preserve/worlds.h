#pragma once

// Small preserves for tests.

#include "evolution/fields/setting_field.h"
#include "persist/preserve/preserve_file.h"
#include "persist/sqlite/database.h"
#include "preserve/laws.h"
#include "preserve/preserve.h"
#include "preserve/replay.h"
#include "simulator/simulator_version.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <catch2/catch.hpp>

#include <deque>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace cambrian::test {

inline ExperimentSettings small_world() {
    ExperimentSettings settings = preserve_defaults(kinds());
    settings.preserve.bodies = "ghostly";
    settings.preserve.width = 12.0;
    settings.preserve.height = 10.0;
    settings.preserve.founders = 10;
    settings.preserve.energy_density = 100.0;
    return settings;
}

// Returns a fish whose head is a mouth with that diet.
inline GenomePtr eater(double diet, double width = 0.2) {
    CreatureBuilder builder(kind_catalog());
    const auto head = builder.part(0.4, width);
    const auto tail = builder.part(0.5, 0.15);
    builder.attach(head, tail, 0.625);
    builder.swing(tail, 1.0, 0.0, 0.6);
    builder.organ(head, "mouth", 0, 0.0, diet);
    return builder.build();
}

// Returns an eel of so many parts, each `length` (m) long, whose joints follow each other by a lag
// (cycles).
inline GenomePtr eel(int parts, double length, double lag, double amplitude) {
    CreatureBuilder builder(kind_catalog());
    auto last = builder.part(length, 0.1);
    for (int i = 0; i < parts - 1; ++i) {
        const auto next = builder.part(length, 0.1);
        builder.attach(last, next, 0.125);
        builder.swing(next, 1.0, lag * i, amplitude);
        last = next;
    }
    return builder.build();
}

inline std::unique_ptr<Preserve> begun(const ExperimentSettings& settings,
                                       std::vector<GenomePtr> founders) {
    auto preserve = Preserve::begin(std::make_shared<const ExperimentSettings>(settings), kinds(),
                                    std::move(founders));
    INFO((preserve ? "" : preserve.error().message));
    REQUIRE(preserve);
    return std::move(*preserve);
}

inline void run_to(Preserve& preserve, std::uint64_t tick) {
    ThreadPool pool(1);
    while (preserve.ticks() < tick)
        preserve.tick(pool);
}

inline std::uint64_t digest(const Preserve& preserve) {
    return digest_of(words_of(preserve.save()));
}

// Requires that the residents, which have these genotypes, move for ten seconds exactly as each
// does in a scene of its own.
inline void check_moved_as_alone(Preserve& preserve, const ExperimentSettings& settings,
                                 const std::vector<GenomePtr>& genomes) {
    struct Alone {
        Phenotype phenotype;
        std::unique_ptr<PhysicsScene> scene;
        std::unique_ptr<Creature> creature;
    };
    std::deque<Alone> alone;  // their places last
    const auto& residents = preserve.residents();
    REQUIRE(residents.size() == genomes.size());
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        Alone& each = alone.emplace_back();
        each.phenotype =
            express(*genomes[i], creature_kinds(), settings.expression, settings.world.scene);
        auto scene = creature_kinds().scene.make(each.phenotype.plan, settings.world.environment,
                                                 settings.world.scene);
        REQUIRE(scene);
        each.scene = *std::move(scene);
        REQUIRE(each.scene->begin_at(residents[i]->save().motion));
        each.creature =
            std::make_unique<Creature>(each.phenotype, creature_kinds(), settings.world.scene);
    }
    const CommonSenses senses(area_of(settings.preserve, settings.world.environment),
                              settings.world.environment);
    const CreatureSenses surroundings(senses, 1);
    ThreadPool pool(2);
    for (int tick = 0; tick < 600; ++tick) {
        preserve.tick(pool);
        for (Alone& each : alone) {
            each.creature->act(*each.scene, surroundings, kBrainTick);
            each.scene->advance(kBrainTick);
        }
    }
    REQUIRE(residents.size() == genomes.size());
    for (std::size_t i = 0; i < genomes.size(); ++i) {
        const SceneMotion moved = residents[i]->save().motion;
        CHECK(moved.positions == alone[i].scene->motion().positions);
        CHECK(moved.speeds == alone[i].scene->motion().speeds);
    }
}

// Requires that a world of solid creatures has the same bits after some ticks on 1, 2 and 7
// threads, and that more than so many ticks of creatures were computed with others.
inline void check_same_on_any_threads(const ExperimentSettings& settings,
                                      const std::vector<GenomePtr>& founders, std::uint64_t ticks,
                                      std::uint64_t fewest_joined) {
    std::vector<std::uint64_t> digests;
    for (const std::size_t workers : {1U, 2U, 7U}) {
        const auto preserve = begun(settings, founders);
        ThreadPool pool(workers);
        while (preserve->ticks() < ticks)
            preserve->tick(pool);
        CHECK(preserve->solid_counts().joined_ticks > fewest_joined);
        digests.push_back(digest(*preserve));
    }
    CHECK(digests[1] == digests[0]);
    CHECK(digests[2] == digests[0]);
}

// A preserve of a small world in a new file, and what both began with.
struct KeptWorld {
    SettingsPtr settings;
    std::vector<GenomePtr> founders;
    std::unique_ptr<Preserve> preserve;
    std::unique_ptr<PreserveFile> file;
};

inline KeptWorld kept_in(const std::filesystem::path& path, const ExperimentSettings& settings) {
    KeptWorld world{.settings = std::make_shared<const ExperimentSettings>(settings),
                    .founders = {eater(0.0), eater(1.0)},
                    .preserve = nullptr,
                    .file = nullptr};
    world.preserve = begun(settings, world.founders);
    auto file =
        PreserveFile::create(path, {world.settings, world.founders, std::string(kSimulatorVersion)},
                             world.preserve->take_chronicle(), *world.preserve, kinds());
    REQUIRE(file);
    world.file = *std::move(file);
    return world;
}

// Does the same with small_world(), closes the file and changes its tables by SQL.
inline KeptWorld changed_in(const std::filesystem::path& path, const std::string& changes) {
    KeptWorld world = kept_in(path, small_world());
    world.file.reset();
    Database(path, Database::Access::kWrite).execute(changes);
    return world;
}

// Requires that a file leads from a snapshot to the next one with the same bits, and returns what
// people did between them.
inline std::vector<Intervention> repeated_from(const std::filesystem::path& path,
                                               const KeptWorld& world, std::size_t index) {
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    REQUIRE(saved->snapshots.size() > index + 1);
    const SnapshotEntry& from = saved->snapshots[index];
    const SnapshotEntry& to = saved->snapshots[index + 1];
    const auto state = load_snapshot(path, from, kinds());
    REQUIRE(state);
    const auto laws = laws_at(world.settings, saved->interventions, from.tick, kinds());
    REQUIRE(laws);
    const auto replayed = Preserve::resume(world.settings, kinds(), world.founders, *state, *laws);
    REQUIRE(replayed);
    const auto all = interventions_in(saved->interventions, {from.tick, to.tick});
    std::span<const Intervention> left(all);
    while (!left.empty()) {
        REQUIRE(repeat(**replayed, left));
        if (!left.empty()) run_to(**replayed, (*replayed)->ticks() + 1);
    }
    const auto snapshot = (*replayed)->take_chronicle().snapshot;
    REQUIRE(snapshot);
    CHECK(digest_of(words_of(*snapshot)) == to.digest);
    return all;
}

// Requires that a world goes on from its file with the bits of the one that was not interrupted,
// and returns the settings in the file.
inline SettingsPtr check_goes_on(const std::filesystem::path& path,
                                 const std::vector<GenomePtr>& founders, const Preserve& uncut) {
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    const auto resumed =
        Preserve::resume(opened->origin.settings, kinds(), founders, opened->state);
    REQUIRE(resumed);
    run_to(**resumed, uncut.ticks());
    CHECK(digest(**resumed) == digest(uncut));
    return opened->origin.settings;
}

}  // namespace cambrian::test
