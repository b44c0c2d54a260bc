#include "studio/panels/cards/file_panel.h"

#include "persist/creature/creature_card.h"
#include "persist/creature/page_document.h"
#include "studio/files/file_service.h"
#include "studio/files/typed_path.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstring>
#include <string>
#include <system_error>

namespace cambrian {
namespace {

constexpr float kCaptionWidth = 74.0F;
constexpr float kChoiceRow = 28.0F;

const char* title_of(FileTask task) {
    switch (task) {
        case FileTask::kOpen:
            return "Open a creature, a card, an experiment, a preserve or settings";
        case FileTask::kSaveCreature:
            return "Save the creature on display";
        case FileTask::kSaveClip:
            return "Save a clip of the creature on display";
        case FileTask::kSaveExperiment:
            return "Save the experiment";
        case FileTask::kSavePreserve:
            return "Keep the preserve in another file";
        case FileTask::kSaveSettings:
            break;
        case FileTask::kSaveStatistics:
            return "Export the statistics";
        case FileTask::kSavePlot:
            return "Export the plot";
        case FileTask::kSaveRunPage:
            return "Save a page of this run, for browsers";
        case FileTask::kSaveFilm:
            return "Save a film of this run";
        case FileTask::kSaveRace:
            return "Save a race of the starred creatures";
    }
    return "Save the settings";
}

struct ClipLength {
    const char* label;
    double seconds;
};
constexpr std::array kLengths = {ClipLength{"3 s", 3.0}, ClipLength{"5 s", 5.0},
                                 ClipLength{"10 s", 10.0}, ClipLength{"The whole trial", 86400.0}};
struct ClipSpeed {
    const char* label;
    double speed;
};
constexpr std::array kSpeeds = {ClipSpeed{"¼ ×", 0.25}, ClipSpeed{"½ ×", 0.5},
                                ClipSpeed{"1 ×", 1.0}, ClipSpeed{"2 ×", 2.0}};
struct ClipSize {
    const char* label;
    int width;  // pixels
    int height;
};
constexpr std::array kClipSizes = {ClipSize{"640 × 360", 640, 360}, ClipSize{"720p", 1280, 720},
                                   ClipSize{"1080p", 1920, 1080}};
constexpr std::array kCardSizes = {ClipSize{"480 × 640", 480, 640}, ClipSize{"600 × 800", 600, 800},
                                   ClipSize{"960 × 1280", 960, 1280}};

const std::array<ClipSize, 3>& sizes_of(const ClipKind& kind) {
    return kind.card ? kCardSizes : kClipSizes;
}

// Returns the place of a kind's usual size.
std::size_t usual_size_of(const ClipKind& kind) {
    if (kind.card) return 1;
    return kind.format->usual_width > kClipSizes[0].width ? 1 : 0;
}

template <class Line, std::size_t Count>
std::vector<std::string> clip_labels(const std::array<Line, Count>& lines) {
    std::vector<std::string> labels;
    for (const Line& line : lines)
        labels.emplace_back(line.label);
    return labels;
}

// Draws a caption and the choices beside it; returns whether one was pressed.
template <class Line, std::size_t Count>
bool choose_of_clip(const char* caption, const std::array<Line, Count>& lines,
                    std::size_t& chosen) {
    ImGui::AlignTextToFramePadding();
    muted_text(caption);
    ImGui::SameLine(px(kCaptionWidth));
    const int pressed = segmented(caption, clip_labels(lines), static_cast<int>(chosen));
    if (pressed >= 0) chosen = static_cast<std::size_t>(pressed);
    return pressed >= 0;
}

// Replaces the ending of a creature file, card or clip by another one.
std::string with_other_ending(std::string name, std::string_view ending) {
    std::vector<std::string_view> endings = {kCreatureEnding, kCardEnding, ".png", kPageEnding};
    for (const ClipKind& kind : clip_kinds())
        endings.push_back(kind.ending);
    for (const std::string_view known : endings) {
        if (!name.ends_with(known)) continue;
        name.resize(name.size() - known.size());
        break;
    }
    return name.append(ending);
}

bool is_of_creature(FileTask task) {
    return task == FileTask::kSaveCreature || task == FileTask::kSaveClip;
}

// Returns whether saving would replace another file. A preserve never replaces one.
bool would_replace(const FileBrowser& files, const std::filesystem::path& path) {
    if (files.task == FileTask::kOpen || files.task == FileTask::kSavePreserve) return false;
    std::error_code unknown;
    return std::filesystem::exists(path, unknown) &&
           !std::filesystem::equivalent(path, files.own_file, unknown);
}

// Returns why a kind of clip cannot be written for a task; empty if it can.
std::string missing_of(const ClipKind& kind, FileTask task) {
    if (kind.card && task != FileTask::kSaveClip) return "A card has one creature";
    return kind.format->missing();
}

// A line with an icon that can be clicked.
bool entry_line(const std::string& name, Icon icon, bool chosen) {
    const ImVec2 size = {ImGui::GetContentRegionAvail().x, px(30)};
    const bool pressed = ImGui::InvisibleButton(name.c_str(), size);
    note_place(name);
    const ImVec2 low = ImGui::GetItemRectMin();
    const ImVec2 high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const bool hovered = ImGui::IsItemHovered();
    if (hovered || chosen) {
        const Color back = chosen ? mix(colors().raised, colors().accent, 0.3F) : colors().hovered;
        list.AddRectFilled(low, high, paint(back), px(5));
    }
    const float middle = 0.5F * (low.y + high.y);
    draw_icon(list, icon, {low.x + px(16), middle}, px(14),
              icon == Icon::kFile ? colors().accent : colors().muted);
    list.AddText({low.x + px(34), middle - 0.5F * ImGui::GetFontSize()}, paint(colors().text),
                 fit_text(name, size.x - px(40)).c_str());
    return pressed;
}

}  // namespace

void FilePanel::draw(const FrameContext& frame, Requests& out) {
    const FileBrowser& files = frame.files.browser;
    if (opening_ != files.opened) {
        opening_ = files.opened;
        begin_name(files.suggested_name);
        missing_.clear();
        for (const ClipKind& kind : clip_kinds())
            missing_.push_back(missing_of(kind, files.task));
    }
    {
        const WithFont font(ui().fonts.title);
        ImGui::TextUnformatted(title_of(files.task));
    }
    draw_places(frame, out);
    const bool creature = is_of_creature(files.task);
    const bool clip = is_of_clips(files.task);
    const float foot = px(30) * 2 + px(34) + (creature ? px(50) : 0.0F) +
                       (clip ? 4.0F * px(kChoiceRow) + px(8) : 0.0F);
    ImGui::BeginChild("entries", {0, -foot}, false, ImGuiWindowFlags_NoBackground);
    draw_entries(frame, out);
    ImGui::EndChild();
    if (creature) draw_format(frame, out);
    if (clip) draw_clip_choices(files.task);
    draw_name(frame, out);
}

void FilePanel::draw_places(const FrameContext& frame, Requests& out) {
    const std::filesystem::path& folder = frame.files.browser.listing.folder;
    if (push_button("Up", {.icon = Icon::kUp, .label_shown = false, .tooltip = "The folder above"}))
        out.ask(ListFolder{folder.parent_path()});
    ImGui::SameLine();
    ImGui::AlignTextToFramePadding();
    const WithTextColor muted(colors().muted);
    ImGui::TextUnformatted(fit_text(folder.string(), ImGui::GetContentRegionAvail().x).c_str());
}

void FilePanel::draw_entries(const FrameContext& frame, Requests& out) {
    const FolderListing& listing = frame.files.browser.listing;
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(0, px(1)));
    if (!listing.problem.empty()) muted_text(listing.problem);
    for (const std::string& name : listing.folders) {
        if (entry_line(name, Icon::kFolder, false)) out.ask(ListFolder{listing.folder / name});
    }
    for (const std::string& name : listing.files) {
        const bool chosen = name == name_.data();
        if (!entry_line(name, Icon::kFile, chosen)) continue;
        const bool twice = ImGui::IsMouseDoubleClicked(ImGuiMouseButton_Left) || chosen;
        write_name(name);
        if (twice && frame.files.browser.task == FileTask::kOpen) confirm(frame, out);
    }
    if (listing.folders.empty() && listing.files.empty() && listing.problem.empty())
        muted_text("No folders and no files of this kind here.");
    ImGui::PopStyleVar();
}

