// The camera and the solver.
using System.Linq;
using Gamephys;
using NUnit.Framework;
using static Common;

[TestFixture]
public class MotionTests {
    [Test]
    public void ACameraProjectsAndPicks() {
        uint[] models;
        var scene = SceneOfBalls(out models);
        var desc = CameraDesc.Default;
        desc.ViewportWidth = 640;
        desc.ViewportHeight = 480;
        var camera = new Camera(desc);
        camera.LookAt((0, 0, -9), (0, 0, 0), Up);
        var points = new Vec3[] { (0, 0, 0), (1, 1, 3), (0, 0, -20) };
        var pixels = new Vec3[3];
        camera.ProjectBatch(points, pixels);
        Assert.AreEqual(pixels[1], camera.Project(points[1]));
        Assert.IsNull(camera.Project(points[2]));
        Assert.AreEqual((320f, 240f), (pixels[0].X, pixels[0].Y));
        var back = new Vec3[2];
        camera.UnprojectBatch(pixels.Take(2).ToArray(), back);
        Assert.AreEqual(back[1], camera.Unproject(pixels[1]));
        Assert.AreEqual(3, back[1].Z, 1e-3);

        var rays = new Ray[16 * 12];
        camera.PickRays(312, 234, 16, 12, rays);
        Assert.AreEqual(rays[0], camera.PickRay(312.5f, 234.5f));
        Assert.Throws<System.ArgumentException>(() => camera.PickRays(312, 234, 16, 11, rays));
        var places = Enumerable.Range(0, 64).Select(i => new Vec2(10 * i, 7.5f * i)).ToArray();
        var hits = new Hit[64];
        camera.PickBatch(scene, places, hits);
        for (var i = 0; i < 64; ++i) Assert.AreEqual(camera.Pick(scene, places[i].X, places[i].Y)?.Model ?? 0, hits[i].Model);
        Assert.That(hits.Count(hit => hit.Model != 0), Is.InRange(1, 63));
        Assert.AreEqual(30, camera.Cull(scene).Length);
        Assert.Less(camera.PickRectangle(scene, 0, 0, 320, 480).Length, 30);
    }

    [Test]
    public void ACameraIsPlacedAndSet() {
        var camera = new Camera();
        var halfTurn = new Quat(0, 1, 0, 0);
        camera.SetTransform((1, 2, 3), halfTurn);
        Assert.AreEqual(((Vec3)(1, 2, 3), halfTurn), camera.GetTransform());
        var world = camera.GetWorldMatrix();
        Assert.AreEqual((-1f, 2f), (world[0], world[13]));
        camera.SetWorldMatrix(Mat4.Identity);
        Assert.AreEqual(Mat4.Identity, camera.GetViewMatrix());
        camera.SetPerspective(1, 0.5f, Far);
        Assert.IsNull(camera.GetCorners());
        camera.SetOrthographic(2, 0, 10);
        camera.SetViewport(200, 100);
        var projection = camera.GetProjectionMatrix();
        Assert.AreEqual((0.5f, 1f), (projection[0], projection[5]));
        camera.SetProjection(projection);
        Assert.AreEqual(projection, camera.GetViewProjectionMatrix());
        Assert.AreEqual((Vec3)(2, 1, 10), camera.GetCorners()[6]);
        Refused(Status.ErrorSingular, () => camera.SetProjection(new Mat4()));
        camera.SetOrigin(new double[] { 0, 1e7, 0 });
        Assert.AreEqual(1e7, camera.GetOrigin()[1]);
    }

    [Test]
    public void ACameraOrbits() {
        var camera = new Camera();
        Refused(Status.ErrorUnsupported, () => camera.GetOrbit());
        var orbit = Orbit.Default;
        orbit.RadiansPerUnit = 0.5f;
        camera.SetOrbit(orbit);
        camera.OrbitRotate(1, -1);
        camera.OrbitZoom(4);
        camera.OrbitPan(1, 0);
        camera.OrbitUpdate();
        orbit = camera.GetOrbit();
        Assert.AreEqual((0.5f, -0.5f, 6f, 1f), (orbit.Yaw, orbit.Pitch, orbit.Distance, orbit.Target.X));
    }

