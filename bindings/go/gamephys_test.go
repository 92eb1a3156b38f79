package gamephys

import (
	"errors"
	"fmt"
	"gamephys/internal/ration"
	"io"
	"math"
	"os"
	"reflect"
	"runtime"
	"strings"
	"sync"
	"testing"
	"time"
)

var infinity = float32(math.Inf(1))

// must is the value of a call that does not fail.
func must[T any](value T, err error) T {
	if err != nil {
		panic(err)
	}
	return value
}

// found is the answer of a question that finds something.
func found[T any](value T, found bool, err error) T {
	if err != nil || !found {
		panic(fmt.Sprint("nothing found: ", err))
	}
	return value
}

func try(t *testing.T, err error) {
	t.Helper()
	if err != nil {
		t.Fatal(err)
	}
}

func same(t *testing.T, got, wanted any) {
	t.Helper()
	if !reflect.DeepEqual(got, wanted) {
		t.Fatalf("got %v, wanted %v", got, wanted)
	}
}

func refused(t *testing.T, kind Status, err error) {
	t.Helper()
	if !errors.Is(err, kind) {
		t.Fatalf("got %v, wanted %v", err, kind)
	}
}

// 30 balls on a spiral, and their ids.
func sceneOfBalls() (*Scene, []ModelID) {
	balls := make(Spheres, 30)
	for i := range balls {
		x := float64(i)
		balls[i] = Sphere{Vec(float32(3*math.Sin(x)), float32(3*math.Cos(2*x)), float32(x/3)), 0.7}
	}
	scene, models := must(NewScene(nil)), make([]ModelID, len(balls))
	if err := scene.AddBatch(balls, nil, nil, models); err != nil {
		panic(err)
	}
	return scene, models
}

// 200 rays, some of which meet a ball.
func someRays() []Ray {
	rays := make([]Ray, 200)
	for i := range rays {
		x := float64(i)
		rays[i] = Ray{Vec(0, 0, -5), Vec(float32(math.Sin(x)/2), float32(math.Cos(3*x)/2), 1), infinity}
	}
	return rays
}

