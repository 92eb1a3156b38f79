package gamephys;

import com.sun.jna.Pointer;
import java.lang.ref.Cleaner;
import java.util.function.Consumer;

/** Owns one object of the library: freed by close(), or after nothing refers to it. */
public abstract class Owned implements AutoCloseable {
    private static final Cleaner CLEANER = Cleaner.create();
    private final Cleaner.Cleanable cleanable;
    private Pointer pointer;

    Owned(Pointer pointer, Consumer<Pointer> destroy) {
        this.pointer = pointer;
        this.cleanable = CLEANER.register(this, () -> destroy.accept(pointer));
    }

    /** The C object. */
    final Pointer opened() {
        if (pointer == null) throw new IllegalStateException(getClass().getSimpleName() + " is closed");
        return pointer;
    }

    /** Frees the object now. Using it afterwards is an IllegalStateException; closing again does nothing. */
    @Override
    public final void close() {
        pointer = null;
        cleanable.clean();
    }
}
