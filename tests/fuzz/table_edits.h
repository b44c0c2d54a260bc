#pragma once

// Edits of any table of a database, chosen by the input's bytes: cells of every type, rows, and
// genotypes with their lengths and owners.

#include "core/deflated_text.h"
#include "fuzz/byte_source.h"
#include "persist/sqlite/database.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian::test {

class TableEdits {
public:
    // `sample` gives the tables and their numbers of rows.
    explicit TableEdits(const Database& sample);

    // Makes edits while there are bytes, up to a limit. An edit that the database rejects has no
    // effect.
    void apply(Database& database, ByteSource& bytes);

private:
    struct Table {
        std::string name;
        std::vector<std::string> columns;
        std::string key;  // its columns, separated by commas
        std::size_t rows = 0;
    };
    // A table with genotypes.
    struct Holder {
        std::string table, key, column;
    };
    // A cell, in the form of an SQL update.
    struct Place {
        std::string table, column, row;
    };

    Place place(ByteSource& bytes) const;
    // Returns the text in a cell, if it has one.
    static std::optional<std::string> words_at(const Database& database, const Place& cell);
    void apply_one(Database& database, ByteSource& bytes);
    void copy_row(Database& database, ByteSource& bytes) const;
    void change_genotype(Database& database, ByteSource& bytes);

    std::vector<Table> tables_;
    std::vector<Holder> holders_;
    Inflater inflater_;
    Deflater deflater_;
};

}  // namespace cambrian::test
