/// Errors of the library as exceptions. gamephys_c is the preprocessed header, which ImportC reads.
module errors;

import gamephys_c;
import std.string : fromStringz;

enum allLayers = uint.max; // a macro in C, which the preprocessor has taken away

/// An outcome that is not an error is handed on.
gphys_status must(gphys_status status) {
    if (status < 0) throw new Exception(gphys_last_error().fromStringz.idup);
    return status;
}
