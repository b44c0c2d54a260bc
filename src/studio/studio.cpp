#include "studio/studio.h"

#include "core/stopwatch.h"
#include "core/threads/thread_pool.h"
#include "persist/experiment/file_dimensions.h"
#include "pictures/card_picture.h"
#include "render/renderer.h"
#include "studio/actions/action.h"
#include "studio/files/typed_path.h"
#include "studio/host/frame_log.h"
#include "studio/host/frame_pace.h"
#include "studio/host/imgui_host.h"
#include "studio/host/picture_clipboard.h"
#include "studio/main_window.h"
#include "studio/panels/builtin_panels.h"
#include "studio/panels/generations/timeline_chart.h"
#include "studio/probe/screen_report.h"
#include "studio/studio_controller.h"
#include "studio/view_recorder.h"
#include "studio/widgets/keyboard_focus.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace cambrian {
namespace {

constexpr double kIdleSleep = 0.25;  // s between frames while nothing moves
// Frames drawn after the last activity, for hover effects and layout.
constexpr int kSettledFrames = 3;
constexpr float kPresentationScale = 2.4F;

struct StudioKinds {
    const EvolutionKinds& here;
    const EvolutionKinds& elsewhere;
};

// A world of two or three dimensions, and its settings as they were when the user was there last.
struct VisitedWorld {
    StudioKinds kinds;
    ExperimentSettings settings;
};

// What the user comes to a world for.
struct Visit {
    StudioOptions options;
    bool begins = false;  // to begin a run there
};

// Changes the state from that in one world to that in another one.
void enter(VisitedWorld& from, const VisitedWorld& to, Preferences& state) {
    from.settings = std::exchange(state.settings, to.settings);
    state.experiment.clear();
}

// Machines of a cluster know the plane only.
ClusterJoining joining_in_space(const StudioOptions& options) {
    if (!options.machines.join) return nullptr;
    return [](const ClusterAddress&, const ThreadShare&) {
        return Error{"clusters work in two dimensions only so far"};
    };
}

// What outlives a visit.
struct StudioHost {
    Window& window;
    Renderer& renderer;
    FrameLog& frame_log;
};

class Studio {
public:
    // All must outlive it.
    Studio(const Visit& visit, const Preferences& remembered, const StudioKinds& kinds,
           const StudioHost& host)
        : options_(visit.options),
          window_(host.window),
          renderer_(host.renderer),
          controller_(remembered, kinds.here, machines(options_), options_.status_log,
                      &kinds.elsewhere),
          host_(window_, renderer_, scale(), controller_.view().theme),
          main_window_(builtin_panels(), &renderer_),
          frame_log_(host.frame_log) {
        if (options_.viewer) controller_.window().be_viewer();
        controller_.remember_in(options_.state_dir);
        controller_.use_assets(options_.assets);
        controller_.files().use_page_parts(options_.page_parts);
        open_first_files(visit.begins);
        if (visit.begins) {
            controller_.feedback().tell(
                NoticeKind::kDone,
                fmt::format("A run in {} dimensions. File > Open the run before leads back.",
                            kinds.here.creature.scene.dimensions == 3 ? "three" : "two"));
        }
        const bool unasked =
            options_.open_file.empty() && !options_.evolve && !options_.viewer && !visit.begins;
        if (unasked && !controller_.files().recent().empty())
            controller_.files().carry_out(ToggleStartPage{});
        const bool first_look = !options_.state_dir.empty() && options_.open_file.empty();
        if (first_look && !options_.evolve) controller_.guide().offer_tour();
    }

    // Returns the world to go on in, if the user left for another one.
    std::optional<SpaceCrossing> run() {
        const Stopwatch clock;
        double last_start = 0.0;
        while (!window_.close_wanted() && !controller_.window().quit_wanted() &&
               !options_.end.stop_requested() && !controller_.files().crossing()) {
            wait_for_frame(clock, last_start);
            const double now = clock.seconds();
            frame_log_.begin_frame();
            controller_.feedback().log().begin_frame(frame_log_.frame());
            frame(now, now - last_start);
            const double work = clock.seconds() - now;
            window_.show_frame();
            if (!std::exchange(started_, true)) controller_.feedback().log().write("started");
            frame_log_.end_frame({now - last_start, work, controller_.playback_seconds()});
            last_start = now;
            if (options_.quit_after > 0.0 && now > options_.quit_after) break;
        }
        controller_.close();
        std::optional<SpaceCrossing> crossing = controller_.files().crossing();
        if (crossing) {
            controller_.feedback().log().write("crossing", {{"path", crossing->file.string()}});
            return crossing;
        }
        controller_.feedback().log().write("quit");
        if (!options_.screenshot.empty()) take_picture(options_.screenshot);
        return {};
    }
    Preferences remembered() const { return controller_.remembered(); }

private:
    // Returns the size of the interface in pixels a unit. A presentation is read from afar.
    float scale() const {
        const double told = options_.drawing.scale;
        const float base = told > 0.0 ? static_cast<float>(told) : window_.scale();
        const bool presenting = controller_.presenting();
        return base * 0.01F * static_cast<float>(controller_.view().size) *
               (presenting ? kPresentationScale : 1.0F);
    }

