#include "cluster/messages/unit_text.h"

#include "cluster/coordinator/crash_search.h"
#include "cluster/messages/judging_settings.h"
#include "cluster/units/unit_child.h"
#include "core/random.h"
#include "evolution/evaluation/trials.h"
#include "evolution/settings/goal_defaults.h"
#include "genome/founders/random_genome.h"
#include "persist/creature/creature_file.h"
#include "persist/settings/settings_file.h"
#include "support/catch.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

#include <limits>

using namespace cambrian;
using test::kinds;

namespace {

std::vector<EvaluationRequest> requests(std::size_t count) {
    std::vector<EvaluationRequest> all;
    RandomStream random(8);
    for (std::size_t i = 0; i < count; ++i) {
        EvaluationRequest request;
        request.genome =
            std::make_shared<const Genome>(random_genome({}, kinds().creature.catalog, random));
        request.trial_seed = random.bits();
        request.slot = static_cast<std::uint32_t>(i);
        if (i % 2 == 1)
            request.threshold =
                TerminationThreshold{.score = 0.1 * static_cast<double>(i), .audited = i == 3};
        if (i % 3 == 2) request.probe = Probe{.seed = random.bits(), .finer = i == 2};
        all.push_back(std::move(request));
    }
    return all;
}

const UnitTerms kTerms{.settings = 77, .simulator = "1.2", .proof = 78, .deadline = 61.5};

std::string reason(const Result<Unit>& unit) {
    return unit ? std::string("read") : unit.error().message;
}

}  // namespace

