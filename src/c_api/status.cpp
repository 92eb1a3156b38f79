// Version, status names, last error.
#include "c_api/api.h"

using namespace gphys;

uint32_t gphys_version(void) { return GPHYS_VERSION_MAJOR << 16 | GPHYS_VERSION_MINOR << 8 | GPHYS_VERSION_PATCH; }

#define GPHYS_CASE(status) \
    case status:           \
        return #status

const char* gphys_status_name(gphys_status status) {
    switch (status) {
        GPHYS_CASE(GPHYS_OK);
        GPHYS_CASE(GPHYS_NO_HIT);
        GPHYS_CASE(GPHYS_INCOMPLETE);
        GPHYS_CASE(GPHYS_UNBOUNDED);
        GPHYS_CASE(GPHYS_ERROR_INVALID_ARGUMENT);
        GPHYS_CASE(GPHYS_ERROR_INVALID_ID);
        GPHYS_CASE(GPHYS_ERROR_STRUCT_SIZE);
        GPHYS_CASE(GPHYS_ERROR_OUT_OF_MEMORY);
        GPHYS_CASE(GPHYS_ERROR_CAPACITY);
        GPHYS_CASE(GPHYS_ERROR_CYCLE);
        GPHYS_CASE(GPHYS_ERROR_UNSUPPORTED);
        GPHYS_CASE(GPHYS_ERROR_SINGULAR);
        GPHYS_CASE(GPHYS_ERROR_INTERNAL);
        default:
            return "unknown";
    }
}

const char* gphys_last_error(void) { return last_error(); }
