#pragma once
// What a person sees first: three examples, the files of last time, the keys that matter most.

namespace selvedge {

struct Desk;

void show_start_page(Desk& desk);

}  // namespace selvedge
