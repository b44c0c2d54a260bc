#pragma once

#include <string>

namespace cambrian {

// The laws of a preserve (preserve/README.md).
struct PreserveSettings {
    double width = 40.0;            // m
    double height = 25.0;           // m
    std::string edges = "walls";    // "walls" or "wrap"
    std::string bodies = "solid";   // "solid" or "ghostly"
    int founders = 40;              // creatures at the start
    int max_population = 300;       // no births beyond
    int restock = 8;                // copies of founders come below so many creatures; 0 for never
    double energy_density = 50.0;   // J/m^2; all energy there is, over the area
    double plant_energy = 10.0;     // J of one plant
    double plant_height = 0.5;      // m; with ground, up to which plants grow
    double growth_time = 120.0;     // s; time constant at which light becomes plants
    double efficiency = 1.0;        // share of the spent energy that becomes work of the motors
    double body_upkeep = 0.5;       // W/kg
    double neuron_upkeep = 0.002;   // W for each connected neuron
    double organ_upkeep = 0.2;      // W for an organ at its full signal
    double aging_time = 600.0;      // s; age at which upkeep has doubled
    double flesh_half_life = 60.0;  // s
    double bite_power = 40.0;       // W for each metre of a mouth's width
    double ramming = 0.0;           // J taken for each J that a mouth's impact took; 0: none
    double birth_energy = 100.0;    // J/kg; store of a newborn
    double body_energy = 20.0;      // J/kg bound in a body
    double kin_peace = 20.0;        // s from birth without bites between parent and child
    double birth_interval = 5.0;    // s between two births of a parent
    double mate_distance = 6.0;     // m
    std::string walls;              // as walls_of() reads them
    std::string patches;            // as patches_of() reads them; none: plants grow everywhere

    friend bool operator==(const PreserveSettings&, const PreserveSettings&) = default;
};

inline bool wraps(const PreserveSettings& settings) {
    return settings.edges == "wrap";
}

inline bool is_solid(const PreserveSettings& settings) {
    return settings.bodies == "solid";
}

}  // namespace cambrian
