#pragma once

// A slider drawn as a bar that fills; Ctrl+click types a value. The label is "##value".

#include <string>

namespace cambrian {

struct SliderRange {
    double low = 0.0;
    double high = 1.0;
};

struct SliderStyle {
    SliderRange range;
    bool logarithmic = false;
    std::string pattern = "%.2f";  // printf's; of whole numbers always %d
    float width = 0.0F;            // pixels
};

// True when the value changed; of a typed one, when it is complete. Typed values are kept even
// outside the range shown.
bool value_slider(double& value, const SliderStyle& style);
bool value_slider(int& value, const SliderStyle& style);

}  // namespace cambrian
