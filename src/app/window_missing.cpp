// The window of a program built without one.
#include "app/messages.h"
#include "app/window.h"

namespace cambrian {

Status display_status() {
    return Error{"this program was built without its window"};
}

ExitStatus run_window(const WindowOptions& /*options*/, const EvolutionKinds& /*kinds*/) {
    return fail(display_status().error(), ExitStatus::kFailed);
}

}  // namespace cambrian
