#include "studio/panels/viewport/viewport_panel.h"

#include "pictures/scene/bout_scene.h"
#include "pictures/scene/field_overlays.h"
#include "pictures/scene/follow_camera.h"
#include "pictures/scene/hunter.h"
#include "pictures/scene/living_look.h"
#include "pictures/scene/scenery.h"
#include "pictures/scene/shaped_ground.h"
#include "pictures/scene/small_life.h"
#include "pictures/scene/stone_wall.h"
#include "studio/look/overlays.h"
#include "studio/panels/viewport/axes_gizmo.h"
#include "studio/panels/viewport/scene_overlays.h"
#include "studio/panels/viewport/viewport_labels.h"
#include "studio/panels/viewport/viewport_tools.h"
#include "studio/widgets/widgets.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cambrian {
namespace {

constexpr double kFollowLag = 0.25;         // s; time constant with which the camera follows
constexpr double kFollowMargin = 0.06;      // share of the viewport kept free around the body
constexpr double kFitShare = 0.40;          // share of the viewport filled by a body after FitView
constexpr double kFitShareOfCompany = 0.8;  // the same, by both creatures and the cube, or a hunter
constexpr double kHunterRoom = 0.3;         // m, half the width of a hunter
constexpr float kActionsTop = 64.0F;        // of the buttons below the words, from the top
constexpr double kFarthestLight = 1000.0;   // m; limit of the setting

BoutLook bout_look(const Playback& playback) {
    const ShownBout& shown = playback.creature().bout();
    const TrialWorld& world = playback.trial().world();
    return {shown.cube().poses().front(),
            playback.trial().bout()->opponent_body().get(),
            shown.opponent().poses(),
            shown.opponent().stretches(),
            world.opponents.hue_of_trial(world.light.trial),
            playback.exhibit().genome()->hue};
}

Character shown_character(const FrameContext& frame) {
    const Playback& playback = frame.viewer.playback;
    const PlayedCreature& creature = playback.creature();
    const Individual& individual = playback.exhibit().individual();
    Character character;
    character.line = line_or_hue(individual.line, individual.genome->hue);
    character.walks = creature.replay().environment().has_ground;
    character.posture = creature.readings().posture();
    if (frame.viewer.score != nullptr && !frame.viewer.score->record.samples.empty()) {
        const std::vector<MotionSample>& samples = frame.viewer.score->record.samples;
        character.way =
            way_of((samples.back().center_of_mass - samples.front().center_of_mass).head<2>(),
                   character.walks);
    }
    character.time = playback.trial().time();
    const Vec2 here = creature.motion().center().head<2>();
    follow_path(character, creature.readings().trail(), here, body_size(creature.phenotype()));
    const LightSource& light = playback.trial().surroundings().source();
    if (light.is_on()) look_at(character, here, light.place().head<2>());
    if (const FixedBox* wall = playback.trial().wall())
        look_at(character, here, wall->center.head<2>());
    return character;
}

// The camera stays while ground is drawn.
bool follows(const FrameContext& frame) {
    return frame.view.follow && !frame.viewer.ground_pen;
}

// Returns the window with the displayed creature and, in a contest, with the cube and the opponent.
WorldWindow shown_bounds(const Playback& playback) {
    const PlayedCreature& creature = playback.creature();
    const WorldWindow body = body_window(creature.phenotype(), creature.motion().poses());
    return playback.trial().bout() == nullptr ? body : with_bout(body, bout_look(playback));
}

bool is_hunted(const Playback& playback) {
    const Environment& environment = playback.creature().replay().environment();
    return environment.has_light && environment.light_motion == "hunting";
}

bool has_company(const Playback& playback) {
    return playback.trial().bout() != nullptr || is_hunted(playback);
}

// Returns the same with room for a hunter on either side.
WorldWindow fitted_bounds(const Playback& playback) {
    WorldWindow bounds = shown_bounds(playback);
    if (!is_hunted(playback)) return bounds;
    const PlayedCreature& creature = playback.creature();
    const double reach =
        creature.replay().environment().light_farthest * creature.phenotype().rest_length() +
        kHunterRoom;
    const double middle = creature.motion().center().x();
    bounds.low.x() = std::min(bounds.low.x(), middle - reach);
    bounds.high.x() = std::max(bounds.high.x(), middle + reach);
    return bounds;
}

}  // namespace