// Shows which format the name's ending means, and offers the others.
void FilePanel::draw_format(const FrameContext& frame, Requests& out) {
    const std::string name = name_.data();
    const bool clip = frame.files.browser.task == FileTask::kSaveClip;
    const int present = clip ? 2 : is_page_path(name) ? 3 : is_card_name(name) ? 1 : 0;
    const int chosen = segmented(
        "format", {"Creature file", "Card", "Clip", "Page"}, present,
        {"*.creature.json: the creature as text, to be opened again or read by other programs",
         "*.card.png: a picture of the creature that carries all of it inside. Whoever gets the "
         "picture can drop it on the window.",
         "The creature in motion, to be shown anywhere",
         "*.html: a page on which the creature lives in any browser, without a network. It can be "
         "pulled there, and its score is computed again."});
    ImGui::Dummy({0, px(2)});
    if (chosen < 0 || chosen == present) return;
    constexpr std::array kEndings = {kCreatureEnding, kCardEnding, std::string_view(), kPageEnding};
    if (clip || chosen == 2)
        out.ask(OpenFilePanel{chosen == 2 ? FileTask::kSaveClip : FileTask::kSaveCreature});
    if (chosen == 2) return;
    write_name(with_other_ending(name, kEndings[static_cast<std::size_t>(chosen)]));
    focus_wanted_ = true;
}

