// The scene: batches against single calls, lists, changes, errors, ownership, memory, threads.
using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using System.Threading.Tasks;
using Gamephys;
using NUnit.Framework;
using static Common;

[TestFixture]
public class SceneTests {
    [Test]
    public void AnArrayWithoutElementsIsNotOneThatIsLeftOut() {
        var scene = new Scene();
        var spheres = new Sphere[] { new Sphere((0, 0, 5), 1), new Sphere((0, 0, 9), 1) };
        var rays = new Ray[] { new Ray((0, 0, 0), (0, 0, 1), 100), new Ray((0, 0, 0), (0, 0, 1), 100) };
        Assert.Throws<ArgumentException>(() => scene.AddBatch(spheres, new uint[2], new Transform[0]));
        Assert.Throws<ArgumentException>(() => scene.AddDescribedBatch(spheres, new uint[2], null, new ModelDesc[0]));
        Assert.Throws<ArgumentException>(() => scene.RaycastFilteredBatch(rays, new Hit[2], new QueryFilterDesc[0]));
        Assert.IsEmpty(scene.GetModels());
        scene.AddBatch(spheres, new uint[2], null);
        scene.AddBatch(new Sphere[0], new uint[0], new Transform[0]);
        scene.RaycastFilteredBatch(rays, new Hit[2]);
        Assert.AreEqual(2, scene.GetModels().Length);
    }

    [Test]
    public void BatchesAnswerAsSingleCallsDo() {
        uint[] models;
        var scene = SceneOfBalls(out models);
        var rays = SomeRays();
        Hit[] hits = new Hit[rays.Length], crossed = new Hit[rays.Length], swept = new Hit[rays.Length];
        var any = new int[rays.Length];
        var nearest = new Nearest[rays.Length];
        var segments = rays.Select(ray => new Segment(ray.Origin, (0, 0, 5))).ToArray();
        var points = rays.Select(ray => ray.Direction).ToArray();
        var moving = points.Select(point => new Sphere(point, 0.1f)).ToArray();
        Vec3 way = (0, 0, 9);
        scene.RaycastBatch(rays, hits);
        scene.RaycastAnyBatch(rays, any);
        var distances = new Distance[rays.Length];
        scene.RaycastDistanceBatch(rays, distances);
        scene.SegmentTestBatch(segments, crossed);
        scene.NearestBatch(points, nearest);
        scene.SweepSphereBatch(moving, new[] { way }, swept); // one displacement for all
        var all = scene.RaycastAllBatch(rays);
        var near = scene.OverlapBatch(moving);
        var nothing = new Hit { T = Far, Triangle = Constants.NoTriangle };
        for (var i = 0; i < rays.Length; ++i) {
            Assert.AreEqual(scene.Raycast(rays[i]) ?? nothing, hits[i]);
            Assert.AreEqual(scene.RaycastAny(rays[i]), any[i] != 0);
            Assert.AreEqual((hits[i].T, hits[i].Model), (distances[i].T, distances[i].Model));
            CollectionAssert.AreEqual(scene.RaycastAll(rays[i]), all[i]);
            Assert.AreEqual(scene.SegmentTest(segments[i]) ?? nothing, crossed[i]);
            Assert.AreEqual(scene.Nearest(points[i]), nearest[i]);
            Assert.AreEqual(scene.SweepSphere(moving[i], way) ?? nothing, swept[i]);
            CollectionAssert.AreEqual(scene.Overlap(moving[i]), near[i]);
        }
        Assert.That(hits.Count(hit => hit.Model != 0), Is.InRange(1, rays.Length - 1));
    }

