/* The part of cmocka's interface that these tests use, for machines without cmocka: a failed check
 * prints its place and ends its test. */
#ifndef PORTABLE_CMOCKA_H
#define PORTABLE_CMOCKA_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

struct CMUnitTest {
    const char* name;
    void (*test)(void** state);
    int (*setup)(void** state);
    int (*teardown)(void** state);
};

#define cmocka_unit_test(f) \
    { #f, f, NULL, NULL }
#define cmocka_unit_test_setup_teardown(f, setup, teardown) \
    { #f, f, setup, teardown }

static jmp_buf portable_failure;

static inline void portable_check(int condition, const char* text, const char* file, int line) {
    if (condition) return;
    printf("%s:%d: %s\n", file, line, text);
    longjmp(portable_failure, 1);
}

#define fail_msg(...) (printf(__VA_ARGS__), portable_check(0, "", __FILE__, __LINE__))
#define PORTABLE_CHECK(condition, text) portable_check(condition, text, __FILE__, __LINE__)
#define assert_true(c) PORTABLE_CHECK((c) ? 1 : 0, #c)
#define assert_false(c) PORTABLE_CHECK((c) ? 0 : 1, "not " #c)
#define assert_int_equal(a, b) PORTABLE_CHECK((long long)(a) == (long long)(b), #a " == " #b)
#define assert_int_not_equal(a, b) PORTABLE_CHECK((long long)(a) != (long long)(b), #a " != " #b)
#define assert_in_range(a, low, high) PORTABLE_CHECK((a) >= (low) && (a) <= (high), #a " in range")
#define assert_float_equal(a, b, epsilon) PORTABLE_CHECK(fabs((double)(a) - (double)(b)) <= (epsilon), #a " is " #b)
#define assert_null(p) PORTABLE_CHECK((p) == NULL, #p " == NULL")
#define assert_non_null(p) PORTABLE_CHECK((p) != NULL, #p " != NULL")
#define assert_ptr_equal(a, b) PORTABLE_CHECK((const void*)(a) == (const void*)(b), #a " == " #b)
#define assert_memory_equal(a, b, size) PORTABLE_CHECK(memcmp(a, b, size) == 0, #a " holds what " #b " holds")
#define assert_memory_not_equal(a, b, size) PORTABLE_CHECK(memcmp(a, b, size) != 0, #a " differs from " #b)
#define assert_string_equal(a, b) PORTABLE_CHECK(strcmp(a, b) == 0, #a " is " #b)
#define assert_string_not_equal(a, b) PORTABLE_CHECK(strcmp(a, b) != 0, #a " is not " #b)

static int portable_run(const struct CMUnitTest* tests, size_t count, int (*setup)(void**), int (*teardown)(void**)) {
    volatile int failed = 0;
    void* group = NULL;
    if (setup && setup(&group) != 0) return 1;
    for (volatile size_t i = 0; i < count; ++i) {
        void* state = group;
        volatile int passed = 0;
        if (tests[i].setup) tests[i].setup(&state);
        if (setjmp(portable_failure) == 0) {
            tests[i].test(&state);
            passed = 1;
        }
        if (tests[i].teardown) tests[i].teardown(&state);
        printf("%s %s\n", passed ? "ok    " : "FAILED", tests[i].name);
        fflush(stdout);
        failed += !passed;
    }
    if (teardown && teardown(&group) != 0) ++failed;
    return failed;
}

#define cmocka_run_group_tests(tests, setup, teardown) \
    portable_run(tests, sizeof(tests) / sizeof((tests)[0]), setup, teardown)

#endif
