#include "studio/playback/signal_trace.h"

namespace cambrian {

void SignalTrace::add(const Brain& brain, std::size_t outputs) {
    if (ticks_.size() == kLength) ticks_.pop_front();
    Tick& tick = ticks_.emplace_back();
    tick.slots.assign(brain.values().begin(), brain.values().end());
    for (std::size_t i = 0; i < outputs; ++i)
        tick.outputs.push_back(brain.output(i));
}

std::vector<double> SignalTrace::of_slot(Slot slot) const {
    std::vector<double> values;
    for (const Tick& tick : ticks_)
        values.push_back(tick.slots[slot]);
    return values;
}

std::vector<double> SignalTrace::of_output(std::size_t output) const {
    std::vector<double> values;
    for (const Tick& tick : ticks_)
        values.push_back(tick.outputs[output]);
    return values;
}

}  // namespace cambrian