    [Test]
    public void ModelsWithDescsOfTheirOwn() {
        var scene = new Scene();
        var balls = Enumerable.Repeat(new Sphere((0, 0, 0), 1), 3).ToArray();
        var root = scene.Add(balls[0]);
        var models = new uint[3];
        Action<(uint, uint, uint)[]> are = wanted => CollectionAssert.AreEqual(
            wanted, models.Select(model => scene.GetInfo(model)).Select(info => (info.Parent, info.Layers, info.Tag)));
        ModelDesc plain = ModelDesc.Default, first = plain, second = plain;
        first.Parent = root;
        first.Layers = 2;
        first.Tag = 5;
        second.Tag = 6;
        var some = new[] { first, second, plain };
        var known = new[] { (root, 2u, 5u), (0u, 1u, 6u), (0u, 1u, 0u) };
        scene.AddDescribedBatch(balls, models, descs: some);
        are(known);
        scene.AddDescribedBatch((Shape)balls[0], models, descs: some);
        are(known);
        scene.AddDescribedBatch(balls, models, descs: new[] { first }); // one for all
        are(new[] { known[0], known[0], known[0] });
        scene.AddDescribedBatch(balls, models, new[] { Transform.Identity });
        are(new[] { known[2], known[2], known[2] });
        var count = scene.GetModels().Length;
        Assert.Throws<ArgumentException>(() => scene.AddDescribedBatch(balls, models, descs: new[] { first, second }));
        Refused(Status.ErrorStructSize, () => scene.AddDescribedBatch(balls, models, descs: new ModelDesc[3]));
        some[2].Parent = 12345;
        Refused(Status.ErrorInvalidId, () => scene.AddDescribedBatch(balls, models, descs: some));
        Assert.AreEqual(count, scene.GetModels().Length);
    }

    [Test]
    public void FiltersLeaveOutModels() {
        var scene = new Scene();
        var ball = new Sphere((0, 0, 0), 1);
        var body = scene.Add(ball);
        var onBody = ModelDesc.Default;
        onBody.Parent = body;
        scene.Add(ball, Transform.At((0, 0, 3)), onBody);
        var target = scene.Add(ball, Transform.At((0, 0, 10)));
        var filter = QueryFilterDesc.Default;
        filter.IgnoredModel = body;
        filter.Flags = Constants.FilterSubtree;
        Ray ray = new Ray((0, 0, 0), (0, 0, 1), Far);
        Segment segment = new Segment((0, 0, 0), (0, 0, 20));
        Sphere moving = new Sphere((0, 0, 0), 0.5f), large = new Sphere((0, 0, 0), 50);
        Vec3 origin = (0, 0, 0), way = (0, 0, 20);
        Assert.AreEqual(body, scene.RaycastFiltered(ray).Value.Model);
        Assert.AreEqual(target, scene.RaycastFiltered(ray, filter).Value.Model);
        Assert.AreEqual(target, scene.SegmentTestFiltered(segment, filter).Value.Model);
        Assert.AreEqual(target, scene.NearestFiltered(origin, Far, filter).Value.Model);
        Assert.AreEqual(target, scene.SweepSphereFiltered(moving, way, filter).Value.Model);
        Assert.IsTrue(scene.RaycastAnyFiltered(ray, filter));
        Assert.AreEqual(1, scene.RaycastAllFiltered(ray, filter).Length);
        CollectionAssert.AreEqual(new[] { target }, scene.OverlapFiltered(large, filter));
        var hits = new Hit[2];
        var any = new int[2];
        var nearest = new Nearest[2];
        scene.RaycastFilteredBatch(new[] { ray, ray }, hits, new[] { filter });
        Assert.AreEqual(target, hits[1].Model);
        var distances = new Distance[2];
        scene.RaycastDistanceFilteredBatch(new[] { ray, ray }, distances, new[] { filter });
        Assert.AreEqual(target, distances[1].Model);
        scene.SegmentTestFilteredBatch(new[] { segment, segment }, hits, new[] { filter });
        Assert.AreEqual(target, hits[1].Model);
        scene.SweepSphereFilteredBatch(new[] { moving, moving }, new[] { way }, hits, new[] { filter });
        Assert.AreEqual(target, hits[1].Model);
        scene.NearestFilteredBatch(new[] { way, way }, nearest, Far, new[] { filter });
        Assert.AreEqual(target, nearest[1].Model);
        scene.RaycastAnyFilteredBatch(new[] { ray, ray }, any, new[] { filter });
        CollectionAssert.AreEqual(new[] { 1, 1 }, any);
        CollectionAssert.AreEqual(new[] { 0, 1, 2 }, scene.RaycastAllFilteredBatch(new[] { ray, ray }, new[] { filter }).Offsets);
        CollectionAssert.AreEqual(new[] { target }, scene.OverlapFilteredBatch(new[] { large, large }, new[] { filter })[1]);
        var camera = new Camera();
        camera.LookAt((0, 0, -10), origin, Up);
        Assert.AreEqual(target, camera.PickFiltered(scene, 400, 300, filter).Value.Model);
        camera.PickFilteredBatch(scene, new[] { new Vec2(400, 300), new Vec2(1, 1) }, hits, new[] { filter });
        Assert.AreEqual((target, 0u), (hits[0].Model, hits[1].Model));
        CollectionAssert.AreEqual(new[] { target }, camera.PickRectangleFiltered(scene, 0, 0, 800, 600, filter));
        CollectionAssert.AreEqual(new[] { target }, camera.CullFiltered(scene, filter));
        CollectionAssert.AreEqual(new[] { target }, scene.CullFiltered(camera.GetFrustum(), filter));
        var views = new[] { camera.GetFrustum(), camera.GetFrustum() };
        CollectionAssert.AreEqual(new[] { 0, 3, 6 }, scene.CullBatch(views).Offsets);
        CollectionAssert.AreEqual(new[] { target }, scene.CullFilteredBatch(views, new[] { filter })[1]);
    }

