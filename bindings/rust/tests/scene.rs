//! The scene: batches against single calls, lists, changes, errors, memory, threads.
mod common;
use common::{scene_of_balls, some_rays, tetrahedron};
use gamephys::*;
use std::ffi::c_void;
use std::sync::atomic::{AtomicIsize, AtomicUsize, Ordering};

const FAR: f32 = f32::INFINITY;

#[test]
fn batches_answer_as_single_calls_do() {
    let (scene, _) = scene_of_balls();
    let rays = some_rays();
    let mut hits = vec![Hit::default(); rays.len()];
    scene.raycast_batch(&rays, ALL_LAYERS, &mut hits).unwrap();
    let mut any = vec![0; rays.len()];
    scene.raycast_any_batch(&rays, ALL_LAYERS, &mut any).unwrap();
    let mut distances = vec![Distance::default(); rays.len()];
    scene.raycast_distance_batch(&rays, ALL_LAYERS, &mut distances).unwrap();
    let all = scene.raycast_all_batch(&rays, ALL_LAYERS).unwrap();
    let segments: Vec<_> = rays.iter().map(|r| Segment::new(r.origin, [0.0, 0.0, 5.0])).collect();
    let mut crossed = hits.clone();
    scene.segment_test_batch(&segments, ALL_LAYERS, &mut crossed).unwrap();
    let points: Vec<_> = rays.iter().map(|r| r.direction).collect();
    let mut nearest = vec![Nearest::default(); rays.len()];
    scene.nearest_batch(&points, FAR, ALL_LAYERS, &mut nearest).unwrap();
    let moving: Vec<_> = points.iter().map(|p| Sphere::new(*p, 0.1)).collect();
    let mut swept = hits.clone();
    scene.sweep_sphere_batch(&moving, Batch::one(&Vec3::new(0.0, 0.0, 9.0)), ALL_LAYERS, &mut swept).unwrap();
    let near = scene.overlap_batch(&moving, ALL_LAYERS).unwrap();
    for i in 0..rays.len() {
        let nothing = Hit { t: FAR, triangle: NO_TRIANGLE, ..Default::default() };
        assert_eq!(scene.raycast(&rays[i], ALL_LAYERS).unwrap().unwrap_or(nothing), hits[i]);
        assert_eq!(scene.raycast_any(&rays[i], ALL_LAYERS).unwrap(), any[i] != 0);
        assert_eq!((distances[i].t, distances[i].model), (hits[i].t, hits[i].model));
        assert_eq!(scene.raycast_all(&rays[i], ALL_LAYERS).unwrap(), all[i]);
        assert_eq!(scene.segment_test(&segments[i], ALL_LAYERS).unwrap().unwrap_or(nothing), crossed[i]);
        assert_eq!(scene.nearest(points[i], FAR, ALL_LAYERS).unwrap().unwrap(), nearest[i]);
        assert_eq!(scene.sweep_sphere(&moving[i], [0.0, 0.0, 9.0], ALL_LAYERS).unwrap().unwrap_or(nothing), swept[i]);
        assert_eq!(scene.overlap(&moving[i], ALL_LAYERS).unwrap(), near[i]);
    }
    let met = hits.iter().filter(|hit| hit.model != 0).count();
    assert!(met > 0 && met < rays.len());
}

#[test]
fn models_with_descs_of_their_own() {
    let mut scene = Scene::new(None).unwrap();
    let balls = [Sphere::new([0.0; 3], 1.0); 3];
    let root = scene.add(&balls[0], None, None).unwrap();
    let plain = ModelDesc::default();
    let some = [ModelDesc { parent: root, layers: 2, tag: 5, ..plain }, ModelDesc { tag: 6, ..plain }, plain];
    let known = [(root, 2, 5), (0, 1, 6), (0, 1, 0)];
    let read_back = |scene: &Scene, models: [ModelId; 3]| {
        models.map(|model| scene.get_info(model).unwrap()).map(|info| (info.parent, info.layers, info.tag))
    };
    let mut models = [0; 3];
    scene.add_described_batch(&balls, Batch::none(), &some, &mut models).unwrap();
    assert_eq!(read_back(&scene, models), known);
    scene.add_described_batch(Shapes::one(&balls[0]), Batch::none(), &some, &mut models).unwrap();
    assert_eq!(read_back(&scene, models), known);
    scene.add_described_batch(&balls, Batch::none(), Batch::one(&some[0]), &mut models).unwrap();
    assert_eq!(read_back(&scene, models), [known[0]; 3]);
    scene.add_described_batch(&balls, &[Transform::default(); 3], Batch::none(), &mut models).unwrap();
    assert_eq!(read_back(&scene, models), [known[2]; 3]);
    let count = scene.get_models().unwrap().len();
    let fails = scene.add_described_batch(&balls, Batch::none(), &some[..2], &mut models).unwrap_err();
    assert_eq!(fails.status, Status::ERROR_INVALID_ARGUMENT);
    let stale = [some[0], some[1], ModelDesc { parent: 12345, ..plain }];
    let fails = scene.add_described_batch(&balls, Batch::none(), &stale, &mut models).unwrap_err();
    assert_eq!(fails.status, Status::ERROR_INVALID_ID);
    assert_eq!(scene.get_models().unwrap().len(), count);
}

