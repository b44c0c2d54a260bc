#include "persist/preserve/kept_genotypes.h"

#include <fmt/core.h>

#include <vector>

namespace cambrian {
namespace {

constexpr std::int64_t kFirstVersionWithBases = 6;  // of the tables

struct PackedRow {
    std::int64_t size = 0;
    std::string bytes;
};

std::string selection(const Database& database) {
    const bool has_bases = database.integer("PRAGMA user_version") >= kFirstVersionWithBases;
    return fmt::format("SELECT size, document, {} FROM genotypes WHERE number = ?",
                       has_bases ? "base" : "0");
}

}  // namespace

KeptGenotypes::KeptGenotypes(const Database& database, const EvolutionKinds& kinds)
    : select_(database.prepare(selection(database))), reader_(kinds) {}

Result<KeptText> KeptGenotypes::text(std::uint64_t number) {
    std::vector<PackedRow> rows;  // from the wanted one to the one without a base
    for (std::uint64_t next = number; rows.empty() || next != 0;) {
        if (rows.size() > kMostDifferences)
            return Error{fmt::format("the genotype of creature {} has more than {} differences",
                                     number, kMostDifferences)};
        select_.bind(next);
        if (!select_.step()) return Error{fmt::format("creature {} is missing", next)};
        rows.push_back({select_.integer(0), std::string(select_.bytes(1))});
        next = static_cast<std::uint64_t>(select_.integer(2));
        select_.restart();  // a row that is still selected would keep the log from being emptied
    }
    Result<std::string> text = reader_.unpack(rows.back().bytes, rows.back().size);
    for (auto row = rows.rbegin() + 1; text && row != rows.rend(); ++row)
        text = reader_.unpack_difference(row->bytes, *text, row->size);
    if (!text) return text.error();
    return KeptText{*std::move(text), rows.size() - 1};
}

Result<GenomePtr> KeptGenotypes::genome(std::uint64_t number) {
    const Result<KeptText> kept = text(number);
    return kept ? reader_.parse(kept->text) : kept.error();
}

}  // namespace cambrian