    [Test]
    public void FiltersHaveListsOfModelsAndBatchesAFilterForEach() {
        var scene = new Scene();
        var models = new uint[4];
        for (var i = 0; i < 4; ++i) models[i] = scene.Add(new Sphere(new Vec3(0, 0, 4 * i), 1));
        var ray = new Ray(new Vec3(0, 0, -5), new Vec3(0, 0, 1), float.PositiveInfinity);
        QueryFilterDesc two = QueryFilterDesc.Default, one = two, none = two;
        two.IgnoredModels = new[] { models[1], models[0] };
        one.IgnoredModels = new[] { models[0] };
        none.IgnoredModels = new uint[0];
        Assert.AreEqual(models[2], scene.RaycastFiltered(ray, two).Value.Model);
        Assert.AreEqual(models[0], scene.RaycastFiltered(ray, none).Value.Model);
        CollectionAssert.AreEqual(new[] { models[2], models[3] }, scene.OverlapFiltered(new Sphere(new Vec3(0, 0, 0), 50), two));
        var hits = new Hit[3];
        scene.RaycastFilteredBatch(new[] { ray, ray, ray }, hits, new[] { none, one, two });
        CollectionAssert.AreEqual(new[] { models[0], models[1], models[2] }, Array.ConvertAll(hits, hit => hit.Model));
        scene.RaycastFilteredBatch(new[] { ray, ray, ray }, hits, new[] { two });
        CollectionAssert.AreEqual(new[] { models[2], models[2], models[2] }, Array.ConvertAll(hits, hit => hit.Model));
        scene.RaycastFilteredBatch(new[] { ray, ray, ray }, hits);
        Assert.AreEqual(models[0], hits[2].Model);
        var balls = new[] { new Sphere(new Vec3(0, 0, 2), 2), new Sphere(new Vec3(0, 0, 2), 2) };
        CollectionAssert.AreEqual(new[] { 0, 1, 1 }, scene.OverlapFilteredBatch(balls, new[] { one, two }).Offsets);
        Assert.Throws<ArgumentException>(() => scene.RaycastFilteredBatch(new[] { ray, ray, ray }, hits, new[] { one, two }));
    }

