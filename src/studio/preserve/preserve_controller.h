#pragma once

// Owns the preserve as a mode of the studio: begins, opens and closes it, and carries out what the
// user asks of it.

#include "core/threads/thread_share.h"
#include "studio/experiment/generations_controller.h"
#include "studio/hand_picking/picking_controller.h"
#include "studio/preserve/open_preserve.h"
#include "studio/preserve/preserve_contract.h"
#include "studio/preserve/world_pins.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace cambrian {

// The controllers that the mode needs. All must outlive the preserve controller.
struct PreserveSubjects {
    ViewerController& viewer;
    ExperimentController& experiment;
    GenerationsController& generations;
    PickingController& picking;
};

class PreserveController {
public:
    // `threads` compute a preserve. The references in `services` must outlive the
    // controller.
    PreserveController(const Services& services, const PreserveSubjects& subjects,
                       const ThreadShare& threads);

    // Sets the folder of the sample creatures and of the sample settings.
    void use_assets(const std::filesystem::path& folder) { assets_ = folder; }
    // Keeps new preserves in this folder from now on; an empty path keeps them nowhere.
    void keep_in(const std::filesystem::path& folder);

    void update();  // must be called once a frame
    void carry_out(const PreserveRequest& request);
    // Null while no preserve is open.
    const PreserveView* facts() const { return facts_ ? &*facts_ : nullptr; }
    PreserveCardView card() const;

    bool on() const { return picture_ != nullptr; }
    // Whether the viewport displays the world rather than one creature.
    bool world_shown() const { return on() && !tools_.single; }
    bool animating() const { return on() && (open_ == nullptr || picture_->playing); }

    void open(OpenedWorld opened);
    // Adds a creature where the user points.
    void add(const GenomePtr& genome);
    // Displays a creature in the viewer; returns false if there is none.
    bool show_alone(WorldSubject subject);
    // Keeps the preserve in another file from now on.
    void move_to(const std::filesystem::path& path);

private:
    struct WorldLists;
    struct WorldTools;
    struct Handler;
    // Carries out requests of the world's panels.
    struct Tools {
        Vec2 aim = Vec2::Zero();  // m
        WallTool wall;
        std::size_t plot = 0;
        WorldList list = WorldList::kLineages;
        unsigned laws_asked = 0;
        std::size_t piece = 0;
        bool follow = false;
        bool energy = false;
        bool single = false;
        bool card_open = false;
        PlanPreserve plan;  // of the card
        bool near = false;
        unsigned fits_asked = 0;
    };
    void send(PreserveCommand command);
    void begin(FounderChoice choice, const BeginPreserve& request);
    void close();
    void leave();
    void branch(std::optional<std::uint64_t> tick, const std::filesystem::path& to);
    void open_later(std::function<Result<OpenedWorld>()> make, bool play);

    Services services_;
    PreserveSubjects subjects_;
    ThreadShare threads_;
    std::filesystem::path assets_;
    std::filesystem::path own_file_;
    unsigned attempts_ = 0;               // number of the present attempt to open a world
    unsigned unfinished_ = 0;             // attempts that the background is still at
    std::shared_ptr<OpenPreserve> open_;  // null while another world is being read
    std::shared_ptr<const PreservePicture> picture_;
    WorldPins pins_;
    Tools tools_;
    std::optional<PreserveView> facts_;
};

}  // namespace cambrian
