# osifont (ISO 3098; GPL 3 with the exception for documents that embed it) becomes a part of the program, so that drawings look
# the same on every machine.
find_file(KEMPE_LETTERING_FONT osifont.ttf PATHS /usr/share/fonts/truetype/osifont NO_CMAKE_FIND_ROOT_PATH REQUIRED)
mark_as_advanced(KEMPE_LETTERING_FONT)
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/lettering_font.cpp
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/lettering_font.cpp -DFONT=${KEMPE_LETTERING_FONT}
          -P ${CMAKE_CURRENT_SOURCE_DIR}/workshop/embed_font.cmake
  DEPENDS ${KEMPE_LETTERING_FONT} ${CMAKE_CURRENT_SOURCE_DIR}/workshop/embed_font.cmake
  COMMENT "Embedding the lettering of the drawings"
  VERBATIM)
target_sources(kempe_reports PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/lettering_font.cpp)
