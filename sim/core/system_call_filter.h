#pragma once
// Takes from a process what reading a file does not need (Linux seccomp): a file that takes over its reader gains
// nothing.

namespace selvedge::sim {

// From now on this process may open files for reading only, write to `answer_end` and to the standard output and error,
// and take memory of its own. Any other system call kills it with SIGSYS: one that writes, renames or deletes a file,
// opens a socket, starts a program or a process, traces another, or makes memory executable, or shared and writable.
// What is open already can still be read: close it before. Returns false, and forbids nothing, where the kernel has no
// such filters. It cannot be undone.
bool forbid_all_but_reading(int answer_end);

}  // namespace selvedge::sim
