#pragma once

// The requests of all panels in the order in which they were made. The studio controller carries
// them out after the frame is drawn. Each subject defines its own requests in its contract.

#include "studio/coach/coach_contract.h"
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

#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cambrian {

using StudioRequest = std::variant<ViewerRequest, ExperimentRequest, GenerationsRequest,
                                   PickingRequest, PreserveRequest, FilesRequest, GuideRequest,
                                   MachinesRequest, ComparisonRequest, CoachRequest, WindowRequest>;

namespace request_detail {

template <class Kind, class Variant>
inline constexpr bool kIsAlternative = false;
template <class Kind, class... Kinds>
inline constexpr bool kIsAlternative<Kind, std::variant<Kinds...>> = (std::is_same_v<Kind, Kinds> ||
                                                                      ...);

template <class Kind, class Subjects>
struct Subject;
template <class Kind, class First, class... Others>
struct Subject<Kind, std::variant<First, Others...>>
    : std::conditional_t<kIsAlternative<Kind, First>, std::type_identity<First>,
                         Subject<Kind, std::variant<Others...>>> {};

}  // namespace request_detail

// The subject's variant that has this kind of request.
template <class Kind>
using SubjectOf = typename request_detail::Subject<Kind, StudioRequest>::type;

class Requests {
public:
    // The subject is found by the exact kind, which the compiler does sooner than to try every
    // variant's conversions.
    template <class Kind>
    void ask(Kind request) {
        all_.emplace_back(std::in_place_type<SubjectOf<Kind>>, std::in_place_type<Kind>,
                          std::move(request));
    }

    const std::vector<StudioRequest>& all() const { return all_; }
    std::vector<StudioRequest> take() { return std::exchange(all_, {}); }

private:
    std::vector<StudioRequest> all_;
};

}  // namespace cambrian
