#include "app/command_line/option_types.h"
#include "app/evolve/experiment_rescoring.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "core/threads/thread_pool.h"
#include "evolution/backends/thread_pool_backend.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/rescoring.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>

namespace cambrian {
namespace {

// Example: "1.23 BL/s by simulator 1.0".
std::string score_text(const CreatureDocument& document) {
    return fmt::format("{} {} by simulator {}", short_text(document.score()), document.notes.unit,
                       document.notes.simulator);
}

// Example: "best of generation 8 1.3 BL/s by simulator 1.1; best of generation 7 1.2 BL/s by
// simulator 1.0, now 1.25 BL/s".
std::string words_for(const RescoredExperiment& done, const EvolutionKinds& kinds) {
    const std::string& unit = kinds.goals.find(done.after.settings->goal)->unit;
    const auto best_of = [&](const JudgedIndividual& champion, std::string_view simulator) {
        return fmt::format("best of generation {} {} {} by simulator {}", champion.generation,
                           short_text(unconfirmed_score(champion.individual->result)), unit,
                           simulator);
    };
    const std::string words = fmt::format(
        "{}; {}", best_of(done.after, simulator_version(kinds.creature.scene.dimensions)),
        best_of(done.before, done.simulator));
    return done.again ? fmt::format("{}, now {} {}", words, short_text(*done.again), unit) : words;
}

ExitStatus rescore_run(const std::string& file, const EvolutionKinds& kinds, LongWork& work) {
    work.begin("judging again", 1, "generation");
    const auto backend = make_thread_pool_backend(kinds, ThreadPool::default_workers());
    const auto done = rescore_experiment(file, kinds, *backend, work.stop());
    if (!done)
        return fail(done.error(), work.interrupted() ? ExitStatus::kFailed : ExitStatus::kBadInput);
    if (!done->has_value())
        return print_result_line(fmt::format("{}: unchanged, scored by simulator {}", file,
                                             simulator_version(kinds.creature.scene.dimensions)));
    return print_result_line(fmt::format("{}: {}", file, words_for(**done, kinds)));
}

class RescoreSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option(
               "creatures", files_,
               "Creature files, which are replaced, or experiment files, whose creatures are "
               "judged again in the next generation")
            ->type_name(option_type::kCreatureOrExperiment)
            ->required();
        app.add_option("-o,--out", out_,
                       "Creature file to write instead of replacing the only input")
            ->type_name("FILE.creature.json");
        app.add_flag("--default-integration", default_integration_,
                     "Default integrator, tolerance and contact step instead of the file's");
    }

    CommandFiles files() const override {
        return CommandFiles().reads_each(files_).writes(out_, output_form::kCreature);
    }

    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (!out_.empty() && files_.size() > 1)
            return fail({fmt::format("--out is for one creature, found {}", files_.size())});
        if (changes_creatures() && std::any_of(files_.begin(), files_.end(), is_experiment))
            return fail({"--out and --default-integration are for creatures, not experiments"});
        LongWork work;
        ExitStatus worst = ExitStatus::kDone;
        for (const std::string& file : files_) {
            worst = std::max(worst, is_experiment(file) ? rescore_run(file, kinds, work)
                                                        : rescore(file, kinds, work));
            if (work.interrupted()) break;
        }
        return worst;
    }

private:
    static bool is_experiment(const std::string& file) { return is_experiment_name(file); }
    bool changes_creatures() const { return !out_.empty() || default_integration_; }

    ExitStatus rescore(const std::string& file, const EvolutionKinds& kinds, LongWork& work) const {
        const Result<CreatureDocument> before = read(file, kinds);
        if (!before) return fail(before.error());
        const std::string target = out_.empty() ? file : out_;
        if (const Status writable = check_writable(target); !writable)
            return fail(writable.error());
        const TrialSettings& trial = before->settings().world.trial;
        work.begin("scoring " + file, trial.duration * trial.trials);
        const Result<CreatureDocument> after = rescored(asked_of(*before), kinds, work.stop());
        if (!after)
            return fail({fmt::format("{}: left as it is: {}", file, after.error().message)},
                        ExitStatus::kFailed);
        if (out_.empty() && same_score(*before, *after)) {
            return print_result_line(fmt::format("{}: unchanged, {}", file, score_text(*after)));
        }
        const Status written = save_creature(target, *after, kinds);
        if (!written) return fail(written.error(), ExitStatus::kFailed);
        return print_result_line(
            fmt::format("{}: {}, was {}", target, score_text(*after), score_text(*before)));
    }

    // Reads a creature from a file whose score can be replaced.
    Result<CreatureDocument> read(const std::string& file, const EvolutionKinds& kinds) const {
        const Result<bool> card = is_card(file);
        if (!card) return card.error();
        if (*card && out_.empty()) {
            return Error{file +
                         ": a card's picture shows its score; write a creature file with --out and "
                         "draw that one's card with 'cambrian render'"};
        }
        Result<CreatureDocument> document = load_creature(file, kinds);
        if (!document) return document;
        say_of(file, document->warnings);
        if (!document->scored()) return Error{file + ": holds no score to replace"};
        return document;
    }

    // Returns the creature with the settings of the trial that is to score it.
    CreatureDocument asked_of(CreatureDocument document) const {
        if (!default_integration_) return document;
        change_settings(document.creature, [](ExperimentSettings& settings) {
            SceneSettings& scene = settings.world.scene;
            const SceneSettings usual;
            scene.integrator = usual.integrator;
            scene.tolerance = usual.tolerance;
            scene.contact_step = usual.contact_step;
        });
        return document;
    }

    std::vector<std::string> files_;
    std::string out_;
    bool default_integration_ = false;
};

}  // namespace

SubcommandKind rescore_subcommand() {
    return {.id = "rescore",
            .summary =
                "Score creatures, or those of an experiment, with this version of the simulator.",
            .example = "cambrian rescore champion-walking-seed7.creature.json",
            .make = make_subcommand<RescoreSubcommand>};
}

}  // namespace cambrian