    [Test]
    public void BodiesAreMadeMovedAndRemoved() {
        var settings = SolverDesc.Default;
        settings.Substeps = 4;
        var solver = new Solver(settings);
        solver.SetSubsteps(8);
        solver.SetGravity((0, -10, 0));
        var body = solver.AddParticles(new Vec3[] { (0, 0, 0), (0, 0, 1), (0, 0, 3) });
        solver.SetPositions(body, 1, new Vec3[] { (0, 1, 2) });
        solver.SetVelocities(body, 0, Enumerable.Repeat<Vec3>((1, 0, 0), 3).ToArray());
        solver.SetMasses(body, 2, new float[] { 4 });
        solver.SetRadii(body, 0, new float[] { 0.1f, 0.1f });
        solver.SetForces(body, 2, new Vec3[] { (0, 40, 0) });
        solver.SetPinned(body, 0, 1, true);
        solver.Step(0.1f);
        Vec3[] positions = new Vec3[3], velocities = new Vec3[3];
        var masses = new float[3];
        solver.GetPositions(body, 0, positions);
        solver.GetVelocities(body, 0, velocities);
        solver.GetMasses(body, 0, masses);
        Assert.AreEqual((0f, 0f, 4f), (positions[0].X, velocities[0].X, masses[2]));
        Assert.AreEqual(0.95, positions[1].Y, 1e-5);
        Assert.AreEqual(-1, velocities[1].Y, 1e-5);
        Assert.AreEqual(0.1, positions[2].X, 1e-6);
        Assert.AreEqual(0, positions[2].Y, 1e-5);
        Refused(Status.ErrorInvalidArgument, () => solver.GetPositions(body, 1, positions));

        var cloth = solver.AddClothMesh(Tetrahedron(), Transform.At((9, 0, 0)));
        var info = solver.GetBodyInfo(cloth);
        Assert.AreEqual((BodyKind.Cloth, 4, 4), (info.Kind, (int)info.ParticleCount, (int)info.TriangleCount));
        Assert.AreEqual(12, solver.GetTriangles(cloth).Length);
        var link = solver.AddDistance(body, 1, 2, -1);
        Assert.AreEqual(link, solver.GetConstraints(body)[0].Id);
        solver.RemoveConstraint(body, link);
        Assert.AreEqual(0, solver.GetStats(body).ConstraintCount);
        CollectionAssert.AreEqual(new[] { body, cloth }, solver.GetBodies());
        solver.RemoveBody(cloth);
        Refused(Status.ErrorInvalidId, () => solver.GetBodyInfo(cloth));
        solver.SetOrigin(new double[] { 5, 0, 0 });
        CollectionAssert.AreEqual(new[] { 5, 0, 0 }, solver.GetOrigin());
    }

    [Test]
    public void BodiesMeetAndFollowModels() {
        var scene = new Scene();
        var ground = scene.Add(new Plane(Up, 0));
        var hook = scene.Add(new Sphere((0, 5, 0), 0.1f));
        var solver = new Solver();
        var desc = BodyDesc.Default;
        desc.Layers = 1;
        desc.Radius = 0.1f;
        var drop = solver.AddParticles(new Vec3[] { (3, 0.2f, 0) }, desc);
        desc.Layers = 0;
        var rope = solver.AddRope(new Vec3[] { (0, 5, 0), (0, 4.5f, 0) }, desc: desc);
        solver.AddCloth((0, 9, 0), (1, 0, 0), (0, 0, 1), 3, 3);
        solver.Attach(scene, rope, 0, hook);
        for (var frame = 0; frame < 30; ++frame) {
            var (steps, leftover) = solver.Advance(1f / 60, scene);
            Assert.LessOrEqual(steps, 2);
            Assert.That(leftover, Is.InRange(0f, 1f));
        }
        Assert.IsTrue(solver.GetContacts().Any(c => c.Body == drop && c.Model == ground && c.Normal.Y == 1));
        scene.SetTransform(hook, Transform.At((2, 0, 0)));
        solver.Step(0.01f, scene);
        var end = new Vec3[1];
        solver.GetPositions(rope, 0, end);
        Assert.AreEqual(2, end[0].X, 1e-5);
        solver.Detach(rope, 0);
        Refused(Status.ErrorInvalidArgument, () => solver.Detach(rope, 0));
    }

