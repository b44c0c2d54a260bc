#include "studio/imgui_host.h"

#include "render/gl.h"
#include "studio/window.h"

#include <backends/imgui_impl_glfw.h>
#include <backends/imgui_impl_opengl3.h>

namespace cambrian {

ImGuiHost::ImGuiHost(Window& window, float scale, ThemeKind theme) : window_(window) {
    ImGui::CreateContext();
    ImGuiIO& io = ImGui::GetIO();
    io.UserData = &context_;
    io.IniFilename = nullptr;  // the studio remembers its arrangement itself
    io.ConfigWindowsMoveFromTitleBarOnly = true;
    context_.scale = scale;
    context_.fonts = load_fonts(scale);
    set_theme(theme);
    ImGui_ImplGlfw_InitForOpenGL(window.handle(), true);
    ImGui_ImplOpenGL3_Init("#version 330 core");
}

ImGuiHost::~ImGuiHost() {
    ImGui_ImplOpenGL3_Shutdown();
    ImGui_ImplGlfw_Shutdown();
    ImGui::DestroyContext();
}

void ImGuiHost::set_theme(ThemeKind theme) {
    context_.theme = theme;
    context_.palette = palette_of(theme);
    apply_style(context_.palette, context_.scale);
}

void ImGuiHost::begin_frame(const std::vector<KeyPress>& pressed) {
    ImGui_ImplOpenGL3_NewFrame();
    ImGui_ImplGlfw_NewFrame();
    bool* down = ImGui::GetIO().KeysDown;
    const auto known = [](int key) { return key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown); };
    for (const KeyPress& press : pressed) {
        if (known(press.key)) down[press.key] = true;
    }
    ImGui::NewFrame();
    for (const KeyPress& press : pressed) {
        if (known(press.key)) down[press.key] = window_.key_down(press.key);
    }
}

void ImGuiHost::end_frame(int width, int height) {
    ImGui::Render();
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, width, height);
    glDisable(GL_SCISSOR_TEST);
    const Color& back = context_.palette.panel;
    glClearColor(back.r, back.g, back.b, 1.0F);
    glClear(GL_COLOR_BUFFER_BIT);
    ImGui_ImplOpenGL3_RenderDrawData(ImGui::GetDrawData());
}

}  // namespace cambrian
