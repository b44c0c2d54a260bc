#include "persist/creature/creature_file.h"

#include "core/random.h"
#include "evolution/evaluation/evaluation.h"
#include "genome/founders/random_genome.h"
#include "persist/sample_creature.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/temporary_directory.h"

#include <algorithm>
#include <array>

using namespace cambrian;
using namespace cambrian::test;

TEST_CASE("a saved creature loads as it was", "[persist][creature_file]") {
    const TemporaryDirectory folder;
    const CreatureDocument saved = sample_document();
    REQUIRE(save_creature(folder / "a.creature.json", saved, kinds()));
    const auto loaded = load_creature(folder / "a.creature.json", kinds());
    REQUIRE(loaded);
    CHECK(loaded->genome() == saved.genome());
    CHECK(loaded->genome().name == saved.genome().name);
    CHECK(loaded->genome().hue == saved.genome().hue);
    CHECK(loaded->genome().nodes[1].uid == 2);
    CHECK(loaded->creature.individual->uid == saved.creature.individual->uid);
    CHECK(loaded->creature.individual->parents == saved.creature.individual->parents);
    CHECK(loaded->creature.individual->method == saved.creature.individual->method);
    CHECK(loaded->scored());
    CHECK(same_score(*loaded, saved));
    CHECK(loaded->warnings.empty());
}

TEST_CASE("random creatures are saved, loaded and saved again to the same bytes",
          "[persist][creature_file]") {
    RandomStream stream(61);
    for (int i = 0; i < 3000; ++i) {
        const CreatureDocument document{unjudged(std::make_shared<const Genome>(
            random_genome(FounderSettings{}, kinds().creature.catalog, stream)))};
        const std::string text = write_creature(document, kinds());
        const auto loaded = parse_creature(text, "test", kinds());
        REQUIRE(loaded);
        REQUIRE(loaded->warnings.empty());
        REQUIRE(loaded->genome() == document.genome());
        REQUIRE(write_creature(*loaded, kinds()) == text);
    }
}

TEST_CASE("creatures with organs come back, as version 3; those without are version 2",
          "[persist][creature_file]") {
    FounderSettings founders;
    founders.organs = {{"sound", true}, {"scent", true}, {"deformer", true}};
    RandomStream stream(62);
    int with = 0;
    for (int i = 0; i < 600; ++i) {
        const CreatureDocument document{unjudged(std::make_shared<const Genome>(
            random_genome(founders, kinds().creature.catalog, stream)))};
        const std::string text = write_creature(document, kinds());
        const auto& nodes = document.genome().nodes;
        const bool organs = std::any_of(nodes.begin(), nodes.end(),
                                        [](const NodeGene& node) { return !node.organs.empty(); });
        with += organs ? 1 : 0;
        CHECK_THAT(text, Catch::Contains(organs ? "\"version\": 3" : "\"version\": 2"));
        CHECK((text.find("organs") != std::string::npos) == organs);
        const auto loaded = parse_creature(text, "test", kinds());
        REQUIRE(loaded);
        REQUIRE(loaded->warnings.empty());
        REQUIRE(loaded->genome() == document.genome());
        REQUIRE(write_creature(*loaded, kinds()) == text);
    }
    CHECK(with > 100);
}

TEST_CASE("the settings of a score survive whatever they are", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.world.environment.gravity = 0.1 + 0.2;
        settings.world.environment.has_ground = false;
        settings.world.scene.tolerance = 3e-5;
        settings.world.trial.duration = 7.5;
        settings.expression.max_parts = 9;
        settings.goal = "swimming";
    });
    const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
    REQUIRE(loaded);
    CHECK(same_score(*loaded, document));
    CHECK(same_judgement(loaded->settings(), document.settings()));
}

TEST_CASE("a score without a light does not name one, a score with one keeps it",
          "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.world.environment = {};
        settings.world.trial = {};
    });
    const std::string dark = write_creature(document, kinds());
    for (const char* key : {"\"light", "\"trials-renewed\"", "\"draw\""})
        CHECK(dark.find(key) == std::string::npos);
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.world.environment.has_light = true;
        settings.world.environment.light_motion = "wandering";
        settings.world.environment.light_x = -2.5;
        settings.world.trial.draw = 7;
    });
    const std::string lit = write_creature(document, kinds());
    CHECK(lit.find("\"light-motion\": \"wandering\"") != std::string::npos);
    CHECK(lit.find("light-range") == std::string::npos);
    const auto read = parse_creature(lit, "it", kinds());
    REQUIRE(read);
    CHECK(read->settings().world == document.settings().world);
}

TEST_CASE("a creature without a score or parents is complete", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    drop_score(document);
    change_individual(document.creature, [](Individual& individual) { individual.parents = {}; });
    const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
    REQUIRE(loaded);
    CHECK_FALSE(loaded->scored());
    CHECK(loaded->creature.individual->parents == std::array<std::uint64_t, 2>{0, 0});
}

