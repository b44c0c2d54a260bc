#pragma once

#include "studio/experiment/setting_presets.h"
#include "studio/frame/frame_context.h"

#include <string>
#include <utility>

namespace cambrian {

// Asks for the draft settings with a preset's values.
inline void ask_preset(const SettingPreset& preset, const FrameContext& frame, Requests& out) {
    ExperimentSettings edited = frame.experiment.editor.draft();
    preset.apply(edited, frame.kinds);
    out.ask(EditSettings{std::move(edited), std::string(preset.table)});
    out.ask(FinishEdit{});
}

}  // namespace cambrian
