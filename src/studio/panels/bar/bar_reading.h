#pragma once

#include <imgui.h>

#include <string>

namespace cambrian {

// Draws a number with its name below it; returns the width used.
float draw_reading(const ImVec2& at, const std::string& value, const std::string& name);

}  // namespace cambrian
