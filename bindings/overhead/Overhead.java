import gamephys.*;
import java.util.Collections;
import java.util.Locale;

/** Java: Overhead [milliseconds a case] */
public class Overhead {
    static final int RAYS = 1000;
    static Object kept; // so that no result is optimised away

    static void measure(String name, Runnable call, int items, double budget) {
        double end = System.nanoTime() + budget, best = Double.POSITIVE_INFINITY;
        long calls = 1;
        while (System.nanoTime() < end || Double.isInfinite(best)) {
            long start = System.nanoTime();
            for (long i = 0; i < calls; ++i) call.run();
            double elapsed = System.nanoTime() - start;
            if (elapsed < 1e6) {
                calls *= 2;
            } else {
                best = Math.min(best, elapsed / calls);
            }
        }
        System.out.printf(Locale.ROOT, "java,%s,%.2f%n", name, best / items);
    }

    public static void main(String[] arguments) {
        double budget = 1e6 * (arguments.length > 0 ? Double.parseDouble(arguments[0]) : 200);
        Scene scene = new Scene();
        Camera camera = new Camera();
        int model = scene.add(new Sphere(new Vec3(0, 0, 5), 1));
        Ray ray = new Ray(new Vec3(0, 0, 0), new Vec3(0, 0, 1), 100);
        Batch<Ray> rays = Batch.copyOf(Ray.LAYOUT, Collections.nCopies(RAYS, ray));
        Batch<Hit> hits = Batch.allocate(Hit.LAYOUT, RAYS);
        scene.raycastBatch(rays, Gamephys.ALL_LAYERS, hits);
        if (scene.raycast(ray).orElseThrow().t() != 4 || hits.get(RAYS - 1).t() != 4) throw new AssertionError("wrong answer");
        measure("scalar", () -> kept = scene.has(model), 1, budget);
        measure("vec3", () -> kept = camera.getOrigin(), 1, budget);
        measure("raycast", () -> kept = scene.raycast(ray), 1, budget);
        measure("raycast_batch", () -> scene.raycastBatch(rays, Gamephys.ALL_LAYERS, hits), RAYS, budget);
    }
}
