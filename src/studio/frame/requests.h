#pragma once

// The requests of all panels in the order in which they were made. The studio controller carries
// them out after the frame is drawn. Each subject defines its own requests in its contract.

#include "studio/comparison/comparison_contract.h"
#include "studio/experiment/experiment_contract.h"
#include "studio/experiment/generations_contract.h"
#include "studio/files/files_contract.h"
#include "studio/frame/window_contract.h"
#include "studio/hand_picking/picking_contract.h"
#include "studio/help/guide_contract.h"
#include "studio/machines/machines_contract.h"
#include "studio/preserve/preserve_contract.h"
#include "studio/viewer/viewer_contract.h"

#include <utility>
#include <variant>
#include <vector>

namespace cambrian {

using StudioRequest = std::variant<ViewerRequest, ExperimentRequest, GenerationsRequest,
                                   PickingRequest, PreserveRequest, FilesRequest, GuideRequest,
                                   MachinesRequest, ComparisonRequest, WindowRequest>;

class Requests {
public:
    void ask(ViewerRequest request) { all_.emplace_back(std::move(request)); }
    void ask(ExperimentRequest request) { all_.emplace_back(std::move(request)); }
    void ask(GenerationsRequest request) { all_.emplace_back(std::move(request)); }
    void ask(PickingRequest request) { all_.emplace_back(std::move(request)); }
    void ask(PreserveRequest request) { all_.emplace_back(std::move(request)); }
    void ask(FilesRequest request) { all_.emplace_back(std::move(request)); }
    void ask(GuideRequest request) { all_.emplace_back(std::move(request)); }
    void ask(MachinesRequest request) { all_.emplace_back(std::move(request)); }
    void ask(ComparisonRequest request) { all_.emplace_back(std::move(request)); }
    void ask(WindowRequest request) { all_.emplace_back(request); }

    const std::vector<StudioRequest>& all() const { return all_; }
    std::vector<StudioRequest> take() { return std::exchange(all_, {}); }

private:
    std::vector<StudioRequest> all_;
};

}  // namespace cambrian
