//! The camera and the solver.
mod common;
use common::{scene_of_balls, tetrahedron};
use gamephys::*;

#[test]
fn a_camera_projects_and_picks() {
    let (scene, models) = scene_of_balls();
    let desc = CameraDesc { viewport_width: 640.0, viewport_height: 480.0, ..Default::default() };
    let mut camera = Camera::new(Some(&desc)).unwrap();
    camera.look_at([0.0, 0.0, -9.0], [0.0; 3], [0.0, 1.0, 0.0]).unwrap();
    let points = [[0.0; 3], [1.0, 1.0, 3.0], [0.0, 0.0, -20.0]];
    let mut pixels = [Vec3::default(); 3];
    camera.project_batch(&points, &mut pixels).unwrap();
    assert_eq!(camera.project(points[1]).unwrap(), Some(pixels[1]));
    assert_eq!(camera.project(points[2]).unwrap(), None);
    assert_eq!((pixels[0].x, pixels[0].y), (320.0, 240.0));
    let mut back = [Vec3::default(); 2];
    camera.unproject_batch(&pixels[..2], &mut back).unwrap();
    assert_eq!(camera.unproject(pixels[1]).unwrap(), Some(back[1]));
    assert!((back[1].z - 3.0).abs() < 1e-3);

    let mut rays = vec![Ray::default(); 16 * 12];
    camera.pick_rays(312, 234, 16, 12, &mut rays).unwrap();
    assert_eq!(Some(rays[0]), camera.pick_ray(312.5, 234.5).unwrap());
    assert!(camera.pick_rays(312, 234, 16, 11, &mut rays).is_err());
    let places: Vec<[f32; 2]> = (0..64).map(|i| [10.0 * i as f32, 7.5 * i as f32]).collect();
    let mut hits = vec![Hit::default(); places.len()];
    camera.pick_batch(&scene, &places, ALL_LAYERS, &mut hits).unwrap();
    for ([x, y], hit) in places.iter().zip(&hits) {
        assert_eq!(camera.pick(&scene, *x, *y, ALL_LAYERS).unwrap().map_or(0, |hit| hit.model), hit.model);
    }
    assert!(hits.iter().any(|hit| models.contains(&hit.model)));
    assert_eq!(camera.cull(&scene, ALL_LAYERS).unwrap().len(), 30);
    assert!(camera.pick_rectangle(&scene, 0.0, 0.0, 320.0, 480.0, ALL_LAYERS).unwrap().len() < 30);
}

#[test]
fn a_camera_is_placed_and_set() {
    let mut camera = Camera::new(None).unwrap();
    let half_turn = Quat::new(0.0, 1.0, 0.0, 0.0);
    camera.set_transform([1.0, 2.0, 3.0], half_turn).unwrap();
    assert_eq!(camera.get_transform().unwrap(), (Vec3::new(1.0, 2.0, 3.0), half_turn));
    let world = camera.get_world_matrix().unwrap();
    assert_eq!((world.m[0], world.m[13]), (-1.0, 2.0));
    camera.set_world_matrix(&Mat4::default()).unwrap();
    assert_eq!(camera.get_view_matrix().unwrap(), Mat4::default());
    camera.set_perspective(1.0, 0.5, f32::INFINITY).unwrap();
    assert_eq!(camera.get_corners().unwrap(), None);
    camera.set_orthographic(2.0, 0.0, 10.0).unwrap();
    camera.set_viewport(200.0, 100.0).unwrap();
    let projection = camera.get_projection_matrix().unwrap();
    assert_eq!((projection.m[0], projection.m[5]), (0.5, 1.0));
    camera.set_projection(&projection).unwrap();
    assert_eq!(camera.get_view_projection_matrix().unwrap(), projection);
    assert_eq!(camera.get_frustum().unwrap().planes.len(), 6);
    assert_eq!(camera.get_corners().unwrap().unwrap()[6], Vec3::new(2.0, 1.0, 10.0));
    assert_eq!(camera.set_projection(&Mat4 { m: [0.0; 16] }).unwrap_err().status, Status::ERROR_SINGULAR);
    camera.set_origin(&[0.0, 1e7, 0.0]).unwrap();
    assert_eq!(camera.get_origin().unwrap()[1], 1e7);
}

