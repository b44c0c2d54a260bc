#pragma once

// Rows of numbers in one text, as "1 2 3; 4 5 6".

#include "core/result.h"

#include <string_view>
#include <vector>

namespace cambrian {

struct RowFormat {
    std::size_t columns = 0;
    std::size_t most = 0;       // rows
    const char* noun = "";      // of a row: "wall"
    const char* expected = "";  // of the text, in words
};

// Fails, with the row, for another number of columns, for more rows, and for numbers that are not
// finite. An empty text has no rows.
Result<std::vector<std::vector<double>>> number_rows(std::string_view text,
                                                     const RowFormat& format);

}  // namespace cambrian
