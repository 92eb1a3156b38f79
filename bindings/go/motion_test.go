package gamephys

import (
	"math"
	"testing"
)

func close(a float32, b, tolerance float64) bool { return math.Abs(float64(a)-b) <= tolerance }

func TestACameraProjectsAndPicks(t *testing.T) {
	scene, _ := sceneOfBalls()
	desc := DefaultCameraDesc()
	desc.ViewportWidth, desc.ViewportHeight = 640, 480
	camera := must(NewCamera(&desc))
	try(t, camera.LookAt(Vec(0, 0, -9), Vec3{}, up))
	points, pixels := []Vec3{{}, {1, 1, 3}, {0, 0, -20}}, make([]Vec3, 3)
	try(t, camera.ProjectBatch(points, pixels))
	same(t, found(camera.Project(points[1])), pixels[1])
	_, seen, err := camera.Project(points[2])
	same(t, []any{seen, err}, []any{false, nil})
	same(t, []float32{pixels[0].X, pixels[0].Y}, []float32{320, 240})
	back := make([]Vec3, 2)
	try(t, camera.UnprojectBatch(pixels[:2], back))
	same(t, found(camera.Unproject(pixels[1])), back[1])
	same(t, close(back[1].Z, 3, 1e-3), true)

	rays := make([]Ray, 16*12)
	try(t, camera.PickRays(312, 234, 16, 12, rays))
	same(t, found(camera.PickRay(312.5, 234.5)), rays[0])
	refused(t, ErrInvalidArgument, camera.PickRays(312, 234, 16, 11, rays))
	places, hits, met := make([][2]float32, 64), make([]Hit, 64), 0
	for i := range places {
		places[i] = [2]float32{10 * float32(i), 7.5 * float32(i)}
	}
	try(t, camera.PickBatch(scene, places, AllLayers, hits))
	for i, place := range places {
		hit, _, err := camera.Pick(scene, place[0], place[1], AllLayers)
		try(t, err)
		same(t, hit.Model, hits[i].Model)
		if hit.Model != 0 {
			met++
		}
	}
	same(t, met > 0 && met < 64, true)
	same(t, len(must(camera.Cull(scene, AllLayers))), 30)
	same(t, len(must(camera.PickRectangle(scene, 0, 0, 320, 480, AllLayers))) < 30, true)
}

func TestACameraIsPlacedAndSet(t *testing.T) {
	camera, halfTurn := must(NewCamera(nil)), Quat{Y: 1}
	try(t, camera.SetTransform(Vec(1, 2, 3), halfTurn))
	position, rotation, err := camera.Transform()
	same(t, []any{position, rotation, err}, []any{Vec(1, 2, 3), halfTurn, nil})
	world := must(camera.WorldMatrix())
	same(t, []float32{world.M[0], world.M[13]}, []float32{-1, 2})
	identity := Mat4{[16]float32{0: 1, 5: 1, 10: 1, 15: 1}}
	try(t, camera.SetWorldMatrix(identity))
	same(t, must(camera.ViewMatrix()), identity)
	try(t, camera.SetPerspective(1, 0.5, infinity))
	_, finite, err := camera.Corners()
	same(t, []any{finite, err}, []any{false, nil})
	try(t, camera.SetOrthographic(2, 0, 10))
	try(t, camera.SetViewport(200, 100))
	projection := must(camera.ProjectionMatrix())
	same(t, []float32{projection.M[0], projection.M[5]}, []float32{0.5, 1})
	try(t, camera.SetProjection(projection))
	same(t, must(camera.ViewProjectionMatrix()), projection)
	same(t, found(camera.Corners())[6], Vec(2, 1, 10))
	refused(t, ErrSingular, camera.SetProjection(Mat4{}))
	try(t, camera.SetOrigin([3]float64{0, 1e7, 0}))
	same(t, must(camera.Origin())[1], 1e7)
}

func TestACameraOrbits(t *testing.T) {
	camera, orbit := must(NewCamera(nil)), DefaultOrbit()
	_, err := camera.Orbit()
	refused(t, ErrUnsupported, err)
	orbit.RadiansPerUnit = 0.5
	try(t, camera.SetOrbit(orbit))
	try(t, camera.OrbitRotate(1, -1))
	try(t, camera.OrbitZoom(4))
	try(t, camera.OrbitPan(1, 0))
	try(t, camera.OrbitUpdate())
	orbit = must(camera.Orbit())
	same(t, []float32{orbit.Yaw, orbit.Pitch, orbit.Distance, orbit.Target.X}, []float32{0.5, -0.5, 6, 1})
}

