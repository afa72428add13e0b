# How the library is compiled to WebAssembly: all that differs from a native build, here and in studio/platform.hpp.
# scripts/studio names this file as CMAKE_PROJECT_TOP_LEVEL_INCLUDES beside Emscripten's tool chain. Emscripten finds none of
# Debian's libraries, so find_package() is answered here: headers through a folder of links (never /usr/include, which holds
# the C library of another machine), the rest compiled from Debian's sources.
set(KEMPE_WASM_SOURCES "" CACHE PATH "Where scripts/studio has unpacked the sources of the C and C++ libraries")
set(KEMPE_WASM_HEADERS ${CMAKE_BINARY_DIR}/headers)

# No rounding modes: CGAL then widens every operation by a unit in the last place. No exceptions without the flag. Nothing is
# contracted, as in native builds.
add_compile_definitions(CGAL_ALWAYS_ROUND_TO_NEAREST CGAL_DISABLE_GMP)
add_compile_options(-fwasm-exceptions "$<$<COMPILE_LANGUAGE:CXX>:SHELL:-include ${CMAKE_CURRENT_LIST_DIR}/../studio/platform.hpp>")
add_link_options(-fwasm-exceptions)

function(kempe_wasm_headers name)
  file(MAKE_DIRECTORY ${KEMPE_WASM_HEADERS})
  foreach(folder IN LISTS ARGN)
    get_filename_component(last ${folder} NAME)
    file(CREATE_LINK ${folder} ${KEMPE_WASM_HEADERS}/${last} SYMBOLIC)
  endforeach()
  if(NOT TARGET ${name})
    add_library(${name} INTERFACE IMPORTED GLOBAL)
    target_include_directories(${name} SYSTEM INTERFACE ${KEMPE_WASM_HEADERS})
  endif()
endfunction()

# kempe_wasm_library(NAME ALIAS INCLUDE SOURCE...): from KEMPE_WASM_SOURCES/NAME; the alias is what find_package() would define.
function(kempe_wasm_library name alias include)
  set(root ${KEMPE_WASM_SOURCES}/${name})
  list(TRANSFORM ARGN PREPEND ${root}/ OUTPUT_VARIABLE sources)
  add_library(wasm_${name} STATIC ${sources})
  target_compile_options(wasm_${name} PRIVATE -w)
  target_compile_features(wasm_${name} PRIVATE cxx_std_17)
  target_include_directories(wasm_${name} SYSTEM PUBLIC ${root}/${include})
  add_library(${alias} ALIAS wasm_${name})
endfunction()

function(kempe_wasm_nlopt)
  # What its own CMake files find out by trying, for this one machine.
  file(WRITE ${CMAKE_BINARY_DIR}/nlopt/nlopt_config.h
    "#define HAVE_COPYSIGN\n#define HAVE_FPCLASSIFY\n#define HAVE_GETTIMEOFDAY\n#define HAVE_ISINF\n#define HAVE_ISNAN\n"
    "#define HAVE_STDINT_H\n#define HAVE_SYS_TIME_H\n#define HAVE_TIME\n#define HAVE_UINT32_T\n#define HAVE_GETPID\n"
    "#define HAVE_UNISTD_H\n"
    "#define TIME_WITH_SYS_TIME\n#define SIZEOF_UNSIGNED_INT 4\n#define SIZEOF_UNSIGNED_LONG 4\n#define THREADLOCAL __thread\n"
    "#define MAJOR_VERSION 2\n#define MINOR_VERSION 7\n#define BUGFIX_VERSION 1\n")
  set(algorithms direct/DIRect direct/direct_wrap direct/DIRserial direct/DIRsubrout cdirect/cdirect cdirect/hybrid
    praxis/praxis luksan/plis luksan/plip luksan/pnet luksan/mssubs luksan/pssubs crs/crs mlsl/mlsl mma/mma mma/ccsa_quadratic
    cobyla/cobyla newuoa/newuoa neldermead/nldrmd neldermead/sbplx auglag/auglag bobyqa/bobyqa isres/isres slsqp/slsqp esch/esch)
  set(interface general options optimize deprecated)
  set(helpers mt19937ar sobolseq timer stop redblack qsort_r rescale)
  list(TRANSFORM algorithms REPLACE "(.+)" "src/algs/\\1.c")
  list(TRANSFORM interface REPLACE "(.+)" "src/api/\\1.c")
  list(TRANSFORM helpers REPLACE "(.+)" "src/util/\\1.c")
  kempe_wasm_library(nlopt NLopt::nlopt src/api ${algorithms} ${interface} ${helpers})
  set(root ${KEMPE_WASM_SOURCES}/nlopt)
  target_include_directories(wasm_nlopt PRIVATE ${CMAKE_BINARY_DIR}/nlopt ${root}/src/util)
  foreach(algorithm IN ITEMS direct cdirect praxis luksan crs mlsl mma cobyla newuoa neldermead auglag bobyqa isres slsqp esch)
    target_include_directories(wasm_nlopt PRIVATE ${root}/src/algs/${algorithm})
  endforeach()