#[test]
fn a_camera_orbits() {
    let mut camera = Camera::new(None).unwrap();
    assert_eq!(camera.get_orbit().unwrap_err().status, Status::ERROR_UNSUPPORTED);
    camera.set_orbit(&Orbit { radians_per_unit: 0.5, ..Default::default() }).unwrap();
    camera.orbit_rotate(1.0, -1.0).unwrap();
    camera.orbit_zoom(4.0).unwrap();
    camera.orbit_pan(1.0, 0.0).unwrap();
    camera.orbit_update().unwrap();
    let orbit = camera.get_orbit().unwrap();
    assert_eq!((orbit.yaw, orbit.pitch, orbit.distance), (0.5, -0.5, 6.0));
    assert_eq!(orbit.target.x, 1.0);
}

#[test]
fn bodies_are_made_moved_and_removed() {
    let mut solver = Solver::new(Some(&SolverDesc { substeps: 4, ..Default::default() })).unwrap();
    solver.set_substeps(8).unwrap();
    solver.set_gravity([0.0, -10.0, 0.0]).unwrap();
    let body = solver.add_particles(&[[0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 3.0]], None).unwrap();
    solver.set_positions(body, 1, &[[0.0, 1.0, 2.0]]).unwrap();
    solver.set_velocities(body, 0, &[[1.0, 0.0, 0.0]; 3]).unwrap();
    solver.set_masses(body, 2, &[4.0]).unwrap();
    solver.set_radii(body, 0, &[0.1, 0.1]).unwrap();
    solver.set_forces(body, 2, &[[0.0, 40.0, 0.0]]).unwrap();
    solver.set_pinned(body, 0, 1, true).unwrap();
    solver.step(None, 0.1).unwrap();
    let (mut positions, mut velocities, mut masses) = ([Vec3::default(); 3], [Vec3::default(); 3], [0.0; 3]);
    solver.get_positions(body, 0, &mut positions).unwrap();
    solver.get_velocities(body, 0, &mut velocities).unwrap();
    solver.get_masses(body, 0, &mut masses).unwrap();
    assert_eq!((positions[0].x, velocities[0].x, masses[2]), (0.0, 0.0, 4.0));
    assert!((positions[1].y - 0.95).abs() < 1e-5 && (velocities[1].y + 1.0).abs() < 1e-5);
    assert!((positions[2].x - 0.1).abs() < 1e-6 && positions[2].y.abs() < 1e-5);
    assert!(solver.get_positions(body, 1, &mut positions).is_err());

    let cloth = solver
        .add_cloth_mesh(&tetrahedron(), Some(&Transform::new([9.0, 0.0, 0.0], Quat::default(), 1.0)), None)
        .unwrap();
    let info = solver.get_body_info(cloth).unwrap();
    assert_eq!((info.kind, info.particle_count, info.triangle_count), (BodyKind::CLOTH, 4, 4));
    assert_eq!(solver.get_triangles(cloth).unwrap().len(), 12);
    let link = solver.add_distance(body, 1, 2, -1.0, 0.0).unwrap();
    assert_eq!(solver.get_constraints(body).unwrap()[0].id, link);
    solver.remove_constraint(body, link).unwrap();
    assert_eq!(solver.get_stats(body).unwrap().constraint_count, 0);
    assert_eq!(solver.get_bodies().unwrap(), [body, cloth]);
    solver.remove_body(cloth).unwrap();
    assert_eq!(solver.get_body_info(cloth).unwrap_err().status, Status::ERROR_INVALID_ID);
    solver.set_origin(&[5.0, 0.0, 0.0]).unwrap();
    assert_eq!(solver.get_origin().unwrap(), [5.0, 0.0, 0.0]);
}

