#pragma once

#include "evolution/individual/statistics.h"
#include "persist/sqlite/columns.h"

#include <array>

namespace cambrian {

inline constexpr std::array kStatisticsColumns = {
    Column<GenerationStatistics>{"generation", &GenerationStatistics::generation},
    Column<GenerationStatistics>{"size", &GenerationStatistics::size},
    Column<GenerationStatistics>{"evaluations", &GenerationStatistics::evaluations},
    Column<GenerationStatistics>{"best", &GenerationStatistics::best},
    Column<GenerationStatistics>{"upper", &GenerationStatistics::upper},
    Column<GenerationStatistics>{"median", &GenerationStatistics::median},
    Column<GenerationStatistics>{"lower", &GenerationStatistics::lower},
    Column<GenerationStatistics>{"mean", &GenerationStatistics::mean},
    Column<GenerationStatistics>{"invalid_share", &GenerationStatistics::invalid_share},
    Column<GenerationStatistics>{"mean_parts", &GenerationStatistics::mean_parts},
    Column<GenerationStatistics>{"mean_neurons", &GenerationStatistics::mean_neurons},
    Column<GenerationStatistics>{"distinct_genomes", &GenerationStatistics::distinct_genomes},
    Column<GenerationStatistics>{"rejected", &GenerationStatistics::rejected},
    Column<GenerationStatistics>{"reused", &GenerationStatistics::reused},
    Column<GenerationStatistics>{"rested", &GenerationStatistics::rested},
    Column<GenerationStatistics>{"given_up", &GenerationStatistics::given_up},
    Column<GenerationStatistics>{"giving_up_distrusted",
                                 &GenerationStatistics::giving_up_distrusted},
    Column<GenerationStatistics>{"time_saved", &GenerationStatistics::time_saved},
    Column<GenerationStatistics>{"filled_cells", &GenerationStatistics::filled_cells},
    Column<GenerationStatistics>{"quality", &GenerationStatistics::quality},
    Column<GenerationStatistics>{"generations_without_progress",
                                 &GenerationStatistics::generations_without_progress},
    Column<GenerationStatistics>{"progress_mark", &GenerationStatistics::progress_mark},
};

// Columns added by version 3 of experiment files.
inline constexpr std::array kLaterStatisticsColumns = {
    Column<GenerationStatistics>{"confirmations", &GenerationStatistics::confirmations},
    Column<GenerationStatistics>{"best_lowest", &GenerationStatistics::best_lowest},
    Column<GenerationStatistics>{"best_highest", &GenerationStatistics::best_highest},
    Column<GenerationStatistics>{"lines", &GenerationStatistics::lines},
    Column<GenerationStatistics>{"plans", &GenerationStatistics::plans},
};

}  // namespace cambrian
