#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "preserve/life/founders.h"
#include "support/build_speed.h"
#include "worlds.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <string>

namespace cambrian {
namespace {

using namespace test;

// Returns how many random founders have only joints that follow a neuron of their own part.
std::ptrdiff_t rhythmic_founders(const ExperimentSettings& settings) {
    const auto founders = random_founders(settings, kinds());
    REQUIRE(founders);
    const auto follows_itself = [](const NodeGene& node) {
        return node.effector.source.kind == SourceKind::kLocalNeuron;
    };
    return std::count_if(founders->begin(), founders->end(), [&](const GenomePtr& founder) {
        return std::all_of(founder->nodes.begin(), founder->nodes.end(), follows_itself);
    });
}

TEST_CASE("random founders can live where no parts may overlap", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.expression.strict_overlap = true;
    settings.preserve.founders = 40;
    const auto founders = random_founders(settings, kinds());
    REQUIRE(founders);
    CHECK(begun(settings, *founders)->residents().size() == 40);
}

TEST_CASE("energy is constant to the last unit while creatures feed, breed and die", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.founders = 16;
    const auto preserve = begun(settings, {eater(0.0), eater(1.0), fish(kind_catalog())});
    const Energy constant = preserve->founding_energy();
    CHECK(constant == energy_of(100.0 * 12.0 * 10.0));
    ThreadPool pool(1);
    std::size_t births = 0;
    std::size_t deaths = 0;
    const int ticks = by_build(9000, 3000);
    for (int tick = 0; tick < ticks; ++tick) {
        preserve->tick(pool);
        REQUIRE(preserve->total_energy() == constant);
        const Chronicle chronicle = preserve->take_chronicle();
        births += chronicle.born.size();
        deaths += chronicle.died.size();
    }
    CHECK(births > 16);
    CHECK(deaths > 0);
}

TEST_CASE("random founders move in one rhythm unless the settings say otherwise", "[preserve]") {
    ExperimentSettings settings = preserve_defaults(kinds());
    CHECK(rhythmic_founders(settings) == settings.preserve.founders);
    settings.founders.rhythmic_share = 0.0;
    CHECK(rhythmic_founders(settings) < settings.preserve.founders / 2);
}

TEST_CASE("threads do not change the bits of a hundred creatures", "[preserve][threads]") {
    ExperimentSettings settings = preserve_defaults(kinds());
    settings.preserve.bodies = "ghostly";
    settings.preserve.founders = 100;
    settings.founders.channels = {{"sound-1", true}, {"smell", true}, {"smell-food", true}};
    settings.founders.organs = {{"sound", true}, {"scent", true}, {"mouth", true}};
    const auto founders = random_founders(settings, kinds());
    REQUIRE(founders);
    std::vector<std::uint64_t> digests;
    const std::uint64_t digest_interval = by_build<std::uint64_t>(kTicksPerRow, kTicksPerRow / 4);
    for (const std::size_t workers : {1U, 2U, 7U}) {
        const auto preserve = begun(settings, *founders);
        ThreadPool pool(workers);
        std::vector<std::uint64_t> seen;
        for (std::uint64_t tick = 1; tick <= 2 * digest_interval; ++tick) {
            preserve->tick(pool);
            if (tick % digest_interval == 0) seen.push_back(digest(*preserve));
        }
        if (digests.empty()) digests = seen;
        CHECK(seen == digests);
    }
    CHECK(digests.size() == 2);
}

TEST_CASE("a lone creature moves exactly as in a scene of its own", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.founders = 1;
    settings.preserve.plant_energy = 9e3;  // all there is, more than the light has left
    settings.preserve.energy_density = 0.9;
    settings.preserve.max_population = 1;
    settings.preserve.restock = 0;
    settings.preserve.width = 100.0;
    settings.preserve.height = 100.0;
    const auto preserve = begun(settings, {fish(kind_catalog())});
    check_moved_as_alone(*preserve, settings, {fish(kind_catalog())});
}

TEST_CASE("the walls keep swimmers inside", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.width = 6.0;
    settings.preserve.height = 6.0;
    settings.preserve.energy_density = 900.0;
    settings.preserve.founders = 20;
    settings.preserve.bite_power = 0.0;
    const auto preserve = begun(settings, {fish(kind_catalog()), eater(0.0)});
    ThreadPool pool(1);
    int beyond = 0;
    for (int tick = 0; tick < 1200; ++tick) {
        preserve->tick(pool);
        for (const auto& each : preserve->residents()) {
            const Bounds bounds = each->bounds();
            const double most =
                std::max({bounds.high.x(), -bounds.low.x(), bounds.high.y(), -bounds.low.y()});
            CHECK(most < 3.0 + 0.5);
            beyond += most > 3.0 ? 1 : 0;
        }
    }
    CHECK(beyond > 0);
}

// What the founders with a hunter's diet gained, J.
struct Gain {
    double bites = 0.0, all = 0.0;
    void add(const Life& life) {
        if (life.diet < 0.9 || life.method != "founder") return;
        bites += joules(life.bitten);
        all += joules(life.bitten + life.eaten_plants + life.eaten_flesh);
    }
};

TEST_CASE("the sample hunter among grazers lives by bites", "[preserve]") {
    const std::filesystem::path assets = CAMBRIAN_SOURCE_DIR "/assets";
    auto settings =
        load_settings(assets / "settings/hunting.toml", kinds(), SettingsUse::kPreserve);
    REQUIRE(settings);
    std::vector<GenomePtr> founders;
    for (const char* name : {"pike", "carp", "carp", "carp"}) {
        const auto read =
            load_creature(assets / "hunting" / (std::string(name) + ".creature.json"), kinds());
        REQUIRE(read);
        CHECK(read->warnings.empty());
        founders.push_back(read->creature.individual->genome);
    }
    const auto preserve = begun(*settings, founders);
    ThreadPool pool(1);
    Gain gain;
    for (int tick = 0; tick < 40 * 60; ++tick) {
        preserve->tick(pool);
        for (const Life& life : preserve->take_chronicle().died)
            gain.add(life);
    }
    for (const auto& each : preserve->residents())
        gain.add(each->life);
    CHECK(gain.bites > 30.0);
    CHECK(gain.bites > 0.3 * gain.all);
}

TEST_CASE("ears hear other creatures, and noses smell food and flesh", "[preserve]") {
    const Environment water = small_world().world.environment;
    CommonSenses common({20.0, 20.0}, water);
    Food plants({20.0, 20.0});
    Food flesh({20.0, 20.0});
    plants.add(Vec3(3.0, 3.0, 0.0), energy_of(10.0));
    flesh.add(Vec3(-3.0, -3.0, 0.0), energy_of(10.0));
    Emissions call;
    call.sounds.push_back({Vec3(1.0, 0.0, 0.0), 2, 1.0});
    call.scents.push_back({Vec3(0.0, 5.0, 0.0), 1.0});
    common.begin_tick();
    common.take(call, 7);
    common.end_tick(6, plants, flesh);
    const CreatureSenses caller(common, 7);
    const CreatureSenses other(common, 8);
    CHECK(caller.sound(Vec3::Zero(), 2) == 0.0);
    CHECK(other.sound(Vec3::Zero(), 2) == 0.5);
    CHECK(other.sound(Vec3::Zero(), 1) == 0.0);
    CHECK(other.scent(Vec3(0.0, 5.0, 0.0)) > other.scent(Vec3(0.0, -5.0, 0.0)));
    CHECK(other.plant_smell(Vec3(3.0, 3.0, 0.0)) > 0.0);
    CHECK(other.plant_smell(Vec3(-3.0, -3.0, 0.0)) == 0.0);
    CHECK(other.flesh_smell(Vec3(-3.0, -3.0, 0.0)) > 0.0);
}

TEST_CASE("newcomers restock a world below its floor and are paid from its light", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.founders = 6;
    settings.preserve.restock = 6;
    settings.preserve.body_upkeep = 200.0;  // nobody lives for long
    const auto preserve = begun(settings, {eater(0.0)});
    ThreadPool pool(1);
    Chronicle chronicle = preserve->take_chronicle();
    CHECK(chronicle.born.size() == 6);
    for (int tick = 0; tick < 600; ++tick)
        preserve->tick(pool);
    chronicle = preserve->take_chronicle();
    REQUIRE_FALSE(chronicle.interventions.empty());
    CHECK(chronicle.interventions.front().what == "restock");
    CHECK(chronicle.interventions.front().number == 7);
    CHECK(chronicle.interventions.size() == chronicle.born.size());
    CHECK(chronicle.died.front().cause == DeathCause::kHunger);
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("a world that has grown over is restocked, and plants pay for it", "[preserve]") {
    ExperimentSettings settings = small_world();
    settings.preserve.founders = 6;
    settings.preserve.restock = 0;
    settings.preserve.growth_time = 1.0;
    settings.preserve.body_upkeep = 1000.0;  // nobody lives for long
    const auto preserve = begun(settings, {eater(0.0)});
    ThreadPool pool(1);
    for (int tick = 0; tick < 1200; ++tick)
        preserve->tick(pool);
    REQUIRE(preserve->residents().empty());
    REQUIRE(joules(preserve->ambient()) < 2.0 * settings.preserve.plant_energy);
    REQUIRE(preserve->intervene({.what = "law preserve.restock", .x = 6.0}));
    preserve->take_chronicle();
    for (int tick = 0; tick < 60; ++tick)
        preserve->tick(pool);
    CHECK(preserve->take_chronicle().born.size() == 6);
    CHECK(preserve->total_energy() == preserve->founding_energy());
}

TEST_CASE("a lineage begins where more than four genes of the body differ", "[preserve]") {
    const GenomePtr founder = eater(0.0);
    Genome changed = *founder;
    CHECK(differing_body_genes(*founder, changed) == 0);
    changed.nodes[0].length += 0.1;
    changed.nodes[0].width += 0.1;
    changed.nodes[1].limit_low -= 0.1;
    changed.nodes[1].edges.push_back({});
    changed.nodes[1].neurons.clear();
    CHECK(differing_body_genes(*founder, changed) == 4);
    changed.nodes.push_back(changed.nodes[1]);
    CHECK(differing_body_genes(*founder, changed) == 4 + 8 + 1);
    CHECK(differing_body_genes(changed, *founder) == 4 + 8 + 1);
}

}  // namespace
}  // namespace cambrian
