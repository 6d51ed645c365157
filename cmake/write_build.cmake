# Run at each build: writes OUTPUT, the source that tells --version what the program was built from, if that has changed.
# SOURCE: the checkout. No date: the same sources give the same bits.
set(commit "")
find_program(GIT git)
if(GIT)
  # Not the commit of another project, in whose checkout this one was unpacked.
  execute_process(COMMAND ${GIT} rev-parse --show-toplevel WORKING_DIRECTORY ${SOURCE}
    OUTPUT_VARIABLE top OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
  file(REAL_PATH ${SOURCE} source)
  if(result EQUAL 0 AND top STREQUAL source)
    execute_process(COMMAND ${GIT} rev-parse --short=12 HEAD WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE commit OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE result)
    execute_process(COMMAND ${GIT} --no-optional-locks status --porcelain --untracked-files=no WORKING_DIRECTORY ${SOURCE}
      OUTPUT_VARIABLE changes ERROR_QUIET)
    if(NOT result EQUAL 0)
      set(commit "")
    elseif(changes)
      string(APPEND commit ", changed")
    endif()
  endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
// Made by write_build.cmake.
#include "app/version_text.h"

selvedge::app::Build selvedge::app::program_build() {
    return {.commit = "@commit@", .compiler = "@COMPILER@", .type = "@TYPE@"};
}
]])
