#include "studio/panels/machines/machines_panel.h"

#include "core/text/pretty_text.h"
#include "studio/files/typed_path.h"
#include "studio/machines/machine_words.h"
#include "studio/panels/cards/card_title.h"
#include "studio/widgets/keyboard_focus.h"
#include "studio/widgets/widgets.h"

#include <fmt/core.h>

#include <cmath>
#include <string>

namespace cambrian {
namespace {

constexpr const char* kHelpPage = "several_machines";

struct Field {
    const char* label;
    const char* hint;
    const char* help;
    std::string ClusterLogin::*place;
};
constexpr std::array kFields = {
    Field{"Server", "nats://lab-server",
          "Where the NATS server runs: nats://host, or tls://host with encryption. Several hosts, "
          "separated by commas, are one server cluster.",
          &ClusterLogin::servers},
    Field{"Cluster name", kStandardClusterName,
          "Workers and runs of the same name find each other; several names share one server.",
          &ClusterLogin::name},
    Field{"Credentials file", "none",
          "The file of the coordinator's role, if the server asks for one.",
          &ClusterLogin::credentials},
    Field{"Certificate authority", "the system's",
          "The authority's certificate file for tls://, if it is not the system's.",
          &ClusterLogin::authority},
};

void draw_state(const MachinesView& machines) {
    const bool bad = cluster_wanted(machines) && troubled(machines);
    const WithTextColor color(bad ? colors().danger : colors().muted);
    ImGui::PushTextWrapPos(0.0F);
    ImGui::TextUnformatted(cluster_wanted(machines)
                               ? machines_words(machines).c_str()
                               : "Working alone: this machine's cores do everything.");
    ImGui::PopTextWrapPos();
    note_place("machines state");
}

struct Column {
    const char* title;
    const char* help;
    float width;  // in units of 1/96 inch; 0 takes the remaining width
    bool number;  // column of numbers, aligned at the right
    std::string (*text)(const WorkerStatus& worker);
};

std::string name_words(const WorkerStatus& worker) {
    return worker.id.empty() ? "This machine" : worker.name;
}

std::string share_words(const WorkerStatus& worker) {
    return pretty_number(std::round(100.0 * worker.share)) + " %";
}

const std::array kColumns = {
    Column{"Machine", "The name of the worker, which is the host's by default", 0, false,
           name_words},
    Column{"Cores", "The number of cores that evaluate", 64, true,
           [](const WorkerStatus& worker) { return pretty_number(worker.cores); }},
    Column{"State", "The present state of the worker", 244, false, state_words},
    Column{"Creatures/s", "The rate of evaluation in the last seconds", 104, true,
           [](const WorkerStatus& worker) {
               return pretty_number(std::round(worker.creatures_per_second));
           }},
    Column{"Share", "The share of the work of the last minute", 68, true, share_words},
    Column{"Checks", "The number of creatures that another machine evaluated with the same bits",
           76, true,
           [](const WorkerStatus& worker) {
               return pretty_number(static_cast<double>(worker.checks_passed));
           }},
};

// Begins a cell of a table. Numbers are aligned at the right, with a gap to the next column.
void begin_cell(const Column& column, const std::string& text) {
    ImGui::TableNextColumn();
    if (!column.number) return;
    const float free =
        ImGui::GetContentRegionAvail().x - px(18) - ImGui::CalcTextSize(text.c_str()).x;
    ImGui::SetCursorPosX(ImGui::GetCursorPosX() + std::fmax(0.0F, free));
}

void draw_row(const WorkerStatus& worker) {
    ImGui::TableNextRow();
    const bool bad = worker.state == WorkerState::kAway || worker.state == WorkerState::kRefused;
    for (const Column& column : kColumns) {
        const std::string text = column.text(worker);
        begin_cell(column, text);
        const std::string shown = fit_text(text, ImGui::GetContentRegionAvail().x);
        const bool state = column.text == state_words;
        const WithTextColor color(state && bad ? colors().danger : colors().text);
        ImGui::TextUnformatted(shown.c_str());
        if (shown != text) tooltip(text);
    }
    note_place("machine " + worker.name);
}

void draw_table(const BackendStatus& status) {
    constexpr ImGuiTableFlags flags = ImGuiTableFlags_ScrollY | ImGuiTableFlags_BordersInnerH;
    if (!ImGui::BeginTable("machines", static_cast<int>(kColumns.size()), flags)) return;
    ImGui::TableSetupScrollFreeze(0, 1);
    for (const Column& column : kColumns)
        set_up_column(column.title, column.width);
    ImGui::TableNextRow();
    {
        const WithFont font(ui().fonts.small);
        const WithTextColor color(colors().muted);
        for (const Column& column : kColumns) {
            begin_cell(column, column.title);
            ImGui::TextUnformatted(column.title);
            tooltip(column.help);
        }
    }
    ImGuiListClipper clipper;
    clipper.Begin(static_cast<int>(status.workers.size()));
    while (clipper.Step()) {
        for (int i = clipper.DisplayStart; i < clipper.DisplayEnd; ++i)
            draw_row(status.workers[static_cast<std::size_t>(i)]);
    }
    ImGui::EndTable();
}

std::string counts_words(const BackendStatus& status) {
    const BackendCounts& counts = status.counts;
    const auto number = [](std::uint64_t count) {
        return pretty_number(static_cast<double>(count));
    };
    return fmt::format(
        "{} units handed out, {} more than once, {} overdue done here · {} creatures checked · {} "
        "results refused · {} unreadable messages",
        number(counts.units), number(counts.redelivered), number(counts.overdue_at_home),
        number(counts.checked), number(counts.refused), number(counts.malformed));
}

}  // namespace

void MachinesPanel::show(const ClusterLogin& login) {
    shown_ = login;
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        texts_[i].fill('\0');
        (login.*kFields[i].place).copy(texts_[i].data(), kLongest - 1);
    }
}

