#pragma once

// Writes to the status log where controls are and which text on the screen cannot be read. Tests
// that drive the window from outside read it.

#include "studio/background/status_log.h"
#include "studio/look/ui_context.h"

#include <map>
#include <string>
#include <tuple>

namespace cambrian {

class ScreenReport {
public:
    // Must be called after each frame. Writes a "place" for each control that appeared or moved and
    // a "gone" for each that is no longer visible. Writes a "text fault" for each fault that lasts,
    // and a "theme" after a frame in another theme was displayed.
    void write(StatusLog& log);

private:
    void write_places(StatusLog& log);
    void write_faults(StatusLog& log);
    void write_theme(StatusLog& log);

    using FaultKey = std::tuple<int, std::string, int, int>;  // kind, window, top left corner
    std::map<std::string, NotedPlace> places_;                // as logged last
    std::map<FaultKey, int> faults_;  // number of looks in which each fault was found
    int frames_ = 0;
    ThemeKind theme_ = ThemeKind::kDark;    // of the frame before
    ThemeKind written_ = ThemeKind::kDark;  // as logged last
};

}  // namespace cambrian
