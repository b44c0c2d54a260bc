#include "quality/run_table.h"

#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "persist/text/digest_text.h"

#include <charconv>
#include <sstream>

namespace cambrian::quality {
namespace {

constexpr std::size_t kMaxBytes = 64'000'000;
constexpr const char* kMethods[] = {"asexual", "crossover", "grafting", "homologous-crossover"};

// Writes or reads one column.
class Column {
public:
    virtual ~Column() = default;
    virtual void text(const char* name, std::string& value) = 0;
    virtual void whole(const char* name, int& value) = 0;
    virtual void real(const char* name, double& value) = 0;
};

void visit(RunResult& run, Column& column) {
    column.text("plan", run.spec.plan);
    column.text("goal", run.spec.goal);
    column.text("arm", run.spec.arm);
    auto seed = static_cast<int>(run.spec.seed);
    column.whole("seed", seed);
    run.spec.seed = static_cast<std::uint64_t>(seed);
    column.whole("size", run.spec.size);
    column.whole("budget", run.spec.budget);
    column.real("best", run.best);
    column.real("final_best", run.final_best);
    column.whole("evaluations", run.evaluations);
    column.whole("generations", run.generations);
    column.real("cpu_seconds", run.seconds);
    column.real("invalid_share", run.invalid_share);
    column.whole("cells", run.cells);
    column.real("quality", run.quality);
    int decreased = run.decreased ? 1 : 0;
    column.whole("decreased", decreased);
    run.decreased = decreased != 0;
    column.real("champion_finer", run.finer);
    column.real("champion_late_travel", run.late_travel);
    column.real("champion_reversals", run.reversals);
    int clean = run.clean ? 1 : 0;
    column.whole("champion_clean", clean);
    run.clean = clean != 0;
    std::string digest = hex_text(run.digest);
    column.text("digest", digest);
    run.digest = parse_hex(digest).value_or(0);
    for (const char* method : kMethods) {
        Offspring& offspring = run.offspring[method];
        column.whole((std::string(method) + "_children").c_str(), offspring.born);
        column.whole((std::string(method) + "_improved").c_str(), offspring.improved);
    }
}

class Header final : public Column {
public:
    void text(const char* name, std::string& /*value*/) override {
        line += (line.empty() ? "" : ",") + std::string(name);
    }
    void whole(const char* name, int& /*value*/) override { add(name); }
    void real(const char* name, double& /*value*/) override { add(name); }
    std::string line;

private:
    void add(const char* name) { line += "," + std::string(name); }
};

class Writer final : public Column {
public:
    void text(const char* /*name*/, std::string& value) override {
        line += (line.empty() ? "" : ",") + value;
    }
    void whole(const char* /*name*/, int& value) override { line += "," + std::to_string(value); }
    void real(const char* /*name*/, double& value) override { line += "," + real_text(value); }
    std::string line;
};

class Reader final : public Column {
public:
    explicit Reader(const std::string& line) : line_(line) {}
    void text(const char* /*name*/, std::string& value) override {
        if (!std::getline(line_, value, ',')) whole_line_ = false;
    }
    void whole(const char* /*name*/, int& value) override { number(value); }
    void real(const char* /*name*/, double& value) override { number(value); }
    bool whole_line() {
        return whole_line_ && line_.peek() == std::stringstream::traits_type::eof();
    }

private:
    template <class Number>
    void number(Number& value) {
        std::string cell;
        if (!std::getline(line_, cell, ',')) whole_line_ = false;
        const char* const end = cell.data() + cell.size();
        const auto read = std::from_chars(cell.data(), end, value);
        if (read.ec != std::errc{} || read.ptr != end) whole_line_ = false;
    }

    std::stringstream line_;
    bool whole_line_ = true;
};

}  // namespace

std::string run_header() {
    RunResult none;
    Header header;
    visit(none, header);
    return header.line + "\n";
}

std::string run_line(const RunResult& result) {
    RunResult run = result;
    Writer writer;
    visit(run, writer);
    return writer.line + "\n";
}

std::string curve_header() {
    return "plan,goal,arm,seed,evaluations,best\n";
}

std::string curve_lines(const RunResult& result) {
    const RunSpec& spec = result.spec;
    const std::string run =
        spec.plan + "," + spec.goal + "," + spec.arm + "," + std::to_string(spec.seed) + ",";
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
        Reader reader(line);
        visit(run, reader);
        if (reader.whole_line()) runs.push_back(std::move(run));
    }
    return runs;
}

}  // namespace cambrian::quality