// Shows which kind of clip the name's ending means, and all that can be chosen about it.
void FilePanel::draw_clip_choices(FileTask task) {
    const std::vector<ClipKind>& kinds = clip_kinds();
    const ClipKind* named = clip_kind_of(name_.data());
    const auto take = [&](std::size_t kind) {
        if (kind != clip_.kind) clip_.size = usual_size_of(kinds[kind]);
        clip_.kind = kind;
    };
    if (named != nullptr) take(static_cast<std::size_t>(named - kinds.data()));
    std::vector<std::string> labels;
    std::vector<std::string> words;
    std::vector<bool> possible;
    for (std::size_t i = 0; i < kinds.size(); ++i) {
        labels.push_back(kinds[i].label);
        words.push_back(missing_[i].empty() ? fmt::format("*{}", kinds[i].ending) : missing_[i]);
        possible.push_back(missing_[i].empty());
    }
    ImGui::AlignTextToFramePadding();
    muted_text("Kind");
    ImGui::SameLine(px(kCaptionWidth));
    const int pressed = segmented("Kind", labels, static_cast<int>(clip_.kind), words, possible);
    if (pressed >= 0) {
        take(static_cast<std::size_t>(pressed));
        write_name(with_other_ending(name_.data(), kinds[clip_.kind].ending));
        focus_wanted_ = true;
    }
    // The keyboard stays with the name.
    focus_wanted_ |= choose_of_clip("Length", kLengths, length_of(task));
    focus_wanted_ |= choose_of_clip("Speed", kSpeeds, clip_.speed);
    focus_wanted_ |= choose_of_clip("Size", sizes_of(kinds[clip_.kind]), clip_.size);
    ImGui::Dummy({0, px(2)});
}

std::size_t& FilePanel::length_of(FileTask task) {
    if (task == FileTask::kSaveFilm) return clip_.film_length;
    return task == FileTask::kSaveRace ? clip_.race_length : clip_.length;
}

ClipChoice FilePanel::clip_choice(FileTask task) {
    const ClipKind& kind = clip_kinds()[clip_.kind];
    const ClipSize& size = sizes_of(kind)[clip_.size];
    return {kind.format,
            kind.card,
            size.width,
            size.height,
            kLengths[length_of(task)].seconds,
            kSpeeds[clip_.speed].speed};
}

// Offers a name to type over.
void FilePanel::begin_name(const std::string& name) {
    write_name(name);
    warned_.clear();
    refused_.clear();
    focus_wanted_ = true;
}

void FilePanel::write_name(const std::string& name) {
    name_.fill('\0');
    name.copy(name_.data(), name_.size() - 1);
}

