#include "selvedge/errors.h"

#include <new>
#include <utility>

#include "selvedge/content.h"
#include "sim/core/argument_name.h"
#include "sim/core/error.h"
#include "sim/core/passing_error.h"
#include "sim/core/printable.h"

namespace selvedge {

InputError::InputError(std::string file, std::string place, std::string problem, Lasting lasting)
    : std::runtime_error(sim::fault_line(file, place, problem)),
      file_(std::move(file)),
      place_(std::move(place)),
      problem_(std::move(problem)),
      lasting_(lasting) {}

InputError::InputError(const InputError&) = default;

InputError::~InputError() = default;

Cancelled::~Cancelled() = default;

const char* Cancelled::what() const noexcept {
    return "the dressing was cancelled";
}

void throw_for_caller() {
    const auto translated = [](const sim::InputError& error, InputError::Lasting lasting) {
        return InputError(error.file(), sim::argument_name(error.place()), error.problem(), lasting);
    };
    try {
        throw;
    } catch (const sim::PassingError& error) {
        throw translated(error, InputError::Lasting::ThisTime);
    } catch (const sim::InputError& error) {
        throw translated(error, InputError::Lasting::Always);
    } catch (const InputError&) {
        throw;
    } catch (const std::bad_alloc&) {
        throw;
    } catch (const std::exception& error) {  // of the standard library: an argument that no check above has refused
        throw InputError("", "", error.what());
    }
}

}  // namespace selvedge
