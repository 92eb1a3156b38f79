# Arithmetic of the x87 rounds twice; with SSE2 the answers are those of every other processor.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR i686)
set(CMAKE_C_COMPILER i686-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER i686-linux-gnu-g++)
set(CMAKE_C_FLAGS_INIT "-msse2 -mfpmath=sse")
set(CMAKE_CXX_FLAGS_INIT "-msse2 -mfpmath=sse")
set(CMAKE_FIND_ROOT_PATH /usr/i686-linux-gnu)
# With the loader and the libraries of the compiler: the host's cache of libraries, which qemu's -L does not replace, may
# name another libc, with which that loader does not start threads.
set(loader /usr/i686-linux-gnu/lib/ld-linux.so.2 --library-path /usr/i686-linux-gnu/lib)
# Some kernels run no 32-bit programs; qemu does.
set(CMAKE_CROSSCOMPILING_EMULATOR ${loader})
execute_process(COMMAND ${loader} --help RESULT_VARIABLE without_32_bits OUTPUT_QUIET ERROR_QUIET)
if(NOT without_32_bits EQUAL 0)
  set(CMAKE_CROSSCOMPILING_EMULATOR qemu-i386-static -cpu max ${loader})
endif()