// Draws the caption of the name, why it was refused, or the warning that a file would be replaced.
void FilePanel::draw_caption(const TypedPath& typed) const {
    if (!refused_.empty() && refused_ == name_.data() && !typed.fault.empty()) {
        const WithTextColor danger(colors().danger);
        const WithFont font(ui().fonts.small);
        ImGui::TextUnformatted(fit_text(typed.fault, ImGui::GetContentRegionAvail().x).c_str());
        note_place("name refused");
        return;
    }
    const std::filesystem::path& path = typed.path;
    if (warned_.empty() || path != warned_) return caption("File name, or a path");
    constexpr const char* words = " exists. Press Save again to replace it.";
    const float room = ImGui::GetContentRegionAvail().x - ImGui::CalcTextSize(words).x;
    const WithTextColor danger(colors().danger);
    const WithFont font(ui().fonts.small);
    ImGui::TextUnformatted((fit_text(path.filename().string(), room) + words).c_str());
    note_place("replace warning");
}

void FilePanel::draw_name(const FrameContext& frame, Requests& out) {
    draw_caption(typed_path(frame.files.browser, name_.data()));
    if (focus_wanted_) ImGui::SetKeyboardFocusHere();
    focus_wanted_ = false;
    ImGui::SetNextItemWidth(ImGui::GetContentRegionAvail().x);
    const bool entered =
        ImGui::InputText("##name", name_.data(), name_.size(),
                         ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
    note_place("file name");
    focus_stop_for_text();
    const bool saving = frame.files.browser.task != FileTask::kOpen;
    const char* verb = saving ? "Save" : "Open";
    const bool named = name_[0] != '\0';
    ImGui::SetCursorPosX(ImGui::GetWindowContentRegionMax().x - px(90) * 2 - px(8));
    if (push_button("Cancel", {.width = px(90)})) out.ask(CloseFilePanel{});
    ImGui::SameLine();
    const bool pressed =
        push_button(verb, {.look = ButtonLook::kPrimary, .width = px(90), .enabled = named});
    if ((entered || pressed) && named) confirm(frame, out);
}

// Asks to save or open. A folder is entered instead, and a file that would be replaced needs a
// second Save.
void FilePanel::confirm(const FrameContext& frame, Requests& out) {
    const FileBrowser& files = frame.files.browser;
    if (is_of_clips(files.task) && name_[0] != '\0' && clip_kind_of(name_.data()) == nullptr)
        write_name(with_other_ending(name_.data(), clip_kinds()[clip_.kind].ending));
    const TypedPath typed = typed_path(files, name_.data());
    const std::filesystem::path& path = typed.path;
    if (!typed.fault.empty()) {
        refused_ = name_.data();
        focus_wanted_ = true;
        return;
    }
    if (typed.folder) {
        out.ask(ListFolder{path});
        return begin_name(files.suggested_name);
    }
    if (path != warned_ && would_replace(files, path)) {
        warned_ = path;
        focus_wanted_ = true;
        return;
    }
    const FileTask task = files.task;
    if (task == FileTask::kOpen) out.ask(LoadFile{path});
    if (task == FileTask::kSaveCreature) out.ask(SaveCreatureFile{path});
    if (task == FileTask::kSaveClip) out.ask(SaveClip{path, clip_choice(task)});
    if (task == FileTask::kSaveFilm) out.ask(SaveFilm{path, clip_choice(task)});
    if (task == FileTask::kSaveRace) out.ask(SaveRace{path, clip_choice(task)});
    if (task == FileTask::kSaveExperiment) out.ask(SaveExperimentFile{path});
    if (task == FileTask::kSavePreserve) out.ask(SavePreserveFile{path});
    if (task == FileTask::kSaveSettings) out.ask(SaveSettingsFile{path});
    if (task == FileTask::kSaveStatistics) out.ask(SaveStatisticsFile{path});
    if (task == FileTask::kSaveRunPage) out.ask(SaveRunPage{path});
    if (task == FileTask::kSavePlot) out.ask(SavePlotPicture{path, files.picture});
    out.ask(CloseFilePanel{});
}

}  // namespace cambrian
