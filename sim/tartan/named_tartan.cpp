#include "sim/tartan/named_tartan.h"

#include "sim/core/error.h"
#include "sim/tartan/tartan_file.h"

namespace selvedge::sim {

Sett named_tartan(const std::string& name, const std::string& file, const std::string& place) {
    try {
        return find_tartan(name);
    } catch (const InputError& error) {
        const std::string stripe = error.place() == "tartan" || error.place().empty() ? "" : error.place() + ": ";
        throw InputError(file, place, stripe + error.problem());
    }
}

}  // namespace selvedge::sim
