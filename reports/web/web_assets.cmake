# The report's style sheets and scripts, inlined into the program: a user's machine needs no Node.
# jsxgraph comes from reports/web/node_modules (scripts/bootstrap puts it there). Without it the report is made all the
# same, with its picture standing still.
option(KEMPE_WITH_LIVE_REPORT "Inline jsxgraph, so that the report's picture can be moved" ON)
set(web ${CMAKE_CURRENT_SOURCE_DIR}/web)
set(geometry ${web}/node_modules/jsxgraph/distrib/jsxgraphcore.js)
set(KEMPE_REPORT_IS_LIVE ${KEMPE_WITH_LIVE_REPORT})
if(KEMPE_WITH_LIVE_REPORT AND NOT EXISTS ${geometry})
  set(KEMPE_REPORT_IS_LIVE OFF)
  message(STATUS "reports/web/node_modules has no jsxgraph: report.html will not move (run scripts/bootstrap)")
endif()
set(KEMPE_REPORT_IS_LIVE ${KEMPE_REPORT_IS_LIVE} CACHE INTERNAL "report.html can be moved")

set(parts ${web}/report.css ${web}/animation.css ${web}/animation.js ${web}/embed.cmake)
if(KEMPE_REPORT_IS_LIVE)
  list(APPEND parts ${web}/kinematics.js ${web}/contact.js ${web}/places.js ${web}/frame.js ${web}/stage.js ${web}/live.js
       ${geometry})
endif()
add_custom_command(OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp
  COMMAND ${CMAKE_COMMAND} -DOUTPUT=${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp -DWEB=${web}
          -DWITH_LIVE=${KEMPE_REPORT_IS_LIVE} -P ${web}/embed.cmake
  DEPENDS ${parts}
  COMMENT "Embedding the report's style sheets and scripts"
  VERBATIM)
target_sources(kempe_reports PRIVATE ${CMAKE_CURRENT_BINARY_DIR}/web_assets.cpp)
