# embed_shaders(TARGET FILES ...): the text of the shader files becomes part of the target, as the function
# drape::render::shader_source (render/shader_source.h), so that the program needs no files at run time.
function(embed_shaders target)
  set(generated ${CMAKE_CURRENT_BINARY_DIR}/shader_source.cpp)
  add_custom_command(
    OUTPUT ${generated}
    COMMAND ${CMAKE_COMMAND} -D "OUTPUT=${generated}" -D "FILES=${ARGN}" -P ${PROJECT_SOURCE_DIR}/cmake/WriteShaderSource.cmake
    DEPENDS ${ARGN} ${PROJECT_SOURCE_DIR}/cmake/WriteShaderSource.cmake
    COMMENT "Embedding the shaders"
    VERBATIM)
  target_sources(${target} PRIVATE ${generated})
endfunction()
