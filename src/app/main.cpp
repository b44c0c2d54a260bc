#include "app/command_line.h"
#include "app/process/messages.h"
#include "app/process/process.h"

#include <exception>
#include <new>
#include <system_error>

int main(int argc, char** argv) {
    using cambrian::ExitStatus;
    ExitStatus status = ExitStatus::kFailed;
    try {
        const cambrian::Status prepared = cambrian::prepare_process();
        status = prepared ? cambrian::run_command_line(argc, argv)
                          : cambrian::fail(prepared.error(), ExitStatus::kFailed);
    } catch (const std::bad_alloc&) {
        cambrian::say("out of memory");
    } catch (const std::system_error& failure) {
        const bool threads = failure.code() == std::errc::resource_unavailable_try_again;
        cambrian::say(threads ? "the system lets this program start no more threads; --threads N "
                                "asks for fewer"
                              : failure.what());
    } catch (const std::exception& failure) {
        cambrian::say(failure.what());
    }
    return static_cast<int>(status);
}
