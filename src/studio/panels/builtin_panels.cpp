#include "studio/panels/builtin_panels.h"

#include "studio/panels/bar/evolve_bar.h"
#include "studio/panels/bar/machines_line.h"
#include "studio/panels/cards/file_panel.h"
#include "studio/panels/cards/file_strip.h"
#include "studio/panels/cards/help_panel.h"
#include "studio/panels/cards/notice_strip.h"
#include "studio/panels/cards/palette_panel.h"
#include "studio/panels/cards/samples_panel.h"
#include "studio/panels/cards/start_panel.h"
#include "studio/panels/cards/suggestions_card.h"
#include "studio/panels/cards/tour_card.h"
#include "studio/panels/comparison/comparison_panel.h"
#include "studio/panels/experiment/experiment_panel.h"
#include "studio/panels/generations/population_panel.h"
#include "studio/panels/generations/timeline_panel.h"
#include "studio/panels/inspector/inspector_panel.h"
#include "studio/panels/machines/machines_panel.h"
#include "studio/panels/opening/founders_panel.h"
#include "studio/panels/opening/founders_strip.h"
#include "studio/panels/picking/picking_grid_panel.h"
#include "studio/panels/picking/picking_panel.h"
#include "studio/panels/picking/picking_strip.h"
#include "studio/panels/picking/picking_tree_panel.h"
#include "studio/panels/picking/shelf_panel.h"
#include "studio/panels/preserve/new_preserve_card.h"
#include "studio/panels/preserve/preserve_panel.h"
#include "studio/panels/preserve/resident_panel.h"
#include "studio/panels/preserve/world_line.h"
#include "studio/panels/preserve/world_panel.h"
#include "studio/panels/preserve/world_plots.h"
#include "studio/panels/preserve/world_strip.h"
#include "studio/panels/viewport/drawing_strip.h"
#include "studio/panels/viewport/transport_bar.h"
#include "studio/panels/viewport/viewport_panel.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>

