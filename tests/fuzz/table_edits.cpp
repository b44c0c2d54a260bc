#include "fuzz/table_edits.h"

#include "fuzz/fuzz_target.h"
#include "genome/genome.h"
#include "persist/creature/creature_file.h"
#include "support/kinds.h"

#include <algorithm>
#include <utility>

namespace cambrian::test {
namespace {

constexpr int kMostEdits = 32;
constexpr std::size_t kMostGenotype = 100'000;  // bytes

std::string list(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names)
        text += (text.empty() ? "" : ", ") + name;
    return text;
}

// Replaces a part of the text.
std::string spliced(std::string text, ByteSource& bytes) {
    const std::size_t at = bytes.below(text.size() + 1);
    const std::size_t removed = bytes.number<std::uint8_t>();
    return text.replace(at, removed, bytes.text());
}

void bind_value(Statement& statement, ByteSource& bytes) {
    switch (bytes.below(6)) {
        case 0:
            return statement.bind_next(std::int64_t{bytes.number<std::int8_t>()});
        case 1:
            return statement.bind_next(bytes.number<std::int64_t>());
        case 2:
            return statement.bind_next(bytes.number<double>());
        case 3:
            return statement.bind_next(bytes.text());
        case 4:
            return statement.bind_bytes(bytes.text());
        default:
            return statement.bind_next(std::nullopt);
    }
}

}  // namespace

TableEdits::TableEdits(const Database& sample) {
    Statement names = sample.prepare("SELECT name FROM sqlite_schema WHERE type = 'table'");
    while (names.step()) {
        Table table;
        table.name = names.text(0);
        std::vector<std::string> keys;
        Statement columns = sample.prepare("SELECT name, pk FROM pragma_table_info(?) ORDER BY pk");
        columns.bind(table.name);
        while (columns.step()) {
            table.columns.emplace_back(columns.text(0));
            if (columns.integer(1) > 0) keys.emplace_back(columns.text(0));
        }
        table.key = list(keys);
        table.rows = static_cast<std::size_t>(sample.integer("SELECT count(*) FROM " + table.name));
        promise(table.rows > 0, "the sample has something in every table");
        for (const std::string& column : table.columns) {
            if (column == "document" || column == "genotype")
                holders_.push_back({table.name, table.key, column});
        }
        tables_.push_back(std::move(table));
    }
}

TableEdits::Place TableEdits::place(ByteSource& bytes) const {
    const Table& table = tables_[bytes.below(tables_.size())];
    const std::string row = std::to_string(bytes.below(table.rows));
    return {table.name, table.columns[bytes.below(table.columns.size())],
            " WHERE (" + table.key + ") = (SELECT " + table.key + " FROM " + table.name +
                " LIMIT 1 OFFSET " + row + ")"};
}

void TableEdits::copy_row(Database& database, ByteSource& bytes) const {
    const Table& table = tables_[bytes.below(tables_.size())];
    const std::string row = std::to_string(bytes.below(table.rows));
    std::vector<std::string> values = table.columns;
    values[bytes.below(values.size())] = "?";
    Statement copy =
        database.prepare("INSERT INTO " + table.name + " (" + list(table.columns) + ") SELECT " +
                         list(values) + " FROM " + table.name + " LIMIT 1 OFFSET " + row);
    copy.restart();
    bind_value(copy, bytes);
    copy.finish();
}

void TableEdits::change_genotype(Database& database, ByteSource& bytes) {
    const std::string row = std::to_string(bytes.number<std::uint8_t>() % 8);
    const bool founder = bytes.number<std::uint8_t>() % 4 == 0;
    const auto holder = std::find_if(holders_.begin(), holders_.end(), [&](const Holder& each) {
        return (each.table != "genotypes") == founder;
    });
    if (holder == holders_.end()) return;
    Statement selection = database.prepare("SELECT " + holder->key + ", size, " + holder->column +
                                           " FROM " + holder->table + " WHERE " + holder->column +
                                           " NOT NULL LIMIT 1 OFFSET " + row);
    if (!selection.step()) return;
    const std::int64_t id = selection.integer(0);
    const auto size = static_cast<std::size_t>(selection.integer(1));
    if (size > kMostGenotype) return;
    const auto whole = inflater_.inflate(selection.bytes(2), size);
    if (!whole) return;
    selection.restart();
    const std::string text = spliced(*whole, bytes);
    Statement update = database.prepare("UPDATE " + holder->table + " SET " + holder->column +
                                        " = ?, size = ? WHERE " + holder->key + " = ?");
    update.restart();
    update.bind_bytes(deflater_.deflate(text));
    update.bind_next(std::int64_t(text.size()));
    update.bind_next(id);
    update.finish();
    if (founder || holder->key != "individual") return;
    if (const auto document = parse_creature(text, "genotype", kinds()))
        database.prepare("UPDATE individuals SET genome_hash = ? WHERE id = ?")
            .run(genome_hash(document->genome()), id);
}

std::optional<std::string> TableEdits::words_at(const Database& database, const Place& cell) {
    Statement row = database.prepare("SELECT " + cell.column + " FROM " + cell.table + cell.row +
                                     " AND typeof(" + cell.column + ") = 'text'");
    if (!row.step()) return std::nullopt;
    return std::string(row.text(0));
}

void TableEdits::apply_one(Database& database, ByteSource& bytes) {
    const std::size_t edit = bytes.below(8);
    if (edit == 0) return copy_row(database, bytes);
    if (edit == 1) return change_genotype(database, bytes);
    const Place cell = place(bytes);
    if (edit == 2) return database.execute("DELETE FROM " + cell.table + cell.row);
    const auto words = edit <= 4 ? words_at(database, cell) : std::nullopt;
    Statement update =
        database.prepare("UPDATE " + cell.table + " SET " + cell.column + " = ?" + cell.row);
    update.restart();
    if (words) {
        update.bind_next(spliced(*words, bytes));
    } else {
        bind_value(update, bytes);
    }
    update.finish();
}

void TableEdits::apply(Database& database, ByteSource& bytes) {
    for (int i = 0; i < kMostEdits && !bytes.empty(); ++i) {
        try {
            apply_one(database, bytes);
        } catch (const DatabaseError&) {
            continue;
        }
    }
}

}  // namespace cambrian::test