#[test]
fn filters_have_lists_of_models_and_batches_a_filter_for_each() {
    let mut scene = Scene::new(None).unwrap();
    let mut models = [0; 4];
    for (i, model) in models.iter_mut().enumerate() {
        *model = scene.add(&Sphere::new([0.0, 0.0, 4.0 * i as f32], 1.0), None, None).unwrap();
    }
    let ray = Ray::new([0.0, 0.0, -5.0], [0.0, 0.0, 1.0], FAR);
    let ignoring = |n: usize| QueryFilterDesc { ignored_models: models[..n].into(), ..Default::default() };
    assert_eq!(scene.raycast_filtered(&ray, Some(&ignoring(2))).unwrap().unwrap().model, models[2]);
    assert_eq!(scene.raycast_filtered(&ray, Some(&ignoring(0))).unwrap().unwrap().model, models[0]);
    let large = Sphere::new([0.0; 3], 50.0);
    assert_eq!(scene.overlap_filtered(&large, Some(&ignoring(2))).unwrap(), models[2..]);
    let (rays, mut hits, each) = ([ray; 3], [Hit::default(); 3], [ignoring(0), ignoring(1), ignoring(2)]);
    scene.raycast_filtered_batch(&rays, &each, &mut hits).unwrap();
    assert_eq!(hits.map(|hit| hit.model), models[..3]);
    scene.raycast_filtered_batch(&rays, Batch::one(&each[2]), &mut hits).unwrap();
    assert_eq!(hits.map(|hit| hit.model), [models[2]; 3]);
    scene.raycast_filtered_batch(&rays, Batch::none(), &mut hits).unwrap();
    assert_eq!(hits.map(|hit| hit.model), [models[0]; 3]);
    let near = [Sphere::new([0.0, 0.0, 2.0], 2.0); 3];
    assert_eq!(scene.overlap_filtered_batch(&near, &each).unwrap().offsets, [0, 2, 3, 3]);
    assert!(scene.raycast_filtered_batch(&rays, &each[..2], &mut hits).is_err());
}