void ViewportPanel::draw(const FrameContext& frame, Requests& out) {
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 room = ImGui::GetContentRegionAvail();
    canvas_.area = {at.x, at.y, room.x, room.y};
    canvas_.framebuffer_height = frame.window.framebuffer_height;
    if (std::exchange(fits_seen_, frame.viewer.fits_asked) != frame.viewer.fits_asked)
        fit_wanted_ = true;
    ImGui::InvisibleButton("viewport", {std::max(1.0F, room.x), std::max(1.0F, room.y)},
                           ImGuiButtonFlags_MouseButtonLeft | ImGuiButtonFlags_MouseButtonRight |
                               ImGuiButtonFlags_MouseButtonMiddle);
    note_place("viewport");
    ImGui::SetItemAllowOverlap();
    canvas_.frame.clear();
    canvas_.frame.detail = detail_of(frame.window.scenery);
    canvas_.frame.background = colors().sky;
    if (!frame.viewer.playback.empty()) {
        if (frame.drawing()) {
            draw_paper(frame, out);
        } else if (frame.in_space()) {
            draw_space(frame, out);
        } else {
            handle_mouse(frame, out);
            place_camera(frame);
            build_scene(frame);
        }
    }
    canvas_.add_to(*ImGui::GetWindowDrawList());
    if (frame.drawing()) {
        paper_.draw_words(canvas_, out);
    } else if (!frame.viewer.playback.empty()) {
        draw_viewport_labels(frame, canvas_, space_);
    }
    if (frame.viewer.ground_pen && frame.may_draw_ground()) GroundPen::draw_hint(canvas_);
    if (frame.window.presenting) {
        ImGui::SetMouseCursor(ImGuiMouseCursor_None);
        if (ImGui::IsMouseClicked(ImGuiMouseButton_Left)) out.ask(TogglePresentation{});
        return;
    }
    draw_viewport_tools(frame, canvas_.area, out);
    if (frame.in_space() && !frame.viewer.playback.empty())
        draw_axes_gizmo(space_.camera(), {at.x + room.x - px(0.5F * kGizmoSide + 10),
                                          at.y + px(50 + 0.5F * kGizmoSide)});
    if (has_actions(frame) && !frame.drawing())
        draw_shown_actions(frame, {at.x + px(14), at.y + px(kActionsTop)}, out);
}

void ViewportPanel::draw_space(const FrameContext& frame, Requests& out) {
    const Phenotype* shown = &frame.viewer.playback.creature().phenotype();
    space_.handle_mouse(frame, canvas_, out);
    space_.place_camera(frame, canvas_, std::exchange(seen_, shown) != shown,
                        std::exchange(fit_wanted_, false));
    space_.build_scene(frame, canvas_);
}

void ViewportPanel::draw_paper(const FrameContext& frame, Requests& out) {
    paper_.handle_mouse(frame, canvas_, out);
    paper_.place_camera(canvas_, std::exchange(fit_wanted_, false));
    paper_.build_scene(frame, canvas_);
}

Vec2 ViewportPanel::follow_target(const FrameContext& frame) const {
    const Playback& playback = frame.viewer.playback;
    Vec2 center = playback.creature().motion().center().head<2>();
    if (playback.trial().bout() != nullptr) {
        const WorldWindow bounds = shown_bounds(playback);
        center.x() = 0.5 * (bounds.low.x() + bounds.high.x());
    }
    return follow_center(center, playback.creature().replay().environment(), canvas_.camera,
                         canvas_.size());
}

void ViewportPanel::fit_now(const FrameContext& frame) {
    fit_wanted_ = false;
    const Playback& playback = frame.viewer.playback;
    const double share = has_company(playback) ? kFitShareOfCompany : kFitShare;
    canvas_.camera.fit(fitted_bounds(playback), share, canvas_.size());
    canvas_.camera.center = follow_target(frame);
}

void ViewportPanel::place_camera(const FrameContext& frame) {
    const bool changed = seen_ != &frame.viewer.playback.creature().phenotype();
    seen_ = &frame.viewer.playback.creature().phenotype();
    if (changed && !fit_wanted_) {
        // A new creature keeps the scale, so that sizes can be compared, unless it would not be
        // visible.
        const WorldWindow bounds = shown_bounds(frame.viewer.playback);
        const Vec2 pixels = (bounds.high - bounds.low) * canvas_.camera.pixels_per_metre;
        const double share =
            std::max(pixels.x() / canvas_.size().width, pixels.y() / canvas_.size().height);
        fit_wanted_ = has_company(frame.viewer.playback) || share > 0.7 || share < 0.12;
        if (follows(frame)) canvas_.camera.center = follow_target(frame);
    }
    if (fit_wanted_) {
        fit_now(frame);
    } else if (follows(frame)) {
        const double elapsed = static_cast<double>(ImGui::GetIO().DeltaTime);
        canvas_.camera.approach(follow_target(frame), elapsed, kFollowLag);
        // The lag is a matter of seconds, and a fast playback goes far in that time.
        canvas_.camera.keep_in_view(shown_bounds(frame.viewer.playback), kFollowMargin,
                                    canvas_.size());
    }
}

