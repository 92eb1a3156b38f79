// A rope with a weight, and a cloth that falls over a ball.
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

func main() {
	scene, err := gamephys.NewScene(nil)
	try(err)
	defer scene.Close()
	_, err = scene.Add(gamephys.Plane{Normal: gamephys.Vec(0, 1, 0)}, nil, nil)
	try(err)
	_, err = scene.Add(gamephys.Sphere{Center: gamephys.Vec(0, 1, 0), Radius: 1}, nil, nil)
	try(err)
	solver, err := gamephys.NewSolver(nil)
	try(err)
	defer solver.Close()

	desc := gamephys.DefaultBodyDesc()
	desc.Damping = 2
	line := make([]gamephys.Vec3, 41)
	for i := range line {
		line[i] = gamephys.Vec(5+0.05*float32(i), 3, 0)
	}
	rope, err := solver.AddRope(line, 0, &desc)
	try(err)
	try(solver.SetPinned(rope, 0, 1, true))
	try(solver.SetMasses(rope, 40, []float32{5}))
	desc.Radius = 0.02
	desc.ClothFlags = gamephys.ClothBend
	cloth, err := solver.AddCloth(gamephys.Vec(-1.5, 3, -1.5), gamephys.Vec(3, 0, 0), gamephys.Vec(0, 0, 3), 31, 31, &desc)
	try(err)
	for frame := 0; frame < 360; frame++ {
		_, _, err := solver.Advance(scene, 1.0/60)
		try(err)
	}

	info, err := solver.BodyInfo(cloth)
	try(err)
	positions := make([]gamephys.Vec3, info.ParticleCount)
	try(solver.Positions(cloth, 0, positions)) // into the caller's memory
	height := math.Inf(1)
	for _, p := range positions {
		x, y, z := float64(p.X), float64(p.Y)-1, float64(p.Z)
		height = math.Min(height, math.Sqrt(x*x+y*y+z*z)-1)
	}
	try(solver.Positions(rope, 0, line))
	fmt.Printf("weight %.3f m below the nail, cloth %.4f m above the ball\n", 3-line[40].Y, height)
	if line[40].Y >= 1.02 || height < 0.015 || height > 0.03 {
		log.Fatal("they hang elsewhere")
	}
}
