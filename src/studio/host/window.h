#pragma once

// The window on the display and its OpenGL context.

#include "core/result.h"
#include "studio/host/key_press.h"

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;

namespace cambrian {

// Returns the scale to draw with (pixels per 1/96 inch) where the desktop tells `told`: at least
// 0.5 and at most 4; 1 where it tells nothing usable.
float usable_scale(float told);

class Window {
public:
    // Opens a window; width and height are in units of 1/96 inch. Fails without a display or
    // without OpenGL 3.3.
    static Result<std::unique_ptr<Window>> open(int width, int height, const std::string& title);
    ~Window();
    Window(const Window&) = delete;
    Window& operator=(const Window&) = delete;

    GLFWwindow* handle() { return window_; }
    void set_title(const std::string& title);
    // Fills the display that the window is on, or returns to where it was.
    void fill_display(bool fills);
    bool close_wanted() const;
    float scale() const { return scale_; }  // pixels per 1/96 inch on this display
    int framebuffer_width() const;
    int framebuffer_height() const;
    // Reads pending input; waits for input for at most `longest_sleep` seconds.
    void poll(double longest_sleep);
    void show_frame();

    bool key_down(int key) const;
    // Return the keys and files since the last call.
    std::vector<KeyPress> take_keys();
    std::vector<std::filesystem::path> take_dropped_files();
    // Returns whether there was any input, or the window was exposed, since the last call.
    bool take_activity();

private:
    explicit Window(GLFWwindow* window);
    void limit_size();
    void install_callbacks();

    GLFWwindow* window_ = nullptr;
    float scale_ = 1.0F;
    std::string title_;
    struct {
        int x = 0;
        int y = 0;
        int width = 0;
        int height = 0;
    } windowed_;  // place and size to return to, in GLFW's units
    std::vector<KeyPress> keys_;
    std::vector<std::filesystem::path> dropped_;
    bool activity_ = true;
};

}  // namespace cambrian
