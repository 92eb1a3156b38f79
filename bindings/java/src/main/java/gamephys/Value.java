package gamephys;

import java.nio.ByteBuffer;

/** A value that the library takes as a struct. */
interface Value {
    void write(ByteBuffer memory, int at);
}
