#pragma once

#include "cluster/units/unit_child.h"

namespace cambrian {

// A ChildProcess that runs this program as `cambrian worker --unit`.
Result<ChildEnd> run_unit_process(std::string_view question, const std::stop_token& stop);

}  // namespace cambrian