#[test]
fn filters_leave_out_models() {
    let mut scene = Scene::new(None).unwrap();
    let ball = Sphere::new([0.0; 3], 1.0);
    let body = scene.add(&ball, None, None).unwrap();
    let on_body = ModelDesc { parent: body, ..Default::default() };
    let place = |z| Transform::new([0.0, 0.0, z], Quat::default(), 1.0);
    scene.add(&ball, Some(&place(3.0)), Some(&on_body)).unwrap();
    let target = scene.add(&ball, Some(&place(10.0)), None).unwrap();
    let filter = QueryFilterDesc { ignored_model: body, flags: FILTER_SUBTREE, ..Default::default() };
    let without = Some(&filter);
    let ray = Ray::new([0.0; 3], [0.0, 0.0, 1.0], FAR);
    let segment = Segment::new([0.0; 3], [0.0, 0.0, 20.0]);
    let (moving, large, way) = (Sphere::new([0.0; 3], 0.5), Sphere::new([0.0; 3], 50.0), Vec3::new(0.0, 0.0, 20.0));
    assert_eq!(scene.raycast_filtered(&ray, None).unwrap().unwrap().model, body);
    assert_eq!(scene.raycast_filtered(&ray, without).unwrap().unwrap().model, target);
    assert_eq!(scene.segment_test_filtered(&segment, without).unwrap().unwrap().model, target);
    assert_eq!(scene.nearest_filtered([0.0; 3], FAR, without).unwrap().unwrap().model, target);
    assert_eq!(scene.sweep_sphere_filtered(&moving, way, without).unwrap().unwrap().model, target);
    assert!(scene.raycast_any_filtered(&ray, without).unwrap());
    assert_eq!(scene.raycast_all_filtered(&ray, without).unwrap().len(), 1);
    assert_eq!(scene.overlap_filtered(&large, without).unwrap(), [target]);
    let (mut hits, mut any, mut nearest) = ([Hit::default(); 2], [0; 2], [Nearest::default(); 2]);
    scene.raycast_filtered_batch(&[ray; 2], Batch::one(&filter), &mut hits).unwrap();
    assert_eq!(hits[1].model, target);
    scene.segment_test_filtered_batch(&[segment; 2], Batch::one(&filter), &mut hits).unwrap();
    assert_eq!(hits[1].model, target);
    scene.sweep_sphere_filtered_batch(&[moving; 2], &[way; 2], Batch::one(&filter), &mut hits).unwrap();
    assert_eq!(hits[1].model, target);
    scene.nearest_filtered_batch(&[way; 2], FAR, Batch::one(&filter), &mut nearest).unwrap();
    assert_eq!(nearest[1].model, target);
    scene.raycast_any_filtered_batch(&[ray; 2], Batch::one(&filter), &mut any).unwrap();
    assert_eq!(any, [1, 1]);
    let mut distances = [Distance::default(); 2];
    scene.raycast_distance_filtered_batch(&[ray; 2], Batch::one(&filter), &mut distances).unwrap();
    assert_eq!(distances[1].model, target);
    assert_eq!(scene.raycast_all_filtered_batch(&[ray; 2], Batch::one(&filter)).unwrap()[1].len(), 1);
    assert_eq!(scene.overlap_filtered_batch(&[large; 2], Batch::one(&filter)).unwrap()[1], [target]);
    let mut camera = Camera::new(None).unwrap();
    camera.look_at([0.0, 0.0, -10.0], [0.0; 3], [0.0, 1.0, 0.0]).unwrap();
    assert_eq!(camera.pick_filtered(&scene, 400.0, 300.0, without).unwrap().unwrap().model, target);
    camera.pick_filtered_batch(&scene, &[[400.0, 300.0], [1.0, 1.0]], Batch::one(&filter), &mut hits).unwrap();
    assert_eq!((hits[0].model, hits[1].model), (target, 0));
    assert_eq!(camera.pick_rectangle_filtered(&scene, 0.0, 0.0, 800.0, 600.0, without).unwrap(), [target]);
    assert_eq!(camera.cull_filtered(&scene, without).unwrap(), [target]);
    assert_eq!(scene.cull_filtered(&camera.get_frustum().unwrap(), without).unwrap(), [target]);
    let views = [camera.get_frustum().unwrap(); 2];
    assert_eq!(scene.cull_batch(&views, ALL_LAYERS).unwrap()[1].len(), 3);
    assert_eq!(scene.cull_filtered_batch(&views, Batch::one(&filter)).unwrap()[1], [target]);
}

#[test]
fn solids_move_up_to_what_they_touch_and_out_of_what_they_overlap() {
    let ball = Sphere::new([0.0; 3], 1.0);
    assert_eq!(sweep(&ball, &Sphere::new([0.0, 4.0, 0.0], 1.0), [0.0, -4.0, 0.0]).unwrap().unwrap().t, 0.5);
    assert_eq!(penetration(&ball, &Sphere::new([0.0, 0.0, 1.5], 1.0)).unwrap().unwrap().depth, 0.5);
    let mut scene = Scene::new(None).unwrap();
    scene.add(&ball, None, None).unwrap();
    let target = scene.add(&ball, Some(&Transform::new([0.0, 0.0, 10.0], Quat::default(), 1.0)), None).unwrap();
    let others = QueryFilterDesc { ignored_model: target, ..Default::default() };
    let (moving, deep) = (Sphere::new([0.0, 0.0, 5.0], 1.0), Sphere::new([0.0, 0.0, 8.5], 1.0));
    let way = Vec3::new(0.0, 0.0, 6.0);
    assert_eq!(scene.sweep(&moving, way, ALL_LAYERS).unwrap().unwrap().model, target);
    assert!(scene.sweep_filtered(&moving, way, Some(&others)).unwrap().is_none());
    let mut hits = [Hit::default(); 2];
    scene.sweep_batch(&[moving; 2], &[way; 2], ALL_LAYERS, &mut hits).unwrap();
    assert_eq!(hits[1].model, target);
    scene.sweep_filtered_batch(&[moving; 2], &[way; 2], Batch::one(&others), &mut hits).unwrap();
    assert_eq!(hits[1].model, 0);
    assert_eq!(scene.penetration(&deep, ALL_LAYERS).unwrap()[0].depth, 0.5);
    assert!(scene.penetration_filtered(&deep, Some(&others)).unwrap().is_empty());
    let ways_out = scene.penetration_batch(&[deep, moving], ALL_LAYERS).unwrap();
    assert_eq!((ways_out[0].len(), ways_out[0][0].model, ways_out[1].len()), (1, target, 0));
    assert!(scene.penetration_filtered_batch(&[deep, moving], Batch::one(&others)).unwrap()[0].is_empty());
    let solids = [Sphere::new([0.0, 4.0, 0.0], 1.0), Sphere::new([0.0, 0.0, 1.5], 1.0)];
    sweep_batch(Shapes::one(&ball), &solids, Batch::one(&Vec3::new(0.0, -4.0, 0.0)), &mut hits).unwrap();
    assert_eq!((hits[0].t, hits[1].t), (0.5, 0.0));
    let mut outs = [Penetration::default(); 2];
    penetration_batch(Shapes::one(&ball), &solids, &mut outs).unwrap();
    assert_eq!((outs[0].depth, outs[1].depth), (f32::NEG_INFINITY, 0.5));
}

