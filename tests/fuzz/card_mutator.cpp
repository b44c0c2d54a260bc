// The mutator of cards for libFuzzer. Most changes are inside a chunk, whose length and checksum
// are corrected, or inside a chunk's compressed text. Otherwise nearly every change would fail at
// the first checksum.

#include "core/deflated_text.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <libdeflate.h>
#include <optional>
#include <random>
#include <string>
#include <string_view>
#include <vector>

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t most);
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size,
                                               std::size_t most, unsigned int seed);

namespace {

constexpr std::size_t kSignature = 8;  // bytes
constexpr std::size_t kFrame = 12;     // bytes of a chunk besides its content
// Largest text that is inflated to be changed, in bytes.
constexpr std::size_t kMostText = 1'000'000;
constexpr std::size_t kMostContents = 100'000;  // largest content after a change, in bytes

struct Chunk {
    std::string type;
    std::string contents;
};

std::uint32_t number_at(const std::uint8_t* bytes) {
    return std::uint32_t{bytes[0]} << 24 | std::uint32_t{bytes[1]} << 16 |
           std::uint32_t{bytes[2]} << 8 | std::uint32_t{bytes[3]};
}

void append_number(std::string& bytes, std::uint32_t number) {
    for (const int shift : {24, 16, 8, 0})
        bytes += static_cast<char>(number >> shift & 0xff);
}

// Returns the complete chunks.
std::vector<Chunk> chunks_of(const std::uint8_t* data, std::size_t size) {
    std::vector<Chunk> chunks;
    std::size_t at = kSignature;
    while (at + kFrame <= size && number_at(data + at) <= size - at - kFrame) {
        const std::size_t length = number_at(data + at);
        const char* start = reinterpret_cast<const char*>(data) + at + 4;
        chunks.push_back({std::string(start, 4), std::string(start + 4, length)});
        at += kFrame + length;
    }
    return chunks;
}

std::string picture_of(const std::uint8_t* signature, const std::vector<Chunk>& chunks) {
    std::string bytes(reinterpret_cast<const char*>(signature), kSignature);
    for (const Chunk& chunk : chunks) {
        append_number(bytes, static_cast<std::uint32_t>(chunk.contents.size()));
        const std::string checked = chunk.type + chunk.contents;
        bytes += checked;
        append_number(bytes, libdeflate_crc32(0, checked.data(), checked.size()));
    }
    return bytes;
}

std::string mutated(std::string bytes) {
    const std::size_t size = bytes.size();
    const std::size_t most = std::max<std::size_t>(2 * size, 64);
    bytes.resize(std::min(most, kMostContents + size));
    bytes.resize(
        LLVMFuzzerMutate(reinterpret_cast<std::uint8_t*>(bytes.data()), size, bytes.size()));
    return bytes;
}

// Returns the offset of the compressed part of a chunk.
std::optional<std::size_t> compressed_start(const Chunk& chunk) {
    if (chunk.type == "IDAT") return 0;
    const std::size_t keyword = chunk.contents.find('\0');
    if (keyword == std::string::npos) return std::nullopt;
    if (chunk.type == "zTXt" || chunk.type == "iCCP") return keyword + 2;
    if (chunk.type != "iTXt" || chunk.contents.size() < keyword + 3 ||
        chunk.contents[keyword + 1] != 1)
        return std::nullopt;
    const std::size_t language = chunk.contents.find('\0', keyword + 3);
    if (language == std::string::npos) return std::nullopt;
    const std::size_t translated = chunk.contents.find('\0', language + 1);
    if (translated == std::string::npos) return std::nullopt;
    return translated + 1;
}

std::optional<std::string> inflated(std::string_view bytes) {
    static libdeflate_decompressor* inflater = libdeflate_alloc_decompressor();
    std::string text(kMostText, '\0');
    std::size_t size = 0;
    if (libdeflate_zlib_decompress(inflater, bytes.data(), bytes.size(), text.data(), text.size(),
                                   &size) != LIBDEFLATE_SUCCESS)
        return std::nullopt;
    text.resize(size);
    return text;
}

// Changes the compressed part of a chunk; returns false if there is none.
bool mutate_compressed(Chunk& chunk) {
    const auto start = compressed_start(chunk);
    if (!start || *start >= chunk.contents.size()) return false;
    const auto text = inflated(std::string_view(chunk.contents).substr(*start));
    if (!text) return false;
    static cambrian::Deflater deflater;
    chunk.contents.replace(*start, std::string::npos, deflater.deflate(mutated(*text)));
    return true;
}

using Random = std::minstd_rand;

std::size_t below(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random()) % count;
}

void reorder(std::vector<Chunk>& chunks, Random& random) {
    const std::size_t from = below(random, chunks.size());
    const std::size_t to = below(random, chunks.size());
    switch (below(random, 3)) {
        case 0:
            std::swap(chunks[from], chunks[to]);
            break;
        case 1:
            chunks.insert(chunks.begin() + static_cast<std::ptrdiff_t>(to), Chunk(chunks[from]));
            break;
        default:
            chunks.erase(chunks.begin() + static_cast<std::ptrdiff_t>(from));
    }
}

void rename(Chunk& chunk, Random& random) {
    static const std::array<const char*, 18> kTypes = {
        "IHDR", "PLTE", "IDAT", "IEND", "tEXt", "zTXt", "iTXt", "gAMA", "cHRM",
        "sBIT", "sRGB", "iCCP", "tRNS", "bKGD", "hIST", "pHYs", "tIME", "eXIf"};
    chunk.type = kTypes[below(random, kTypes.size())];
}

void mutate_chunks(std::vector<Chunk>& chunks, Random& random) {
    Chunk& chunk = chunks[below(random, chunks.size())];
    switch (below(random, 8)) {
        case 0:
            reorder(chunks, random);
            break;
        case 1:
            rename(chunk, random);
            break;
        case 2:
        case 3:
            chunk.contents = mutated(std::move(chunk.contents));
            break;
        default:
            if (!mutate_compressed(chunk)) chunk.contents = mutated(std::move(chunk.contents));
    }
}

}  // namespace

std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t most,
                                    unsigned int seed) {
    Random random(seed);
    std::vector<Chunk> chunks = chunks_of(data, size);
    if (chunks.empty() || below(random, 8) == 0) return LLVMFuzzerMutate(data, size, most);
    mutate_chunks(chunks, random);
    const std::string bytes = picture_of(data, chunks);
    if (bytes.size() > most) return LLVMFuzzerMutate(data, size, most);
    std::memcpy(data, bytes.data(), bytes.size());
    return bytes.size();
}
