#pragma once
// What the shared library shows to programs that are linked with it: SELVEDGE_API stands before each public function
// and class. All else in the library is hidden.

#define SELVEDGE_API __attribute__((visibility("default")))
