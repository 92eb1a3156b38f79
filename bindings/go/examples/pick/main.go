// What a camera sees: culling, picking, marquee, orbit.
package main

import (
	"fmt"
	"log"

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
	places := []gamephys.Vec3{gamephys.Vec(-4, 0, 9), gamephys.Vec(0, 0, 9), gamephys.Vec(4, 0, 9), gamephys.Vec(0, 0, -50)}
	spheres := make(gamephys.Spheres, len(places))
	for i, place := range places {
		spheres[i] = gamephys.Sphere{Center: place, Radius: 1.5}
	}
	balls := make([]gamephys.ModelID, len(spheres))
	try(scene.AddBatch(spheres, nil, nil, balls))
	desc := gamephys.DefaultCameraDesc()
	desc.ViewportWidth, desc.ViewportHeight = 640, 320
	camera, err := gamephys.NewCamera(&desc)
	try(err)
	defer camera.Close()
	try(camera.SetPerspective(0.7, 0.1, 100))
	orbit := gamephys.DefaultOrbit()
	orbit.Target, orbit.Distance, orbit.RadiansPerUnit = gamephys.Vec(0, 0, 9), 8, 0.01
	try(camera.SetOrbit(orbit))

	seen, err := camera.Cull(scene, gamephys.AllLayers)
	try(err)
	expect(len(seen) == 3, "three balls are seen")
	pixel, _, err := camera.Project(places[0])
	try(err)
	hit, found, err := camera.Pick(scene, pixel.X, pixel.Y, gamephys.AllLayers)
	try(err)
	expect(found && hit.Model == balls[0], "the left ball is picked")
	right, err := camera.PickRectangle(scene, 340, 0, 640, 320, gamephys.AllLayers)
	try(err)
	expect(len(right) == 2, "two balls reach into the right half")

	try(camera.OrbitRotate(157.0796, 0))
	try(camera.OrbitUpdate())
	ray, _, err := camera.PickRay(320, 160)
	try(err)
	behind, err := scene.RaycastAll(ray, gamephys.AllLayers)
	try(err)
	fmt.Println("after a quarter turn", len(behind), "balls stand behind one another")
	expect(len(behind) == 3 && behind[1].Model == balls[1], "the middle ball stands between the others")
}
