#pragma once

#include <map>
#include <string>

namespace cambrian {

// What the user allows in random genomes (genome/README.md 4) and, as far as enabled, in mutation.
struct FounderSettings {
    int min_nodes = 2;
    int max_nodes = 5;
    double min_length = 0.2;  // m
    double max_length = 1.2;
    double min_width = 0.1;  // m
    double max_width = 0.5;
    double rotary_share = 0.8;  // of joints that move, against rigid ones
    double symmetric_share = 0.5;
    int max_node_neurons = 3;
    int max_brain_neurons = 2;
    int max_recursion = 4;
    // Whether a kind may be used, by id. Of kinds not named all functions and kinds of references
    // may, and the usual joints and sensor channels (genome/kind_catalog.h).
    std::map<std::string, bool> functions = {};
    std::map<std::string, bool> joints = {};
    std::map<std::string, bool> channels = {};
    std::map<std::string, bool> references = {};

    friend bool operator==(const FounderSettings&, const FounderSettings&) = default;
};

}  // namespace cambrian
