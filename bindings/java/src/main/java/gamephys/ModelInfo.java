// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import java.nio.ByteBuffer;

/**
 * <pre>
 * What a model is. Frozen.
 * </pre>
 */
public record ModelInfo(int type, int parent, int layers, int tag, int childCount) implements Value {
    public static final Layout<ModelInfo> LAYOUT = new Layout<>(20, 0, ModelInfo::read, ModelInfo::write);

    static ModelInfo read(ByteBuffer memory, int at) {
        return new ModelInfo(
                memory.getInt(at),
                memory.getInt(at + 4),
                memory.getInt(at + 8),
                memory.getInt(at + 12),
                memory.getInt(at + 16));
    }

    @Override
    public void write(ByteBuffer memory, int at) {
        memory.putInt(at, type);
        memory.putInt(at + 4, parent);
        memory.putInt(at + 8, layers);
        memory.putInt(at + 12, tag);
        memory.putInt(at + 16, childCount);
    }
}
