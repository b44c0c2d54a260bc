#pragma once

#include "studio/frame/panel.h"

namespace cambrian {

// Every panel of the window, in the order in which they are drawn; cards come last.
std::span<const PanelKind> builtin_panels();

}  // namespace cambrian
