#include "persist/settings/ground_import.h"

#include "core/text/number_text.h"
#include "core/text/parsed_number.h"
#include "persist/json/json_value.h"
#include "persist/text/quoted_text.h"
#include "world/terrain.h"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <vector>

namespace cambrian {
namespace {

constexpr double kFixedVoxel = 5.0;  // EvoGym's number of the kind
constexpr double kMostVoxelKind = 5.0;
constexpr double kStartColumn = 3.0;
constexpr double kPitDepth = 2.0;       // m
constexpr double kMostColumns = 900.0;  // each has two points

struct VoxelGrid {
    std::size_t width = 0, height = 0;
    std::set<std::size_t> fixed;  // y * width + x, with y upwards

    bool has(std::size_t x, std::size_t y) const { return fixed.count(y * width + x) > 0; }
};

std::optional<std::size_t> whole_size(const JsonValue& object, const char* key, double most) {
    const JsonValue* found = object.find(key);
    if (found == nullptr || found->kind != JsonValue::Kind::kInteger || found->number < 1.0 ||
        found->number > most)
        return std::nullopt;
    return static_cast<std::size_t>(found->number);
}

const JsonValue* voxel_list(const JsonValue& object, const char* key) {
    const JsonValue* found = object.find(key);
    return found != nullptr && found->kind == JsonValue::Kind::kList ? found : nullptr;
}

Status add_voxels(const std::string& name, const JsonValue& object, LooseVoxels loose,
                  VoxelGrid& grid) {
    const std::string quoted = quoted_text(name);
    const JsonValue* indices = voxel_list(object, "indices");
    const JsonValue* types = voxel_list(object, "types");
    if (indices == nullptr || types == nullptr || indices->values.size() != types->values.size())
        return Error{
            fmt::format("the object {} has no lists \"indices\" and \"types\" of one "
                        "length",
                        quoted)};
    for (std::size_t i = 0; i < indices->values.size(); ++i) {
        const double index = indices->values[i].number;
        const double type = types->values[i].number;
        const double most = static_cast<double>(grid.width * grid.height) - 1.0;
        if (indices->values[i].kind != JsonValue::Kind::kInteger || index < 0.0 || index > most)
            return Error{fmt::format("the object {} has a voxel {} outside the grid", quoted,
                                     short_text(index))};
        if (types->values[i].kind != JsonValue::Kind::kInteger || type < 1.0 ||
            type > kMostVoxelKind)
            return Error{fmt::format("the object {} has a voxel of the unknown type {}", quoted,
                                     short_text(type))};
        if (type != kFixedVoxel) {
            if (loose == LooseVoxels::kDropped) continue;
            return Error{
                fmt::format("the object {} moves or is soft, which ground is not; "
                            "--ignore-loose leaves such voxels out",
                            quoted)};
        }
        if (!grid.fixed.insert(static_cast<std::size_t>(index)).second)
            return Error{fmt::format("the object {} has a voxel where another one is", quoted)};
    }
    return {};
}

// Returns the height of a column in voxels; 0 if it is empty.
Result<std::size_t> column_top(const VoxelGrid& grid, std::size_t x, LooseVoxels loose) {
    std::size_t top = 0;
    bool in_air = false;
    for (std::size_t y = 0; y < grid.height; ++y) {
        const bool is_fixed = grid.has(x, y);
        if (is_fixed && in_air && loose == LooseVoxels::kRefused)
            return Error{
                fmt::format("column {} has fixed voxels above air, which ground has not; "
                            "--ignore-loose leaves them out",
                            x + 1)};
        if (is_fixed && !in_air) top = y + 1;
        in_air = in_air || (top > 0 && !is_fixed);
    }
    return top;
}

Result<std::string> checked_ground(std::string points) {
    if (Status sound = check_ground_points(points); !sound) return sound.error();
    return points;
}

Result<std::string> ground_line_of(const VoxelGrid& grid, double voxel, LooseVoxels loose) {
    std::vector<double> heights;
    for (std::size_t x = 0; x < grid.width; ++x) {
        const Result<std::size_t> top = column_top(grid, x, loose);
        if (!top) return top.error();
        heights.push_back(voxel * static_cast<double>(*top));
    }
    const auto start = std::min(static_cast<std::size_t>(kStartColumn), grid.width) - 1;
    const double level = heights[start];
    std::string points;
    double before = std::nan("");
    for (std::size_t x = 0; x < grid.width; ++x) {
        const double height = heights[x] > 0.0 ? heights[x] - level : -level - kPitDepth;
        const double left = voxel * (static_cast<double>(x) - kStartColumn + 0.5);
        if (height != before)
            points += fmt::format("{} {}; ", short_text(left), short_text(height));
        if (x + 1 == grid.width || heights[x + 1] != heights[x])
            points += fmt::format("{} {}; ", short_text(left + voxel), short_text(height));
        before = height;
    }
    points.resize(points.size() - 2);
    return checked_ground(std::move(points));
}

}  // namespace

Result<std::string> ground_of_voxels(std::string_view json, double voxel, LooseVoxels loose) {
    ErrorList errors;
    const auto document = parse_json(json, {}, errors);
    if (!document) return errors.as_error("the world");
    VoxelGrid grid;
    const auto width = whole_size(*document, "grid_width", kMostColumns);
    const auto height = whole_size(*document, "grid_height", kMostColumns);
    if (!width || !height)
        return Error{fmt::format("grid_width and grid_height: expected whole numbers from 1 to {}",
                                 short_text(kMostColumns))};
    grid.width = *width;
    grid.height = *height;
    const JsonValue* objects = document->find("objects");
    if (objects == nullptr || objects->kind != JsonValue::Kind::kObject)
        return Error{"the world has no \"objects\""};
    for (std::size_t i = 0; i < objects->values.size(); ++i) {
        if (Status added = add_voxels(objects->keys[i], objects->values[i], loose, grid); !added)
            return added.error();
    }
    if (grid.fixed.empty()) return Error{"the world has no fixed voxels"};
    return ground_line_of(grid, voxel, loose);
}

Result<std::string> ground_of_table(std::string_view csv) {
    std::string points;
    for (std::size_t line = 1; !csv.empty(); ++line) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        std::string_view row = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        if (row.ends_with('\r')) row.remove_suffix(1);
        if (row.empty()) continue;
        const std::size_t comma = std::min(row.find(','), row.size());
        const auto x = parsed_number<double>(row.substr(0, comma));
        const auto y = parsed_number<double>(row.substr(std::min(comma + 1, row.size())));
        if (!x || !y)
            return Error{fmt::format("line {} is not two numbers with a comma between them", line)};
        if (!points.empty()) points += "; ";
        points += fmt::format("{} {}", short_text(*x), short_text(*y));
    }
    return checked_ground(std::move(points));
}

}  // namespace cambrian