void ViewportPanel::handle_mouse(const FrameContext& frame, Requests& out) {
    const ImGuiIO& io = ImGui::GetIO();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered && io.MouseWheel != 0.0F) {
        canvas_.zoom_by_wheel(follows(frame));
        if (follows(frame)) canvas_.camera.center = follow_target(frame);
    }
    const bool dragged = ImGui::IsItemActive() && (ImGui::IsMouseDragging(ImGuiMouseButton_Right) ||
                                                   ImGui::IsMouseDragging(ImGuiMouseButton_Middle));
    if (dragged) {
        canvas_.camera.pan(
            {static_cast<double>(io.MouseDelta.x), static_cast<double>(io.MouseDelta.y)});
        if (follows(frame) && !panning_) {
            ViewState view = frame.view;
            view.follow = false;
            out.ask(ChangeView{view});
        }
    }
    panning_ = dragged;
    if (pen_.handle_mouse(frame, canvas_, out)) return;
    if (!handle_light(frame, out)) handle_poke(frame, out);
    const int under = hovered ? part_at(frame.viewer.playback.creature().phenotype(),
                                        frame.viewer.playback.creature().motion().poses(),
                                        canvas_.mouse_in_world(),
                                        frame.viewer.playback.creature().motion().stretches())
                              : -1;
    if (under >= 0) out.ask(ShowHighlight{{.part = under}});
}

// The left button drags the light, which edits the environment. Returns whether it holds the light.
bool ViewportPanel::handle_light(const FrameContext& frame, Requests& out) {
    const ExperimentSettings& draft = frame.experiment.editor.draft();
    const LightSource& light = frame.viewer.playback.trial().surroundings().source();
    const Vec2 mouse = canvas_.mouse_in_world();
    if (light_held_ && !ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
        light_held_ = false;
        out.ask(FinishEdit{});
        return true;
    }
    if (!light_held_) {
        const double away = (light.place().head<2>() - mouse).norm();
        light_held_ = ImGui::IsItemActive() && ImGui::IsMouseClicked(ImGuiMouseButton_Left) &&
                      light.is_on() && draft.world.environment.has_light &&
                      away <= kLightPixels * canvas_.camera.pixel();
        return light_held_;
    }
    if (!ImGui::IsMouseDragging(ImGuiMouseButton_Left)) return true;
    ExperimentSettings edited = draft;
    Environment& world = edited.world.environment;
    world.light_x = std::clamp(mouse.x(), -kFarthestLight, kFarthestLight);
    world.light_y = std::clamp(mouse.y(), -kFarthestLight, kFarthestLight);
    out.ask(EditSettings{std::move(edited), "environment.light-x"});
    return true;
}

// The left button grabs the part under the mouse and pulls it while held.
void ViewportPanel::handle_poke(const FrameContext& frame, Requests& out) {
    const Vec2 mouse = canvas_.mouse_in_world();
    const Vec3 target(mouse.x(), mouse.y(), 0.0);
    if (const Hold* hold = frame.viewer.playback.creature().hold()) {
        if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
            out.ask(PokePart{hold->part, hold->point_in_part, target});
        } else {
            out.ask(ReleasePoke{});
        }
        return;
    }
    if (!ImGui::IsItemActive() || !ImGui::IsMouseClicked(ImGuiMouseButton_Left)) return;
    const int part = part_at(frame.viewer.playback.creature().phenotype(),
                             frame.viewer.playback.creature().motion().poses(), mouse,
                             frame.viewer.playback.creature().motion().stretches());
    if (part < 0) return;
    const Pose& pose =
        frame.viewer.playback.creature().motion().poses()[static_cast<std::size_t>(part)];
    const Vec3 inside = pose.orientation.conjugate() * (target - pose.position);
    out.ask(PokePart{static_cast<std::size_t>(part), inside, target});
}

// Adds the ghosts beside the creature and the bodies it contends with.
void ViewportPanel::add_company(const FrameContext& frame, const CreatureLook& look) {
    const Playback& playback = frame.viewer.playback;
    SceneFrame& scene = canvas_.frame;
    for (const auto& ghost : frame.viewer.ghosts) {
        CreatureLook pale{ghost->phenotype(), ghost->poses(), {}, ghost->genome().hue, {},
                          ghost->stretches(), frame.view.look};
        pale.character.line = line_or_hue(ghost->line(), ghost->genome().hue);
        pale.character.walks = look.character.walks;
        add_pale_being(scene, canvas_.camera, pale);
    }
    if (playback.trial().bout() != nullptr) {
        BoutLook bout = bout_look(playback);
        bout.mode = look.mode;
        bout.time = look.character.time;
        add_bout(scene, colors(), canvas_.camera, bout);
    }
}

