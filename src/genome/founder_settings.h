#pragma once

#include <map>
#include <string>

namespace cambrian {

// Limits of random genomes (genome/README.md 4). Mutation uses them to see which kinds are enabled.
struct FounderSettings {
    int min_nodes = 2;
    int max_nodes = 5;
    double min_length = 0.2;  // m
    double max_length = 1.2;
    double min_width = 0.1;  // m
    double max_width = 0.5;
    double moving_share = 0.8;  // share of joints that move
    double symmetric_share = 0.5;
    int max_node_neurons = 3;
    int max_brain_neurons = 2;
    int max_recursion = 4;
    double rhythmic_share = 0.0;  // share of genomes whose limbs follow one rhythm
    // Whether a kind may be used, by id. Functions and kinds of references that are not listed may
    // be used. Of joints, sensor channels and organs that are not listed, the usual ones may
    // (genome/kind_catalog.h).
    std::map<std::string, bool> functions = {};
    std::map<std::string, bool> joints = {};
    std::map<std::string, bool> channels = {};
    std::map<std::string, bool> references = {};
    std::map<std::string, bool> organs = {};

    friend bool operator==(const FounderSettings&, const FounderSettings&) = default;
};

}  // namespace cambrian
