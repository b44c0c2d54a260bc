#include "studio/widgets/column_widths.h"

#include "core/assert.h"

namespace cambrian {

std::vector<float> column_widths(std::span<const ColumnContent> columns, float available) {
    float words = 0.0F;
    float texts = 0.0F;
    for (const ColumnContent& column : columns) {
        CAMBRIAN_ASSERT(column.longest_word > 0.0F && column.longest_word <= column.longest_text,
                        "a word is no longer than its text");
        words += column.longest_word;
        texts += column.longest_text;
    }
    std::vector<float> widths;
    for (const ColumnContent& column : columns) {
        const float more = column.longest_text - column.longest_word;
        if (texts <= available)
            widths.push_back(column.longest_text * available / texts);
        else if (words >= available)
            widths.push_back(column.longest_word * available / words);
        else
            widths.push_back(column.longest_word + more * (available - words) / (texts - words));
    }
    return widths;
}

}  // namespace cambrian
