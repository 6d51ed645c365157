# Declares the modules (docs/modules.md) and their tests. A module is a folder, and its target is named after it:
# sim/mesh is selvedge::sim_mesh. A file that is added to a folder is found when the build runs next.

add_library(selvedge_flags INTERFACE)
target_compile_options(selvedge_flags INTERFACE
  -Wall -Wextra -Wpedantic -Wshadow
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict$<SEMICOLON>-Wno-array-bounds>  # g++ 12: false alarms on std::string +
  $<$<CXX_COMPILER_ID:GNU>:-Wno-stringop-overflow$<SEMICOLON>-Wno-stringop-overread>
   $<$<COMPILE_LANGUAGE:CXX>:-Wconversion> -ffp-contract=off
  $<$<BOOL:${SELVEDGE_WERROR}>:-Werror>)
if(SELVEDGE_SANITIZE STREQUAL "address")
  # Without what costs a fifth of the compilation: a null pointer and an access beyond an object crash all the same; a
  # cast to a wrong derived class (vptr) is not looked for.
  target_compile_options(selvedge_flags INTERFACE -fsanitize=address,undefined -fno-sanitize=null,object-size,vptr
    -fno-omit-frame-pointer -fno-sanitize-recover=undefined)
  target_link_options(selvedge_flags INTERFACE -fsanitize=address,undefined)
  target_compile_definitions(selvedge_flags INTERFACE SELVEDGE_ADDRESS_SANITIZER)  # compilers name it differently
elseif(SELVEDGE_SANITIZE STREQUAL "thread")
  target_compile_options(selvedge_flags INTERFACE -fsanitize=thread -fno-omit-frame-pointer)
  target_link_options(selvedge_flags INTERFACE -fsanitize=thread)
elseif(SELVEDGE_SANITIZE)
  message(FATAL_ERROR "SELVEDGE_SANITIZE is address, thread or empty, not '${SELVEDGE_SANITIZE}'")
endif()

