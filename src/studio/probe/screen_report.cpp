#include "studio/probe/screen_report.h"

#include "studio/probe/text_faults.h"

#include <utility>

namespace cambrian {
namespace {

// Windows find their sizes in their first frames. A fault that a person sees lasts longer.
constexpr int kLasting = 4;    // looks in a row before a fault is reported
constexpr int kLookEvery = 4;  // frames between two looks

bool same(const NotedPlace& a, const NotedPlace& b) {
    return a.seen == b.seen && a.cut == b.cut && a.window == b.window;
}

}  // namespace

void ScreenReport::write(StatusLog& log) {
    write_places(log);
    write_theme(log);
    if (++frames_ % kLookEvery == 0) write_faults(log);
}

void ScreenReport::write_places(StatusLog& log) {
    for (const auto& [name, place] : ui().places) {
        const bool shown = place.frame == ImGui::GetFrameCount() && place.seen.width > 0.0F;
        const auto known = places_.find(name);
        if (!shown && known != places_.end()) {
            log.write("gone", {{"name", name}});
            places_.erase(known);
        }
        if (!shown || (known != places_.end() && same(known->second, place))) continue;
        places_[name] = place;
        log.write("place", {{"name", name},
                            {"panel", std::string(place.window)},
                            {"x", static_cast<double>(place.seen.x)},
                            {"y", static_cast<double>(place.seen.y)},
                            {"width", static_cast<double>(place.seen.width)},
                            {"height", static_cast<double>(place.seen.height)},
                            {"cut", place.cut}});
    }
}

void ScreenReport::write_theme(StatusLog& log) {
    const ThemeKind shown = std::exchange(theme_, ui().theme);
    if (shown != ui().theme || shown == std::exchange(written_, shown)) return;
    log.write("theme", {{"light", shown == ThemeKind::kLight}});
}

void ScreenReport::write_faults(StatusLog& log) {
    std::map<FaultKey, int> lasting;
    for (const TextFault& fault : find_text_faults()) {
        const FaultKey key = {static_cast<int>(fault.kind), fault.window,
                              static_cast<int>(fault.where.x), static_cast<int>(fault.where.y)};
        const auto known = faults_.find(key);
        const int looks = known == faults_.end() ? 1 : known->second + 1;
        lasting[key] = looks;
        if (looks != kLasting) continue;
        log.write("text fault",
                  {{"fault", std::string(fault.kind == TextFaultKind::kCut ? "cut" : "overlap")},
                   {"window", fault.window},
                   {"text", fault.text},
                   {"other", fault.other},
                   {"x", static_cast<double>(fault.where.x)},
                   {"y", static_cast<double>(fault.where.y)}});
    }
    faults_ = std::move(lasting);
}

}  // namespace cambrian
