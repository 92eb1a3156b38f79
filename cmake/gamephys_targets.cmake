# gamephys         shared library (gamephys::gamephys), or another name of the static one
# gamephys_static  static archive (gamephys::static)
#
# Both take the same objects of everything below src/c_api. The C interface itself is compiled for
# each: objects that export it would re-export it from any shared object that takes the archive in.

file(GLOB_RECURSE GAMEPHYS_SOURCES CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*.cpp)
# Compiled once for each instruction set (src/foundation/isa.h has the same list).
file(GLOB_RECURSE GAMEPHYS_KERNELS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/*_kernels.cpp)
file(GLOB GAMEPHYS_INTERFACE CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/src/c_api/*.cpp)
list(REMOVE_ITEM GAMEPHYS_SOURCES ${GAMEPHYS_KERNELS} ${GAMEPHYS_INTERFACE})
set(GAMEPHYS_ISAS scalar)
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64|amd64|i[3-6]86)$")
  list(APPEND GAMEPHYS_ISAS sse2 avx2 avx512)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^(aarch64|arm64|ARM64)$")
  list(APPEND GAMEPHYS_ISAS neon)
elseif(CMAKE_SYSTEM_PROCESSOR MATCHES "^wasm" AND CMAKE_CXX_FLAGS MATCHES "-msimd128")
  list(APPEND GAMEPHYS_ISAS wasm)
endif()
set(GAMEPHYS_OPTIONS_sse2 -msse2)
set(GAMEPHYS_OPTIONS_avx2 -mavx2)
set(GAMEPHYS_OPTIONS_avx512 -mavx2 -mavx512f -mavx512vl -mavx512dq -mavx512bw)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # gcc 12 warns of undefined registers in its own avx512fintrin.h (bug 105593).
  list(APPEND GAMEPHYS_OPTIONS_avx512 -Wno-maybe-uninitialized -Wno-uninitialized)
endif()

# Warnings, for everything that belongs to this project.
function(gamephys_warnings target)
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    target_compile_options(${target} PRIVATE -Wall -Wextra $<$<BOOL:${GAMEPHYS_WERROR}>:-Werror>)
  endif()
endfunction()

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
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag("-Werror -ffp-exception-behavior=maytrap" GAMEPHYS_HAS_MAYTRAP)
function(gamephys_exact_traps target)
  if(GAMEPHYS_HAS_MAYTRAP)
    target_compile_options(${target} PRIVATE $<$<COMPILE_LANGUAGE:CXX>:-ffp-exception-behavior=maytrap>)
  endif()
endfunction()

set(THREADS_PREFER_PTHREAD_FLAG ON)
find_package(Threads REQUIRED)

# How everything in src is compiled.
function(gamephys_compilation target)
  target_compile_features(${target} PRIVATE cxx_std_17)
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/src)
  target_link_libraries(${target} PRIVATE Threads::Threads)
  set_target_properties(
    ${target}
    PROPERTIES CXX_EXTENSIONS OFF
               CXX_VISIBILITY_PRESET hidden
               VISIBILITY_INLINES_HIDDEN ON
               POSITION_INDEPENDENT_CODE ON)
  gamephys_warnings(${target})
  if(CMAKE_CXX_COMPILER_ID MATCHES "GNU|Clang")
    # Without contraction every processor gives the same bits. errno of sqrt is never read.
    target_compile_options(${target} PRIVATE -fno-rtti -ffp-contract=off -fno-math-errno)
    gamephys_exact_conversions(${target})
    gamephys_exact_traps(${target})
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
foreach(isa ${GAMEPHYS_ISAS})
  gamephys_objects(gamephys_${isa} ${GAMEPHYS_KERNELS})
  target_compile_definitions(gamephys_${isa} PRIVATE GPHYS_ISA=${isa})
  target_compile_options(gamephys_${isa} PRIVATE ${GAMEPHYS_OPTIONS_${isa}})
endforeach()

function(gamephys_library target)
  add_library(${target} ${ARGN} ${GAMEPHYS_INTERFACE} ${GAMEPHYS_OBJECTS})
  target_include_directories(${target} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/include>
                                              $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}>)
  gamephys_compilation(${target})
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

if(BUILD_SHARED_LIBS)
  gamephys_library(gamephys SHARED)
  target_compile_definitions(gamephys PRIVATE GAMEPHYS_BUILD)
  set_target_properties(gamephys PROPERTIES VERSION ${PROJECT_VERSION} SOVERSION ${PROJECT_VERSION_MAJOR})
  if(UNIX AND NOT APPLE)
    # Hidden visibility alone leaves instances of the C++ library's templates exported.
    set(map ${PROJECT_SOURCE_DIR}/cmake/gamephys.map)
    target_link_options(gamephys PRIVATE LINKER:--version-script=${map})
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
