#include "pictures/canvas/typefaces.h"

#include "pictures/canvas/text_rasterizer.h"

#include <algorithm>
#include <array>
#include <fontconfig/fontconfig.h>
#include <memory>
#include <span>
#include <string_view>
#include <system_error>
#include <utility>

namespace cambrian {
namespace {

constexpr std::array kRegularFaces = {
    "/usr/share/fonts/opentype/inter/Inter-Regular.otf",
    "/usr/share/fonts/truetype/inter/Inter-Regular.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Regular.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
};
constexpr std::array kStrongFaces = {
    "/usr/share/fonts/opentype/inter/Inter-SemiBold.otf",
    "/usr/share/fonts/truetype/inter/Inter-SemiBold.ttf",
    "/usr/share/fonts/truetype/roboto/unhinted/RobotoTTF/Roboto-Medium.ttf",
    "/usr/share/fonts/truetype/dejavu/DejaVuSans-Bold.ttf",
};
constexpr std::array kMonoFaces = {
    "/usr/share/fonts/truetype/dejavu/DejaVuSansMono.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationMono-Regular.ttf",
};

std::span<const char* const> known_files(Typeface typeface) {
    switch (typeface) {
        case Typeface::kStrong:
            return kStrongFaces;
        case Typeface::kMono:
            return kMonoFaces;
        case Typeface::kRegular:
            break;
    }
    return kRegularFaces;
}

struct Release {
    void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
    void operator()(FcFontSet* fonts) const { FcFontSetDestroy(fonts); }
};

// Returns what a font should be like, best first.
std::unique_ptr<FcPattern, Release> pattern_of(Typeface typeface) {
    std::unique_ptr<FcPattern, Release> pattern(FcPatternCreate());
    const char* family = typeface == Typeface::kMono ? "monospace" : "Inter";
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>(family));
    FcPatternAddString(pattern.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
    FcPatternAddInteger(pattern.get(), FC_WEIGHT,
                        typeface == Typeface::kStrong ? FC_WEIGHT_DEMIBOLD : FC_WEIGHT_REGULAR);
    FcPatternAddBool(pattern.get(), FC_SCALABLE, FcTrue);
    FcConfigSubstitute(nullptr, pattern.get(), FcMatchPattern);
    FcDefaultSubstitute(pattern.get());
    return pattern;
}

// Returns whether our rasterizer can draw the font's outlines.
bool has_usable_outlines(FcPattern* font) {
    FcBool outlines = FcFalse;
    FcBool variable = FcFalse;
    FcChar8* format = nullptr;
    FcPatternGetBool(font, FC_OUTLINE, 0, &outlines);
    FcPatternGetBool(font, FC_VARIABLE, 0, &variable);
    if (FcPatternGetString(font, FC_FONTFORMAT, 0, &format) != FcResultMatch) return false;
    const std::string_view name(reinterpret_cast<const char*>(format));
    return outlines == FcTrue && (name == "TrueType" || (name == "CFF" && variable == FcFalse));
}

// Moves the letters that a font has out of `letters`.
LettersOfFile take_letters(FcPattern* font, std::vector<int>& letters) {
    FcChar8* file = nullptr;
    FcCharSet* has = nullptr;
    int index = 0;
    LettersOfFile taken;
    if (!has_usable_outlines(font) ||
        FcPatternGetString(font, FC_FILE, 0, &file) != FcResultMatch ||
        FcPatternGetCharSet(font, FC_CHARSET, 0, &has) != FcResultMatch)
        return taken;
    FcPatternGetInteger(font, FC_INDEX, 0, &index);
    constexpr int face_bits = 0xFFFF;  // the others number instances of a variable font
    taken.file = {reinterpret_cast<const char*>(file), index & face_bits};
    std::erase_if(letters, [&](int letter) {
        const bool found = FcCharSetHasChar(has, static_cast<FcChar32>(letter)) == FcTrue;
        if (found) taken.letters.push_back(letter);
        return found;
    });
    return taken;
}

}  // namespace

std::vector<LettersOfFile> files_with(const std::vector<int>& letters, Typeface typeface) {
    std::vector<LettersOfFile> files;
    if (FcInit() != FcTrue) return files;
    FcResult result = FcResultNoMatch;
    const std::unique_ptr<FcFontSet, Release> fonts(
        FcFontSort(nullptr, pattern_of(typeface).get(), FcTrue, nullptr, &result));
    if (!fonts) return files;
    std::vector<int> missing = letters;
    for (int i = 0; i < fonts->nfont && !missing.empty(); ++i) {
        LettersOfFile taken = take_letters(fonts->fonts[i], missing);
        if (!taken.letters.empty() && TextRasterizer::can_read(taken.file)) {
            files.push_back(std::move(taken));
        } else {
            missing.insert(missing.end(), taken.letters.begin(), taken.letters.end());
        }
    }
    return files;
}

std::vector<std::filesystem::path> installed_files(Typeface typeface) {
    std::vector<std::filesystem::path> installed;
    for (const char* file : known_files(typeface)) {
        std::error_code unknown;
        if (std::filesystem::exists(file, unknown)) installed.emplace_back(file);
    }
    return installed;
}

}  // namespace cambrian
