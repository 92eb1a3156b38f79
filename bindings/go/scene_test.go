package gamephys

import "testing"

func TestBatchesAnswerAsSingleCallsDo(t *testing.T) {
	scene, _ := sceneOfBalls()
	rays := someRays()
	n := len(rays)
	hits, crossed, swept, any, nearest := make([]Hit, n), make([]Hit, n), make([]Hit, n), make([]int32, n), make([]Nearest, n)
	segments, points, moving := make([]Segment, n), make([]Vec3, n), make([]Sphere, n)
	for i, ray := range rays {
		segments[i], points[i], moving[i] = Segment{ray.Origin, Vec(0, 0, 5)}, ray.Direction, Sphere{ray.Direction, 0.1}
	}
	way := Vec(0, 0, 9)
	try(t, scene.RaycastBatch(rays, AllLayers, hits))
	try(t, scene.RaycastAnyBatch(rays, AllLayers, any))
	distances := make([]Distance, len(rays))
	try(t, scene.RaycastDistanceBatch(rays, AllLayers, distances))
	try(t, scene.SegmentTestBatch(segments, AllLayers, crossed))
	try(t, scene.NearestBatch(points, infinity, AllLayers, nearest))
	try(t, scene.SweepSphereBatch(moving, []Vec3{way}, AllLayers, swept)) // one displacement for all
	all, near := must(scene.RaycastAllBatch(rays, AllLayers)), must(scene.OverlapBatch(Spheres(moving), AllLayers))
	met := 0
	or := func(hit Hit, found bool, err error) Hit {
		try(t, err)
		if !found {
			return Hit{T: infinity, Triangle: NoTriangle}
		}
		return hit
	}
	for i := range rays {
		same(t, or(scene.Raycast(rays[i], AllLayers)), hits[i])
		same(t, must(scene.RaycastAny(rays[i], AllLayers)), any[i] != 0)
		same(t, distances[i], Distance{hits[i].T, hits[i].Model, hits[i].Triangle})
		same(t, must(scene.RaycastAll(rays[i], AllLayers)), all.At(i))
		same(t, or(scene.SegmentTest(segments[i], AllLayers)), crossed[i])
		same(t, found(scene.Nearest(points[i], infinity, AllLayers)), nearest[i])
		same(t, or(scene.SweepSphere(moving[i], way, AllLayers)), swept[i])
		same(t, must(scene.Overlap(moving[i], AllLayers)), near.At(i))
		if hits[i].Model != 0 {
			met++
		}
	}
	if met == 0 || met == n {
		t.Fatal(met, "rays meet a ball")
	}
}

func TestModelsWithDescsOfTheirOwn(t *testing.T) {
	scene, balls := must(NewScene(nil)), Spheres{{Radius: 1}, {Radius: 2}, {Radius: 3}}
	root := must(scene.Add(balls[0], nil, nil))
	models := make([]ModelID, 3)
	are := func(wanted ...[3]uint32) {
		t.Helper()
		for i, model := range models {
			info := must(scene.Info(model))
			same(t, [3]uint32{info.Parent, info.Layers, info.Tag}, wanted[i])
		}
	}
	plain := DefaultModelDesc()
	some := []ModelDesc{plain, plain, plain}
	some[0].Parent, some[0].Layers, some[0].Tag, some[1].Tag = root, 2, 5, 6
	first, second, third := [3]uint32{root, 2, 5}, [3]uint32{0, 1, 6}, [3]uint32{0, 1, 0}
	try(t, scene.AddDescribedBatch(balls, nil, some, models))
	are(first, second, third)
	try(t, scene.AddDescribedBatch(balls[0], nil, some, models))
	are(first, second, third)
	try(t, scene.AddDescribedBatch(balls, nil, some[:1], models)) // one for all
	are(first, first, first)
	try(t, scene.AddDescribedBatch(balls, make500Places()[:3], nil, models))
	are(third, third, third)
	count := len(must(scene.Models()))
	refused(t, ErrInvalidArgument, scene.AddDescribedBatch(balls, nil, some[:2], models))
	refused(t, ErrStructSize, scene.AddDescribedBatch(balls, nil, make([]ModelDesc, 3), models))
	some[2].Parent = 12345
	refused(t, ErrInvalidID, scene.AddDescribedBatch(balls, nil, some, models))
	same(t, len(must(scene.Models())), count)
}

