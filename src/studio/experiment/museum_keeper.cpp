#include "studio/experiment/museum_keeper.h"

#include "persist/creature/champion_museum.h"

#include <utility>

namespace cambrian {
namespace {

Result<Admission> exhibit_champion(const std::filesystem::path& museum, JudgedIndividual champion,
                                   const EvolutionKinds& kinds, const std::stop_token& stop) {
    CreatureDocument document = creature_document(std::move(champion), kinds);
    complete_score(document, kinds, stop);
    if (stop.stop_requested()) return Error{"interrupted; the museum is as before"};
    return admit(museum, document, kinds, stop);
}

}  // namespace

void MuseumKeeper::see(const EvolutionSnapshot& snapshot) {
    if (snapshot.experiment != run_ && champion_ && generations_ >= kMuseumGenerations &&
        !folder_.empty()) {
        services_.worker.submit([services = services_, folder = folder_, champion = *champion_](
                                    const std::stop_token& stop) -> BackgroundWorker::Completion {
            const auto admitted = exhibit_champion(folder, champion, services.kinds, stop);
            return [services, admitted] {
                if (!admitted) return services.feedback.report(Status(admitted.error()));
                services.feedback.log().write("museum",
                                              {{"result", std::string(words_of(*admitted))}});
            };
        });
    }
    run_ = snapshot.experiment;
    generations_ = snapshot.champions.size();
    champion_.reset();
    if (generations_ > 0) champion_ = snapshot.champions.back();
}

void MuseumKeeper::close() {
    if (folder_.empty() || !champion_ || generations_ < kMuseumGenerations) return;
    static_cast<void>(exhibit_champion(folder_, *champion_, services_.kinds, {}));
    champion_.reset();
}

}  // namespace cambrian
