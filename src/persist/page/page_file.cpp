#include "persist/page/page_file.h"

#include "core/deflated_text.h"
#include "core/files/file_io.h"
#include "core/text/counted.h"
#include "core/text/number_text.h"
#include "evolution/evaluation/trials.h"
#include "evolution/fields/setting_field.h"
#include "genome/creature_name.h"
#include "persist/creature/page_document.h"
#include "persist/json/json_text.h"
#include "persist/page/described_creature.h"
#include "persist/text/digest_text.h"
#include "persist/text/quoted_text.h"
#include "persist/text/setting_value.h"
#include "persist/text/web_text.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace cambrian {
namespace {

constexpr std::size_t kMaxPart = 16'000'000;  // bytes of a part of a page
constexpr int kPackedLevel = 10;              // of the compression; a tenth of a second
constexpr std::uint64_t kTicksAFrame = 3;     // of a recorded motion
constexpr std::uint64_t kMostTicks = 1'200;   // that are recorded
constexpr double kRecordedRange = 32'000.0;   // of the numbers of a recorded motion
constexpr double kTravelled = 0.3;            // m; creatures that move less have no direction
constexpr std::size_t kMostCourse = 400;      // generations of a course that are drawn

// The motion of a trial at 20 Hz: places and attitudes of all parts.
struct Recording {
    // For each part in each frame its place and attitude, 3 and 4 numbers; in the plane only 2 and
    // 2, since the others are 0.
    std::vector<double> numbers;
    std::size_t places = 3;
    std::size_t turns = 4;
    double farthest = 1.0;  // m
    Vec3 travelled = Vec3::Zero();
};

Result<Recording> record(const CreatureDocument& document,
                         const std::shared_ptr<const Phenotype>& phenotype, const Kinds& kinds) {
    auto trial = Trial::start(phenotype, kinds, first_trial_world(document.settings()));
    if (!trial) return trial.error();
    const PhysicsScene& scene = (*trial)->scene();
    const Vec3 start = scene.center_of_mass();
    Recording made;
    if (document.settings().world.environment.dimensions == 2) made.places = made.turns = 2;
    for (bool more = true; more && (*trial)->ticks() < kMostTicks; more = (*trial)->tick()) {
        if ((*trial)->ticks() % kTicksAFrame != 0) continue;
        for (std::size_t part = 0; part < phenotype->parts.size(); ++part) {
            const Pose pose = scene.part_pose(part);
            for (std::size_t axis = 0; axis < made.places; ++axis) {
                const double place = pose.position[static_cast<Eigen::Index>(axis)];
                made.numbers.push_back(place);
                made.farthest = std::max(made.farthest, std::abs(place));
            }
            made.numbers.push_back(pose.orientation.w());
            for (std::size_t axis = 4 - made.turns; axis < 3; ++axis)
                made.numbers.push_back(pose.orientation.vec()[static_cast<Eigen::Index>(axis)]);
        }
    }
    made.travelled = scene.center_of_mass() - start;
    return made;
}

std::string little_endian(const Recording& recording, double unit) {
    std::string bytes;
    bytes.reserve(2 * recording.numbers.size());
    for (std::size_t i = 0; i < recording.numbers.size(); ++i) {
        const double scaled =
            recording.numbers[i] * (i % (recording.places + recording.turns) < recording.places
                                        ? 1.0 / unit
                                        : kRecordedRange);
        const auto number = static_cast<std::uint16_t>(static_cast<std::int16_t>(
            std::clamp(std::round(scaled), -kRecordedRange, kRecordedRange)));
        bytes += static_cast<char>(number & 0xffU);
        bytes += static_cast<char>(number >> 8U);
    }
    return bytes;
}

std::string written_way(const Vec3& travelled, bool ground) {
    const double length = std::hypot(travelled.x(), travelled.y());
    if (length < kTravelled) return "[1, 0]";
    if (ground) return travelled.x() < 0.0 ? "[-1, 0]" : "[1, 0]";
    return json_list({real_text(travelled.x() / length), real_text(travelled.y() / length)});
}

std::string facts_of(const CreatureDocument& document, std::size_t parts) {
    std::string facts = fmt::format("{}, {}", document.settings().goal, counted(parts, "part"));
    if (document.scored())
        facts += fmt::format("; {:.4g} {}", document.score(), document.notes.unit);
    return facts;
}

struct PlacedCreature {
    std::string id;       // of its element
    std::string element;  // with its file
    std::string entry;    // in the page's list
    std::string facts;
};

Result<PlacedCreature> place(const PageCreature& creature, std::size_t number,
                             const EvolutionKinds& kinds) {
    const CreatureDocument& document = creature.document;
    const auto phenotype = std::make_shared<const Phenotype>(
        express(document.genome(), kinds.creature, document.settings().expression,
                document.settings().world.scene));
    const Result<Recording> recording = record(document, phenotype, kinds.creature);
    if (!recording) return recording.error();
    const double unit = recording->farthest / kRecordedRange;
    PlacedCreature placed;
    placed.id = std::string(kCreatureElement);
    if (number > 0) placed.id += fmt::format("-{}", number + 1);
    placed.element = fmt::format("<script type=\"application/json\" id=\"{}\">{}</script>\n",
                                 placed.id, script_json(write_creature(document, kinds)));
    placed.facts = facts_of(document, phenotype->parts.size());
    const std::string recorded =
        json_object({{"unit", real_text(unit)},
                     {"way", written_way(recording->travelled,
                                         document.settings().world.environment.has_ground)},
                     {"told", described_creature(document, *phenotype, kinds)},
                     {"data", quoted_text(dense_text(little_endian(*recording, unit)))}});
    placed.entry = json_object(
        {{"id", quoted_text(placed.id)},
         {"label", quoted_text(creature.label)},
         {"generation", creature.generation ? std::to_string(*creature.generation) : "null"},
         {"facts", quoted_text(placed.facts)},
         {"recorded", recorded}});
    return placed;
}

std::string plain_text(const SettingValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return setting_text(value);
}

// All settings in lines KEY=VALUE, which the engine takes.
std::string setting_lines(const ExperimentSettings& settings, const EvolutionKinds& kinds) {
    std::string lines;
    for (const SettingField& field : setting_fields(kinds))
        lines += fmt::format("{}={}\n", path_of(field), plain_text(value_of(field, settings)));
    return lines;
}

std::string evolution_entry(const PageEvolution& evolution, const EvolutionKinds& kinds) {
    std::vector<std::string> digests;
    for (const std::uint64_t digest : evolution.digests)
        digests.push_back(quoted_text(digest_text(digest)));
    const ExperimentSettings& settings = evolution.settings;
    return json_object({{"settings", quoted_text(setting_lines(settings, kinds))},
                        {"label", quoted_text(settings.goal + ", as given")},
                        {"seed", std::to_string(settings.seed)},
                        {"size", std::to_string(settings.population.size)},
                        {"digests", json_list(digests)}});
}

std::string finite_number(double value) {
    return std::isfinite(value) ? real_text(value) : "null";
}

// The last generation is among those drawn.
std::string course_entry(const PageCourse& course) {
    const std::size_t count = course.history.size();
    const std::size_t step = std::max<std::size_t>(1, (count + kMostCourse - 1) / kMostCourse);
    std::vector<std::string> rows;
    for (std::size_t i = count == 0 ? 0 : (count - 1) % step; i < count; i += step) {
        const GenerationStatistics& row = course.history[i];
        rows.push_back(json_list(
            {std::to_string(row.generation), finite_number(row.best), finite_number(row.median)}));
    }
    return json_object({{"unit", quoted_text(course.unit)}, {"rows", json_list(rows)}});
}

// Fills the places {{name}} of a template.
std::string filled(std::string_view form,
                   const std::map<std::string, std::string, std::less<>>& parts) {
    std::string text;
    while (true) {
        const std::size_t begin = form.find("{{");
        const std::size_t end = begin == std::string_view::npos ? begin : form.find("}}", begin);
        if (end == std::string_view::npos) return text.append(form);
        text.append(form.substr(0, begin));
        const auto part = parts.find(form.substr(begin + 2, end - begin - 2));
        if (part == parts.end())
            text.append(form.substr(begin, end + 2 - begin));
        else
            text.append(part->second);
        form.remove_prefix(end + 2);
    }
}

Result<std::string> packed(const std::filesystem::path& path) {
    std::error_code missing;
    if (path.empty() || !std::filesystem::exists(path, missing)) return std::string();
    const Result<std::string> bytes = read_file(path, kMaxPart);
    if (!bytes) return bytes.error();
    Deflater deflater(kPackedLevel);
    return dense_text(deflater.deflate(*bytes));
}

}  // namespace

