# Emscripten's own toolchain, with SIMD and with exceptions, which the library uses inside, as
# WebAssembly itself has them: a module without any JavaScript of Emscripten's can throw. The folder
# wasm32 holds headers that its C++ library lacks.
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_FLAGS_INIT "-fwasm-exceptions -msimd128")
set(CMAKE_CXX_FLAGS_INIT "-fwasm-exceptions -msimd128 -isystem ${CMAKE_CURRENT_LIST_DIR}/wasm32")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fwasm-exceptions -sALLOW_MEMORY_GROWTH -O1") # its JavaScript optimiser fails above -O1
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
# What it makes for Node takes a global fetch for a browser's, which would want a URL of the module.
set(CMAKE_CROSSCOMPILING_EMULATOR node --no-experimental-fetch)
