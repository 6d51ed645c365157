#pragma once
// fork() in Python, as multiprocessing does on Linux: a child can do what its parent can.

namespace selvedge::python {

// Registers with Python what is done before and after a fork: no thread draws meanwhile, and no thread of parallel
// loops is left, which the child would miss. Mesa's threads: render/gl/context.cpp.
void survive_forks();

}  // namespace selvedge::python
