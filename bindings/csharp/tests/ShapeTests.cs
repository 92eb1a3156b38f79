// Shapes and meshes on their own.
using System;
using System.Linq;
using System.Runtime.InteropServices;
using Gamephys;
using NUnit.Framework;
using static Common;

[TestFixture]
public class ShapeTests {
    [Test]
    public void FieldsStandWhereCHasThem() {
        Assert.Greater(Layout.Structs.Length, 25);
        foreach (var s in Layout.Structs) {
            Assert.AreEqual(s.Size, Marshal.SizeOf(s.Type), s.Type.Name);
            CollectionAssert.AreEqual(s.Offsets, s.Names.Select(name => (int)Marshal.OffsetOf(s.Type, name)), s.Type.Name);
        }
    }

    [Test]
    public void SingleShapesAnswer() {
        var ball = new Sphere((0, 0, 0), 1);
        Geometry.Validate(ball);
        Assert.AreEqual(new Aabb((-1, -1, -1), (1, 1, 1)), Geometry.Bounds(ball));
        Assert.IsNull(Geometry.Bounds(new Plane(Up, 0)));
        Assert.IsTrue(Geometry.Contains(ball, (0, 0.6f, 0.8f), 1e-6f));
        Assert.AreEqual(2, Geometry.ClosestPoint(ball, (0, 3, 0)).Value.Distance);
        Assert.IsTrue(Geometry.Overlaps(ball, new Aabb((0.5f, 0.5f, 0.5f), (1, 1, 1))));
        Assert.AreEqual((Side.Inside, 2f), Geometry.ClassifyPlane(ball, new Plane(Up, -3)));
        var ray = new Ray((0, 0, -3), (0, 0, 1), 10);
        Assert.AreEqual(2, Geometry.Raycast(ball, ray).Value.T);
        Assert.IsNull(Geometry.Raycast(new Sphere((5, 0, 0), 1), ray));
        Assert.AreEqual(0.5, Geometry.SegmentTest(ball, new Segment((0, 0, -3), (0, 0, 1))).Value.T);
        Assert.AreEqual(0.5, Geometry.SweepSphere(ball, new Sphere((0, 4, 0), 1), (0, -4, 0)).Value.T);
        var closest = Geometry.SegmentClosestPoints(new Segment((0, 0, 0), Up), new Segment((2, 0.5f, -1), (2, 0.5f, 1)));
        Assert.AreEqual(((Vec3)(0, 0.5f, 0), (Vec3)(2, 0.5f, 0), 2f), closest);
    }

    [Test]
    public void ABoxThatIsMovedMayTurn() {
        var moved = Geometry.Transform(new Aabb((0, 0, 0), (2, 2, 2)), Transform.At((1, 0, 0)));
        Assert.AreEqual((Vec3)(2, 1, 1), moved.Obb.Center);
        Assert.Throws<InvalidCastException>(() => moved.Sphere.ToString());
        Assert.AreEqual(new Sphere((0, 3, 0), 3), Geometry.Transform(new Sphere(Up, 1), new Transform((0, 0, 0), Quat.Identity, 3)).Sphere);
        Refused(Status.ErrorUnsupported, () => Geometry.Transform(Tetrahedron(), Transform.Identity));
    }

    [Test]
    public void FrustaComeFromMatrices() {
        var camera = new Camera();
        var frustum = Geometry.FrustumFromMatrix(camera.GetViewProjectionMatrix(), DepthRange.ZeroToOne, false);
        var known = camera.GetCorners();
        var corners = Geometry.FrustumCorners(frustum);
        for (var i = 0; i < 8; ++i) {
            Assert.AreEqual(known[i].X, corners[i].X, 1e-3 * known[i].Z);
            Assert.AreEqual(known[i].Z, corners[i].Z, 1e-3 * known[i].Z);
        }
        Assert.AreEqual(Side.Inside, Geometry.ClassifyFrustum(new Sphere((0, 0, 5), 1), frustum));
        Assert.Less(0, frustum[(int)Constants.FrustumNear].Normal.Z);
        Assert.Throws<IndexOutOfRangeException>(() => frustum[6].ToString());
        Refused(Status.ErrorSingular, () => Geometry.FrustumFromMatrix(new Mat4(), DepthRange.ZeroToOne, false));
    }

    [Test]
    public void OneShapeAgainstMany() {
        var ball = new Sphere((0, 0, 0), 1);
        var points = new Vec3[] { (0, 0, 0), (2, 0, 0) };
        var inside = new int[2];
        Geometry.ContainsBatch(ball, points, inside);
        CollectionAssert.AreEqual(new[] { 1, 0 }, inside);
        var nearest = new Nearest[2];
        Geometry.ClosestPointBatch(ball, points, nearest);
        Assert.AreEqual(1, nearest[1].Distance);
        var balls = Enumerable.Range(0, 4).Select(x => new Sphere((x, 0, 0), 1)).ToArray();
        var met = new int[4];
        Geometry.OverlapsBatch(balls, (Shape)new Plane((1, 0, 0), 0), met);
        CollectionAssert.AreEqual(new[] { 1, 1, 0, 0 }, met);
        var hits = new Hit[3];
        Geometry.RaycastBatch(ball, Enumerable.Range(0, 3).Select(x => new Ray((x, 0, -3), (0, 0, 1), 10)).ToArray(), hits);
        CollectionAssert.AreEqual(new[] { 2, 3, Far }, hits.Select(hit => hit.T));
    }

    [Test]
    public void AMeshIsAShape() {
        var mesh = Tetrahedron();
        Assert.AreEqual(0, mesh.GetReport().OpenEdgeCount);
        Assert.AreEqual((Vec3)(0, 0, 1), mesh.GetVertices()[3]);
        Assert.AreEqual(12, mesh.GetIndices().Length);
        var snapshot = mesh.GetSnapshot();
        CollectionAssert.AreEqual(mesh.GetIndices(), new Mesh(snapshot).GetIndices());
        Refused(Status.ErrorInvalidArgument, () => new Mesh(snapshot.Skip(1).ToArray()));
        var ray = new Ray((0.2f, 0.2f, -1), (0, 0, 1), 10);
        Assert.AreEqual(1, Geometry.Raycast(mesh, ray).Value.T);
        Assert.AreEqual(2, mesh.RaycastAll(ray).Length);
        Assert.IsTrue(mesh.RaycastAny(ray));
        var anyHit = new int[2];
        var distances = new Distance[2];
        mesh.RaycastAnyBatch(new[] { ray, ray }, anyHit);
        mesh.RaycastDistanceBatch(new[] { ray, ray }, distances);
        Assert.AreEqual(1, anyHit[1]);
        Assert.AreNotEqual(Constants.NoTriangle, distances[1].Triangle);
        CollectionAssert.AreEqual(new[] { 3 }, mesh.Overlap(new Sphere((1, 1, 1), 1.2f)));
        Assert.AreEqual(mesh.GetOctreeStats().NodeCount, mesh.GetOctreeBoxes().Length);
        var report = Geometry.MeshCheck(new Vec3[] { (0, 0, 0), (float.NaN, 0, 0) }, new uint[] { 0, 1, 7 });
        Assert.AreEqual((1, 1, 1), ((int)report.BadVertexCount, (int)report.FirstBadVertex, (int)report.OutOfRangeCount));
        Refused(Status.ErrorInvalidArgument, () => new Mesh(new Vec3[1], new uint[] { 0, 1, 7 }));
    }
}
