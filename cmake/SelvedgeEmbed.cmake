# selvedge_embed(TARGET FUNCTION FILE ...) compiles text files into TARGET, so that the program runs from any folder.
# FUNCTION is declared by hand, in a header of the module, as: std::span<const sim::EmbeddedFile> FUNCTION();
# and gives the files in the order named here (sim/core/file.h). File names are relative to the source root.
function(selvedge_embed TARGET FUNCTION)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${FUNCTION}.cpp)
  file(RELATIVE_PATH folder ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_SOURCE_DIR})
  string(REGEX REPLACE "/.*" "" namespace ${folder})
  set(files)
  foreach(file ${ARGN})
    list(APPEND files ${PROJECT_SOURCE_DIR}/${file})
  endforeach()
  string(REPLACE ";" "|" joined "${ARGN}")
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DFUNCTION=${FUNCTION} -DNAMESPACE=${namespace} -DROOT=${PROJECT_SOURCE_DIR} "-DFILES=${joined}"
            -P ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake
    DEPENDS ${files} ${PROJECT_SOURCE_DIR}/cmake/embed_script.cmake VERBATIM)
  target_sources(${TARGET} PRIVATE ${output})
endfunction()
