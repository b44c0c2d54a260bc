#pragma once

#include "studio/frame/panel.h"
#include "studio/machines/machines_contract.h"

#include <array>

namespace cambrian {

// Shows the address of a cluster and the list of its workers.
class MachinesPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    static constexpr std::size_t kLongest = 512;  // bytes in a field
    using Text = std::array<char, kLongest>;

    void draw_fields(const MachinesView& machines, Requests& out);
    void show(const ClusterLogin& login);
    ClusterLogin typed() const;

    std::array<Text, 4> texts_ = {};
    int drawn_ = -1;      // number of the frame in which the card was drawn last
    ClusterLogin shown_;  // content of the fields before they were edited
};

}  // namespace cambrian