func one(filter QueryFilterDesc) []QueryFilterDesc { return []QueryFilterDesc{filter} }

func TestFiltersHaveListsOfModelsAndBatchesAFilterForEach(t *testing.T) {
	scene, models := must(NewScene(nil)), make([]ModelID, 4)
	for i := range models {
		models[i] = must(scene.Add(Sphere{Vec(0, 0, float32(4*i)), 1}, nil, nil))
	}
	ray := Ray{Vec(0, 0, -5), Vec(0, 0, 1), infinity}
	each := make([]QueryFilterDesc, 3)
	for i := range each {
		each[i] = DefaultQueryFilterDesc()
		each[i].IgnoredModels = models[:i]
	}
	same(t, found(scene.RaycastFiltered(ray, &each[2])).Model, models[2])
	same(t, found(scene.RaycastFiltered(ray, &each[0])).Model, models[0])
	same(t, must(scene.OverlapFiltered(Sphere{Radius: 50}, &each[2])), models[2:])
	rays, hits := []Ray{ray, ray, ray}, make([]Hit, 3)
	met := func(filters []QueryFilterDesc) []ModelID {
		try(t, scene.RaycastFilteredBatch(rays, filters, hits))
		return []ModelID{hits[0].Model, hits[1].Model, hits[2].Model}
	}
	same(t, met(each), models[:3])
	same(t, met(each[2:]), []ModelID{models[2], models[2], models[2]})
	same(t, met(nil), []ModelID{models[0], models[0], models[0]})
	near := Sphere{Vec(0, 0, 2), 2}
	same(t, must(scene.OverlapFilteredBatch(Spheres{near, near, near}, each)).Offsets, []uint32{0, 2, 3, 3})
	refused(t, ErrInvalidArgument, scene.RaycastFilteredBatch(rays, each[:2], hits))
}

func TestFiltersLeaveOutModels(t *testing.T) {
	scene, ball := must(NewScene(nil)), Sphere{Radius: 1}
	body := must(scene.Add(ball, nil, nil))
	onBody := DefaultModelDesc()
	onBody.Parent = body
	atHead, farOff := Place(Vec(0, 0, 3)), Place(Vec(0, 0, 10))
	must(scene.Add(ball, &atHead, &onBody))
	target := must(scene.Add(ball, &farOff, nil))
	filter := DefaultQueryFilterDesc()
	filter.IgnoredModel, filter.Flags = body, FilterSubtree
	ray, segment, way := Ray{Vec3{}, Vec(0, 0, 1), infinity}, Segment{Vec3{}, Vec(0, 0, 20)}, Vec(0, 0, 20)
	moving, large := Sphere{Radius: 0.5}, Sphere{Radius: 50}
	same(t, found(scene.RaycastFiltered(ray, nil)).Model, body)
	same(t, found(scene.RaycastFiltered(ray, &filter)).Model, target)
	same(t, found(scene.SegmentTestFiltered(segment, &filter)).Model, target)
	same(t, found(scene.NearestFiltered(Vec3{}, infinity, &filter)).Model, target)
	same(t, found(scene.SweepSphereFiltered(moving, way, &filter)).Model, target)
	same(t, must(scene.RaycastAnyFiltered(ray, &filter)), true)
	same(t, len(must(scene.RaycastAllFiltered(ray, &filter))), 1)
	same(t, must(scene.OverlapFiltered(large, &filter)), []ModelID{target})
	hits, any, nearest := make([]Hit, 2), make([]int32, 2), make([]Nearest, 2)
	try(t, scene.RaycastFilteredBatch([]Ray{ray, ray}, one(filter), hits))
	same(t, hits[1].Model, target)
	try(t, scene.SegmentTestFilteredBatch([]Segment{segment, segment}, one(filter), hits))
	same(t, hits[1].Model, target)
	try(t, scene.SweepSphereFilteredBatch([]Sphere{moving, moving}, []Vec3{way, way}, one(filter), hits))
	same(t, hits[1].Model, target)
	try(t, scene.NearestFilteredBatch([]Vec3{way, way}, infinity, one(filter), nearest))
	same(t, nearest[1].Model, target)
	try(t, scene.RaycastAnyFilteredBatch([]Ray{ray, ray}, one(filter), any))
	distances := make([]Distance, 2)
	try(t, scene.RaycastDistanceFilteredBatch([]Ray{ray, ray}, one(filter), distances))
	same(t, distances[1].Model, target)
	same(t, any, []int32{1, 1})
	same(t, len(must(scene.RaycastAllFilteredBatch([]Ray{ray, ray}, one(filter))).At(1)), 1)
	same(t, must(scene.OverlapFilteredBatch(Spheres{large, large}, one(filter))).At(1), []ModelID{target})
	camera := must(NewCamera(nil))
	try(t, camera.LookAt(Vec(0, 0, -10), Vec3{}, up))
	same(t, found(camera.PickFiltered(scene, 400, 300, &filter)).Model, target)
	try(t, camera.PickFilteredBatch(scene, [][2]float32{{400, 300}, {1, 1}}, one(filter), hits))
	same(t, []ModelID{hits[0].Model, hits[1].Model}, []ModelID{target, 0})
	same(t, must(camera.PickRectangleFiltered(scene, 0, 0, 800, 600, &filter)), []ModelID{target})
	same(t, must(camera.CullFiltered(scene, &filter)), []ModelID{target})
	same(t, must(scene.CullFiltered(must(camera.Frustum()), &filter)), []ModelID{target})
	views := []Frustum{must(camera.Frustum()), must(camera.Frustum())}
	same(t, len(must(scene.CullBatch(views, AllLayers)).At(1)), 3)
	same(t, must(scene.CullFilteredBatch(views, one(filter))).At(1), []ModelID{target})
}

