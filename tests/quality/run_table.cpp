#include "quality/run_table.h"

#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "persist/sqlite/column_text.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <sstream>
#include <utility>

namespace cambrian::quality {
namespace {

constexpr std::size_t kMaxBytes = 64'000'000;
constexpr const char* kMethods[] = {"asexual", "crossover", "grafting", "homologous-crossover"};

constexpr std::array kColumns = {
    Column<RunResult>{"plan", &RunResult::plan},
    Column<RunResult>{"goal", &RunResult::goal},
    Column<RunResult>{"arm", &RunResult::arm},
    Column<RunResult>{"seed", &RunResult::seed},
    Column<RunResult>{"size", &RunResult::size},
    Column<RunResult>{"budget", &RunResult::budget},
    Column<RunResult>{"best", &RunResult::best},
    Column<RunResult>{"final_best", &RunResult::final_best},
    Column<RunResult>{"evaluations", &RunResult::evaluations},
    Column<RunResult>{"generations", &RunResult::generations},
    Column<RunResult>{"cpu_seconds", &RunResult::seconds},
    Column<RunResult>{"invalid_share", &RunResult::invalid_share},
    Column<RunResult>{"cells", &RunResult::cells},
    Column<RunResult>{"quality", &RunResult::quality},
    Column<RunResult>{"decreased", &RunResult::decreased},
    Column<RunResult>{"champion_finer", &RunResult::finer},
    Column<RunResult>{"champion_late_travel", &RunResult::late_travel},
    Column<RunResult>{"champion_reversals", &RunResult::reversals},
    Column<RunResult>{"champion_clean", &RunResult::clean},
    Column<RunResult>{"digest", &RunResult::digest, CellForm::kUid},
};
constexpr std::array kOffspringColumns = {
    Column<Offspring>{"children", &Offspring::born},
    Column<Offspring>{"improved", &Offspring::improved},
};

// Ends a line after the last cell instead of with a comma.
std::string ended(std::string line) {
    line.back() = '\n';
    return line;
}

bool read_run(std::string_view line, RunResult& run) {
    if (!take_cells<RunResult>(line, kColumns, run)) return false;
    return std::all_of(std::begin(kMethods), std::end(kMethods), [&](const char* method) {
        return take_cells<Offspring>(line, kOffspringColumns, run.offspring[method]);
    });
}

}  // namespace

std::string run_header() {
    std::string line;
    for (const Column<RunResult>& column : kColumns)
        line += std::string(column.name) + ",";
    for (const char* method : kMethods) {
        for (const Column<Offspring>& column : kOffspringColumns)
            line += std::string(method) + "_" + column.name + ",";
    }
    return ended(std::move(line));
}

std::string run_line(const RunResult& result) {
    std::string line;
    add_cells<RunResult>(line, result, kColumns);
    for (const char* method : kMethods) {
        const auto offspring = result.offspring.find(method);
        add_cells<Offspring>(line,
                             offspring == result.offspring.end() ? Offspring() : offspring->second,
                             kOffspringColumns);
    }
    return ended(std::move(line));
}

std::string curve_header() {
    return "plan,goal,arm,seed,evaluations,best\n";
}

std::string curve_lines(const RunResult& result) {
    const std::string run = result.plan + "," + result.goal + "," + result.arm + "," +
                            std::to_string(result.seed) + ",";
    std::string text;
    for (const CurvePoint& point : result.curve)
        text += run + std::to_string(point.evaluations) + "," + real_text(point.best) + "\n";
    return text;
}

Result<std::vector<RunResult>> read_runs(const std::filesystem::path& path) {
    std::vector<RunResult> runs;
    if (!std::filesystem::exists(path)) return runs;
    const Result<std::string> text = read_file(path, kMaxBytes);
    if (!text) return text.error();
    std::stringstream lines(*text);
    for (std::string line; std::getline(lines, line);) {
        RunResult run;
        if (read_run(line, run)) runs.push_back(std::move(run));
    }
    return runs;
}

}  // namespace cambrian::quality
