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
	try(t, scene.Clear())
	same(t, len(must(scene.Models())), 0)
}
