/* Version, status names and the error text. */
#include "test.h"

static void version_matches_header(void** state) {
    (void)state;
    assert_int_equal(gphys_version(), GPHYS_VERSION_MAJOR << 16 | GPHYS_VERSION_MINOR << 8 | GPHYS_VERSION_PATCH);
}

static void every_status_has_a_name(void** state) {
    const gphys_status others[] = {4, -9, -99, -101, 12345, INT32_MAX, INT32_MIN};
    size_t i;
    (void)state;
#define CHECK_NAME(status) assert_string_equal(gphys_status_name(status), #status)
    CHECK_NAME(GPHYS_OK);
    CHECK_NAME(GPHYS_NO_HIT);
    CHECK_NAME(GPHYS_INCOMPLETE);
    CHECK_NAME(GPHYS_UNBOUNDED);
    CHECK_NAME(GPHYS_ERROR_INVALID_ARGUMENT);
    CHECK_NAME(GPHYS_ERROR_INVALID_ID);
    CHECK_NAME(GPHYS_ERROR_STRUCT_SIZE);
    CHECK_NAME(GPHYS_ERROR_OUT_OF_MEMORY);
    CHECK_NAME(GPHYS_ERROR_CAPACITY);
    CHECK_NAME(GPHYS_ERROR_CYCLE);
    CHECK_NAME(GPHYS_ERROR_UNSUPPORTED);
    CHECK_NAME(GPHYS_ERROR_SINGULAR);
    CHECK_NAME(GPHYS_ERROR_INTERNAL);
    for (i = 0; i < sizeof others / sizeof *others; ++i) assert_string_equal(gphys_status_name(others[i]), "unknown");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_matches_header),
        cmocka_unit_test(every_status_has_a_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
