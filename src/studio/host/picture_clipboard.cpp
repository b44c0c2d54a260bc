#include "studio/host/picture_clipboard.h"

#include "core/files/file_descriptor.h"
#include "persist/creature/png_file.h"

#include <GLFW/glfw3.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <optional>
#include <poll.h>
#include <string>
#include <string_view>
#include <sys/eventfd.h>
#include <thread>
#include <unistd.h>
#include <utility>
#include <xcb/xcb.h>

namespace cambrian {
namespace {

template <class Type>
struct XReply {
    explicit XReply(Type* taken) : value(taken) {}
    ~XReply() { std::free(value); }
    XReply(const XReply&) = delete;
    XReply& operator=(const XReply&) = delete;
    Type* value;
};

xcb_atom_t named_atom(xcb_connection_t* to, std::string_view name) {
    const auto asked = xcb_intern_atom(to, 0, static_cast<std::uint16_t>(name.size()), name.data());
    const XReply reply(xcb_intern_atom_reply(to, asked, nullptr));
    return reply.value != nullptr ? reply.value->atom : static_cast<xcb_atom_t>(XCB_ATOM_NONE);
}

}  // namespace

// A connection and a window of its own, which owns the selection while it holds the picture.
class PictureClipboard::SelectionOwner {
public:
    SelectionOwner()
        : connection_(xcb_connect(nullptr, nullptr)), wake_(::eventfd(0, EFD_CLOEXEC)) {
        if (!works()) return;
        clipboard_ = named_atom(connection_, "CLIPBOARD");
        targets_ = named_atom(connection_, "TARGETS");
        png_ = named_atom(connection_, "image/png");
        const xcb_screen_t& screen = *xcb_setup_roots_iterator(xcb_get_setup(connection_)).data;
        window_ = xcb_generate_id(connection_);
        xcb_create_window(connection_, 0, window_, screen.root, 0, 0, 1, 1, 0,
                          XCB_WINDOW_CLASS_INPUT_ONLY, screen.root_visual, 0, nullptr);
        xcb_flush(connection_);
        thread_ = std::thread([this] { run(); });
    }
    ~SelectionOwner() {
        ended_ = true;
        wake();
        if (thread_.joinable()) thread_.join();
        xcb_disconnect(connection_);
    }
    SelectionOwner(const SelectionOwner&) = delete;
    SelectionOwner& operator=(const SelectionOwner&) = delete;

    bool works() const { return xcb_connection_has_error(connection_) == 0 && wake_.is_open(); }

    void put(Image picture) {
        {
            const std::lock_guard lock(mutex_);
            next_ = std::move(picture);
        }
        wake();
    }

private:
    void wake() const {
        const std::uint64_t one = 1;
        static_cast<void>(::write(wake_.get(), &one, sizeof one));
    }

    void run() {
        std::array<pollfd, 2> sources = {
            {{xcb_get_file_descriptor(connection_), POLLIN, 0}, {wake_.get(), POLLIN, 0}}};
        while (!ended_ && works()) {
            take_next();
            answer_all();
            ::poll(sources.data(), sources.size(), -1);
            std::uint64_t count = 0;
            if (sources[1].revents != 0)
                static_cast<void>(::read(wake_.get(), &count, sizeof count));
        }
    }

    void take_next() {
        std::optional<Image> picture;
        {
            const std::lock_guard lock(mutex_);
            picture = std::exchange(next_, std::nullopt);
        }
        if (!picture) return;
        auto encoded = encode_png(*picture);
        if (!encoded) return;
        bytes_ = *std::move(encoded);
        xcb_set_selection_owner(connection_, window_, clipboard_, XCB_CURRENT_TIME);
        xcb_flush(connection_);
    }

    void answer_all() {
        for (;;) {
            const XReply event(xcb_poll_for_event(connection_));
            if (event.value == nullptr) return;
            const unsigned kind = event.value->response_type & 0x7FU;
            if (kind == XCB_SELECTION_CLEAR) bytes_.clear();
            if (kind != XCB_SELECTION_REQUEST) continue;
            xcb_selection_request_event_t request;
            std::memcpy(&request, event.value, sizeof request);
            answer(request);
        }
    }

    // A refusal names no property.
    void answer(const xcb_selection_request_event_t& request) {
        xcb_selection_notify_event_t notice{};
        notice.response_type = XCB_SELECTION_NOTIFY;
        notice.time = request.time;
        notice.requestor = request.requestor;
        notice.selection = request.selection;
        notice.target = request.target;
        const xcb_atom_t property =
            request.property == XCB_ATOM_NONE ? request.target : request.property;
        if (give(request, property)) notice.property = property;
        xcb_send_event(connection_, 0, request.requestor, XCB_EVENT_MASK_NO_EVENT,
                       reinterpret_cast<const char*>(&notice));
        xcb_flush(connection_);
    }

    bool give(const xcb_selection_request_event_t& request, xcb_atom_t property) const {
        if (bytes_.empty()) return false;
        if (request.target == targets_) {
            const std::array offered = {targets_, png_};
            xcb_change_property(connection_, XCB_PROP_MODE_REPLACE, request.requestor, property,
                                XCB_ATOM_ATOM, 32, offered.size(), offered.data());
            return true;
        }
        // The server tells in units of four bytes what it takes; a request has a head, too.
        const std::size_t most =
            4 * static_cast<std::size_t>(xcb_get_maximum_request_length(connection_)) - 64;
        if (request.target != png_ || bytes_.size() > most) return false;
        xcb_change_property(connection_, XCB_PROP_MODE_REPLACE, request.requestor, property, png_,
                            8, static_cast<std::uint32_t>(bytes_.size()), bytes_.data());
        return true;
    }

    xcb_connection_t* connection_;
    FileDescriptor wake_;
    xcb_window_t window_ = XCB_WINDOW_NONE;
    xcb_atom_t clipboard_ = XCB_ATOM_NONE;
    xcb_atom_t targets_ = XCB_ATOM_NONE;
    xcb_atom_t png_ = XCB_ATOM_NONE;
    std::string bytes_;  // of the thread: the PNG on offer
    std::mutex mutex_;
    std::optional<Image> next_;  // to be offered
    std::atomic<bool> ended_ = false;
    std::thread thread_;
};

PictureClipboard::PictureClipboard() = default;
PictureClipboard::~PictureClipboard() = default;

bool PictureClipboard::put(Image picture) {
    if (std::string_view(glfwGetVersionString()).find("X11") == std::string_view::npos)
        return false;
    if (!owner_) owner_ = std::make_unique<SelectionOwner>();
    if (!owner_->works()) {
        owner_.reset();
        return false;
    }
    owner_->put(std::move(picture));
    return true;
}

}  // namespace cambrian
