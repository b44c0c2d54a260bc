#include "evolution/fields/setting_words.h"

#include "core/text/pretty_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>

namespace cambrian {
namespace {

// clang-format off
constexpr std::array kSettingWords = {
    SettingWords{"run.seed", "Dice", "The same number gives the same evolution again."},
    SettingWords{"run.stop-hopeless", "Giving up early", ""},
    SettingWords{"goal.behavior", "Goal", "What creatures are selected for."},
    SettingWords{"environment", "World", "Where creatures live. Choosing one sets gravity, ground, grip and medium."},
    SettingWords{"environment.gravity", "", "How strongly everything falls. The Moon has a sixth of the Earth's, a swimmers' tank none."},
    SettingWords{"environment.gravity-direction", "Where down is", ""},
    SettingWords{"environment.friction", "Grip", "How well parts hold on the ground and on each other. Ice has 0.05, rubber 1."},
    SettingWords{"environment.elasticity", "Bounciness", "The share of its speed that a part keeps when it bounces. Clay has 0, a hard ball 0.9."},
    SettingWords{"environment.viscosity-linear", "Syrup thickness", "How strongly a medium like syrup slows a part: at twice the speed, twice as much. This is its viscosity."},
    SettingWords{"environment.viscosity-quadratic", "Water thickness", "How strongly a medium like water or air slows a part: at twice the speed, four times as much."},
    SettingWords{"environment.density", "Heaviness", ""},
    SettingWords{"simulation.integrator", "Way of computing", ""},
    SettingWords{"simulation.tolerance", "Exactness", ""},
    SettingWords{"simulation.target-smoothing", "Calmness", ""},
    SettingWords{"simulation.motor-speed-limit", "Quickness", ""},
    SettingWords{"simulation.motor-frequency", "Stiffness", ""},
    SettingWords{"trial.duration", "Time to perform", ""},
    SettingWords{"trial.trials", "Tries", ""},
    SettingWords{"trial.friction-jitter", "Changing grip", ""},
    SettingWords{"trial.tilt-jitter", "Tilted starts", ""},
    SettingWords{"population.size", "Creatures", "How many creatures live in a generation. More of them find more, and take longer."},
    SettingWords{"population.immigrants", "Newcomers", ""},
    SettingWords{"population.museum", "", "The share of the first creatures that come from your museum, the best of your earlier runs. The others are random."},
    SettingWords{"population.tuned", "Slight copies", ""},
    SettingWords{"selection.method", "Who breeds", ""},
    SettingWords{"selection.survival", "Share that lives on", ""},
    SettingWords{"mutation.rate", "Changes", "How much children differ from their parents. At 1, three of four have a change; at 0, none."},
    SettingWords{"body.max-parts", "Body parts", ""},
    SettingWords{"body.symmetric-share", "Mirrored limbs", ""},
};
// clang-format on

}  // namespace

std::span<const SettingWords> all_setting_words() {
    return kSettingWords;
}

const SettingWords* setting_words(std::string_view path) {
    const auto found = std::find_if(kSettingWords.begin(), kSettingWords.end(),
                                    [&](const SettingWords& each) { return each.path == path; });
    return found == kSettingWords.end() ? nullptr : &*found;
}

std::string plain_label(const SettingField& field) {
    const SettingWords* words = setting_words(path_of(field));
    if (words == nullptr || words->word.empty()) return field.label;
    return fmt::format("{} ({})", words->word, uncapitalized(field.label));
}

std::string plain_help(const SettingField& field) {
    const SettingWords* words = setting_words(path_of(field));
    return words == nullptr || words->hint.empty() ? field.help : std::string(words->hint);
}

std::string words_text(const std::vector<SettingField>& fields) {
    std::string text =
        "# Settings in plain words\n\nThe plain panel and the command palette name these settings "
        "by a word that everybody knows, with the term of the field beside it.\n\n"
        "| word | term | what it does |\n|---|---|---|\n";
    for (const SettingField& field : fields) {
        const SettingWords* words = setting_words(path_of(field));
        if (words != nullptr && !words->word.empty())
            text += fmt::format("| {} | {} | {} |\n", words->word, field.label, plain_help(field));
    }
    return text;
}

}  // namespace cambrian
