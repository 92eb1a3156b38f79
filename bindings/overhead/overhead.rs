//! Rust: overhead [milliseconds a case]
use gamephys::{Camera, Hit, Ray, Result, Scene, Sphere, ALL_LAYERS};
use std::time::{Duration, Instant};

const RAYS: usize = 1000;

fn measure(
    name: &str,
    items: usize,
    budget: Duration,
    mut call: impl FnMut() -> Result<()>,
) -> Result<()> {
    let (begin, mut best, mut calls) = (Instant::now(), f64::INFINITY, 1u32);
    while begin.elapsed() < budget || best == f64::INFINITY {
        let start = Instant::now();
        for _ in 0..calls {
            call()?;
        }
        let elapsed = start.elapsed().as_secs_f64();
        if elapsed < 1e-3 {
            calls *= 2;
        } else {
            best = best.min(elapsed / f64::from(calls));
        }
    }
    println!("rust,{name},{:.2}", 1e9 * best / items as f64);
    Ok(())
}

fn main() -> Result<()> {
    let milliseconds = std::env::args()
        .nth(1)
        .map_or(200, |word| word.parse().expect("milliseconds"));
    let budget = Duration::from_millis(milliseconds);
    let (mut scene, camera) = (Scene::new(None)?, Camera::new(None)?);
    let model = scene.add(&Sphere::new([0.0, 0.0, 5.0], 1.0), None, None)?;
    let ray = Ray::new([0.0; 3], [0.0, 0.0, 1.0], 100.0);
    let rays = vec![ray; RAYS];
    let mut hits = vec![Hit::default(); RAYS];
    scene.raycast_batch(&rays, ALL_LAYERS, &mut hits)?;
    assert!(scene.raycast(&ray, ALL_LAYERS)?.expect("a hit").t == 4.0 && hits[RAYS - 1].t == 4.0);
    measure("scalar", 1, budget, || {
        assert!(scene.has(model));
        Ok(())
    })?;
    measure("vec3", 1, budget, || camera.get_origin().map(drop))?;
    measure("raycast", 1, budget, || {
        scene.raycast(&ray, ALL_LAYERS).map(drop)
    })?;
    measure("raycast_batch", RAYS, budget, || {
        scene.raycast_batch(&rays, ALL_LAYERS, &mut hits)
    })
}
