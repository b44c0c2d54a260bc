// Rows by longest path, order inside a row by the mean position of predecessors (the barycentre
// heuristic of Sugiyama, Tagawa and Toda 1981), one sweep down.

#include "studio/widgets/graph_layout.h"

#include <algorithm>

namespace cambrian {
namespace {

using Rank = std::vector<std::size_t>;

std::vector<Rank> gather_rows(const std::vector<std::size_t>& rows) {
    std::vector<Rank> gathered;
    for (std::size_t node = 0; node < rows.size(); ++node) {
        if (gathered.size() <= rows[node]) gathered.resize(rows[node] + 1);
        gathered[rows[node]].push_back(node);
    }
    std::erase_if(gathered, [](const Rank& row) { return row.empty(); });
    return gathered;
}

// Returns the mean x of the placed predecessors of a node; without one, its own x.
float pull_of(std::size_t node, const std::vector<GraphEdge>& edges,
              const std::vector<GraphPoint>& points, const std::vector<bool>& placed) {
    float sum = 0.0F;
    float count = 0.0F;
    for (const GraphEdge& edge : edges) {
        if (edge.to != node || !placed[edge.from]) continue;
        sum += points[edge.from].x;
        count += 1.0F;
    }
    return count > 0.0F ? sum / count : 0.5F;
}

std::vector<Rank> broken_rows(const std::vector<Rank>& rows, std::size_t most) {
    std::vector<Rank> broken;
    for (const Rank& row : rows) {
        const std::size_t pieces = (row.size() + most - 1) / most;
        for (std::size_t piece = 0; piece < pieces; ++piece) {
            broken.emplace_back();
            for (std::size_t i = piece; i < row.size(); i += pieces)
                broken.back().push_back(row[i]);
        }
    }
    return broken;
}

}  // namespace

std::vector<std::size_t> graph_rows(std::size_t node_count, const std::vector<GraphEdge>& edges) {
    std::vector<std::vector<std::size_t>> sources(node_count);
    for (const GraphEdge& edge : edges) {
        if (edge.from < edge.to) sources[edge.to].push_back(edge.from);
    }
    std::vector<std::size_t> rows(node_count, 0);
    for (std::size_t node = 0; node < node_count; ++node) {
        for (const std::size_t source : sources[node])
            rows[node] = std::max(rows[node], rows[source] + 1);
    }
    return rows;
}

std::vector<GraphPoint> place_in_rows(const std::vector<std::size_t>& rows,
                                      const std::vector<GraphEdge>& edges, std::size_t most) {
    std::vector<GraphPoint> points(rows.size());
    std::vector<bool> placed(rows.size(), false);
    const std::vector<Rank> lines = broken_rows(gather_rows(rows), std::max<std::size_t>(most, 1));
    const auto line_count = static_cast<float>(lines.size());
    for (std::size_t line = 0; line < lines.size(); ++line) {
        Rank row = lines[line];
        std::vector<float> pulls(rows.size(), 0.0F);
        for (const std::size_t node : row)
            pulls[node] = pull_of(node, edges, points, placed);
        std::stable_sort(row.begin(), row.end(),
                         [&pulls](std::size_t a, std::size_t b) { return pulls[a] < pulls[b]; });
        for (std::size_t i = 0; i < row.size(); ++i) {
            points[row[i]] = {(static_cast<float>(i) + 0.5F) / static_cast<float>(row.size()),
                              (static_cast<float>(line) + 0.5F) / line_count};
            placed[row[i]] = true;
        }
    }
    return points;
}

}  // namespace cambrian
