#pragma once

// The text that programs pass to each other. Another program may take as long as it likes to hand
// its text over, or be stopped; this one waits a quarter of a second at most, and then there is
// none.

#include <memory>
#include <string>

namespace cambrian {

class Clipboard {
public:
    // GLFW must be initialised and stay so.
    Clipboard();
    ~Clipboard();
    Clipboard(const Clipboard&) = delete;
    Clipboard& operator=(const Clipboard&) = delete;

    // Returns the text, of 256 KiB at most; empty if there is none.
    std::string text();
    void put(const std::string& text);

private:
    struct Server;

    std::unique_ptr<Server> server_;  // null if the display is not an X server
};

}  // namespace cambrian
