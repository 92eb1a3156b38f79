// C#: overhead [milliseconds a case]
using System;
using System.Diagnostics;
using System.Globalization;
using Gamephys;

static class Overhead {
    const int Rays = 1000;

    static void Measure(string name, int items, double budget, Action call) {
        var begin = Stopwatch.StartNew();
        double best = double.PositiveInfinity;
        for (long calls = 1; begin.Elapsed.TotalSeconds < budget || double.IsInfinity(best);) {
            var watch = Stopwatch.StartNew();
            for (long i = 0; i < calls; ++i) call();
            var elapsed = watch.Elapsed.TotalSeconds;
            if (elapsed < 1e-3) {
                calls *= 2;
            } else {
                best = Math.Min(best, elapsed / calls);
            }
        }
        Console.WriteLine(string.Format(CultureInfo.InvariantCulture, "csharp,{0},{1:F2}", name, 1e9 * best / items));
    }

    static int Main(string[] arguments) {
        var budget = 1e-3 * (arguments.Length > 0 ? int.Parse(arguments[0]) : 200);
        using (var scene = new Scene())
        using (var camera = new Camera()) {
            var model = scene.Add(new Sphere((0, 0, 5), 1));
            var ray = new Ray((0, 0, 0), (0, 0, 1), 100);
            var rays = new Ray[Rays];
            for (var i = 0; i < Rays; ++i) rays[i] = ray;
            var hits = new Hit[Rays];
            scene.RaycastBatch(rays, hits);
            if (scene.Raycast(ray).Value.T != 4 || hits[Rays - 1].T != 4) return 1;
            Measure("scalar", 1, budget, () => scene.Has(model));
            Measure("vec3", 1, budget, () => camera.GetOrigin());
            Measure("raycast", 1, budget, () => scene.Raycast(ray));
            Measure("raycast_batch", Rays, budget, () => scene.RaycastBatch(rays, hits));
        }
        return 0;
    }
}
