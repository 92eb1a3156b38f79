import gamephys.*;

/**
 * A lidar that turns on a vehicle: a million rays a frame, from direct memory that the library reads in place.
 *
 * <p>Lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
 */
public class Lidar {
    static final int BEAMS = 64;
    static final float RANGE = 120;

    static void check(boolean truth) {
        if (!truth) throw new AssertionError("wrong answer");
    }

    /** Ground, and houses and posts to both sides. */
    static Scene street() {
        Scene scene = new Scene();
        scene.add(new Plane(new Vec3(0, 1, 0), 0));
        for (int i = 0; i < 40; ++i) {
            float side = 1 - 2 * (i % 2), z = 5 * i - 100;
            scene.add(new Aabb(new Vec3(14 * side - 5, 0, z), new Vec3(14 * side + 5, 6, z + 8)));
            scene.add(new Capsule(new Vec3(7 * side, 0, z), new Vec3(7 * side, 6, z), 0.15f));
        }
        return scene;
    }

    public static void main(String[] arguments) {
        int frames = arguments.length > 0 ? Integer.parseInt(arguments[0]) : 3;
        int columns = arguments.length > 1 ? Integer.parseInt(arguments[1]) : 15625;
        Batch<Ray> rays = Batch.allocate(Ray.LAYOUT, columns * BEAMS);
        Batch<Hit> hits = Batch.allocate(Hit.LAYOUT, rays.size()); // filled again by every frame
        try (Scene scene = street()) {
            for (int frame = 0; frame < frames; ++frame) {
                Vec3 origin = new Vec3(0, 1.8f, 0.5f * frame); // the vehicle drives on
                for (int i = 0; i < rays.size(); ++i) {
                    double turn = (double) (i / BEAMS) / columns * 2 * Math.PI;
                    double tilt = -0.43 + 0.46 * (i % BEAMS) / (BEAMS - 1), across = Math.cos(tilt);
                    Vec3 direction = new Vec3((float) (Math.cos(turn) * across), (float) Math.sin(tilt), (float) (Math.sin(turn) * across));
                    rays.set(i, new Ray(origin, direction, RANGE));
                }
                long start = System.nanoTime();
                scene.raycastBatch(rays, Gamephys.ALL_LAYERS, hits);
                double milliseconds = (System.nanoTime() - start) / 1e6;
                int seen = 0;
                for (int i = 0; i < hits.size(); ++i) {
                    Hit hit = hits.get(i);
                    if (hit.model() == 0) continue;
                    ++seen;
                    float end = origin.y() + rays.get(i).direction().y() * hit.t();
                    check(hit.t() <= RANGE && Math.abs(end - hit.point().y()) < 1e-4);
                }
                System.out.printf("frame %d: %d rays in %.0f ms, %d points%n", frame, hits.size(), milliseconds, seen);
                check(seen > hits.size() / 2 && seen < hits.size());
            }
        }
    }
}
