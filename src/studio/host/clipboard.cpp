#include "studio/host/clipboard.h"

#include "core/stopwatch.h"

#include <GLFW/glfw3.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <optional>
#include <poll.h>
#include <string_view>
#include <xcb/xcb.h>

namespace cambrian {
namespace {

constexpr double kPatience = 0.25;  // s for an owner to answer
constexpr std::uint32_t kMostPasted = 256 * 1024;

struct Freed {
    void operator()(void* memory) const { std::free(memory); }
};
template <class Type>
using Reply = std::unique_ptr<Type, Freed>;

xcb_atom_t atom(xcb_connection_t* to, std::string_view name) {
    const auto asked = xcb_intern_atom(to, 0, static_cast<std::uint16_t>(name.size()), name.data());
    const Reply<xcb_intern_atom_reply_t> reply(xcb_intern_atom_reply(to, asked, nullptr));
    return reply ? reply->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
}

}  // namespace

// A connection of its own, since GLFW answers requests for its text only between frames.
struct Clipboard::Server {
    xcb_connection_t* connection = xcb_connect(nullptr, nullptr);
    xcb_atom_t clipboard = atom(connection, "CLIPBOARD");
    xcb_atom_t manager = atom(connection, "CLIPBOARD_MANAGER");
    xcb_atom_t utf8 = atom(connection, "UTF8_STRING");
    xcb_atom_t targets = atom(connection, "TARGETS");
    xcb_atom_t answer = atom(connection, "CAMBRIAN_ANSWER");
    // This program's text, and the owner of the clipboard while that is GLFW.
    std::string own;
    xcb_window_t owner_of_own = XCB_WINDOW_NONE;

    Server() = default;
    ~Server() { xcb_disconnect(connection); }
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;

    xcb_window_t owner(xcb_atom_t selection) const {
        const Reply<xcb_get_selection_owner_reply_t> reply(xcb_get_selection_owner_reply(
            connection, xcb_get_selection_owner(connection, selection), nullptr));
        return reply ? reply->owner : static_cast<xcb_window_t>(XCB_WINDOW_NONE);
    }
    bool owned() const {
        return owner_of_own != XCB_WINDOW_NONE && owner(clipboard) == owner_of_own;
    }

    // Asks a selection's owner for a form of it. Returns its answer, which is empty if it refuses,
    // or nothing if it does not answer in time. An answer that comes later finds its window gone.
    std::optional<std::string> ask(xcb_atom_t selection, xcb_atom_t form) const {
        const xcb_window_t window = xcb_generate_id(connection);
        const xcb_screen_t& screen = *xcb_setup_roots_iterator(xcb_get_setup(connection)).data;
        xcb_create_window(connection, 0, window, screen.root, 0, 0, 1, 1, 0,
                          XCB_WINDOW_CLASS_INPUT_ONLY, screen.root_visual, 0, nullptr);
        xcb_convert_selection(connection, window, selection, form, answer, XCB_CURRENT_TIME);
        xcb_flush(connection);
        std::optional<std::string> given;
        if (wait_for_answer(window)) given = take_answer(window, form);
        xcb_destroy_window(connection, window);
        xcb_flush(connection);
        return given;
    }

    bool wait_for_answer(xcb_window_t window) const {
        const Stopwatch waited;
        while (xcb_connection_has_error(connection) == 0) {
            const Reply<xcb_generic_event_t> event(xcb_poll_for_event(connection));
            if (event && (event->response_type & 0x7FU) == XCB_SELECTION_NOTIFY) {
                xcb_selection_notify_event_t notice;
                std::memcpy(&notice, event.get(), sizeof notice);
                if (notice.requestor == window) return true;
            }
            if (event) continue;
            const double left = kPatience - waited.seconds();
            if (left <= 0.0) return false;
            pollfd readable = {xcb_get_file_descriptor(connection), POLLIN, 0};
            poll(&readable, 1, std::max(1, static_cast<int>(1e3 * left)));
        }
        return false;
    }

    std::string take_answer(xcb_window_t window, xcb_atom_t form) const {
        const auto asked = xcb_get_property(connection, 1, window, answer,
                                            XCB_GET_PROPERTY_TYPE_ANY, 0, kMostPasted / 4);
        const Reply<xcb_get_property_reply_t> reply(
            xcb_get_property_reply(connection, asked, nullptr));
        if (!reply || reply->type != form || reply->format != 8) return {};
        const char* bytes = static_cast<const char*>(xcb_get_property_value(reply.get()));
        return {bytes, static_cast<std::size_t>(xcb_get_property_value_length(reply.get()))};
    }
};

Clipboard::Clipboard() {
    if (std::string_view(glfwGetVersionString()).find("X11") == std::string_view::npos) return;
    server_ = std::make_unique<Server>();
    if (xcb_connection_has_error(server_->connection) != 0) server_.reset();
}

// At its end GLFW offers its text to the desktop's clipboard manager, and waits until it is taken.
// The text is given up if the manager does not answer.
Clipboard::~Clipboard() {
    if (!server_ || !server_->owned() || server_->owner(server_->manager) == XCB_WINDOW_NONE)
        return;
    if (server_->ask(server_->manager, server_->targets)) return;
    xcb_set_selection_owner(server_->connection, XCB_WINDOW_NONE, server_->clipboard,
                            XCB_CURRENT_TIME);
    static_cast<void>(server_->owner(server_->clipboard));  // returns when that is done
}

std::string Clipboard::text() {
    if (!server_) {
        const char* text = glfwGetClipboardString(nullptr);
        return text == nullptr ? "" : text;
    }
    if (server_->owned()) return server_->own;
    if (server_->owner(server_->clipboard) == XCB_WINDOW_NONE) return {};
    return server_->ask(server_->clipboard, server_->utf8).value_or("");
}

void Clipboard::put(const std::string& text) {
    glfwSetClipboardString(nullptr, text.c_str());
    if (!server_) return;
    server_->own = text;
    server_->owner_of_own = server_->owner(server_->clipboard);
}

}  // namespace cambrian