TEST_CASE("a creature without a score keeps its world unless it is the default one",
          "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    drop_score(document);
    CHECK_FALSE(document.has_world());
    CHECK(write_creature(document, kinds()).find("\"world\"") == std::string::npos);
    change_settings(document.creature, [](ExperimentSettings& settings) {
        settings.goal = "swimming";
        settings.world.environment = kinds().goals.find("swimming")->default_environment();
        settings.world.environment.viscosity_linear = 0.25;
        settings.world.trial.duration = 3.5;
        settings.expression.max_parts = 7;
        settings.world.opponents.genomes = {sample_document().creature.individual->genome};
    });
    REQUIRE(document.has_world());
    const std::string text = write_creature(document, kinds());
    const auto loaded = parse_creature(text, "test", kinds());
    REQUIRE(loaded);
    CHECK(loaded->warnings.empty());
    CHECK_FALSE(loaded->scored());
    CHECK(loaded->has_world());
    CHECK(same_judgement(loaded->settings(), document.settings()));
    CHECK(write_creature(*loaded, kinds()) == text);
}

TEST_CASE("the world of a creature with a score is that of its trial", "[persist][creature_file]") {
    std::string text = sample_text();
    text.insert(text.find("\"scored\""),
                "\"world\": {\"goal\": {\"behavior\": \"swimming\"}},\n  ");
    const auto loaded = parse_creature(text, "test", kinds());
    REQUIRE(loaded);
    CHECK(loaded->settings().goal == "walking");
    REQUIRE(loaded->warnings.size() == 1);
    CHECK_THAT(loaded->warnings.front(), Catch::Contains("W01 /world"));
}

TEST_CASE("a name may hold any text and comes back readable", "[persist][creature_file]") {
    const auto saved_and_loaded = [](const std::string& name) {
        const CreatureDocument named =
            with_genome(sample_document(), [&](Genome& genome) { genome.name = name; });
        const auto loaded = parse_creature(write_creature(named, kinds()), "test", kinds());
        REQUIRE(loaded);
        return loaded->genome().name;
    };
    for (const std::string name : {"", "\"\\/\n\t\x01", "žába 蛙", "🦎"})
        CHECK(saved_and_loaded(name) == name);
    CHECK(saved_and_loaded("cut in a character \xe8") == "cut in a character ?");
}

TEST_CASE("a uid that is not a number is nobody's", "[persist][creature_file]") {
    std::string text = sample_text();
    const std::string uid = "9f3c22a1d0b4e877";
    text.replace(text.find(uid), uid.size(), "the first of all");
    const auto loaded = parse_creature(text, "test", kinds());
    REQUIRE(loaded);
    CHECK(loaded->creature.individual->uid == 0);
    CHECK_THAT(write_creature(*loaded, kinds()), Catch::Contains("\"uid\": \"\""));
}

TEST_CASE("a failed save keeps the old file", "[persist][creature_file]") {
    const TemporaryDirectory folder;
    CHECK_FALSE(save_creature(folder / "no/such/folder/a", sample_document(), kinds()));
    std::filesystem::create_directory(folder / "taken");
    const Status saved = save_creature(folder / "taken", sample_document(), kinds());
    REQUIRE_FALSE(saved);
    CHECK_THAT(saved.error().message, Catch::Contains("taken"));
    CHECK(folder.size() == 1);
}

TEST_CASE("an individual's file tells how it was bred and scored", "[persist][creature_file]") {
    Individual individual;
    individual.uid = 0xab;
    individual.genome = sample_document().creature.individual->genome;
    individual.parents = {0xcd, 0};
    individual.method = "asexual";
    individual.evaluated = true;
    individual.result.fitness = 1.5;
    individual.result.digest = 99;
    individual.result.finer = FinerResult{.score = 1.25};
    ExperimentSettings settings;
    settings.seed = 3;
    const CreatureDocument document =
        creature_document({.individual = std::make_shared<const Individual>(individual),
                           .settings = std::make_shared<const ExperimentSettings>(settings)},
                          kinds());
    const std::string text = write_creature(document, kinds());
    CHECK_THAT(text, Catch::Contains("\"uid\": \"00000000000000ab\""));
    CHECK_THAT(text, Catch::Contains("\"parents\": [\"00000000000000cd\"]"));
    const auto loaded = parse_creature(text, "test", kinds());
    REQUIRE(loaded);
    REQUIRE(loaded->scored());
    CHECK(loaded->score() == 1.5);
    CHECK(loaded->notes.unit == "BL/s");
    CHECK(loaded->result().digest == 99);
    CHECK(loaded->settings().seed == 3);
    CHECK(loaded->result().finer == FinerResult{.score = 1.25});
}

namespace {

// The crawler with the sample's score, for a trial of that length.
CreatureDocument scored_crawler(double duration) {
    CreatureDocument document = sample_document();
    document.notes.ticks.clear();
    change_settings(document.creature, [&](ExperimentSettings& settings) {
        settings.world.trial.duration = duration;
    });
    change_individual(document.creature, [](Individual& individual) {
        individual.genome = crawler(kinds().creature.catalog);
    });
    return document;
}

void set_finer(CreatureDocument& document, std::optional<FinerResult> finer) {
    change_individual(document.creature,
                      [&](Individual& individual) { individual.result.finer = finer; });
}

}  // namespace

