#pragma once

// Text compressed as zlib streams (RFC 1950), which the sqlite3 shell reads with
// sqlar_uncompress().

#include "core/result.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

struct libdeflate_compressor;
struct libdeflate_decompressor;

namespace cambrian {

class Deflater {
public:
    // At level 1 it is three times as fast as zlib and makes texts as small; levels up to 12 take
    // longer for less.
    explicit Deflater(int level = 1);
    // The result is valid until the next call.
    std::string_view deflate(std::string_view text);

private:
    struct Free {
        void operator()(libdeflate_compressor* compressor) const;
    };
    std::unique_ptr<libdeflate_compressor, Free> compressor_;
    std::string buffer_;
};

class Inflater {
public:
    Inflater();
    // `size` is the number of bytes of the text. Fails if the compressed bytes contain another
    // number.
    Result<std::string> inflate(std::string_view bytes, std::size_t size);

private:
    struct Free {
        void operator()(libdeflate_decompressor* decompressor) const;
    };
    std::unique_ptr<libdeflate_decompressor, Free> decompressor_;
};

// Returns the check of bytes as gzip and PNG have it (CRC-32).
std::uint32_t crc32_of(std::string_view bytes);

}  // namespace cambrian