// Draws a light: a hunter while it is in view, else a lamp, at the edge if it is out of view.
void ViewportPanel::add_shown_light(const FrameContext& frame, const Vec2& place) {
    const PlayedCreature& creature = frame.viewer.playback.creature();
    const WorldWindow view = canvas_.camera.window(canvas_.size());
    const bool seen =
        (place.array() >= view.low.array()).all() && (place.array() <= view.high.array()).all();
    if (seen && creature.replay().environment().light_motion == "hunting")
        return add_hunter(canvas_.frame, place, creature.motion().center().head<2>(),
                          frame.viewer.playback.trial().time());
    add_light(canvas_.frame, canvas_.camera, canvas_.size(), place);
}

void ViewportPanel::build_scene(const FrameContext& frame) {
    const Playback& playback = frame.viewer.playback;
    const Palette& palette = colors();
    SceneFrame& scene = canvas_.frame;
    std::vector<FaceSet> touched;
    if (frame.view.overlays.contacts) touched = touched_faces(playback.trial().scene());
    const CreatureLook look{playback.creature().phenotype(),
                            playback.creature().motion().poses(),
                            touched,
                            playback.exhibit().genome()->hue,
                            frame.viewer.highlight,
                            playback.creature().motion().stretches(),
                            shown_look(frame),
                            shown_character(frame)};
    const DrawnWorld* world =
        shown_world(frame.view, frame.window.scenery, playback.creature().replay().environment());
    const double time = look.character.time;
    use_ground(scene, playback.creature().replay().environment(), canvas_.camera, canvas_.size());
    if (world != nullptr) {
        add_scenery(scene, *world, canvas_.camera, canvas_.size(), time);
        if (frame.view.overlays.ruler)
            add_ground_marks(scene, *world, canvas_.camera, canvas_.size(),
                             mark_spacing(canvas_.camera, kTickPixels));
    } else if (frame.view.overlays.grid) {
        add_grid(scene, palette, canvas_.camera, canvas_.size());
    }
    const TrialSurroundings& surroundings = playback.trial().surroundings();
    const ScentField* scent = surroundings.scent_field();
    if (frame.view.overlays.scent && scent != nullptr)
        add_scent(scene, canvas_.camera, canvas_.size(), *scent);
    if (playback.creature().replay().environment().has_ground) {
        if (world == nullptr) add_ground(scene, palette, canvas_.camera, canvas_.size());
        add_shadow(scene, look);
    }
    if (frame.view.overlays.trail) {
        scene.add_trail(playback.creature().readings().trail(), 2.2 * canvas_.camera.pixel(),
                        with_alpha(palette.accent, 0.8F));
    }
    if (look.mode != LookMode::kMechanics)
        add_small_life(scene, playback.creature().readings().scuffs(), look.character.time,
                       playback.creature().replay().environment());
    if (const FixedBox* wall = playback.trial().wall()) add_stone_wall(scene, *wall);
    add_company(frame, look);
    const LightSource& light = surroundings.source();
    if (light.is_on()) {
        const Vec2 place = light.place().head<2>();
        if (world != nullptr)
            add_lamp(scene, canvas_.camera, canvas_.size(), place,
                     playback.creature().replay().environment().light_reach);
        add_shown_light(frame, place);
    }
    add_being(scene, palette, canvas_.camera, look);
    if (world != nullptr) add_foreground(scene, *world, canvas_.camera, canvas_.size(), time);
    if (frame.view.overlays.sounds) add_sounds(scene, canvas_.camera, surroundings.sounds());
    add_overlays(frame, look);
    pen_.add_stroke(canvas_);
    const Hold* hold = playback.creature().hold();
    const auto& poses = playback.creature().motion().poses();
    if (hold == nullptr || hold->part >= poses.size()) return;
    const Vec3 from = transform(poses[hold->part], hold->point_in_part);
    scene.add_line(from.head<2>(), hold->target.head<2>(), 2.0 * canvas_.camera.pixel(),
                   palette.danger);
}

void ViewportPanel::add_overlays(const FrameContext& frame, const CreatureLook& look) {
    const ViewState& view = frame.view;
    const Trial& trial = frame.viewer.playback.trial();
    const OverlayScene over{look,
                            trial.scene(),
                            trial.creature(),
                            trial.surroundings(),
                            frame.kinds.creature,
                            colors(),
                            canvas_.camera.pixel()};
    if (view.overlays.limits) add_joint_limits(canvas_.frame, over);
    if (view.overlays.torques) add_joint_torques(canvas_.frame, over);
    if (view.overlays.sensors) add_sensor_readings(canvas_.frame, over);
    if (view.overlays.forces) add_contact_forces(canvas_.frame, over);
    if (view.overlays.center_of_mass)
        add_center_of_mass(canvas_.frame, over,
                           frame.viewer.playback.creature().motion().center().head<2>());
}

}  // namespace cambrian