func TestSolidsMoveUpToWhatTheyTouchAndOutOfWhatTheyOverlap(t *testing.T) {
	scene, ball := must(NewScene(nil)), Sphere{Radius: 1}
	same(t, found(Sweep(ball, Sphere{Vec(0, 4, 0), 1}, Vec(0, -4, 0))).T, float32(0.5))
	same(t, found(ShapePenetration(ball, Sphere{Vec(0, 0, 1.5), 1})).Depth, float32(0.5))
	must(scene.Add(ball, nil, nil))
	farOff := Place(Vec(0, 0, 10))
	target := must(scene.Add(ball, &farOff, nil))
	filter := DefaultQueryFilterDesc()
	filter.IgnoredModel = target
	moving, deep, way, hits := Sphere{Vec(0, 0, 5), 1}, Sphere{Vec(0, 0, 8.5), 1}, Vec(0, 0, 6), make([]Hit, 2)
	same(t, found(scene.Sweep(moving, way, AllLayers)).Model, target)
	_, met, err := scene.SweepFiltered(moving, way, &filter)
	same(t, []any{met, err}, []any{false, nil})
	try(t, scene.SweepBatch(Spheres{moving, moving}, []Vec3{way}, AllLayers, hits))
	same(t, hits[1].Model, target)
	try(t, scene.SweepFilteredBatch(Spheres{moving, moving}, []Vec3{way}, one(filter), hits))
	same(t, hits[1].Model, ModelID(0))
	same(t, must(scene.Penetration(deep, AllLayers))[0].Depth, float32(0.5))
	same(t, len(must(scene.PenetrationFiltered(deep, &filter))), 0)
	crowd, above, inside := Spheres{deep, moving}, Sphere{Vec(0, 4, 0), 1}, Sphere{Vec(0, 0, 1.5), 1}
	waysOut := must(scene.PenetrationBatch(crowd, AllLayers))
	same(t, []int{len(waysOut.At(0)), len(waysOut.At(1))}, []int{1, 0})
	same(t, waysOut.At(0)[0].Model, target)
	same(t, len(must(scene.PenetrationFilteredBatch(crowd, one(filter))).At(0)), 0)
	try(t, SweepBatch(ball, Spheres{above, inside}, []Vec3{Vec(0, -4, 0)}, hits))
	same(t, []float32{hits[0].T, hits[1].T}, []float32{0.5, 0})
	outs := make([]Penetration, 2)
	try(t, PenetrationBatch(ball, Spheres{inside, above}, outs))
	same(t, []float32{outs[0].Depth, outs[1].Depth}, []float32{0.5, -infinity})
}

