#pragma once

// Hands a picture to other programs through the X server's clipboard, from a thread of its own, so
// that they never wait for the window. It is there until something else is copied or the program
// ends.

#include "core/image.h"

#include <memory>

namespace cambrian {

class PictureClipboard {
public:
    PictureClipboard();
    ~PictureClipboard();
    PictureClipboard(const PictureClipboard&) = delete;
    PictureClipboard& operator=(const PictureClipboard&) = delete;

    // Returns false where no X server takes pictures.
    bool put(Image picture);

private:
    class SelectionOwner;

    std::unique_ptr<SelectionOwner> owner_;  // null until the first picture
};

}  // namespace cambrian
