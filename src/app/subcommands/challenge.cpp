#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/command_line/seed_list.h"
#include "app/page/board_cards.h"
#include "app/page/page_making.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "comparison/board_text.h"
#include "core/files/file_io.h"
#include "core/text/counted.h"
#include "core/threads/thread_pool.h"
#include "persist/settings/settings_file.h"
#include "simulator/simulator_version.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace cambrian {
namespace {

constexpr std::size_t kMostEntries = 10'000;
constexpr std::uint64_t kHeldOutOffset = 1'000'003;  // usual distance of the second seed

std::string name_of_challenge(const std::filesystem::path& file) {
    const std::string name = file.filename().string();
    return name.substr(0, name.find('.'));
}

class ChallengeSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option(
               "action", action_,
               "Action: new freezes settings to a challenge, enter ranks creatures on its board")
            ->check(CLI::IsMember({"new", "enter"}))
            ->required();
        app.add_option("file", file_, "Settings file (*.toml), or challenge (*.challenge.toml)")
            ->type_name(option_type::kSettings)
            ->required();
        app.add_option("entries", entries_,
                       "Creature files (*.creature.json), cards (*.card.png) or pages (*.html)")
            ->type_name(option_type::kCreature);
        take_whole(*app.add_option("-s,--seed", seed_,
                                   "Seed of the search, instead of that of the settings"),
                   0, kMostSeed);
        take_whole(*app.add_option("--held-out-seed", held_out_seed_,
                                   "Seed of the trials that rank entries where chance has a part; "
                                   "another one than --seed by default"),
                   0, kMostSeed);
        take_whole(*app.add_option("--budget", budget_, "Number of trials of a search")
                        ->default_str("20000"),
                   100, 1'000'000'000);
        app.add_option("--name", name_, "Name of the challenge, instead of the file's")
            ->type_name("NAME");
        app.add_option("-o,--out", out_,
                       "Challenge to write (*.challenge.toml), or board (*.md, *.html)")
            ->type_name(option_type::kChallengeOrBoard)
            ->required();
    }
    // The entries are read one by one, since each may be of another world.
    CommandFiles files() const override {
        return CommandFiles().reads(file_).writes(
            out_, action_ == "new" ? output_form::kChallenge : output_form::kBoard);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        return action_ == "new" ? freeze(kinds) : enter(kinds);
    }

private:
    ExitStatus freeze(const EvolutionKinds& kinds) {
        if (!entries_.empty()) return fail({"`challenge new` takes one settings file"});
        Result<ExperimentSettings> settings = load_settings(file_, kinds);
        if (!settings) return fail(settings.error());
        if (const Status possible = check_challenge(*settings, kinds); !possible)
            return fail({file_ + ": " + possible.error().message});
        const auto path = output_path(out_, "", files());
        if (!path) return fail(path.error());
        if (seed_) settings->seed = *seed_;
        ChallengeTable table{name_.empty() ? name_of_challenge(*path) : name_,
                             held_out_seed_.value_or((settings->seed + kHeldOutOffset) % kMostSeed),
                             std::string(simulator_version(kinds.creature.scene.dimensions))};
        const Challenge challenge = make_challenge(*std::move(settings), std::move(table), budget_);
        const std::string text = write_challenge(challenge, kinds);
        // It must be read as it was meant.
        const auto read = parse_challenge(text, path->string(), kinds);
        if (!read) return fail(read.error());
        const Status written = write_file(*path, text);
        if (!written) return fail(written.error(), ExitStatus::kFailed);
        return print_result_line(fmt::format("{}: seed {}, {} trials", path->string(),
                                             challenge.settings.seed, budget_));
    }

    ExitStatus enter(const EvolutionKinds& kinds) {
        if (seed_ || held_out_seed_ || !name_.empty())
            return fail({"--seed, --held-out-seed and --name are frozen in the challenge"});
        if (entries_.empty()) return fail({"expected creatures to enter"});
        if (entries_.size() > kMostEntries)
            return fail(
                {fmt::format("{} entries; expected at most {}", entries_.size(), kMostEntries)});
        const Result<Challenge> challenge = load_challenge(file_, kinds);
        if (!challenge) return fail(challenge.error());
        const auto path = output_path(out_, "", files().reads_each(entries_));
        if (!path) return fail(path.error());
        LongWork work;
        work.begin("judging", static_cast<double>(entries_.size()), "entries");
        ThreadPool pool(ThreadPool::default_workers());
        const auto board = judge_entries(*challenge, {entries_.begin(), entries_.end()}, kinds,
                                         pool, work.watch());
        if (!board) return fail(board.error(), ExitStatus::kFailed);
        return write_board(*board, *path, kinds, work);
    }

    static ExitStatus write_board(const ChallengeBoard& board, const std::filesystem::path& path,
                                  const EvolutionKinds& kinds, LongWork& work) {
        std::string text;
        const std::filesystem::path folder = path.parent_path();
        if (is_page_name(path)) {
            work.begin("drawing",
                       static_cast<double>(std::min(board.ranked.size(), kMostBoardCards)),
                       "cards");
            const auto cards = board_cards(board, kinds, work.watch());
            if (work.interrupted())
                return fail({"interrupted; nothing was written"}, ExitStatus::kFailed);
            text = board_html(board, folder, cards, kinds);
        } else {
            text = board_markdown(board, folder, kinds);
        }
        const Status written = write_file(path, text);
        if (!written) return fail(written.error(), ExitStatus::kFailed);
        for (const BoardEntry& entry : board.refused)
            say(fmt::format("{}: refused: {}", entry.file.string(), entry.refusal));
        return print_result_line(fmt::format("{}: {} ranked, {} refused", path.string(),
                                             board.ranked.size(), board.refused.size()));
    }

    std::string action_;
    std::string file_;
    std::vector<std::string> entries_;
    std::optional<std::uint64_t> seed_;
    std::optional<std::uint64_t> held_out_seed_;
    int budget_ = 20'000;
    std::string name_;
    std::string out_;
};

}  // namespace

SubcommandKind challenge_subcommand() {
    return {
        .id = "challenge",
        .summary = "Freeze settings to a challenge for several people, or rank creatures in it.",
        .example =
            "cambrian challenge enter assets/challenges/walk.challenge.toml "
            "assets/creatures/biped.creature.json -o board.html",
        .make = make_subcommand<ChallengeSubcommand>};
}

}  // namespace cambrian
