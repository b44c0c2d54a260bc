#include "core/deflated_text.h"

#include <libdeflate.h>

namespace cambrian {

void Deflater::Free::operator()(libdeflate_compressor* compressor) const {
    libdeflate_free_compressor(compressor);
}

Deflater::Deflater(int level) : compressor_(libdeflate_alloc_compressor(level)) {
    CAMBRIAN_ASSERT(compressor_ != nullptr, "out of memory");
}

std::string_view Deflater::deflate(std::string_view text) {
    buffer_.resize(libdeflate_zlib_compress_bound(compressor_.get(), text.size()));
    const std::size_t size = libdeflate_zlib_compress(compressor_.get(), text.data(), text.size(),
                                                      buffer_.data(), buffer_.size());
    return std::string_view(buffer_).substr(0, size);
}

void Inflater::Free::operator()(libdeflate_decompressor* decompressor) const {
    libdeflate_free_decompressor(decompressor);
}

Inflater::Inflater() : decompressor_(libdeflate_alloc_decompressor()) {
    CAMBRIAN_ASSERT(decompressor_ != nullptr, "out of memory");
}

Result<std::string> Inflater::inflate(std::string_view bytes, std::size_t size) {
    std::string text(size, '\0');
    const libdeflate_result result = libdeflate_zlib_decompress(
        decompressor_.get(), bytes.data(), bytes.size(), text.data(), text.size(), nullptr);
    if (result != LIBDEFLATE_SUCCESS) return Error{"cannot be decompressed"};
    return text;
}

std::uint32_t crc32_of(std::string_view bytes) {
    return libdeflate_crc32(0, bytes.data(), bytes.size());
}

}  // namespace cambrian
