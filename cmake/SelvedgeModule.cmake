# Declares the rooms of the house (see docs/architecture.md) and their tests.

add_library(selvedge_flags INTERFACE)
target_compile_options(selvedge_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>  # g++ 12: false alarms on std::string +
   $<$<COMPILE_LANGUAGE:CXX>:-Wconversion> -ffp-contract=off
  $<$<BOOL:${SELVEDGE_WERROR}>:-Werror>)
if(SELVEDGE_SANITIZE STREQUAL "address")
  target_compile_options(selvedge_flags INTERFACE -fsanitize=address,undefined -fno-omit-frame-pointer
    -fno-sanitize-recover=undefined)
  target_link_options(selvedge_flags INTERFACE -fsanitize=address,undefined)
elseif(SELVEDGE_SANITIZE STREQUAL "thread")
  target_compile_options(selvedge_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(selvedge_flags INTERFACE -fsanitize=thread)
elseif(SELVEDGE_SANITIZE)
  message(FATAL_ERROR "SELVEDGE_SANITIZE is address, thread or empty, not '${SELVEDGE_SANITIZE}'")
endif()

if(SELVEDGE_FUZZ)
  target_compile_options(selvedge_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# selvedge_module(NAME SOURCES ... HEADERS ... [USES module ...] [LINK target ...] [PRIVATE_LINK target ...])
# makes the library selvedge::NAME from the room that this CMakeLists.txt stands in.
# Headers form a file set, so that each must compile alone.
function(selvedge_module NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;HEADERS;USES;LINK;PRIVATE_LINK" ${ARGN})
  set(target selvedge_${NAME})
  if(ARG_SOURCES)
    add_library(${target} STATIC ${ARG_SOURCES})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE selvedge_flags ${ARG_PRIVATE_LINK})
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  target_sources(${target} ${scope} FILE_SET HEADERS BASE_DIRS ${CMAKE_SOURCE_DIR} FILES ${ARG_HEADERS})
  foreach(used ${ARG_USES})
    target_link_libraries(${target} ${scope} selvedge::${used})
  endforeach()
  target_link_libraries(${target} ${scope} ${ARG_LINK})
  add_library(selvedge::${NAME} ALIAS ${target})
endfunction()

# selvedge_test(NAME SOURCES ... USES module ... [LABELS ...] [LINK ...] [TOGETHER suite])
# makes one GoogleTest program. ctest runs each of its tests in a process of its own, but those of the suite TOGETHER in
# one, for they share what is costly to prepare.
function(selvedge_test NAME)
  cmake_parse_arguments(ARG "" "TOGETHER" "SOURCES;USES;LABELS;LINK" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  set(target test_${NAME})
  add_executable(${target} ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${CMAKE_SOURCE_DIR})
  foreach(used ${ARG_USES})
    target_link_libraries(${target} PRIVATE selvedge::${used})
  endforeach()
  target_link_libraries(${target} PRIVATE selvedge_flags GTest::gtest_main ${ARG_LINK})
  target_compile_definitions(${target} PRIVATE SELVEDGE_SOURCE_DIR="${CMAKE_SOURCE_DIR}")
  set(alone "*")
  if(ARG_TOGETHER)
    set(alone "-${ARG_TOGETHER}.*")
    add_test(NAME ${ARG_TOGETHER} COMMAND ${target} --gtest_filter=${ARG_TOGETHER}.*)
    set_tests_properties(${ARG_TOGETHER} PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 600)
  endif()
  gtest_discover_tests(${target} TEST_FILTER "${alone}" DISCOVERY_TIMEOUT 60
    PROPERTIES LABELS "${ARG_LABELS}" TIMEOUT 600)
endfunction()

# selvedge_simd_sources(AVX2 file ... AVX512 file ...)
# compiles these sources of the room for those instructions (sim/core/simd_level.h). Such a file may hold nothing that
# the linker could take for another file's: what it defines inline is always inlined or has internal linkage.
function(selvedge_simd_sources)
  cmake_parse_arguments(ARG "" "" "AVX2;AVX512" ${ARGN})
  set_source_files_properties(${ARG_AVX2} PROPERTIES COMPILE_OPTIONS "-mavx2;-mfma")
  set_source_files_properties(${ARG_AVX512} PROPERTIES COMPILE_OPTIONS
    "-mfma;-mavx512f;-mavx512bw;-mavx512dq;-mavx512vl;-mprefer-vector-width=512;-Wno-maybe-uninitialized;-Wno-uninitialized")  # g++ 12: false
endfunction()