ClusterLogin MachinesPanel::typed() const {
    ClusterLogin login;
    for (std::size_t i = 0; i < kFields.size(); ++i)
        login.*kFields[i].place = texts_[i].data();
    login.credentials = with_home(login.credentials).string();
    login.authority = with_home(login.authority).string();
    return login;
}

void MachinesPanel::draw(const FrameContext& frame, Requests& out) {
    if (frame.machines == nullptr) return;
    const MachinesView& machines = *frame.machines;
    const bool opened = ImGui::GetFrameCount() != drawn_ + 1;
    drawn_ = ImGui::GetFrameCount();
    if (opened || machines.login != shown_) show(machines.login);
    if (card_title("Several machines", "Close machines", kHelpPage, out)) out.ask(ToggleMachines{});
    muted_text(
        "Machines that run “cambrian worker” evaluate for this run, beside this one. Which machine "
        "computes a creature changes nothing about it.");
    ImGui::Dummy({0, px(2)});
    draw_fields(machines, out);
    ImGui::Dummy({0, px(2)});
    draw_state(machines);
    section("Members of the cluster");
    const float foot = machines.joined ? ImGui::GetTextLineHeightWithSpacing() : 0.0F;
    ImGui::BeginChild("table", {0, -foot}, false, ImGuiWindowFlags_NoBackground);
    draw_table(machines.status);
    ImGui::EndChild();
    if (machines.joined) caption(counts_words(machines.status));
}

void MachinesPanel::draw_fields(const MachinesView& machines, Requests& out) {
    const float gap = px(12);
    const float width = 0.5F * (ImGui::GetContentRegionAvail().x - gap);
    bool entered = false;
    ImVec2 row;  // position of the row
    for (std::size_t i = 0; i < kFields.size(); ++i) {
        if (i % 2 == 0) {
            row = ImGui::GetCursorPos();
        } else {
            ImGui::SetCursorPos({row.x + width + gap, row.y});
        }
        ImGui::BeginGroup();
        caption(kFields[i].label);
        ImGui::SetNextItemWidth(width);
        ImGui::PushID(kFields[i].label);
        entered |= ImGui::InputTextWithHint("##field", kFields[i].hint, texts_[i].data(), kLongest,
                                            ImGuiInputTextFlags_EnterReturnsTrue);
        ImGui::PopID();
        note_place(kFields[i].label);
        focus_stop_for_text();
        tooltip(kFields[i].help);
        ImGui::EndGroup();
    }
    ImGui::Dummy({0, px(2)});
    const bool ready = texts_[0][0] != '\0' && !machines.joining;
    const bool pressed = push_button(
        "Connect", {.look = ButtonLook::kPrimary,
                    .width = px(118),
                    .enabled = ready,
                    .tooltip = "Evaluates on these machines from now on; no result changes"});
    ImGui::SameLine();
    if (push_button("Work alone", {.width = px(118),
                                   .enabled = cluster_wanted(machines),
                                   .tooltip = "Evaluates on this machine only from now on"}))
        out.ask(LeaveCluster{});
    if (ready && (pressed || entered)) out.ask(JoinCluster{typed()});
}

}  // namespace cambrian
