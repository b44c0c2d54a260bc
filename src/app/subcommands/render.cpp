#include "app/command_line/number_checks.h"
#include "app/command_line/option_types.h"
#include "app/command_line/output_path.h"
#include "app/command_line/picture_size.h"
#include "app/page/page_making.h"
#include "app/preserve/preserve_drawing.h"
#include "app/process/long_work.h"
#include "app/process/messages.h"
#include "app/subcommands/subcommands.h"
#include "app/trial/creature_world.h"
#include "app/trial/score_notice.h"
#include "core/files/file_io.h"
#include "core/text/number_text.h"
#include "core/text/pretty_text.h"
#include "persist/creature/creature_card.h"
#include "persist/creature/png_file.h"
#include "pictures/card_picture.h"
#include "pictures/clip.h"
#include "pictures/sheet.h"
#include "pictures/workshop.h"

#include <CLI/CLI.hpp>
#include <fmt/core.h>

#include <algorithm>
#include <optional>

namespace cambrian {
namespace {

constexpr int kUsualPoses = 12;
constexpr double kMostPreserveSeconds = 1e8;

struct RenderOptions {
    std::string creature;
    std::string out;
    std::string environment;
    std::string size;  // "WIDTHxHEIGHT"
    std::string theme = "dark";
    std::optional<int> poses;
    std::optional<double> frames_a_second;
    std::optional<double> speed;
    std::optional<double> seconds;
    std::optional<double> from;
    std::optional<double> to;
    std::optional<int> trial;
    bool card = false;
    bool animated = false;
    bool dithered = false;
};

// Returns whether an option is given that only pictures and clips have.
bool has_options_of_drawings(const RenderOptions& options) {
    const bool numbered = options.poses || options.frames_a_second || options.speed ||
                          options.seconds || options.from || options.to || options.trial;
    const bool flagged = options.card || options.animated || options.dithered;
    return numbered || flagged || !options.environment.empty() || !options.size.empty() ||
           options.theme != "dark";
}

enum class ProductKind : unsigned char { kSheet, kCard, kClip };

struct Product {
    ProductKind kind = ProductKind::kSheet;
    const ClipFormat* format = nullptr;  // null unless pictures move: a clip or a moving card

