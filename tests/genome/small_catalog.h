#pragma once

#include "genome/kind_catalog.h"

namespace cambrian {

// Returns a catalog with functions of every arity, one of them with a founder's range, and the
// planar joints and channels.
inline KindCatalog small_catalog() {
    KindCatalog catalog;
    catalog.functions = {
        {"sum", "Sum", 3, {}},
        {"product", "Product", 2, {}},
        {"abs", "Absolute", 1, {}},
        {"oscillate-wave", "Wave", 2, {{0.8, 0.3, 2.0}, {0.8, -0.5, 0.5}}},
    };
    catalog.joints = {
        {"rigid", "Rigid", 0}, {"rotary", "Rotary", 1}, {"linear", "Linear", 1, false}};
    catalog.effectors = {{"joint", "Joint"}};
    catalog.organs = {{"voice",
                       "Voice",
                       {{.name = "band",
                         .key = "band",
                         .low = 0.0,
                         .high = 3.0,
                         .fallback = 0.0,
                         .step = {.relative = 0.2, .floor = 3.0},
                         .whole = true}}},
                      {"gland", "Gland", {}},
                      {"bender", "Bender", {}, false, true}};
    catalog.channels = {{"joint", "Joint"},
                        {"contact-distal", "Distal"},
                        {"contact-left", "Left"},
                        {"contact-proximal", "Proximal"},
                        {"contact-right", "Right"}};
    catalog.reproductions = {"inherit", "asexual", "crossover", "grafting"};
    return catalog;
}

}  // namespace cambrian
