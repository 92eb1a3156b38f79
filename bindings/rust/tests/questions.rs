//! Shapes and meshes on their own.
mod common;
use common::tetrahedron;
use gamephys::*;

const UP: [f32; 3] = [0.0, 1.0, 0.0];

#[test]
fn single_shapes_answer() {
    let ball = Sphere::new([0.0; 3], 1.0);
    validate(&ball).unwrap();
    assert_eq!(bounds(&ball).unwrap(), Some(Aabb::new([-1.0; 3], [1.0; 3])));
    assert_eq!(bounds(&Plane::new(UP, 0.0)).unwrap(), None);
    assert!(contains(&ball, [0.0, 0.6, 0.8], 1e-6).unwrap());
    assert_eq!(closest_point(&ball, [0.0, 3.0, 0.0]).unwrap().unwrap().distance, 2.0);
    assert!(overlaps(&ball, &Aabb::new([0.5; 3], [1.0; 3])).unwrap());
    assert_eq!(classify_plane(&ball, &Plane::new(UP, -3.0)).unwrap(), (Side::INSIDE, 2.0));
    let ray = Ray::new([0.0, 0.0, -3.0], [0.0, 0.0, 1.0], 10.0);
    assert_eq!(raycast(&ball, &ray).unwrap().unwrap().t, 2.0);
    assert_eq!(raycast(&Sphere::new([5.0, 0.0, 0.0], 1.0), &ray).unwrap(), None);
    assert_eq!(segment_test(&ball, &Segment::new([0.0, 0.0, -3.0], [0.0, 0.0, 1.0])).unwrap().unwrap().t, 0.5);
    assert_eq!(sweep_sphere(&ball, &Sphere::new([0.0, 4.0, 0.0], 1.0), [0.0, -4.0, 0.0]).unwrap().unwrap().t, 0.5);
    let (a, b, distance) =
        segment_closest_points(&Segment::new([0.0; 3], UP), &Segment::new([2.0, 0.5, -1.0], [2.0, 0.5, 1.0])).unwrap();
    assert_eq!((a, b, distance), ([0.0, 0.5, 0.0].into(), [2.0, 0.5, 0.0].into(), 2.0));
}

#[test]
fn a_box_that_is_moved_may_turn() {
    let moved: Obb =
        transform(&Aabb::new([0.0; 3], [2.0; 3]), &Transform::new([1.0, 0.0, 0.0], Quat::default(), 1.0)).unwrap();
    assert_eq!(moved.center, Vec3::new(2.0, 1.0, 1.0));
    let moved: Sphere = transform(&Sphere::new(UP, 1.0), &Transform { scale: 3.0, ..Default::default() }).unwrap();
    assert_eq!(moved, Sphere::new([0.0, 3.0, 0.0], 3.0));
}

#[test]
fn frusta_come_from_matrices() {
    let camera = Camera::new(None).unwrap();
    let matrix = camera.get_view_projection_matrix().unwrap();
    let frustum = frustum_from_matrix(&matrix, DepthRange::ZERO_TO_ONE, false).unwrap();
    let corners = frustum_corners(&frustum).unwrap().unwrap();
    for (corner, known) in corners.iter().zip(camera.get_corners().unwrap().unwrap()) {
        assert!((corner.x - known.x).abs() < 1e-3 * known.z && (corner.z - known.z).abs() < 1e-3 * known.z);
    }
    assert_eq!(classify_frustum(&Sphere::new([0.0, 0.0, 5.0], 1.0), &frustum).unwrap(), Side::INSIDE);
    let flat = Mat4 { m: [0.0; 16] };
    assert_eq!(frustum_from_matrix(&flat, DepthRange::ZERO_TO_ONE, false).unwrap_err().status, Status::ERROR_SINGULAR);
}

#[test]
fn one_shape_against_many() {
    let ball = Sphere::new([0.0; 3], 1.0);
    let points = [[0.0; 3], [2.0, 0.0, 0.0]];
    let mut inside = [7; 2];
    contains_batch(&ball, &points, 0.0, &mut inside).unwrap();
    assert_eq!(inside, [1, 0]);
    let mut nearest = [Nearest::default(); 2];
    closest_point_batch(&ball, &points, &mut nearest).unwrap();
    assert_eq!(nearest[1].distance, 1.0);
    let balls = [0.0, 1.0, 2.0, 3.0].map(|x| Sphere::new([x, 0.0, 0.0], 1.0));
    let mut met = [7; 4];
    overlaps_batch(&balls, Shapes::one(&Plane::new([1.0, 0.0, 0.0], 0.0)), &mut met).unwrap();
    assert_eq!(met, [1, 1, 0, 0]);
    let mut hits = [Hit::default(); 3];
    let rays = [0.0, 1.0, 2.0].map(|x| Ray::new([x, 0.0, -3.0], [0.0, 0.0, 1.0], 10.0));
    raycast_batch(&ball, &rays, &mut hits).unwrap();
    assert_eq!(hits.map(|hit| hit.t), [2.0, 3.0, f32::INFINITY]);
}

#[test]
fn a_mesh_is_a_shape() {
    let mesh = tetrahedron();
    assert_eq!(mesh.get_report().unwrap().open_edge_count, 0);
    assert_eq!(mesh.get_vertices().unwrap()[3], Vec3::new(0.0, 0.0, 1.0));
    assert_eq!(mesh.get_indices().unwrap().len(), 12);
    let snapshot = mesh.get_snapshot().unwrap();
    assert_eq!(Mesh::from_snapshot(&snapshot, None).unwrap().get_indices().unwrap(), mesh.get_indices().unwrap());
    assert_eq!(Mesh::from_snapshot(&snapshot[1..], None).unwrap_err().status, Status::ERROR_INVALID_ARGUMENT);
    let ray = Ray::new([0.2, 0.2, -1.0], [0.0, 0.0, 1.0], 10.0);
    assert_eq!(raycast(&mesh, &ray).unwrap().unwrap().t, 1.0);
    assert_eq!(mesh.raycast_all(&ray).unwrap().len(), 2);
    assert!(mesh.raycast_any(&ray).unwrap());
    let (mut any, mut distances) = ([0; 2], [Distance::default(); 2]);
    mesh.raycast_any_batch(&[ray; 2], &mut any).unwrap();
    mesh.raycast_distance_batch(&[ray; 2], &mut distances).unwrap();
    assert_eq!(any, [1, 1]);
    assert_ne!(distances[1].triangle, NO_TRIANGLE);
    assert_eq!(mesh.overlap(&Sphere::new([1.0, 1.0, 1.0], 1.2)).unwrap(), [3]);
    let stats = mesh.get_octree_stats().unwrap();
    assert_eq!((stats.item_count, mesh.get_octree_boxes().unwrap().len()), (4, stats.node_count as usize));
}

#[test]
fn bad_meshes_are_explained() {
    let corners = vec![Vec3::default(), Vec3::new(f32::NAN, 0.0, 0.0)];
    let report = mesh_check(&corners, &[0, 1, 7]).unwrap();
    assert_eq!((report.bad_vertex_count, report.first_bad_vertex, report.out_of_range_count), (1, 1, 1));
    assert_eq!(Mesh::new(&corners, &[0, 1, 7], None).unwrap_err().status, Status::ERROR_INVALID_ARGUMENT);
    assert_eq!(Mesh::new(&corners, &[0, 1], None).unwrap_err().status, Status::ERROR_INVALID_ARGUMENT);
}
