#include "golden/audit.h"

namespace cambrian::golden {

void add_audit(Hash64& hash, const SceneAudit& audit) {
    for (const double number :
         {audit.motor_work, audit.gross_motor_work, audit.drag_work, audit.contact_work,
          audit.limit_work, audit.impulse_work, audit.positive_work, audit.energy_residual,
          audit.energy_scale, audit.max_penetration, audit.max_limit_overrun, audit.max_part_speed,
          audit.max_part_spin})
        hash.add(number);
    for (const std::uint64_t count :
         {audit.evaluations, audit.steps, audit.rejections, audit.events, audit.fallbacks})
        hash.add(count);
}

}  // namespace cambrian::golden