if(SELVEDGE_FUZZ)
  target_compile_options(selvedge_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# Tests spend their time in the modules: their own code is compiled faster, with the same bits.
set(SELVEDGE_TEST_OPTIONS $<$<CONFIG:Release>:-O1>)

# Headers that nearly every source includes are compiled once, and once more with GoogleTest for the tests.
# So that ccache serves one checkout from another's cache, g++ tells it the precompiled header, and that is named by its
# place in the checkout. With clang it cannot: the presets that use clang precompile nothing.
target_compile_options(selvedge_flags INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess>)
set(kinds module)
if(BUILD_TESTING)
  list(APPEND kinds test)
endif()
foreach(kind ${kinds})
  file(CONFIGURE OUTPUT ${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp CONTENT "// Nothing: a header is compiled with it.\n")
  add_library(selvedge_precompiled_${kind} OBJECT ${PROJECT_BINARY_DIR}/precompiled_${kind}.cpp)
  target_include_directories(selvedge_precompiled_${kind} PRIVATE ${PROJECT_SOURCE_DIR})
  target_link_libraries(selvedge_precompiled_${kind} PRIVATE selvedge_flags Eigen3::Eigen)
  target_precompile_headers(selvedge_precompiled_${kind} PRIVATE <sim/core/precompiled.h>)
endforeach()
if(BUILD_TESTING)
  target_link_libraries(selvedge_precompiled_test PRIVATE GTest::gtest)
  target_precompile_headers(selvedge_precompiled_test PRIVATE <gtest/gtest.h>)
  target_compile_options(selvedge_precompiled_test PRIVATE ${SELVEDGE_TEST_OPTIONS})
endif()

# selvedge_batches(NAME VARIABLE [ALONE file ...]): in a list of sources, puts batches for them: sources that include up to
# SELVEDGE_BATCH_SIZE of them, by their names from the root, so that a compiler cache serves one checkout from another's.
# What is ALONE stays so. CMake's own UNITY_BUILD names sources by absolute paths.
set(SELVEDGE_BATCH_SIZE 1 CACHE STRING "Sources of a module or test program that are compiled as one (1: each by itself)")
function(selvedge_batches NAME VARIABLE)
  cmake_parse_arguments(ARG "" "" "ALONE" ${ARGN})
  if(SELVEDGE_BATCH_SIZE LESS 2)
    return()
  endif()
  set(batched "")
  set(rest "")
  foreach(source ${${VARIABLE}})
    get_filename_component(source ${source} ABSOLUTE)
    file(RELATIVE_PATH name ${PROJECT_SOURCE_DIR} ${source})
    get_filename_component(file ${source} NAME)
    if(file IN_LIST ARG_ALONE)
      list(APPEND rest ${source})
    else()
      list(APPEND batched ${name})
    endif()
  endforeach()
  # As many batches as it takes, each of about the same number of sources.
  list(LENGTH batched count)
  math(EXPR batches "(${count} + ${SELVEDGE_BATCH_SIZE} - 1) / ${SELVEDGE_BATCH_SIZE}")
  set(number 0)
  while(number LESS batches)
    math(EXPR first "${number} * ${count} / ${batches}")
    math(EXPR length "(${number} + 1) * ${count} / ${batches} - ${first}")
    list(SUBLIST batched ${first} ${length} members)
    list(TRANSFORM members REPLACE "(.+)" "#include \"\\1\"\n")
    list(JOIN members "" text)
    math(EXPR number "${number} + 1")
    set(batch ${CMAKE_CURRENT_BINARY_DIR}/${NAME}_batch_${number}.cpp)
    file(CONFIGURE OUTPUT ${batch} CONTENT "// Made by selvedge_batches.\n${text}" @ONLY)
    # A local constant may have the name of another source's: -Wshadow is for sources by themselves (dev, parse_singles).
    set_source_files_properties(${batch} PROPERTIES COMPILE_OPTIONS -Wno-shadow)
    list(APPEND rest ${batch})
  endwhile()
  set(${VARIABLE} ${rest} PARENT_SCOPE)
endfunction()

# selvedge_target_of(FOLDER VARIABLE): the name of a module's target, sim_mesh of sim/mesh.
function(selvedge_target_of FOLDER VARIABLE)
  string(REPLACE "/" "_" name ${FOLDER})
  set(${VARIABLE} ${name} PARENT_SCOPE)
endfunction()

# Sources named *_simd.cpp are compiled once for each SimdLevel (sim/core/simd_level.h). Such a source may hold nothing
# that the linker could take for another's: what it defines inline is always inlined or has internal linkage.
set(selvedge_simd_plain "")
set(selvedge_simd_avx2 -mavx2 -mfma)
set(selvedge_simd_avx512 -mfma -mavx512f -mavx512bw -mavx512dq -mavx512vl -mprefer-vector-width=512
  $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized> -Wno-uninitialized)  # g++ 12: false alarms
function(selvedge_simd_sources TARGET)
  foreach(level plain avx2 avx512)
    set(objects ${TARGET}_${level})
    add_library(${objects} OBJECT ${ARGN})
    target_include_directories(${objects} PRIVATE ${PROJECT_SOURCE_DIR})
    target_compile_options(${objects} PRIVATE ${selvedge_simd_${level}})
    target_link_libraries(${objects} PRIVATE selvedge_flags Eigen3::Eigen)
    target_sources(${TARGET} PRIVATE $<TARGET_OBJECTS:${objects}>)
  endforeach()
endfunction()

add_custom_target(selvedge_modules)  # all of them

# selvedge_module([USES folder ...] [LINK target ...] [PRIVATE_LINK target ...] [ALONE file ...])
# makes a library of all sources and headers in this folder. Sources that are ALONE are compiled by themselves. Each
# header must compile alone. For one that has a source of its name, scripts/checks shows it: the source includes it first
# (tests/style), and is parsed with nothing precompiled but what the header includes itself. The others have a source made
# for that, which the target all_verify_interface_header_sets compiles and scripts/checks parses.
function(selvedge_module)
  cmake_parse_arguments(ARG "" "" "USES;LINK;PRIVATE_LINK;ALONE" ${ARGN})
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  selvedge_target_of(${folder} name)
  set(target selvedge_${name})
  file(GLOB sources CONFIGURE_DEPENDS *.cpp)
  file(GLOB simd_sources CONFIGURE_DEPENDS *_simd.cpp)
  file(GLOB headers CONFIGURE_DEPENDS *.h)
  list(REMOVE_ITEM sources ${simd_sources} ${CMAKE_CURRENT_SOURCE_DIR}/main.cpp)
  if(sources)
    set(compiled ${sources})
    selvedge_batches(${name} compiled ALONE ${ARG_ALONE})
    add_library(${target} STATIC ${compiled})
    target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
    set(scope PUBLIC)
    target_link_libraries(${target} PRIVATE selvedge_flags ${ARG_PRIVATE_LINK})
    target_precompile_headers(${target} REUSE_FROM selvedge_precompiled_module)
  else()
    add_library(${target} INTERFACE)
    set(scope INTERFACE)
  endif()
  set(without_source ${headers})
  foreach(source ${sources})
    string(REGEX REPLACE "\\.cpp$" ".h" header ${source})
    list(REMOVE_ITEM without_source ${header})
  endforeach()
  list(REMOVE_ITEM headers ${without_source})
  target_sources(${target} ${scope}
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers}
    FILE_SET without_source TYPE HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${without_source})
  set_target_properties(${target} PROPERTIES INTERFACE_HEADER_SETS_TO_VERIFY without_source)
  foreach(used ${ARG_USES})
    selvedge_target_of(${used} used_name)
    target_link_libraries(${target} ${scope} selvedge::${used_name})
  endforeach()
  target_link_libraries(${target} ${scope} ${ARG_LINK})
  add_library(selvedge::${name} ALIAS ${target})
  add_dependencies(selvedge_modules ${target})
  if(simd_sources)
    selvedge_simd_sources(${target} ${simd_sources})
  endif()
endfunction()

# selvedge_test(NAME [SOURCES ...] USES folder ... [LABELS ...] [LINK ...] [DIVIDED suite parts ...]
#               [ALONE file ...])
# makes one GoogleTest program, of all sources in this folder unless they are named. ctest runs each of its suites in a
# process of its own, so that a suite prepares once what is costly; a suite that takes over 30 s is DIVIDED.
function(selvedge_test NAME)
  cmake_parse_arguments(ARG "" "" "SOURCES;USES;LABELS;LINK;DIVIDED;ALONE" ${ARGN})
  if(NOT ARG_LABELS)
    set(ARG_LABELS unit)
  endif()
  if(NOT ARG_SOURCES)
    file(GLOB ARG_SOURCES CONFIGURE_DEPENDS *.cpp)
  endif()
  set(target test_${NAME})
  selvedge_batches(${target} ARG_SOURCES ALONE ${ARG_ALONE})
  add_executable(${target} ${ARG_SOURCES})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR})
  foreach(used ${ARG_USES})
    selvedge_target_of(${used} used_name)
    target_link_libraries(${target} PRIVATE selvedge::${used_name})
  endforeach()
  target_link_libraries(${target} PRIVATE selvedge_flags selvedge_test_checkout selvedge_test_main ${ARG_LINK})
  target_compile_options(${target} PRIVATE ${SELVEDGE_TEST_OPTIONS})
  target_precompile_headers(${target} REUSE_FROM selvedge_precompiled_test)
  set(suites ${CMAKE_CURRENT_BINARY_DIR}/${target}_suites.cmake)
  string(REPLACE ";" "|" divided "${ARG_DIVIDED}")
  string(REPLACE ";" "|" labels "${ARG_LABELS}")
  add_custom_command(TARGET ${target} POST_BUILD BYPRODUCTS ${suites} VERBATIM
    COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:${target}> -DOUTPUT=${suites} -DFOLDER=${CMAKE_CURRENT_BINARY_DIR}
      -DLABELS=${labels} -DDIVIDED=${divided} -P ${PROJECT_SOURCE_DIR}/cmake/discover_suites.cmake)
  # A program that was not built shows as a test that cannot be found.
  file(CONFIGURE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake @ONLY CONTENT
"if(EXISTS \"@suites@\")
  include(\"@suites@\")
else()
  add_test(@target@_IS_NOT_BUILT @target@_IS_NOT_BUILT)
endif()
")
  set_property(DIRECTORY APPEND PROPERTY TEST_INCLUDE_FILES ${CMAKE_CURRENT_BINARY_DIR}/${target}_include.cmake)
endfunction()
