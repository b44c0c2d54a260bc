// A joint, an integrator, an effector, an organ, a sensor, a neuron function, a mutation, a
// breeding method, a selection and a goal that only this file knows. An experiment that uses only
// these kinds evolves and is saved, loaded and drawn. A list of known kinds or a switch over them
// makes a test fail.

#include "evolution/backends/thread_pool_backend.h"
#include "evolution/evolution.h"
#include "persist/creature/creature_file.h"
#include "persist/creature/rescoring.h"
#include "persist/experiment/experiment_file.h"
#include "persist/settings/settings_file.h"
#include "pictures/card_picture.h"
#include "render/opengl/offscreen_context.h"
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <array>
#include <atomic>
#include <cmath>
#include <set>

namespace cambrian {
namespace {

// In rad: the joint's limit on either side, and how far a load may press a joint past its limit.
constexpr double kStiffLimit = 0.3;
constexpr double kLimitCompliance = 0.1;

// The number of calls of each made-up kind.
struct Calls {
    std::atomic<int> joint = 0;
    std::atomic<int> integrator = 0;
    std::atomic<int> effector = 0;
    std::atomic<int> organ = 0;
    std::atomic<int> sensor = 0;
    std::atomic<int> function = 0;
    std::atomic<int> mutation = 0;
    std::atomic<int> breeding = 0;
    std::atomic<int> selection = 0;
    std::atomic<int> goal = 0;
};
Calls calls;

// A hinge with narrow limits, whatever the genes are.
void shape_stiff(const JointGenes& genes, PlannedPart& part) {
    ++calls.joint;
    part.limit_low = -kStiffLimit;
    part.limit_high = kStiffLimit;
    part.max_effort = genes.muscle_strength * genes.width * genes.width;
}

// The physics with one more integrator, which halves the tolerance of the accurate one. Integrators
// are compiled with the physics; the rest of the program knows them by the names a scene kind has.
SceneKind with_halving(SceneKind scene) {
    scene.integrators.push_back({"halving", "Halved tolerance"});
    scene.make = [inner = scene.make, accurate = scene.accurate_integrator](
                     const BodyPlan& plan, const Environment& environment,
                     const SceneSettings& settings) {
        SceneSettings known = settings;
        if (settings.integrator == "halving") {
            ++calls.integrator;
            known.integrator = accurate;
            known.tolerance = 0.5 * settings.tolerance;
        }
        return inner(plan, environment, known);
    };
    return scene;
}

// Drives the joint to one stop or the other.
void drive_flip(const EffectorSite& site, double signal, double /*share*/,
                const SceneSettings& /*settings*/, double& memory, PhysicsScene& scene) {
    ++calls.effector;
    memory = signal > 0.0 ? site.part.limit_high : site.part.limit_low;
    scene.set_target(site.joint, memory);
}

// Gives off nothing; counts calls with parameters in their ranges.
void hum(const OrganSite& site, double /*signal*/, Emissions& /*emissions*/) {
    const double depth = site.parameters[0];
    const double count = site.parameters[1];
    if (depth >= -7.0 && depth <= -3.0 && count >= 1.0 && count <= 9.0) ++calls.organ;
}

std::string hum_in_words(std::span<const double> /*parameters*/) {
    return "Hums.";
}

double read_height(const SensorSite& site, double& /*memory*/) {
    ++calls.sensor;
    return site.body.part_pose(site.index).position.y();
}

double triple(const double* inputs, double* /*memory*/, double /*dt*/) {
    ++calls.function;
    return 3.0 * inputs[0];
}

bool lean(Genome& genome, const MutationContext& /*context*/, RandomStream& stream,
          MutationRecord& record) {
    ++calls.mutation;
    genome.root_angle += stream.uniform();
    record.place = "root";
    return true;
}

Genome breed_second(const Genome& /*first*/, const Genome& second, const KindCatalog& /*catalog*/,
                    RandomStream& /*stream*/) {
    ++calls.breeding;
    return second;
}

constexpr KindParameter<int> kPart{"one-in", 2};

void add_part_settings(SelectionRows& rows) {
    rows.table.number(kPart, kPart.key, "One in", "", {1, 6}, "Of so many creatures one survives.")
        .applies = rows.in_force;
}

// The best survive and breed in turn.
SelectionResult select_part(std::span<const IndividualPtr> ranked,
                            const ExperimentSettings& settings, SelectionMemory& /*memory*/,
                            RandomStream& /*stream*/) {
    ++calls.selection;
    SelectionResult result;
    const auto one_in = static_cast<std::size_t>(kPart.of(settings.selection.own));
    const std::size_t kept = (ranked.size() + one_in - 1) / one_in;
    for (std::size_t i = 0; i < kept; ++i)
        result.survivors.push_back(i);
    for (std::size_t i = kept; i < static_cast<std::size_t>(settings.population.size); ++i)
        result.first_parents.push_back(i % kept);
    result.partner_weights.assign(ranked.size(), 1.0);
    return result;
}

Score score_mass(const TrialRecord& record) {
    ++calls.goal;
    return {record.mass, {{"mass", record.mass, "kg"}}};
}

EvolutionKinds with_made_up_kinds() {
    NeuronFunctionRegistry functions = builtin_neuron_functions();
    functions.add({.id = "triple", .label = "Triple", .evaluate = triple});
    SensorRegistry sensors = builtin_sensors();
    sensors.add({.id = "height",
                 .label = "Height",
                 .channels = {{"height-middle", "Height of the middle"}},
                 .read = read_height});
    EffectorRegistry effectors = builtin_effectors();
    effectors.add({.id = "flip", .label = "Flip", .drive = drive_flip});
    OrganRegistry organs = builtin_organs();
    organs.add({.id = "hum",
                .label = "Hum",
                .parameters = {{.name = "depth",
                                .key = "depth",
                                .low = -7.0,
                                .high = -3.0,
                                .fallback = -4.0,
                                .unit = "m"},
                               {.name = "count",
                                .key = "count",
                                .low = 1.0,
                                .high = 9.0,
                                .fallback = 1.0,
                                .whole = true}},
                .act = hum,
                .words = hum_in_words});
    SceneKind scene = with_halving(test::kinds().creature.scene);
    scene.joints.add({.id = "stiff",
                      .label = "Stiff",
                      .motion = JointMotion::kTurn,
                      .usual = false,
                      .shape = shape_stiff});
    MutationRegistry mutations = builtin_mutations();
    mutations.add({.id = "lean", .label = "Lean", .apply = lean});
    BreedingRegistry breeding = builtin_breeding();
    breeding.add({.id = "second", .label = "Second", .parents = 2, .breed = breed_second});
    SelectionRegistry selections = builtin_selections();
    selections.add({.id = "part",
                    .label = "Part",
                    .help = "A part of them survives.",
                    .add_settings = add_part_settings,
                    .select = select_part});
    GoalRegistry goals = builtin_goals();
    goals.add({.id = "heavy",
               .label = "Heavy",
               .unit = "kg",
               .help = "Mass.",
               .default_environment = [] { return Environment{}; },
               .mismatch = [](const Environment&) { return std::string(); },
               .score = score_mass});
    return make_evolution_kinds(
        make_kinds(std::move(functions), std::move(sensors), std::move(effectors),
                   std::move(organs), std::move(scene)),
        std::move(mutations), std::move(breeding), std::move(goals), std::move(selections));
}

const EvolutionKinds& kinds() {
    static const EvolutionKinds all = with_made_up_kinds();
    return all;
}

template <class Value, class Kinds>
std::map<std::string, Value> only(const Kinds& kinds, std::string_view id, Value on, Value off) {
    std::map<std::string, Value> values;
    for (const auto& kind : kinds)
        values[kind.id] = kind.id == id ? on : off;
    return values;
}

// Returns settings that enable only the made-up kinds.
ExperimentSettings made_up_settings() {
    const KindCatalog& catalog = kinds().creature.catalog;
    ExperimentSettings settings = default_settings("heavy", kinds());
    settings.population.size = 12;
    settings.world.scene.integrator = "halving";
    settings.world.trial.duration = 0.5;
    settings.world.trial.settle_limit = 0.5;
    settings.selection.method = "part";
    settings.selection.own["one-in"] = 3;
    settings.breeding.shares = only(kinds().breeding.all(), "second", 1.0, 0.0);
    settings.mutation.weights = only(kinds().mutations.all(), "lean", 1.0, 0.0);
    settings.founders.joints = only(catalog.joints, "stiff", true, false);
    settings.founders.organs = only(catalog.organs, "hum", true, false);
    settings.founders.functions = only(catalog.functions, "triple", true, false);
    settings.founders.channels = only(catalog.channels, "height-middle", true, false);
    return settings;
}

// Returns the file of a run of three generations.
std::shared_ptr<ExperimentFile> evolved() {
    const auto settings = std::make_shared<const ExperimentSettings>(made_up_settings());
    auto file = ExperimentFile::create(kinds(), settings, {});
    REQUIRE(file);
    Evolution evolution(settings, kinds());
    const auto backend = make_thread_pool_backend(kinds(), 2);
    EvaluationProgress progress;
    for (int generation = 0; generation < 3; ++generation) {
        if (generation > 0) evolution.breed();
        REQUIRE(evolution.evaluate(*backend, progress, {}));
        REQUIRE((*file)->record(evolution));
    }
    return *file;
}

SavedExperiment saved_and_loaded() {
    const TemporaryDirectory folder;
    REQUIRE(evolved()->move_to(folder / "run.cambrian"));
    auto saved = load_experiment(folder / "run.cambrian", kinds());
    INFO((saved ? "" : saved.error().message));
    REQUIRE(saved);
    return std::move(*saved);
}

TEST_CASE("settings that name made-up kinds are written and read", "[extension]") {
    const std::string text = write_settings(made_up_settings(), kinds());
    for (const char* id : {"heavy", "halving", "part", "one-in = 3", "second", "lean", "stiff",
                           "triple", "height-middle", "hum = true"})
        CHECK_THAT(text, Catch::Contains(id));
    const auto read = parse_settings(text, "made-up.toml", kinds());
    INFO((read ? "" : read.error().message));
    REQUIRE(read);
    CHECK(write_settings(*read, kinds()) == text);
}

TEST_CASE("two generations are bred with nothing but made-up kinds", "[extension]") {
    for (std::atomic<int>* count :
         {&calls.joint, &calls.integrator, &calls.effector, &calls.organ, &calls.sensor,
          &calls.function, &calls.mutation, &calls.breeding, &calls.selection, &calls.goal})
        *count = 0;
    const SavedExperiment saved = saved_and_loaded();
    CHECK(calls.joint > 0);
    CHECK(calls.integrator > 0);
    CHECK(calls.effector > 0);
    CHECK(calls.organ > 0);
    CHECK(calls.sensor > 0);
    CHECK(calls.function > 0);
    CHECK(calls.mutation > 0);
    CHECK(calls.breeding > 0);
    CHECK(calls.selection >= 2);
    CHECK(calls.goal > 0);
    REQUIRE(saved.latest);
    CHECK(saved.latest->generation == 2);
    CHECK(saved.latest->population.front()->result.fitness > 0.0);
    CHECK(kPart.of(saved.latest->settings->selection.own) == 3);
    CHECK(std::count_if(saved.latest->population.begin(), saved.latest->population.end(),
                        [](const IndividualPtr& each) { return each->born < 2; }) == 4);
    CHECK(saved.digests.size() == 3);
    CHECK(std::any_of(saved.latest->population.begin(), saved.latest->population.end(),
                      [](const IndividualPtr& each) { return each->method == "second"; }));
}

TEST_CASE("the trials of made-up kinds are verified from their files", "[extension]") {
    const SavedExperiment saved = saved_and_loaded();
    for (const IndividualPtr& individual : saved.latest->population) {
        const CreatureDocument document = creature_document(
            {.individual = individual, .settings = saved.latest->settings}, kinds());
        const auto read =
            parse_creature(write_creature(document, kinds()), "made-up.creature.json", kinds());
        INFO((read ? "" : read.error().message));
        REQUIRE(read);
        REQUIRE(read->scored());
        const EvaluationResult again = run_scored_trial(*read, kinds());
        CHECK(again.digest == individual->result.digest);
        CHECK(again.fitness == read->score());
    }
}

TEST_CASE("a made-up joint moves, within its own limits", "[extension]") {
    const SavedExperiment saved = saved_and_loaded();
    const ExperimentSettings& settings = *saved.latest->settings;
    double farthest = 0.0;
    for (const IndividualPtr& individual : saved.latest->population) {
        const auto phenotype = std::make_shared<const Phenotype>(express(
            *individual->genome, kinds().creature, settings.expression, settings.world.scene));
        auto trial = Trial::start(phenotype, kinds().creature, settings.world);
        if (!trial) continue;  // the body is not possible in this world
        while ((*trial)->tick()) {
            for (const JointDegree& joint : phenotype->effectors) {
                farthest =
                    std::fmax(farthest, std::fabs((*trial)->scene().joint_coordinate(joint)));
            }
        }
    }
    CHECK(farthest > 0.5 * kStiffLimit);
    CHECK(farthest < kStiffLimit + kLimitCompliance);
}

TEST_CASE("creatures of made-up kinds are saved, loaded and drawn", "[extension]") {
    const SavedExperiment saved = saved_and_loaded();
    std::set<std::string> unseen = {"\"height-middle\"", "\"triple\"", "\"stiff\"",
                                    "\"kind\": \"flip\""};
    auto context = OffscreenContext::create();
    REQUIRE(context);
    auto renderer = Renderer::create();
    auto text_rasterizer = TextRasterizer::load();
    REQUIRE(renderer);
    REQUIRE(text_rasterizer);
    for (const IndividualPtr& individual : saved.latest->population) {
        const CreatureDocument document = creature_document(
            {.individual = individual, .settings = saved.latest->settings}, kinds());
        const std::string text = write_creature(document, kinds());
        std::erase_if(
            unseen, [&](const std::string& word) { return text.find(word) != std::string::npos; });
        const auto read = parse_creature(text, "made-up.creature.json", kinds());
        INFO((read ? "" : read.error().message));
        REQUIRE(read);
        CHECK(read->warnings.empty());
        CHECK(read->genome() == *individual->genome);
        CHECK(write_creature(*read, kinds()) == text);
    }
    CHECK(unseen.empty());
    const CreatureDocument best = creature_document(
        {.individual = saved.latest->population.front(), .settings = saved.latest->settings},
        kinds());
    const auto subject = subject_of(best, *saved.latest->settings, "Made up", kinds());
    INFO((subject ? "" : subject.error().message));
    REQUIRE(subject);
    auto canvas = PictureCanvas::create(**renderer, **text_rasterizer, 240, 320);
    REQUIRE(canvas);
    draw_card(*canvas, *subject, palette_of(ThemeKind::kDark));
    const auto image = canvas->finish();
    REQUIRE(image.rgb.size() == 240U * 320U * 3U);
    std::set<std::array<std::uint8_t, 3>> colors;
    for (std::size_t i = 0; i < image.rgb.size(); i += 3)
        colors.insert({image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]});
    CHECK(colors.size() > 50);
}

}  // namespace
}  // namespace cambrian
