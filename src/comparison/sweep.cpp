#include "comparison/sweep.h"

#include "persist/settings/typed_setting.h"

#include <fmt/core.h>

namespace cambrian {

Result<std::vector<NamedSettings>> swept_arms(const std::vector<NamedSettings>& arms,
                                              const std::string& key,
                                              const std::vector<std::string>& values,
                                              const EvolutionKinds& kinds) {
    std::vector<NamedSettings> all;
    for (const NamedSettings& arm : arms) {
        for (const std::string& value : values) {
            const std::string assignment = fmt::format("{}={}", key, value);
            Result<SettingsText> text = typed_setting(assignment, kinds);
            if (!text) return text.error();
            NamedSettings& one = all.emplace_back(arm);
            one.name = arms.size() == 1 ? assignment : fmt::format("{} {}", arm.name, assignment);
            one.texts.push_back(*std::move(text));
        }
    }
    return all;
}

}  // namespace cambrian
