// Fuzzes preserve files: the reader gives a world that goes on, or a message.
//
// An input that begins with W changes numbers of a sound snapshot, with E it is a list of edits to
// the tables of a valid preserve, and with P it replaces bytes of its pages. Any other input is a
// file.

#include "evolution/fields/setting_field.h"
#include "fuzz/byte_source.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/preserve_sample.h"
#include "fuzz/scratch.h"
#include "fuzz/table_edits.h"
#include "persist/preserve/preserve_file.h"
#include "persist/preserve/preserve_tables.h"
#include "preserve/laws.h"
#include "preserve/preserve.h"
#include "support/kinds.h"
#include "support/temporary_directory.h"

using namespace cambrian;
using namespace cambrian::test;

namespace {

constexpr int kMostChanges = 32;           // of numbers
constexpr int kTicks = 3;                  // for which a world goes on
constexpr std::size_t kMostResidents = 8;  // of a world that goes on
constexpr std::size_t kWrittenOneIn = 61;  // one of so many edited preserves is written to a file

// The sample remains open, so that its tables need not be created each time.
struct Workplace {
    TemporaryDirectory folder{scratch_folder()};
    std::filesystem::path path = folder / "input.cambrian";
    std::filesystem::path edited = folder / "sample.cambrian";
    std::string sample = sample_preserve(folder.path());
    Database database{edited, Database::Access::kWrite};
    TableEdits edits{database};
    SavedPreserve saved = read_preserve(database, kinds());
    PreserveState state = *read_snapshot(database, saved.snapshots.back(), kinds());
    ThreadPool pool{1};

    Workplace() { database.execute("PRAGMA journal_mode = MEMORY; PRAGMA synchronous = OFF"); }
};

// Goes on from a state that was read, unless that is refused.
void go_on(const PreserveOrigin& origin, const PreserveState& state, const SettingsPtr& laws,
           ThreadPool& pool) {
    if (state.residents.size() > kMostResidents) return;
    auto preserve = Preserve::resume(origin.settings, kinds(), origin.founders, state, laws);
    if (!preserve) {
        promise(!preserve.error().message.empty(), "a refusal has a reason");
        return;
    }
    const PreserveState begun = (*preserve)->save();
    const auto again = Preserve::resume(origin.settings, kinds(), origin.founders, begun, laws);
    promise(again && words_of((*again)->save()) == words_of(begun),
            "a state is restored as it was");
    for (int i = 0; i < kTicks; ++i)
        (*preserve)->tick(pool);
    promise((*preserve)->total_energy() == (*preserve)->founding_energy(), "energy is conserved");
    for (const auto& each : (*preserve)->residents())
        promise(each->center().allFinite(), "creatures are somewhere");
}

void look_at(const SavedPreserve& saved) {
    promise(saved.origin.settings != nullptr, "there are settings");
    promise(check_preserve(*saved.origin.settings, kinds()).has_value(),
            "all settings pass their check");
    promise(!saved.origin.founders.empty() && !saved.snapshots.empty(),
            "there are founders and a snapshot");
    for (const GenomePtr& founder : saved.origin.founders)
        promise(validate(*founder, kinds().creature.catalog).empty(), "every genome is valid");
}

void look_at(const std::vector<MuseumPiece>& museum) {
    for (const MuseumPiece& piece : museum)
        promise(validate(*piece.genome, kinds().creature.catalog).empty(), "every genome is valid");
}

void read_tables(Workplace& at) {
    try {
        look_at(read_museum(at.database, kinds()));
        const SavedPreserve saved = read_preserve(at.database, kinds());
        look_at(saved);
        const auto state = read_snapshot(at.database, saved.snapshots.back(), kinds());
        const auto laws = laws_at(saved.origin.settings, saved.interventions,
                                  saved.snapshots.back().tick, kinds());
        promise(laws || !laws.error().message.empty(), "a refusal has a reason");
        if (state && laws) go_on(saved.origin, *state, *laws, at.pool);
    } catch (const DatabaseError& error) {
        promise(*error.what() != '\0', "a refusal has a reason");
    }
}

void read_file(Workplace& at) {
    for (const auto& table : {lives_csv(at.path), series_csv(at.path)})
        promise(!table || table->find('\n') != std::string::npos, "a table has a line of names");
    if (const auto museum = load_museum(at.path, kinds())) look_at(*museum);
    const auto saved = load_preserve(at.path, kinds());
    promise(saved || saved.error().message.find(at.path.string()) != std::string::npos,
            "a refusal names the file");
    const auto opened = PreserveFile::open(at.path, kinds());
    promise(saved.has_value() || !opened.has_value(), "what is opened can be looked at");
    if (!opened) return;
    look_at(*saved);
    go_on(opened->origin, opened->state, opened->laws, at.pool);
    promise(load_preserve(at.path, kinds()).has_value(), "an opened file can be read again");
}

void read_edited(Workplace& at, std::string_view input) {
    ByteSource bytes(input);
    at.database.execute("BEGIN");
    at.edits.apply(at.database, bytes);
    if (input.size() % kWrittenOneIn != 0) {
        read_tables(at);
        return at.database.execute("ROLLBACK");
    }
    at.database.execute("COMMIT");
    std::filesystem::copy_file(at.edited, at.path,
                               std::filesystem::copy_options::overwrite_existing);
    read_file(at);
    put_text(at.edited, at.sample);
}

// Reads the sample's snapshot with numbers changed to others, moved a little, copied or removed.
void read_words(Workplace& at, ByteSource bytes) {
    std::vector<std::uint64_t> words = words_of(at.state);
    for (int i = 0; i < kMostChanges && !bytes.empty() && !words.empty(); ++i) {
        const auto place = words.begin() + static_cast<std::ptrdiff_t>(bytes.below(words.size()));
        switch (bytes.below(4)) {
            case 0:
                *place = bytes.number<std::uint64_t>();
                break;
            case 1:
                *place += static_cast<std::uint64_t>(std::int64_t{bytes.number<std::int8_t>()});
                break;
            case 2:
                words.insert(place, words[bytes.below(words.size())]);
                break;
            default:
                words.erase(place);
        }
    }
    const auto state = state_of(words, [&](std::uint64_t number) -> Result<Origin> {
        if (number == 0) return Error{"creature 0 is missing"};
        return Origin{at.saved.origin.founders.front(), "founder"};
    });
    if (state) go_on(at.saved.origin, *state, at.saved.origin.settings, at.pool);
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static Workplace at;
    const std::string_view input = text_of(data, size);
    if (input.starts_with('W')) {
        read_words(at, ByteSource(input.substr(1)));
        return 0;
    }
    if (input.starts_with('E')) {
        read_edited(at, input.substr(1));
        return 0;
    }
    put_text(at.path, input.starts_with('P')
                          ? with_patched_pages(at.sample, ByteSource(input.substr(1)))
                          : std::string(input));
    read_file(at);
    return 0;
}
