#include "golden/founders.h"

#include "support/kinds.h"

namespace cambrian::golden {

FounderSettings all_joints() {
    FounderSettings settings;
    for (const JointChoice& joint : test::kinds().creature.catalog.joints)
        settings.joints[joint.id] = true;
    return settings;
}

Genome founder(int number) {
    RandomStream random(stream_seed({11, static_cast<std::uint64_t>(number)}));
    return random_genome(all_joints(), test::kinds().creature.catalog, random);
}

FounderSettings all_organs() {
    const KindCatalog& catalog = test::kinds().creature.catalog;
    FounderSettings settings = all_joints();
    for (const OrganEntry& organ : catalog.organs)
        settings.organs[organ.id] = true;
    for (const ChannelEntry& channel : catalog.channels)
        settings.channels[channel.id] = true;
    return settings;
}

Genome founder_with_organs(int number) {
    RandomStream random(stream_seed({14, static_cast<std::uint64_t>(number)}));
    return random_genome(all_organs(), test::kinds().creature.catalog, random);
}

}  // namespace cambrian::golden
