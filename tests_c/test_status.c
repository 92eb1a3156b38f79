/* Version, status names and the error text. */
#include "test.h"

static void version_matches_header(void** state) {
    (void)state;
    assert_int_equal(gphys_version(), GPHYS_VERSION_MAJOR << 16 | GPHYS_VERSION_MINOR << 8 | GPHYS_VERSION_PATCH);
}

static void every_status_has_a_name(void** state) {
    (void)state;
    assert_string_equal(gphys_status_name(GPHYS_OK), "GPHYS_OK");
    assert_string_equal(gphys_status_name(GPHYS_ERROR_SINGULAR), "GPHYS_ERROR_SINGULAR");
    assert_string_equal(gphys_status_name(12345), "unknown");
}

int main(void) {
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_matches_header),
        cmocka_unit_test(every_status_has_a_name),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
