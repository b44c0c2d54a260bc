#include "studio/look/foreign_letters.h"

#include "core/text/code_points.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace cambrian {
namespace {

constexpr std::size_t kMostLetters = 2000;  // bounds the size of the fonts' texture
constexpr int kFirstForeign = 0xA0;         // those before are in every font or are no letters

}  // namespace

void ForeignLetters::note(std::string_view text, const ImFont& font) {
    const bool plain = std::all_of(text.begin(), text.end(), [](char letter) {
        return static_cast<unsigned char>(letter) < 0x80;
    });
    if (plain) return;
    for (const int letter : code_points(text)) {
        if (letter < kFirstForeign || letter > IM_UNICODE_CODEPOINT_MAX) continue;
        if (font.FindGlyphNoFallback(static_cast<ImWchar>(letter)) != nullptr) continue;
        if (asked_.size() < kMostLetters && asked_.insert(letter).second) wanted_.push_back(letter);
    }
}

bool ForeignLetters::load(const Fonts& fonts) {
    if (search_.valid()) {
        if (search_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
        const Found found = search_.get();
        for (ImFont* font : {fonts.body, fonts.small, fonts.mono})
            add(found.regular, font);
        for (ImFont* font : {fonts.strong, fonts.title})
            add(found.strong, font);
        return !found.regular.empty() || !found.strong.empty();
    }
    if (wanted_.empty()) return false;
    search_ = std::async(std::launch::async, [letters = std::exchange(wanted_, {})] {
        return Found{files_with(letters, Typeface::kRegular),
                     files_with(letters, Typeface::kStrong)};
    });
    return false;
}

void ForeignLetters::add(const std::vector<LettersOfFile>& files, ImFont* font) {
    for (const LettersOfFile& each : files) {
        std::vector<ImWchar>& range = ranges_.emplace_back();
        for (const int letter : each.letters)
            range.insert(range.end(), 2, static_cast<ImWchar>(letter));
        range.push_back(0);
        ImFontConfig config = face_config();
        config.MergeMode = true;
        config.DstFont = font;
        config.FontNo = each.file.face;
        ImGui::GetIO().Fonts->AddFontFromFileTTF(each.file.path.c_str(), font->FontSize, &config,
                                                 range.data());
    }
}

}  // namespace cambrian
