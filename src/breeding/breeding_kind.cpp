#include "breeding/breeding_kind.h"

namespace cambrian {

std::vector<std::string> reproductions_of(const BreedingRegistry& methods) {
    std::vector<std::string> ids = KindCatalog().reproductions;
    for (const BreedingKind& method : methods.all()) {
        if (method.heritable) ids.push_back(method.id);
    }
    return ids;
}

const BreedingKind& single_parent_method(const BreedingRegistry& methods) {
    for (const BreedingKind& method : methods.all()) {
        if (method.parents == 1) return method;
    }
    return methods[0];
}

}  // namespace cambrian
