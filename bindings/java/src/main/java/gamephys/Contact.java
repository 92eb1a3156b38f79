// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * A particle that touched a model in the last step. Frozen.
 * </pre>
 */
public record Contact(int body, int particle, int model, int tag, Vec3 point, Vec3 normal) implements Value {
    public static final Layout<Contact> LAYOUT = new Layout<>(40, 0, Contact::read, Contact::write);

    static Contact read(ByteBuffer memory, int at) {
        return new Contact(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                Vec3.read(memory, at + 16),
                Vec3.read(memory, at + 28));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, body);
        memory.putInt(at + 4, particle);
        memory.putInt(at + 8, model);
        memory.putInt(at + 12, tag);
        point.write(memory, at + 16);
        normal.write(memory, at + 28);
    }
}
