#include "app/evolve/run_outputs.h"

#include "app/command_line/output_path.h"
#include "core/files/file_errors.h"
#include "core/files/pending_file.h"
#include "core/files/private_folder.h"

#include <fmt/core.h>

#include <system_error>

namespace cambrian {
namespace {

constexpr int kMostOfOneName = 10'000;

// Returns the names of a run's files in a folder. The names of run 1 have no number.
RunOutputs named_in(const std::filesystem::path& folder, const std::string& name, int number) {
    const std::string numbered = number == 1 ? name : fmt::format("{}-{}", name, number);
    return {.champion = folder / fmt::format("champion-{}.creature.json", numbered),
            .experiment = folder / (numbered + ".cambrian"),
            .numbered = true};
}

bool is_free(const RunOutputs& outputs) {
    std::error_code unknown;
    return !std::filesystem::exists(outputs.champion, unknown) &&
           !std::filesystem::exists(outputs.experiment, unknown);
}

// Writes a file that does not exist yet.
Status write_new_file(const std::filesystem::path& path, std::string_view bytes) {
    Result<PendingFile> file = PendingFile::beside(path);
    if (!file) return file.error();
    if (const int code = file->write(bytes); code != 0) return write_outcome(path, code);
    return file->commit(PendingFile::Existing::kRefuse);
}

// Saves a champion under a free name of a folder.
Result<std::filesystem::path> save_numbered(std::filesystem::path path, const OutputWish& wish,
                                            const CreatureDocument& champion,
                                            const EvolutionKinds& kinds) {
    for (;;) {
        const Status saved = write_new_file(path, write_creature(champion, kinds));
        if (saved) return path;
        std::error_code unknown;
        if (!std::filesystem::exists(path, unknown)) return saved.error();
        const Result<RunOutputs> others = run_outputs(wish);
        if (!others || others->champion == path) return saved.error();
        path = others->champion;
    }
}

Result<std::filesystem::path> save_replacing(const std::filesystem::path& path,
                                             const CreatureDocument& champion,
                                             const EvolutionKinds& kinds) {
    const Status saved = save_creature(path, champion, kinds);
    return saved ? Result(path) : saved.error();
}

}  // namespace

Result<RunOutputs> run_outputs(const OutputWish& wish) {
    const auto& [asked, settings, files] = wish;
    if (is_experiment_name(asked)) return RunOutputs{.champion = {}, .experiment = asked};
    if (!asked.empty() && !check_ending(asked, output_form::kCreature))
        return Error{
            fmt::format("--out {0}: expected a folder ({0}/), an experiment ({0}.cambrian) "
                        "or a creature file ({0}.creature.json)",
                        asked)};
    const std::string name = fmt::format("{}-seed{}", settings.goal, settings.seed);
    const auto place = output_path(asked, fmt::format("champion-{}.creature.json", name), files);
    if (!place) return place.error();
    if (!asked.empty() && place->string() == asked)
        return RunOutputs{.champion = *place, .experiment = {}};
    RunOutputs outputs;
    int number = 0;
    do {
        outputs = named_in(place->parent_path(), name, ++number);
    } while (!is_free(outputs) && number < kMostOfOneName);
    return outputs;
}

Result<std::filesystem::path> save_champion(const RunOutputs& outputs, const OutputWish& wish,
                                            const CreatureDocument& champion,
                                            const EvolutionKinds& kinds) {
    auto saved = outputs.numbered ? save_numbered(outputs.champion, wish, champion, kinds)
                                  : save_replacing(outputs.champion, champion, kinds);
    if (saved) return saved;
    const Result<std::filesystem::path> folder = make_lasting_private_folder();
    if (!folder) return saved.error();
    const std::filesystem::path refuge = *folder / outputs.champion.filename();
    if (!save_creature(refuge, champion, kinds)) {
        std::error_code ignored;
        std::filesystem::remove(*folder, ignored);
        return saved.error();
    }
    return Error{fmt::format("{}; the champion is in {}", saved.error().message, refuge.string())};
}

std::string words_of(const RunOutputs& outputs) {
    if (outputs.champion.empty())
        return fmt::format("writes the experiment to {}", outputs.experiment.string());
    if (outputs.experiment.empty())
        return fmt::format(
            "writes the champion to {}, and no experiment; --out FOLDER/ or --out NAME.cambrian "
            "keeps one",
            outputs.champion.string());
    return fmt::format("writes the experiment to {} and the champion to {}",
                       outputs.experiment.string(), outputs.champion.string());
}

}  // namespace cambrian
