// Stops the compiler if its flags break IEEE arithmetic (-ffast-math and the like), on which all results depend. The
// build system switches these flags off.
#pragma once

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || \
    defined(__NO_SIGNED_ZEROS__) || (defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__)
#error "gamephys must not be compiled with -ffast-math or a part of it: signs and answers would be wrong"
#endif

#if defined(__FLT_EVAL_METHOD__) && __FLT_EVAL_METHOD__ != 0
#error "gamephys needs double arithmetic that rounds once: compile with -msse2 -mfpmath=sse"
#endif