    [Test]
    public void SolidsMoveUpToWhatTheyTouchAndOutOfWhatTheyOverlap() {
        var ball = new Sphere((0, 0, 0), 1);
        Assert.AreEqual(0.5, Geometry.Sweep(ball, new Sphere((0, 4, 0), 1), (0, -4, 0)).Value.T);
        Assert.AreEqual(0.5, Geometry.Penetration(ball, new Sphere((0, 0, 1.5f), 1)).Value.Depth);
        var scene = new Scene();
        scene.Add(ball);
        var target = scene.Add(ball, Transform.At((0, 0, 10)));
        var filter = QueryFilterDesc.Default;
        filter.IgnoredModel = target;
        Sphere moving = new Sphere((0, 0, 5), 1), deep = new Sphere((0, 0, 8.5f), 1);
        Vec3 way = (0, 0, 6);
        Assert.AreEqual(target, scene.Sweep(moving, way).Value.Model);
        Assert.IsNull(scene.SweepFiltered(moving, way, filter));
        var hits = new Hit[2];
        scene.SweepBatch(new[] { moving, moving }, new[] { way }, hits);
        Assert.AreEqual((target, 0.5f), (hits[1].Model, hits[1].T));
        scene.SweepFilteredBatch(new[] { moving, moving }, new[] { way }, hits, new[] { filter });
        Assert.AreEqual(0u, hits[1].Model);
        Assert.AreEqual(0.5f, scene.Penetration(deep)[0].Depth);
        Assert.IsEmpty(scene.PenetrationFiltered(deep, filter));
        var crowd = new[] { deep, moving };
        var waysOut = scene.PenetrationBatch(crowd);
        CollectionAssert.AreEqual(new[] { 0, 1, 1 }, waysOut.Offsets);
        Assert.AreEqual(target, waysOut[0][0].Model);
        CollectionAssert.AreEqual(new[] { 0, 0, 0 }, scene.PenetrationFilteredBatch(crowd, new[] { filter }).Offsets);
        Sphere above = new Sphere((0, 4, 0), 1), inside = new Sphere((0, 0, 1.5f), 1);
        Geometry.SweepBatch((Shape)ball, new[] { above, inside }, new Vec3[] { (0, -4, 0) }, hits);
        Assert.AreEqual((0.5f, 0f), (hits[0].T, hits[1].T));
        var outs = new Penetration[2];
        Geometry.PenetrationBatch((Shape)ball, new[] { inside, above }, outs);
        Assert.AreEqual((0.5f, float.NegativeInfinity), (outs[0].Depth, outs[1].Depth));
    }

    [Test]
    public void ShapesChangeAndTreesAndCamerasAreRead() {
        var scene = new Scene();
        var body = scene.Add(new Sphere((0, 0, 0), 1));
        var onBody = ModelDesc.Default;
        onBody.Parent = body;
        var head = scene.Add(new Sphere((0, 0, 0), 1), null, onBody);
        scene.SetShape(body, new Sphere((0, 0, 0), 5));
        Assert.AreEqual(5, scene.GetBounds(body).Value.Max.X);
        scene.SetScale(body, (2, 2, 2));
        Assert.AreEqual(10, scene.GetBounds(body).Value.Max.X);
        Assert.AreEqual(2, scene.GetScale(body).Y);
        CollectionAssert.AreEqual(new[] { body }, scene.GetRoots());
        CollectionAssert.AreEqual(new[] { head }, scene.GetChildren(body));
        var camera = new Camera();
        camera.SetOrthographic(10, 1, 100);
        camera.SetViewport(200, 100);
        Assert.AreEqual((Projection.Orthographic, 10f, 1f, 100f), camera.GetProjection());
        Assert.AreEqual((200f, 100f), camera.GetViewport());
    }

