import gamephys.*;

/** A rope with a weight, and a cloth that falls over a ball. */
public class Step {
    public static void main(String[] arguments) {
        try (Scene scene = new Scene(); Solver solver = new Solver()) {
            scene.add(new Plane(new Vec3(0, 1, 0), 0));
            scene.add(new Sphere(new Vec3(0, 1, 0), 1));

            Batch<Vec3> line = Batch.allocate(Vec3.LAYOUT, 41);
            for (int i = 0; i < 41; ++i) line.set(i, new Vec3(5 + 0.05f * i, 3, 0));
            int rope = solver.addRope(line, 0, new BodyDesc().damping(2));
            solver.setPinned(rope, 0, 1, true);
            solver.setMasses(rope, 40, Batch.floats(5));

            int cloth = solver.addCloth(new Vec3(-1.5f, 3, -1.5f), new Vec3(3, 0, 0), new Vec3(0, 0, 3), 31, 31,
                    new BodyDesc().damping(2).radius(0.02f).clothFlags(Gamephys.CLOTH_BEND));
            int count = solver.getBodyInfo(cloth).particleCount();
            Batch<Vec3> positions = Batch.allocate(Vec3.LAYOUT, count);
            for (int frame = 0; frame < 6 * 60; ++frame) {
                solver.advance(scene, 1 / 60f);
                solver.getPositions(cloth, 0, count, positions); // the same memory each frame
            }

            double height = positions.stream()
                    .mapToDouble(p -> Math.sqrt(p.x() * p.x() + (p.y() - 1) * (p.y() - 1) + p.z() * p.z()) - 1)
                    .min().orElseThrow();
            Vec3 weight = solver.getPositions(rope, 40, 1).get(0);
            System.out.printf("weight %.3f m below the nail, cloth %.4f m above the ball%n", 3 - weight.y(), height);
            if (!(weight.y() < 1.02 && height > 0.015 && height < 0.03)) throw new AssertionError("wrong answer");
        }
    }
}
