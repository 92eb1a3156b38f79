# Whether the tests are built (build_tests), and what of them is left out because something is not
# installed: gamephys_left_out(WHAT REASON) says it and keeps it for ./test.sh, in left_out.txt.
set_property(GLOBAL PROPERTY gamephys_left_out "")
function(gamephys_left_out what reason)
  message(STATUS "gamephys: without ${what}: ${reason}")
  set_property(GLOBAL APPEND_STRING PROPERTY gamephys_left_out "${what} (${reason})\n")
endfunction()

option(GAMEPHYS_SHORT_TESTS
       "Of the tests' long simulations none, of random cases and failing allocations a part, and one process for each \
file of C++ tests: for sanitizers, under which tests take ten times as long, and a process a fifth of a second"
       OFF)
mark_as_advanced(GAMEPHYS_SHORT_TESTS)

set(build_tests ${GAMEPHYS_TESTS})
if(NOT build_tests)
  return()
endif()

set(missing)
if(NOT CMAKE_CROSSCOMPILING)
  find_library(CMOCKA_LIBRARY cmocka)
  find_package(Catch2 QUIET)
  find_program(PYTHON3 python3)
  if(NOT CMOCKA_LIBRARY)
    list(APPEND missing libcmocka-dev)
  endif()
  if(NOT Catch2_FOUND)
    list(APPEND missing catch2)
  endif()
  if(NOT PYTHON3)
    list(APPEND missing python3)
  endif()
endif()
if(NOT missing)
  set(build_tests ON)
  return()
endif()
list(JOIN missing " " missing)
if(GAMEPHYS_TESTS STREQUAL "AUTO")
  set(build_tests OFF)
  message(NOTICE "gamephys: the tests are left out. They need the Debian packages ${missing}.")
else()
  message(FATAL_ERROR "gamephys: the tests need the Debian packages ${missing}: install them (./test.sh does), "
                      "or configure with -DGAMEPHYS_TESTS=OFF.")
endif()
