// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.nio.ByteBuffer;

/**
 * <pre>
 * Which models a query sees. Ids that name no model leave out nothing and are not an error: the
 * model that asked may have been removed since.
 * </pre>
 */
public final class QueryFilterDesc extends Listed {
    /** For a Batch of copies: Batch.copyOf, or Batch.shared for one that stands for all. */
    public static final Layout<QueryFilterDesc> LAYOUT = new Layout<>(Low.pick(32, 28), 0, QueryFilterDesc::read, QueryFilterDesc::write);

    private final ByteBuffer memory = Batch.direct(Low.pick(32, 28));

    public QueryFilterDesc() {
        Low.check(Low.gphys_query_filter_desc_init(pointer(), memory.capacity()));
    }

    Pointer pointer() {
        return com.sun.jna.Native.getDirectBufferPointer(memory);
    }

    /**
     * <pre>
     * a model is seen if its own mask shares a bit; default ALL_LAYERS
     * </pre>
     */
    public QueryFilterDesc layers(int value) {
        memory.putInt(4, value);
        return this;
    }

    public int layers() {
        return memory.getInt(4);
    }

    /**
     * <pre>
     * left out; 0: none; default 0
     * </pre>
     */
    public QueryFilterDesc ignoredModel(int value) {
        memory.putInt(8, value);
        return this;
    }

    public int ignoredModel() {
        return memory.getInt(8);
    }

    /**
     * <pre>
     * filter values; default 0
     * </pre>
     */
    public QueryFilterDesc flags(int value) {
        memory.putInt(12, value);
        return this;
    }

    public int flags() {
        return memory.getInt(12);
    }

    /**
     * <pre>
     * left out as well, in any order; read during the call; default null
     * </pre>
     */
    public QueryFilterDesc ignoredModels(int... value) {
        Batch<Integer> copy = Batch.ints(value);
        pointer().setPointer(16, value.length == 0 ? null : copy.pointer());
        memory.putInt(Low.pick(24, 20), value.length);
        list = copy;
        return this;
    }

    /** The same from a Batch or another list. */
    public QueryFilterDesc ignoredModels(java.util.List<Integer> value) {
        return ignoredModels(value.stream().mapToInt(Integer::intValue).toArray());
    }

    private static QueryFilterDesc read(ByteBuffer memory, int at) {
        QueryFilterDesc copy = new QueryFilterDesc();
        copy.memory.put(0, memory, at, Low.pick(32, 28));
        return copy;
    }

    private void write(ByteBuffer to, int at) {
        to.put(at, memory, 0, Low.pick(32, 28));
    }
}
