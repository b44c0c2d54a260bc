#include "pictures/canvas/typefaces.h"

#include <array>
#include <span>
#include <system_error>

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

}  // namespace

std::vector<std::filesystem::path> installed_files(Typeface typeface) {
    std::vector<std::filesystem::path> installed;
    for (const char* file : known_files(typeface)) {
        std::error_code unknown;
        if (std::filesystem::exists(file, unknown)) installed.emplace_back(file);
    }
    return installed;
}

}  // namespace cambrian
