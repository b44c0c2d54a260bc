#include "studio/host/window.h"

#include "core/text/shown_text.h"
#include "render/opengl/gl.h"

#include <GLFW/glfw3.h>
#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <utility>

namespace cambrian {
namespace {

constexpr float kLeastWidth = 960.0F;  // in units of 1/96 inch
constexpr float kLeastHeight = 600.0F;

// The keys that act again and again while they are held: steps, paces, arrows and the like. Others
// are mostly switches.
constexpr std::array kRepeatingKeys = {
    GLFW_KEY_PERIOD, GLFW_KEY_COMMA, GLFW_KEY_LEFT_BRACKET, GLFW_KEY_RIGHT_BRACKET,
    GLFW_KEY_LEFT,   GLFW_KEY_RIGHT, GLFW_KEY_UP,           GLFW_KEY_DOWN,
    GLFW_KEY_TAB};

bool counts(int key, int action) {
    if (action != GLFW_REPEAT) return action == GLFW_PRESS;
    return std::find(kRepeatingKeys.begin(), kRepeatingKeys.end(), key) != kRepeatingKeys.end();
}

std::string last_glfw_error() {
    const char* text = nullptr;
    glfwGetError(&text);
    return text == nullptr ? "no reason given" : text;
}

Window& owner_of(GLFWwindow* window) {
    return *static_cast<Window*>(glfwGetWindowUserPointer(window));
}

// Returns the scale that the desktop tells, without checks.
float told_scale() {
    float scale = 0.0F;
    float across = 0.0F;
    GLFWmonitor* monitor = glfwGetPrimaryMonitor();
    if (monitor != nullptr) glfwGetMonitorContentScale(monitor, &scale, &across);
    return scale;
}

// GLFW itself makes the window as many times larger as the desktop tells, unless that is not
// usable.
GLFWwindow* create_window(int width, int height, const std::string& title) {
    const float told = told_scale();
    const float scale = usable_scale(told);
    const bool usable = scale == told;
    const auto sized = [&](int units) {
        return usable ? units : static_cast<int>(scale * static_cast<float>(units));
    };
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    glfwWindowHint(GLFW_STENCIL_BITS, 0);
    glfwWindowHint(GLFW_SCALE_TO_MONITOR, usable ? GLFW_TRUE : GLFW_FALSE);
    glfwWindowHint(GLFW_AUTO_ICONIFY, GLFW_FALSE);
    glfwWindowHintString(GLFW_X11_CLASS_NAME, "cambrian");
    return glfwCreateWindow(sized(width), sized(height), title.c_str(), nullptr, nullptr);
}

}  // namespace

float usable_scale(float told) {
    constexpr float least = 0.5F;
    constexpr float most = 4.0F;
    return told > 0.0F ? std::clamp(told, least, most) : 1.0F;
}

Result<std::unique_ptr<Window>> Window::open(int width, int height, const std::string& title) {
    if (glfwInit() != GLFW_TRUE) {
        return Error{
            fmt::format("no display to open a window on ({}); the subcommands work without one",
                        last_glfw_error())};
    }
    GLFWwindow* window = create_window(width, height, title);
    if (window == nullptr) {
        const std::string why = last_glfw_error();
        glfwTerminate();
        return Error{"no window with OpenGL 3.3 can be opened: " + why};
    }
    glfwMakeContextCurrent(window);
    if (gladLoadGL(glfwGetProcAddress) == 0) {
        glfwDestroyWindow(window);
        glfwTerminate();
        return Error{"the graphics driver offers no OpenGL 3.3"};
    }
    return std::unique_ptr<Window>(new Window(window));
}

Window::Window(GLFWwindow* window) : window_(window) {
    float across = 1.0F;
    glfwGetWindowContentScale(window_, &scale_, &across);
    scale_ = usable_scale(scale_);
    glfwSwapInterval(1);
    limit_size();
    install_callbacks();
}

// GLFW measures windows in pixels on some systems and in larger units on others.
void Window::limit_size() {
    int width = 1;
    glfwGetWindowSize(window_, &width, nullptr);
    const float pixels =
        static_cast<float>(framebuffer_width()) / static_cast<float>(std::max(1, width));
    const float units = scale_ / std::max(1.0F, pixels);
    glfwSetWindowSizeLimits(window_, static_cast<int>(kLeastWidth * units),
                            static_cast<int>(kLeastHeight * units), GLFW_DONT_CARE, GLFW_DONT_CARE);
}

Window::~Window() {
    glfwDestroyWindow(window_);
    glfwTerminate();
}

// Must run before Dear ImGui installs its callbacks, which call these in turn.
void Window::install_callbacks() {
    glfwSetWindowUserPointer(window_, this);
    glfwSetKeyCallback(window_, [](GLFWwindow* window, int key, int, int action, int mods) {
        owner_of(window).activity_ = true;
        if (!counts(key, action)) return;
        owner_of(window).keys_.push_back(
            {key, (mods & GLFW_MOD_CONTROL) != 0, (mods & GLFW_MOD_SHIFT) != 0});
    });
    glfwSetDropCallback(window_, [](GLFWwindow* window, int count, const char** paths) {
        owner_of(window).activity_ = true;
        for (int i = 0; i < count; ++i)
            owner_of(window).dropped_.emplace_back(paths[i]);
    });
    glfwSetCharCallback(window_, [](GLFWwindow* w, unsigned) { owner_of(w).activity_ = true; });
    glfwSetCursorPosCallback(window_,
                             [](GLFWwindow* w, double, double) { owner_of(w).activity_ = true; });
    glfwSetMouseButtonCallback(window_,
                               [](GLFWwindow* w, int, int, int) { owner_of(w).activity_ = true; });
    glfwSetScrollCallback(window_,
                          [](GLFWwindow* w, double, double) { owner_of(w).activity_ = true; });
    glfwSetWindowRefreshCallback(window_, [](GLFWwindow* w) { owner_of(w).activity_ = true; });
    glfwSetFramebufferSizeCallback(window_,
                                   [](GLFWwindow* w, int, int) { owner_of(w).activity_ = true; });
}

void Window::set_title(const std::string& title) {
    // The title may be a creature's name.
    const std::string clean = shown_whole(title);
    if (clean == title_) return;
    title_ = clean;
    glfwSetWindowTitle(window_, title_.c_str());
}

namespace {

// Returns the display that has the middle of a window; null without displays.
GLFWmonitor* display_of(int x, int y) {
    int count = 0;
    GLFWmonitor** const all = glfwGetMonitors(&count);
    for (int i = 0; i < count; ++i) {
        int left = 0;
        int top = 0;
        glfwGetMonitorPos(all[i], &left, &top);
        const GLFWvidmode* mode = glfwGetVideoMode(all[i]);
        if (mode != nullptr && x >= left && x < left + mode->width && y >= top &&
            y < top + mode->height)
            return all[i];
    }
    return glfwGetPrimaryMonitor();
}

}  // namespace

void Window::fill_display(bool fills) {
    activity_ = true;
    if (fills == (glfwGetWindowMonitor(window_) != nullptr)) return;
    auto& [x, y, width, height] = windowed_;
    if (!fills) return glfwSetWindowMonitor(window_, nullptr, x, y, width, height, GLFW_DONT_CARE);
    glfwGetWindowPos(window_, &x, &y);
    glfwGetWindowSize(window_, &width, &height);
    GLFWmonitor* const display = display_of(x + width / 2, y + height / 2);
    const GLFWvidmode* mode = display == nullptr ? nullptr : glfwGetVideoMode(display);
    if (mode == nullptr) return;
    glfwSetWindowMonitor(window_, display, 0, 0, mode->width, mode->height, mode->refreshRate);
}

bool Window::close_wanted() const {
    return glfwWindowShouldClose(window_) == GLFW_TRUE;
}

int Window::framebuffer_width() const {
    int width = 1;
    int height = 1;
    glfwGetFramebufferSize(window_, &width, &height);
    return width;
}

int Window::framebuffer_height() const {
    int width = 1;
    int height = 1;
    glfwGetFramebufferSize(window_, &width, &height);
    return height;
}

void Window::poll(double longest_sleep) {
    if (longest_sleep > 0.0) {
        glfwWaitEventsTimeout(longest_sleep);
    } else {
        glfwPollEvents();
    }
}

void Window::show_frame() {
    glfwSwapBuffers(window_);
}

bool Window::key_down(int key) const {
    return glfwGetKey(window_, key) == GLFW_PRESS;
}

std::vector<KeyPress> Window::take_keys() {
    return std::exchange(keys_, {});
}

std::vector<std::filesystem::path> Window::take_dropped_files() {
    return std::exchange(dropped_, {});
}

bool Window::take_activity() {
    return std::exchange(activity_, false);
}

}  // namespace cambrian
