//! A rope with a weight, and a cloth that falls over a ball.
use gamephys::*;

fn main() -> Result<()> {
    let mut scene = Scene::new(None)?;
    scene.add(&Plane::new([0.0, 1.0, 0.0], 0.0), None, None)?;
    scene.add(&Sphere::new([0.0, 1.0, 0.0], 1.0), None, None)?;
    let mut solver = Solver::new(None)?;
    let desc = BodyDesc { damping: 2.0, ..Default::default() };
    let mut line: Vec<_> = (0..41).map(|i| Vec3::new(5.0 + 0.05 * i as f32, 3.0, 0.0)).collect();
    let rope = solver.add_rope(&line, 0.0, Some(&desc))?;
    solver.set_pinned(rope, 0, 1, true)?;
    solver.set_masses(rope, 40, &[5.0])?;
    let desc = BodyDesc { radius: 0.02, cloth_flags: CLOTH_BEND, ..desc };
    let cloth = solver.add_cloth([-1.5, 3.0, -1.5], [3.0, 0.0, 0.0], [0.0, 0.0, 3.0], 31, 31, Some(&desc))?;
    for _frame in 0..360 {
        solver.advance(Some(&scene), 1.0 / 60.0)?;
    }

    let mut positions = vec![Vec3::default(); solver.get_body_info(cloth)?.particle_count as usize];
    solver.get_positions(cloth, 0, &mut positions)?; // into the caller's memory
    let heights = positions.iter().map(|p| (p.x * p.x + (p.y - 1.0).powi(2) + p.z * p.z).sqrt() - 1.0);
    let height = heights.fold(f32::INFINITY, f32::min);
    solver.get_positions(rope, 0, &mut line)?;
    println!("weight {:.3} m below the nail, cloth {height:.4} m above the ball", 3.0 - line[40].y);
    assert!(line[40].y < 1.02 && height > 0.015 && height < 0.03);
    Ok(())
}