func TestBodiesAreMadeMovedAndRemoved(t *testing.T) {
	desc := DefaultSolverDesc()
	desc.Substeps = 4
	solver := must(NewSolver(&desc))
	try(t, solver.SetSubsteps(8))
	try(t, solver.SetGravity(Vec(0, -10, 0)))
	body := must(solver.AddParticles([]Vec3{{}, {0, 0, 1}, {0, 0, 3}}, nil))
	try(t, solver.SetPositions(body, 1, []Vec3{{0, 1, 2}}))
	try(t, solver.SetVelocities(body, 0, []Vec3{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}}))
	try(t, solver.SetMasses(body, 2, []float32{4}))
	try(t, solver.SetRadii(body, 0, []float32{0.1, 0.1}))
	try(t, solver.SetForces(body, 2, []Vec3{{0, 40, 0}}))
	try(t, solver.SetPinned(body, 0, 1, true))
	try(t, solver.Step(nil, 0.1))
	positions, velocities, masses := make([]Vec3, 3), make([]Vec3, 3), make([]float32, 3)
	try(t, solver.Positions(body, 0, positions))
	try(t, solver.Velocities(body, 0, velocities))
	try(t, solver.Masses(body, 0, masses))
	same(t, []float32{positions[0].X, velocities[0].X, masses[2]}, []float32{0, 0, 4})
	same(t, close(positions[1].Y, 0.95, 1e-5) && close(velocities[1].Y, -1, 1e-5), true)
	same(t, close(positions[2].X, 0.1, 1e-6) && close(positions[2].Y, 0, 1e-5), true)
	refused(t, ErrInvalidArgument, solver.Positions(body, 1, positions))

	aside := Place(Vec(9, 0, 0))
	cloth := must(solver.AddClothMesh(tetrahedron(), &aside, nil))
	info := must(solver.BodyInfo(cloth))
	same(t, []any{info.Kind, info.ParticleCount, info.TriangleCount}, []any{BodyCloth, uint32(4), uint32(4)})
	same(t, len(must(solver.Triangles(cloth))), 12)
	link := must(solver.AddDistance(body, 1, 2, -1, 0))
	same(t, must(solver.Constraints(body))[0].ID, link)
	try(t, solver.RemoveConstraint(body, link))
	same(t, must(solver.Stats(body)).ConstraintCount, uint32(0))
	same(t, must(solver.Bodies()), []BodyID{body, cloth})
	try(t, solver.RemoveBody(cloth))
	_, err := solver.BodyInfo(cloth)
	refused(t, ErrInvalidID, err)
	try(t, solver.SetOrigin([3]float64{5, 0, 0}))
	same(t, must(solver.Origin()), [3]float64{5, 0, 0})
}

func TestBodiesMeetAndFollowModels(t *testing.T) {
	scene, solver := must(NewScene(nil)), must(NewSolver(nil))
	ground := must(scene.Add(Plane{Normal: up}, nil, nil))
	hook := must(scene.Add(Sphere{Vec(0, 5, 0), 0.1}, nil, nil))
	desc := DefaultBodyDesc()
	desc.Layers, desc.Radius = 1, 0.1
	drop := must(solver.AddParticles([]Vec3{{3, 0.2, 0}}, &desc))
	desc.Layers = 0
	rope := must(solver.AddRope([]Vec3{{0, 5, 0}, {0, 4.5, 0}}, 0, &desc))
	must(solver.AddCloth(Vec(0, 9, 0), Vec(1, 0, 0), Vec(0, 0, 1), 3, 3, nil))
	try(t, solver.Attach(scene, rope, 0, hook, nil))
	for frame := 0; frame < 30; frame++ {
		steps, leftover, err := solver.Advance(scene, 1.0/60)
		try(t, err)
		same(t, steps <= 2 && 0 <= leftover && leftover < 1, true)
	}
	met := false
	for _, contact := range must(solver.Contacts()) {
		met = met || contact.Body == drop && contact.Model == ground && contact.Normal == up
	}
	same(t, met, true)
	try(t, scene.SetTransform(hook, Place(Vec(2, 0, 0))))
	try(t, solver.Step(scene, 0.01))
	end := make([]Vec3, 1)
	try(t, solver.Positions(rope, 0, end))
	same(t, close(end[0].X, 2, 1e-5), true)
	try(t, solver.Detach(rope, 0))
	refused(t, ErrInvalidArgument, solver.Detach(rope, 0))
}

