#include "preserve/state.h"

#include "core/hash.h"

#include <bit>
#include <cmath>

namespace cambrian {
namespace {

class WordWriter {
public:
    void put(std::uint64_t word) { words_.push_back(word); }
    void put(std::uint32_t word) { words_.push_back(word); }
    void put(Energy energy) { words_.push_back(static_cast<std::uint64_t>(energy)); }
    void put(double number) { words_.push_back(std::bit_cast<std::uint64_t>(number)); }
    void put(const std::vector<double>& numbers) {
        put(std::uint64_t{numbers.size()});
        for (const double number : numbers)
            put(number);
    }
    std::vector<std::uint64_t> take() { return std::move(words_); }

private:
    std::vector<std::uint64_t> words_;
};

// Reads the numbers back. After a fault, everything reads as 0.
class WordReader {
public:
    explicit WordReader(std::span<const std::uint64_t> words) : words_(words) {}

    void get(std::uint64_t& word) {
        word = 0;
        if (at_ == words_.size()) sound_ = false;
        if (sound_) word = words_[at_++];
    }
    void get(std::uint32_t& number) {
        std::uint64_t word = 0;
        get(word);
        number = static_cast<std::uint32_t>(word);
        if (word != number) sound_ = false;
    }
    void get(Energy& energy) {
        std::uint64_t word = 0;
        get(word);
        energy = static_cast<Energy>(word);
        if (energy < 0) sound_ = false;
    }
    void get(double& number) {
        std::uint64_t word = 0;
        get(word);
        number = std::bit_cast<double>(word);
        if (!std::isfinite(number)) sound_ = false;
    }
    void get(std::vector<double>& numbers) {
        numbers.resize(count());
        for (double& number : numbers)
            get(number);
    }
    // Returns a number of items, which cannot be more than the words that are left.
    std::size_t count() {
        std::uint64_t word = 0;
        get(word);
        if (word > words_.size() - at_) sound_ = false;
        return sound_ ? word : 0;
    }
    bool sound() const { return sound_; }
    bool at_end() const { return at_ == words_.size(); }
    bool finished() const { return sound_ && at_ == words_.size(); }

private:
    std::span<const std::uint64_t> words_;
    std::size_t at_ = 0;
    bool sound_ = true;
};

// The following functions visit the members of a state in the order of the words; `Words` is a
// function object for each member.
template <class Life, class Words>
void visit_life(Life& life, Words& words) {
    words(life.number);
    words(life.uid);
    words(life.parents[0]);
    words(life.parents[1]);
    words(life.lineage);
    words(life.mutations);
    words(life.born);
    words(life.x);
    words(life.y);
    words(life.mass);
    words(life.parts);
    words(life.neurons);
    words(life.diet);
    words(life.eaten_plants);
    words(life.eaten_flesh);
    words(life.bitten);
    words(life.lost);
    words(life.children);
}

template <class Resident, class Words>
void visit_resident(Resident& resident, Words& words) {
    visit_life(resident.life, words);
    words(resident.store);
    words(resident.body);
    words(resident.last_birth);
    words(resident.motion.positions);
    words(resident.motion.speeds);
    words(resident.motion.targets);
    words(resident.brain_values);
    words(resident.brain_memory);
    words(resident.sensor_memory);
    words(resident.effector_memory);
}

template <class State, class Words>
void visit_head(State& state, Words& words) {
    words(state.tick);
    words(state.next_number);
    words(state.attempts);
    words(state.restocked);
    words(state.ambient);
}

void put_pellets(const std::vector<Pellet>& pellets, WordWriter& writer) {
    writer.put(std::uint64_t{pellets.size()});
    for (const Pellet& pellet : pellets) {
        writer.put(pellet.x);
        writer.put(pellet.y);
        writer.put(pellet.energy);
    }
}

void get_pellets(WordReader& reader, std::vector<Pellet>& pellets) {
    pellets.resize(reader.count());
    for (Pellet& pellet : pellets) {
        reader.get(pellet.x);
        reader.get(pellet.y);
        reader.get(pellet.energy);
    }
}

template <class Wall, class Words>
void visit_wall(Wall& wall, Words& words) {
    words(wall.from.x());
    words(wall.from.y());
    words(wall.to.x());
    words(wall.to.y());
}

// A world without walls has no words for them.
void put_walls(const std::vector<WallLine>& walls, WordWriter& writer) {
    if (walls.empty()) return;
    writer.put(std::uint64_t{walls.size()});
    const auto put = [&](const auto& member) { writer.put(member); };
    for (const WallLine& wall : walls)
        visit_wall(wall, put);
}

void get_walls(WordReader& reader, std::vector<WallLine>& walls) {
    if (reader.at_end()) return;
    walls.resize(reader.count());
    const auto get = [&](auto& member) { reader.get(member); };
    for (WallLine& wall : walls)
        visit_wall(wall, get);
}

Status find_origins(PreserveState& state, const FindOrigin& find) {
    for (ResidentState& resident : state.residents) {
        Result<Origin> origin = find(resident.life.number);
        if (!origin) return origin.error();
        resident.life.genome = origin->genome;
        resident.life.method = origin->method;
    }
    for (Lineage& lineage : state.lineages) {
        Result<Origin> origin = find(lineage.number);
        if (!origin) return origin.error();
        lineage.genome = origin->genome;
    }
    return {};
}

}  // namespace

std::vector<std::uint64_t> words_of(const PreserveState& state) {
    WordWriter writer;
    const auto put = [&](const auto& member) { writer.put(member); };
    visit_head(state, put);
    put_pellets(state.plants, writer);
    put_pellets(state.flesh, writer);
    writer.put(std::uint64_t{state.lineages.size()});
    for (const Lineage& lineage : state.lineages)
        writer.put(lineage.number);
    writer.put(std::uint64_t{state.residents.size()});
    for (const ResidentState& resident : state.residents)
        visit_resident(resident, put);
    for (const auto* field : {&state.scents.scent, &state.scents.plants, &state.scents.flesh})
        writer.put(field->cells);
    put_walls(state.walls, writer);
    return writer.take();
}

std::uint64_t digest_of(std::span<const std::uint64_t> words) {
    Hash64 hash;
    for (const std::uint64_t word : words)
        hash.add(word);
    return hash.value();
}

Result<PreserveState> state_of(std::span<const std::uint64_t> words, const FindOrigin& find) {
    WordReader reader(words);
    const auto get = [&](auto& member) { reader.get(member); };
    PreserveState state;
    visit_head(state, get);
    get_pellets(reader, state.plants);
    get_pellets(reader, state.flesh);
    state.lineages.resize(reader.count());
    for (Lineage& lineage : state.lineages)
        reader.get(lineage.number);
    const std::size_t residents = reader.count();
    for (std::size_t i = 0; i < residents && reader.sound(); ++i)
        visit_resident(state.residents.emplace_back(), get);
    for (auto* field : {&state.scents.scent, &state.scents.plants, &state.scents.flesh}) {
        reader.get(field->cells);
        field->any = !field->cells.empty();
    }
    get_walls(reader, state.walls);
    if (!reader.finished()) return Error{"the snapshot is damaged"};
    if (Status found = find_origins(state, find); !found) return found.error();
    return state;
}

}  // namespace cambrian
