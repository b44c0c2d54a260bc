#pragma once

namespace cambrian {

// A key that went down, with the modifiers held at that time.
struct KeyPress {
    int key = 0;  // GLFW's number
    bool control = false;
    bool shift = false;

    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

}  // namespace cambrian
