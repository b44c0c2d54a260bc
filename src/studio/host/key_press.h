#pragma once

namespace cambrian {

// A key that was pressed, with the modifiers held at that time.
struct KeyPress {
    int key = 0;  // GLFW key code
    bool control = false;
    bool shift = false;

    friend bool operator==(const KeyPress&, const KeyPress&) = default;
};

}  // namespace cambrian
