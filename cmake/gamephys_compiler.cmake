# Which compilers build the library, and how they are told to compute: the same bits on every
# processor and at every optimisation level, whatever flags a parent project compiles with.

# MSVC is also set for clang-cl, the simulated id for clang that uses Microsoft's C++ library.
if(MSVC
   OR CMAKE_CXX_SIMULATE_ID STREQUAL "MSVC"
   OR NOT CMAKE_CXX_COMPILER_ID MATCHES "^(GNU|Clang|AppleClang)$")
  message(
    FATAL_ERROR
      "gamephys: the compiler ${CMAKE_CXX_COMPILER_ID} (${CMAKE_CXX_COMPILER}) is not supported. gcc and clang are, "
      "with MinGW-w64, Apple's clang and Emscripten among them; on Windows use MinGW-w64.")
endif()

# gamephys_flags(OUT [CONFIG]): the options that come before those of our targets.
function(gamephys_flags out)
  get_directory_property(options COMPILE_OPTIONS)
  string(TOUPPER "${ARGN}" config)
  set(${out} " ${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_${config}} ${options} " PARENT_SCOPE)
endfunction()

# A build type that is none, or unknown, means -O0. Our targets are optimised all the same, unless a
# level is given elsewhere.
set(GAMEPHYS_OPTIMISATION)
string(TOUPPER "${CMAKE_BUILD_TYPE}" build_type)
if(NOT CMAKE_CONFIGURATION_TYPES AND NOT build_type STREQUAL "DEBUG")
  gamephys_flags(flags ${CMAKE_BUILD_TYPE})
  if(NOT flags MATCHES "[ ;]-O([0-9sgz]|fast)?[ ;]")
    set(GAMEPHYS_OPTIMISATION -O3)
    message(STATUS "gamephys: the build type \"${CMAKE_BUILD_TYPE}\" does not optimise, so the library is compiled with -O3")
  endif()
endif()
# -Ofast is an optimisation level, which no -fno-... takes back; the linker's driver reads it too.
foreach(config IN LISTS CMAKE_BUILD_TYPE CMAKE_CONFIGURATION_TYPES)
  gamephys_flags(flags ${config})
  if(flags MATCHES "[ ;]-Ofast[ ;]")
    list(APPEND GAMEPHYS_OPTIMISATION $<$<CONFIG:${config}>:-O3>)
  endif()
endforeach()
gamephys_flags(flags)
if(flags MATCHES "[ ;]-Ofast[ ;]")
  list(APPEND GAMEPHYS_OPTIMISATION -O3)
endif()

# What -ffast-math and its parts change. gcc does not undo a part that was asked for by its own
# name with -fno-fast-math; clang does, and says that it overrides -ffp-contract.
include(CheckCXXCompilerFlag)
set(GAMEPHYS_IEEE -fno-fast-math)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  list(APPEND GAMEPHYS_IEEE -fno-unsafe-math-optimizations -fno-associative-math -fno-reciprocal-math
       -fno-finite-math-only -fsigned-zeros -ftrapping-math -fno-cx-limited-range -fno-single-precision-constant)
else()
  check_cxx_compiler_flag("-Werror -Wno-overriding-t-option" GAMEPHYS_HAS_OVERRIDING_T_OPTION)
  check_cxx_compiler_flag("-Werror -Wno-overriding-option" GAMEPHYS_HAS_OVERRIDING_OPTION)
  if(GAMEPHYS_HAS_OVERRIDING_T_OPTION)
    list(APPEND GAMEPHYS_IEEE -Wno-overriding-t-option)
  elseif(GAMEPHYS_HAS_OVERRIDING_OPTION)
    list(APPEND GAMEPHYS_IEEE -Wno-overriding-option)
  endif()
endif()
# Without contraction every processor gives the same bits. errno of sqrt is never read.
list(APPEND GAMEPHYS_IEEE -ffp-contract=off -fno-math-errno)

# gcc 12's vectorizer of straight-line code takes double -> float -> double of two neighbours for
# no change and drops the rounding (a case of test_math.cpp shows it). That of Emscripten 3.1.6's
# clang, with SIMD, takes three points that turn for a line (test_shape_rays.c shows it).
function(gamephys_exact_conversions target)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fno-tree-slp-vectorize>)
  elseif(EMSCRIPTEN)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-fno-slp-vectorize>)
  endif()
endfunction()

# Hosts may trap division by zero and invalid operations. gcc respects that; clang, unless told,
# computes both sides of a choice, the guarded division included.
check_cxx_compiler_flag("-Werror -ffp-exception-behavior=maytrap" GAMEPHYS_HAS_MAYTRAP)
function(gamephys_exact_traps target)
  if(GAMEPHYS_HAS_MAYTRAP)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-ffp-exception-behavior=maytrap>)
  endif()
endfunction()