TEST_CASE("a score is recomputed more finely once, unless that is stopped",
          "[persist][creature_file]") {
    CreatureDocument document = scored_crawler(1.0);
    set_finer(document, std::nullopt);
    const auto once = note_ticks(document.genome(), document.settings(), kinds());
    REQUIRE(once);
    change_individual(document.creature,
                      [&](Individual& individual) { individual.result.digest = once->digest; });
    complete_score(document, kinds());
    CHECK(document.notes.ticks == once->ticks);
    CHECK(document.notes.ticks.size() > 60);
    REQUIRE(document.result().finer);
    CHECK(document.result().finer->outcome == Outcome::kCompleted);
    CHECK(document.result().finer->verdict == AuditVerdict::kClean);
    set_finer(document, FinerResult{.score = 77.0});
    complete_score(document, kinds());
    CHECK(document.result().finer->score == 77.0);

    document = scored_crawler(1e4);
    set_finer(document, std::nullopt);
    std::stop_source stop;
    stop.request_stop();
    complete_score(document, kinds(), stop.get_token());
    CHECK_FALSE(document.result().finer);
}

TEST_CASE("ticks of another motion than the one scored are not kept", "[persist][creature_file]") {
    CreatureDocument document = scored_crawler(0.5);
    complete_score(document, kinds());
    CHECK(document.notes.ticks.empty());
}

namespace {

// Returns the sample as version 1 wrote it, with the central neuron's channel as a number.
std::string numbered_sample(const std::string& number) {
    std::string text = sample_text();
    for (const auto& [from, to] :
         {std::pair<std::string, std::string>{"\"version\": 2", "\"version\": 1"},
          {"\"contact-distal\"", "1"},
          {"\"contact-left\"", number}}) {
        const std::size_t place = text.find(from);
        REQUIRE(place != std::string::npos);
        text.replace(place, from.size(), to);
    }
    return text;
}

int central_channel(const std::string& text, const EvolutionKinds& all) {
    const auto document = parse_creature(text, "some.creature.json", all);
    INFO((document ? "" : document.error().message));
    REQUIRE(document);
    return document->genome().brain[0].inputs[0].source.index;
}

// Returns kinds whose sensor channels are registered in reverse order.
EvolutionKinds with_reversed_channels() {
    EvolutionKinds all = kinds();
    std::reverse(all.creature.catalog.channels.begin(), all.creature.catalog.channels.end());
    return all;
}

// Returns the number of the channel registered last.
int last_channel() {
    return static_cast<int>(kinds().creature.catalog.channels.size()) - 1;
}

}  // namespace

TEST_CASE("sensor channels are written by id", "[persist][creature_file]") {
    CHECK_THAT(sample_text(), Catch::Contains("\"ch\": \"contact-left\""));
    const EvolutionKinds reversed = with_reversed_channels();
    CHECK_THAT(write_creature(sample_document(), reversed),
               Catch::Contains("\"ch\": \"" + reversed.creature.catalog.channels[2].id + "\""));
}

TEST_CASE("files of version 1 number the sensor channels they had", "[persist][creature_file]") {
    CHECK(central_channel(numbered_sample("2"), kinds()) == 2);
    CHECK(write_creature(*parse_creature(numbered_sample("2"), "", kinds()), kinds()) ==
          sample_text());
}

TEST_CASE("the order in which sensors are registered does not matter to files",
          "[persist][creature_file]") {
    const EvolutionKinds reversed = with_reversed_channels();
    CHECK(central_channel(sample_text(), reversed) == last_channel() - 2);
    CHECK(central_channel(numbered_sample("4"), reversed) == last_channel() - 4);
    CHECK(central_channel(numbered_sample("0"), reversed) == last_channel());
}

TEST_CASE("a number of no sensor channel stays one that nothing has", "[persist][creature_file]") {
    CHECK(central_channel(numbered_sample("200"), kinds()) == 200);
    // Version 1 had five channels. A larger number must not become the number of a later channel.
    CHECK(central_channel(numbered_sample("5"), kinds()) == 255);
    EvolutionKinds fewer = kinds();
    fewer.creature.catalog.channels.resize(5);
    CHECK(central_channel(numbered_sample("5"), fewer) == 5);
}

TEST_CASE("the sample of each goal was evolved for it", "[persist][creature_file]") {
    const std::filesystem::path samples = CAMBRIAN_SOURCE_DIR "/assets/creatures";
    for (const GoalKind& goal : kinds().goals.all()) {
        CAPTURE(goal.id);
        REQUIRE_FALSE(goal.sample.empty());
        const auto sample = load_creature(samples / (goal.sample + ".creature.json"), kinds());
        REQUIRE(sample);
        CHECK(sample->settings().goal == goal.id);
        CHECK(sample->score() > 0.0);
    }
}