Result<std::string> make_page(const PageContent& content, const PageParts& parts,
                              const EvolutionKinds& kinds) {
    std::map<std::string, std::string, std::less<>> texts;
    for (const char* script :
         {"engine.js", "worker.js", "population.js", "body.js", "places.js", "page.js"}) {
        Result<std::string> text = read_file(parts.folder / script, kMaxPart);
        if (!text) return text.error();
        texts[script] = std::move(*text);
    }
    const Result<std::string> form = read_file(parts.folder / "page.html", kMaxPart);
    if (!form) return form.error();
    for (const auto& [name, path] :
         {std::pair("engine", parts.engine), std::pair("licences", parts.licences)}) {
        Result<std::string> text = packed(path);
        if (!text) return text.error();
        texts[name] = std::move(*text);
    }
    std::vector<std::string> entries;
    for (std::size_t i = 0; i < content.creatures.size(); ++i) {
        Result<PlacedCreature> placed = place(content.creatures[i], i, kinds);
        if (!placed) return placed.error();
        texts["creatures"] += placed->element;
        entries.push_back(placed->entry);
        if (i == 0) texts["facts"] = html_text(placed->facts);
    }
    texts["creatures"];
    texts["facts"];
    texts["title"] = html_text(content.title);
    texts["version"] = html_text(parts.version);
    texts["page"] = script_json(json_object(
        {{"creatures", json_list(entries)},
         {"course", content.course ? course_entry(*content.course) : "null"},
         {"evolve", content.evolution ? evolution_entry(*content.evolution, kinds) : "null"}}));
    return filled(*form, texts);
}

}  // namespace cambrian
