#pragma once

// Registers the sensor kinds, in the order of builtin_sensors().

#include "sensors/sensor.h"

namespace cambrian {

void add_joint_sensor(SensorRegistry& sensors);
void add_second_degree_sensor(SensorRegistry& sensors);
void add_third_degree_sensor(SensorRegistry& sensors);
void add_further_rate_sensor(SensorRegistry& sensors);
void add_further_effort_sensor(SensorRegistry& sensors);
void add_flat_contact_sensor(SensorRegistry& sensors);
void add_contact_sensor(SensorRegistry& sensors);
void add_accelerometer(SensorRegistry& sensors);
void add_joint_rate_sensor(SensorRegistry& sensors);
void add_effort_sensor(SensorRegistry& sensors);
void add_spin_sensor(SensorRegistry& sensors);
void add_balance_sensor(SensorRegistry& sensors);
void add_load_sensor(SensorRegistry& sensors);
void add_light_sensor(SensorRegistry& sensors);
void add_sound_sensor(SensorRegistry& sensors);
void add_smell_sensor(SensorRegistry& sensors);
void add_stretch_sensor(SensorRegistry& sensors);
void add_food_smell_sensor(SensorRegistry& sensors);
void add_hunger_sensor(SensorRegistry& sensors);
void add_obstacle_sensor(SensorRegistry& sensors);
void add_whisker_sensor(SensorRegistry& sensors);
void add_rise_sensor(SensorRegistry& sensors);

}  // namespace cambrian