func TestShapesChangeAndTreesAndCamerasAreRead(t *testing.T) {
	scene := must(NewScene(nil))
	body := must(scene.Add(Sphere{Radius: 1}, nil, nil))
	onBody := DefaultModelDesc()
	onBody.Parent = body
	head := must(scene.Add(Sphere{Radius: 1}, nil, &onBody))
	try(t, scene.SetShape(body, Sphere{Radius: 5}))
	same(t, found(scene.Bounds(body)).Max.X, float32(5))
	try(t, scene.SetScale(body, Vec3{2, 2, 2}))
	same(t, found(scene.Bounds(body)).Max.X, float32(10))
	same(t, must(scene.Scale(body)), Vec3{2, 2, 2})
	same(t, must(scene.Roots()), []ModelID{body})
	same(t, must(scene.Children(body)), []ModelID{head})
	camera := must(NewCamera(nil))
	try(t, camera.SetOrthographic(10, 1, 100))
	try(t, camera.SetViewport(200, 100))
	kind, size, from, to, err := camera.Projection()
	same(t, []any{kind, size, from, to, err}, []any{ProjectionOrthographic, float32(10), float32(1), float32(100), nil})
	width, height, err := camera.Viewport()
	same(t, []any{width, height, err}, []any{float32(200), float32(100), nil})
}

func TestCamerasSeeByAspectInAWindowFromTheNearPlaneOn(t *testing.T) {
	camera := must(NewCamera(nil))
	try(t, camera.SetPerspectiveAspect(1, 2, 1, 100))
	aspect, fixed, err := camera.Aspect()
	same(t, []any{aspect, fixed, err}, []any{float32(2), true, nil})
	handedness, depthRange, reverseZ, err := camera.Conventions()
	same(t, []any{handedness, depthRange, reverseZ, err}, []any{LeftHanded, DepthZeroToOne, false, nil})
	try(t, camera.SetOrthographicSize(8, 6, 1, 100))
	width, height, err := camera.ImageSize()
	same(t, []any{width, height, err}, []any{float32(8), float32(6), nil})
	try(t, camera.SetViewportOrigin(800, 0))
	x, y, err := camera.ViewportOrigin()
	same(t, []any{x, y, err}, []any{float32(800), float32(0), nil})
	try(t, camera.SetPerspective(1, 1, 100))
	same(t, found(camera.PickRay(1200, 300)).Origin.Z, float32(1))
	try(t, camera.SetPickStart(PickFromCentre))
	same(t, must(camera.PickStart()), PickFromCentre)
	same(t, found(camera.PickRay(1200, 300)).Origin.Z, float32(0))
	view := must(camera.ViewMatrix())
	try(t, camera.SetViewMatrix(view))
	same(t, must(Mat4Orthonormality(view)), float32(0))
	same(t, found(camera.RectangleCorners(800, 0, 1600, 600)), found(camera.Corners()))
	same(t, must(camera.RectangleFrustum(800, 0, 1200, 600)).Origin, Vec3{})
	try(t, camera.SetOrbit(DefaultOrbit()))
	speeds := OrbitSpeeds{RotateX: 0.5, RotateY: 1, Zoom: 2, PanX: 3, PanY: 4}
	try(t, camera.SetOrbitSpeeds(speeds))
	same(t, must(camera.OrbitSpeeds()), speeds)
	x1, y2, z3 := Plane{Vec(1, 0, 0), 1}, Plane{up, 2}, Plane{Vec(0, 0, 1), 3}
	same(t, found(PlanesIntersection(x1, y2, z3)), Vec(1, 2, 3))
	points := make([]Vec3, 2)
	try(t, PlanesIntersectionBatch([]Plane{x1, x1}, []Plane{y2, y2}, []Plane{z3, y2}, points))
	same(t, points, []Vec3{Vec(1, 2, 3), Vec(infinity, infinity, infinity)})
}