    [Test]
    public void CamerasSeeByAspectInAWindowFromTheNearPlaneOn() {
        var camera = new Camera();
        camera.SetPerspectiveAspect(1, 2, 1, 100);
        Assert.AreEqual((2f, true), camera.GetAspect());
        Assert.AreEqual((Handedness.LeftHanded, DepthRange.ZeroToOne, false), camera.GetConventions());
        camera.SetOrthographicSize(8, 6, 1, 100);
        Assert.AreEqual((8f, 6f), camera.GetImageSize());
        camera.SetViewportOrigin(800, 0);
        Assert.AreEqual((800f, 0f), camera.GetViewportOrigin());
        camera.SetPerspective(1, 1, 100);
        Assert.AreEqual(1, camera.PickRay(1200, 300).Value.Origin.Z);
        camera.SetPickStart(PickStart.Centre);
        Assert.AreEqual(PickStart.Centre, camera.GetPickStart());
        Assert.AreEqual(0, camera.PickRay(1200, 300).Value.Origin.Z);
        camera.LookAt((1, 2, 3), (0, 0, 0), Up);
        var view = camera.GetViewMatrix();
        camera.SetViewMatrix(view);
        Assert.Less(Geometry.Mat4Orthonormality(view), 1e-6f);
        Assert.AreEqual(3, camera.GetTransform().Position.Z, 1e-5);
        CollectionAssert.AreEqual(camera.GetCorners(), camera.GetRectangleCorners(800, 0, 1600, 600));
        Assert.AreEqual(3, camera.GetRectangleFrustum(800, 0, 1200, 600).Origin.Z, 1e-5);
        camera.SetOrbit(Orbit.Default);
        camera.SetOrbitSpeeds(new OrbitSpeeds { RotateX = 0.5f, RotateY = 1, Zoom = 2, PanX = 3, PanY = 4 });
        Assert.AreEqual(4, camera.GetOrbitSpeeds().PanY);
        Plane x1 = new Plane((1, 0, 0), 1), y2 = new Plane((0, 1, 0), 2), z3 = new Plane((0, 0, 1), 3);
        Assert.AreEqual((Vec3)(1, 2, 3), Geometry.PlanesIntersection(x1, y2, z3).Value);
        Assert.IsNull(Geometry.PlanesIntersection(x1, y2, y2));
        var points = new Vec3[2];
        Geometry.PlanesIntersectionBatch(new[] { x1 }, new[] { y2 }, new[] { z3, y2 }, points);
        Assert.AreEqual((3f, Far), (points[0].Z, points[1].Z));
    }

    [Test]
    public void AMeshDeformsAndItsModelsWithIt() {
        var desc = MeshDesc.Default;
        desc.Deformable = 1;
        var mesh = new Mesh(new Vec3[] { (0, 0, 0), (1, 0, 0), (0, 1, 0) }, new uint[] { 0, 1, 2 }, desc);
        var scene = new Scene();
        var model = scene.Add(mesh);
        mesh.SetVertices(new Vec3[] { (0, 0, 7), (1, 0, 7), (0, 1, 7) });
        Assert.AreEqual(7, scene.GetBounds(model).Value.Min.Z, 1e-3);
        Assert.AreEqual(1, mesh.GetInfo().Deformable);
        // The mesh of a restored scene, met from behind, or not.
        var copy = new Scene();
        copy.Restore(scene.GetSnapshot(true));
        var info = new Mesh(copy, model).GetInfo();
        Assert.AreEqual((MeshKind.Surface, 3u, 1u), (info.Kind, info.VertexCount, info.TriangleCount));
        var fromBehind = new Ray((0.2f, 0.2f, 0), (0, 0, 1), Far);
        var filter = QueryFilterDesc.Default;
        filter.Flags = Constants.FilterNoFrontFaces;
        Assert.AreEqual(Constants.HitBack, copy.RaycastFiltered(fromBehind, filter).Value.Flags);
        filter.Flags = Constants.FilterNoBackFaces;
        Assert.IsNull(copy.RaycastFiltered(fromBehind, filter));
    }

    [Test]
    public void AHullIsASolidMesh() {
        var hull = new Mesh(new Vec3[] { (0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1), (0.1f, 0.1f, 0.1f) });
        Assert.AreEqual(4, hull.GetVertices().Length);
        Assert.AreEqual(4, hull.GetHullPlanes().Length);
        Assert.AreEqual(new uint[] { 0, 1, 2, 3 }, hull.GetHullFaces());
    }

    [Test]
    public void ARopeIsPickedAsAModelThatFollowsIt() {
        var solver = new Solver();
        var rope = solver.AddRope(new Vec3[] { (0, 0, 0), (1, 0, 0), (2, 0, 0) }, 0);
        var scene = new Scene();
        var model = scene.Add(new Mesh(solver, rope));
        solver.SetPositions(rope, 0, new Vec3[] { (0, 0, 7), (1, 0, 7), (2, 0, 7) });
        var hit = scene.Raycast(new Ray((1.8f, 0, 0), (0, 0, 1), float.PositiveInfinity)).Value;
        Assert.AreEqual((model, 1u), (hit.Model, hit.Triangle));
        Assert.AreEqual(2u, solver.GetNearestParticle(rope, hit.Triangle, hit.Point));
    }

