#include "studio/host/imgui_host.h"

#include "render/opengl/framebuffer.h"
#include "render/opengl/gl.h"
#include "studio/host/area_painting.h"
#include "studio/host/window.h"
#include "studio/widgets/keyboard_focus.h"

#include <GLFW/glfw3.h>
#include <imgui_internal.h>

#include <array>
#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

namespace cambrian {
namespace {

// Clears the full framebuffer that is bound.
void clear(const Color& color, int width, int height) {
    glViewport(0, 0, width, height);
    glDisable(GL_SCISSOR_TEST);
    glClearColor(color.r, color.g, color.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
}

}  // namespace

ImGuiHost::ImGuiHost(Window& window, Renderer& renderer, float scale, ThemeKind theme)
    : window_(window), tiles_(renderer) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.UserData = &context_;
    io.IniFilename = nullptr;  // the studio stores the arrangement itself
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    context_.scale = scale;
    context_.fonts = load_fonts(scale);
    context_.texture_of = [this](const auto& picture) { return textures_.of(picture); };
    context_.tile_of = [this](const TileWish& wish) { return tiles_.of(wish); };
    set_theme(theme);
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui::GetIO().KeyMap[ImGuiKey_Tab] = -1;  // begin_focus_frame() handles it
    use_clipboard();
    ImGui_ImplOpenGL3_Init("#version 330 core");
    // Renders all glyphs now, so that no frame waits for them.
    ImGui_ImplOpenGL3_CreateDeviceObjects();
}

ImGuiHost::~ImGuiHost() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

// In place of the back-end's functions, which wait for the owner of the clipboard.
void ImGuiHost::use_clipboard() {
    ImGuiIO& io = ImGui::GetIO();
    io.ClipboardUserData = this;
    io.SetClipboardTextFn = [](void* self, const char* text) {
        static_cast<ImGuiHost*>(self)->clipboard_.put(text);
    };
    io.GetClipboardTextFn = [](void* self) {
        auto& host = *static_cast<ImGuiHost*>(self);
        host.pasted_ = host.clipboard_.text();
        note_letters(host.pasted_);
        return host.pasted_.c_str();
    };
}

void ImGuiHost::set_theme(ThemeKind theme) {
    context_.theme = theme;
    context_.palette = palette_of(theme);
    apply_style(context_.palette, context_.scale);
}

void ImGuiHost::set_scale(float scale) {
    ImGui::GetIO().Fonts->Clear();
    context_.scale = scale;
    context_.letters = {};
    context_.fonts = load_fonts(scale);
    set_theme(context_.theme);
    make_letters();
}

void ImGuiHost::make_letters() {
    ImGui_ImplOpenGL3_DestroyFontsTexture();
    ImGui_ImplOpenGL3_CreateFontsTexture();
    changed_ = {};
}

bool ImGuiHost::begin_frame(const std::vector<KeyPress>& pressed, bool tab_moves) {
    for (const ImWchar typed : ImGui::GetIO().InputQueueCharacters) {
        std::array<char, 5> letter{};
        ImTextCharToUtf8(letter.data(), typed);
        note_letters(letter.data());
    }
    if (context_.letters.load(context_.fonts)) make_letters();
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    bool* down = ImGui::GetIO().KeysDown;
    const auto known = [](int key) { return key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown); };
    for (const KeyPress& press : pressed) {
        if (known(press.key)) down[press.key] = true;
    }
    ImGui::NewFrame();
    // Dear ImGui's WantTextInput alone holds for one frame after a field was left.
    const bool typing = ImGui::GetIO().WantTextInput && ImGui::IsAnyItemActive();
    int steps = 0;
    for (const KeyPress& press : pressed) {
        if (known(press.key)) down[press.key] = window_.key_down(press.key);
        const bool moves = press.key == GLFW_KEY_TAB && !press.control && (tab_moves || typing);
        if (moves) steps += press.shift ? -1 : 1;
    }
    begin_focus_frame(steps);
    return typing;
}

Result<Image> ImGuiHost::picture(int width, int height,
                                 const std::function<void(ImDrawList&)>& draw) {
    auto framebuffer = Framebuffer::create(width, height);
    if (!framebuffer) return framebuffer.error();
    ImDrawList list(ImGui::GetDrawListSharedData());
    list._ResetForNewFrame();
    list.PushTextureID(ImGui::GetIO().Fonts->TexID);
    const ImVec2 size = {static_cast<float>(width), static_cast<float>(height)};
    list.PushClipRect({0, 0}, size);
    draw(list);
    std::array<ImDrawList*, 1> lists = {&list};
    ImDrawData data;
    data.Valid = true;
    data.CmdLists = lists.data();
    data.CmdListsCount = 1;
    data.TotalIdxCount = list.IdxBuffer.Size;
    data.TotalVtxCount = list.VtxBuffer.Size;
    data.DisplaySize = size;
    data.FramebufferScale = {1, 1};
    framebuffer->bind();
    clear(context_.palette.panel, width, height);
    ImGui_ImplOpenGL3_RenderDrawData(&data);
    Image image = read_pixels(width, height);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    return image;
}

bool ImGuiHost::close_popup() {
    const int open = ImGui::GetCurrentContext()->OpenPopupStack.Size;
    if (open == 0) return false;
    ImGui::ClosePopupToLevel(open - 1, true);
    return true;
}

void ImGuiHost::end_frame() {
    ImGui::Render();
    const ImDrawData& data = *ImGui::GetDrawData();
    const Color& background = context_.palette.panel;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    if (!stamp_.found()) changed_ = {};
    for (const Rect& area : changed_.update(data, paint(background)))
        paint_area(data, area, background);
    stamp_.put(background);
    glFinish();
}

}  // namespace cambrian
