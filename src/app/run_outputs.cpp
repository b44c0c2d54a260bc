#include "app/run_outputs.h"

#include "app/output_path.h"

#include <system_error>

namespace cambrian {
namespace {

constexpr const char* kExperimentEnding = ".cambrian";
constexpr int kMostOfOneName = 10'000;

std::filesystem::path unused_name(const std::filesystem::path& folder, const std::string& name) {
    std::filesystem::path path = folder / (name + kExperimentEnding);
    std::error_code unknown;
    for (int i = 2; std::filesystem::exists(path, unknown) && i < kMostOfOneName; ++i)
        path = folder / (name + "-" + std::to_string(i) + kExperimentEnding);
    return path;
}

}  // namespace

Result<RunOutputs> run_outputs(const std::string& asked, const ExperimentSettings& settings) {
    if (std::filesystem::path(asked).extension() == kExperimentEnding)
        return RunOutputs{.champion = {}, .experiment = asked};
    const std::string name = settings.goal + "-seed" + std::to_string(settings.seed);
    const Result<std::filesystem::path> champion =
        output_path(asked, "champion-" + name + ".creature.json");
    if (!champion) return champion.error();
    const bool one_file = !asked.empty() && champion->string() == asked;
    return RunOutputs{.champion = *champion,
                      .experiment = one_file ? std::filesystem::path()
                                             : unused_name(champion->parent_path(), name)};
}

}  // namespace cambrian