    [Test]
    public void SpansArePartsOfArrays() {
        uint[] models;
        var scene = SceneOfBalls(out models);
        var rays = SomeRays();
        Hit[] hits = new Hit[rays.Length], part = new Hit[rays.Length];
        scene.RaycastBatch(rays, hits);
        scene.RaycastBatch(rays.AsSpan(10, 20), part.AsSpan(10, 20));
        CollectionAssert.AreEqual(hits.Skip(10).Take(20), part.Skip(10).Take(20));
        Assert.IsTrue(part.Take(10).Concat(part.Skip(30)).All(hit => hit.Equals(default(Hit))));
    }

    [Test]
    public void LengthsMustAgree() {
        uint[] models;
        var scene = SceneOfBalls(out models);
        Assert.Throws<ArgumentException>(() => scene.RaycastBatch(SomeRays(), new Hit[3]));
        Assert.Throws<ArgumentException>(() => scene.SweepSphereBatch(new Sphere[2], new Vec3[3], new Hit[2]));
        Assert.Throws<ArgumentException>(() => scene.SetTransforms(models.AsSpan(0, 1), new Transform[3]));
        Assert.Throws<ArgumentException>(() => scene.GetTransforms(models, new Transform[2]));
        Assert.Throws<ArgumentException>(() => scene.AddBatch(new Sphere[3], new uint[3], new Transform[2]));
        Assert.Throws<ArgumentException>(() => scene.SetOrigin(new double[2]));
        scene.RaycastBatch(new Ray[0], new Hit[0]);
        scene.RaycastBatch(SomeRays().AsSpan(0, 1), new Hit[1]);
    }

    [Test]
    public void ListsHaveAnyLength() {
        var scene = new Scene();
        var models = new uint[500];
        scene.AddBatch((Shape)new Sphere((0, 0, 0), 1), models, Enumerable.Repeat(Transform.Identity, 500).ToArray());
        CollectionAssert.AreEqual(models, scene.GetModels());
        var boxes = new[] { new Aabb((-1, -1, -1), (1, 1, 1)), new Aabb((5, 5, 5), (6, 6, 6)), new Aabb((0, 0, 0), (1, 1, 1)) };
        var lists = scene.OverlapBatch(boxes);
        CollectionAssert.AreEqual(new[] { 0, 500, 500, 1000 }, lists.Offsets);
        CollectionAssert.AreEqual(models, lists[2]);
        Assert.AreEqual(500, scene.RaycastAll(new Ray((0, 0, -5), (0, 0, 1), Far)).Length);
        Assert.AreEqual(0, new Scene().GetModels().Length);
    }

    [Test]
    public void ModelsAreMovedDescribedAndRemoved() {
        var settings = SceneDesc.Default;
        settings.WorkerCount = 2;
        var scene = new Scene(settings);
        var capsule = new Capsule((0, 0, 0), Up, 0.25f);
        var parent = scene.Add(capsule);
        var desc = ModelDesc.Default;
        desc.Parent = parent;
        desc.Layers = 2;
        desc.Tag = 7;
        var child = scene.Add(new Aabb((0, 0, 0), (1, 1, 1)), Transform.At((2, 0, 0)), desc);
        Assert.AreEqual(new ModelInfo { Type = ShapeType.Aabb, Parent = parent, Layers = 2, Tag = 7 }, scene.GetInfo(child));
        Assert.AreEqual(capsule, scene.GetShape(parent).Capsule);
        scene.SetTransform(parent, Transform.At((0, 5, 0)));
        var both = new[] { parent, child };
        var places = new Transform[2];
        scene.GetTransforms(both, places);
        Assert.AreEqual((5f, 0f), (places[0].Position.Y, places[1].Position.Y));
        scene.GetWorldTransforms(both, places);
        Assert.AreEqual((Vec3)(2, 5, 0), places[1].Position);
        Assert.AreEqual((Vec3)(2, 5, 0), scene.GetBounds(child).Value.Min);
        Assert.AreEqual((Vec3)(3, 6.25f, 1), scene.GetSceneBounds().Value.Max);
        scene.SetParent(child, 0, true);
        Refused(Status.ErrorCycle, () => scene.SetParent(child, child, false));
        scene.SetTransforms(both, new[] { Transform.Identity });
        scene.SetLayers(child, 4);
        scene.SetTag(child, 8);
        var down = new Ray((0.5f, 9, 0.5f), (0, -1, 0), Far);
        Assert.AreEqual(8, scene.Raycast(down, 4).Value.Tag);
        Assert.IsNull(scene.Raycast(down, 2));
        CollectionAssert.AreEqual(both, scene.Cull(new Camera().GetFrustum()));
        scene.SetOrigin(new[] { 1e9 + 0.5, 0, 0 });
        CollectionAssert.AreEqual(new[] { 1e9 + 0.5, 0, 0 }, scene.GetOrigin());
        Assert.AreEqual(2, scene.GetOctreeStats().ItemCount);
        Assert.Greater(scene.GetOctreeBoxes().Length, 0);
        scene.Validate();
        var mesh = scene.Add(Tetrahedron());
        Refused(Status.ErrorUnsupported, () => scene.GetShape(mesh));
        scene.Remove(child);
        Assert.IsTrue(!scene.Has(child) && scene.Has(parent));
        scene.RemoveSubtree(parent);
        scene.RemoveBatch(new[] { mesh });
        scene.Add(capsule);
        scene.RebuildOctree();
        Assert.IsTrue(scene.MaintainOctree(1000));
        scene.SetWorkerCount(2);
        Assert.AreEqual(2, scene.GetWorkerCount());
        scene.Clear();
        Assert.AreEqual(0, scene.GetModels().Length);
    }

