#include "app/command_line.h"
#include "app/messages.h"
#include "app/process.h"

#include <exception>
#include <new>

int main(int argc, char** argv) {
    using cambrian::ExitStatus;
    ExitStatus status = ExitStatus::kFailed;
    try {
        const cambrian::Status prepared = cambrian::prepare_process();
        status = prepared ? cambrian::run_command_line(argc, argv)
                          : cambrian::fail(prepared.error(), ExitStatus::kFailed);
    } catch (const std::bad_alloc&) {
        cambrian::say("out of memory");
    } catch (const std::exception& failure) {
        cambrian::say(failure.what());
    }
    return static_cast<int>(status);
}
