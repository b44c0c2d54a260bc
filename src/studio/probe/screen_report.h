#pragma once

// Tells the status log where controls are and what text on the screen cannot be read, for tests
// that drive the window from outside and judge how it looks.

#include "studio/background/status_log.h"
#include "studio/look/ui_context.h"

#include <map>
#include <string>
#include <tuple>

namespace cambrian {

class ScreenReport {
public:
    // After each frame: a "place" for each control that appeared or moved, a "gone" for each that
    // is no longer seen, a "text fault" for each that stays, a "theme" once a frame on another one
    // is on the screen.
    void write(StatusLog& log);

private:
    void write_places(StatusLog& log);
    void write_faults(StatusLog& log);
    void write_theme(StatusLog& log);

    using FaultKey = std::tuple<int, std::string, int, int>;  // kind, window, where it begins
    std::map<std::string, NotedPlace> places_;                // as logged last
    std::map<FaultKey, int> faults_;                          // frames that each has lasted
    int frames_ = 0;
    ThemeKind theme_ = ThemeKind::kDark;    // of the frame before
    ThemeKind written_ = ThemeKind::kDark;  // as logged last
};

}  // namespace cambrian