func TestASolverGoesOnFromASnapshot(t *testing.T) {
	solver, twin := must(NewSolver(nil)), must(NewSolver(nil))
	body := must(solver.AddCloth(Vec3{}, Vec(1, 0, 0), Vec(0, 0, 1), 10, 10, nil))
	try(t, solver.SetPinned(body, 0, 1, true))
	try(t, solver.Step(nil, 0.01))
	snapshot := must(solver.Snapshot())
	refused(t, ErrInvalidArgument, twin.Restore(snapshot[1:]))
	try(t, twin.Restore(snapshot))
	place, copied := must(NewScene(nil)), must(NewScene(nil))
	must(place.Add(Sphere{Vec(0, 1, 0), 1}, nil, nil))
	try(t, copied.Restore(nil, must(place.Snapshot(true))))
	same(t, must(copied.Hash()), must(place.Hash()))
	try(t, copied.Restore(place, must(place.Snapshot(false))))
	same(t, must(copied.Hash()), must(place.Hash()))
	same(t, must(twin.Hash()), must(solver.Hash()))
	try(t, solver.Step(nil, 0.01))
	same(t, must(twin.Hash()) == must(solver.Hash()), false)
	try(t, twin.Step(nil, 0.01))
	same(t, must(twin.Hash()), must(solver.Hash()))
	same(t, must(twin.Snapshot()), must(solver.Snapshot()))
	try(t, twin.Wake(0))
	same(t, len(must(twin.Sleeping())), 0)
}

func TestSubstepsAreAsManyAsAskedForOrAsATargetTakes(t *testing.T) {
	substeps := func(maxStrain float32) uint32 {
		desc := DefaultSolverDesc()
		desc.MaxStrain = maxStrain
		solver := must(NewSolver(&desc))
		cloth := must(solver.AddCloth(Vec3{}, Vec(1, 0, 0), Vec(0, 0, 1), 3, 3, nil))
		try(t, solver.SetPinned(cloth, 0, 1, true))
		same(t, must(solver.Substeps(cloth)), uint32(0))
		for i := 0; i < 5; i++ {
			try(t, solver.Step(nil, 0.01))
		}
		return must(solver.Substeps(cloth))
	}
	same(t, substeps(0), uint32(8))
	same(t, substeps(1e-6) > 8, true)
}

func TestAStringHoldsAWeightAndATetrahedronKeepsItsVolume(t *testing.T) {
	scene, solver := must(NewScene(nil)), must(NewSolver(nil))
	model, body := DefaultModelDesc(), DefaultBodyDesc()
	model.Tag, body.Mass, body.Layers = 5, 2, 0
	hook := must(scene.Add(Sphere{Radius: 0.1}, nil, &model))
	weights := must(solver.AddParticles([]Vec3{{}, Vec(0, -1, 0)}, &body))
	try(t, solver.Attach(scene, weights, 0, hook, &Vec3{}))
	line := must(solver.AddMaxDistance(weights, 0, 1, 2, 1e-6))
	try(t, solver.SetConstraintDamping(weights, line, 50))
	kinds := make([]ConstraintKind, 1)
	try(t, solver.ConstraintKinds(weights, []ConstraintID{line}, kinds))
	same(t, kinds[0], ConstraintMaxDistance)
	same(t, must(solver.Attachments(weights))[0].Model, hook)
	for i := 0; i < 300; i++ {
		try(t, solver.Step(scene, 0.01))
	}
	end := make([]Vec3, 1)
	try(t, solver.Positions(weights, 1, end))
	same(t, close(end[0].Y, -2, 1e-3), true)
	impulses := must(solver.Impulses())
	same(t, len(impulses), 1)
	same(t, []uint32{uint32(impulses[0].Model), impulses[0].Tag}, []uint32{uint32(hook), 5})
	same(t, close(impulses[0].Linear.Y, -2*9.81*0.01, 5e-3), true)
	ball := must(solver.AddClothMesh(tetrahedron(), nil, nil))
	try(t, solver.SetVolume(ball, -1, 0))
	volume, pressure, err := solver.Volume(ball)
	try(t, err)
	same(t, close(volume, 1.0/6, 1e-6) && pressure == 0, true)
	rest, compliance, err := solver.VolumeSettings(ball)
	same(t, []any{rest, compliance, err}, []any{volume, float32(0), nil})
	try(t, solver.SetVolume(ball, 1, infinity))
	_, _, err = solver.Volume(ball)
	refused(t, ErrUnsupported, err)
}

