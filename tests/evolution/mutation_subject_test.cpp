// Every operator changes only what it is listed under: the body or the brain.

#include "evolution/individual/individual.h"
#include "genome/founders/random_genome.h"
#include "support/catch.h"
#include "support/kinds.h"

using namespace cambrian;

namespace {

struct Effects {
    int applied = 0;
    int on_body = 0;
};

Effects effects_of(const MutationKind& kind) {
    const KindCatalog& catalog = test::kinds().creature.catalog;
    FounderSettings founders;
    for (const auto& organ : catalog.organs)
        founders.organs[organ.id] = true;
    Effects effects;
    for (std::uint64_t number = 0; number < 300; ++number) {
        RandomStream stream(stream_seed(11, 0, number, Purpose::kTest));
        const Genome before = random_genome(founders, catalog, stream);
        Genome after = before;
        MutationRecord record;
        if (!kind.apply(after, {catalog, founders}, stream, record)) continue;
        repair(after, catalog);
        if (after == before) continue;
        ++effects.applied;
        effects.on_body += differing_body_genes(before, after) == 0 ? 0 : 1;
    }
    return effects;
}

}  // namespace

TEST_CASE("operators on the body change bodies, those on the brain never do",
          "[evolution][mutation]") {
    for (const MutationKind& kind : test::kinds().mutations.all()) {
        const Effects effects = effects_of(kind);
        INFO(kind.id);
        CHECK(effects.applied > 30);
        CHECK(effects.on_body == (kind.subject == MutationSubject::kBody ? effects.applied : 0));
    }
}