namespace cambrian {
namespace {

template <class Kind>
std::unique_ptr<Panel> make([[maybe_unused]] Renderer* renderer) {
    if constexpr (std::is_constructible_v<Kind, Renderer*>) {
        return std::make_unique<Kind>(renderer);
    } else {
        return std::make_unique<Kind>();
    }
}

// Returns a rectangle of this size in the middle of the window.
template <int Width, int Height>
Rect centered(const FrameContext&, const CardSpace& space) {
    const Rect& over = space.window;
    const float w = std::min(px(Width), over.width - px(24));
    const float h = std::min(px(Height), over.height - px(24));
    return {std::round(over.center().x - 0.5F * w), std::round(over.center().y - 0.5F * h), w, h};
}

// Returns a rectangle near the top, so that it stays where it is while its content changes.
Rect palette_place(const FrameContext& frame, const CardSpace& space) {
    Rect rect = centered<680, 460>(frame, space);
    rect.y = std::min(rect.y, px(66));
    return rect;
}

// The conditions under which panels are shown.
bool always(const FrameContext&) {
    return true;
}
bool evolving(const FrameContext& frame) {
    return frame.picking == nullptr && frame.preserve == nullptr;
}
bool picking(const FrameContext& frame) {
    return frame.picking != nullptr && frame.preserve == nullptr;
}
bool grid_shown(const FrameContext& frame) {
    return frame.grid_shown() && frame.preserve == nullptr;
}
bool creature_shown(const FrameContext& frame) {
    return !frame.grid_shown() && !frame.world_shown();
}
bool founders_shown(const FrameContext& frame) {
    return frame.founders_shown();
}
bool alone_shown(const FrameContext& frame) {
    return creature_shown(frame) && !founders_shown(frame);
}
bool alone_and_played(const FrameContext& frame) {
    return alone_shown(frame) && !frame.drawing();
}
bool drawn(const FrameContext& frame) {
    return frame.drawing();
}
bool no_preserve(const FrameContext& frame) {
    return frame.preserve == nullptr;
}
bool preserve_open(const FrameContext& frame) {
    return frame.preserve != nullptr;
}
bool world_shown(const FrameContext& frame) {
    return frame.world_shown();
}
bool preserve_card_open(const FrameContext& frame) {
    return frame.preserve_card.open;
}
bool files_open(const FrameContext& frame) {
    return frame.files.browser.open;
}
bool help_open(const FrameContext& frame) {
    return frame.guide.help_shown;
}
bool palette_open(const FrameContext& frame) {
    return frame.window.palette_open;
}
bool samples_open(const FrameContext& frame) {
    return frame.samples_shown();
}
bool start_open(const FrameContext& frame) {
    return frame.start_shown();
}
bool suggestions_open(const FrameContext& frame) {
    return frame.coach.suggestions && evolving(frame);
}
bool machines_told(const FrameContext& frame) {
    return frame.machines_told() && frame.preserve == nullptr;
}
bool machines_open(const FrameContext& frame) {
    return frame.machines != nullptr && frame.machines->card_open;
}
bool comparison_open(const FrameContext& frame) {
    return frame.comparison != nullptr && frame.comparison->card_open;
}
bool file_written(const FrameContext& frame) {
    return !frame.files.writing.name.empty();
}
bool touring(const FrameContext& frame) {
    return frame.tour_shown();
}
bool notice_told(const FrameContext& frame) {
    return frame.window.notice != nullptr;
}

using enum PanelArea;

// clang-format off
const std::array kPanels = {
    PanelKind{"bar",           {kBar, 12, 10},                            always,         make<EvolveBar>},
    PanelKind{"experiment",    {kLeft},                                   no_preserve,    make<ExperimentPanel>},
    PanelKind{"picking grid",  {kCenter, 0, 0},                           grid_shown,     make<PickingGridPanel>},
    PanelKind{"picking strip", {kUnderCenter, 10, 8},                     grid_shown,     make<PickingStrip>},
    PanelKind{"picking",       {kRight},                                  grid_shown,     make<PickingPanel>},
    PanelKind{"founders",      {kCenter, 0, 0},                           founders_shown, make<FoundersPanel>},
    PanelKind{"founders strip", {kUnderCenter, 14, 6},                    founders_shown, make<FoundersStrip>},
    PanelKind{"viewport",      {kCenter, 0, 0},                           alone_shown,    make<ViewportPanel>},
    PanelKind{"transport",     {kUnderCenter, 10, 6},                    alone_and_played,       make<TransportBar>},
    PanelKind{"drawing strip", {kUnderCenter, 10, 2},                     drawn,          make<DrawingStrip>},
    PanelKind{"inspector",     {kRight},                                  creature_shown, make<InspectorPanel>},
    PanelKind{"tree",          {kBottomLeft},                             picking,        make<PickingTreePanel>},
    PanelKind{"shelf place",   {kBottomRight},                            picking,        make<ShelfPanel>},
    PanelKind{"timeline",      {kBottomLeft, -1, -1, Place::kTimeline},   evolving,       make<TimelinePanel>},
    PanelKind{"population",    {kBottomRight, -1, -1, Place::kPopulation}, evolving,      make<PopulationPanel>},
    PanelKind{"preserve",      {kLeft},                                   preserve_open,  make<PreservePanel>},
    PanelKind{"world",         {kCenter, 0, 0},                           world_shown,    make<WorldPanel>},
    PanelKind{"world strip",   {kUnderCenter, 10, 6},                     world_shown,    make<WorldStrip>},
    PanelKind{"resident",      {kRight},                                  world_shown,    make<ResidentPanel>},
    PanelKind{"world plots",   {kBottomLeft},                             preserve_open,  make<WorldPlotsPanel>},
    PanelKind{"energy plot",   {kBottomRight},                            preserve_open,  make<EnergyPlotPanel>},
    PanelKind{"world line",    {kUnderAll, 14, 4},                        preserve_open,  make<WorldLine>},
    PanelKind{"machines line", {kUnderAll, 14, 4},                        machines_told,  make<MachinesLine>},
    PanelKind{"suggestions",   {kCard, 16, 14, {}, 10, suggestions_place}, suggestions_open, make<SuggestionsCard>},
    PanelKind{"files",         {kCard, 20, 18, {}, 10, centered<620, 560>}, files_open,   make<FilePanel>},
    PanelKind{"new preserve",  {kCard, 20, 18, {}, 10, centered<480, 650>}, preserve_card_open, make<NewPreserveCard>},
    PanelKind{"help",          {kCard, 20, 18, {}, 10, centered<860, 640>}, help_open,    make<HelpPanel>},
    PanelKind{"samples",       {kCard, 20, 18, {}, 10, centered<780, 560>}, samples_open, make<SamplesPanel>},
    PanelKind{"start",         {kCard, 20, 18, {}, 10, centered<800, 600>}, start_open,   make<StartPanel>},
    PanelKind{"machines",      {kCard, 20, 18, {}, 10, centered<860, 600>}, machines_open, make<MachinesPanel>},
    PanelKind{"comparison",    {kCard, 20, 18, {}, 10, centered<860, 640>}, comparison_open, make<ComparisonPanel>},
    PanelKind{"tour",          {kCard, 20, 18, {}, 10, tour_place},       touring,        make<TourCard>},
    PanelKind{"palette",       {kCard, 14, 14, {}, 10, palette_place},    palette_open,   make<PalettePanel>},
    PanelKind{"clip",          {kCard, 16, 9, {}, 6, file_strip_place},         file_written,   make<FileStrip>},
    PanelKind{"notice",        {kCard, 18, 10, {}, 4, notice_place},      notice_told,    make<NoticeStrip>},
};
// clang-format on

}  // namespace

std::span<const PanelKind> builtin_panels() {
    return kPanels;
}

}  // namespace cambrian
