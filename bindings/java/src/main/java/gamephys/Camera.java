// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.util.Optional;

/**
 * <pre>
 * Create a camera with the defaults above.
 * &#64;param desc  NULL: the defaults
 * Cost: O(1).
 * </pre>
 */
public final class Camera extends Owned {
    public Camera(CameraDesc desc) {
        super(create(desc), Low::gphys_camera_destroy);
    }

    public Camera() {
        super(create((CameraDesc) null), Low::gphys_camera_destroy);
    }

    private static Pointer create(CameraDesc desc) {
        return Low.create(made -> Low.gphys_camera_create(desc == null ? null : desc.pointer(), made));
    }

    /**
     * <pre>
     * Move the point of the world that the camera's coordinates count from; see gphys_scene_set_origin.
     * The camera and the target of its orbit stay where they are in the world. Picking and culling need a
     * scene of the same origin, else they return GPHYS_ERROR_INVALID_ARGUMENT.
     * &#64;param origin  x, y, z in the world, metres, within GPHYS_MAX_COORDINATE
     * Cost: O(1).
     * </pre>
     */
    public void setOrigin(double[] origin) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_set_origin(opened(), scratch.put(1, origin, 3));
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Where in the world the camera's coordinates count from, metres. Cost: O(1).
     * </pre>
     */
    public double[] getOrigin() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_origin(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return scratch.doubles(1, 3);
    }

    /**
     * <pre>
     * See with a perspective projection; what is further away is smaller.
     * &#64;param fov_y  full vertical angle in radians, 1e-6 &lt;= fov_y &lt; pi
     * &#64;param near_distance  metres, &gt; 0
     * &#64;param far_distance   metres, &gt; near_distance; INFINITY allowed
     * Cost: O(1).
     * </pre>
     */
    public void setPerspective(float fovY, float nearDistance, float farDistance) {
        int status = Low.gphys_camera_set_perspective(opened(), fovY, nearDistance, farDistance);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * See with an orthographic projection; the distance changes no size.
     * &#64;param height  metres seen from top to bottom, &gt;= 1e-6; the width follows from the viewport
     * &#64;param near_distance, far_distance  metres; far at least 1e-6 above near, which may be negative
     * Cost: O(1).
     * </pre>
     */
    public void setOrthographic(float height, float nearDistance, float farDistance) {
        int status = Low.gphys_camera_set_orthographic(opened(), height, nearDistance, farDistance);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * See with any projection matrix of the camera's depth range and direction (off-centre, oblique,
     * another library's). It is not changed by gphys_camera_set_viewport.
     * &#64;return GPHYS_ERROR_SINGULAR if it has no inverse, or is too close to such a matrix to tell;
     *         GPHYS_ERROR_INVALID_ARGUMENT if a plane other than far lies at infinity, as it does when
     *         the matrix is for another depth range
     * Cost: O(1).
     * </pre>
     */
    public void setProjection(Mat4 projection) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_set_projection(opened(), scratch.put(1, projection));
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * The viewport was resized. Perspective keeps fov_y, orthographic its height.
     * &#64;param width, height  pixels, 1e-3 .. 1e6
     * Cost: O(1).
     * </pre>
     */
    public void setViewport(float width, float height) {
        int status = Low.gphys_camera_set_viewport(opened(), width, height);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Place the camera.
     * &#64;param position  metres, of its centre
     * &#64;param rotation  from its own axes to those of the world
     * Cost: O(1).
     * </pre>
     */
    public void setTransform(Vec3 position, Quat rotation) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_set_transform(opened(), scratch.put(1, position), scratch.put(2, rotation));
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
     * kept, then up), so that a matrix which drifted is corrected.
     * &#64;return GPHYS_ERROR_SINGULAR if the axes do not span space, GPHYS_ERROR_INVALID_ARGUMENT if
     *         they mirror or the last row is not 0 0 0 1
     * Cost: O(1).
     * </pre>
     */
    public void setWorldMatrix(Mat4 world) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_set_world_matrix(opened(), scratch.put(1, world));
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
     * chosen in its place, always the same for the same input.
     * &#64;return GPHYS_ERROR_INVALID_ARGUMENT if eye equals target or up is zero
     * Cost: O(1).
     * </pre>
     */
    public void lookAt(Vec3 eye, Vec3 target, Vec3 up) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_look_at(opened(), scratch.put(1, eye), scratch.put(2, target), scratch.put(3, up));
        Low.keep(this);
        Low.check(status);
    }

    /** What getTransform returns. */
    public record TransformResult(Vec3 position, Quat rotation) {}

    /**
     * <pre>
     * Where the camera stands, in metres, and how it is turned, rounded to float32. Cost: O(1).
     * </pre>
     */
    public TransformResult getTransform() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_transform(opened(), scratch.slot(1), scratch.slot(2));
        Low.keep(this);
        Low.check(status);
        return new TransformResult(Vec3.read(scratch.memory, Scratch.at(1)), Quat.read(scratch.memory, Scratch.at(2)));
    }

