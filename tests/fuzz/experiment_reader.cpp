// Fuzzes experiment files: the reader gives a complete experiment that can continue, or a message.
//
// Most files are rejected at their first bytes. An input that begins with E is therefore a list of
// edits to the tables of a valid experiment, and one that begins with P replaces bytes of its
// pages. Any other input is a file.

#include "persist/experiment/experiment_reader.h"

#include "evolution/fields/setting_field.h"
#include "evolution/individual/population_digest.h"
#include "fuzz/byte_source.h"
#include "fuzz/experiment_sample.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/scratch.h"
#include "fuzz/table_edits.h"
#include "persist/experiment/experiment_file.h"
#include "persist/records/individual_reader.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

constexpr std::size_t kWrittenOneIn = 61;  // one of so many edited experiments is written to a file
constexpr int kMostBred = 100;             // creatures

// The sample remains open, so that its tables need not be created each time.
struct Workplace {
    TemporaryDirectory folder{scratch_folder()};
    std::filesystem::path path = folder / "input.cambrian";
    std::filesystem::path edited = folder / "sample.cambrian";
    std::string sample = sample_experiment(folder.path());
    Database database{edited, Database::Access::kWrite};
    TableEdits edits{database};

    Workplace() { database.execute("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF"); }
};

// Writes the digest of the population if the file has all of it.
void renew_digest(Database& database) {
    std::vector<IndividualPtr> population;
    IndividualReader individuals(database, kinds());
    try {
        const SettingsPtr settings = read_last_settings(database, kinds());
        Statement place =
            database.prepare("SELECT individual, judged FROM population ORDER BY place");
        while (place.step())
            population.push_back(individuals.read({place.integer(0), place.integer(1)}, *settings));
    } catch (const DatabaseError&) {
        return;
    }
    database
        .prepare(
            "UPDATE generations SET population_digest = ? WHERE generation = "
            "(SELECT max(generation) FROM generations)")
        .run(population_digest(population));
}

void look_at(const IndividualPtr& individual) {
    promise(individual && individual->genome, "there are no holes");
    promise(validate(*individual->genome, kinds().creature.catalog).empty(),
            "every genome is valid");
}

void look_at(const SettingsPtr& settings) {
    static ExperimentSettings sound;  // the last valid ones
    promise(settings != nullptr, "there are settings");
    if (*settings == sound) return;
    promise(check_settings(*settings, kinds()).has_value(), "all settings pass their check");
    sound = *settings;
}

void look_at(const EvolutionState& latest) {
    promise(!latest.population.empty(), "a generation has creatures");
    promise(latest.generation + 1 == latest.history.size(), "the latest generation is the last");
    for (std::size_t i = 0; i < latest.history.size(); ++i)
        promise(latest.history[i].generation == i, "generations follow each other");
    for (const IndividualPtr& individual : latest.population)
        look_at(individual);
    for (const IndividualPtr& individual : latest.memory.archive)
        look_at(individual);
    look_at(latest.settings);
}

void go_on(const SavedExperiment& saved) {
    for (const JournalEntry& change : setting_changes(saved)) {
        look_at(change.settings);
        if (change.settings->population.size > kMostBred) return;
    }
    if (saved.latest && saved.latest->settings->population.size > kMostBred) return;
    const Evolution evolution = resumed(saved, kinds());
    promise(!evolution.population().empty(), "the next generation can be bred");
}

void look_at(const SavedExperiment& saved) {
    const std::size_t generations = saved.latest ? saved.latest->history.size() : 0;
    promise(saved.champions.size() == generations && saved.digests.size() == generations,
            "every generation has a champion and a digest");
    for (const JudgedIndividual& champion : saved.champions)
        look_at(champion.individual);
    if (saved.latest) look_at(*saved.latest);
    look_at(saved.settings);
    go_on(saved);
}

void look_at(const PickingRecord& picking) {
    for (std::uint32_t i = 0; i < picking.tree.size(); ++i) {
        promise(!picking.tree.node(i).creatures.empty(), "a grid has creatures");
        for (const IndividualPtr& individual : picking.tree.node(i).creatures)
            look_at(individual);
    }
    for (const std::size_t pick : picking.picks)
        promise(pick < picking.tree.current().creatures.size(), "only what is there is picked");
}

// Returns whether the file could be read.
bool read_file_at(const std::filesystem::path& path) {
    const auto saved = load_experiment(path, kinds());
    promise(saved || saved.error().message.find(path.string()) != std::string::npos,
            "a refusal names the file");
    if (saved) look_at(*saved);
    return saved.has_value();
}

// Checks that an experiment stays the same when it is opened to be continued.
void keep_on(const std::filesystem::path& path) {
    const auto opened = open_experiment(path, kinds());
    promise(opened.has_value(), "what can be looked at can be gone on with");
    promise(opened->file->keep_picking(opened->picking) && opened->file->keep_stars(opened->stars),
            "what was read can be kept");
    const auto again = load_experiment(path, kinds());
    promise(again && again->digests == opened->saved.digests, "and read again");
}

void read_tables(const Database& database) {
    try {
        const ReadExperiment read = read_experiment(database, kinds());
        look_at(read.saved);
        look_at(read.picking);
    } catch (const DatabaseError& error) {
        promise(*error.what() != '\0', "a refusal has a reason");
    }
}

// Reads the edited experiment as a file.
void read_committed(Workplace& at) {
    at.database.execute("COMMIT");
    std::filesystem::copy_file(at.edited, at.path,
                               std::filesystem::copy_options::overwrite_existing);
    if (read_file_at(at.path)) keep_on(at.path);
    put_text(at.edited, at.sample);
}

void read_edited(Workplace& at, std::string_view input) {
    ByteSource bytes(input);
    at.database.execute("BEGIN");
    const bool digest = bytes.number<std::uint8_t>() % 2 == 0;
    at.edits.apply(at.database, bytes);
    if (digest) renew_digest(at.database);
    if (input.size() % kWrittenOneIn == 0) return read_committed(at);
    read_tables(at.database);
    at.database.execute("ROLLBACK");
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Workplace at;
    const std::string_view input = text_of(data, size);
    if (input.starts_with('E')) {
        read_edited(at, input.substr(1));
        return 0;
    }
    put_text(at.path, input.starts_with('P')
                          ? with_patched_pages(at.sample, ByteSource(input.substr(1)))
                          : std::string(input));
    read_file_at(at.path);
    return 0;
}
