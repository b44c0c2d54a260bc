#pragma once

// Edits of any table of an experiment, chosen by bytes: cells of every type, rows, and genotypes
// with all that says how long they are and whose.

#include "fuzz/byte_source.h"
#include "persist/sqlite/database.h"
#include "persist/text/deflated_text.h"

#include <optional>
#include <string>
#include <vector>

namespace cambrian::test {

class TableEdits {
public:
    // sample: knows the tables and how many rows they have.
    explicit TableEdits(const Database& sample);

    // As many as there are bytes for, up to some limit. One that the database refuses changes
    // nothing.
    void apply(Database& database, ByteSource& bytes);

private:
    struct Table {
        std::string name;
        std::vector<std::string> columns;
        std::string key;  // its columns, with commas between
        std::size_t rows = 0;
    };
    // A cell, as the SQL of an update.
    struct Place {
        std::string table, column, row;
    };

    Place place(ByteSource& bytes) const;
    // The value of a text.
    static std::optional<std::string> words_at(const Database& database, const Place& cell);
    void apply_one(Database& database, ByteSource& bytes);
    void copy_row(Database& database, ByteSource& bytes) const;
    void change_genotype(Database& database, ByteSource& bytes);

    std::vector<Table> tables_;
    Inflater inflater_;
    Deflater deflater_;
};

}  // namespace cambrian::test