func tetrahedron() *Mesh {
	desc := DefaultMeshDesc()
	return must(NewMesh([]Vec3{{}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, []uint32{0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}, &desc))
}

func TestErrorsCarryTheMessageOfTheLibrary(t *testing.T) {
	scene := must(NewScene(nil))
	_, err := scene.Add(Sphere{Radius: -1}, nil, nil)
	refused(t, ErrInvalidArgument, err)
	var failed *Error
	if !errors.As(err, &failed) || !strings.Contains(failed.Message, "radius") {
		t.Fatal(err)
	}
	refused(t, ErrInvalidID, scene.Remove(12345))
	_, err = scene.Add(nil, nil, nil)
	refused(t, ErrInvalidArgument, err)
	_, err = scene.Add(Sphere{}, nil, &ModelDesc{})
	refused(t, ErrStructSize, err)
	same(t, ErrCycle.Error(), "GPHYS_ERROR_CYCLE")
	if _, err = NewMesh([]Vec3{{}}, []uint32{0, 1, 7}, nil); err == nil {
		t.Fatal("a mesh with an index out of range")
	}
	// The message comes from the thread that made the call, wherever the goroutine goes on.
	var group sync.WaitGroup
	for i := 0; i < 64; i++ {
		group.Add(1)
		go func(i int) {
			defer group.Done()
			for n := 0; n < 200; n++ {
				var err error
				wanted := "radius"
				if i%2 == 0 {
					wanted = "direction"
					_, _, err = Raycast(Sphere{Radius: 1}, Ray{TMax: 1})
				} else {
					err = Validate(Sphere{Radius: -1})
				}
				if !strings.Contains(err.Error(), wanted) {
					t.Error(err)
				}
			}
		}(i)
	}
	group.Wait()
}

func TestUseAfterCloseIsAnError(t *testing.T) {
	scene, mesh, camera, solver := must(NewScene(nil)), tetrahedron(), must(NewCamera(nil)), must(NewSolver(nil))
	try(t, scene.Close())
	try(t, scene.Close())
	try(t, mesh.Close())
	try(t, camera.Close())
	_, listed := scene.Models()
	_, added := must(NewScene(nil)).Add(mesh, nil, nil)
	_, _, cast := Raycast(mesh, Ray{Direction: Vec(0, 0, 1)})
	_, _, picked := camera.Pick(must(NewScene(nil)), 1, 1, AllLayers)
	_, _, closed := must(NewCamera(nil)).Pick(scene, 1, 1, AllLayers)
	_, none := (*Scene)(nil).Models()
	stepped := solver.Step(scene, 0.01)
	for _, err := range []error{listed, added, cast, picked, closed, none, stepped, scene.Clear()} {
		if err != ErrClosed {
			t.Fatal(err)
		}
	}
	if scene.Has(1) {
		t.Fatal("a closed scene has models")
	}
	try(t, solver.Step(nil, 0.01))
}

// A scene with two workers has a thread of its own, which shows whether the scene is there.
func TestObjectsAreFreedWhenNothingRefersToThem(t *testing.T) {
	threads := func() int {
		tasks, err := os.ReadDir("/proc/self/task")
		if err != nil {
			t.Skip("threads are not listed here")
		}
		return len(tasks)
	}
	desc := DefaultSceneDesc()
	desc.WorkerCount = 2
	scenes := make([]*Scene, 100)
	for i := range scenes {
		scenes[i] = must(NewScene(&desc))
	}
	held := threads()
	runtime.KeepAlive(scenes)
	for wait := 0; threads() > held-90; wait++ {
		if wait == 1000 {
			t.Fatal(held, "threads were", threads(), "are")
		}
		runtime.GC()
		time.Sleep(time.Millisecond)
	}
}

func TestAMeshLivesAsLongAsItsModels(t *testing.T) {
	scene, mesh := must(NewScene(nil)), tetrahedron()
	must(scene.Add(mesh, nil, nil))
	try(t, mesh.Close())
	same(t, found(scene.Raycast(Ray{Vec(0.2, 0.2, -1), Vec(0, 0, 1), infinity}, AllLayers)).T, float32(1))
}

func TestSingleCallsAllocateNothing(t *testing.T) {
	scene, _ := sceneOfBalls()
	camera, rays := must(NewCamera(nil)), someRays()
	hits := make([]Hit, len(rays))
	same(t, testing.AllocsPerRun(100, func() {
		found(scene.Raycast(Ray{Vec(0, 0, -5), Vec(0, 3, 5), infinity}, AllLayers))
		must(camera.Origin())
		scene.RaycastBatch(rays, AllLayers, hits)
	}), 0.0)
}

func TestGoroutinesMayAskAtOnce(t *testing.T) {
	scene, _ := sceneOfBalls()
	rays := someRays()
	expected, results := make([]Hit, len(rays)), make([][]Hit, 8)
	try(t, scene.RaycastBatch(rays, AllLayers, expected))
	var group sync.WaitGroup
	for i := range results {
		results[i] = make([]Hit, len(rays))
		group.Add(1)
		go func(hits []Hit) {
			defer group.Done()
			for n := 0; n < 20; n++ {
				if err := scene.RaycastBatch(rays, AllLayers, hits); err != nil {
					t.Error(err)
				}
			}
		}(results[i])
	}
	group.Wait()
	for _, hits := range results {
		same(t, hits, expected)
	}
}

func TestTheVersionIsThatOfTheHeader(t *testing.T) {
	major, _, _ := Version()
	same(t, major, VersionMajor)
}

func Example() {
	scene, err := NewScene(nil)
	if err != nil {
		return
	}
	defer scene.Close()
	ball, err := scene.Add(Sphere{Center: Vec(0, 0, 5), Radius: 1}, nil, nil)
	if err != nil {
		return
	}
	hit, found, err := scene.Raycast(Ray{Direction: Vec(0, 0, 1), TMax: 100}, AllLayers)
	fmt.Println(found, hit.Model == ball, hit.T, err)
	// Output: true true 4 <nil>
}

func TestRunningOutOfMemoryIsAnErrorAndLeaksNothing(t *testing.T) {
	memory := ration.New()
	defer memory.Free()
	desc := DefaultSceneDesc()
	desc.Allocator = memory.Allocator()
	refusals, complete := 0, false
	for allowed := 0; !complete; allowed += 2000 {
		memory.Allow(allowed)
		scene, err := NewScene(&desc)
		if err != nil {
			refused(t, ErrOutOfMemory, err)
			refusals++
			continue
		}
		made := 0
		for ; made < 50; made++ {
			if _, err = scene.Add(Sphere{Radius: 1}, nil, nil); err != nil {
				refused(t, ErrOutOfMemory, err)
				refusals++
				break
			}
		}
		complete = made == 50
		same(t, len(must(scene.Models())), made)
		memory.Allow(1 << 30)
		try(t, scene.Validate())
		try(t, scene.Close())
		same(t, memory.Held(), 0)
	}
	same(t, refusals > 1, true)
}

func TestEveryKindOfObjectGivesItsMemoryBack(t *testing.T) {
	memory := ration.New()
	defer memory.Free()
	memory.Allow(1 << 30)
	meshes, scenes, cameras, solvers := DefaultMeshDesc(), DefaultSceneDesc(), DefaultCameraDesc(), DefaultSolverDesc()
	meshes.Allocator, scenes.Allocator = memory.Allocator(), memory.Allocator()
	cameras.Allocator, solvers.Allocator = memory.Allocator(), memory.Allocator()
	for _, object := range []io.Closer{
		must(NewMesh([]Vec3{{}, {}, {}}, []uint32{0, 1, 2}, &meshes)), must(NewScene(&scenes)),
		must(NewCamera(&cameras)), must(NewSolver(&solvers)),
	} {
		held := memory.Held()
		try(t, object.Close())
		same(t, memory.Held() < held, true)
	}
	same(t, memory.Held(), 0)
}
