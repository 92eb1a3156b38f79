//! A lidar that turns on a vehicle: a million rays a frame, shared by two threads that read one scene.
//!
//! lidar [frames] [columns]: 64 beams for each column, 15625 columns are a million rays.
use gamephys::*;
use std::time::Instant;

const BEAMS: usize = 64;
const RANGE: f32 = 120.0;

fn main() -> Result<()> {
    let arguments: Vec<usize> = std::env::args().skip(1).map(|word| word.parse().expect("a number")).collect();
    let frames = *arguments.first().unwrap_or(&3);
    let columns = *arguments.get(1).unwrap_or(&15625);

    // A street: ground, and houses and posts to both sides.
    let mut scene = Scene::new(None)?;
    scene.add(&Plane::new([0.0, 1.0, 0.0], 0.0), None, None)?;
    let mut models = vec![0; 40];
    let side = |i: usize| if i % 2 == 0 { -1.0 } else { 1.0 };
    let houses: Vec<_> = (0..40)
        .map(|i| {
            Aabb::new(
                [14.0 * side(i) - 5.0, 0.0, 5.0 * i as f32 - 100.0],
                [14.0 * side(i) + 5.0, 6.0, 5.0 * i as f32 - 92.0],
            )
        })
        .collect();
    scene.add_batch(&houses, Batch::none(), None, &mut models)?;
    let posts: Vec<_> = (0..40)
        .map(|i| {
            Capsule::new(
                [7.0 * side(i), 0.0, 5.0 * i as f32 - 100.0],
                [7.0 * side(i), 6.0, 5.0 * i as f32 - 100.0],
                0.15,
            )
        })
        .collect();
    scene.add_batch(&posts, Batch::none(), None, &mut models)?;

    let mut rays = vec![Ray::default(); columns * BEAMS];
    for (i, ray) in rays.iter_mut().enumerate() {
        let turn = (i / BEAMS) as f32 / columns as f32 * std::f32::consts::TAU;
        let tilt = -0.43 + 0.46 * (i % BEAMS) as f32 / (BEAMS - 1) as f32;
        *ray = Ray::new([0.0; 3], [turn.cos() * tilt.cos(), tilt.sin(), turn.sin() * tilt.cos()], RANGE);
    }
    let mut hits = vec![Hit::default(); rays.len()]; // filled again by every frame
    for frame in 0..frames {
        for ray in &mut rays {
            ray.origin = [0.0, 1.8, 0.5 * frame as f32].into(); // the vehicle drives on
        }
        let start = Instant::now();
        let half = rays.len() / 2;
        let (first, second) = hits.split_at_mut(half);
        std::thread::scope(|scope| {
            let other = scope.spawn(|| scene.raycast_batch(&rays[half..], ALL_LAYERS, second));
            scene.raycast_batch(&rays[..half], ALL_LAYERS, first)?;
            other.join().expect("a thread that does not panic")
        })?;
        let elapsed = start.elapsed();
        let seen = hits.iter().filter(|hit| hit.model != 0).count();
        println!("frame {frame}: {} rays in {} ms, {seen} points", rays.len(), elapsed.as_millis());
        for (ray, hit) in rays.iter().zip(&hits).filter(|(_, hit)| hit.model != 0) {
            let end = ray.origin.y + ray.direction.y * hit.t;
            assert!(hit.t <= RANGE && (end - hit.point.y).abs() < 1e-4);
        }
        assert!(seen > rays.len() / 2 && seen < rays.len());
    }
    Ok(())
}
