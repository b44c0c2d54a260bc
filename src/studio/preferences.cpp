#include "studio/preferences.h"

#include "core/files/file_io.h"
#include "core/text/parsed_number.h"
#include "core/text/pretty_text.h"
#include "persist/experiment/file_dimensions.h"
#include "persist/settings/settings_file.h"
#include "studio/experiment/timeline_plots.h"
#include "studio/files/recent_runs.h"
#include "studio/look/overlays.h"
#include "studio/panels/generations/tile_list.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <sstream>

namespace cambrian {
namespace {

constexpr std::size_t kMostPreferenceBytes = 100'000;

struct Flag {
    const char* name;
    bool& (*of)(ViewState& view);
};
constexpr std::array kFlags = {
    Flag{"follow", [](ViewState& view) -> bool& { return view.follow; }},
    Flag{"experiment-panel", [](ViewState& view) -> bool& { return view.panels.left; }},
    Flag{"inspector-panel", [](ViewState& view) -> bool& { return view.panels.right; }},
    Flag{"bottom-panel", [](ViewState& view) -> bool& { return view.panels.bottom; }},
    Flag{"all-settings", [](ViewState& view) -> bool& { return view.all_settings; }},
    Flag{"rival", [](ViewState& view) -> bool& { return view.rival; }},
    Flag{"tour-taken", [](ViewState& view) -> bool& { return view.tour_taken; }},
};

struct Size {
    const char* name;
    float PanelSizes::*place;
};
constexpr std::array kSizes = {
    Size{"experiment-width", &PanelSizes::left_width},
    Size{"inspector-width", &PanelSizes::right_width},
    Size{"bottom-height", &PanelSizes::bottom_height},
};
constexpr std::array kGhostChoices = {"none", "improvements", "every-tenth", "across"};
constexpr std::array kLooks = {"life", "glass", "mechanics"};
constexpr float kMostSize = 4000.0F;

void read_speed(const std::string& value, ViewState& view) {
    const double speed = parsed_number<double>(value).value_or(0.0);
    if (std::find(kPlaybackSpeeds.begin(), kPlaybackSpeeds.end(), speed) != kPlaybackSpeeds.end())
        view.speed = speed;
}

void read_size(const std::string& name, const std::string& value, PanelSizes& sizes) {
    const float units = parsed_number<float>(value).value_or(-1.0F);
    for (const Size& size : kSizes) {
        if (name == size.name && units >= 0.0F && units <= kMostSize) sizes.*size.place = units;
    }
}

void read_interface_size(const std::string& value, ViewState& view) {
    const int size = parsed_number<int>(value).value_or(0);
    if (std::find(kInterfaceSizes.begin(), kInterfaceSizes.end(), size) != kInterfaceSizes.end())
        view.size = size;
}

void read_look(const std::string& value, ViewState& view) {
    for (std::size_t i = 0; i < kLooks.size(); ++i)
        if (value == kLooks[i]) view.look = static_cast<LookMode>(i);
}

void read_line(const std::string& name, const std::string& value, ViewState& view) {
    for (const Flag& flag : kFlags) {
        if (name == flag.name) flag.of(view) = value == "yes";
    }
    for (const OverlayKind& overlay : overlay_kinds()) {
        if (name == overlay.name) view.overlays.*overlay.shown = value == "yes";
    }
    for (std::size_t i = 0; i < kGhostChoices.size(); ++i) {
        if (name == "ghosts" && value == kGhostChoices[i])
            view.ghosts = static_cast<GhostChoice>(i);
    }
    if (name == "look") read_look(value, view);
    if (name == "scenery") view.scenery = scenery_named(value).value_or(view.scenery);
    if (name == "interface-size") read_interface_size(value, view);
    read_size(name, value, view.panels);
    for (const TimelinePlot& plot : timeline_plots()) {
        if (name == "timeline" && value == plot.id) view.quantity = plot.quantity;
    }
    for (const TileSorting& sorting : tile_sortings()) {
        if (name == "population" && value == sorting.id) view.order = sorting.order;
    }
    if (name == "theme") view.theme = value == "light" ? ThemeKind::kLight : ThemeKind::kDark;
    if (name == "speed") read_speed(value, view);
}

struct ClusterLine {
    const char* name;
    std::string ClusterLogin::*place;
};
constexpr std::array kClusterLines = {
    ClusterLine{"server", &ClusterLogin::servers},
    ClusterLine{"cluster-name", &ClusterLogin::name},
    ClusterLine{"credentials", &ClusterLogin::credentials},
    ClusterLine{"ca", &ClusterLogin::authority},
};

std::filesystem::path settings_in(const std::filesystem::path& folder) {
    return folder / "experiment.toml";
}

// Renames settings that cannot be read. Returns what became of them, in words for the user.
std::string set_aside(const std::filesystem::path& file, const std::string& why) {
    std::error_code error;
    std::filesystem::path aside;
    for (int number = 1; aside.empty() || std::filesystem::exists(aside, error); ++number)
        aside = file.parent_path() / fmt::format("experiment-unreadable-{}.toml", number);
    std::filesystem::rename(file, aside, error);
    return fmt::format(
        "The settings of last time cannot be read, so the defaults are used. They are kept in {}; "
        "mend them there and open that file. {}",
        (error ? file : aside).string(), why);
}

}  // namespace

std::string write_view(const ViewState& view) {
    std::string text;
    ViewState copy = view;
    for (const Flag& flag : kFlags)
        text += fmt::format("{} = {}\n", flag.name, flag.of(copy) ? "yes" : "no");
    for (const OverlayKind& overlay : overlay_kinds())
        text += fmt::format("{} = {}\n", overlay.name, view.overlays.*overlay.shown ? "yes" : "no");
    text += fmt::format("ghosts = {}\n", kGhostChoices[static_cast<std::size_t>(view.ghosts)]);
    for (const Size& size : kSizes)
        text +=
            fmt::format("{} = {:.0f}\n", size.name, static_cast<double>(view.panels.*size.place));
    text += fmt::format("theme = {}\n", view.theme == ThemeKind::kLight ? "light" : "dark");
    text += fmt::format("look = {}\n", kLooks[static_cast<std::size_t>(view.look)]);
    text += fmt::format("scenery = {}\n", kSceneryNames[static_cast<std::size_t>(view.scenery)]);
    text += fmt::format("interface-size = {}\n", view.size);
    text += fmt::format("timeline = {}\n", timeline_plot(view.quantity).id);
    text += fmt::format("population = {}\n", tile_sorting(view.order).id);
    return text + fmt::format("speed = {:g}\n", view.speed);
}

ViewState parse_view(std::string_view text) {
    ViewState view;
    std::istringstream lines{std::string(text)};
    std::string name;
    std::string equals;
    std::string value;
    for (std::string line; std::getline(lines, line);) {
        std::istringstream words(line);
        if (words >> name >> equals >> value && equals == "=") read_line(name, value, view);
    }
    return view;
}

std::string write_cluster(const ClusterMemory& cluster) {
    std::string text = fmt::format("joined = {}\n", cluster.joined ? "yes" : "no");
    for (const ClusterLine& line : kClusterLines)
        text += fmt::format("{} = {}\n", line.name, cluster.login.*line.place);
    return text;
}

ClusterMemory parse_cluster(std::string_view text) {
    ClusterMemory cluster;
    std::istringstream lines{std::string(text)};
    for (std::string line; std::getline(lines, line);) {
        const std::size_t equals = line.find(" = ");
        if (equals == std::string::npos) continue;
        const std::string name = line.substr(0, equals);
        const std::string value = line.substr(equals + 3);
        if (name == "joined") cluster.joined = value == "yes";
        for (const ClusterLine& known : kClusterLines) {
            if (name == known.name) cluster.login.*known.place = value;
        }
    }
    return cluster;
}

Preferences recall(const std::filesystem::path& folder, const EvolutionKinds& kinds) {
    Preferences remembered;
    if (folder.empty()) return remembered;
    if (const auto view = read_file(folder / "view.conf", kMostPreferenceBytes))
        remembered.view = parse_view(*view);
    std::error_code unknown;
    if (std::filesystem::exists(settings_in(folder), unknown)) {
        if (auto settings = load_settings(settings_in(folder), kinds)) {
            remembered.settings = std::move(*settings);
        } else {
            remembered.fault = set_aside(settings_in(folder), settings.error().message);
        }
    }
    if (auto path = read_file(folder / "experiment.path", kMostPreferenceBytes))
        remembered.experiment = std::move(*path);
    if (const auto recent = read_file(folder / "recent.txt", kMostPreferenceBytes)) {
        std::istringstream lines(*recent);
        for (std::string line; std::getline(lines, line);)
            if (!line.empty() && remembered.recent.size() < kMostRecent)
                remembered.recent.emplace_back(line);
    }
    if (const auto cluster = read_file(folder / "cluster.conf", kMostPreferenceBytes))
        remembered.cluster = parse_cluster(*cluster);
    return remembered;
}

int remembered_dimensions(const std::filesystem::path& folder) {
    return folder.empty() ? 2 : dimensions_of_file(settings_in(folder));
}

Status remember(const std::filesystem::path& folder, const Preferences& remembered,
                const EvolutionKinds& kinds) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) return Error{fmt::format("{} cannot be made: {}", folder.string(), error.message())};
    if (Status status = write_file(folder / "view.conf", write_view(remembered.view)); !status)
        return status;
    if (Status status = write_file(folder / "experiment.path", remembered.experiment); !status)
        return status;
    std::string recent;
    for (const std::filesystem::path& path : remembered.recent)
        if (path.string().find('\n') == std::string::npos) recent += path.string() + "\n";
    if (Status status = write_file(folder / "recent.txt", recent); !status) return status;
    if (Status status = write_file(folder / "cluster.conf", write_cluster(remembered.cluster));
        !status)
        return status;
    return save_settings(settings_in(folder), remembered.settings, kinds);
}

std::filesystem::path own_experiment(const std::filesystem::path& folder) {
    return folder / "experiment.cambrian";
}

std::filesystem::path own_museum(const std::filesystem::path& folder) {
    return folder.empty() ? folder : folder / "museum";
}

}  // namespace cambrian
