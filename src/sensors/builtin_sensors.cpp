#include "sensors/kinds.h"

namespace cambrian {

// The order fixes the absolute channel numbers genes hold: new kinds go to the end.
SensorRegistry builtin_sensors() {
    SensorRegistry sensors;
    add_joint_sensor(sensors);
    add_contact_sensor(sensors);
    return sensors;
}

}  // namespace cambrian
