// A lidar that turns on a vehicle: a million rays a frame, shared by tasks that read one scene.
//
// lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
using System;
using System.Diagnostics;
using System.Linq;
using System.Threading.Tasks;
using Gamephys;

static class Program {
    const int Beams = 64;
    const float Range = 120;

    // Ground, and houses and posts to both sides.
    static Scene Street() {
        var scene = new Scene();
        scene.Add(new Plane((0, 1, 0), 0));
        var houses = new Aabb[40];
        var posts = new Capsule[40];
        for (var i = 0; i < 40; ++i) {
            float side = 1 - 2 * (i % 2), z = 5 * i - 100;
            houses[i] = new Aabb((14 * side - 5, 0, z), (14 * side + 5, 6, z + 8));
            posts[i] = new Capsule((7 * side, 0, z), (7 * side, 6, z), 0.15f);
        }
        var models = new uint[40];
        scene.AddBatch(houses, models);
        scene.AddBatch(posts, models);
        return scene;
    }

    static int Main(string[] arguments) {
        var frames = arguments.Length > 0 ? int.Parse(arguments[0]) : 3;
        var columns = arguments.Length > 1 ? int.Parse(arguments[1]) : 15625;
        var rays = new Ray[columns * Beams];
        for (var i = 0; i < rays.Length; ++i) {
            var turn = (double)(i / Beams) / columns * 2 * Math.PI;
            var tilt = -0.43 + 0.46 * (i % Beams) / (Beams - 1);
            var direction = ((float)(Math.Cos(turn) * Math.Cos(tilt)), (float)Math.Sin(tilt), (float)(Math.Sin(turn) * Math.Cos(tilt)));
            rays[i] = new Ray((0, 0, 0), direction, Range);
        }
        var hits = new Hit[rays.Length]; // filled again by every frame
        var parts = Environment.ProcessorCount;
        using (var scene = Street()) {
            for (var frame = 0; frame < frames; ++frame) {
                for (var i = 0; i < rays.Length; ++i) rays[i].Origin = (0, 1.8f, 0.5f * frame); // the vehicle drives on
                var watch = Stopwatch.StartNew();
                Parallel.For(0, parts, part => {
                    int from = (int)((long)part * rays.Length / parts), to = (int)((part + 1L) * rays.Length / parts);
                    scene.RaycastBatch(rays.AsSpan(from, to - from), hits.AsSpan(from, to - from));
                });
                var milliseconds = watch.ElapsedMilliseconds;
                var seen = Enumerable.Range(0, rays.Length).Where(i => hits[i].Model != 0).ToArray();
                Console.WriteLine($"frame {frame}: {rays.Length} rays in {milliseconds} ms, {seen.Length} points");
                Func<int, float> end = i => rays[i].Origin.Y + rays[i].Direction.Y * hits[i].T;
                if (seen.Length <= rays.Length / 2 || seen.Length == rays.Length) return 1;
                if (seen.Any(i => hits[i].T > Range || Math.Abs(end(i) - hits[i].Point.Y) > 1e-4)) return 1;
            }
        }
        return 0;
    }
}
