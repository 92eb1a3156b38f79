// Go: overhead [milliseconds a case]
package main

import (
	"fmt"
	"log"
	"math"
	"os"
	"strconv"
	"time"

	"gamephys"
)

const rayCount = 1000

func try(err error) {
	if err != nil {
		log.Fatal(err)
	}
}

func measure(name string, items int, budget time.Duration, call func()) {
	begin, best := time.Now(), math.Inf(1)
	for calls := 1; time.Since(begin) < budget || math.IsInf(best, 1); {
		start := time.Now()
		for i := 0; i < calls; i++ {
			call()
		}
		elapsed := time.Since(start)
		if elapsed < time.Millisecond {
			calls *= 2
		} else {
			best = math.Min(best, float64(elapsed.Nanoseconds())/float64(calls))
		}
	}
	fmt.Printf("go,%s,%.2f\n", name, best/float64(items))
}

func main() {
	budget := 200 * time.Millisecond
	if len(os.Args) > 1 {
		milliseconds, err := strconv.Atoi(os.Args[1])
		try(err)
		budget = time.Duration(milliseconds) * time.Millisecond
	}
	scene, err := gamephys.NewScene(nil)
	try(err)
	camera, err := gamephys.NewCamera(nil)
	try(err)
	model, err := scene.Add(gamephys.Sphere{Center: gamephys.Vec(0, 0, 5), Radius: 1}, nil, nil)
	try(err)
	ray := gamephys.Ray{Direction: gamephys.Vec(0, 0, 1), TMax: 100}
	rays, hits := make([]gamephys.Ray, rayCount), make([]gamephys.Hit, rayCount)
	for i := range rays {
		rays[i] = ray
	}
	hit, _, err := scene.Raycast(ray, gamephys.AllLayers)
	try(err)
	try(scene.RaycastBatch(rays, gamephys.AllLayers, hits))
	if hit.T != 4 || hits[rayCount-1].T != 4 {
		log.Fatal("the ray ends elsewhere")
	}
	measure("scalar", 1, budget, func() { scene.Has(model) })
	measure("vec3", 1, budget, func() { camera.Origin() })
	measure("raycast", 1, budget, func() { scene.Raycast(ray, gamephys.AllLayers) })
	measure("raycast_batch", rayCount, budget, func() { scene.RaycastBatch(rays, gamephys.AllLayers, hits) })
}
