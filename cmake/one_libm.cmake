# kempe_libm: the sines, logarithms and powers that every build of the library uses, so that the same spec gives the same bytes on
# every processor and in the studio's page. The C library of Debian has other last digits than the page's, and on a processor
# with fused multiply-add others than on one without. musl's, which the page has, are taken from Debian's musl-dev, and seen
# by what this build compiles alone: no other library of a process notices.
# Square roots, remainders and roundings to integers are exact in every library and stay where they are.
option(KEMPE_WITH_MUSL_LIBM "Take sines, logarithms and powers from musl, where its libc.a is found" ON)

add_library(kempe_libm INTERFACE)
set(KEMPE_LIBM_OBJECT "")

function(kempe_one_libm)
  set(functions acos acosh asin asinh atan atan2 atanh cabs cbrt cos cosh erf erfc exp exp2 expm1 hypot log log10 log1p log2 pow sin
    sincos sinh tan tanh)
  # What these call. erfc stands in erf.lo.
  set(members ${functions} __sin __cos __tan __rem_pio2 __rem_pio2_large __expo2 exp_data log_data log2_data pow_data __math_divzero
    __math_invalid __math_oflow __math_uflow __math_xflow)
  list(REMOVE_ITEM members erfc)
  list(TRANSFORM members APPEND .lo)

  set(folder ${PROJECT_BINARY_DIR}/libm)
  file(MAKE_DIRECTORY ${folder})
  # A hidden symbol binds inside the program or the shared library that is linked.
  list(TRANSFORM functions REPLACE "(.+)" ".globl \\1\n.hidden \\1\n" OUTPUT_VARIABLE hidden)
  list(JOIN hidden "" hidden)
  file(WRITE ${folder}/hidden.s "${hidden}.section .note.GNU-stack,\"\",@progbits\n")
  list(JOIN functions "\n" lines)
  file(WRITE ${folder}/functions.txt "${lines}\n")
  set(command_options WORKING_DIRECTORY ${folder} COMMAND_ERROR_IS_FATAL ANY)
  execute_process(COMMAND ${CMAKE_AR} x ${KEMPE_MUSL_LIBC} ${members} ${command_options})
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -c hidden.s -o hidden.o ${command_options})
  execute_process(COMMAND ${CMAKE_LINKER} -r -o joined.o ${members} hidden.o ${command_options})
  execute_process(COMMAND ${CMAKE_OBJCOPY} --keep-global-symbols=functions.txt joined.o kempe_libm.o ${command_options})
  file(REMOVE ${folder}/libkempe_libm.a)
  execute_process(COMMAND ${CMAKE_AR} rcs libkempe_libm.a kempe_libm.o ${command_options})
  target_link_libraries(kempe_libm INTERFACE ${folder}/libkempe_libm.a)
  set(KEMPE_LIBM_OBJECT ${folder}/kempe_libm.o PARENT_SCOPE)
endfunction()

if(NOT EMSCRIPTEN)  # which has musl's anyway
  if(KEMPE_WITH_MUSL_LIBM)
    find_file(KEMPE_MUSL_LIBC libc.a PATHS /usr/lib/${CMAKE_SYSTEM_PROCESSOR}-linux-musl /usr/lib/musl/lib NO_DEFAULT_PATH)
  endif()
  if(KEMPE_WITH_MUSL_LIBM AND KEMPE_MUSL_LIBC)
    kempe_one_libm()
    message(STATUS "Sines, logarithms and powers: musl's, as in the studio's page (${KEMPE_MUSL_LIBC})")
  else()
    message(STATUS "Sines, logarithms and powers: this system's (no musl-dev): last digits of designs depend on it and on the "
      "processor, and may differ from the studio's page")
  endif()
endif()
