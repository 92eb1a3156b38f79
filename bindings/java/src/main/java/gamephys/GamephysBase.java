package gamephys;

/** What Gamephys has beside the functions that their declarations give. */
public abstract sealed class GamephysBase permits Gamephys {
    /** Version of the loaded library. */
    public static String version() {
        int version = Low.gphys_version();
        return (version >> 16) + "." + (version >> 8 & 255) + "." + (version & 255);
    }

    /** Name of a status, such as "GPHYS_NO_HIT". */
    public static String statusName(int status) {
        return Low.gphys_status_name(status);
    }

    /** The orbit settings that the library starts from. */
    public static Orbit defaultOrbit() {
        Scratch scratch = Scratch.get();
        Low.check(Low.gphys_orbit_init(scratch.slot(0)));
        return Orbit.read(scratch.memory, Scratch.at(0));
    }

    /** The shape moved by a transform; an Aabb becomes an Obb. */
    public static Shape transform(Shape shape, Transform by) {
        Scratch scratch = Scratch.get();
        int status =
                Low.gphys_shape_transform(shape.kind(), Low.shape(shape, scratch, 1), scratch.put(2, by), scratch.slot(3));
        Low.keep(shape);
        Low.check(status);
        int moved = shape instanceof Aabb ? Gamephys.SHAPE_OBB : shape.kind();
        return Shapes.layoutOf(moved).reader().read(scratch.memory, Scratch.at(3));
    }
}
