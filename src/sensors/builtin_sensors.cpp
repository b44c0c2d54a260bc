#include "sensors/kinds.h"

namespace cambrian {

namespace {

// Digests of genes include channel numbers in this order, so new kinds must be added at the end of
// one of the two lists below.
SensorRegistry common_sensors() {
    SensorRegistry sensors;
    add_joint_sensor(sensors);
    add_contact_sensor(sensors);
    add_accelerometer(sensors);
    add_joint_rate_sensor(sensors);
    add_effort_sensor(sensors);
    add_spin_sensor(sensors);
    add_balance_sensor(sensors);
    add_load_sensor(sensors);
    add_light_sensor(sensors);
    add_sound_sensor(sensors);
    add_smell_sensor(sensors);
    add_stretch_sensor(sensors);
    add_food_smell_sensor(sensors);
    add_hunger_sensor(sensors);
    return sensors;
}

}  // namespace

SensorRegistry builtin_sensors() {
    SensorRegistry sensors = common_sensors();
    add_obstacle_sensor(sensors);
    add_whisker_sensor(sensors);
    add_rise_sensor(sensors);
    return sensors;
}

SensorRegistry spatial_sensors() {
    SensorRegistry sensors = common_sensors();
    add_second_degree_sensor(sensors);
    add_flat_contact_sensor(sensors);
    add_third_degree_sensor(sensors);
    add_further_rate_sensor(sensors);
    add_further_effort_sensor(sensors);
    return sensors;
}

}  // namespace cambrian
