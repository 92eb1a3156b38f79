// A rope with a weight, and a cloth that falls over a ball.
using System;
using System.Linq;
using Gamephys;

static class Program {
    static int Main() {
        using (var scene = new Scene())
        using (var solver = new Solver()) {
            scene.Add(new Plane((0, 1, 0), 0));
            scene.Add(new Sphere((0, 1, 0), 1));
            var desc = BodyDesc.Default;
            desc.Damping = 2;
            var line = Enumerable.Range(0, 41).Select(i => new Vec3(5 + 0.05f * i, 3, 0)).ToArray();
            var rope = solver.AddRope(line, desc: desc);
            solver.SetPinned(rope, 0, 1, true);
            solver.SetMasses(rope, 40, new float[] { 5 });
            desc.Radius = 0.02f;
            desc.ClothFlags = Constants.ClothBend;
            var cloth = solver.AddCloth((-1.5f, 3, -1.5f), (3, 0, 0), (0, 0, 3), 31, 31, desc);
            for (var frame = 0; frame < 360; ++frame) solver.Advance(1f / 60, scene);

            var positions = new Vec3[solver.GetBodyInfo(cloth).ParticleCount];
            solver.GetPositions(cloth, 0, positions); // into the caller's memory
            var height = positions.Min(p => Math.Sqrt(p.X * p.X + (p.Y - 1) * (p.Y - 1) + p.Z * p.Z)) - 1;
            solver.GetPositions(rope, 0, line);
            Console.WriteLine($"weight {3 - line[40].Y:F3} m below the nail, cloth {height:F4} m above the ball");
            return line[40].Y < 1.02f && height > 0.015 && height < 0.03 ? 0 : 1;
        }
    }
}