endfunction()

function(kempe_wasm_cminpack)
  set(functions chkder covar covar1 dogleg dpmpar enorm fdjac1 fdjac2 hybrd hybrd1 hybrj hybrj1 lmder lmder1 lmdif lmdif1 lmpar
    lmstr lmstr1 qform qrfac qrsolv r1mpyq r1updt rwupdt)
  list(TRANSFORM functions APPEND .c)
  kempe_wasm_library(cminpack Cminpack::cminpack . ${functions})
endfunction()

function(kempe_wasm_muparser)
  set(sources muParser muParserBase muParserBytecode muParserCallback muParserError muParserTokenReader)
  list(TRANSFORM sources REPLACE "(.+)" "src/\\1.cpp")
  kempe_wasm_library(muparser muparser::muparser include ${sources})
  target_compile_definitions(wasm_muparser PUBLIC MUPARSER_STATIC)
endfunction()

function(kempe_wasm_dxflib)
  set(root ${KEMPE_WASM_SOURCES}/dxflib)
  file(MAKE_DIRECTORY ${root}/include)
  file(CREATE_LINK ${root}/src ${root}/include/dxflib SYMBOLIC)
  kempe_wasm_library(dxflib dxflib include src/dl_dxf.cpp src/dl_writer_ascii.cpp)
endfunction()

function(kempe_wasm_haru)
  # Without PNG images. Of zlib only what compresses.
  kempe_wasm_library(zlib ZLIB::ZLIB . adler32.c compress.c crc32.c deflate.c trees.c zutil.c)
  set(root ${KEMPE_WASM_SOURCES}/libharu)
  file(GLOB sources RELATIVE ${root} CONFIGURE_DEPENDS ${root}/src/*.c)
  list(FILTER sources EXCLUDE REGEX "_png\\.c$")
  kempe_wasm_library(libharu Haru::haru include ${sources})
  target_link_libraries(wasm_libharu PRIVATE ZLIB::ZLIB)
  file(WRITE ${CMAKE_BINARY_DIR}/libharu/hpdf_config.h "#define LIBHPDF_HAVE_NOPNGLIB\n")
  target_include_directories(wasm_libharu PUBLIC ${CMAKE_BINARY_DIR}/libharu)
endfunction()

# The answer to find_package().
macro(kempe_wasm_provide method package)
  enable_language(C)
  if("${package}" STREQUAL "Eigen3")
    kempe_wasm_headers(Eigen3::Eigen /usr/include/eigen3/Eigen /usr/include/eigen3/unsupported)
  elseif("${package}" STREQUAL "tl-expected")
    kempe_wasm_headers(tl::expected /usr/include/tl)
  elseif("${package}" STREQUAL "CGAL")
    kempe_wasm_headers(CGAL::CGAL /usr/include/CGAL /usr/include/boost)
  elseif("${package}" STREQUAL "nlohmann_json")
    kempe_wasm_headers(nlohmann_json::nlohmann_json /usr/include/nlohmann)
  elseif("${package}" STREQUAL "tomlplusplus")
    kempe_wasm_headers(tomlplusplus::tomlplusplus /usr/include/toml++)
  elseif("${package}" STREQUAL "Threads")
    if(NOT TARGET Threads::Threads)  # one thread; std::thread is there and never started
      add_library(Threads::Threads INTERFACE IMPORTED GLOBAL)
    endif()
  elseif("${package}" STREQUAL "fmt" AND NOT TARGET fmt::fmt)
    kempe_wasm_headers(kempe_wasm_numbers /usr/include/fast_float)  # for studio/platform.hpp
    include_directories(SYSTEM ${KEMPE_WASM_HEADERS})
    kempe_wasm_library(fmt fmt::fmt include src/format.cc)
  elseif("${package}" STREQUAL "NLopt" AND NOT TARGET NLopt::nlopt)
    kempe_wasm_nlopt()
  elseif("${package}" STREQUAL "Cminpack" AND NOT TARGET Cminpack::cminpack)
    kempe_wasm_cminpack()
  elseif("${package}" STREQUAL "muparser" AND NOT TARGET muparser::muparser)
    kempe_wasm_muparser()
  elseif("${package}" STREQUAL "pugixml" AND NOT TARGET pugixml::pugixml)
    kempe_wasm_library(pugixml pugixml::pugixml src src/pugixml.cpp)
    kempe_wasm_dxflib()  # which comes without a package to be found
  elseif("${package}" STREQUAL "Haru" AND NOT TARGET Haru::haru)
    kempe_wasm_haru()
  endif()
  set(${package}_FOUND TRUE)
endmacro()
cmake_language(SET_DEPENDENCY_PROVIDER kempe_wasm_provide SUPPORTED_METHODS FIND_PACKAGE)