#[test]
fn bodies_meet_and_follow_models() {
    let mut scene = Scene::new(None).unwrap();
    let ground = scene.add(&Plane::new([0.0, 1.0, 0.0], 0.0), None, None).unwrap();
    let hook = scene.add(&Sphere::new([0.0, 5.0, 0.0], 0.1), None, None).unwrap();
    let mut solver = Solver::new(None).unwrap();
    let desc = BodyDesc { layers: 1, radius: 0.1, ..Default::default() };
    let drop = solver.add_particles(&[[3.0, 0.2, 0.0]], Some(&desc)).unwrap();
    let rope =
        solver.add_rope(&[[0.0, 5.0, 0.0], [0.0, 4.5, 0.0]], 0.0, Some(&BodyDesc { layers: 0, ..desc })).unwrap();
    solver.add_cloth([0.0, 9.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 3, 3, None).unwrap();
    solver.attach(&scene, rope, 0, hook, None).unwrap();
    for _ in 0..30 {
        let (steps, leftover) = solver.advance(Some(&scene), 1.0 / 60.0).unwrap();
        assert!(steps <= 2 && (0.0..1.0).contains(&leftover));
    }
    let contacts = solver.get_contacts().unwrap();
    assert!(contacts.iter().any(|c| c.body == drop && c.model == ground && c.normal.y == 1.0), "{contacts:?}");
    scene.set_transform(hook, &Transform::new([2.0, 0.0, 0.0], Quat::default(), 1.0)).unwrap();
    solver.step(Some(&scene), 0.01).unwrap();
    let mut end = [Vec3::default()];
    solver.get_positions(rope, 0, &mut end).unwrap();
    assert!((end[0].x - 2.0).abs() < 1e-5);
    solver.detach(rope, 0).unwrap();
    assert_eq!(solver.detach(rope, 0).unwrap_err().status, Status::ERROR_INVALID_ARGUMENT);
}

#[test]
fn a_solver_goes_on_from_a_snapshot() {
    let (mut solver, mut twin) = (Solver::new(None).unwrap(), Solver::new(None).unwrap());
    let body = solver.add_cloth([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 10, 10, None).unwrap();
    solver.set_pinned(body, 0, 1, true).unwrap();
    solver.step(None, 0.01).unwrap();
    let snapshot = solver.get_snapshot().unwrap();
    assert_eq!(twin.restore(&snapshot[1..]).unwrap_err().status, Status::ERROR_INVALID_ARGUMENT);
    twin.restore(&snapshot).unwrap();
    let mut place = Scene::new(None).unwrap();
    place.add(&Sphere::new([0.0, 1.0, 0.0], 1.0), None, None).unwrap();
    let mut copy = Scene::new(None).unwrap();
    copy.restore(None, &place.get_snapshot(true).unwrap()).unwrap();
    assert_eq!(copy.get_hash().unwrap(), place.get_hash().unwrap());
    copy.restore(Some(&place), &place.get_snapshot(false).unwrap()).unwrap();
    assert_eq!(copy.get_models().unwrap(), place.get_models().unwrap());
    assert_eq!(twin.get_hash().unwrap(), solver.get_hash().unwrap());
    solver.step(None, 0.01).unwrap();
    assert_ne!(twin.get_hash().unwrap(), solver.get_hash().unwrap());
    twin.step(None, 0.01).unwrap();
    assert_eq!(twin.get_snapshot().unwrap(), solver.get_snapshot().unwrap());
    twin.wake(body).unwrap();
    assert!(twin.get_sleeping().unwrap().is_empty());
}

#[test]
fn substeps_are_as_many_as_asked_for_or_as_a_target_takes() {
    let substeps = |max_strain| {
        let mut solver = Solver::new(Some(&SolverDesc { max_strain, ..Default::default() })).unwrap();
        let cloth = solver.add_cloth([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 3, 3, None).unwrap();
        solver.set_pinned(cloth, 0, 1, true).unwrap();
        assert_eq!(solver.get_substeps(cloth).unwrap(), 0);
        (0..5).for_each(|_| solver.step(None, 0.01).unwrap());
        solver.get_substeps(cloth).unwrap()
    };
    assert_eq!(substeps(0.0), 8);
    assert!(substeps(1e-6) > 8);
}

#[test]
fn a_string_holds_a_weight_and_a_tetrahedron_keeps_its_volume() {
    let (mut scene, mut solver) = (Scene::new(None).unwrap(), Solver::new(None).unwrap());
    let tagged = ModelDesc { tag: 5, ..Default::default() };
    let hook = scene.add(&Sphere::new([0.0; 3], 0.1), None, Some(&tagged)).unwrap();
    let desc = BodyDesc { mass: 2.0, layers: 0, ..Default::default() };
    let weights = solver.add_particles(&[[0.0; 3], [0.0, -1.0, 0.0]], Some(&desc)).unwrap();
    solver.attach(&scene, weights, 0, hook, Some(&[0.0; 3].into())).unwrap();
    let string = solver.add_max_distance(weights, 0, 1, 2.0, 1e-6).unwrap();
    solver.set_constraint_damping(weights, string, 50.0).unwrap();
    let mut kinds = [ConstraintKind::default()];
    solver.get_constraint_kinds(weights, &[string], &mut kinds).unwrap();
    assert_eq!(kinds, [ConstraintKind::MAX_DISTANCE]);
    assert_eq!(solver.get_attachments(weights).unwrap()[0].model, hook);
    (0..300).for_each(|_| solver.step(Some(&scene), 0.01).unwrap());
    let mut end = [Vec3::default()];
    solver.get_positions(weights, 1, &mut end).unwrap();
    assert!((end[0].y + 2.0).abs() < 1e-3);
    let impulses = solver.get_impulses().unwrap();
    assert_eq!(impulses.iter().map(|i| (i.model, i.tag)).collect::<Vec<_>>(), [(hook, 5)]);
    assert!((impulses[0].linear.y + 2.0 * 9.81 * 0.01).abs() < 5e-3);
    let ball = solver.add_cloth_mesh(&tetrahedron(), None, None).unwrap();
    solver.set_volume(ball, -1.0, 0.0).unwrap();
    let (volume, pressure) = solver.get_volume(ball).unwrap();
    assert!((volume - 1.0 / 6.0).abs() < 1e-6 && pressure == 0.0);
    assert_eq!(solver.get_volume_settings(ball).unwrap(), (volume, 0.0));
    solver.set_volume(ball, 1.0, f32::INFINITY).unwrap();
    assert_eq!(solver.get_volume(ball).unwrap_err().status, Status::ERROR_UNSUPPORTED);
}

#[test]
fn settings_change_live() {
    let mut solver = Solver::new(None).unwrap();
    let mut settings = solver.get_settings().unwrap();
    settings.substeps = 5;
    solver.set_settings(&settings).unwrap();
    assert_eq!(solver.get_settings().unwrap().substeps, 5);
    solver.set_worker_count(2).unwrap();
    assert_eq!((solver.get_worker_count().unwrap(), solver.get_leftover().unwrap()), (2, 0.0));
    let rope = solver.add_rope(&[[0.0; 3], [0.0, -1.0, 0.0]], 0.0, None).unwrap();
    solver.set_pinned(rope, 0, 1, true).unwrap();
    let mut pinned = [7; 2];
    solver.get_pinned(rope, 0, &mut pinned).unwrap();
    assert_eq!(pinned, [1, 0]);
    let mut body = solver.get_body_settings(rope).unwrap();
    body.damping = 0.5;
    solver.set_body_settings(rope, &body).unwrap();
    assert_eq!(solver.get_body_settings(rope).unwrap().damping, 0.5);
    let links = [solver.get_constraints(rope).unwrap()[0].id];
    let mut link = [ConstraintSettings::default()];
    solver.get_constraint_settings(rope, &links, &mut link).unwrap();
    link[0].rest_length = 0.5;
    solver.set_constraint_settings(rope, &links, &link).unwrap();
    let (mut radii, mut vectors) = ([0.0f32; 2], [Vec3::default(); 2]);
    solver.get_radii(rope, 0, &mut radii).unwrap();
    solver.get_forces(rope, 0, &mut vectors).unwrap();
    assert!(radii[1] == 0.01 && vectors[1].y == 0.0);
    (0..10).for_each(|_| solver.step(None, 0.01).unwrap());
    solver.get_positions(rope, 0, &mut vectors).unwrap();
    assert!((vectors[1].y + 0.5).abs() < 1e-5);
}

#[test]
fn wind_carries_balls_along() {
    let desc = SolverDesc { gravity: [0.0; 3].into(), ..Default::default() };
    let mut solver = Solver::new(Some(&desc)).unwrap();
    let balls = solver.add_particles(&[[0.0; 3], [1.0, 0.0, 0.0]], None).unwrap();
    solver.set_wind(balls, &Wind { velocity: [2.0, 0.0, 0.0].into(), density: 1e4, drag: 0.5, lift: 0.0 }).unwrap();
    assert_eq!(solver.get_wind(balls).unwrap().density, 1e4);
    solver.set_air_velocities(balls, 1, &[[0.0, 3.0, 0.0]]).unwrap();
    let mut vectors = [Vec3::default(); 2];
    solver.get_air_velocities(balls, 0, &mut vectors).unwrap();
    assert!(vectors[0].y == 0.0 && vectors[1].y == 3.0);
    (0..500).for_each(|_| solver.step(None, 0.01).unwrap());
    solver.get_velocities(balls, 0, &mut vectors).unwrap();
    assert!(vectors[0].x > 1.8 && vectors[1].y > 2.7);
}

#[test]
fn a_cluster_holds_out_a_particle_until_it_ends() {
    let mut solver = Solver::new(None).unwrap();
    let plank = solver.add_particles(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], None).unwrap();
    solver.set_pinned(plank, 0, 2, true).unwrap();
    let cluster = solver.add_cluster(plank, &[0, 1, 2]).unwrap();
    assert_eq!(solver.get_clusters(plank).unwrap(), [cluster]);
    assert_eq!(solver.get_cluster_particles(plank, cluster).unwrap(), [0, 1, 2]);
    let mut places = [Vec3::default(); 1];
    (0..30).for_each(|_| solver.step(None, 0.01).unwrap());
    solver.get_positions(plank, 2, &mut places).unwrap();
    assert!((places[0].x - 2.0).abs() < 1e-5 && places[0].y.abs() < 1e-5);
    solver.remove_cluster(plank, cluster).unwrap();
    (0..30).for_each(|_| solver.step(None, 0.01).unwrap());
    solver.get_positions(plank, 2, &mut places).unwrap();
    assert!(places[0].y < -0.4);
    assert_eq!(solver.remove_cluster(plank, cluster).unwrap_err().status, Status::ERROR_INVALID_ID);
}

#[test]
fn a_rope_breaks_under_its_weight_and_cloth_is_cut() {
    let mut solver = Solver::new(None).unwrap();
    let rope = solver.add_rope(&[[0.0, 0.0, 0.0], [0.0, -1.0, 0.0]], 0.0, None).unwrap();
    solver.set_pinned(rope, 0, 1, true).unwrap();
    let links = [solver.get_constraints(rope).unwrap()[0].id];
    solver.set_breaking_forces(rope, &links, &[3.0f32]).unwrap();
    let mut forces = [0.0f32];
    solver.get_breaking_forces(rope, &links, &mut forces).unwrap();
    assert_eq!(forces, [3.0]);
    assert!(solver.get_breaks().unwrap().is_empty());
    for _ in 0..10 {
        if solver.get_breaks().unwrap().is_empty() {
            solver.step(None, 0.01).unwrap();
        }
    }
    let breaks = solver.get_breaks().unwrap();
    assert_eq!(breaks.len(), 1);
    assert!(breaks[0].body == rope && breaks[0].constraint == links[0] && breaks[0].load > 3.0);
    assert_eq!(breaks[0].torn_particle, NO_PARTICLE);
    assert_eq!(solver.break_constraint(rope, links[0]).unwrap_err().status, Status::ERROR_INVALID_ID);
    let sheet = solver.add_cloth([0.0; 3], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0], 3, 3, None).unwrap();
    let second = solver.get_constraints(sheet).unwrap()[1].id;
    assert_eq!(solver.break_constraint(sheet, second).unwrap().new_particle, 9);
}

#[test]
fn one_of_two_balls_slides_over_ice() {
    let mut solver = Solver::new(None).unwrap();
    let mut scene = Scene::new(None).unwrap();
    scene.add(&Plane::new([0.0, 1.0, 0.0], 0.0), None, None).unwrap();
    let balls = solver.add_particles(&[[0.0, 0.01, 0.0], [0.0, 0.01, 1.0]], None).unwrap();
    solver.set_friction_factors(balls, 1, &[0.0]).unwrap();
    let mut factors = [0.5; 2];
    solver.get_friction_factors(balls, 0, &mut factors).unwrap();
    assert_eq!(factors, [1.0, 0.0]);
    solver.set_velocities(balls, 0, &[[1.0, 0.0, 0.0], [1.0, 0.0, 0.0]]).unwrap();
    (0..50).for_each(|_| solver.step(Some(&scene), 0.01).unwrap());
    let mut speeds = [Vec3::default(); 2];
    solver.get_velocities(balls, 0, &mut speeds).unwrap();
    assert!(speeds[0].x == 0.0 && (speeds[1].x - 1.0).abs() < 1e-5);
}

#[test]
fn a_ball_presses_the_one_that_it_lies_on() {
    let mut solver = Solver::new(None).unwrap();
    let desc = BodyDesc { mass: 2.0, radius: 0.5, body_layers: 1, ..Default::default() };
    let lower = solver.add_particles(&[[0.0; 3]], Some(&desc)).unwrap();
    let upper = solver.add_particles(&[[0.0, 1.0, 0.0]], Some(&desc)).unwrap();
    solver.set_pinned(lower, 0, 1, true).unwrap();
    (0..20).for_each(|_| solver.step(None, 0.01).unwrap());
    let contacts = solver.get_body_contacts().unwrap();
    assert_eq!(contacts.len(), 1);
    let contact = &contacts[0];
    assert!(contact.body_a == lower && contact.body_b == upper && contact.normal.y == 1.0);
    assert!((contact.impulse - 0.1962).abs() < 2e-3);
}

#[test]
fn a_ball_hangs_below_its_animation_target() {
    let mut solver = Solver::new(None).unwrap();
    let balls = solver.add_particles(&[[0.0; 3], [1.0, 0.0, 0.0]], None).unwrap();
    let mut targets = [AnimationTarget::default(); 2];
    solver.get_animation_targets(balls, 0, &mut targets).unwrap();
    assert_eq!(targets[1].max_distance, f32::INFINITY);
    targets[1].position = [1.0, 0.0, 0.0].into();
    targets[1].max_distance = 0.25;
    solver.set_animation_targets(balls, 0, &targets).unwrap();
    (0..60).for_each(|_| solver.step(None, 0.01).unwrap());
    let mut at = [Vec3::default()];
    solver.get_positions(balls, 1, &mut at).unwrap();
    assert_eq!(at[0].y, -0.25);
}

#[test]
fn a_joint_holds_a_particle_of_another_body() {
    let mut solver = Solver::new(None).unwrap();
    let desc = BodyDesc { mass: 2.0, ..Default::default() };
    let nail = solver.add_particles(&[[0.0; 3]], Some(&desc)).unwrap();
    let weight = solver.add_particles(&[[0.0, -1.0, 0.0]], Some(&desc)).unwrap();
    solver.set_pinned(nail, 0, 1, true).unwrap();
    let joint = solver.join(nail, 0, weight, 0, -1.0, 0.0).unwrap();
    (0..20).for_each(|_| solver.step(None, 0.01).unwrap());
    let joints = solver.get_joints(weight).unwrap();
    assert_eq!(joints.iter().map(|j| (j.id, j.body_a, j.body_b)).collect::<Vec<_>>(), [(joint, nail, weight)]);
    assert!((joints[0].force - 2.0 * 9.81).abs() < 0.01);
    solver.unjoin(joint).unwrap();
    assert!(solver.get_joints(0).unwrap().is_empty());
    assert_eq!(solver.unjoin(joint).unwrap_err().status, Status::ERROR_INVALID_ID);
}

#[test]
fn the_version_is_that_of_the_header() {
    assert_eq!(version().0, 1);
}