    [Test]
    public void ErrorsCarryTheMessageOfTheLibrary() {
        var scene = new Scene();
        var error = Assert.Throws<GamephysException>(() => scene.Add(new Sphere((0, 0, 0), -1)));
        Assert.AreEqual(Status.ErrorInvalidArgument, error.Status);
        StringAssert.Contains("radius", error.Message);
        Refused(Status.ErrorInvalidId, () => scene.Remove(12345));
        Refused(Status.ErrorInvalidArgument, () => scene.Add(default(Shape)));
        Refused(Status.ErrorStructSize, () => scene.Add(new Sphere(), desc: new ModelDesc()));
        Assert.Throws<ArgumentNullException>(() => scene.Add((Mesh)null));
        Assert.AreEqual("GPHYS_ERROR_CYCLE", Library.NameOf(Status.ErrorCycle));
        Assert.AreEqual(Constants.VersionMajor, Library.Version.Major);
    }

    [Test]
    public void UseAfterDisposeThrows() {
        var scene = new Scene();
        var mesh = Tetrahedron();
        var camera = new Camera();
        foreach (var given in new IDisposable[] { scene, scene, mesh, camera }) given.Dispose();
        var open = new Scene();
        foreach (var use in new TestDelegate[] {
            () => scene.GetModels(), () => scene.Clear(), () => scene.Has(1), () => open.Add(mesh), () => open.AddBatch(mesh, new uint[1]),
            () => mesh.GetReport(), () => camera.Pick(open, 1, 1), () => new Camera().Pick(scene, 1, 1), () => new Solver().Step(0.01f, scene),
            () => Geometry.Bounds(mesh) }) {
            Assert.Throws<ObjectDisposedException>(use);
        }
        new Solver().Step(0.01f);
    }

    // A scene with two workers has a thread of its own, which shows whether the scene is there.
    [Test]
    public void ObjectsAreFreedWhenNothingRefersToThem() {
        if (!Directory.Exists("/proc/self/task")) Assert.Ignore("threads are not listed here");
        Func<int> threads = () => Directory.GetDirectories("/proc/self/task").Length;
        var held = 0;
        var maker = new Thread(() => { // with a stack of its own, which the collector does not search afterwards
            var desc = SceneDesc.Default;
            desc.WorkerCount = 2;
            var scenes = Enumerable.Range(0, 100).Select(_ => new Scene(desc)).ToArray();
            held = threads();
            GC.KeepAlive(scenes);
        });
        maker.Start();
        maker.Join();
        for (var wait = 0; threads() > held - 90; ++wait) {
            Assert.Less(wait, 1000, $"{held} threads were, {threads()} are");
            GC.Collect();
            GC.WaitForPendingFinalizers();
            Thread.Sleep(1);
        }
    }

