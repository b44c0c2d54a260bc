#include "persist/preserve/kept_genotypes.h"

#include "breeding/mutation.h"
#include "genome/founders/random_genome.h"
#include "persist/sqlite/database.h"
#include "support/temporary_directory.h"
#include "worlds.h"

#include <fmt/core.h>

namespace cambrian {
namespace {

using namespace test;

constexpr std::uint64_t kFirst = 1001;  // number of the first of the line
constexpr std::size_t kGenerations = 80;

// Mothers and their daughters, each with the mutations of hers and more.
std::vector<GenomePtr> line_of_descent() {
    const ExperimentSettings settings;
    RandomStream stream(stream_seed(3, 0, 0, Purpose::kTest));
    std::vector<GenomePtr> line;
    Genome genome = random_genome(settings.founders, kind_catalog(), stream);
    for (std::size_t i = 0; i < kGenerations; ++i) {
        line.push_back(std::make_shared<const Genome>(genome));
        mutate(genome, settings.mutation, kinds().mutations, {kind_catalog(), settings.founders},
               stream, 1);
    }
    return line;
}

// Writes the births of the line to a file, in two pieces.
void write_line(const std::filesystem::path& path, const std::vector<GenomePtr>& line) {
    const KeptWorld world = kept_in(path, small_world());
    for (const std::size_t begin : {std::size_t{0}, kGenerations / 2}) {
        Chronicle chronicle;
        for (std::size_t i = begin; i < begin + kGenerations / 2; ++i) {
            const std::uint64_t number = kFirst + i;
            chronicle.born.push_back(
                {.number = number, .parents = {i == 0 ? 0 : number - 1, 0}, .genome = line[i]});
        }
        REQUIRE(world.file->write(chronicle, *world.preserve));
    }
}

std::string message_of(const std::filesystem::path& path, std::uint64_t number) {
    const Database database(path, Database::Access::kRead);
    const Result<GenomePtr> genome = KeptGenotypes(database, kinds()).genome(number);
    return genome ? "no error" : genome.error().message;
}

TEST_CASE("genotypes of a line are read back from their differences", "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const std::vector<GenomePtr> line = line_of_descent();
    write_line(path, line);
    const Database database(path, Database::Access::kRead);
    KeptGenotypes genotypes(database, kinds());
    for (std::size_t i = 0; i < kGenerations; ++i) {
        const Result<GenomePtr> genome = genotypes.genome(kFirst + i);
        REQUIRE(genome);
        REQUIRE(**genome == *line[i]);
        const Result<KeptText> text = genotypes.text(kFirst + i);
        REQUIRE(text);
        REQUIRE(text->differences == i % (kMostDifferences + 1));
    }
    const auto mean_length = [&](const char* which) {
        return database.integer(
            fmt::format("SELECT CAST(avg(length(document)) AS INTEGER) FROM genotypes WHERE "
                        "number >= {} AND {}",
                        kFirst, which));
    };
    CHECK(mean_length("base != 0") < mean_length("base = 0") / 3);
}

TEST_CASE("a genotype whose differences are damaged is told, whatever the file says",
          "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    write_line(path, line_of_descent());
    const std::uint64_t number = kFirst + 10;
    const auto message_with = [&](const char* set) {
        const auto changed = folder.path() / "changed.cambrian";
        std::filesystem::remove(changed);
        Database(path, Database::Access::kRead).copy_to(changed);
        Database(changed, Database::Access::kWrite)
            .execute(fmt::format("UPDATE genotypes SET {} WHERE number = {}", set, number - 1));
        return message_of(changed, number);
    };
    CHECK(message_with("size = size") == "no error");
    CHECK(message_with("base = number") ==
          fmt::format("the genotype of creature {} has more than 32 differences", number));
    CHECK(message_with("base = number + 1") ==
          fmt::format("the genotype of creature {} has more than 32 differences", number));
    CHECK(message_with("base = 999") == "creature 999 is missing");
    CHECK(message_with("base = -5") == "creature 18446744073709551611 is missing");
    CHECK(message_with("size = -1") == "a genotype's size is negative");
    CHECK(message_with("size = 1000000000") == "genotype too large: 1000000000 bytes");
    CHECK(message_with("size = size + 1") == "cannot be decompressed");
    CHECK(message_with("document = x'00'") == "cannot be decompressed");
    CHECK(message_with("base = 0") == "cannot be decompressed");
    CHECK(message_of(path, 5000) == "creature 5000 is missing");
}

TEST_CASE("a child of a creature whose genotype is damaged is written by itself",
          "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const KeptWorld world = kept_in(path, small_world());
    const std::vector<GenomePtr> line = line_of_descent();
    const auto write = [&](std::uint64_t number, const GenomePtr& genome) {
        Chronicle chronicle;
        chronicle.born.push_back({.number = number, .parents = {number - 1, 0}, .genome = genome});
        REQUIRE(world.file->write(chronicle, *world.preserve));
    };
    write(kFirst, line[0]);
    Database(path, Database::Access::kWrite)
        .execute(fmt::format("UPDATE genotypes SET document = x'00' WHERE number = {}", kFirst));
    write(kFirst + 1, line[1]);
    CHECK(message_of(path, kFirst) == "cannot be decompressed");
    CHECK(message_of(path, kFirst + 1) == "no error");
}

TEST_CASE("a file's log can be emptied after each minute", "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const KeptWorld world = kept_in(path, small_world());
    Chronicle chronicle;
    chronicle.born.push_back({.number = kFirst, .parents = {1, 0}, .genome = eater(0.5)});
    REQUIRE(world.file->write(chronicle, *world.preserve));
    const Database other(path, Database::Access::kWrite);
    CHECK(other.integer("PRAGMA wal_checkpoint(TRUNCATE)") == 0);  // nobody reads it
}

TEST_CASE("a preserve goes on from the snapshot before one of whose creatures is damaged",
          "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    ExperimentSettings settings = small_world();
    settings.preserve.restock = settings.preserve.founders;
    std::uint64_t newcomer = 0;
    {
        const KeptWorld world = kept_in(path, settings);
        Preserve& preserve = *world.preserve;
        REQUIRE(preserve.intervene({.what = intervention::kRemove, .number = 1}));
        run_to(preserve, 300);
        REQUIRE(preserve.intervene({.what = intervention::kRest}));
        newcomer = preserve.residents().back()->life.number;
        REQUIRE(world.file->write(preserve.take_chronicle(), preserve));
    }
    REQUIRE(load_preserve(path, kinds())->snapshots.size() == 2);
    Database(path, Database::Access::kWrite)
        .execute(fmt::format("UPDATE genotypes SET document = x'00' WHERE number = {}", newcomer));
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    CHECK(opened->state.tick == 0);
    REQUIRE(opened->warnings.size() == 1);
    CHECK_THAT(opened->warnings.front(),
               Catch::StartsWith("the snapshot of 5 s is damaged (cannot be decompressed)"));
}

TEST_CASE("a file of version 5, which has no differences, is brought to the present one",
          "[preserve][genotypes]") {
    const TemporaryDirectory folder;
    const auto path = folder.path() / "pond.cambrian";
    const KeptWorld world =
        changed_in(path, "ALTER TABLE genotypes DROP COLUMN base; PRAGMA user_version = 5");
    const auto saved = load_preserve(path, kinds());
    REQUIRE(saved);
    REQUIRE(load_snapshot(path, saved->snapshots.front(), kinds()));
    const auto opened = PreserveFile::open(path, kinds());
    REQUIRE(opened);
    Chronicle chronicle;
    chronicle.born.push_back({.number = 50, .parents = {1, 0}, .genome = eater(0.25)});
    REQUIRE(opened->file->write(chronicle, *world.preserve));
    const Database database(path, Database::Access::kRead);
    CHECK(database.integer("PRAGMA user_version") == 6);
    CHECK(database.integer("SELECT base FROM genotypes WHERE number = 50") == 1);
    CHECK(**KeptGenotypes(database, kinds()).genome(50) == *eater(0.25));
}

}  // namespace
}  // namespace cambrian