func TestSettingsChangeLive(t *testing.T) {
	solver := must(NewSolver(nil))
	settings := must(solver.Settings())
	settings.Substeps = 5
	try(t, solver.SetSettings(settings))
	same(t, must(solver.Settings()).Substeps, uint32(5))
	try(t, solver.SetWorkerCount(2))
	same(t, must(solver.WorkerCount()), uint32(2))
	same(t, must(solver.Leftover()), float32(0))
	rope := must(solver.AddRope([]Vec3{{}, Vec(0, -1, 0)}, 0, nil))
	try(t, solver.SetPinned(rope, 0, 1, true))
	pinned := make([]int32, 2)
	try(t, solver.Pinned(rope, 0, pinned))
	same(t, pinned, []int32{1, 0})
	body := must(solver.BodySettings(rope))
	body.Damping = 0.5
	try(t, solver.SetBodySettings(rope, body))
	same(t, must(solver.BodySettings(rope)).Damping, float32(0.5))
	links := []ConstraintID{must(solver.Constraints(rope))[0].ID}
	link := make([]ConstraintSettings, 1)
	try(t, solver.ConstraintSettings(rope, links, link))
	link[0].RestLength = 0.5
	try(t, solver.SetConstraintSettings(rope, links, link))
	radii, vectors := make([]float32, 2), make([]Vec3, 2)
	try(t, solver.Radii(rope, 0, radii))
	try(t, solver.Forces(rope, 0, vectors))
	same(t, radii[1] == 0.01 && vectors[1].Y == 0, true)
	for i := 0; i < 10; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	try(t, solver.Positions(rope, 0, vectors))
	same(t, close(vectors[1].Y, -0.5, 1e-5), true)
}

func TestWindCarriesBallsAlong(t *testing.T) {
	desc := DefaultSolverDesc()
	desc.Gravity = Vec3{}
	solver := must(NewSolver(&desc))
	balls := must(solver.AddParticles([]Vec3{{}, Vec(1, 0, 0)}, nil))
	try(t, solver.SetWind(balls, Wind{Velocity: Vec(2, 0, 0), Density: 1e4, Drag: 0.5}))
	same(t, must(solver.Wind(balls)).Density, float32(1e4))
	try(t, solver.SetAirVelocities(balls, 1, []Vec3{Vec(0, 3, 0)}))
	vectors := make([]Vec3, 2)
	try(t, solver.AirVelocities(balls, 0, vectors))
	same(t, vectors[0].Y == 0 && vectors[1].Y == 3, true)
	for i := 0; i < 500; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	try(t, solver.Velocities(balls, 0, vectors))
	same(t, vectors[0].X > 1.8 && vectors[1].Y > 2.7, true)
}

func TestAClusterHoldsOutAParticleUntilItEnds(t *testing.T) {
	solver := must(NewSolver(nil))
	plank := must(solver.AddParticles([]Vec3{{}, Vec(1, 0, 0), Vec(2, 0, 0)}, nil))
	try(t, solver.SetPinned(plank, 0, 2, true))
	cluster := must(solver.AddCluster(plank, []uint32{0, 1, 2}))
	same(t, must(solver.Clusters(plank)), []ClusterID{cluster})
	same(t, must(solver.ClusterParticles(plank, cluster)), []uint32{0, 1, 2})
	places := make([]Vec3, 1)
	for i := 0; i < 30; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	try(t, solver.Positions(plank, 2, places))
	same(t, close(places[0].X, 2, 1e-5) && close(places[0].Y, 0, 1e-5), true)
	try(t, solver.RemoveCluster(plank, cluster))
	for i := 0; i < 30; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	try(t, solver.Positions(plank, 2, places))
	same(t, places[0].Y < -0.4, true)
	refused(t, ErrInvalidID, solver.RemoveCluster(plank, cluster))
}

