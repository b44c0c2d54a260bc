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

}  // namespace cambrian::golden
