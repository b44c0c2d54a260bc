#pragma once

// The creatures of a preserve: how they come into it, breed and die (preserve/README.md 6), and the
// lineages of the living.

#include "preserve/life/room.h"
#include "preserve/preserve_world.h"
#include "preserve/state.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace cambrian {

class Population {
public:
    // The world must outlive it. Founders must be valid and are used in turn.
    Population(PreserveWorld& world, std::vector<GenomePtr> founders);

    const Residents& living() const { return residents_; }
    // Adds the founders that the settings ask for. Fails if one cannot live in this world.
    Status found();
    // Adds a creature as near to a place as there is room; the light pays it. Returns its number.
    Result<std::uint64_t> admit(const GenomePtr& genome, const Vec3& place);
    // Moves a creature as near to a place as there is room. It is at rest then but for its joints.
    Status move(std::uint64_t number, const Vec3& place);
    // Ends a life; its energy becomes flesh.
    Status remove(std::uint64_t number);
    // Moves all creatures that these walls meet, or none if there is no room for one of them.
    Status make_way(const DrawnWalls& walls);

    // The phases of a tick. Those whose store is empty or whose motion failed die in that tick.
    void bury(std::uint64_t tick);
    void breed();
    void restock();
    // Tells everybody how much it has in store.
    void feel_energy();
    // Takes the creature that has borne the most children into the museum.
    void remember_parent();

    void save(PreserveState& state) const;
    // Returns false if these are no creatures of this world, of which the rest is restored.
    bool restore(const PreserveState& state);

private:
    Room room() const;
    Result<std::unique_ptr<Resident>> grow(Life life) const;
    Result<std::unique_ptr<Resident>> newcomer(std::size_t place, std::string method);
    Life arriving(const GenomePtr& genome, std::string method) const;
    Energy price_of(const Resident& resident) const;
    void welcome(std::unique_ptr<Resident> resident);
    void take_in(std::unique_ptr<Resident> resident);
    void join_lineage(Resident& resident, const Resident* parent);
    void forget_lineages();
    void end_life(Resident& resident, std::uint64_t tick);
    void try_birth(Resident& parent);
    void bear(Resident& parent, std::unique_ptr<Resident> child, RandomStream& stream);
    void remember_lineage(std::uint64_t lineage);
    Residents::iterator find(std::uint64_t number);

    PreserveWorld& world_;
    std::vector<GenomePtr> founders_;
    Residents residents_;
    std::map<std::uint64_t, GenomePtr> lineages_;  // founders by number
    std::uint64_t next_number_ = 1;
    std::uint64_t attempts_ = 0;   // at a birth
    std::uint64_t restocked_ = 0;  // newcomers
};

}  // namespace cambrian