#[test]
fn shapes_change_and_trees_and_cameras_are_read() {
    let mut scene = Scene::new(None).unwrap();
    let ball = Sphere::new([0.0; 3], 1.0);
    let body = scene.add(&ball, None, None).unwrap();
    let head = scene.add(&ball, None, Some(&ModelDesc { parent: body, ..Default::default() })).unwrap();
    scene.set_shape(body, &Sphere::new([0.0; 3], 5.0)).unwrap();
    assert_eq!(scene.get_bounds(body).unwrap().unwrap().max.x, 5.0);
    scene.set_scale(body, [2.0; 3]).unwrap();
    assert_eq!(scene.get_bounds(body).unwrap().unwrap().max.x, 10.0);
    assert_eq!(scene.get_scale(body).unwrap().y, 2.0);
    assert_eq!(scene.get_roots().unwrap(), [body]);
    assert_eq!(scene.get_children(body).unwrap(), [head]);
    let mut camera = Camera::new(None).unwrap();
    camera.set_orthographic(10.0, 1.0, 100.0).unwrap();
    camera.set_viewport(200.0, 100.0).unwrap();
    assert_eq!(camera.get_projection().unwrap(), (Projection::ORTHOGRAPHIC, 10.0, 1.0, 100.0));
    assert_eq!(camera.get_viewport().unwrap(), (200.0, 100.0));
}

#[test]
fn cameras_see_by_aspect_in_a_window_from_the_near_plane_on() {
    let mut camera = Camera::new(None).unwrap();
    camera.set_perspective_aspect(1.0, 2.0, 1.0, 100.0).unwrap();
    assert_eq!(camera.get_aspect().unwrap(), (2.0, true));
    assert_eq!(camera.get_conventions().unwrap(), (Handedness::LEFT_HANDED, DepthRange::ZERO_TO_ONE, false));
    camera.set_orthographic_size(8.0, 6.0, 1.0, 100.0).unwrap();
    assert_eq!(camera.get_image_size().unwrap(), (8.0, 6.0));
    camera.set_viewport_origin(800.0, 0.0).unwrap();
    assert_eq!(camera.get_viewport_origin().unwrap(), (800.0, 0.0));
    camera.set_perspective(1.0, 1.0, 100.0).unwrap();
    assert_eq!(camera.pick_ray(1200.0, 300.0).unwrap().unwrap().origin.z, 1.0);
    camera.set_pick_start(PickStart::CENTRE).unwrap();
    assert_eq!(camera.get_pick_start().unwrap(), PickStart::CENTRE);
    assert_eq!(camera.pick_ray(1200.0, 300.0).unwrap().unwrap().origin.z, 0.0);
    let view = camera.get_view_matrix().unwrap();
    camera.set_view_matrix(&view).unwrap();
    assert_eq!(mat4_orthonormality(&view).unwrap(), 0.0);
    let corners = camera.get_rectangle_corners(800.0, 0.0, 1600.0, 600.0).unwrap();
    assert_eq!(corners, camera.get_corners().unwrap());
    assert_eq!(camera.get_rectangle_frustum(800.0, 0.0, 1200.0, 600.0).unwrap().origin.z, 0.0);
    camera.set_orbit(&Orbit::default()).unwrap();
    let speeds = OrbitSpeeds { rotate_x: 0.5, rotate_y: 1.0, zoom: 2.0, pan_x: 3.0, pan_y: 4.0 };
    camera.set_orbit_speeds(&speeds).unwrap();
    assert_eq!(camera.get_orbit_speeds().unwrap(), speeds);
    let plane = |x: f32, y: f32, z: f32, distance: f32| Plane { normal: Vec3 { x, y, z }, distance };
    let (x1, y2, z3) = (plane(1.0, 0.0, 0.0, 1.0), plane(0.0, 1.0, 0.0, 2.0), plane(0.0, 0.0, 1.0, 3.0));
    assert_eq!(planes_intersection(&x1, &y2, &z3).unwrap(), Some(Vec3 { x: 1.0, y: 2.0, z: 3.0 }));
    assert_eq!(planes_intersection(&x1, &y2, &y2).unwrap(), None);
    let mut points = [Vec3::default(); 2];
    planes_intersection_batch(&[x1, x1], &[y2, y2], &[z3, y2], &mut points).unwrap();
    assert_eq!((points[0].z, points[1].z), (3.0, f32::INFINITY));
}