    static MachineOptions machines(const StudioOptions& options) {
        MachineOptions machines = options.machines;
        std::size_t& workers = machines.threads.workers;
        if (workers == 0) workers = ThreadPool::default_workers();
        return machines;
    }

    void open_first_files(bool begins) {
        const std::filesystem::path& file = options_.open_file;
        if (!file.empty()) {
            controller_.files().open_now(file, ExhibitSource::kFile);
        } else if (!options_.evolve && !begins) {
            controller_.reopen_last();
        }
        if (controller_.frame_context().viewer.playback.empty()) controller_.show_founders();
        if (options_.evolve) {
            Requests requests;
            requests.ask(ToggleEvolution{});
            controller_.carry_out(requests);
        }
    }

    // Waits for the next frame; a display that sets a lower frame rate makes it later.
    void wait_for_frame(const Stopwatch& clock, double last_start) {
        if (window_.take_activity() || controller_.animating() || renderer_.take_unfinished())
            quiet_frames_ = 0;
        const bool idle = ++quiet_frames_ > kSettledFrames;
        const double due = last_start + (idle ? kIdleSleep : 1.0 / options_.drawing.frame_rate);
        window_.poll(0.0);
        while (clock.seconds() < due) {
            window_.poll(std::max(0.0, due - clock.seconds()));
            if (idle && window_.take_activity()) break;
        }
    }

    void frame(double now, double elapsed) {
        controller_.update(now, elapsed);
        FrameContext context = controller_.frame_context();
        window_.fill_display(context.window.full_screen);
        context.window.framebuffer_height = window_.framebuffer_height();
        const bool automatic = context.view.scenery == Scenery::kAutomatic;
        context.window.scenery = automatic ? pace_.tier() : context.view.scenery;
        if (host_.context().scale != scale()) host_.set_scale(scale());
        context.window.narrow = is_narrow(static_cast<float>(window_.framebuffer_width()), scale());
        Requests requests;
        if (host_.context().theme != controller_.view().theme)
            host_.set_theme(controller_.view().theme);
        host_.set_look(controller_.view().look);
        const std::vector<KeyPress> pressed = window_.take_keys();
        const bool typing = host_.begin_frame(pressed, !context.world_shown());
        for (const KeyPress& press : pressed) {
            controller_.feedback().log().write("pressed",
                                               {{"key", static_cast<double>(press.key)}});
            const bool taken =
                (press.key == GLFW_KEY_ESCAPE && ImGuiHost::close_popup()) ||
                (press.key == GLFW_KEY_ENTER && control_focused()) ||
                (popup_open() && (press.key == GLFW_KEY_UP || press.key == GLFW_KEY_DOWN));
            if (!taken) press_shortcut(press, typing, context, requests);
        }
        for (const std::filesystem::path& path : window_.take_dropped_files())
            controller_.files().carry_out(LoadFile{path});
        if (options_.viewer)
            window_.set_title(context.viewer.playback.exhibit().name() + " – Cambrian");
        main_window_.draw(context, requests);
        const std::string complaint = host_.take_complaint();
        if (!complaint.empty()) controller_.feedback().tell(NoticeKind::kProblem, complaint);
        const PictureOrders orders = controller_.files().take_orders();
        if (orders.plot) keep_plot(*orders.plot, context);
        const Stopwatch drawing;
        host_.end_frame();
        if (automatic && controller_.animating()) pace_.note(drawing.seconds(), elapsed);
        if (!context.window.presenting) recorder_.take(center(), now);
        if (orders.screenshot) keep_picture(orders.screenshot->path);
        if (orders.seen) keep_seen(now);
        if (orders.copy) copy_picture();
        if (orders.card) keep_card(*orders.card);
        controller_.carry_out(requests);
        if (!options_.status_log.empty()) screen_report_.write(controller_.feedback().log());
    }

    Image picture() {
        return read_pixels(window_.framebuffer_width(), window_.framebuffer_height());
    }

    // Returns where the viewport, the grid or the world is.
    ReadArea center() const {
        const Rect& rect = main_window_.center();
        const auto whole = [](float pixels) { return static_cast<int>(pixels); };
        return {whole(rect.x), window_.framebuffer_height() - whole(rect.y) - whole(rect.height),
                whole(rect.width), whole(rect.height)};
    }

