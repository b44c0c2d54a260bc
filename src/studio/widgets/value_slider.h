#pragma once

// A slider drawn as a bar that fills; Ctrl+click types a value. The label is "##value".

#include <optional>
#include <string>

namespace cambrian {

struct SliderRange {
    double low = 0.0;
    double high = 1.0;
};

struct SliderStyle {
    SliderRange range;
    bool logarithmic = false;
    std::string pattern = "%.2f";  // printf pattern; integers always use %d
    float width = 0.0F;            // pixels
    // The numbers that may be typed; by default all.
    std::optional<SliderRange> allowed = {};
};

// Return true when the value changed; a typed value counts when it is complete. Typed values
// outside the slider's range are kept. What is no number, or not allowed, is refused with a
// complaint (UiContext).
bool value_slider(double& value, const SliderStyle& style);
bool value_slider(int& value, const SliderStyle& style);

}  // namespace cambrian
