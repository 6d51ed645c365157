#pragma once
// Bodies and their clips as bytes (sim/core/flat_bytes.h), for another process and for a store on disk.
#include <optional>
#include <string>
#include <string_view>

#include "sim/body/body.h"
#include "sim/body/clip.h"
#include "sim/core/flat_bytes.h"

namespace selvedge::sim {

void write(FlatWriter& writer, const Bone& bone);
void read(FlatReader& reader, Bone& bone);

// A clip as files hold it: no loop. The reader is no longer sound if keys and times differ in number.
void write(FlatWriter& writer, const Clip& clip);
void read(FlatReader& reader, Clip& clip);

std::string to_bytes(const Body& body);

// nullopt when the bytes are not a valid Body: every number finite, every index in range.
std::optional<Body> body_from_bytes(std::string_view bytes);

}  // namespace selvedge::sim
