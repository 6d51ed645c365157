# Every package that Selvedge uses, each owned by one module (docs/modules.md).
option(SELVEDGE_TESTS "Build the tests" ${PROJECT_IS_TOP_LEVEL})
option(SELVEDGE_PYTHON "Build the Python module" ${PROJECT_IS_TOP_LEVEL})
if(NOT SELVEDGE_PROGRAM)
  set(SELVEDGE_TESTS OFF)
  set(SELVEDGE_PYTHON OFF)
endif()
set(BUILD_TESTING ${SELVEDGE_TESTS})  # CGAL's package would declare it, switched off
if(SELVEDGE_PYTHON AND (SELVEDGE_SANITIZE OR SELVEDGE_FUZZ))
  # The run-time library of a sanitizer must be the first that a process loads, and Python's own process has none.
  set(SELVEDGE_PYTHON OFF)
elseif(SELVEDGE_PYTHON AND CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
  # The presets with clang show that the modules compile with their own includes; a Python module by clang would not
  # give the bits of the program that is installed, which is built by g++.
  set(SELVEDGE_PYTHON OFF)
endif()
if(NOT Python3_EXECUTABLE AND EXISTS /usr/bin/python3)
  set(Python3_EXECUTABLE /usr/bin/python3)  # Debian's, for which it has NumPy; another one by -DPython3_EXECUTABLE=
endif()
set(CMAKE_POLICY_DEFAULT_CMP0167 NEW)  # CGAL finds Boost by Boost's own package
find_package(Threads REQUIRED)
find_package(Eigen3 3.4 REQUIRED NO_MODULE)    # sim/core
find_package(nlohmann_json 3.11 REQUIRED)      # sim/core/json
find_package(TBB REQUIRED)                     # sim/core/parallel
find_package(CGAL 5.5 REQUIRED)                # sim/mesh
find_package(assimp 5.2 REQUIRED)              # sim/repair, in a child process
find_package(meshoptimizer REQUIRED)           # sim/repair/plain_gltf; 0.18 to 0.22 (each calls itself incompatible with the last)
find_package(PNG REQUIRED)                     # render/image
find_path(SELVEDGE_STB_FOLDER stb_truetype.h PATH_SUFFIXES stb REQUIRED)  # render/image/outline_font
if(SELVEDGE_TESTS)
  find_package(GTest REQUIRED)                 # tests
  set(SELVEDGE_NUMPY NumPy)                    # of tests/python; the module itself takes it when it runs
endif()
if(SELVEDGE_PYTHON)
  find_package(Python3 3.10 REQUIRED COMPONENTS Interpreter Development.Module ${SELVEDGE_NUMPY})  # python
  set(PYBIND11_FINDPYTHON ON)
  find_package(pybind11 2.10 REQUIRED)         # python
endif()
find_package(PkgConfig REQUIRED)
pkg_check_modules(nettle REQUIRED IMPORTED_TARGET nettle>=3.7)  # sim/core/sha256
pkg_check_modules(seccomp REQUIRED IMPORTED_TARGET libseccomp>=2.5)  # sim/core/system_call_filter
pkg_check_modules(turbojpeg REQUIRED IMPORTED_TARGET libturbojpeg>=2.1)  # render/image
pkg_check_modules(exif REQUIRED IMPORTED_TARGET libexif>=0.6.24)  # render/image
pkg_check_modules(glib REQUIRED IMPORTED_TARGET glib-2.0>=2.74)  # sim/proposals: letters of any script
# Its -pthread would define _REENTRANT, with which the precompiled header was not made.
set_target_properties(PkgConfig::glib PROPERTIES INTERFACE_COMPILE_OPTIONS "")

# Of the program alone.
if(NOT SELVEDGE_PROGRAM)
  return()
endif()
find_package(CLI11 REQUIRED)                   # app/arguments
pkg_check_modules(imgui REQUIRED IMPORTED_TARGET imgui>=1.86)  # editor, app/ui_draw
pkg_check_modules(pugixml REQUIRED IMPORTED_TARGET pugixml>=1.13)  # sim/paper
pkg_check_modules(polyclipping REQUIRED IMPORTED_TARGET polyclipping)  # sim/paper
pkg_check_modules(poppler REQUIRED IMPORTED_TARGET poppler>=22.12)  # sim/paper/pdf_recorder, in a child process
pkg_check_modules(yaml-cpp REQUIRED IMPORTED_TARGET yaml-cpp>=0.7)  # sim/paper
pkg_check_modules(pangocairo REQUIRED IMPORTED_TARGET pangocairo>=1.50)  # sim/print, with Cairo
set_target_properties(PkgConfig::pangocairo PROPERTIES INTERFACE_COMPILE_OPTIONS "")  # as glib
pkg_check_modules(fontconfig REQUIRED IMPORTED_TARGET fontconfig)  # app/fallback_fonts
pkg_check_modules(glfw REQUIRED IMPORTED_TARGET glfw3>=3.3)    # app/window
