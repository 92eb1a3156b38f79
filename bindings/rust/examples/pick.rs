//! What a camera sees: culling, picking, marquee, orbit.
use gamephys::*;

fn main() -> Result<()> {
    let mut scene = Scene::new(None)?;
    let places = [[-4.0, 0.0, 9.0], [0.0, 0.0, 9.0], [4.0, 0.0, 9.0], [0.0, 0.0, -50.0]];
    let mut balls = [0; 4];
    scene.add_batch(&places.map(|place| Sphere::new(place, 1.5)), Batch::none(), None, &mut balls)?;
    let desc = CameraDesc { viewport_width: 640.0, viewport_height: 320.0, ..Default::default() };
    let mut camera = Camera::new(Some(&desc))?;
    camera.set_perspective(0.7, 0.1, 100.0)?;
    let orbit = Orbit { target: [0.0, 0.0, 9.0].into(), distance: 8.0, radians_per_unit: 0.01, ..Default::default() };
    camera.set_orbit(&orbit)?;
    assert_eq!(camera.cull(&scene, ALL_LAYERS)?.len(), 3);
    let pixel = camera.project(places[0])?.expect("a ball in front of the camera");
    assert_eq!(camera.pick(&scene, pixel.x, pixel.y, ALL_LAYERS)?.expect("the ball there").model, balls[0]);
    assert_eq!(camera.pick_rectangle(&scene, 340.0, 0.0, 640.0, 320.0, ALL_LAYERS)?.len(), 2);
    camera.orbit_rotate(157.0796, 0.0)?;
    camera.orbit_update()?;
    let behind = scene.raycast_all(&camera.pick_ray(320.0, 160.0)?.expect("a ray"), ALL_LAYERS)?;
    println!("after a quarter turn {} balls stand behind one another", behind.len());
    assert!(behind.len() == 3 && behind[1].model == balls[1]);
    Ok(())
}
