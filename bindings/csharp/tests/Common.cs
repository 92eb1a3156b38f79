// What several tests need.
using System;
using System.Linq;
using Gamephys;
using NUnit.Framework;

static class Common {
    public const float Far = float.PositiveInfinity;
    public static readonly Vec3 Up = (0, 1, 0);

    // 30 balls on a spiral.
    public static Scene SceneOfBalls(out uint[] models) {
        var scene = new Scene();
        var balls = Enumerable.Range(0, 30).Select(i => new Sphere(((float)(3 * Math.Sin(i)), (float)(3 * Math.Cos(2 * i)), i / 3f), 0.7f)).ToArray();
        models = new uint[balls.Length];
        scene.AddBatch(balls, models);
        return scene;
    }

    // 200 rays, some of which meet a ball.
    public static Ray[] SomeRays() {
        return Enumerable.Range(0, 200).Select(i => new Ray((0, 0, -5), ((float)Math.Sin(i) / 2, (float)Math.Cos(3 * i) / 2, 1), Far)).ToArray();
    }

    public static Mesh Tetrahedron() {
        var corners = new Vec3[] { (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1) };
        return new Mesh(corners, new uint[] { 0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3 }, MeshDesc.Default);
    }

    public static void Refused(Status status, TestDelegate call) {
        Assert.AreEqual(status, Assert.Throws<GamephysException>(call).Status);
    }
}
