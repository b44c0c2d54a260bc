#include "app/evolution_report.h"

#include "core/number_text.h"
#include "persist/digest_text.h"
#include "persist/quoted_text.h"

#include <cstdio>

namespace cambrian {
namespace {

// Four decimals: the same column for every generation.
std::string fixed(double number) {
    char text[64];
    std::snprintf(text, sizeof text, "%.4f", number);
    return text;
}

std::string padded(std::string text, std::size_t width) {
    if (text.size() < width) text.insert(0, width - text.size(), ' ');
    return text;
}

std::string member(const char* key, const std::string& value) {
    return "\"" + std::string(key) + "\": " + value;
}

std::string savings_members(const GenerationStatistics& statistics) {
    return member("rejected", std::to_string(statistics.rejected)) + ", " +
           member("reused", std::to_string(statistics.reused)) + ", " +
           member("rested", std::to_string(statistics.rested)) + ", " +
           member("given_up", std::to_string(statistics.given_up)) + ", " +
           member("giving_up_distrusted", statistics.giving_up_distrusted ? "true" : "false") +
           ", " + member("time_saved", real_text(statistics.time_saved));
}

// What a person should know of a generation besides its numbers.
std::string remarks(const GenerationStatistics& statistics) {
    std::string text;
    if (stagnant(statistics)) {
        text += "   no progress for " + std::to_string(statistics.generations_without_progress) +
                " generations";
    }
    if (statistics.giving_up_distrusted)
        text += "   trials are not given up any more: an audited one would have survived";
    return text;
}

std::string json_of(const MutationRecord& mutation) {
    return "{" + member("operator", quoted_text(mutation.operator_id)) + ", " +
           member("place", quoted_text(mutation.place)) + ", " +
           member("from", quoted_text(mutation.from)) + ", " +
           member("to", quoted_text(mutation.to)) + "}";
}

std::string origin_members(const Individual& individual) {
    std::string parents;
    for (const std::uint64_t parent : individual.parents) {
        if (parent != 0) parents += (parents.empty() ? "" : ", ") + quoted_text(hex_text(parent));
    }
    std::string mutations;
    for (const MutationRecord& mutation : individual.mutations)
        mutations += (mutations.empty() ? "" : ", ") + json_of(mutation);
    return member("uid", quoted_text(hex_text(individual.uid))) + ", " +
           member("born", std::to_string(individual.born)) + ", " +
           member("method", quoted_text(individual.method)) + ", " +
           member("parents", "[" + parents + "]") + ", " +
           member("mutations", "[" + mutations + "]");
}

}  // namespace

std::string origin_in_words(const Individual& individual) {
    std::string text =
        "born in generation " + std::to_string(individual.born) + ", " + individual.method;
    for (const MutationRecord& mutation : individual.mutations) {
        text += "; " + mutation.place + ": ";
        text += mutation.from.empty() ? mutation.to : mutation.from + " to " + mutation.to;
    }
    return text;
}

std::string generation_line(const GenerationStatistics& statistics, const std::string& unit,
                            bool json) {
    const std::string number = std::to_string(statistics.generation);
    if (json) {
        return "{" + member("generation", number) + ", " +
               member("size", std::to_string(statistics.size)) + ", " +
               member("evaluations", std::to_string(statistics.evaluations)) + ", " +
               member("best", real_text(statistics.best)) + ", " +
               member("upper", real_text(statistics.upper)) + ", " +
               member("median", real_text(statistics.median)) + ", " +
               member("lower", real_text(statistics.lower)) + ", " +
               member("mean", real_text(statistics.mean)) + ", " +
               member("invalid_share", real_text(statistics.invalid_share)) + ", " +
               member("mean_parts", real_text(statistics.mean_parts)) + ", " +
               member("mean_neurons", real_text(statistics.mean_neurons)) + ", " +
               member("distinct_genomes", std::to_string(statistics.distinct_genomes)) + ", " +
               savings_members(statistics) + ", " +
               member("filled_cells", std::to_string(statistics.filled_cells)) + ", " +
               member("quality", real_text(statistics.quality)) + ", " +
               member("generations_without_progress",
                      std::to_string(statistics.generations_without_progress)) +
               ", " + member("unit", quoted_text(unit)) + "}";
    }
    return "generation " + padded(number, 4) + "   best " + padded(fixed(statistics.best), 8) +
           " " + unit + "   median " + padded(fixed(statistics.median), 8) + " " + unit +
           remarks(statistics);
}

std::string final_line(std::span<const GenerationStatistics> history, const std::string& unit,
                       const Individual& champion, const std::filesystem::path& file,
                       std::string_view stopped_by, bool json) {
    const GenerationStatistics& first = history.front();
    const GenerationStatistics& last = history.back();
    const bool interrupted = stopped_by == "interruption";
    if (json) {
        return "{" + member("champion", quoted_text(file.string())) + ", " +
               origin_members(champion) + ", " +
               member("generations", std::to_string(history.size())) + ", " +
               member("best_of_first", real_text(first.best)) + ", " +
               member("best_of_last", real_text(last.best)) + ", " +
               member("unit", quoted_text(unit)) + ", " +
               member("stopped_by", quoted_text(stopped_by)) + ", " +
               member("interrupted", interrupted ? "true" : "false") + "}";
    }
    return std::string(interrupted ? "interrupted; best" : "best") + " of generation " +
           std::to_string(first.generation) + ": " + fixed(first.best) + " " + unit +
           ", of generation " + std::to_string(last.generation) + ": " + fixed(last.best) + " " +
           unit + "\nchampion: " + file.string() + " (" + origin_in_words(champion) + ")";
}

}  // namespace cambrian
