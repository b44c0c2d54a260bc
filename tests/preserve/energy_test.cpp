#include "preserve/world/energy.h"

#include "preserve/life/diet.h"
#include "preserve/life/feeding.h"
#include "worlds.h"

namespace cambrian {
namespace {

using namespace test;

TEST_CASE("specialists digest all of their food and omnivores five eighths", "[preserve]") {
    CHECK(share_of_plants(0.0) == 1.0);
    CHECK(share_of_flesh(0.0) == 0.0);
    CHECK(share_of_plants(1.0) == 0.0);
    CHECK(share_of_flesh(1.0) == 1.0);
    CHECK(share_of_plants(0.5) == 0.625);
    CHECK(share_of_flesh(0.5) == 0.625);
    CHECK(share_of_plants(0.25) == 0.8125);
    CHECK(share_of_flesh(0.25) == 0.3125);
}

TEST_CASE("a share of an energy is never more than the energy", "[preserve]") {
    const Energy large = (Energy{1} << 60) - 1;  // rounds up as a double
    CHECK(share_of(large, 1.0) == large);
    CHECK(share_of(1000, 0.5) == 500);
    CHECK(share_of(999, 0.5) == 499);
    CHECK(energy_of(-1.0) == 0);
    CHECK(energy_of(1.5) == 1'500'000'000);
}

// Two residents whose parts overlap, with 10 J each.
struct Meeting {
    explicit Meeting(double diet)
        : senses({20.0, 20.0}, settings.world.environment), flesh({20.0, 20.0}) {
        for (auto* each : {&biter, &victim}) {
            Life life{.number = each == &biter ? 1U : 2U, .genome = eater(diet)};
            auto grown = Resident::grow(std::move(life), creature_kinds(), settings, senses);
            REQUIRE(grown);
            *each = std::move(*grown);
            (*each)->store = energy_of(10.0);
            (*each)->body = energy_of(1.0);
        }
    }
    Energy total() const {
        return biter->store + biter->body + victim->store + victim->body + flesh.energy();
    }

    ExperimentSettings settings = small_world();
    CommonSenses senses;
    Food flesh;
    std::unique_ptr<Resident> biter, victim;
};

TEST_CASE("a bite moves the energy of a mouth's width, four fifths to the biter", "[preserve]") {
    Meeting meeting(1.0);
    const Energy before = meeting.total();
    bite(*meeting.biter, *meeting.victim, {meeting.settings.preserve, 0, {}}, meeting.flesh);
    const Energy taken = energy_of(40.0 * 0.2 * kBrainTick);
    CHECK(meeting.victim->store == energy_of(10.0) - taken);
    CHECK(meeting.biter->store == energy_of(10.0) + taken - taken / 5);
    CHECK(meeting.flesh.energy() == taken / 5);
    CHECK(meeting.victim->life.lost == taken);
    CHECK(meeting.total() == before);
}

TEST_CASE("a bite takes at most what is there, the body last", "[preserve]") {
    Meeting meeting(1.0);
    meeting.victim->store = 100;
    meeting.victim->body = 50;
    const Energy before = meeting.total();
    bite(*meeting.biter, *meeting.victim, {meeting.settings.preserve, 0, {}}, meeting.flesh);
    CHECK(meeting.victim->store == 0);
    CHECK(meeting.victim->body == 0);
    CHECK(meeting.total() == before);
}

TEST_CASE("a mouth for plants does not bite", "[preserve]") {
    Meeting meeting(0.0);
    bite(*meeting.biter, *meeting.victim, {meeting.settings.preserve, 0, {}}, meeting.flesh);
    CHECK(meeting.victim->store == energy_of(10.0));
}

TEST_CASE("parents and young children do not bite each other", "[preserve]") {
    Meeting meeting(1.0);
    meeting.victim->life.parents = {0, meeting.biter->life.number};
    const auto tick = static_cast<std::uint64_t>(meeting.settings.preserve.kin_peace * 60.0);
    bite(*meeting.biter, *meeting.victim, {meeting.settings.preserve, tick - 2, {}}, meeting.flesh);
    bite(*meeting.victim, *meeting.biter, {meeting.settings.preserve, tick - 2, {}}, meeting.flesh);
    CHECK(meeting.victim->store == energy_of(10.0));
    CHECK(meeting.biter->store == energy_of(10.0));
    bite(*meeting.biter, *meeting.victim, {meeting.settings.preserve, tick + 2, {}}, meeting.flesh);
    CHECK(meeting.victim->store < energy_of(10.0));
}

TEST_CASE("a dead body becomes flesh where its parts are", "[preserve]") {
    Meeting meeting(0.5);
    const Energy before = meeting.total();
    decay_to_flesh(*meeting.victim, meeting.flesh);
    CHECK(meeting.victim->store == 0);
    CHECK(meeting.victim->body == 0);
    CHECK(meeting.total() == before);
    REQUIRE(meeting.flesh.all().size() == 2);
    const auto parts = meeting.victim->rectangles();
    for (std::size_t i = 0; i < 2; ++i)
        CHECK((meeting.flesh.all()[i].place() - parts[i].center).norm() < 1e-12);
}

TEST_CASE("upkeep follows mass, neurons and age", "[preserve]") {
    Meeting meeting(0.5);
    Resident& resident = *meeting.biter;
    const PreserveSettings& laws = meeting.settings.preserve;
    const double young = laws.body_upkeep * resident.life.mass +
                         laws.neuron_upkeep * static_cast<double>(resident.life.neurons);
    CHECK(spend(resident, laws, 0) == energy_of(young * kBrainTick));
    const auto aged = static_cast<std::uint64_t>(laws.aging_time * 60.0);
    const double old = static_cast<double>(spend(resident, laws, aged));
    CHECK(old == Approx(2.0 * young * kBrainTick * kEnergyUnits).epsilon(1e-6));
    resident.store = 5;
    CHECK(spend(resident, laws, aged) == 5);
    CHECK(resident.store == 0);
}

}  // namespace
}  // namespace cambrian
