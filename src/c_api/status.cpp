// Version, status names, last error.
#include "c_api/api.h"

using namespace gphys;

uint32_t gphys_version(void) { return GPHYS_VERSION_MAJOR << 16 | GPHYS_VERSION_MINOR << 8 | GPHYS_VERSION_PATCH; }

const char* gphys_status_name(gphys_status status) {
    switch (status) {
        case GPHYS_OK:
            return "GPHYS_OK";
        case GPHYS_NO_HIT:
            return "GPHYS_NO_HIT";
        case GPHYS_INCOMPLETE:
            return "GPHYS_INCOMPLETE";
        case GPHYS_UNBOUNDED:
            return "GPHYS_UNBOUNDED";
        case GPHYS_ERROR_INVALID_ARGUMENT:
            return "GPHYS_ERROR_INVALID_ARGUMENT";
        case GPHYS_ERROR_INVALID_ID:
            return "GPHYS_ERROR_INVALID_ID";
        case GPHYS_ERROR_STRUCT_SIZE:
            return "GPHYS_ERROR_STRUCT_SIZE";
        case GPHYS_ERROR_OUT_OF_MEMORY:
            return "GPHYS_ERROR_OUT_OF_MEMORY";
        case GPHYS_ERROR_CAPACITY:
            return "GPHYS_ERROR_CAPACITY";
        case GPHYS_ERROR_CYCLE:
            return "GPHYS_ERROR_CYCLE";
        case GPHYS_ERROR_UNSUPPORTED:
            return "GPHYS_ERROR_UNSUPPORTED";
        case GPHYS_ERROR_SINGULAR:
            return "GPHYS_ERROR_SINGULAR";
        case GPHYS_ERROR_INTERNAL:
            return "GPHYS_ERROR_INTERNAL";
        default:
            return "unknown";
    }
}

const char* gphys_last_error(void) { return last_error(); }