    [Test]
    public void ASolverGoesOnFromASnapshot() {
        Solver solver = new Solver(), twin = new Solver();
        var body = solver.AddCloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 10, 10);
        solver.SetPinned(body, 0, 1, true);
        solver.Step(0.01f);
        var snapshot = solver.GetSnapshot();
        Refused(Status.ErrorInvalidArgument, () => twin.Restore(snapshot.Skip(1).ToArray()));
        twin.Restore(snapshot);
        Scene place = new Scene(), copy = new Scene();
        place.Add(new Sphere((0, 1, 0), 1));
        copy.Restore(place.GetSnapshot(true));
        CollectionAssert.AreEqual(place.GetHash(), copy.GetHash());
        copy.Restore(place.GetSnapshot(false), place);
        CollectionAssert.AreEqual(place.GetModels(), copy.GetModels());
        CollectionAssert.AreEqual(solver.GetHash(), twin.GetHash());
        solver.Step(0.01f);
        CollectionAssert.AreNotEqual(solver.GetHash(), twin.GetHash());
        twin.Step(0.01f);
        CollectionAssert.AreEqual(solver.GetSnapshot(), twin.GetSnapshot());
    }

    [Test]
    public void ABodyAtRestSleepsUntilItIsWoken() {
        var settings = SolverDesc.Default;
        (settings.SleepSpeed, settings.SleepTime) = (1, 0);
        var solver = new Solver(settings);
        var body = solver.AddCloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 3, 3);
        solver.Step(0.01f);
        CollectionAssert.AreEqual(new[] { body }, solver.GetSleeping());
        solver.Wake(body);
        CollectionAssert.IsEmpty(solver.GetSleeping());
    }

    [Test]
    public void SubstepsAreAsManyAsAskedForOrAsATargetTakes() {
        var substeps = new uint[2];
        for (var i = 0; i < 2; ++i) {
            var settings = SolverDesc.Default;
            settings.MaxStrain = i * 1e-6f;
            var solver = new Solver(settings);
            var cloth = solver.AddCloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 3, 3);
            solver.SetPinned(cloth, 0, 1, true);
            Assert.AreEqual(0, solver.GetSubsteps(cloth));
            for (var step = 0; step < 5; ++step) solver.Step(0.01f);
            substeps[i] = solver.GetSubsteps(cloth);
        }
        Assert.AreEqual(8, substeps[0]);
        Assert.Greater(substeps[1], 8);
    }

    [Test]
    public void AStringHoldsAWeightAndATetrahedronKeepsItsVolume() {
        var scene = new Scene();
        var solver = new Solver();
        var model = ModelDesc.Default;
        model.Tag = 5;
        var hook = scene.Add(new Sphere((0, 0, 0), 0.1f), null, model);
        var body = BodyDesc.Default;
        (body.Mass, body.Layers) = (2, 0);
        var weights = solver.AddParticles(new Vec3[] { (0, 0, 0), (0, -1, 0) }, body);
        solver.Attach(scene, weights, 0, hook, (0, 0, 0));
        var line = solver.AddMaxDistance(weights, 0, 1, 2, 1e-6f);
        solver.SetConstraintDamping(weights, line, 50);
        var kinds = new ConstraintKind[1];
        solver.GetConstraintKinds(weights, new[] { line }, kinds);
        Assert.AreEqual(ConstraintKind.MaxDistance, kinds[0]);
        Assert.AreEqual(hook, solver.GetAttachments(weights).Single().Model);
        for (var i = 0; i < 300; ++i) solver.Step(0.01f, scene);
        var end = new Vec3[1];
        solver.GetPositions(weights, 1, end);
        Assert.AreEqual(-2, end[0].Y, 1e-3);
        var impulse = solver.GetImpulses().Single();
        Assert.AreEqual((hook, 5u), (impulse.Model, impulse.Tag));
        Assert.AreEqual(-2 * 9.81 * 0.01, impulse.Linear.Y, 5e-3);
        var ball = solver.AddClothMesh(Tetrahedron());
        solver.SetVolume(ball, -1);
        var (volume, pressure) = solver.GetVolume(ball);
        Assert.AreEqual(1.0 / 6, volume, 1e-6);
        Assert.AreEqual(0, pressure);
        Assert.AreEqual((volume, 0f), solver.GetVolumeSettings(ball));
        solver.SetVolume(ball, 1, float.PositiveInfinity);
        Refused(Status.ErrorUnsupported, () => solver.GetVolume(ball));
    }

    [Test]
    public void SettingsChangeLive() {
        var solver = new Solver();
        var settings = solver.GetSettings();
        settings.Substeps = 5;
        solver.SetSettings(settings);
        Assert.AreEqual(5, solver.GetSettings().Substeps);
        solver.SetWorkerCount(2);
        Assert.AreEqual(2, solver.GetWorkerCount());
        Assert.AreEqual(0, solver.GetLeftover());
        var rope = solver.AddRope(new Vec3[] { (0, 0, 0), (0, -1, 0) }, 0);
        solver.SetPinned(rope, 0, 1, true);
        var pinned = new int[2];
        solver.GetPinned(rope, 0, pinned);
        Assert.AreEqual(new[] { 1, 0 }, pinned);
        var body = solver.GetBodySettings(rope);
        body.Damping = 0.5f;
        solver.SetBodySettings(rope, body);
        Assert.AreEqual(0.5f, solver.GetBodySettings(rope).Damping);
        var links = new[] { solver.GetConstraints(rope)[0].Id };
        var link = new ConstraintSettings[1];
        solver.GetConstraintSettings(rope, links, link);
        link[0].RestLength = 0.5f;
        solver.SetConstraintSettings(rope, links, link);
        var (radii, vectors) = (new float[2], new Vec3[2]);
        solver.GetRadii(rope, 0, radii);
        solver.GetForces(rope, 0, vectors);
        Assert.AreEqual((0.01f, 0f), (radii[1], vectors[1].Y));
        for (var i = 0; i < 10; ++i) solver.Step(0.01f);
        solver.GetPositions(rope, 0, vectors);
        Assert.AreEqual(-0.5, vectors[1].Y, 1e-5);
    }

    [Test]
    public void WindCarriesBallsAlong() {
        var desc = SolverDesc.Default;
        desc.Gravity = (0, 0, 0);
        var solver = new Solver(desc);
        var balls = solver.AddParticles(new Vec3[] { (0, 0, 0), (1, 0, 0) });
        solver.SetWind(balls, new Wind { Velocity = (2, 0, 0), Density = 1e4f, Drag = 0.5f });
        Assert.AreEqual(1e4f, solver.GetWind(balls).Density);
        solver.SetAirVelocities(balls, 1, new Vec3[] { (0, 3, 0) });
        var vectors = new Vec3[2];
        solver.GetAirVelocities(balls, 0, vectors);
        Assert.AreEqual((0f, 3f), (vectors[0].Y, vectors[1].Y));
        for (var i = 0; i < 500; ++i) solver.Step(0.01f);
        solver.GetVelocities(balls, 0, vectors);
        Assert.That(vectors[0].X > 1.8 && vectors[1].Y > 2.7);
    }

    [Test]
    public void AClusterHoldsOutAParticleUntilItEnds() {
        var solver = new Solver();
        var plank = solver.AddParticles(new Vec3[] { (0, 0, 0), (1, 0, 0), (2, 0, 0) });
        solver.SetPinned(plank, 0, 2, true);
        var cluster = solver.AddCluster(plank, new uint[] { 0, 1, 2 });
        CollectionAssert.AreEqual(new[] { cluster }, solver.GetClusters(plank));
        CollectionAssert.AreEqual(new uint[] { 0, 1, 2 }, solver.GetClusterParticles(plank, cluster));
        var places = new Vec3[1];
        for (var i = 0; i < 30; ++i) solver.Step(0.01f);
        solver.GetPositions(plank, 2, places);
        Assert.AreEqual(2, places[0].X, 1e-5);
        Assert.AreEqual(0, places[0].Y, 1e-5);
        solver.RemoveCluster(plank, cluster);
        for (var i = 0; i < 30; ++i) solver.Step(0.01f);
        solver.GetPositions(plank, 2, places);
        Assert.That(places[0].Y < -0.4);
        Refused(Status.ErrorInvalidId, () => solver.RemoveCluster(plank, cluster));
    }

    [Test]
    public void ARopeBreaksUnderItsWeightAndClothIsCut() {
        var solver = new Solver();
        var rope = solver.AddRope(new Vec3[] { (0, 0, 0), (0, -1, 0) }, 0);
        solver.SetPinned(rope, 0, 1, true);
        var links = new[] { solver.GetConstraints(rope)[0].Id };
        solver.SetBreakingForces(rope, links, new[] { 3f });
        var forces = new float[1];
        solver.GetBreakingForces(rope, links, forces);
        Assert.AreEqual(3f, forces[0]);
        Assert.AreEqual(0, solver.GetBreaks().Length);
        for (var i = 0; i < 10 && solver.GetBreaks().Length == 0; ++i) solver.Step(0.01f);
        var breaks = solver.GetBreaks();
        Assert.AreEqual(1, breaks.Length);
        Assert.AreEqual((rope, links[0], uint.MaxValue), (breaks[0].Body, breaks[0].Constraint, breaks[0].TornParticle));
        Assert.That(breaks[0].Load > 3);
        Refused(Status.ErrorInvalidId, () => solver.BreakConstraint(rope, links[0]));
        var sheet = solver.AddCloth((0, 0, 0), (1, 0, 0), (0, 0, 1), 3, 3);
        Assert.AreEqual(9, solver.BreakConstraint(sheet, solver.GetConstraints(sheet)[1].Id).NewParticle);
    }

    [Test]
    public void OneOfTwoBallsSlidesOverIce() {
        var solver = new Solver();
        var scene = new Scene();
        scene.Add(new Plane(Up, 0));
        var balls = solver.AddParticles(new Vec3[] { (0, 0.01f, 0), (0, 0.01f, 1) });
        solver.SetFrictionFactors(balls, 1, new float[] { 0 });
        var factors = new float[2];
        solver.GetFrictionFactors(balls, 0, factors);
        Assert.AreEqual((1f, 0f), (factors[0], factors[1]));
        var speeds = new Vec3[] { (1, 0, 0), (1, 0, 0) };
        solver.SetVelocities(balls, 0, speeds);
        for (var i = 0; i < 50; ++i) solver.Step(0.01f, scene);
        solver.GetVelocities(balls, 0, speeds);
        Assert.AreEqual(0, speeds[0].X);
        Assert.AreEqual(1, speeds[1].X, 1e-5);
    }

    [Test]
    public void ABallPressesTheOneThatItLiesOn() {
        var solver = new Solver();
        var desc = BodyDesc.Default;
        desc.Mass = 2;
        desc.Radius = 0.5f;
        desc.BodyLayers = 1;
        var lower = solver.AddParticles(new Vec3[] { (0, 0, 0) }, desc);
        var upper = solver.AddParticles(new Vec3[] { (0, 1, 0) }, desc);
        solver.SetPinned(lower, 0, 1, true);
        for (var i = 0; i < 20; ++i) solver.Step(0.01f);
        var contact = solver.GetBodyContacts().Single();
        Assert.AreEqual((lower, upper, 1f), (contact.BodyA, contact.BodyB, contact.Normal.Y));
        Assert.AreEqual(0.1962, contact.Impulse, 2e-3);
    }

    [Test]
    public void ABallHangsBelowItsAnimationTarget() {
        var solver = new Solver();
        var balls = solver.AddParticles(new Vec3[] { (0, 0, 0), (1, 0, 0) });
        var targets = new AnimationTarget[2];
        solver.GetAnimationTargets(balls, 0, targets);
        Assert.AreEqual(float.PositiveInfinity, targets[1].MaxDistance);
        targets[1].Position = (1, 0, 0);
        targets[1].MaxDistance = 0.25f;
        solver.SetAnimationTargets(balls, 0, targets);
        for (var i = 0; i < 60; ++i) solver.Step(0.01f);
        var at = new Vec3[1];
        solver.GetPositions(balls, 1, at);
        Assert.AreEqual(-0.25f, at[0].Y);
    }

    [Test]
    public void AJointHoldsAParticleOfAnotherBody() {
        var solver = new Solver();
        var body = BodyDesc.Default;
        body.Mass = 2;
        var nail = solver.AddParticles(new Vec3[] { (0, 0, 0) }, body);
        var weight = solver.AddParticles(new Vec3[] { (0, -1, 0) }, body);
        solver.SetPinned(nail, 0, 1, true);
        var joint = solver.Join(nail, 0, weight, 0, -1);
        for (var i = 0; i < 20; ++i) solver.Step(0.01f);
        var held = solver.GetJoints(weight).Single();
        Assert.AreEqual((joint, nail, weight), (held.Id, held.BodyA, held.BodyB));
        Assert.AreEqual(2 * 9.81, held.Force, 0.01);
        solver.Unjoin(joint);
        Assert.IsEmpty(solver.GetJoints(0));
        Refused(Status.ErrorInvalidId, () => solver.Unjoin(joint));
    }
}
