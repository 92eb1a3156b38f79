import gamephys.*;
import java.util.List;

/** What a camera sees: culling, a picture of picks, projection, marquee, orbit. */
public class Pick {
    static final int WIDTH = 64, HEIGHT = 16;

    static void check(boolean truth) {
        if (!truth) throw new AssertionError("wrong answer");
    }

    public static void main(String[] arguments) {
        try (Scene scene = new Scene(); Camera camera = new Camera(new CameraDesc().viewportWidth(640).viewportHeight(320))) {
            Batch<Integer> balls = scene.addBatch(Shapes.of(List.of(
                    new Sphere(new Vec3(-4, 0, 9), 1.5f), new Sphere(new Vec3(0, 0, 9), 1.5f),
                    new Sphere(new Vec3(4, 0, 9), 1.5f), new Sphere(new Vec3(0, 0, -50), 2))));
            camera.setPerspective(0.7f, 0.1f, 100);
            Orbit usual = Gamephys.defaultOrbit();
            camera.setOrbit(new Orbit(new Vec3(0, 0, 9), usual.up(), 8, 0, 0, 0.01f, usual.metresPerUnit(),
                    usual.minDistance(), usual.maxDistance(), usual.minPitch(), usual.maxPitch()));
            check(camera.cull(scene).size() == 3);

            Batch<Float> pixels = Batch.allocate(Layout.FLOAT, 2 * WIDTH * HEIGHT);
            for (int i = 0; i < WIDTH * HEIGHT; ++i) {
                pixels.set(2 * i, 10 * (i % WIDTH + 0.5f));
                pixels.set(2 * i + 1, 20 * (i / WIDTH + 0.5f));
            }
            Batch<Hit> hits = camera.pickBatch(scene, pixels);
            for (int row = 0; row < HEIGHT; ++row) {
                StringBuilder text = new StringBuilder();
                for (Hit hit : hits.subList(row * WIDTH, (row + 1) * WIDTH)) {
                    Vec3 n = hit.normal();
                    float light = Math.min(1, Math.max(0, -0.5f * n.x() + 0.6f * n.y() - 0.6f * n.z()));
                    text.append(hit.model() == 0 ? ' ' : "@%#*+=-:.".charAt(8 - (int) (8 * light)));
                }
                System.out.println(text.toString().stripTrailing());
            }

            Vec3 pixel = camera.project(new Vec3(-4, 0, 9)).orElseThrow();
            check(camera.pick(scene, pixel.x(), pixel.y()).orElseThrow().model() == balls.get(0));
            check(camera.pickRectangle(scene, 340, 0, 640, 320).equals(balls.subList(1, 3)));
            camera.orbitRotate(157.0796f, 0); // pixels of mouse movement: a quarter turn
            camera.orbitUpdate();
            List<Hit> behind = scene.raycastAll(camera.pickRay(320, 160).orElseThrow());
            check(behind.size() == 3 && behind.get(1).model() == balls.get(1));
            System.out.printf("after a quarter turn %d balls stand behind one another%n", behind.size());
        }
    }
}
