#pragma once
// A body that one process holds ready for others that are copies of it, so that these neither read it nor build its
// collider.
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "app/options.h"
#include "sim/core/content_store.h"
#include "sim/dress/prepared_body.h"

namespace selvedge::app {

// The body of make_body(), with its colliders. store: null for none. Throws InputError as make_body() does.
std::shared_ptr<const sim::PreparedBody> prepare_body(const BodyOptions& options, const sim::ContentStore* store);

// Holds the body that was asked for last. More would take memory of every process.
class LastBody {
 public:
    explicit LastBody(const sim::ContentStore* store) : store_(store) {}

    // Makes the body ready on this thread, if it is not. One that cannot be made is left to whoever needs it.
    void prepare(const BodyOptions& options);
    // Null if that body is not ready, or a file of it was written since.
    std::shared_ptr<const sim::PreparedBody> find(const BodyOptions& options) const;

 private:
    struct Entry {
        BodyOptions options;
        std::vector<std::filesystem::file_time_type> written;  // its files
        std::shared_ptr<const sim::PreparedBody> body;         // null: it could not be made
    };

    const sim::ContentStore* store_;
    std::optional<Entry> entry_;
};

}  // namespace selvedge::app