#[test]
fn a_mesh_deforms_and_its_models_with_it() {
    let desc = MeshDesc { deformable: 1, ..Default::default() };
    let mut mesh = Mesh::new(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]], &[0, 1, 2], Some(&desc)).unwrap();
    let mut scene = Scene::new(None).unwrap();
    let model = scene.add(&mesh, None, None).unwrap();
    // Nobody else has the scene.
    unsafe { mesh.set_vertices(&[[0.0, 0.0, 7.0], [1.0, 0.0, 7.0], [0.0, 1.0, 7.0]]) }.unwrap();
    assert!((scene.get_bounds(model).unwrap().unwrap().min.z - 7.0).abs() < 1e-3);
    assert_eq!(mesh.get_info().unwrap().deformable, 1);
    // The mesh of a restored scene, met from behind, or not.
    let mut copy = Scene::new(None).unwrap();
    copy.restore(None, &scene.get_snapshot(true).unwrap()).unwrap();
    let info = Mesh::from_scene(&copy, model).unwrap().get_info().unwrap();
    assert_eq!((info.kind, info.vertex_count, info.triangle_count), (MeshKind::SURFACE, 3, 1));
    let from_behind = Ray::new([0.2, 0.2, 0.0], [0.0, 0.0, 1.0], f32::INFINITY);
    let mut filter = QueryFilterDesc { flags: FILTER_NO_FRONT_FACES, ..Default::default() };
    assert_eq!(copy.raycast_filtered(&from_behind, Some(&filter)).unwrap().unwrap().flags, HIT_BACK);
    filter.flags = FILTER_NO_BACK_FACES;
    assert_eq!(copy.raycast_filtered(&from_behind, Some(&filter)).unwrap(), None);
}

#[test]
fn a_hull_is_a_solid_mesh() {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [0.1, 0.1, 0.1]];
    let hull = Mesh::hull(&corners, None).unwrap();
    assert_eq!(hull.get_vertices().unwrap().len(), 4);
    assert_eq!(hull.get_hull_planes().unwrap().len(), 4);
    assert_eq!(hull.get_hull_faces().unwrap(), [0, 1, 2, 3]);
}

