#include "app/last_body.h"

#include <algorithm>
#include <iterator>
#include <new>
#include <system_error>

#include "app/body_buffers.h"
#include "sim/core/error.h"
#include "sim/core/parallel.h"

namespace selvedge::app {
namespace {

bool is_same(const BodyOptions& a, const BodyOptions& b) {
    return a.source == b.source && a.load.unit == b.load.unit && a.load.up == b.load.up &&
           a.load.stands_on_floor == b.load.stands_on_floor;
}

// Of its files, if it has any. The earliest time of one that is not there.
std::vector<std::filesystem::file_time_type> times_of(const BodyOptions& options) {
    if (!options.is_file()) return {};
    std::vector<std::filesystem::path> files{options.source};
    std::ranges::move(buffers_beside(options.source), std::back_inserter(files));
    std::vector<std::filesystem::file_time_type> times;
    for (const std::filesystem::path& file : files) {
        std::error_code error;
        times.push_back(std::filesystem::last_write_time(file, error));
    }
    return times;
}

}  // namespace

std::shared_ptr<const sim::PreparedBody> prepare_body(const BodyOptions& options, const sim::ContentStore* store) {
    auto prepared = std::make_shared<const sim::PreparedBody>(make_body(options, store));
    prepared->collider({}, store);
    prepared->own_collider({}, store);
    return prepared;
}

void LastBody::prepare(const BodyOptions& options) {
    const auto written = times_of(options);
    if (entry_ && is_same(entry_->options, options) && entry_->written == written) return;
    const sim::ThreadLimit alone(1);  // a process with more threads cannot be copied
    entry_ = Entry{options, written, nullptr};
    try {
        entry_->body = prepare_body(options, store_);
    } catch (const sim::InputError&) {
    } catch (const std::bad_alloc&) {
    }
}

std::shared_ptr<const sim::PreparedBody> LastBody::find(const BodyOptions& options) const {
    const bool has_it = entry_ && is_same(entry_->options, options) && entry_->written == times_of(options);
    return has_it ? entry_->body : nullptr;
}

}  // namespace selvedge::app
