//! What several tests need; none needs all of it.
#![allow(dead_code)]
use gamephys::*;

/// 30 balls on a spiral, and their ids.
pub fn scene_of_balls() -> (Scene, Vec<ModelId>) {
    let mut scene = Scene::new(None).unwrap();
    let balls: Vec<_> =
        (0..30u8).map(f32::from).map(|i| Sphere::new([3.0 * i.sin(), 3.0 * (2.0 * i).cos(), i / 3.0], 0.7)).collect();
    let mut models = vec![0; balls.len()];
    scene.add_batch(&balls, Batch::none(), None, &mut models).unwrap();
    (scene, models)
}

/// 200 rays, some of which meet a ball.
pub fn some_rays() -> Vec<Ray> {
    (0..200u8)
        .map(f32::from)
        .map(|i| Ray::new([0.0, 0.0, -5.0], [i.sin() / 2.0, (3.0 * i).cos() / 2.0, 1.0], f32::INFINITY))
        .collect()
}

pub fn tetrahedron() -> Mesh {
    let corners = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    Mesh::new(&corners, &[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3], Some(&MeshDesc::default())).unwrap()
}
