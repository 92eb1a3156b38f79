/* What the library says about itself and about a call that it refused. */
#include <string.h>

#include "check.h"

/* A program that was linked to a shared library asks at its start whether the one that
 * it has got is new enough. */
static void version(void) {
    const uint32_t loaded = gphys_version();
    const uint32_t major = loaded >> 16, minor = loaded >> 8 & 0xff,
                   patch = loaded & 0xff;
    printf("gamephys %u.%u.%u\n", (unsigned)major, (unsigned)minor, (unsigned)patch);
    EXPECT(major == GPHYS_VERSION_MAJOR && minor >= GPHYS_VERSION_MINOR);
}

/* A sphere cannot have a negative radius. The status is for the program, the sentence
 * for whoever reads its log. */
static void refused(void) {
    const gphys_sphere ball = {{0, 0, 0}, -1};
    gphys_aabb box;
    const gphys_status status = gphys_shape_bounds(GPHYS_SHAPE_SPHERE, &ball, &box);
    EXPECT(status == GPHYS_ERROR_INVALID_ARGUMENT);
    fprintf(stderr, "%s: %s\n", gphys_status_name(status), gphys_last_error());
    EXPECT(strcmp(gphys_status_name(status), "GPHYS_ERROR_INVALID_ARGUMENT") == 0);
    EXPECT(strstr(gphys_last_error(), "radius") != NULL);
}

int main(void) {
    version();
    refused();
    return 0;
}
