# Emscripten's own toolchain, with exceptions, which the library uses inside, and SIMD. The folder
# wasm32 holds headers that its C++ library lacks.
set(EMSCRIPTEN_SYSTEM_PROCESSOR wasm32)
set(CMAKE_C_FLAGS_INIT "-fexceptions -msimd128")
set(CMAKE_CXX_FLAGS_INIT "-fexceptions -msimd128 -isystem ${CMAKE_CURRENT_LIST_DIR}/wasm32")
set(CMAKE_EXE_LINKER_FLAGS_INIT "-fexceptions -sALLOW_MEMORY_GROWTH -O1") # its JavaScript optimiser fails above -O1
include(/usr/share/emscripten/cmake/Modules/Platform/Emscripten.cmake)