func TestAMeshDeformsAndItsModelsWithIt(t *testing.T) {
	desc := DefaultMeshDesc()
	desc.Deformable = 1
	mesh := must(NewMesh([]Vec3{{}, {1, 0, 0}, {0, 1, 0}}, []uint32{0, 1, 2}, &desc))
	scene := must(NewScene(nil))
	model := must(scene.Add(mesh, nil, nil))
	try(t, mesh.SetVertices([]Vec3{{0, 0, 7}, {1, 0, 7}, {0, 1, 7}}))
	hit := found(scene.Raycast(Ray{Vec(0.2, 0.2, 0), Vec(0, 0, 1), infinity}, AllLayers))
	same(t, []any{hit.Model, hit.T}, []any{model, float32(7)})
	same(t, must(mesh.Info()).Deformable, int32(1))
	// The mesh of a restored scene, met from behind, or not.
	copied := must(NewScene(nil))
	try(t, copied.Restore(nil, must(scene.Snapshot(true))))
	info := must(must(NewMeshFromScene(copied, model)).Info())
	same(t, []any{info.Kind, info.VertexCount, info.TriangleCount}, []any{MeshSurface, uint32(3), uint32(1)})
	fromBehind, filter := Ray{Vec(0.2, 0.2, 0), Vec(0, 0, 1), infinity}, DefaultQueryFilterDesc()
	filter.Flags = FilterNoFrontFaces
	same(t, found(copied.RaycastFiltered(fromBehind, &filter)).Flags, HitBack)
	filter.Flags = FilterNoBackFaces
	_, met, err := copied.RaycastFiltered(fromBehind, &filter)
	same(t, []any{met, err}, []any{false, nil})
}

func TestAHullIsASolidMesh(t *testing.T) {
	hull := must(NewMeshHull([]Vec3{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0.1, 0.1, 0.1}}, nil))
	same(t, len(must(hull.Vertices())), 4)
	same(t, len(must(hull.HullPlanes())), 4)
	same(t, must(hull.HullFaces()), []uint32{0, 1, 2, 3})
}

func TestARopeIsPickedAsAModelThatFollowsIt(t *testing.T) {
	solver := must(NewSolver(nil))
	rope := must(solver.AddRope([]Vec3{{}, {1, 0, 0}, {2, 0, 0}}, 0, nil))
	scene := must(NewScene(nil))
	model := must(scene.Add(must(NewMeshFromBody(solver, rope, nil)), nil, nil))
	try(t, solver.SetPositions(rope, 0, []Vec3{{0, 0, 7}, {1, 0, 7}, {2, 0, 7}}))
	hit := found(scene.Raycast(Ray{Vec(1.8, 0, 0), Vec(0, 0, 1), infinity}, AllLayers))
	same(t, []any{hit.Model, hit.Triangle}, []any{model, uint32(1)})
	same(t, must(solver.NearestParticle(rope, hit.Triangle, hit.Point)), uint32(2))
}

func TestLengthsMustAgree(t *testing.T) {
	scene, models := sceneOfBalls()
	refused(t, ErrInvalidArgument, scene.RaycastBatch(someRays(), AllLayers, make([]Hit, 3)))
	refused(t, ErrInvalidArgument, scene.SweepSphereBatch(make([]Sphere, 2), make([]Vec3, 3), AllLayers, make([]Hit, 2)))
	refused(t, ErrInvalidArgument, scene.SetTransforms(models[:1], make([]Transform, 3)))
	refused(t, ErrInvalidArgument, scene.Transforms(models, make([]Transform, 2)))
	refused(t, ErrInvalidArgument, scene.AddBatch(make(Spheres, 3), make([]Transform, 2), nil, make([]ModelID, 3)))
	try(t, scene.RaycastBatch(nil, AllLayers, nil))
	try(t, scene.RaycastBatch(someRays()[:1], AllLayers, make([]Hit, 1)))
}

