#pragma once

// The opponents of contests in an experiment file. Files without contests do not have their table.
// Throws DatabaseError.

#include "evolution/kinds/evolution_kinds.h"
#include "persist/sqlite/database.h"
#include "simulator/contest/opponents.h"

#include <cstdint>

namespace cambrian {

// Writes the opponents that belong to a row of settings, if there are any.
void write_opponents(Database& database, std::int64_t settings_row, const Opponents& opponents,
                     const EvolutionKinds& kinds);

Opponents read_opponents(const Database& database, std::int64_t settings_row,
                         const EvolutionKinds& kinds);

}  // namespace cambrian
