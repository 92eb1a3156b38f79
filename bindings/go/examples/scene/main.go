// A scene and questions to it, one by one and in a batch.
package main

import (
	"fmt"
	"log"
	"math"

	"gamephys"
)

func try(err error) {
	if err != nil {
		log.Fatal(err)
	}
}

func expect(condition bool, what string) {
	if !condition {
		log.Fatal("not so: ", what)
	}
}

func main() {
	scene, err := gamephys.NewScene(nil)
	try(err)
	defer scene.Close()
	ground, err := scene.Add(gamephys.Plane{Normal: gamephys.Vec(0, 1, 0)}, nil, nil)
	try(err)

	// A row of 100 pyramids that share one mesh, which they keep alive.
	corners := []gamephys.Vec3{
		gamephys.Vec(-1, 0, -1), gamephys.Vec(1, 0, -1), gamephys.Vec(1, 0, 1), gamephys.Vec(-1, 0, 1), gamephys.Vec(0, 2, 0),
	}
	mesh, err := gamephys.NewMesh(corners, []uint32{0, 1, 2, 0, 2, 3, 1, 0, 4, 2, 1, 4, 3, 2, 4, 0, 3, 4}, nil)
	try(err)
	report, err := mesh.Report()
	try(err)
	expect(report.OpenEdgeCount == 0, "the pyramid is closed")
	places := make([]gamephys.Transform, 100)
	for i := range places {
		places[i] = gamephys.Place(gamephys.Vec(5*float32(i), 0, 10))
	}
	pyramids := make([]gamephys.ModelID, len(places))
	try(scene.AddBatch(mesh, places, nil, pyramids))
	mesh.Close()

	infinity := float32(math.Inf(1))
	ray := gamephys.Ray{Origin: gamephys.Vec(25, 1, 0), Direction: gamephys.Vec(0, 0, 1), TMax: infinity}
	hit, found, err := scene.Raycast(ray, gamephys.AllLayers)
	try(err)
	fmt.Printf("ray: a pyramid, triangle %d, %.3f m away\n", hit.Triangle, hit.T)
	expect(found && hit.Model == pyramids[5] && math.Abs(float64(hit.T)-9.5) < 1e-6, "the sixth pyramid is hit")
	ray.Direction = gamephys.Vec(0, 1, 0)
	_, found, err = scene.Raycast(ray, gamephys.AllLayers)
	try(err)
	expect(!found, "nothing is above")
	box := gamephys.AABB{Min: gamephys.Vec(-1, 0.5, 8), Max: gamephys.Vec(21, 1, 12)}
	inside, err := scene.Overlap(box, gamephys.AllLayers)
	try(err)
	expect(len(inside) == 5, "five pyramids reach into the box")
	nearest, _, err := scene.Nearest(gamephys.Vec(0, 10, -50), infinity, gamephys.AllLayers)
	try(err)
	expect(nearest.Model == ground, "the ground is nearest")

	// One call for 1000 rays that look down.
	rays := make([]gamephys.Ray, 1000)
	for i := range rays {
		rays[i] = gamephys.Ray{Origin: gamephys.Vec(0.5*float32(i), 5, 10), Direction: gamephys.Vec(0, -1, 0), TMax: 10}
	}
	hits := make([]gamephys.Hit, len(rays))
	try(scene.RaycastBatch(rays, gamephys.AllLayers, hits))
	above := 0
	for _, hit := range hits {
		if hit.T < 5 {
			above++
		}
	}
	fmt.Println(above, "of 1000 rays end on a pyramid")
	expect(above == 299, "299 rays end on a pyramid")
}
