#include "golden/founders.h"

#include "support/kinds.h"

namespace cambrian::golden {

FounderSettings all_joints(const KindCatalog& catalog) {
    FounderSettings settings;
    for (const JointChoice& joint : catalog.joints)
        settings.joints[joint.id] = true;
    return settings;
}

Genome founder(int number, const KindCatalog& catalog) {
    RandomStream random(stream_seed({11, static_cast<std::uint64_t>(number)}));
    return random_genome(all_joints(catalog), catalog, random);
}

// The organs and channels that there were when the digests were recorded.
FounderSettings with_emitters() {
    constexpr std::size_t kChannels = 21;
    const KindCatalog& catalog = test::kinds().creature.catalog;
    FounderSettings settings = all_joints();
    settings.organs = {{"sound", true}, {"scent", true}};
    for (std::size_t i = 0; i < kChannels; ++i)
        settings.channels[catalog.channels[i].id] = true;
    return settings;
}

FounderSettings with_deformers() {
    FounderSettings settings = all_joints();
    settings.organs = {{"deformer", true}};
    settings.channels = {{"stretch", true}, {"stretch-rate", true}};
    return settings;
}

Genome founder_with_organs(int number) {
    RandomStream random(stream_seed({14, static_cast<std::uint64_t>(number)}));
    return random_genome(with_emitters(), test::kinds().creature.catalog, random);
}

Genome founder_with_deformers(int number) {
    RandomStream random(stream_seed({15, static_cast<std::uint64_t>(number)}));
    return random_genome(with_deformers(), test::kinds().creature.catalog, random);
}

}  // namespace cambrian::golden
