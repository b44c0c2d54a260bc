"""A client of an X display for tests of the window, through libX11.

x_client.py resources TEXT   sets the desktop's resources, as its settings do
x_client.py mute             owns the clipboard and never answers, as a stopped program
x_client.py offer TEXT       owns the clipboard and hands the text over
x_client.py take FILE        writes the clipboard's PNG picture to the file

Prints "ready" and stays until it is ended."""

import ctypes
import sys
import time

X = ctypes.CDLL("libX11.so.6")
X.XOpenDisplay.restype = ctypes.c_void_p
for call in (X.XDefaultRootWindow, X.XCreateSimpleWindow, X.XInternAtom):
    call.restype = ctypes.c_ulong
SELECTION_REQUEST = 30
SELECTION_NOTIFY = 31
STRING = 31
RESOURCE_MANAGER = 23
REPLACE = 0


class Request(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("sent", ctypes.c_int),
                ("display", ctypes.c_void_p), ("owner", ctypes.c_ulong),
                ("requestor", ctypes.c_ulong), ("selection", ctypes.c_ulong),
                ("target", ctypes.c_ulong), ("property", ctypes.c_ulong), ("time", ctypes.c_ulong)]


class Notice(ctypes.Structure):
    _fields_ = [("type", ctypes.c_int), ("serial", ctypes.c_ulong), ("sent", ctypes.c_int),
                ("display", ctypes.c_void_p), ("requestor", ctypes.c_ulong),
                ("selection", ctypes.c_ulong), ("target", ctypes.c_ulong),
                ("property", ctypes.c_ulong), ("time", ctypes.c_ulong)]


class Event(ctypes.Union):
    _fields_ = [("type", ctypes.c_int), ("request", Request), ("notice", Notice),
                ("space", ctypes.c_long * 24)]


def set_property(display, window, name, kind, text):
    X.XChangeProperty(display, ctypes.c_ulong(window), ctypes.c_ulong(name), ctypes.c_ulong(kind),
                      8, REPLACE, text, len(text))


def answer(display, request, text):
    set_property(display, request.requestor, request.property, request.target, text)
    event = Event()
    event.notice = Notice(SELECTION_NOTIFY, 0, 1, display, request.requestor, request.selection,
                          request.target, request.property, request.time)
    X.XSendEvent(display, ctypes.c_ulong(request.requestor), 0, ctypes.c_long(0),
                 ctypes.byref(event))
    X.XFlush(display)


def taken(display, window, clipboard):
    """Returns the clipboard's content as a PNG picture; nothing if its owner refuses."""
    png, answer_here = (ctypes.c_ulong(X.XInternAtom(display, name, 0))
                        for name in (b"image/png", b"TAKEN"))
    X.XConvertSelection(display, ctypes.c_ulong(clipboard), png, answer_here,
                        ctypes.c_ulong(window), ctypes.c_ulong(0))
    event = Event()
    while event.type != SELECTION_NOTIFY:
        X.XNextEvent(display, ctypes.byref(event))
    if event.notice.property == 0:
        return b""
    kind, form = ctypes.c_ulong(), ctypes.c_int()
    count, left = ctypes.c_ulong(), ctypes.c_ulong()
    data = ctypes.c_void_p()
    X.XGetWindowProperty(display, ctypes.c_ulong(window), answer_here, ctypes.c_long(0),
                         ctypes.c_long(1 << 24), 0, ctypes.c_ulong(0), ctypes.byref(kind),
                         ctypes.byref(form), ctypes.byref(count), ctypes.byref(left),
                         ctypes.byref(data))
    return ctypes.string_at(data, count.value)


def main(task, text=""):
    display = ctypes.c_void_p(X.XOpenDisplay(None))
    root = X.XDefaultRootWindow(display)
    if task == "take":
        window = X.XCreateSimpleWindow(display, ctypes.c_ulong(root), 0, 0, 1, 1, 0,
                                       ctypes.c_ulong(0), ctypes.c_ulong(0))
        clipboard = X.XInternAtom(display, b"CLIPBOARD", 0)
        with open(text, "wb") as file:
            file.write(taken(display, window, clipboard))
        return
    if task == "resources":
        set_property(display, root, RESOURCE_MANAGER, STRING, text.encode())
    else:
        window = X.XCreateSimpleWindow(display, ctypes.c_ulong(root), 0, 0, 1, 1, 0,
                                       ctypes.c_ulong(0), ctypes.c_ulong(0))
        clipboard = X.XInternAtom(display, b"CLIPBOARD", 0)
        X.XSetSelectionOwner(display, ctypes.c_ulong(clipboard), ctypes.c_ulong(window),
                             ctypes.c_ulong(0))
    X.XSync(display, 0)
    print("ready", flush=True)
    while task == "offer":
        event = Event()
        X.XNextEvent(display, ctypes.byref(event))
        if event.type == SELECTION_REQUEST:
            answer(display, event.request, text.encode())
    while True:
        time.sleep(60)


if __name__ == "__main__":
    main(*sys.argv[1:])
