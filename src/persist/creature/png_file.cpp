// libpng reports errors by jumping out of its functions (setjmp, longjmp), which skips destructors.
// So functions that call it have no objects with destructors: the filled objects and the last error
// belong to their callers.

#include "persist/creature/png_file.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstdint>
#include <cstring>
#include <png.h>

namespace cambrian {
namespace {

constexpr std::size_t kSignature = 8;  // bytes

// The last error, in a buffer of fixed size.
struct Fault {
    std::array<char, 160> words{};
};

[[noreturn]] void fail(png_structp png, png_const_charp message) {
    auto& words = static_cast<Fault*>(png_get_error_ptr(png))->words;
    std::strncpy(words.data(), message, words.size() - 1);
    png_longjmp(png, 1);
}

void ignore_warning(png_structp /*png*/, png_const_charp /*message*/) {}

// The bytes that are not read yet.
struct Source {
    const char* next = nullptr;
    std::size_t left = 0;
};

void take_bytes(png_structp png, png_bytep target, std::size_t count) {
    auto& source = *static_cast<Source*>(png_get_io_ptr(png));
    if (count > source.left) png_error(png, "the file is cut off");
    std::memcpy(target, source.next, count);
    source.next += count;
    source.left -= count;
}

void append_bytes(png_structp png, png_bytep bytes, std::size_t count) {
    static_cast<std::string*>(png_get_io_ptr(png))
        ->append(reinterpret_cast<const char*>(bytes), count);
}

class Writer {
public:
    Writer()
        : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &fault, fail, ignore_warning)),
          info(png_create_info_struct(png)) {}
    ~Writer() { png_destroy_write_struct(&png, &info); }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    Fault fault;
    png_structp png;
    png_infop info;
};

class Reader {
public:
    Reader()
        : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &fault, fail, ignore_warning)),
          info(png_create_info_struct(png)) {}
    ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
    Reader(const Reader&) = delete;
    Reader& operator=(const Reader&) = delete;

    Fault fault;
    png_structp png;
    png_infop info;
};

// Returns false after an error. Must not contain objects with destructors.
bool write_whole(Writer& writer, const Image& image, const png_text* texts, int count,
                 std::string& bytes) {
    if (setjmp(png_jmpbuf(writer.png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_write_fn(writer.png, &bytes, append_bytes, nullptr);
    png_set_IHDR(writer.png, writer.info, static_cast<png_uint_32>(image.width),
                 static_cast<png_uint_32>(image.height), 8, PNG_COLOR_TYPE_RGB, PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    if (count > 0) png_set_text(writer.png, writer.info, texts, count);
    png_write_info(writer.png, writer.info);
    const std::size_t row = 3 * static_cast<std::size_t>(image.width);
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y)
        png_write_row(writer.png, image.rgb.data() + y * row);
    png_write_end(writer.png, nullptr);
    return true;
}

// Returns false after an error. Must not contain objects with destructors.
bool read_whole(Reader& reader, Source& source, const PngLimits& limits) {
    if (setjmp(png_jmpbuf(reader.png)) != 0) return false;  // NOLINT(cert-err52-cpp)
    png_set_read_fn(reader.png, &source, take_bytes);
    const auto side = static_cast<png_uint_32>(limits.side);
    png_set_user_limits(reader.png, side, side);
    png_set_chunk_cache_max(reader.png, static_cast<png_uint_32>(limits.chunks));
    png_set_chunk_malloc_max(reader.png, limits.text_bytes + 256);
    png_set_crc_action(reader.png, PNG_CRC_ERROR_QUIT, PNG_CRC_ERROR_QUIT);
    png_set_benign_errors(reader.png, 0);
    png_read_info(reader.png, reader.info);
    const int passes = png_set_interlace_handling(reader.png);
    png_read_update_info(reader.png, reader.info);
    const png_uint_32 height = png_get_image_height(reader.png, reader.info);
    for (int pass = 0; pass < passes; ++pass) {
        for (png_uint_32 y = 0; y < height; ++y)
            png_read_row(reader.png, nullptr, nullptr);
    }
    png_read_end(reader.png, reader.info);
    return true;
}

png_text chunk_of(PngText& text) {
    png_text chunk{};
    chunk.compression = PNG_ITXT_COMPRESSION_zTXt;
    chunk.key = text.keyword.data();
    chunk.text = text.text.data();
    chunk.itxt_length = text.text.size();
    return chunk;
}

// libpng stores the length of tEXt and zTXt chunks in another field than that of iTXt.
std::string text_of(const png_text& chunk) {
    const std::size_t length = chunk.compression > 0 ? chunk.itxt_length : chunk.text_length;
    return {chunk.text, length};
}

}  // namespace

Result<std::string> encode_png(const Image& image, const std::vector<PngText>& texts) {
    std::vector<PngText> kept = texts;  // copied, since libpng takes no const texts
    std::vector<png_text> chunks;
    chunks.reserve(kept.size());
    for (PngText& text : kept)
        chunks.push_back(chunk_of(text));
    std::string bytes;
    Writer writer;
    if (write_whole(writer, image, chunks.data(), static_cast<int>(chunks.size()), bytes))
        return bytes;
    return Error{std::string("the picture cannot be encoded: ") + writer.fault.words.data()};
}

Result<Image> decode_png(std::string_view bytes, const PngLimits& limits) {
    png_image picture{};
    picture.version = PNG_IMAGE_VERSION;
    if (png_image_begin_read_from_memory(&picture, bytes.data(), bytes.size()) == 0)
        return Error{picture.message};
    const auto most = static_cast<png_uint_32>(limits.side);
    if (picture.width > most || picture.height > most) {
        png_image_free(&picture);
        return Error{fmt::format("it has {} x {} pixels; expected at most {} on each side",
                                 picture.width, picture.height, most)};
    }
    picture.format = PNG_FORMAT_RGB;
    Image image{.width = static_cast<int>(picture.width),
                .height = static_cast<int>(picture.height),
                .rgb = std::vector<std::uint8_t>(PNG_IMAGE_SIZE(picture))};
    constexpr png_color kWhite = {255, 255, 255};
    if (png_image_finish_read(&picture, &kWhite, image.rgb.data(), 0, nullptr) == 0)
        return Error{picture.message};
    return image;
}

bool is_png(std::string_view bytes) {
    const std::string_view start = bytes.substr(0, kSignature);
    return start == std::string_view("\x89PNG\r\n\x1a\n", kSignature);
}

Result<std::vector<std::string>> png_texts(std::string_view bytes, std::string_view keyword,
                                           const PngLimits& limits) {
    Reader reader;
    Source source{bytes.data(), bytes.size()};
    if (!read_whole(reader, source, limits)) return Error{reader.fault.words.data()};
    png_textp chunks = nullptr;
    int count = 0;
    png_get_text(reader.png, reader.info, &chunks, &count);
    std::vector<std::string> texts;
    for (int i = 0; i < count; ++i) {
        if (keyword == chunks[i].key) texts.push_back(text_of(chunks[i]));
    }
    return texts;
}

}  // namespace cambrian
