#include "app/evolution_report.h"

#include "core/number_text.h"
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

}  // namespace

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
               member("unit", quoted_text(unit)) + "}";
    }
    return "generation " + padded(number, 4) + "   best " + padded(fixed(statistics.best), 8) +
           " " + unit + "   median " + padded(fixed(statistics.median), 8) + " " + unit;
}

std::string final_line(std::span<const GenerationStatistics> history, const std::string& unit,
                       const std::filesystem::path& champion, bool interrupted, bool json) {
    const GenerationStatistics& first = history.front();
    const GenerationStatistics& last = history.back();
    if (json) {
        return "{" + member("champion", quoted_text(champion.string())) + ", " +
               member("generations", std::to_string(history.size())) + ", " +
               member("best_of_first", real_text(first.best)) + ", " +
               member("best_of_last", real_text(last.best)) + ", " +
               member("unit", quoted_text(unit)) + ", " +
               member("interrupted", interrupted ? "true" : "false") + "}";
    }
    return std::string(interrupted ? "interrupted; best" : "best") + " of generation " +
           std::to_string(first.generation) + ": " + fixed(first.best) + " " + unit +
           ", of generation " + std::to_string(last.generation) + ": " + fixed(last.best) + " " +
           unit + "\nchampion: " + champion.string();
}

}  // namespace cambrian
