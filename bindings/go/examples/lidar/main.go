// A lidar that turns on a vehicle: a million rays a frame, shared by goroutines that read one scene.
//
// lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
package main

import (
	"fmt"
	"log"
	"math"
	"os"
	"runtime"
	"strconv"
	"sync"
	"time"

	"gamephys"
)

const (
	beams = 64
	reach = 120
)

func try(err error) {
	if err != nil {
		log.Fatal(err)
	}
}

func argument(i, otherwise int) int {
	if len(os.Args) <= i {
		return otherwise
	}
	number, err := strconv.Atoi(os.Args[i])
	try(err)
	return number
}

// street has ground, and houses and posts to both sides.
func street() *gamephys.Scene {
	scene, err := gamephys.NewScene(nil)
	try(err)
	_, err = scene.Add(gamephys.Plane{Normal: gamephys.Vec(0, 1, 0)}, nil, nil)
	try(err)
	houses, posts := make(gamephys.AABBs, 40), make(gamephys.Capsules, 40)
	for i := range houses {
		side, z := float32(1-2*(i%2)), 5*float32(i)-100
		houses[i] = gamephys.AABB{Min: gamephys.Vec(14*side-5, 0, z), Max: gamephys.Vec(14*side+5, 6, z+8)}
		posts[i] = gamephys.Capsule{A: gamephys.Vec(7*side, 0, z), B: gamephys.Vec(7*side, 6, z), Radius: 0.15}
	}
	models := make([]gamephys.ModelID, 40)
	try(scene.AddBatch(houses, nil, nil, models))
	try(scene.AddBatch(posts, nil, nil, models))
	return scene
}

func main() {
	frames, columns := argument(1, 3), argument(2, 15625)
	scene := street()
	defer scene.Close()
	rays := make([]gamephys.Ray, columns*beams)
	for i := range rays {
		turn := float64(i/beams) / float64(columns) * 2 * math.Pi
		tilt := -0.43 + 0.46*float64(i%beams)/(beams-1)
		x, y, z := math.Cos(turn)*math.Cos(tilt), math.Sin(tilt), math.Sin(turn)*math.Cos(tilt)
		rays[i] = gamephys.Ray{Direction: gamephys.Vec(float32(x), float32(y), float32(z)), TMax: reach}
	}
	hits := make([]gamephys.Hit, len(rays)) // filled again by every frame
	workers := runtime.NumCPU()
	for frame := 0; frame < frames; frame++ {
		for i := range rays {
			rays[i].Origin = gamephys.Vec(0, 1.8, 0.5*float32(frame)) // the vehicle drives on
		}
		start := time.Now()
		var group sync.WaitGroup
		for worker := 0; worker < workers; worker++ {
			from, to := worker*len(rays)/workers, (worker+1)*len(rays)/workers
			group.Add(1)
			go func() {
				defer group.Done()
				try(scene.RaycastBatch(rays[from:to], gamephys.AllLayers, hits[from:to]))
			}()
		}
		group.Wait()
		elapsed := time.Since(start)
		seen := 0
		for i, hit := range hits {
			if hit.Model == 0 {
				continue
			}
			seen++
			end := rays[i].Origin.Y + rays[i].Direction.Y*hit.T
			if hit.T > reach || math.Abs(float64(end-hit.Point.Y)) > 1e-4 {
				log.Fatalf("ray %d ends at %v after %v", i, hit.Point, hit.T)
			}
		}
		fmt.Printf("frame %d: %d rays in %d ms, %d points\n", frame, len(rays), elapsed.Milliseconds(), seen)
		if seen <= len(rays)/2 || seen == len(rays) {
			log.Fatal("this is no street")
		}
	}
}
