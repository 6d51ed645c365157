# refine: one-to-four refinement beside OpenMesh's, built only where OpenMesh is found.
find_package(OpenMesh QUIET NO_MODULE)
if(TARGET OpenMeshCore)
  add_executable(refine ${CMAKE_CURRENT_LIST_DIR}/refine.cpp)
  get_target_property(openmesh_headers OpenMeshCore INTERFACE_INCLUDE_DIRECTORIES)
  if(openmesh_headers)
    target_include_directories(refine SYSTEM PRIVATE ${openmesh_headers})  # its warnings are its own
  endif()
  target_compile_definitions(refine PRIVATE NDEBUG)  # OpenMesh's own asserts
  target_link_libraries(refine PRIVATE selvedge::adaptive selvedge_flags OpenMeshCore)
  target_include_directories(refine PRIVATE ${CMAKE_SOURCE_DIR})
endif()
