package gamephys;

import com.sun.jna.Pointer;
import java.lang.ref.Cleaner;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.function.Consumer;

/** Owns one object of the library: freed by close(), or after nothing refers to it. */
public abstract class Owned implements AutoCloseable {
    private static final Cleaner CLEANER = Cleaner.create();
    private static final int CLOSED = 1 << 31;
    private final Cleaner.Cleanable cleanable;
    private final Pointer pointer;
    /** The calls that other threads are in, and whether close() has been called. */
    private final AtomicInteger calls = new AtomicInteger();

    Owned(Pointer pointer, Consumer<Pointer> destroy) {
        this.pointer = pointer;
        this.cleanable = CLEANER.register(this, () -> destroy.accept(pointer));
    }

    /** The C object, which stays until leave(); null for null. */
    static Pointer enter(Owned object) {
        if (object == null) return null;
        if (object.calls.incrementAndGet() < 0) {
            leave(object);
            throw new IllegalStateException(object.getClass().getSimpleName() + " is closed");
        }
        return object.pointer;
    }

    static void leave(Owned object) {
        if (object != null && object.calls.decrementAndGet() == CLOSED) object.cleanable.clean();
    }

    /** The C object, for a mesh that is a shape. */
    final Pointer opened() {
        if (calls.get() < 0) throw new IllegalStateException(getClass().getSimpleName() + " is closed");
        return pointer;
    }

    /**
     * Frees the object now, or when the calls end that other threads are in. Using it afterwards is an
     * IllegalStateException; closing again does nothing.
     */
    @Override
    public final void close() {
        if (calls.getAndUpdate(n -> n | CLOSED) == 0) cleanable.clean();
    }
}
