#include "studio/host/changed_areas.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>

namespace cambrian {
namespace {

bool empty(const Rect& rect) {
    return rect.width <= 0.0F || rect.height <= 0.0F;
}

bool meet(const Rect& a, const Rect& b) {
    return a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height &&
           b.y < a.y + a.height;
}

Rect between(float left, float top, float right, float bottom) {
    return {left, top, std::max(0.0F, right - left), std::max(0.0F, bottom - top)};
}

Rect common(const Rect& a, const Rect& b) {
    return between(std::max(a.x, b.x), std::max(a.y, b.y), std::min(a.high().x, b.high().x),
                   std::min(a.high().y, b.high().y));
}

Rect around(const Rect& a, const Rect& b) {
    if (empty(a)) return b;
    if (empty(b)) return a;
    return between(std::min(a.x, b.x), std::min(a.y, b.y), std::max(a.high().x, b.high().x),
                   std::max(a.high().y, b.high().y));
}

Rect whole_pixels(const Rect& rect) {
    return between(std::floor(rect.x), std::floor(rect.y), std::ceil(rect.high().x),
                   std::ceil(rect.high().y));
}

bool calls_back(const ImDrawCmd& command) {
    return command.UserCallback != nullptr;
}

// Returns the rectangle that encloses the clip rectangles of all commands.
Rect clip_of(const ImDrawList& list) {
    Rect area;
    for (const ImDrawCmd& command : list.CmdBuffer) {
        const ImVec4& clip = command.ClipRect;
        area = around(area, between(clip.x, clip.y, clip.z, clip.w));
    }
    return area;
}

Rect reach_of(const ImVector<ImDrawVert>& vertices) {
    if (vertices.empty()) return {};
    ImVec2 low = vertices.front().pos;
    ImVec2 high = low;
    for (const ImDrawVert& vertex : vertices) {
        low = {std::min(low.x, vertex.pos.x), std::min(low.y, vertex.pos.y)};
        high = {std::max(high.x, vertex.pos.x), std::max(high.y, vertex.pos.y)};
    }
    return between(low.x, low.y, high.x, high.y);
}

template <class Item>
bool same_bytes(const ImVector<Item>& a, const ImVector<Item>& b) {
    return a.Size == b.Size &&
           (a.Size == 0 ||
            std::memcmp(a.Data, b.Data, static_cast<std::size_t>(a.size_in_bytes())) == 0);
}

bool same_command(const ImDrawCmd& a, const ImDrawCmd& b) {
    const ImVec4& clip = a.ClipRect;
    return clip.x == b.ClipRect.x && clip.y == b.ClipRect.y && clip.z == b.ClipRect.z &&
           clip.w == b.ClipRect.w && a.TextureId == b.TextureId && a.VtxOffset == b.VtxOffset &&
           a.IdxOffset == b.IdxOffset && a.ElemCount == b.ElemCount;
}

void unite_overlapping(std::vector<Rect>& areas) {
    std::erase_if(areas, empty);
    std::size_t i = 0;
    while (i < areas.size()) {
        const auto rest = areas.begin() + static_cast<std::ptrdiff_t>(i) + 1;
        const auto met = std::find_if(
            rest, areas.end(), [&area = areas[i]](const Rect& each) { return meet(each, area); });
        if (met == areas.end()) {
            ++i;
            continue;
        }
        areas[i] = around(areas[i], *met);
        areas.erase(met);
        i = 0;  // starts again, since the larger area may overlap one already checked
    }
}

}  // namespace

ChangedAreas::Painted ChangedAreas::painted(const ImDrawList& list, const Rect& window) {
    Painted result;
    result.list = &list;
    result.calls_back = std::any_of(list.CmdBuffer.begin(), list.CmdBuffer.end(), calls_back);
    const Rect clip = common(clip_of(list), window);
    // A callback may paint anywhere in its clip rectangle; its list has no vertices.
    result.area = whole_pixels(result.calls_back ? clip : common(clip, reach_of(list.VtxBuffer)));
    result.vertices = list.VtxBuffer;
    result.indices = list.IdxBuffer;
    result.commands = list.CmdBuffer;
    return result;
}

bool ChangedAreas::same(const Painted& painted, const ImDrawList& list) {
    return !painted.calls_back && same_bytes(painted.vertices, list.VtxBuffer) &&
           same_bytes(painted.indices, list.IdxBuffer) &&
           std::equal(painted.commands.begin(), painted.commands.end(), list.CmdBuffer.begin(),
                      list.CmdBuffer.end(), same_command);
}

std::vector<Rect> ChangedAreas::changed_lists(const ImDrawData& data) {
    std::vector<Rect> areas;
    std::vector<Painted> next;
    auto from = painted_.begin();  // lists before this one are already matched or were removed
    for (int i = 0; i < data.CmdListsCount; ++i) {
        const ImDrawList& list = *data.CmdLists[i];
        const auto is_it = [&list](const Painted& each) { return each.list == &list; };
        const auto found = std::find_if(from, painted_.end(), is_it);
        if (found == painted_.end()) {
            next.push_back(painted(list, window_));
            areas.push_back(next.back().area);
            continue;
        }
        for (; from != found; ++from)
            areas.push_back(from->area);
        ++from;
        if (same(*found, list)) {
            next.push_back(std::move(*found));
            continue;
        }
        next.push_back(painted(list, window_));
        areas.push_back(found->area);
        areas.push_back(next.back().area);
    }
    for (; from != painted_.end(); ++from)
        areas.push_back(from->area);
    painted_ = std::move(next);
    return areas;
}

std::vector<Rect> ChangedAreas::update(const ImDrawData& data, ImU32 background) {
    const Rect window = {data.DisplayPos.x, data.DisplayPos.y, data.DisplaySize.x,
                         data.DisplaySize.y};
    const bool all = !(window == window_) || background != background_;
    window_ = window;
    background_ = background;
    std::vector<Rect> areas = changed_lists(data);
    if (all) return {window};
    unite_overlapping(areas);
    return areas;
}

}  // namespace cambrian