#[test]
fn a_rope_is_picked_as_a_model_that_follows_it() {
    let mut solver = Solver::new(None).unwrap();
    let rope = solver.add_rope(&[[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [2.0, 0.0, 0.0]], 0.0, None).unwrap();
    // All on this thread.
    let mesh = unsafe { Mesh::from_body(&mut solver, rope, None) }.unwrap();
    let mut scene = Scene::new(None).unwrap();
    let model = scene.add(&mesh, None, None).unwrap();
    solver.set_positions(rope, 0, &[[0.0, 0.0, 7.0], [1.0, 0.0, 7.0], [2.0, 0.0, 7.0]]).unwrap();
    let hit = scene.raycast(&Ray::new([1.8, 0.0, 0.0], [0.0, 0.0, 1.0], f32::INFINITY), ALL_LAYERS).unwrap().unwrap();
    assert_eq!((hit.model, hit.triangle), (model, 1));
    assert_eq!(solver.get_nearest_particle(rope, hit.triangle, hit.point).unwrap(), 2);
}

#[test]
fn a_field_of_each_element_is_a_batch() {
    #[derive(Clone, Copy, Default)]
    struct Ship {
        _name: u32,
        sight: Ray,
        seen: Hit,
        _more: u64,
    }
    let (scene, _) = scene_of_balls();
    let rays = some_rays();
    let mut expected = vec![Hit::default(); rays.len()];
    scene.raycast_batch(&rays, ALL_LAYERS, &mut expected).unwrap();
    let ships: Vec<_> = rays.iter().map(|ray| Ship { sight: *ray, ..Default::default() }).collect();
    let mut out = ships.clone();
    scene
        .raycast_batch(
            Batch::field(&ships, |ship| &ship.sight),
            ALL_LAYERS,
            BatchMut::field(&mut out, |ship| &mut ship.seen),
        )
        .unwrap();
    assert!(out.iter().zip(&expected).all(|(ship, hit)| ship.seen == *hit));
}

#[test]
fn a_field_is_at_the_same_place_in_each_element() {
    let apart = [Box::new(Ray::default()), Box::new(Ray::default())];
    assert!(std::panic::catch_unwind(|| {
        Batch::field(&apart, |ray| &**ray);
    })
    .is_err());
    let chosen = [(true, Ray::default(), Ray::default()), (false, Ray::default(), Ray::default())];
    assert!(std::panic::catch_unwind(|| {
        Batch::field(&chosen, |c| if c.0 { &c.1 } else { &c.2 });
    })
    .is_err());
    assert!(std::panic::catch_unwind(|| {
        Batch::field(&chosen[..1], |c| if c.0 { &c.1 } else { &c.2 });
    })
    .is_ok());
}

#[test]
fn lengths_must_agree() {
    let (scene, models) = scene_of_balls();
    let rays = some_rays();
    let error = scene.raycast_batch(&rays, ALL_LAYERS, &mut [Hit::default(); 3]).unwrap_err();
    assert_eq!((error.status, error.to_string().contains("200")), (Status::ERROR_INVALID_ARGUMENT, true));
    let error = scene
        .sweep_sphere_batch(&[Sphere::default(); 2], &[[0.0; 3]; 3], ALL_LAYERS, &mut [Hit::default(); 2])
        .unwrap_err();
    assert_eq!(error.to_string(), "arrays of different lengths: 2 and 3");
    assert!(scene.raycast_batch(Batch::one(&rays[0]), ALL_LAYERS, &mut [Hit::default()]).is_err());
    assert!(scene.get_transforms(&models, &mut [Transform::default(); 2]).is_err());
    scene.raycast_batch(&[], ALL_LAYERS, &mut []).unwrap();
}

#[test]
fn lists_have_any_length() {
    let mut scene = Scene::new(None).unwrap();
    let mut models = vec![0; 500];
    scene.add_batch(&vec![Sphere::new([0.0; 3], 1.0); 500], Batch::none(), None, &mut models).unwrap();
    assert_eq!(scene.get_models().unwrap(), models);
    let boxes = [Aabb::new([-1.0; 3], [1.0; 3]), Aabb::new([5.0; 3], [6.0; 3]), Aabb::new([0.0; 3], [1.0; 3])];
    let lists = scene.overlap_batch(&boxes, ALL_LAYERS).unwrap();
    assert_eq!(lists.offsets, [0, 500, 500, 1000]);
    assert_eq!(lists[2], models);
    assert!(lists[1].is_empty());
    let ray = Ray::new([0.0, 0.0, -5.0], [0.0, 0.0, 1.0], FAR);
    assert_eq!(scene.raycast_all(&ray, ALL_LAYERS).unwrap().len(), 500);
    assert!(Scene::new(None).unwrap().get_models().unwrap().is_empty());
}

#[test]
fn models_are_moved_described_and_removed() {
    let mut scene = Scene::new(None).unwrap();
    let parent = scene.add(&Capsule::new([0.0; 3], [0.0, 1.0, 0.0], 0.25), None, None).unwrap();
    let desc = ModelDesc { parent, layers: 2, tag: 7, ..Default::default() };
    let child = scene
        .add(&Aabb::new([0.0; 3], [1.0; 3]), Some(&Transform::new([2.0, 0.0, 0.0], Quat::default(), 1.0)), Some(&desc))
        .unwrap();
    let info = scene.get_info(child).unwrap();
    assert_eq!((info.type_, info.parent, info.layers, info.tag), (ShapeType::AABB, parent, 2, 7));
    assert_eq!(scene.get_shape(parent).unwrap(), AnyShape::Capsule(Capsule::new([0.0; 3], [0.0, 1.0, 0.0], 0.25)));
    scene.set_transform(parent, &Transform::new([0.0, 5.0, 0.0], Quat::default(), 1.0)).unwrap();
    let mut places = [Transform::default(); 2];
    scene.get_transforms(&[parent, child], &mut places).unwrap();
    assert_eq!((places[0].position.y, places[1].position.y), (5.0, 0.0));
    scene.get_world_transforms(&[parent, child], &mut places).unwrap();
    assert_eq!(places[1].position, Vec3::new(2.0, 5.0, 0.0));
    assert_eq!(scene.get_bounds(child).unwrap().unwrap().min, Vec3::new(2.0, 5.0, 0.0));
    assert_eq!(scene.get_scene_bounds().unwrap().unwrap().max, Vec3::new(3.0, 6.25, 1.0));
    scene.set_parent(child, 0, true).unwrap();
    scene.set_transforms(&[child, parent], Batch::one(&Transform::default())).unwrap();
    scene.set_layers(child, 4).unwrap();
    scene.set_tag(child, 8).unwrap();
    let down = Ray::new([0.5, 9.0, 0.5], [0.0, -1.0, 0.0], FAR);
    assert_eq!(scene.raycast(&down, 4).unwrap().unwrap().tag, 8);
    assert!(scene.raycast(&down, 2).unwrap().is_none());
    let frustum = Camera::new(None).unwrap().get_frustum().unwrap();
    assert_eq!(scene.cull(&frustum, ALL_LAYERS).unwrap(), [parent, child]);
    scene.set_origin(&[1e9 + 0.5, 0.0, 0.0]).unwrap();
    assert_eq!(scene.get_origin().unwrap(), [1e9 + 0.5, 0.0, 0.0]);
    assert_eq!(scene.get_octree_stats().unwrap().item_count, 2);
    assert!(!scene.get_octree_boxes().unwrap().is_empty());
    scene.validate().unwrap();
    scene.remove(child).unwrap();
    assert!(!scene.has(child) && scene.has(parent));
    scene.remove_subtree(parent).unwrap();
    let more = [scene.add(&Sphere::default(), None, None).unwrap(), scene.add(&Sphere::default(), None, None).unwrap()];
    scene.remove_batch(&more[..1]).unwrap();
    scene.rebuild_octree().unwrap();
    assert!(scene.maintain_octree(1000).unwrap());
    scene.set_worker_count(2).unwrap();
    assert_eq!(scene.get_worker_count().unwrap(), 2);
    scene.clear().unwrap();
    assert!(scene.get_models().unwrap().is_empty() && scene.get_scene_bounds().unwrap().is_none());
}

#[test]
fn errors_carry_the_message_of_the_library() {
    let mut scene = Scene::new(None).unwrap();
    let error = scene.add(&Sphere::new([0.0; 3], -1.0), None, None).unwrap_err();
    assert_eq!(error.status, Status::ERROR_INVALID_ARGUMENT);
    assert!(error.to_string().contains("radius"), "{error}");
    assert_eq!(scene.remove(12345).unwrap_err().status, Status::ERROR_INVALID_ID);
    assert_eq!(scene.get_shape(12345).unwrap_err().status, Status::ERROR_INVALID_ID);
    let mesh = scene.add(&tetrahedron(), None, None).unwrap();
    assert_eq!(scene.get_shape(mesh).unwrap_err().status, Status::ERROR_UNSUPPORTED);
    assert_eq!(scene.set_parent(mesh, mesh, false).unwrap_err().status, Status::ERROR_CYCLE);
    assert_eq!(Status::ERROR_CYCLE.to_string(), "GPHYS_ERROR_CYCLE");
    let boxed: Box<dyn std::error::Error + Send + Sync> = error.into();
    assert!(boxed.to_string().contains("radius"));
}

#[test]
fn a_mesh_lives_as_long_as_its_models() {
    let mut scene = Scene::new(None).unwrap();
    let mesh = tetrahedron();
    scene.add(&mesh, None, None).unwrap();
    drop(mesh);
    assert_eq!(scene.raycast(&Ray::new([0.2, 0.2, -1.0], [0.0, 0.0, 1.0], FAR), ALL_LAYERS).unwrap().unwrap().t, 1.0);
}

#[test]
fn threads_may_ask_at_once_and_take_a_scene_along() {
    let (scene, _) = scene_of_balls();
    let rays = some_rays();
    let ask = || {
        let mut hits = vec![Hit::default(); rays.len()];
        scene.raycast_batch(&rays, ALL_LAYERS, &mut hits).unwrap();
        hits
    };
    let expected = ask();
    std::thread::scope(|scope| {
        let all: Vec<_> = (0..4).map(|_| scope.spawn(ask)).collect();
        assert!(all.into_iter().all(|thread| thread.join().unwrap() == expected));
    });
    std::thread::spawn(move || drop(scene)).join().unwrap();
}

/// Memory that runs out: as many bytes as are left, and what is held of it.
struct Ration {
    left: AtomicIsize,
    held: AtomicIsize,
}

unsafe extern "C" fn allocate(user: *mut c_void, size: usize, alignment: usize) -> *mut c_void {
    let ration = &*(user as *const Ration);
    if ration.left.fetch_sub(size as isize, Ordering::Relaxed) < size as isize {
        return std::ptr::null_mut();
    }
    ration.held.fetch_add(size as isize, Ordering::Relaxed);
    std::alloc::alloc(std::alloc::Layout::from_size_align(size, alignment).unwrap()).cast()
}

unsafe extern "C" fn release(user: *mut c_void, memory: *mut c_void, size: usize, alignment: usize) {
    let ration = &*(user as *const Ration);
    ration.held.fetch_sub(size as isize, Ordering::Relaxed);
    std::alloc::dealloc(memory.cast(), std::alloc::Layout::from_size_align(size, alignment).unwrap());
}

#[test]
fn running_out_of_memory_is_an_error_and_leaks_nothing() {
    let ration = Ration { left: AtomicIsize::new(0), held: AtomicIsize::new(0) };
    let allocator =
        Allocator { allocate: Some(allocate), release: Some(release), user: &ration as *const Ration as *mut c_void };
    let hook = unsafe { Hook::new(&allocator) };
    let desc = SceneDesc { allocator: hook, ..Default::default() };
    let mut failed = 0;
    for left in (0..400_000).step_by(2000) {
        ration.left.store(left, Ordering::Relaxed);
        if let Ok(mut scene) = Scene::new(Some(&desc)) {
            let made = (0..50).map(|_| scene.add(&Sphere::default(), None, None)).filter(|added| added.is_ok()).count();
            failed += usize::from(made < 50);
            assert_eq!(scene.get_models().unwrap().len(), made);
            ration.left.store(1 << 30, Ordering::Relaxed);
            scene.validate().unwrap();
        } else {
            failed += 1;
        }
        assert_eq!(ration.held.load(Ordering::Relaxed), 0);
    }
    assert!(failed > 0 && failed < 200, "{failed}");
    ration.left.store(0, Ordering::Relaxed);
    assert_eq!(Scene::new(Some(&desc)).unwrap_err().status, Status::ERROR_OUT_OF_MEMORY);
}

#[test]
fn every_kind_of_object_gives_its_memory_back() {
    let ration = Ration { left: AtomicIsize::new(1 << 30), held: AtomicIsize::new(0) };
    let allocator =
        Allocator { allocate: Some(allocate), release: Some(release), user: &ration as *const Ration as *mut c_void };
    let allocator = unsafe { Hook::new(&allocator) };
    let mesh = Mesh::new(&[[0.0; 3]; 3], &[0, 1, 2], Some(&MeshDesc { allocator, ..Default::default() })).unwrap();
    let objects = (
        Scene::new(Some(&SceneDesc { allocator, ..Default::default() })).unwrap(),
        Camera::new(Some(&CameraDesc { allocator, ..Default::default() })).unwrap(),
        Solver::new(Some(&SolverDesc { allocator, ..Default::default() })).unwrap(),
    );
    assert!(ration.held.load(Ordering::Relaxed) > 0);
    drop((mesh, objects));
    assert_eq!(ration.held.load(Ordering::Relaxed), 0);
}

unsafe extern "C" fn run(user: *mut c_void, task: Task, context: *mut c_void, count: u32) {
    (*(user as *const AtomicUsize)).fetch_add(1, Ordering::Relaxed);
    for index in 0..count {
        task.expect("a function")(context, index);
    }
}

#[test]
fn work_may_go_to_the_callers_threads() {
    let calls = AtomicUsize::new(0);
    let runner = TaskRunner { run: Some(run), user: &calls as *const AtomicUsize as *mut c_void };
    let desc = SceneDesc { worker_count: 4, task_runner: unsafe { Hook::new(&runner) }, ..Default::default() };
    let mut scene = Scene::new(Some(&desc)).unwrap();
    scene.add(&Sphere::new([0.0, 0.0, 5.0], 1.0), None, None).unwrap();
    let rays = vec![Ray::new([0.0; 3], [0.0, 0.0, 1.0], FAR); 100_000];
    let mut hits = vec![Hit::default(); rays.len()];
    scene.raycast_batch(&rays, ALL_LAYERS, &mut hits).unwrap();
    assert!(hits.iter().all(|hit| hit.t == 4.0) && calls.load(Ordering::Relaxed) > 0);
}
