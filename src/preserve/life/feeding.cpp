#include "preserve/life/feeding.h"

#include <algorithm>

namespace cambrian {
namespace {

constexpr double kReach = 0.1;           // m, of a mouth
constexpr double kSolidBite = 0.01;      // m; gap through which a mouth bites
constexpr double kCrumbDistance = 0.25;  // m, within which crumbs become one piece of flesh
constexpr Energy kBittenOff = 5;         // one part in so many of a bite falls down as flesh

// Returns the energy gained of the pellets within reach; `rest` is raised by the remainder.
Energy eat_of(Food& pellets, const Rectangle& mouth, double share, Energy& rest) {
    Energy gained = 0;
    for (const Pellet& pellet : pellets.take(mouth, kReach)) {
        const Energy digested = share_of(pellet.energy, share);
        gained += digested;
        rest += pellet.energy - digested;
    }
    return gained;
}

bool is_young_child_of(const Resident& child, const Resident& parent, const PreserveSettings& laws,
                       std::uint64_t tick) {
    const auto& parents = child.life.parents;
    return (parents[0] == parent.life.number || parents[1] == parent.life.number) &&
           child.age(tick) < laws.kin_peace;
}

// Returns the first part that is that near to a mouth, or the number of parts.
std::size_t bitten_part(Rectangle mouth, double distance, std::span<const Rectangle> parts,
                        const Torus& torus) {
    mouth.half_length += distance;
    mouth.half_width += distance;
    const auto found = std::find_if(parts.begin(), parts.end(), [&](const Rectangle& part) {
        const Vec3 way = part.center - mouth.center;
        return overlap(mouth, moved(part, torus.shortest(way) - way));
    });
    return static_cast<std::size_t>(found - parts.begin());
}

struct Ram {
    double lost = 0.0;  // J, of the impacts
    Vec3 place = Vec3::Zero();
};

// Returns how a mouth rammed a victim in the last tick.
Ram ram_of(const Resident& biter, const Mouth& mouth, const Resident& victim) {
    Ram ram;
    for (const SceneImpact& impact : biter.impacts()) {
        const bool is_bite = impact.other_scene == &victim.scene() &&
                             static_cast<std::size_t>(impact.part) == mouth.part;
        if (!is_bite || !(impact.lost > 0.0)) continue;
        ram.lost += impact.lost;
        ram.place = impact.point;
    }
    return ram;
}

// Takes energy from the store, then from the body.
void take_energy(Resident& victim, Energy energy) {
    const Energy stored = std::min(victim.store, energy);
    victim.store -= stored;
    victim.body -= energy - stored;
    victim.life.lost += energy;
    victim.bitten = true;
}

}  // namespace

Energy eat(Resident& resident, Food& plants, Food& flesh) {
    Energy rest = 0;
    for (const Mouth& mouth : resident.mouths()) {
        const Rectangle& place = resident.rectangles()[mouth.part];
        const Energy grazed = eat_of(plants, place, share_of_plants(mouth.diet), rest);
        const Energy scavenged = eat_of(flesh, place, share_of_flesh(mouth.diet), rest);
        resident.life.eaten_plants += grazed;
        resident.life.eaten_flesh += scavenged;
        resident.store += grazed + scavenged;
    }
    return rest;
}

double bite_distance(const PreserveSettings& laws) {
    return is_solid(laws) ? kSolidBite : 0.0;
}

// A body that bounced off may be as far away as it gets within a tick.
double bite_reach(const Resident& resident, const PreserveSettings& laws) {
    const double recoil = laws.ramming > 0.0 ? resident.fastest() * kBrainTick : 0.0;
    return bite_distance(laws) + recoil;
}

void bite(Resident& biter, Resident& victim, const BiteRules& rules, Food& flesh) {
    const PreserveSettings& laws = rules.laws;
    if (biter.store <= 0) return;
    if (is_young_child_of(biter, victim, laws, rules.tick) ||
        is_young_child_of(victim, biter, laws, rules.tick))
        return;
    for (const Mouth& mouth : biter.mouths()) {
        const Rectangle& place = biter.rectangles()[mouth.part];
        const std::size_t part =
            bitten_part(place, bite_distance(laws), victim.rectangles(), rules.torus);
        const bool is_held = part < victim.rectangles().size();
        const Ram ram = ram_of(biter, mouth, victim);
        if (!is_held && ram.lost == 0.0) continue;
        const double share = share_of_flesh(mouth.diet);
        const double power = is_held ? share * laws.bite_power * mouth.width : 0.0;
        const double wanted = power * kBrainTick + share * laws.ramming * ram.lost;
        const Energy taken = std::min(victim.store + victim.body, energy_of(wanted));
        if (taken == 0) continue;
        const Energy crumbs = taken / kBittenOff;
        take_energy(victim, taken);
        biter.store += taken - crumbs;
        biter.life.bitten += taken - crumbs;
        flesh.add_near(is_held ? victim.rectangles()[part].center : ram.place, crumbs,
                       kCrumbDistance);
    }
}

Energy spend(Resident& resident, const PreserveSettings& laws, std::uint64_t tick) {
    double signals = 0.0;  // of organs, each up to 1
    for (const Sound& sound : resident.emissions().sounds)
        signals += sound.loudness;
    for (const Scent& scent : resident.emissions().scents)
        signals += scent.amount / kBrainTick;
    const Life& life = resident.life;
    const double upkeep = (laws.body_upkeep * life.mass + laws.neuron_upkeep * life.neurons +
                           laws.organ_upkeep * signals) *
                          (1.0 + resident.age(tick) / laws.aging_time);
    const Energy needed = energy_of(resident.work() / laws.efficiency + upkeep * kBrainTick);
    const Energy spent = std::min(resident.store, needed);
    resident.store -= spent;
    return spent;
}

void decay_to_flesh(Resident& resident, Food& flesh) {
    const Energy all = resident.store + resident.body;
    Energy left = all;
    const auto& parts = resident.phenotype().parts;
    double area = 0.0;
    for (const BodyPart& part : parts)
        area += part.length * part.width;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const bool last = i + 1 == parts.size();
        const Energy share =
            last ? left : std::min(left, share_of(all, parts[i].length * parts[i].width / area));
        flesh.add(resident.rectangles()[i].center, share);
        left -= share;
    }
    resident.store = 0;
    resident.body = 0;
}

}  // namespace cambrian
