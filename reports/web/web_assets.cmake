# The report's style sheets and scripts, inlined into the program: a user's machine needs no Node.
# JSXGraph stands in reports/web/jsxgraph, with its licence and checksums.
option(KEMPE_WITH_LIVE_REPORT "Inline JSXGraph (1 MB), so that the report's picture can be moved" ON)
set(web ${CMAKE_CURRENT_SOURCE_DIR}/web)
set(parts ${web}/report.css ${web}/elements.js ${web}/animation/animation.css ${web}/centres/centres.css ${web}/centres/centres.js
    ${web}/embed.cmake)
foreach(name IN ITEMS motion player arrows polygons plottable plots page)
  list(APPEND parts ${web}/animation/${name}.js)
endforeach()
if(KEMPE_WITH_LIVE_REPORT)
  list(APPEND parts ${web}/kinematics.js ${web}/contact.js ${web}/places.js ${web}/frame.js ${web}/stage.js ${web}/live.js
       ${web}/jsxgraph/jsxgraphcore.js ${web}/jsxgraph/jsxgraph.css ${web}/jsxgraph/LICENSE.MIT ${web}/jsxgraph/SHA256SUMS)
endif()
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp -DWEB=${web}
          -DWITH_LIVE=${KEMPE_WITH_LIVE_REPORT} -P ${web}/embed.cmake
  DEPENDS ${parts}
  COMMENT "Embedding the report's style sheets and scripts"
  VERBATIM)
target_sources(kempe_reports PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp)
