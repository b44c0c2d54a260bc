#include "golden/digest_file.h"

#include <algorithm>
#include <iomanip>
#include <map>
#include <sstream>

namespace cambrian::golden {
namespace {

std::string hexadecimal(std::uint64_t value) {
    std::ostringstream text;
    text << std::hex << std::setw(16) << std::setfill('0') << value;
    return text.str();
}

}  // namespace

std::string text_of(const Digests& digests) {
    std::string text;
    for (const Digest& digest : digests)
        text += digest.name + ' ' + hexadecimal(digest.value) + '\n';
    return text;
}

std::vector<std::string> differences(const std::string& recorded, const Digests& digests) {
    std::map<std::string, std::string> expected;
    std::istringstream lines(recorded);
    for (std::string name, value; lines >> name >> value;)
        expected[name] = value;

    std::vector<std::string> different;
    for (const Digest& digest : digests) {
        const std::string value = hexadecimal(digest.value);
        const auto found = expected.extract(digest.name);
        if (!found) {
            different.push_back(digest.name + " is " + value + " and not recorded");
        } else if (found.mapped() != value) {
            different.push_back(digest.name + " is " + value + " instead of " + found.mapped());
        }
    }
    for (const auto& [name, value] : expected)
        different.push_back(name + " is recorded and not computed");
    return different;
}

}  // namespace cambrian::golden
