# Emscripten's own toolchain, with SIMD and with exceptions, which the library uses inside, as
# WebAssembly itself has them: a module without any JavaScript of Emscripten's can throw. The folder
# wasm32 holds headers that its C++ library lacks.
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions -msimd128")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -msimd128 -isystem ${CMAKE_CURRENT_LIST_DIR}/wasm32")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions -sALLOW_MEMORY_GROWTH -O1") # its JavaScript optimiser fails above -O1

# Emscripten is where emsdk says, where emcc in the PATH is, where Homebrew keeps it (there emcc is a
# script), or where Debian does.
set(emscripten_places)
if(DEFINED ENV{EMSDK})
  list(APPEND emscripten_places $ENV{EMSDK}/upstream/emscripten)
endif()
find_program(emcc emcc NO_CACHE)
if(emcc)
  file(REAL_PATH ${emcc} emcc)
  get_filename_component(emcc_place ${emcc} DIRECTORY)
  list(APPEND emscripten_places ${emcc_place})
endif()
foreach(homebrew $ENV{HOMEBREW_PREFIX} /opt/homebrew /usr/local /home/linuxbrew/.linuxbrew)
  list(APPEND emscripten_places ${homebrew}/opt/emscripten/libexec)
endforeach()
list(APPEND emscripten_places /usr/share/emscripten)
set(emscripten_module)
foreach(place IN LISTS emscripten_places)
  if(NOT emscripten_module AND EXISTS ${place}/cmake/Modules/Platform/Emscripten.cmake)
    set(emscripten_module ${place}/cmake/Modules/Platform/Emscripten.cmake)
  endif()
endforeach()
if(NOT emscripten_module)
  message(FATAL_ERROR "Emscripten is in none of: ${emscripten_places}. Activate emsdk (which sets EMSDK), put emcc "
                      "into the PATH, or install the package emscripten of Debian or Homebrew.")
endif()
include(${emscripten_module})

# What it makes for Node takes a global fetch for a browser's, which would want a URL of the module.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