    bool is_card() const { return kind == ProductKind::kCard; }
};

Result<Product> product_of(const RenderOptions& options) {
    const std::filesystem::path out = options.out;
    if (const ClipFormat* format = clip_format_of(out)) {
        if (options.card || options.animated)
            return Error{options.out + ": a card is a picture, expected *.png"};
        return Product{ProductKind::kClip, format};
    }
    if (out.extension() != ".png")
        return Error{options.out +
                     ": expected a name that ends in .png, .mp4, .gif, .apng or .html"};
    if (options.card || options.out.ends_with(kCardEnding))
        return Product{ProductKind::kCard, options.animated ? &card_format() : nullptr};
    if (options.animated) return Error{options.out + ": --animated is for cards (*.card.png)"};
    return Product{};
}

PictureSides usual_size(const Product& product) {
    if (product.kind == ProductKind::kSheet) return {1600, 900};
    if (product.kind == ProductKind::kClip)
        return {product.format->usual_width, product.format->usual_height};
    if (product.format != nullptr) return {kMovingCardWidth, kMovingCardHeight};
    return {kCardWidth, kCardHeight};
}

double usual_rate(const Product& product) {
    return product.format == nullptr ? ClipTiming().frames_a_second : product.format->usual_rate;
}

// Rejects options that have no meaning for the requested product.
Status check_options(const RenderOptions& options, const Product& product) {
    const bool timed = options.frames_a_second || options.speed || options.seconds;
    if (product.format == nullptr && timed) {
        return Error{options.out +
                     ": --fps, --speed and --seconds are for clips (*.mp4, *.gif, *.apng) and "
                     "cards with --animated"};
    }
    if (options.dithered && (product.format == nullptr || !product.format->few_colors))
        return Error{options.out +
                     ": --dither is for clips of few colors (*.gif, *.apng) and cards "
                     "with --animated"};
    const PictureSides size = parse_picture_size(options.size).value_or(usual_size(product));
    if (product.format != nullptr) {
        const double rate = options.frames_a_second.value_or(usual_rate(product));
        Status possible = check_clip(*product.format, options.out, size.width, size.height, rate);
        if (!possible) return possible;
    }
    if (product.kind != ProductKind::kSheet && options.poses)
        return Error{options.out + ": --poses is for sheets (*.png)"};
    if (product.is_card() && !options.environment.empty())
        return Error{options.out +
                     ": a card shows the trial its creature was scored in; leave "
                     "--environment away"};
    return {};
}

// Rejects options that have no meaning for a preserve.
Status check_preserve_options(const RenderOptions& options, const Product& product) {
    if (product.is_card()) return Error{options.creature + ": a preserve has no card"};
    if (options.poses || options.seconds || options.trial || !options.environment.empty())
        return Error{
            options.creature +
            ": --poses, --seconds, --trial and --environment are for creatures; a preserve's times "
            "are --from and --to"};
    if (product.format == nullptr && options.to)
        return Error{options.out + ": --to is for clips (*.mp4, *.gif, *.apng)"};
    return {};
}

class RenderSubcommand final : public Subcommand {
public:
    void add_options(CLI::App& app) override {
        app.add_option("creature", options_.creature,
                       "Creature file (*.creature.json), card (*.card.png), preserve file "
                       "(*.cambrian) or, for a page, experiment file (*.cambrian)")
            ->type_name(option_type::kCreatureOrExperiment)
            ->required();
        app.add_option("-o,--out", options_.out,
                       "File to write: a sheet of poses or a picture of a preserve (*.png), a clip "
                       "(*.gif; *.mp4, which needs ffmpeg; *.apng, which contains the creature), "
                       "a card that contains the creature (*.card.png) or a page (*.html), as "
                       "`cambrian page` makes it")
            ->type_name(option_type::kDrawing)
            ->required();
        app.add_flag("--card", options_.card,
                     "Card instead of a sheet, also if the name does not end in .card.png");
        app.add_flag("--animated", options_.animated, "Card on which the creature moves");
        app.add_flag("--dither", options_.dithered,
                     "Mix colors where a GIF or a moving card has too few; about twice as large");
        app.add_option("--size", options_.size,
                       "Size in pixels, each side 64 to 4096; 1600x900 for a picture, 1280x720 for "
                       "an MP4, 640x360 for other clips, 960x1280 for a card and 600x800 for one "
                       "that moves by default")
            ->type_name("WIDTHxHEIGHT")
            ->check(check_picture_size);
        app.add_option("--theme", options_.theme, "Theme of the colors")
            ->check(CLI::IsMember({"dark", "light"}))
            ->capture_default_str();
        take_whole(*app.add_option("--poses", options_.poses, "Number of poses of a sheet")
                        ->default_str(std::to_string(kUsualPoses)),
                   1, kMostPoses);
        take_real(*app.add_option("--fps", options_.frames_a_second,
                                  "Frames per second of a clip; 30 for an MP4 and 20 for others by "
                                  "default"),
                  1.0, 120.0);
        take_real(*app.add_option("--speed", options_.speed,
                                  "Speed of a clip, as a multiple of real time")
                       ->default_str(short_text(ClipTiming().speed)),
                  0.05, 20.0);
        take_real(*app.add_option("--seconds", options_.seconds,
                                  "Duration, in seconds from the start of the trial, of what a "
                                  "clip shows; the complete trial by default, 4 on a moving card"),
                  0.01, 86400.0);
        take_real(
            *app.add_option("--from", options_.from,
                            "Time of a preserve, in seconds, that a picture shows or at which "
                            "a clip begins; by default a picture shows the last one kept and "
                            "a clip the last minute"),
            0.0, kMostPreserveSeconds);
        take_real(*app.add_option("--to", options_.to,
                                  "Time of a preserve, in seconds, at which a clip ends"),
                  0.0, kMostPreserveSeconds);
        take_whole(*app.add_option("--trial", options_.trial,
                                   "Number of the trial to show, of those that a score combines; "
                                   "the first by default"),
                   1, 50);
        app.add_option(
               "-e,--environment", options_.environment,
               "Settings file whose environment and goal are used instead of the creature's own")
            ->type_name(option_type::kSettings);
    }

