#include "evolution/selection.h"

namespace cambrian {

void register_truncation(SelectionRegistry& selections);

SelectionRegistry builtin_selections() {
    SelectionRegistry selections;
    register_truncation(selections);
    return selections;
}

}  // namespace cambrian
