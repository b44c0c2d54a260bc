#pragma once

// All panels in their places.

#include "studio/layout.h"
#include "studio/panels/bar/evolve_bar.h"
#include "studio/panels/cards/file_panel.h"
#include "studio/panels/cards/help_panel.h"
#include "studio/panels/cards/notice_strip.h"
#include "studio/panels/cards/samples_panel.h"
#include "studio/panels/cards/tour_card.h"
#include "studio/panels/experiment/experiment_panel.h"
#include "studio/panels/generations/population_panel.h"
#include "studio/panels/generations/timeline_panel.h"
#include "studio/panels/inspector/inspector_panel.h"
#include "studio/panels/picking/picking_grid_panel.h"
#include "studio/panels/picking/picking_panel.h"
#include "studio/panels/picking/picking_strip.h"
#include "studio/panels/picking/picking_tree_panel.h"
#include "studio/panels/picking/shelf_panel.h"
#include "studio/panels/viewport/transport_bar.h"
#include "studio/panels/viewport/viewport_panel.h"

namespace cambrian {

class MainWindow {
public:
    explicit MainWindow(Renderer* renderer) : viewport_(renderer), grid_(renderer) {}

    // Between the host's begin_frame and end_frame.
    void draw(const FrameContext& frame, int framebuffer_height, Requests& out);
    void fit() { viewport_.fit(); }

private:
    void draw_studio(const FrameContext& frame, const Layout& layout, Requests& out);
    void draw_tour(const FrameContext& frame, const Rect& whole, Requests& out);
    void draw_stage(const FrameContext& frame, const Layout& layout, Requests& out);
    void draw_grid(const FrameContext& frame, const Layout& layout, Requests& out);
    void draw_overlays(const FrameContext& frame, const Layout& layout, Requests& out);

    EvolveBar bar_;
    ExperimentPanel experiment_;
    ViewportPanel viewport_;
    TransportBar transport_;
    InspectorPanel inspector_;
    TimelinePanel timeline_;
    PopulationPanel population_;
    PickingGridPanel grid_;
    PickingStrip strip_;
    PickingPanel picking_;
    PickingTreePanel tree_;
    ShelfPanel shelf_;
    FilePanel files_;
    HelpPanel help_;
    SamplesPanel samples_;
    TourCard tour_;
    NoticeStrip notice_;
};

}  // namespace cambrian
