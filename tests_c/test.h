/* cmocka and the public header: all that a C test may see. */
#ifndef TEST_H
#define TEST_H

/* cmocka.h wants these before it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <gamephys_c.h>

#include <float.h>
#include <math.h>
#include <string.h>

/* A WebAssembly module has no threads unless it is built for shared memory. */
#if defined(__EMSCRIPTEN__) && !defined(__EMSCRIPTEN_PTHREADS__)
enum { HAS_THREADS = 0 };
#else
enum { HAS_THREADS = 1 };
#endif

#endif
