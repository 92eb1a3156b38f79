// What a camera sees: culling, picking, marquee, orbit.
using System;
using System.Linq;
using Gamephys;

static class Program {
    static void Expect(bool condition, string what) {
        if (!condition) throw new Exception("not so: " + what);
    }

    static void Main() {
        var desc = CameraDesc.Default;
        desc.ViewportWidth = 640;
        desc.ViewportHeight = 320;
        using (var scene = new Scene())
        using (var camera = new Camera(desc)) {
            var places = new Vec3[] { (-4, 0, 9), (0, 0, 9), (4, 0, 9), (0, 0, -50) };
            var balls = new uint[places.Length];
            scene.AddBatch(places.Select(place => new Sphere(place, 1.5f)).ToArray(), balls);
            camera.SetPerspective(0.7f, 0.1f, 100);
            var orbit = Orbit.Default;
            orbit.Target = (0, 0, 9);
            orbit.Distance = 8;
            orbit.RadiansPerUnit = 0.01f;
            camera.SetOrbit(orbit);
            Expect(camera.Cull(scene).Length == 3, "three balls are seen");
            var pixel = camera.Project(places[0]).Value;
            Expect(camera.Pick(scene, pixel.X, pixel.Y).Value.Model == balls[0], "the left ball is picked");
            Expect(camera.PickRectangle(scene, 340, 0, 640, 320).Length == 2, "two balls reach into the right half");
            camera.OrbitRotate(157.0796f, 0);
            camera.OrbitUpdate();
            var behind = scene.RaycastAll(camera.PickRay(320, 160).Value);
            Console.WriteLine($"after a quarter turn {behind.Length} balls stand behind one another");
            Expect(behind.Length == 3 && behind[1].Model == balls[1], "the middle ball stands between the others");
        }
    }
}
