# gamephys         shared library (gamephys::gamephys), or another name of the static one
# gamephys_static  static archive (gamephys::static)
#
# Both take the same objects of everything below src/c_api. The C interface itself is compiled for
# each: objects that export it would re-export it from any shared object that takes the archive in.

file(GLOB_RECURSE GAMEPHYS_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
# Compiled once for each instruction set (gamephys_isas.cmake).
file(GLOB_RECURSE GAMEPHYS_KERNELS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*_kernels.cpp)
file(GLOB GAMEPHYS_INTERFACE CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/c_api/*.cpp)
list(REMOVE_ITEM GAMEPHYS_SOURCES ${GAMEPHYS_KERNELS} ${GAMEPHYS_INTERFACE})
# Those that no set but the wide ones uses.
set(GAMEPHYS_WIDE_KERNELS ${PROJECT_SOURCE_DIR}/src/scene/box_kernels.cpp
                          ${PROJECT_SOURCE_DIR}/src/scene/hit_kernels.cpp)
list(REMOVE_ITEM GAMEPHYS_KERNELS ${GAMEPHYS_WIDE_KERNELS})
include(${CMAKE_CURRENT_LIST_DIR}/gamephys_isas.cmake)
include(${CMAKE_CURRENT_LIST_DIR}/gamephys_compiler.cmake)

# Warnings, for everything that belongs to this project.
function(gamephys_warnings target)
  target_compile_options(${target} PRIVATE -Wall -Wextra $<$<BOOL:${GAMEPHYS_WERROR}>:-Werror>)
endfunction()

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

set(GAMEPHYS_LIBRARY_OPTIONS "" CACHE STRING "Further compiler options for the library alone, such as those that count its lines")
mark_as_advanced(GAMEPHYS_LIBRARY_OPTIONS)

# How everything in src is compiled. Exceptions stay inside, and have to be there. A unity build
# would join files whose local names are the same.
function(gamephys_compilation target)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE Threads::Threads)
  set_target_properties(
    ${target}
    PROPERTIES CXX_STANDARD 17
               CXX_STANDARD_REQUIRED ON
               CXX_EXTENSIONS OFF
               CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               POSITION_INDEPENDENT_CODE ON
               UNITY_BUILD OFF)
  gamephys_warnings(${target})
  # src is C++17 without extensions, of which clang finds more than gcc (tests_package/microsoft.sh).
  if(CMAKE_CXX_COMPILER_ID STREQUAL "Clang")
    target_compile_options(${target} PRIVATE -pedantic -Wgnu)
  endif()
  target_compile_options(${target} PRIVATE ${GAMEPHYS_OPTIMISATION} ${GAMEPHYS_IEEE} ${GAMEPHYS_LIBRARY_OPTIONS} -fno-rtti)
  if(NOT EMSCRIPTEN) # which has -fwasm-exceptions instead
    target_compile_options(${target} PRIVATE -fexceptions)
  endif()
  gamephys_exact_conversions(${target})
  gamephys_exact_traps(${target})
endfunction()

# The standard headers, which take a fifth of the time, are compiled once. Not with a compiler cache, which would not
# recognise a file that uses them; nor for other machines, where compilers differ in what they precompile.
function(gamephys_standard_headers target)
  if(NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT CMAKE_CROSSCOMPILING AND NOT APPLE)
    target_precompile_headers(
      ${target} PRIVATE <algorithm> <atomic> <cmath> <condition_variable> <cstring> <functional> <limits>
      <memory_resource> <mutex> <optional> <thread> <variant> <vector>)
  endif()
endfunction()

# Objects for both forms of the library: the kernels of each instruction set, and the rest.
set(GAMEPHYS_OBJECTS)
function(gamephys_objects target)
  add_library(${target} OBJECT ${ARGN})
  gamephys_compilation(${target})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include)
  target_compile_definitions(${target} PRIVATE GAMEPHYS_STATIC)
  set(GAMEPHYS_OBJECTS ${GAMEPHYS_OBJECTS} $<TARGET_OBJECTS:${target}> PARENT_SCOPE)
endfunction()
gamephys_objects(gamephys_core ${GAMEPHYS_SOURCES})
gamephys_standard_headers(gamephys_core)
foreach(isa ${GAMEPHYS_ISAS})
  set(wide)
  if(isa IN_LIST GAMEPHYS_WIDE_ISAS)
    set(wide ${GAMEPHYS_WIDE_KERNELS})
  endif()
  gamephys_objects(gamephys_${isa} ${GAMEPHYS_KERNELS} ${wide})
  target_compile_options(gamephys_${isa} PRIVATE ${GAMEPHYS_OPTIONS_${isa}})
endforeach()

function(gamephys_library target)
  add_library(${target} ${ARGN} ${GAMEPHYS_INTERFACE} ${GAMEPHYS_OBJECTS})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  gamephys_compilation(${target})
  gamephys_standard_headers(${target})
endfunction()

gamephys_library(gamephys_static STATIC)
add_library(gamephys::static ALIAS gamephys_static)
target_compile_definitions(gamephys_static PUBLIC GAMEPHYS_STATIC)
set_target_properties(gamephys_static PROPERTIES EXPORT_NAME static)
if(NOT WIN32) # there the import library of the shared one has this name
  set_target_properties(gamephys_static PROPERTIES OUTPUT_NAME gamephys)
endif()
# What a C linker has to be told so that it links C++ objects: stdc++ and m, or c++ and m.
set(GAMEPHYS_CXX_RUNTIME ${CMAKE_CXX_IMPLICIT_LINK_LIBRARIES})
list(REMOVE_ITEM GAMEPHYS_CXX_RUNTIME ${CMAKE_C_IMPLICIT_LINK_LIBRARIES})
target_link_libraries(gamephys_static INTERFACE ${GAMEPHYS_CXX_RUNTIME})

if(GAMEPHYS_SHARED)
  gamephys_library(gamephys SHARED)
  target_compile_definitions(gamephys PRIVATE GAMEPHYS_BUILD)
  # With -ffast-math the compiler's driver links an object that flushes the host's denormals to zero.
  target_link_options(gamephys PRIVATE ${GAMEPHYS_OPTIMISATION} -fno-fast-math -fno-unsafe-math-optimizations)
  set_target_properties(gamephys PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  if(UNIX AND NOT APPLE)
    # Hidden visibility alone leaves instances of the C++ library's templates exported.
    set(map ${PROJECT_SOURCE_DIR}/cmake/gamephys.map)
    target_link_options(gamephys PRIVATE LINKER:--version-script=${map} LINKER:-z,relro,-z,now)
    set_target_properties(gamephys PROPERTIES LINK_DEPENDS ${map})
  endif()
  if(NOT GAMEPHYS_INSTALL)
    set_target_properties(gamephys_static PROPERTIES EXCLUDE_FROM_ALL ON)
  endif()
  add_library(gamephys::gamephys ALIAS gamephys)
else()
  add_library(gamephys ALIAS gamephys_static)
  add_library(gamephys::gamephys ALIAS gamephys_static)
endif()
