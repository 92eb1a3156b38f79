package gamephys;

import com.sun.jna.Library;
import com.sun.jna.Native;
import com.sun.jna.NativeLibrary;
import com.sun.jna.Pointer;
import java.lang.ref.Reference;
import java.util.Map;

/** Calls: statuses become exceptions, lists are fetched whole. */
final class Low extends LowFunctions {
    private static final int FIRST_GUESS = 64;

    private Low() {}

    /** Connects native methods to the library: $GAMEPHYS_LIBRARY, else the one in the jar, else the system's. */
    static void load(Class<?> functions) {
        String named = System.getenv("GAMEPHYS_LIBRARY");
        String system = System.getProperty("os.name").startsWith("Linux") ? "libgamephys.so.1" : "gamephys";
        Native.register(
                functions,
                NativeLibrary.getInstance(named != null ? named : system, Map.of(Library.OPTION_STRING_ENCODING, "UTF-8")));
    }

    /** One of two offsets, by the size of a pointer. */
    static int pick(int wide, int narrow) {
        return Native.POINTER_SIZE == 8 ? wide : narrow;
    }

    static int check(int status) {
        if (status < 0) throw new GamephysException(status, gphys_last_error());
        return status;
    }

    static boolean found(int status) {
        return check(status) == Gamephys.OK;
    }

    /** A status that is an answer: OK is yes, the one given is no. */
    static boolean answered(int status, int no) {
        return status != no && found(status);
    }

    /** Keeps objects from being freed before the call returned. */
    static void keep(Object object) {
        Reference.reachabilityFence(object);
    }

    static void keep(Object first, Object second) {
        Reference.reachabilityFence(first);
        Reference.reachabilityFence(second);
    }

    static void keep(Object... objects) {
        for (Object object : objects) Reference.reachabilityFence(object);
    }

    /** A shape that is an object of the library, which a call holds. */
    static Mesh mesh(Shape shape) {
        return shape instanceof Mesh mesh ? mesh : null;
    }

    static Pointer shape(Shape shape, Scratch scratch, int slot) {
        return shape instanceof Mesh mesh ? mesh.opened() : scratch.put(slot, (Value) shape);
    }

    /** The length that batches share; -1 stands for any. */
    static int common(int... sizes) {
        int common = -1;
        for (int size : sizes) {
            if (size >= 0 && common >= 0 && size != common) {
                throw new IllegalArgumentException("batches of different lengths: " + common + " and " + size);
            }
            common = Math.max(common, size);
        }
        if (common < 0) throw new IllegalArgumentException("no batch says how many there are");
        return common;
    }

    interface Creation {
        int call(Pointer made);
    }

    static Pointer create(Creation creation) {
        Pointer made = Scratch.get().slot(15);
        check(creation.call(made));
        return made.getPointer(0);
    }

    interface Listing {
        int call(Pointer room, int capacity, Pointer total);
    }

    /** All elements of a list, whose call is repeated with enough room if it has to be. */
    static <T> Batch<T> list(Layout<T> layout, Listing listing) {
        Batch<Integer> total = Batch.allocate(Layout.INT, 1);
        for (int capacity = FIRST_GUESS; ; capacity = total.get(0)) {
            Batch<T> room = Batch.allocate(layout, capacity);
            if (check(listing.call(room.pointer(), capacity, total.pointer())) != Gamephys.INCOMPLETE) {
                return room.first(total.get(0));
            }
        }
    }

    static <T> Ragged<T> ragged(Layout<T> layout, int count, Listing listing) {
        Batch<Integer> offsets = Batch.allocate(Layout.INT, count + 1);
        for (int capacity = Math.max(FIRST_GUESS, count); ; capacity = offsets.get(count)) {
            Batch<T> room = Batch.allocate(layout, capacity);
            if (check(listing.call(room.pointer(), capacity, offsets.pointer())) != Gamephys.INCOMPLETE) {
                return new Ragged<>(room.first(offsets.get(count)), offsets);
            }
        }
    }
}
