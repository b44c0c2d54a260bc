#ifndef __clang_analyzer__  // the library is not ours to analyse
#define STB_TRUETYPE_IMPLEMENTATION
#endif
#define STBTT_STATIC
#include "pictures/canvas/text_rasterizer.h"

#include "core/files/file_io.h"
#include "core/text/code_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <stb/stb_truetype.h>
#include <vector>

namespace cambrian {
namespace {

constexpr std::size_t kMaxFontBytes = 32'000'000;
constexpr std::string_view kEllipsis = "…";

// Returns the index at which the last complete character of UTF-8 text begins.
std::size_t last_letter(std::string_view text) {
    std::size_t at = text.size() - 1;
    while (at > 0 && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U)
        --at;
    return at;
}

void blend(std::uint8_t& channel, float color, float share) {
    const float mixed = static_cast<float>(channel) * (1.0F - share) + 255.0F * color * share;
    channel = static_cast<std::uint8_t>(std::lround(mixed));
}

// A glyph's coverage of pixels, with its upper left corner at x, y of the image.
struct Stencil {
    std::vector<unsigned char> coverage;
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

void stamp(Image& image, const Stencil& stencil, const Color& color) {
    const int left = std::max(0, -stencil.x);
    const int right = std::min(stencil.width, image.width - stencil.x);
    const int top = std::max(0, -stencil.y);
    const int bottom = std::min(stencil.height, image.height - stencil.y);
    for (int row = top; row < bottom; ++row) {
        for (int column = left; column < right; ++column) {
            const auto inside =
                static_cast<std::size_t>(row) * static_cast<std::size_t>(stencil.width) +
                static_cast<std::size_t>(column);
            const float share = color.a * static_cast<float>(stencil.coverage[inside]) / 255.0F;
            std::uint8_t* pixel = image.pixel(stencil.x + column, stencil.y + row);
            blend(pixel[0], color.r, share);
            blend(pixel[1], color.g, share);
            blend(pixel[2], color.b, share);
        }
    }
}

}  // namespace

struct TextRasterizer::Face {
    std::string bytes;
    stbtt_fontinfo font{};
    Typeface typeface = Typeface::kRegular;
    std::string path;  // of a face of other scripts
    // The faces of letters that this one lacks, null where there is none.
    mutable std::map<int, std::shared_ptr<const Face>> others;

    static std::unique_ptr<Face> read(const FontFile& file) {
        auto face = std::make_unique<Face>();
        Result<std::string> bytes = read_file(file.path, kMaxFontBytes);
        if (!bytes) return nullptr;
        face->bytes = std::move(*bytes);
        const auto* data = reinterpret_cast<const unsigned char*>(face->bytes.data());
        const int start = stbtt_GetFontOffsetForIndex(data, file.face);
        return start >= 0 && stbtt_InitFont(&face->font, data, start) != 0 ? std::move(face)
                                                                           : nullptr;
    }
    static std::unique_ptr<Face> load(Typeface typeface) {
        for (const std::filesystem::path& file : installed_files(typeface)) {
            if (auto face = read({file})) {
                face->typeface = typeface;
                return face;
            }
        }
        return nullptr;
    }
    bool has(int letter) const { return stbtt_FindGlyphIndex(&font, letter) != 0; }
    // Returns the face that draws a letter: this one or, where it lacks the letter, another one of
    // the system's, if there is one.
    const Face& of(int letter) const {
        constexpr int first = 0xA0;  // those before are in every font or are no letters
        if (letter < first || has(letter)) return *this;
        const auto known = others.find(letter);
        if (known != others.end()) return known->second ? *known->second : *this;
        std::shared_ptr<const Face>& other = others[letter];
        const auto files = files_with({letter}, typeface);
        if (files.empty()) return *this;
        const std::string from = files.front().file.path.string();
        for (const auto& [_, each] : others) {
            if (each && each->path == from) other = each;
        }
        if (!other) {
            std::unique_ptr<Face> face = read(files.front().file);
            if (face) face->path = from;
            other = std::move(face);
        }
        return other ? *other : *this;
    }
    float scale(double size) const {
        return stbtt_ScaleForPixelHeight(&font, static_cast<float>(size));
    }
    // Calls visit(face, letter, x) for each letter, with x in pixels from the first. Returns the
    // end of the last one.
    template <class Visit>
    float set(std::string_view text, double size, Visit visit) const {
        float x = 0.0F;
        int before = 0;
        const Face* face_before = this;
        for (const int letter : code_points(text)) {
            const Face& face = of(letter);
            const float per_unit = face.scale(size);
            if (before != 0 && face_before == &face)
                x += per_unit *
                     static_cast<float>(stbtt_GetCodepointKernAdvance(&face.font, before, letter));
            visit(face, letter, x);
            int advance = 0;
            int bearing = 0;
            stbtt_GetCodepointHMetrics(&face.font, letter, &advance, &bearing);
            x += per_unit * static_cast<float>(advance);
            before = letter;
            face_before = &face;
        }
        return x;
    }
    // Rasterises a glyph whose baseline begins at x, y.
    Stencil stencil(int letter, float per_unit, double x, double y) const {
        const double left = std::floor(x);
        const auto shift = static_cast<float>(x - left);
        Stencil result;
        int right = 0;
        int bottom = 0;
        stbtt_GetCodepointBitmapBoxSubpixel(&font, letter, per_unit, per_unit, shift, 0.0F,
                                            &result.x, &result.y, &right, &bottom);
        result.width = right - result.x;
        result.height = bottom - result.y;
        result.x += static_cast<int>(left);
        result.y += static_cast<int>(std::lround(y));
        result.coverage.resize(static_cast<std::size_t>(result.width) *
                               static_cast<std::size_t>(result.height));
        if (!result.coverage.empty())
            stbtt_MakeCodepointBitmapSubpixel(&font, result.coverage.data(), result.width,
                                              result.height, result.width, per_unit, per_unit,
                                              shift, 0.0F, letter);
        return result;
    }
};

TextRasterizer::TextRasterizer() = default;
TextRasterizer::~TextRasterizer() = default;

Result<std::unique_ptr<TextRasterizer>> TextRasterizer::load() {
    std::unique_ptr<TextRasterizer> result(new TextRasterizer);
    for (const Typeface typeface : {Typeface::kRegular, Typeface::kStrong}) {
        auto& face = result->faces_[static_cast<std::size_t>(typeface)];
        face = Face::load(typeface);
        if (!face)
            return Error{
                "no typeface to write with; install Inter or DejaVu (Debian: fonts-inter "
                "or fonts-dejavu)"};
    }
    return result;
}

bool TextRasterizer::can_read(const FontFile& file) {
    return Face::read(file) != nullptr;
}

double TextRasterizer::width(std::string_view text, Typeface typeface, double size) const {
    return static_cast<double>(face(typeface).set(text, size, [](const Face&, int, float) {}));
}

void TextRasterizer::draw(Image& image, double x, double y, std::string_view text,
                          Typeface typeface, double size, const Color& color) const {
    face(typeface).set(text, size, [&](const Face& letters, int letter, float from) {
        stamp(image, letters.stencil(letter, letters.scale(size), x + static_cast<double>(from), y),
              color);
    });
}

std::string TextRasterizer::fit(std::string_view text, Typeface typeface, double size,
                                double most) const {
    if (width(text, typeface, size) <= most) return std::string(text);
    std::string cut;
    do {
        text = text.substr(0, last_letter(text));
        cut = std::string(text) + std::string(kEllipsis);
    } while (!text.empty() && width(cut, typeface, size) > most);
    return cut;
}

}  // namespace cambrian