func TestARopeBreaksUnderItsWeightAndClothIsCut(t *testing.T) {
	solver := must(NewSolver(nil))
	rope := must(solver.AddRope([]Vec3{{}, Vec(0, -1, 0)}, 0, nil))
	try(t, solver.SetPinned(rope, 0, 1, true))
	links := []ConstraintID{must(solver.Constraints(rope))[0].ID}
	try(t, solver.SetBreakingForces(rope, links, []float32{3}))
	forces := make([]float32, 1)
	try(t, solver.BreakingForces(rope, links, forces))
	same(t, forces, []float32{3})
	same(t, len(must(solver.Breaks())), 0)
	for i := 0; i < 10 && len(must(solver.Breaks())) == 0; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	breaks := must(solver.Breaks())
	same(t, len(breaks), 1)
	same(t, breaks[0].Body == rope && breaks[0].Constraint == links[0] && breaks[0].Load > 3, true)
	same(t, breaks[0].TornParticle, uint32(NoParticle))
	_, err := solver.BreakConstraint(rope, links[0])
	refused(t, ErrInvalidID, err)
	sheet := must(solver.AddCloth(Vec3{}, Vec(1, 0, 0), Vec(0, 0, 1), 3, 3, nil))
	cut := must(solver.BreakConstraint(sheet, must(solver.Constraints(sheet))[1].ID))
	same(t, cut.NewParticle, uint32(9))
}

func TestOneOfTwoBallsSlidesOverIce(t *testing.T) {
	solver := must(NewSolver(nil))
	scene := must(NewScene(nil))
	must(scene.Add(Plane{Normal: up}, nil, nil))
	balls := must(solver.AddParticles([]Vec3{Vec(0, 0.01, 0), Vec(0, 0.01, 1)}, nil))
	try(t, solver.SetFrictionFactors(balls, 1, []float32{0}))
	factors := make([]float32, 2)
	try(t, solver.FrictionFactors(balls, 0, factors))
	same(t, factors[0] == 1 && factors[1] == 0, true)
	speeds := []Vec3{Vec(1, 0, 0), Vec(1, 0, 0)}
	try(t, solver.SetVelocities(balls, 0, speeds))
	for i := 0; i < 50; i++ {
		try(t, solver.Step(scene, 0.01))
	}
	try(t, solver.Velocities(balls, 0, speeds))
	same(t, speeds[0].X, float32(0))
	same(t, close(speeds[1].X, 1, 1e-5), true)
}

func TestABallPressesTheOneThatItLiesOn(t *testing.T) {
	solver, desc := must(NewSolver(nil)), DefaultBodyDesc()
	desc.Mass, desc.Radius, desc.BodyLayers = 2, 0.5, 1
	lower := must(solver.AddParticles([]Vec3{{}}, &desc))
	upper := must(solver.AddParticles([]Vec3{up}, &desc))
	try(t, solver.SetPinned(lower, 0, 1, true))
	for i := 0; i < 20; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	contacts := must(solver.BodyContacts())
	same(t, len(contacts), 1)
	same(t, contacts[0].BodyA == lower && contacts[0].BodyB == upper && contacts[0].Normal == up, true)
	same(t, close(contacts[0].Impulse, 0.1962, 2e-3), true)
}

func TestABallHangsBelowItsAnimationTarget(t *testing.T) {
	solver := must(NewSolver(nil))
	balls := must(solver.AddParticles([]Vec3{{}, Vec(1, 0, 0)}, nil))
	targets := make([]AnimationTarget, 2)
	try(t, solver.AnimationTargets(balls, 0, targets))
	same(t, math.IsInf(float64(targets[1].MaxDistance), 1), true)
	targets[1].Position, targets[1].MaxDistance = Vec(1, 0, 0), 0.25
	try(t, solver.SetAnimationTargets(balls, 0, targets))
	for i := 0; i < 60; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	at := make([]Vec3, 1)
	try(t, solver.Positions(balls, 1, at))
	same(t, at[0].Y, float32(-0.25))
}

func TestAJointHoldsAParticleOfAnotherBody(t *testing.T) {
	solver, body := must(NewSolver(nil)), DefaultBodyDesc()
	body.Mass = 2
	nail := must(solver.AddParticles([]Vec3{{}}, &body))
	weight := must(solver.AddParticles([]Vec3{Vec(0, -1, 0)}, &body))
	try(t, solver.SetPinned(nail, 0, 1, true))
	joint := must(solver.Join(nail, 0, weight, 0, -1, 0))
	for i := 0; i < 20; i++ {
		try(t, solver.Step(nil, 0.01))
	}
	joints := must(solver.Joints(weight))
	same(t, len(joints), 1)
	same(t, joints[0].ID == joint && joints[0].BodyA == nail && joints[0].BodyB == weight, true)
	same(t, close(joints[0].Force, 2*9.81, 0.01), true)
	try(t, solver.Unjoin(joint))
	same(t, len(must(solver.Joints(0))), 0)
	refused(t, ErrInvalidID, solver.Unjoin(joint))
}
