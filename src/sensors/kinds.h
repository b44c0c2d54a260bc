#pragma once

// The sensor kinds; one file each.

#include "sensors/sensor.h"

namespace cambrian {

void add_joint_sensor(SensorRegistry& sensors);
void add_contact_sensor(SensorRegistry& sensors);

}  // namespace cambrian
