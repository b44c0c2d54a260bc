#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Returns every kind of panel, in the order of drawing; cards come last.
std::span<const PanelKind> builtin_panels();

}  // namespace cambrian
