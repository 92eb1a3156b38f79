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

#endif
