// A scene and questions to it, one by one and in a batch.
using System;
using System.Linq;
using Gamephys;

static class Program {
    static void Expect(bool condition, string what) {
        if (!condition) throw new Exception("not so: " + what);
    }

    static void Main() {
        using (var scene = new Scene()) {
            var ground = scene.Add(new Plane((0, 1, 0), 0));

            // A row of 100 pyramids that share one mesh, which they keep alive.
            var places = Enumerable.Range(0, 100).Select(i => Transform.At((5 * i, 0, 10))).ToArray();
            var pyramids = new uint[places.Length];
            var corners = new Vec3[] { (-1, 0, -1), (1, 0, -1), (1, 0, 1), (-1, 0, 1), (0, 2, 0) };
            var triangles = new uint[] { 0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4 };
            using (var mesh = new Mesh(corners, triangles)) {
                Expect(mesh.GetReport().OpenEdgeCount == 0, "the pyramid is closed");
                scene.AddBatch(mesh, pyramids, places);
            }
            var hit = scene.Raycast(new Ray((25, 1, 0), (0, 0, 1), float.PositiveInfinity)).Value;
            Console.WriteLine($"ray: a pyramid, triangle {hit.Triangle}, {hit.T:F3} m away");
            Expect(hit.Model == pyramids[5] && Math.Abs(hit.T - 9.5) < 1e-6, "the sixth pyramid is hit");
            Expect(scene.Raycast(new Ray((25, 1, 0), (0, 1, 0), float.PositiveInfinity)) == null, "nothing is above");
            Expect(scene.Overlap(new Aabb((-1, 0.5f, 8), (21, 1, 12))).Length == 5, "five pyramids reach into the box");
            Expect(scene.Nearest((0, 10, -50)).Value.Model == ground, "the ground is nearest");

            // One call for 1000 rays that look down.
            var rays = Enumerable.Range(0, 1000).Select(i => new Ray((0.5f * i, 5, 10), (0, -1, 0), 10)).ToArray();
            var hits = new Hit[rays.Length];
            scene.RaycastBatch(rays, hits);
            var above = hits.Count(h => h.T < 5);
            Console.WriteLine($"{above} of 1000 rays end on a pyramid");
            Expect(above == 299, "299 rays end on a pyramid");
        }
    }
}
