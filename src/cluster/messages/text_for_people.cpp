#include "cluster/messages/text_for_people.h"

#include "core/text/shown_text.h"

namespace cambrian {

std::string text_for_people(std::string_view text, std::size_t longest) {
    return shown(text, longest);
}

}  // namespace cambrian