    [Test]
    public void AMeshLivesAsLongAsItsModels() {
        var scene = new Scene();
        using (var mesh = Tetrahedron()) scene.Add(mesh);
        Assert.AreEqual(1, scene.Raycast(new Ray((0.2f, 0.2f, -1), (0, 0, 1), Far)).Value.T);
    }

    [Test]
    public void ThreadsMayAskAtOnce() {
        uint[] models;
        var scene = SceneOfBalls(out models);
        var rays = SomeRays();
        Func<Hit[]> ask = () => {
            var hits = new Hit[rays.Length];
            for (var i = 0; i < 20; ++i) scene.RaycastBatch(rays, hits);
            return hits;
        };
        var expected = ask();
        foreach (var task in Enumerable.Range(0, 4).Select(_ => Task.Run(ask)).ToArray()) CollectionAssert.AreEqual(expected, task.Result);
    }

    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    private delegate IntPtr Allocate(IntPtr user, UIntPtr size, UIntPtr alignment);
    [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
    private delegate void Release(IntPtr user, IntPtr memory, UIntPtr size, UIntPtr alignment);

    // Memory that runs out: as many bytes as are left, and what is held of it.
    private sealed class Ration : IDisposable {
        public long Left, Held;
        public readonly IntPtr Allocator = Marshal.AllocHGlobal(Marshal.SizeOf<Allocator>());
        private readonly Dictionary<IntPtr, IntPtr> starts = new Dictionary<IntPtr, IntPtr>(); // of aligned memory
        private readonly Allocate allocate;
        private readonly Release release;

        public Ration() {
            allocate = (user, size, alignment) => {
                if ((Left -= (long)size) < 0) return IntPtr.Zero;
                Held += (long)size;
                var start = Marshal.AllocHGlobal((int)size + (int)alignment);
                var aligned = (IntPtr)(((long)start + (long)alignment - 1) / (long)alignment * (long)alignment);
                starts[aligned] = start;
                return aligned;
            };
            release = (user, memory, size, alignment) => {
                Held -= (long)size;
                Marshal.FreeHGlobal(starts[memory]);
                starts.Remove(memory);
            };
            var functions = new Allocator {
                Allocate = Marshal.GetFunctionPointerForDelegate(allocate), Release = Marshal.GetFunctionPointerForDelegate(release)
            };
            Marshal.StructureToPtr(functions, Allocator, false);
        }

        public void Dispose() { Marshal.FreeHGlobal(Allocator); }
    }

    [Test]
    public void RunningOutOfMemoryIsAnExceptionAndLeaksNothing() {
        using (var ration = new Ration()) {
            var desc = SceneDesc.Default;
            desc.Allocator = ration.Allocator;
            var failed = 0;
            for (var bytes = 0; bytes < 400000; bytes += 4000) {
                ration.Left = bytes;
                try {
                    using (var scene = new Scene(desc)) {
                        try {
                            for (var i = 0; i < 50; ++i) scene.Add(new Sphere());
                        } finally {
                            ration.Left = 1 << 30;
                            scene.Validate();
                        }
                    }
                } catch (OutOfMemoryException) {
                    ++failed;
                }
                Assert.AreEqual(0, ration.Held);
            }
            Assert.That(failed, Is.InRange(1, 99));
        }
    }

    [Test]
    public void EveryKindOfObjectGivesItsMemoryBack() {
        using (var ration = new Ration { Left = 1 << 30 }) {
            var mesh = MeshDesc.Default;
            var scene = SceneDesc.Default;
            var camera = CameraDesc.Default;
            var solver = SolverDesc.Default;
            mesh.Allocator = scene.Allocator = camera.Allocator = solver.Allocator = ration.Allocator;
            var objects = new IDisposable[] { new Mesh(new Vec3[3], new uint[] { 0, 1, 2 }, mesh), new Scene(scene), new Camera(camera), new Solver(solver) };
            foreach (var made in objects) {
                var held = ration.Held;
                made.Dispose();
                Assert.Less(ration.Held, held, made.GetType().Name);
            }
            Assert.AreEqual(0, ration.Held);
        }
    }
}
