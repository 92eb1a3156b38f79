import static gamephys.Gamephys.ALL_LAYERS;

import gamephys.*;
import java.util.List;

/** A scene and questions to it, one by one and in a batch. */
public class Scenes {
    static final int LAYER_WORLD = 1, LAYER_ROBOT = 2;
    static final Quat STILL = new Quat(0, 0, 0, 1);

    static Transform at(float x, float y, float z) {
        return new Transform(new Vec3(x, y, z), STILL, 1);
    }

    static void check(boolean truth) {
        if (!truth) throw new AssertionError("wrong answer");
    }

    public static void main(String[] arguments) {
        try (Scene scene = new Scene()) {
            int ground = scene.add(new Plane(new Vec3(0, 1, 0), 0));

            // A row of 100 pyramids, five metres apart, that share one mesh, which they keep alive.
            Batch<Transform> places = Batch.allocate(Transform.LAYOUT, 100);
            for (int i = 0; i < 100; ++i) places.set(i, at(5 * i, 0, 10));
            Batch<Integer> pyramids;
            try (Mesh mesh = new Mesh(
                    Batch.floats(-1, 0, -1, 1, 0, -1, 1, 0, 1, -1, 0, 1, 0, 2, 0),
                    Batch.ints(0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4))) {
                check(mesh.getReport().openEdgeCount() == 0);
                pyramids = scene.addBatch(Shapes.of(mesh), places);
            }

            // A robot's arm, and a hand two metres above it that follows.
            int arm = scene.add(new Capsule(new Vec3(0, 0, 0), new Vec3(0, 1, 0), 0.2f), at(0, 1, -5), new ModelDesc().layers(LAYER_ROBOT));
            int hand = scene.add(new Sphere(new Vec3(0, 0, 0), 0.5f), at(0, 2, 0), new ModelDesc().layers(LAYER_ROBOT).parent(arm));

            Hit hit = scene.raycast(new Ray(new Vec3(25, 1, 0), new Vec3(0, 0, 1), Float.POSITIVE_INFINITY)).orElseThrow();
            System.out.printf("ray: a pyramid, triangle %d, %.1f m away%n", hit.triangle(), hit.t());
            check(hit.model() == pyramids.get(5) && Math.abs(hit.t() - 9.5) < 1e-6);

            Segment sight = new Segment(new Vec3(0, 3, -10), new Vec3(0, 3, 0));
            check(scene.segmentTest(sight).orElseThrow().model() == hand);
            check(scene.segmentTest(sight, LAYER_WORLD).isEmpty());
            scene.setTransform(arm, at(0, 1, -50));
            check(scene.segmentTest(sight).isEmpty());
            check(scene.nearest(new Vec3(0, 10, -50), 100, LAYER_WORLD).orElseThrow().model() == ground);

            List<Integer> found = scene.overlap(new Aabb(new Vec3(-1, 0.5f, 8), new Vec3(21, 1, 12)), LAYER_WORLD);
            System.out.printf("box: %d models%n", found.size());
            check(found.equals(pyramids.subList(0, 5)));

            // One call for 1000 rays that look down.
            Batch<Ray> rays = Batch.allocate(Ray.LAYOUT, 1000);
            for (int i = 0; i < 1000; ++i) rays.set(i, new Ray(new Vec3(0.5f * i, 5, 10), new Vec3(0, -1, 0), 10));
            long above = scene.raycastBatch(rays, ALL_LAYERS).stream().filter(each -> each.t() < 5).count();
            System.out.printf("batch: %d of 1000 rays end on a pyramid%n", above);
            check(above == 299);
        }
    }
}