TEST_CASE("a unit's text gives the same requests", "[cluster]") {
    const std::vector<EvaluationRequest> sent = requests(20);
    UnitWriter writer(kinds());
    UnitReader reader(kinds());
    const std::string body = writer.write(kTerms, sent);
    const Result<Unit> unit = reader.read(body);
    REQUIRE(unit);
    CHECK(unit->terms == kTerms);
    REQUIRE(unit->requests.size() == sent.size());
    for (std::size_t i = 0; i < sent.size(); ++i) {
        CHECK(*unit->requests[i].genome == *sent[i].genome);
        CHECK(unit->requests[i].trial_seed == sent[i].trial_seed);
        CHECK(unit->requests[i].slot == sent[i].slot);
        CHECK(unit->requests[i].threshold == sent[i].threshold);
        CHECK(unit->requests[i].probe == sent[i].probe);
    }
    const Result<UnitOutline> outline = parse_unit_outline(body);
    REQUIRE(outline);
    CHECK(outline->version == kUnitVersion);
    CHECK(outline->terms == kTerms);
    CHECK(body.size() < 2'000 * sent.size());
}

TEST_CASE("a threshold that no score reaches travels", "[cluster]") {
    std::vector<EvaluationRequest> one = requests(1);
    one[0].threshold =
        TerminationThreshold{.score = -std::numeric_limits<double>::infinity(), .audited = true};
    UnitWriter writer(kinds());
    const Result<Unit> unit = UnitReader(kinds()).read(writer.write(kTerms, one));
    REQUIRE(unit);
    CHECK(unit->requests[0].threshold == one[0].threshold);
}

TEST_CASE("what is no unit is refused with a reason", "[cluster]") {
    UnitWriter writer(kinds());
    const std::string body = writer.write(kTerms, requests(2));
    UnitReader reader(kinds());
    const auto with = [&](const std::string& what, const std::string& instead) {
        std::string changed = body;
        changed.replace(changed.find(what), what.size(), instead);
        return reason(reader.read(changed));
    };
    CHECK(reason(reader.read("")).find("E01") != std::string::npos);
    CHECK(reason(reader.read(body.substr(0, body.size() - 1))) != "read");
    CHECK(reason(reader.read(body.substr(0, body.find('\n')))) != "read");
    CHECK(reason(reader.read(std::string(4'000'001, 'x'))).find("limit 4000000") !=
          std::string::npos);
    CHECK(with("\"version\": 1", "\"version\": 2").find("expected 1, found 2") !=
          std::string::npos);
    CHECK(with("\"bytes\": ", "\"bytes\": 1").find("read") == std::string::npos);
    CHECK(with("\"bytes\": ", "\"bytes\": 9999").find("limit") == std::string::npos);
    CHECK(with("\"deadline\": 61.5", "\"deadline\": -1.0").find("/deadline") != std::string::npos);
    const std::size_t hash = body.find("\"genome\": \"fnv1a64:") + 19;
    std::string other = body;
    other[hash] = other[hash] == '0' ? '1' : '0';
    CHECK(reason(reader.read(other)).find("is not the one that was sent") != std::string::npos);
}

TEST_CASE("a unit of another version tells its version and no more", "[cluster]") {
    const Result<UnitOutline> newer =
        parse_unit_outline("{\"format\": \"cambrian-unit\", \"version\": 2, \"all\": \"new\"}");
    REQUIRE(newer);
    CHECK(newer->version == 2);
    CHECK_FALSE(parse_unit_outline("{\"format\": \"cambrian-result\", \"version\": 1}"));
    CHECK_FALSE(parse_unit_outline("{\"format\": \"cambrian-unit\", \"version\": 0}"));
}

TEST_CASE("what a result depends on of the settings travels, and nothing else", "[cluster]") {
    ExperimentSettings settings;
    settings.goal = "jumping";
    settings.world.environment.gravity = 3.7;
    settings.world.trial.trials = 4;
    settings.selection.confirm_jitter = 0.037;
    settings.selection.confirm_tilt = 3.7;
    const Result<JudgingSettings> judging = judging_settings(settings, kinds());
    REQUIRE(judging);
    CHECK(judging->key == settings_key(judging->text));
    const Result<ExperimentSettings> read = parse_settings(judging->text, "sent", kinds());
    REQUIRE(read);
    CHECK(same_judgement(*read, settings));
    CHECK(read->selection.confirm_jitter == 0.037);
    CHECK(read->selection.confirm_tilt == 3.7);
    // Workers keep their settings when only breeding changes.
    settings.mutation = {};
    settings.population.size = 77;
    settings.seed = 5;
    CHECK(judging_settings(settings, kinds())->key == judging->key);
    settings.selection.confirm_jitter = 0.01;
    CHECK(judging_settings(settings, kinds())->key != judging->key);
    settings.selection.confirm_jitter = 0.037;
    settings.selection.confirm_tilt = 2.0;
    CHECK(judging_settings(settings, kinds())->key != judging->key);
}

TEST_CASE("settings of an accurate computation travel", "[cluster]") {
    for (const GoalKind& goal : kinds().goals.all()) {
        ExperimentSettings settings;
        settings.goal = goal.id;
        adopt_defaults(settings, goal);
        for (const double contact_step : {1e-4, 1.0 / 60}) {
            settings.world.scene.contact_step = contact_step;
            for (const int trials : {1, 16}) {
                settings.world.trial.trials = trials;
                const ExperimentSettings accurate = accurate_settings(settings, kinds());
                CHECK(accurate.world.scene.max_evaluations > 3e5);
                const Result<JudgingSettings> judging = judging_settings(accurate, kinds());
                CAPTURE(goal.id, contact_step, trials);
                REQUIRE(judging);
                CHECK(parse_settings(judging->text, "sent", kinds())->world == accurate.world);
            }
        }
    }
}

TEST_CASE("the opponents of a contest travel with the settings", "[cluster]") {
    ExperimentSettings settings;
    settings.goal = "competition";
    adopt_defaults(settings, *kinds().goals.find(settings.goal));
    for (const EvaluationRequest& request : requests(3))
        settings.world.opponents.genomes.push_back(request.genome);
    const Result<JudgingSettings> judging = judging_settings(settings, kinds());
    REQUIRE(judging);
    const Result<ExperimentSettings> read = read_judging_settings(judging->text, "sent", kinds());
    REQUIRE(read);
    CHECK(read->world.opponents == settings.world.opponents);
    std::swap(settings.world.opponents.genomes[0], settings.world.opponents.genomes[1]);
    CHECK(judging_settings(settings, kinds())->key != judging->key);
    // A text that is cut off is refused, or it has fewer opponents.
    const std::size_t last = judging->text.find_last_not_of('\n');
    for (std::size_t size = 0; size <= last; size += 97) {
        const auto cut = read_judging_settings(judging->text.substr(0, size), "sent", kinds());
        CHECK((!cut || cut->world.opponents.genomes.size() < 3));
    }
    const std::string opponents = judging->text.substr(judging->text.find("\n# opponent:\n"));
    std::string many = judging->text;
    while (many.size() + opponents.size() < kMostSettingsBytes)
        many += opponents;
    const auto refused = read_judging_settings(many, "sent", kinds());
    REQUIRE_FALSE(refused);
    CHECK(refused.error().message == "sent: more than 50 opponents");
    many += many;
    CHECK(read_judging_settings(many, "sent", kinds()).error().message == "sent: too large");
}

TEST_CASE("a process of its own answers with the results of this one", "[cluster]") {
    ExperimentSettings settings;
    settings.world.trial.duration = 1.0;
    const JudgingSettings judging = *judging_settings(settings, kinds());
    const std::vector<EvaluationRequest> sent = requests(5);
    UnitWriter writer(kinds());
    const std::string question = question_text(judging.text, writer.write(kTerms, sent));
    const Result<std::string> answer = answer_question(question, kinds());
    REQUIRE(answer);
    const Result<UnitResult> results = parse_unit_result(*answer);
    REQUIRE(results);
    REQUIRE(results->results.size() == sent.size());
    for (std::size_t i = 0; i < sent.size(); ++i)
        CHECK(result_text(results->results[i].result) ==
              result_text(evaluate_in_trials(sent[i], settings, kinds())));
    CHECK_FALSE(answer_question("", kinds()));
    CHECK_FALSE(answer_question("what?", kinds()));
    CHECK_FALSE(answer_question(question.substr(0, question.size() / 2), kinds()));
    CHECK_FALSE(answer_question(question.substr(0, question.find('\n') + 10), kinds()));
}

TEST_CASE("the creature that ends processes is found by halving", "[cluster]") {
    const TemporaryDirectory folder;
    ExperimentSettings settings;
    settings.world.trial.duration = 0.5;
    const std::string text = judging_settings(settings, kinds())->text;
    const std::vector<EvaluationRequest> sent = requests(8);
    const std::size_t guilty = GENERATE(0U, 5U, 7U);
    const GenomePtr poison = sent[guilty].genome;
    int crashes = 0;
    const ChildProcess child = [&](std::string_view question,
                                   const std::stop_token&) -> Result<ChildEnd> {
        const std::string unit(question.substr(question.find(text) + text.size()));
        const Result<Unit> asked = UnitReader(kinds()).read(unit);
        for (const EvaluationRequest& each : asked->requests) {
            if (!(*each.genome == *poison)) continue;
            ++crashes;
            return ChildEnd{.crashed = true, .cause = "signal 11", .output = {}};
        }
        return ChildEnd{
            .crashed = false, .cause = {}, .output = *answer_question(question, kinds())};
    };
    const std::filesystem::path place = folder.path();
    const CrashSearch search(kinds(), child, text, place);
    const Apart apart = search.compute(sent, {});
    CHECK(apart.trouble.empty());
    CHECK(apart.failure.find("(signal 11)") != std::string::npos);
    CHECK(crashes == 4);
    REQUIRE(folder.size() == 1);
    const auto file = std::filesystem::directory_iterator(place)->path();
    CHECK(*poison == load_creature(file, kinds())->genome());
}

TEST_CASE("a process that cannot be started is trouble, not a failure", "[cluster]") {
    const std::filesystem::path here = ".";
    const std::string text = judging_settings({}, kinds())->text;
    const ChildProcess none = [](std::string_view, const std::stop_token&) -> Result<ChildEnd> {
        return Error{"no such program"};
    };
    CHECK(CrashSearch(kinds(), none, text, here).compute(requests(2), {}).trouble ==
          "no such program");
    const ChildProcess odd = [](std::string_view, const std::stop_token&) -> Result<ChildEnd> {
        return ChildEnd{.crashed = false, .cause = {}, .output = write_unit_result({})};
    };
    const Apart apart = CrashSearch(kinds(), odd, text, here).compute(requests(2), {});
    CHECK(apart.results.empty());
    CHECK(apart.failure.empty());
    CHECK(apart.trouble.find("answered something else") != std::string::npos);
}

TEST_CASE("settings sent by anybody are refused if they nest deeply", "[cluster][unit_text]") {
    std::string text = "a";
    for (int i = 0; i < 200'000; ++i)
        text += ".a";
    const auto read = read_judging_settings(text + " = 1\n", "settings of a run", kinds());
    REQUIRE_FALSE(read);
    CHECK(read.error().message == "settings of a run: line 1: nested deeper than 32 levels");
}
