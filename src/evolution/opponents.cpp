#include "evolution/opponents.h"

#include "core/random.h"

namespace cambrian {

Opponents draw_opponents(const OpponentSource& source, const ExperimentSettings& settings,
                         std::uint32_t generation) {
    RandomStream stream(stream_seed(settings.seed, generation, 0, Purpose::kOpponent));
    const auto count = static_cast<std::size_t>(settings.world.trial.trials);
    const std::span<const GenomePtr> champions = source.champions;
    Opponents opponents;
    if (!champions.empty()) opponents.genomes.push_back(champions.back());
    while (opponents.genomes.size() < count) {
        if (champions.empty()) {
            opponents.genomes.push_back(stream.pick(source.population)->genome);
        } else {
            // The best of the last generation is drawn again only while there is no other one.
            const std::size_t earlier = champions.size() > 1 ? champions.size() - 1 : 1;
            opponents.genomes.push_back(champions[stream.below(earlier)]);
        }
    }
    return opponents;
}

}  // namespace cambrian