    CommandFiles files() const override {
        return CommandFiles()
            .reads(options_.creature)
            .reads(options_.environment)
            .writes(options_.out, output_form::kDrawing);
    }
    bool works_in_space() const override { return true; }
    ExitStatus run(const EvolutionKinds& kinds) override {
        if (is_page_name(options_.out)) return render_page(kinds);
        const Result<Product> product = product_of(options_);
        if (!product) return fail(product.error());
        if (const Status usable = check_options(options_, *product); !usable)
            return fail(usable.error());
        if (is_experiment_name(options_.creature)) return render_preserve(*product, kinds);
        if (options_.from || options_.to)
            return fail({options_.creature + ": --from and --to are for preserves (*.cambrian)"});
        const Result<std::string> text = read_creature_text(options_.creature);
        if (!text) return fail(text.error());
        const auto document = parse_creature(*text, options_.creature, kinds);
        if (!document) return fail(document.error());
        say_of(options_.creature, document->warnings);
        say_of_simulator(options_.creature, *document);
        const auto settings = world_of(*document, options_.environment, kinds);
        if (!settings) return fail(settings.error());
        const auto path = output_path(options_.out, "", files());
        if (!path) return fail(path.error());
        LongWork work;
        work.begin("simulating", settings->world.trial.duration);
        if (const Status known = check_trial(options_.trial, options_.creature, *settings); !known)
            return fail(known.error());
        const auto subject = subject_of(*document, *settings, title(), kinds, work.watch(),
                                        options_.trial.value_or(1) - 1);
        if (!subject) return fail(subject.error(), ExitStatus::kFailed);
        if (subject->verified == false)
            say(options_.creature + ": the motion differs from that of the scored trial");
        const Status made = make(*product, *subject, kinds.creature, *text, *path, work);
        return made ? ExitStatus::kDone : fail(made.error(), ExitStatus::kFailed);
    }

private:
    ExitStatus render_page(const EvolutionKinds& kinds) {
        if (has_options_of_drawings(options_))
            return fail({options_.out + ": a page (*.html) takes no other options"});
        return make_page_of({options_.creature}, options_.out, files(), kinds);
    }

    ExitStatus render_preserve(const Product& product, const EvolutionKinds& kinds) {
        if (const Status usable = check_preserve_options(options_, product); !usable)
            return fail(usable.error());
        const auto path = output_path(options_.out, "", files());
        if (!path) return fail(path.error());
        const PictureSides size = size_of(product);
        const ClipTiming usual;
        LongWork work;
        const Status drawn = draw_preserve(
            {.file = options_.creature,
             .out = *path,
             .format = product.format,
             .width = size.width,
             .height = size.height,
             .palette = palette(),
             .from = options_.from,
             .to = options_.to,
             .frames_a_second = options_.frames_a_second.value_or(usual_rate(product)),
             .speed = options_.speed.value_or(usual.speed),
             .dithered = options_.dithered},
            kinds, work);
        if (drawn) return ExitStatus::kDone;
        return fail(drawn.error(),
                    work.interrupted() ? ExitStatus::kFailed : ExitStatus::kBadInput);
    }

    PictureSides size_of(const Product& product) const {
        return parse_picture_size(options_.size).value_or(usual_size(product));
    }
    Palette palette() const {
        return palette_of(options_.theme == "light" ? ThemeKind::kLight : ThemeKind::kDark);
    }

    // Returns the title of a creature without a name: the name of its file.
    std::string title() const {
        const std::string name = std::filesystem::path(options_.creature).filename().string();
        return capitalized(name.substr(0, name.find('.')));
    }

    Status make(const Product& product, const Subject& subject, const Kinds& kinds,
                const std::string& text, const std::filesystem::path& path, LongWork& work) const {
        const PictureSides size = size_of(product);
        const auto workshop = open_workshop(size.width, size.height);
        if (!workshop) return workshop.error();
        PictureCanvas& canvas = *(*workshop)->canvas;
        if (product.format != nullptr) {
            const ClipOrder order{.format = product.format,
                                  .path = path,
                                  .timing = timing(product, subject),
                                  .palette = palette(),
                                  .dithered = options_.dithered,
                                  .card = product.is_card(),
                                  .creature = text};
            work.begin("drawing", order.timing.seconds);
            return write_clip(canvas, subject, kinds, order, work.watch());
        }
        if (product.is_card()) {
            draw_card(canvas, subject, palette());
            return save_card(path, canvas.finish(), text);
        }
        draw_sheet(canvas, subject, palette(), options_.poses.value_or(kUsualPoses));
        const Result<std::string> png = encode_png(canvas.finish());
        return png ? write_file(path, *png) : Status(png.error());
    }

    ClipTiming timing(const Product& product, const Subject& subject) const {
        ClipTiming timing;
        timing.frames_a_second = options_.frames_a_second.value_or(usual_rate(product));
        timing.speed = options_.speed.value_or(timing.speed);
        const double whole = subject.motion().length();
        const double usual = product.is_card() ? kMovingCardSeconds * timing.speed : whole;
        timing.seconds = std::min(options_.seconds.value_or(usual), whole);
        return timing;
    }

    RenderOptions options_;
};

}  // namespace

SubcommandKind render_subcommand() {
    return {.id = "render",
            .summary =
                "Make a picture or a clip of one creature's trial or of a preserve, or a "
                "creature's card. "
                "Needs no display.",
            .example = "cambrian render champion-walking-seed7.creature.json -o clip.mp4",
            .make = make_subcommand<RenderSubcommand>};
}

}  // namespace cambrian
