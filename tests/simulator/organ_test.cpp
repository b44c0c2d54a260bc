// Creatures with organs in a trial: what they give off, when it can be sensed, and that a replay
// has the same bits.
#include "simulator/trial.h"
#include "support/catch.h"
#include "support/creatures.h"
#include "support/kinds.h"

#include <algorithm>

using namespace cambrian;
using test::CreatureBuilder;

namespace {

const KindCatalog& catalog() {
    return test::creature_kinds().catalog;
}

SourceRef sense(std::string_view channel) {
    const auto& channels = catalog().channels;
    const auto found = std::find_if(channels.begin(), channels.end(),
                                    [&](const ChannelEntry& each) { return each.id == channel; });
    REQUIRE(found != channels.end());
    return {SourceKind::kLocalSensor, static_cast<std::uint8_t>(found - channels.begin())};
}

// Returns a box on the ground with an arm that follows a sense of its own, and an organ on the box
// that works from `delay` on.
Genome with_organ(std::string_view organ, std::string_view channel, double weight,
                  double delay = 0.0, double parameter = 0.0) {
    CreatureBuilder builder(catalog());
    const auto body = builder.part(0.5, 0.2);
    const auto arm = builder.part(0.3, 0.1);
    builder.attach(body, arm, 0.1);
    builder.organ(body, organ, test::alarm(builder, body, delay, 1.0), 0.5, parameter);
    Genome genome = *builder.build();
    genome.nodes[arm].effector = {sense(channel), weight};
    return genome;
}

// The same with an organ that hears a constant.
Genome with_steady_organ(std::string_view organ, std::string_view channel, double weight) {
    Genome genome = with_organ(organ, channel, weight);
    genome.nodes[0].neurons.clear();
    genome.nodes[0].organs[0].input = {{}, 1.0};
    return genome;
}

std::unique_ptr<Trial> begin(const Genome& genome, const Environment& environment = {}) {
    TrialWorld world;
    world.environment = environment;
    auto trial = Trial::start(
        std::make_shared<const Phenotype>(express(genome, test::creature_kinds(), {}, world.scene)),
        test::creature_kinds(), world);
    REQUIRE(trial);
    while ((*trial)->settling())
        (*trial)->tick();
    return std::move(*trial);
}

void run_ticks(Trial& trial, int ticks) {
    for (int i = 0; i < ticks; ++i)
        trial.tick();
}

double reading(const Trial& trial) {
    return trial.creature().reading(0, trial.scene(), trial.surroundings());
}

}  // namespace

TEST_CASE("a voice calls in its band, as loud as its signal, and is not heard by its owner",
          "[simulator][organs]") {
    const auto trial = begin(with_organ("sound", "sound-3", 1.0, 1.0, 2.0));
    run_ticks(*trial, 50);
    CHECK(trial->surroundings().sounds().empty());
    run_ticks(*trial, 20);
    REQUIRE(trial->surroundings().sounds().size() == 1);
    const Sound& call = trial->surroundings().sounds()[0];
    CHECK(call.band == 2);
    CHECK(call.loudness == 0.5);
    CHECK((call.place - trial->scene().part_pose(0).position).norm() < 0.01);
    CHECK(reading(*trial) == 0.0);
}

TEST_CASE("a steady gland is smelled from the next tick on", "[simulator][organs]") {
    const auto trial = begin(with_steady_organ("scent", "smell", 0.0));
    REQUIRE(trial->surroundings().scent_field() != nullptr);
    CHECK(trial->surroundings().scent_field()->total() == 0.0);
    trial->tick();
    CHECK(trial->surroundings().scent_field()->total() == Approx(1.0 / 60.0));
    run_ticks(*trial, 59);
    const double total = trial->surroundings().scent_field()->total();
    CHECK(total > 0.95);
    CHECK(total < 1.0);
    CHECK(reading(*trial) > 0.1);
}

TEST_CASE("a scent field exists only for those who scent or smell", "[simulator][organs]") {
    CHECK(begin(*test::crawler(catalog()))->surroundings().scent_field() == nullptr);
    CHECK(begin(with_organ("sound", "sound-1", 1.0))->surroundings().scent_field() == nullptr);
    CHECK(begin(with_organ("sound", "smell", 1.0))->surroundings().scent_field() != nullptr);
}

TEST_CASE("in a world without smell or hearing senses read 0", "[simulator][organs]") {
    Environment world;
    world.scentless = true;
    const auto trial = begin(with_steady_organ("scent", "smell", 0.0), world);
    run_ticks(*trial, 60);
    CHECK(trial->surroundings().scent_field()->total() > 0.5);
    CHECK(reading(*trial) == 0.0);
}

TEST_CASE("a restored trial with organs goes on with the same bits", "[simulator][organs]") {
    Genome genome = with_organ("scent", "smell", 2.0, 0.2);
    genome.nodes[1].organs = {{.kind = 0, .input = {sense("joint"), 4.0}, .parameters = {1.0}}};
    const auto trial = begin(genome);
    run_ticks(*trial, 100);
    const Trial::State state = trial->save();
    const auto go_on = [&] {
        run_ticks(*trial, 203);
        Hash64 digest;
        trial->scene().add_to_digest(digest);
        for (const double cell : trial->surroundings().scent_field()->save().cells)
            digest.add(cell);
        for (const Sound& sound : trial->surroundings().sounds())
            digest.add(sound.loudness);
        return digest.value();
    };
    const std::uint64_t first = go_on();
    trial->restore(state);
    CHECK(go_on() == first);
    const auto again = begin(genome);
    run_ticks(*again, 303);
    Hash64 digest;
    again->scene().add_to_digest(digest);
    Hash64 other;
    trial->scene().add_to_digest(other);
    CHECK(digest.value() == other.value());
}

TEST_CASE("who smells does not rest while there is a scent", "[simulator][organs]") {
    const auto computed = [](const Genome& genome, const Environment& environment) {
        const auto trial = begin(genome, environment);
        while (trial->tick()) {
        }
        return trial->record().computed_time;
    };
    const Genome smelling = with_steady_organ("scent", "smell", 0.0);
    CHECK(computed(smelling, {}) == Approx(15.0));
    CHECK(computed(with_steady_organ("scent", "contact-left", 0.0), {}) < 6.0);
    Environment world;
    world.scentless = true;
    CHECK(computed(smelling, world) < 6.0);
}

TEST_CASE("organs alone do not make a creature one that can score", "[simulator][organs]") {
    Genome genome = with_organ("sound", "smell", 1.0);
    genome.nodes[1].effector = {{}, 1.0};
    const Phenotype phenotype = express(genome, test::creature_kinds(), {}, {});
    CHECK(phenotype.organs.size() == 1);
    CHECK(phenotype.network.outputs.size() == 2);
    CHECK_FALSE(phenotype.has_live_control);
}
