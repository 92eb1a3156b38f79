# The instruction sets that kernels are compiled for (src/foundation/isa.h has the same lists):
#   GAMEPHYS_ISAS               their names
#   GAMEPHYS_WIDE_ISAS          those of them, and others, whose registers hold four doubles or more
#   GAMEPHYS_OPTIONS_<isa>      the compiler options of each, the definition of GPHYS_ISA among them

set(GAMEPHYS_WIDE_ISAS avx2 avx512)

set(isa_options_sse2 -msse2)
set(isa_options_avx2 -mavx2)
set(isa_options_avx512 -mavx2 -mavx512f -mavx512vl -mavx512dq -mavx512bw)

option(GAMEPHYS_SCALAR_KERNELS "Kernels without SIMD instructions too, as a reference for the others" OFF)
mark_as_advanced(GAMEPHYS_SCALAR_KERNELS)
if(GAMEPHYS_SCALAR_KERNELS)
  add_compile_definitions(GPHYS_SCALAR_KERNELS)
endif()

option(GAMEPHYS_WIDEST_KERNELS
       "Beside the scalar kernels only those of the widest x86 instruction set that this machine has" OFF)
mark_as_advanced(GAMEPHYS_WIDEST_KERNELS)
set(isas_x86 sse2 avx2 avx512)
if(GAMEPHYS_WIDEST_KERNELS AND GAMEPHYS_SCALAR_KERNELS)
  include(CheckCXXSourceRuns)
  foreach(isa avx512vl avx2)
    check_cxx_source_runs("int main() { return __builtin_cpu_supports(\"${isa}\") ? 0 : 1; }" GAMEPHYS_HAS_${isa})
    if(GAMEPHYS_HAS_${isa})
      string(REPLACE "vl" "" isas_x86 ${isa})
      string(TOUPPER ${isas_x86} only)
      add_compile_definitions(GPHYS_ONLY_${only})
      break()
    endif()
  endforeach()
endif()

# gamephys_isas_of(OUT PROCESSOR)
function(gamephys_isas_of out processor)
  set(isas)
  if(processor MATCHES "^(x86_64h?|AMD64|amd64|i[3-6]86)$")
    set(isas ${isas_x86})
  elseif(processor MATCHES "^(aarch64|arm64e?|ARM64)$")
    set(isas neon)
  elseif(processor MATCHES "^wasm" AND CMAKE_CXX_FLAGS MATCHES "-msimd128")
    set(isas wasm)
  endif()
  # Each 64-bit x86 processor has SSE2, but not each 32-bit one.
  if(GAMEPHYS_SCALAR_KERNELS OR NOT isas OR ("sse2" IN_LIST isas AND CMAKE_SIZEOF_VOID_P EQUAL 4))
    list(PREPEND isas scalar)
  endif()
  set(${out} ${isas} PARENT_SCOPE)
endfunction()

# On macOS the target is CMAKE_OSX_ARCHITECTURES, whatever processor compiles.
set(architectures ${CMAKE_SYSTEM_PROCESSOR})
if(APPLE AND CMAKE_OSX_ARCHITECTURES)
  set(architectures ${CMAKE_OSX_ARCHITECTURES})
endif()
list(LENGTH architectures architecture_count)

set(GAMEPHYS_ISAS)
foreach(architecture IN LISTS architectures)
  gamephys_isas_of(isas_${architecture} "${architecture}")
  list(APPEND GAMEPHYS_ISAS ${isas_${architecture}})
endforeach()
list(REMOVE_DUPLICATES GAMEPHYS_ISAS)

foreach(isa IN LISTS GAMEPHYS_ISAS)
  if(architecture_count LESS_EQUAL 1)
    set(GAMEPHYS_OPTIONS_${isa} -DGPHYS_ISA=${isa} ${isa_options_${isa}})
    continue()
  endif()
  # One compilation makes the objects of all architectures. Where an architecture lacks the
  # instruction set, it gets plain code in a namespace that nothing refers to.
  set(GAMEPHYS_OPTIONS_${isa})
  foreach(architecture IN LISTS architectures)
    set(for "SHELL:-Xarch_${architecture}")
    if(isa IN_LIST isas_${architecture})
      list(APPEND GAMEPHYS_OPTIONS_${isa} "${for} -DGPHYS_ISA=${isa}")
      foreach(option IN LISTS isa_options_${isa})
        list(APPEND GAMEPHYS_OPTIONS_${isa} "${for} ${option}")
      endforeach()
    else()
      list(APPEND GAMEPHYS_OPTIONS_${isa} "${for} -DGPHYS_ISA=without_${isa}")
    endif()
  endforeach()
endforeach()
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # gcc 12 warns of undefined registers in its own avx512fintrin.h (bug 105593).
  list(APPEND GAMEPHYS_OPTIONS_avx512 -Wno-maybe-uninitialized -Wno-uninitialized)
endif()
