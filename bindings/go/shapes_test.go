package gamephys

import (
	"math"
	"testing"
)

var up = Vec(0, 1, 0)

func TestSingleShapesAnswer(t *testing.T) {
	ball := Sphere{Radius: 1}
	try(t, Validate(ball))
	same(t, found(Bounds(ball)), AABB{Vec(-1, -1, -1), Vec(1, 1, 1)})
	_, bounded, err := Bounds(Plane{Normal: up})
	same(t, []any{bounded, err}, []any{false, nil})
	same(t, must(Contains(ball, Vec(0, 0.6, 0.8), 1e-6)), true)
	same(t, found(ClosestPoint(ball, Vec(0, 3, 0))).Distance, float32(2))
	same(t, must(Overlaps(ball, AABB{Vec(0.5, 0.5, 0.5), Vec(1, 1, 1)})), true)
	side, distance, err := ClassifyPlane(ball, Plane{up, -3})
	same(t, []any{side, distance, err}, []any{SideInside, float32(2), nil})
	ray := Ray{Vec(0, 0, -3), Vec(0, 0, 1), 10}
	same(t, found(Raycast(ball, ray)).T, float32(2))
	_, hit, err := Raycast(Sphere{Vec(5, 0, 0), 1}, ray)
	same(t, []any{hit, err}, []any{false, nil})
	same(t, found(SegmentTest(ball, Segment{Vec(0, 0, -3), Vec(0, 0, 1)})).T, float32(0.5))
	same(t, found(SweepSphere(ball, Sphere{Vec(0, 4, 0), 1}, Vec(0, -4, 0))).T, float32(0.5))
	a, b, distance, err := SegmentClosestPoints(Segment{B: up}, Segment{Vec(2, 0.5, -1), Vec(2, 0.5, 1)})
	same(t, []any{a, b, distance, err}, []any{Vec(0, 0.5, 0), Vec(2, 0.5, 0), float32(2), nil})
}

func TestABoxThatIsMovedMayTurn(t *testing.T) {
	moved := must(Transformed(AABB{Max: Vec(2, 2, 2)}, Place(Vec(1, 0, 0))))
	same(t, moved.(OBB).Center, Vec(2, 1, 1))
	same(t, must(Transformed(Sphere{up, 1}, Transform{Rotation: Quat{W: 1}, Scale: 3})), Shape(Sphere{Vec(0, 3, 0), 3}))
	_, err := Transformed(tetrahedron(), Place(up))
	refused(t, ErrUnsupported, err)
}

func TestFrustaComeFromMatrices(t *testing.T) {
	camera := must(NewCamera(nil))
	frustum := must(FrustumFromMatrix(must(camera.ViewProjectionMatrix()), DepthZeroToOne, false))
	known := found(camera.Corners())
	for i, corner := range found(FrustumCorners(frustum)) {
		if math.Abs(float64(corner.X-known[i].X)) > 1e-3*float64(known[i].Z) || math.Abs(float64(corner.Z-known[i].Z)) > 1e-3*float64(known[i].Z) {
			t.Fatal(i, corner, known[i])
		}
	}
	same(t, must(ClassifyFrustum(Sphere{Vec(0, 0, 5), 1}, frustum)), SideInside)
	_, err := FrustumFromMatrix(Mat4{}, DepthZeroToOne, false)
	refused(t, ErrSingular, err)
}

func TestOneShapeAgainstMany(t *testing.T) {
	ball, points := Sphere{Radius: 1}, []Vec3{{}, {2, 0, 0}}
	inside := []int32{7, 7}
	try(t, ContainsBatch(ball, points, 0, inside))
	same(t, inside, []int32{1, 0})
	nearest := make([]Nearest, 2)
	try(t, ClosestPointBatch(ball, points, nearest))
	same(t, nearest[1].Distance, float32(1))
	balls, met := Spheres{{Vec(0, 0, 0), 1}, {Vec(1, 0, 0), 1}, {Vec(2, 0, 0), 1}, {Vec(3, 0, 0), 1}}, make([]int32, 4)
	try(t, OverlapsBatch(balls, Plane{Normal: Vec(1, 0, 0)}, met))
	same(t, met, []int32{1, 1, 0, 0})
	rays, hits := make([]Ray, 3), make([]Hit, 3)
	for i := range rays {
		rays[i] = Ray{Vec(float32(i), 0, -3), Vec(0, 0, 1), 10}
	}
	try(t, RaycastBatch(ball, rays, hits))
	same(t, []float32{hits[0].T, hits[1].T, hits[2].T}, []float32{2, 3, infinity})
}

func TestAMeshIsAShape(t *testing.T) {
	mesh := tetrahedron()
	same(t, must(mesh.Report()).OpenEdgeCount, uint32(0))
	same(t, must(mesh.Vertices())[3], Vec(0, 0, 1))
	same(t, len(must(mesh.Indices())), 12)
	loaded := must(NewMeshFromSnapshot(must(mesh.Snapshot()), nil))
	same(t, must(loaded.Indices())[11], must(mesh.Indices())[11])
	ray := Ray{Vec(0.2, 0.2, -1), Vec(0, 0, 1), 10}
	same(t, found(Raycast(mesh, ray)).T, float32(1))
	same(t, len(must(mesh.RaycastAll(ray))), 2)
	same(t, must(mesh.RaycastAny(ray)), true)
	anyHit, distances := make([]int32, 2), make([]Distance, 2)
	try(t, mesh.RaycastAnyBatch([]Ray{ray, ray}, anyHit))
	try(t, mesh.RaycastDistanceBatch([]Ray{ray, ray}, distances))
	same(t, anyHit[1], int32(1))
	same(t, distances[1].Triangle != NoTriangle, true)
	same(t, must(mesh.Overlap(Sphere{Vec(1, 1, 1), 1.2})), []uint32{3})
	same(t, must(mesh.OctreeStats()).NodeCount, uint32(len(must(mesh.OctreeBoxes()))))
	report := must(MeshCheck([]Vec3{{}, {float32(math.NaN()), 0, 0}}, []uint32{0, 1, 7}))
	same(t, []uint32{report.BadVertexCount, report.FirstBadVertex, report.OutOfRangeCount}, []uint32{1, 1, 1})
}
