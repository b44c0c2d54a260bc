#pragma once

// Registers the kinds of organs, one file each.

#include "organs/organ.h"

namespace cambrian {

void add_sound_organ(OrganRegistry& organs);
void add_scent_organ(OrganRegistry& organs);
void add_deformer_organ(OrganRegistry& organs);
void add_mouth_organ(OrganRegistry& organs);

}  // namespace cambrian
