#pragma once

#include "studio/frame/panel.h"
#include "studio/machines/machines_contract.h"

#include <array>

namespace cambrian {

// The address of a cluster and its workers.
class MachinesPanel final : public Panel {
public:
    void draw(const FrameContext& frame, Requests& out) override;

private:
    static constexpr std::size_t kLongest = 512;  // bytes of a field
    using Text = std::array<char, kLongest>;

    void draw_fields(const MachinesView& machines, Requests& out);
    void show(const ClusterLogin& login);
    ClusterLogin typed() const;

    std::array<Text, 4> texts_ = {};
    int drawn_ = -1;      // the frame in which the card was drawn last
    ClusterLogin shown_;  // what the fields showed before they were edited
};

}  // namespace cambrian