    // Returns a new path in the user's folder of pictures. What was just saved may still be without
    // a file, so its number is never reused.
    std::filesystem::path new_path(std::string_view ending) {
        std::filesystem::path path;
        do {
            path = pictures_folder() / fmt::format("cambrian-{}{}", ++pictures_, ending);
        } while (std::filesystem::exists(path));
        return std::filesystem::absolute(path);
    }

    void keep_seen(double now) {
        SeenClip seen = recorder_.seen(now);
        if (seen.pictures.empty())
            return controller_.feedback().tell(NoticeKind::kProblem, "Nothing was seen yet.");
        controller_.files().save_seen(new_path(".gif"), std::move(seen));
    }

    void copy_picture() {
        if (clipboard_.put(read_pixels(center())))
            return controller_.feedback().tell(NoticeKind::kDone,
                                               "The picture is on the clipboard.");
        controller_.feedback().tell(
            NoticeKind::kProblem,
            "Pictures can be copied only where the display is an X server; F12 saves one.");
    }

    void keep_picture(std::filesystem::path path) {
        if (path.empty() || std::filesystem::exists(path)) path = new_path(".png");
        controller_.files().save_picture(std::filesystem::absolute(path), picture());
    }

    void keep_plot(const SavePlotPicture& request, const FrameContext& context) {
        const int width = request.size.width;
        const int height = request.size.height;
        auto image = host_.picture(width, height, [&](ImDrawList& list) {
            draw_timeline_picture(
                list, {0, 0, static_cast<float>(width), static_cast<float>(height)},
                context.experiment.snapshot, context.view.quantity, context.kinds.goals);
        });
        if (!image) return controller_.feedback().tell(NoticeKind::kProblem, image.error().message);
        controller_.files().save_picture(std::filesystem::absolute(request.path),
                                         std::move(*image));
    }

    void keep_card(const PreparedCard& card) {
        auto picture = draw_card_picture(card.subject);
        if (!picture)
            return controller_.feedback().tell(NoticeKind::kProblem, picture.error().message);
        controller_.files().save_card(card, std::move(*picture));
    }

    Result<Image> draw_card_picture(const Subject& subject) {
        const auto text_rasterizer = TextRasterizer::load();
        if (!text_rasterizer) return text_rasterizer.error();
        auto canvas = PictureCanvas::create(renderer_, **text_rasterizer, kCardWidth, kCardHeight);
        if (!canvas) return canvas.error();
        draw_card(*canvas, subject, palette_of(controller_.view().theme));
        return canvas->finish();
    }

    void take_picture(const std::filesystem::path& path) {
        do {
            frame(1e9, 0.0);
        } while (renderer_.take_unfinished());
        controller_.files().save_picture(path, picture());
    }

    const StudioOptions& options_;
    Window& window_;
    Renderer& renderer_;
    StudioController controller_;
    ImGuiHost host_;
    MainWindow main_window_;
    FrameLog& frame_log_;
    FramePace pace_;
    ViewRecorder recorder_;
    PictureClipboard clipboard_;
    int quiet_frames_ = 0;
    int pictures_ = 0;  // number of the last one named by the studio
    bool started_ = false;
    ScreenReport screen_report_;
};

}  // namespace

Status run_studio(const StudioOptions& options, const EvolutionKinds& plane,
                  const EvolutionKinds& space) {
    auto window = Window::open(options.drawing.width, options.drawing.height, "Cambrian");
    if (!window) return window.error();
    auto renderer = Renderer::create();
    if (!renderer) return renderer.error();
    FrameLog frame_log(options.frame_log);
    const int last = remembered_dimensions(options.state_dir);
    std::map<int, VisitedWorld> worlds;
    worlds.emplace(2, VisitedWorld{{plane, space}, {}});
    worlds.emplace(3, VisitedWorld{{space, plane}, plain_defaults(space)});
    Preferences state = recall(options.state_dir, worlds.at(last).kinds.here);
    if (state.settings == ExperimentSettings{}) state.settings = worlds.at(last).settings;
    if (options.theme) state.view.theme = *options.theme;
    if (options.scenery) state.view.scenery = *options.scenery;
    Visit visit{options, false};
    int here = options.open_file.empty() ? last : dimensions_of_file(options.open_file);
    if (here != last) enter(worlds.at(last), worlds.at(here), state);
    while (true) {
        visit.options.machines.join = here == 3 ? joining_in_space(options) : options.machines.join;
        Studio studio(visit, state, worlds.at(here).kinds, {**window, **renderer, frame_log});
        const std::optional<SpaceCrossing> crossing = studio.run();
        if (!crossing) return {};
        state = studio.remembered();
        const int next = here == 3 ? 2 : 3;
        enter(worlds.at(here), worlds.at(next), state);
        here = next;
        visit.options.open_file = crossing->file;
        visit.options.evolve = false;
        visit.begins = crossing->file.empty();
    }
}

}  // namespace cambrian