    /**
     * <pre>
     * The matrix from camera to world. Cost: O(1).
     * </pre>
     */
    public Mat4 getWorldMatrix() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_world_matrix(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * The matrix from world to camera: the transpose of the orthonormal world axes, and the position
     * through them. Cost: O(1).
     * </pre>
     */
    public Mat4 getViewMatrix() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_view_matrix(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * The matrix from camera to clip space. Cost: O(1).
     * </pre>
     */
    public Mat4 getProjectionMatrix() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_projection_matrix(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * Projection * view, multiplied in double precision and rounded once. Cost: O(1).
     * </pre>
     */
    public Mat4 getViewProjectionMatrix() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_view_projection_matrix(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * Start orbiting with these settings; places the camera at once and drops pending input. An angle
     * or a distance outside its limits is brought inside. Cost: O(1).
     * </pre>
     */
    public void setOrbit(Orbit orbit) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_set_orbit(opened(), scratch.put(1, orbit));
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * The present settings, angles and distance of the orbit.
     * &#64;return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
     * Cost: O(1).
     * </pre>
     */
    public Orbit getOrbit() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_orbit(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Orbit.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * Add input to the orbit: yaw by units_x, pitch by units_y, times radians_per_unit.
     * &#64;param units_x, units_y  finite, any size
     * &#64;return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
     * Cost: O(1).
     * </pre>
     */
    public void orbitRotate(float unitsX, float unitsY) {
        int status = Low.gphys_camera_orbit_rotate(opened(), unitsX, unitsY);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Add input to the orbit: come closer by units times metres_per_unit (go back if negative).
     * &#64;param units  finite, any size
     * &#64;return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
     * Cost: O(1).
     * </pre>
     */
    public void orbitZoom(float units) {
        int status = Low.gphys_camera_orbit_zoom(opened(), units);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Add input to the orbit: move the target to the camera's right and up, as the last update left them,
     * by units times metres_per_unit.
     * &#64;param units_right, units_up  finite, any size
     * &#64;return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
     * Cost: O(1).
     * </pre>
     */
    public void orbitPan(float unitsRight, float unitsUp) {
        int status = Low.gphys_camera_orbit_pan(opened(), unitsRight, unitsUp);
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * Apply the input since the last update, within the limits, and place the camera. Angles are
     * wrapped to -pi .. pi in constant time.
     * &#64;return GPHYS_ERROR_UNSUPPORTED if the camera was never set to orbit
     * Cost: O(1).
     * </pre>
     */
    public void orbitUpdate() {
        int status = Low.gphys_camera_orbit_update(opened());
        Low.keep(this);
        Low.check(status);
    }

    /**
     * <pre>
     * The seen volume, with origin at the camera's position and planes from its parameters: each
     * number within 2 ulp. A user projection gives its planes by Gribb-Hartmann in double precision.
     * Cost: O(1).
     * </pre>
     */
    public Frustum getFrustum() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_frustum(opened(), scratch.slot(1));
        Low.keep(this);
        Low.check(status);
        return Frustum.read(scratch.memory, Scratch.at(1));
    }

    /**
     * <pre>
     * World positions of the corners of the seen volume, in the order of gphys_frustum_corners.
     * &#64;return GPHYS_UNBOUNDED with an infinite far plane
     * Cost: O(1).
     * </pre>
     */
    public Optional<java.util.List<Vec3>> getCorners() {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_get_corners(opened(), scratch.slot(1));
        Low.keep(this);
        return Low.found(status) ? Optional.of(scratch.list(1, 8, Vec3.LAYOUT)) : Optional.empty();
    }

    /**
     * <pre>
     * World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the viewport;
     * z is the depth in the camera's range.
     * &#64;return GPHYS_NO_HIT if the point is not in front of the camera's centre (no image), or its
     *         image lies beyond the range of coordinates
     * Cost: O(1).
     * </pre>
     */
    public Optional<Vec3> project(Vec3 point) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_project(opened(), scratch.put(1, point), scratch.slot(2));
        Low.keep(this);
        return Low.found(status) ? Optional.of(Vec3.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * <pre>
     * Pixels of count world points, as gphys_camera_project; a point without an image gets
     * x = y = z = INFINITY.
     * &#64;param points      metres; a stride of 0 projects one point count times
     * &#64;param out_pixels  count elements
     * Cost: O(count).
     * </pre>
     */
    public Batch<Vec3> projectBatch(Batch<Vec3> points, Batch<Vec3> out) {
        int count = Low.common(points.common());
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status = Low.gphys_camera_project_batch(opened(), points.pointer(), points.stride(), count, room.pointer(), Vec3.LAYOUT.bytes());
        Low.keep(this, points, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> projectBatch(Batch<Vec3> points) {
        return projectBatch(points, (Batch<Vec3>) null);
    }

    /**
     * <pre>
     * Pixel and depth to world point: the inverse of gphys_camera_project.
     * &#64;return GPHYS_UNBOUNDED for the depth of an infinite far plane, and for points beyond that or
     *         beyond the range of coordinates
     * Cost: O(1).
     * </pre>
     */
    public Optional<Vec3> unproject(Vec3 pixel) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_unproject(opened(), scratch.put(1, pixel), scratch.slot(2));
        Low.keep(this);
        return Low.found(status) ? Optional.of(Vec3.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * <pre>
     * World points of count pixels with depth, as gphys_camera_unproject; one at infinity gets
     * x = y = z = INFINITY.
     * &#64;param pixels      x, y in pixels, z the depth; a stride of 0 takes one pixel count times
     * &#64;param out_points  count elements
     * Cost: O(count).
     * </pre>
     */
    public Batch<Vec3> unprojectBatch(Batch<Vec3> pixels, Batch<Vec3> out) {
        int count = Low.common(pixels.common());
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status = Low.gphys_camera_unproject_batch(opened(), pixels.pointer(), pixels.stride(), count, room.pointer(), Vec3.LAYOUT.bytes());
        Low.keep(this, pixels, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> unprojectBatch(Batch<Vec3> pixels) {
        return unprojectBatch(pixels, (Batch<Vec3>) null);
    }

    /**
     * <pre>
     * The ray through a pixel, of unit direction. It starts at the camera's position (perspective) or
     * on the near plane (orthographic, user) and t_max ends on the far plane (INFINITY without one).
     * Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, as
     * near as half an ulp of a direction can be; gphys_camera_pick is not so limited.
     * For perspective the stretch before the near plane is part of the ray.
     * &#64;param pixel_x, pixel_y  pixels; may lie outside the viewport
     * &#64;return GPHYS_UNBOUNDED if the line of sight does not meet the near plane (user projections)
     * Cost: O(1).
     * </pre>
     */
    public Optional<Ray> pickRay(float pixelX, float pixelY) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_pick_ray(opened(), pixelX, pixelY, scratch.slot(3));
        Low.keep(this);
        return Low.found(status) ? Optional.of(Ray.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * <pre>
     * Rays for a rectangle of pixel centres, as gphys_camera_pick_ray, row by row.
     * &#64;param x, y, width, height  pixels; width * height rays, fewer than 2^32
     * &#64;param out_rays             width * height elements
     * &#64;return GPHYS_UNBOUNDED if the line of sight of a pixel does not meet the near plane
     * Cost: O(width * height).
     * </pre>
     */
    public Batch<Ray> pickRays(int x, int y, int width, int height, Batch<Ray> out) {
        Batch<Ray> room = Batch.room(Ray.LAYOUT, width * height, out);
        int status = Low.gphys_camera_pick_rays(opened(), x, y, width, height, room.pointer(), Ray.LAYOUT.bytes());
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Ray> pickRays(int x, int y, int width, int height) {
        return pickRays(x, y, width, height, (Batch<Ray>) null);
    }

    /**
     * <pre>
     * The model under a pixel: the first hit of gphys_camera_pick_ray, before that is rounded to
     * float32; t is in metres.
     * &#64;param pixel_x, pixel_y  pixels; may lie outside the viewport
     * &#64;return GPHYS_OK or GPHYS_NO_HIT
     * Cost: O(log n) expected.
     * </pre>
     */
    public Optional<Hit> pick(Scene scene, float pixelX, float pixelY, int layers) {
        Scratch scratch = Scratch.get();
        int status = Low.gphys_camera_pick(opened(), scene.opened(), pixelX, pixelY, layers, scratch.slot(5));
        Low.keep(this, scene);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> pick(Scene scene, float pixelX, float pixelY) {
        return pick(scene, pixelX, pixelY, Gamephys.ALL_LAYERS);
    }

    /**
     * <pre>
     * The models under count pixels, as gphys_camera_pick; a pixel without one gets model = 0 and
     * t = INFINITY.
     * &#64;param pixels    x, y pairs of floats; a stride of 0 takes one pixel count times
     * &#64;param out_hits  count elements
     * Cost: at most that of count single calls; shared among the scene's workers.
     * </pre>
     */
    public Batch<Hit> pickBatch(Scene scene, Batch<Float> pixels, int layers, Batch<Hit> out) {
        int count = Low.common(pixels.common(2));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status = Low.gphys_camera_pick_batch(opened(), scene.opened(), pixels.pointer(), pixels.stride(8), count, layers, room.pointer(), Hit.LAYOUT.bytes());
        Low.keep(this, scene, pixels, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> pickBatch(Scene scene, Batch<Float> pixels, int layers) {
        return pickBatch(scene, pixels, layers, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> pickBatch(Scene scene, Batch<Float> pixels) {
        return pickBatch(scene, pixels, Gamephys.ALL_LAYERS, (Batch<Hit>) null);
    }

    /**
     * <pre>
     * Marquee: ids of all models that show or would show, were nothing in front of them, in the pixel
     * rectangle, between near and far plane; exact shapes, ascending. Kept when too many: the lowest.
     * &#64;param x0, y0, x1, y1  pixels, opposite corners in any order; may lie outside the viewport
     * &#64;return GPHYS_ERROR_INVALID_ARGUMENT if the rectangle has no area
     * Cost: O(log n + k) expected.
     * </pre>
     */
    public Batch<Integer> pickRectangle(Scene scene, float x0, float y0, float x1, float y1, int layers) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status = Low.gphys_camera_pick_rectangle(opened(), scene.opened(), x0, y0, x1, y1, layers, room, capacity, total);
                Low.keep(this, scene);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> pickRectangle(Scene scene, float x0, float y0, float x1, float y1) {
        return pickRectangle(scene, x0, y0, x1, y1, Gamephys.ALL_LAYERS);
    }

    /**
     * <pre>
     * Ids of the models to draw: gphys_scene_cull with the camera's frustum. Kept when too many: the lowest.
     * Cost: O(log n + k) expected.
     * </pre>
     */
    public Batch<Integer> cull(Scene scene, int layers) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status = Low.gphys_camera_cull(opened(), scene.opened(), layers, room, capacity, total);
                Low.keep(this, scene);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> cull(Scene scene) {
        return cull(scene, Gamephys.ALL_LAYERS);
    }
}
