#pragma once

#include "cluster/units/unit_child.h"

namespace cambrian {

// Runs this very program as `cambrian worker --unit`; a ChildProcess.
Result<ChildEnd> run_unit_process(std::string_view question, const std::stop_token& stop);

}  // namespace cambrian
