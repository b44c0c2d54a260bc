#include "breeding/methods.h"

namespace cambrian {
namespace {

Genome breed_asexual(const Genome& first, const Genome& /*second*/, const KindCatalog& /*catalog*/,
                     RandomStream& /*stream*/) {
    return child_of(first);
}

}  // namespace

Genome child_of(const Genome& parent) {
    Genome child = parent;
    child.name.clear();
    return child;
}

void add_asexual(BreedingRegistry& methods) {
    methods.add({.id = "asexual",
                 .label = "Asexual",
                 .parents = 1,
                 .default_share = 0.4,
                 .breed = breed_asexual});
}

}  // namespace cambrian
