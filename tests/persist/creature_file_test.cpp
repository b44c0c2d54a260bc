#include "persist/creature/creature_file.h"

#include "core/random.h"
#include "evolution/evaluation/evaluation.h"
#include "genome/founders/random_genome.h"
#include "persist/sample_creature.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

TEST_CASE("a saved creature loads as it was", "[persist][creature_file]") {
    const TemporaryDirectory folder;
    const CreatureDocument saved = sample_document();
    REQUIRE(save_creature(folder / "a.creature.json", saved, kinds()));
    const auto loaded = load_creature(folder / "a.creature.json", kinds());
    REQUIRE(loaded);
    CHECK(loaded->genome == saved.genome);
    CHECK(loaded->genome.name == saved.genome.name);
    CHECK(loaded->genome.hue == saved.genome.hue);
    CHECK(loaded->genome.nodes[1].uid == 2);
    CHECK(loaded->uid == saved.uid);
    CHECK(loaded->parents == saved.parents);
    CHECK(loaded->method == saved.method);
    CHECK(loaded->scored == saved.scored);
    CHECK(loaded->warnings.empty());
}

TEST_CASE("random creatures are saved, loaded and saved again to the same bytes",
          "[persist][creature_file]") {
    RandomStream stream(61);
    CreatureDocument document;
    for (int i = 0; i < 3000; ++i) {
        document.genome = random_genome(FounderSettings{}, kinds().creature.catalog, stream);
        const std::string text = write_creature(document, kinds());
        const auto loaded = parse_creature(text, "test", kinds());
        REQUIRE(loaded);
        REQUIRE(loaded->warnings.empty());
        REQUIRE(loaded->genome == document.genome);
        REQUIRE(write_creature(*loaded, kinds()) == text);
    }
}

TEST_CASE("the settings of a score survive whatever they are", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    document.scored->world.environment.gravity = 0.1 + 0.2;
    document.scored->world.environment.has_ground = false;
    document.scored->world.scene.tolerance = 3e-5;
    document.scored->world.trial.duration = 7.5;
    document.scored->expression.max_parts = 9;
    document.scored->goal = "swimming";
    const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
    REQUIRE(loaded);
    CHECK(loaded->scored == document.scored);
    CHECK(settings_of(*loaded->scored).world == document.scored->world);
}

TEST_CASE("a creature without a score or parents is complete", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    document.scored.reset();
    document.parents.clear();
    const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
    REQUIRE(loaded);
    CHECK_FALSE(loaded->scored);
    CHECK(loaded->parents.empty());
}

TEST_CASE("a name may hold any text and comes back readable", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    for (const std::string name : {"", "\"\\/\n\t\x01", "žába 蛙", "🦎"}) {
        document.genome.name = name;
        const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
        REQUIRE(loaded);
        CHECK(loaded->genome.name == name);
    }
    document.genome.name = "cut in a character \xe8";
    const auto loaded = parse_creature(write_creature(document, kinds()), "test", kinds());
    REQUIRE(loaded);
    CHECK(loaded->genome.name == "cut in a character ?");
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
    individual.genome = std::make_shared<const Genome>(sample_document().genome);
    individual.parents = {0xcd, 0};
    individual.method = "asexual";
    individual.evaluated = true;
    individual.result.fitness = 1.5;
    individual.result.digest = 99;
    individual.result.finer = FinerResult{.score = 1.25};
    ExperimentSettings settings;
    settings.seed = 3;
    const CreatureDocument document = creature_document(individual, settings, kinds());
    CHECK(document.uid == "00000000000000ab");
    CHECK(document.parents == std::vector<std::string>{"00000000000000cd"});
    REQUIRE(document.scored);
    CHECK(document.scored->fitness == 1.5);
    CHECK(document.scored->unit == "BL/s");
    CHECK(document.scored->trajectory == 99);
    CHECK(document.scored->seed == 3);
    CHECK(document.scored->finer == FinerResult{.score = 1.25});
}

TEST_CASE("a score is recomputed more finely once, unless that is stopped",
          "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    document.genome = *crawler(kinds().creature.catalog);
    document.scored->finer.reset();
    document.scored->world.trial.duration = 1.0;
    const ExperimentSettings settings = settings_of(*document.scored);
    const auto once = note_ticks(document.genome, settings, kinds());
    REQUIRE(once);
    document.scored->trajectory = once->digest;
    document.scored->ticks.clear();
    complete_score(document, kinds());
    CHECK(document.scored->ticks == once->ticks);
    CHECK(document.scored->ticks.size() > 60);
    REQUIRE(document.scored->finer);
    CHECK(document.scored->finer->outcome == Outcome::kCompleted);
    CHECK(document.scored->finer->verdict == AuditVerdict::kClean);
    document.scored->finer->score = 77.0;
    complete_score(document, kinds());
    CHECK(document.scored->finer->score == 77.0);

    document.scored->finer.reset();
    document.scored->world.trial.duration = 1e4;
    std::stop_source stop;
    stop.request_stop();
    complete_score(document, kinds(), stop.get_token());
    CHECK_FALSE(document.scored->finer);
}

TEST_CASE("ticks of another motion than the one scored are not kept", "[persist][creature_file]") {
    CreatureDocument document = sample_document();
    document.genome = *crawler(kinds().creature.catalog);
    document.scored->world.trial.duration = 0.5;
    document.scored->trajectory ^= 1;
    document.scored->ticks.clear();
    complete_score(document, kinds());
    CHECK(document.scored->ticks.empty());
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
    return document->genome.brain[0].inputs[0].source.index;
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