func TestListsHaveAnyLength(t *testing.T) {
	scene, models := must(NewScene(nil)), make([]ModelID, 500)
	try(t, scene.AddBatch(Sphere{Radius: 1}, make500Places(), nil, models))
	same(t, must(scene.Models()), models)
	boxes := AABBs{{Vec(-1, -1, -1), Vec(1, 1, 1)}, {Vec(5, 5, 5), Vec(6, 6, 6)}, {Vec(0, 0, 0), Vec(1, 1, 1)}}
	lists := must(scene.OverlapBatch(boxes, AllLayers))
	same(t, lists.Offsets, []uint32{0, 500, 500, 1000})
	same(t, lists.At(2), models)
	same(t, len(must(scene.RaycastAll(Ray{Vec(0, 0, -5), Vec(0, 0, 1), infinity}, AllLayers))), 500)
	same(t, len(must(must(NewScene(nil)).Models())), 0)
}

func make500Places() []Transform {
	places := make([]Transform, 500)
	for i := range places {
		places[i] = Place(Vec3{})
	}
	return places
}

func TestModelsAreMovedDescribedAndRemoved(t *testing.T) {
	settings := DefaultSceneDesc()
	settings.WorkerCount = 2
	scene := must(NewScene(&settings))
	capsule := Capsule{B: up, Radius: 0.25}
	parent := must(scene.Add(capsule, nil, nil))
	desc := DefaultModelDesc()
	desc.Parent, desc.Layers, desc.Tag = parent, 2, 7
	aside := Place(Vec(2, 0, 0))
	child := must(scene.Add(AABB{Max: Vec(1, 1, 1)}, &aside, &desc))
	same(t, must(scene.Info(child)), ModelInfo{ShapeAABB, parent, 2, 7, 0})
	same(t, must(scene.Shape(parent)), Shape(capsule))
	try(t, scene.SetTransform(parent, Place(Vec(0, 5, 0))))
	both, places := []ModelID{parent, child}, make([]Transform, 2)
	try(t, scene.Transforms(both, places))
	same(t, []float32{places[0].Position.Y, places[1].Position.Y}, []float32{5, 0})
	try(t, scene.WorldTransforms(both, places))
	same(t, places[1].Position, Vec(2, 5, 0))
	same(t, found(scene.Bounds(child)).Min, Vec(2, 5, 0))
	same(t, found(scene.SceneBounds()).Max, Vec(3, 6.25, 1))
	try(t, scene.SetParent(child, 0, true))
	refused(t, ErrCycle, scene.SetParent(child, child, false))
	try(t, scene.SetTransforms(both, []Transform{Place(Vec3{})}))
	try(t, scene.SetLayers(child, 4))
	try(t, scene.SetTag(child, 8))
	down := Ray{Vec(0.5, 9, 0.5), Vec(0, -1, 0), infinity}
	same(t, found(scene.Raycast(down, 4)).Tag, uint32(8))
	_, seen, err := scene.Raycast(down, 2)
	same(t, []any{seen, err}, []any{false, nil})
	same(t, must(scene.Cull(must(must(NewCamera(nil)).Frustum()), AllLayers)), both)
	try(t, scene.SetOrigin([3]float64{1e9 + 0.5, 0, 0}))
	same(t, must(scene.Origin()), [3]float64{1e9 + 0.5, 0, 0})
	same(t, must(scene.OctreeStats()).ItemCount, uint32(2))
	same(t, len(must(scene.OctreeBoxes())) > 0, true)
	try(t, scene.Validate())
	mesh := must(scene.Add(tetrahedron(), nil, nil))
	_, err = scene.Shape(mesh)
	refused(t, ErrUnsupported, err)
	try(t, scene.Remove(child))
	same(t, []bool{scene.Has(child), scene.Has(parent)}, []bool{false, true})
	try(t, scene.RemoveSubtree(parent))
	try(t, scene.RemoveBatch([]ModelID{mesh}))
	must(scene.Add(capsule, nil, nil))
	try(t, scene.RebuildOctree())
	if done, err := scene.MaintainOctree(1000); err != nil || !done {
		t.Error(done, err)
	}
	try(t, scene.SetWorkerCount(2))
	same(t, must(scene.WorkerCount()), uint32(2))
	try(t, scene.Clear())
	same(t, len(must(scene.Models())), 0)
}
