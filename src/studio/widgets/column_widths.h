#pragma once

#include <span>
#include <vector>

namespace cambrian {

// Widths of a table's column, in pixels: that of its longest word, and that of its longest text on
// one line. Both are above 0, and `longest_text` is not below `longest_word`.
struct ColumnContent {
    float longest_word = 0.0F;
    float longest_text = 0.0F;
};

// Shares a table's width among its columns, so that no word is cut as long as there is room for
// all. If the longest texts fit, widths are in proportion to these; otherwise each column has the
// width of its longest word, and the rest goes to columns with longer texts. The sum is
// `available`, in pixels.
std::vector<float> column_widths(std::span<const ColumnContent> columns, float available);

}  // namespace cambrian
