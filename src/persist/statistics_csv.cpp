#include "persist/statistics_csv.h"

#include "core/number_text.h"

#include <array>
#include <cstdint>
#include <variant>

namespace cambrian {
namespace {

using Row = GenerationStatistics;

struct Column {
    const char* name;
    std::variant<std::uint32_t Row::*, int Row::*, double Row::*, bool Row::*> field;
};

constexpr std::array kColumns = {
    Column{"generation", &Row::generation},
    Column{"size", &Row::size},
    Column{"evaluations", &Row::evaluations},
    Column{"best", &Row::best},
    Column{"upper", &Row::upper},
    Column{"median", &Row::median},
    Column{"lower", &Row::lower},
    Column{"mean", &Row::mean},
    Column{"invalid_share", &Row::invalid_share},
    Column{"mean_parts", &Row::mean_parts},
    Column{"mean_neurons", &Row::mean_neurons},
    Column{"distinct_genomes", &Row::distinct_genomes},
    Column{"rejected", &Row::rejected},
    Column{"reused", &Row::reused},
    Column{"rested", &Row::rested},
    Column{"given_up", &Row::given_up},
    Column{"giving_up_distrusted", &Row::giving_up_distrusted},
    Column{"time_saved", &Row::time_saved},
    Column{"filled_cells", &Row::filled_cells},
    Column{"quality", &Row::quality},
    Column{"generations_without_progress", &Row::generations_without_progress},
    Column{"progress_mark", &Row::progress_mark},
};

std::string number_text(double number) {
    return real_text(number);
}
template <class Whole>
std::string number_text(Whole number) {
    return std::to_string(number);
}

}  // namespace

std::string statistics_csv(std::span<const GenerationStatistics> history) {
    std::string text;
    for (const Column& column : kColumns) {
        if (!text.empty()) text += ',';
        text += column.name;
    }
    text += '\n';
    for (const Row& row : history) {
        for (const Column& column : kColumns) {
            if (&column != kColumns.data()) text += ',';
            text +=
                std::visit([&row](auto field) { return number_text(row.*field); }, column.field);
        }
        text += '\n';
    }
    return text;
}

}  // namespace cambrian
