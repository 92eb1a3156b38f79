// Generated from gamephys_api.json by bindings/generate.py. Not for editing.
package gamephys;

import com.sun.jna.Pointer;
import java.util.Optional;

/**
 * <pre>
 * Create a camera at the origin, with the projection and the viewport of its desc.
 *   - desc: null: the defaults
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
        return Low.create(made -> {
            int status = Low.gphys_camera_create(desc == null ? null : desc.pointer(), made);
            Low.keep(desc);
            return status;
        });
    }

    /**
     * Move the point of the world that the camera's coordinates count from; see Scene.setOrigin. The
     * camera and the target of its orbit stay where they are in the world. Picking and culling need a
     * scene of the same origin, else they fail with ERROR_INVALID_ARGUMENT.
     * Cost: O(1).
     * @param origin x, y, z in the world, metres, within MAX_COORDINATE
     */
    public void setOrigin(double[] origin) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_origin(self, scratch.put(1, origin, 3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Where in the world the camera's coordinates count from, metres.
     * Cost: O(1).
     */
    public double[] getOrigin() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_origin(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.doubles(1, 3);
    }

    /**
     * Use a perspective projection: distant objects appear smaller.
     * Cost: O(1).
     * @param fovY full vertical angle in radians, 1e-6 &lt;= fovY &lt; pi
     * @param nearDistance metres, &gt; 0
     * @param farDistance metres, &gt; nearDistance; INFINITY allowed
     */
    public void setPerspective(float fovY, float nearDistance, float farDistance) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_perspective(self, fovY, nearDistance, farDistance);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Use an orthographic projection: the distance does not change apparent size.
     * Cost: O(1).
     * @param height metres seen from top to bottom, &gt;= 1e-6; the width follows from the viewport and is at
     *     most twice MAX_COORDINATE
     * @param nearDistance metres, may be negative
     * @param farDistance metres, at least 1e-6 above nearDistance
     */
    public void setOrthographic(float height, float nearDistance, float farDistance) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_orthographic(self, height, nearDistance, farDistance);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Use any projection matrix of the camera's depth range and direction (off-centre, oblique, another
     * library's). It is not changed by Camera.setViewport.
     * Cost: O(1).
     * @throws GamephysException with ERROR_SINGULAR: if it has no inverse, or is too close to such a
     *     matrix to tell
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if a plane other than far lies at infinity,
     *     as it does when the matrix is for another depth range, or one lies beyond MAX_COORDINATE
     */
    public void setProjection(Mat4 projection) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_projection(self, scratch.put(1, projection));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * As Camera.setPerspective, with a fixed aspect ratio: the image is stretched to the viewport, as with
     * pixels that are not square, and the viewport does not change what is seen.
     * Cost: O(1). Since 1.1.
     * @param fovY full vertical angle in radians, 1e-6 &lt;= fovY &lt; pi
     * @param aspect width over height of what is seen, 1e-6 .. 1e6
     * @param nearDistance metres, &gt; 0
     * @param farDistance metres, &gt; nearDistance; INFINITY allowed
     */
    public void setPerspectiveAspect(float fovY, float aspect, float nearDistance, float farDistance) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_perspective_aspect(self, fovY, aspect, nearDistance, farDistance);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * As Camera.setOrthographic, with a width of its own, which the viewport does not change.
     * Cost: O(1). Since 1.1.
     * @param width metres seen from left to right, &gt;= 1e-6
     * @param height metres seen from top to bottom, &gt;= 1e-6
     * @param nearDistance metres, may be negative
     * @param farDistance metres, at least 1e-6 above nearDistance
     */
    public void setOrthographicSize(float width, float height, float nearDistance, float farDistance) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_orthographic_size(self, width, height, nearDistance, farDistance);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Set the size of the viewport. A perspective keeps fovY, an orthographic projection its height; the
     * call is refused if that makes the width more than twice MAX_COORDINATE.
     * Cost: O(1).
     * @param width pixels, 1e-3 .. 1e6
     * @param height pixels, 1e-3 .. 1e6
     */
    public void setViewport(float width, float height) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_viewport(self, width, height);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Where the viewport is in its window, as one of several of a split screen: pixels of all functions
     * count from the window's top left corner. (0, 0) at creation.
     * Cost: O(1). Since 1.1.
     * @param x pixels from the window's left edge to the viewport's
     * @param y pixels from the window's top edge to the viewport's
     */
    public void setViewportOrigin(float x, float y) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_viewport_origin(self, x, y);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Where the rays of a perspective begin, for all functions that pick. From the near plane at creation;
     * rays of other projections always begin there.
     * Cost: O(1). Since 1.1.
     */
    public void setPickStart(int start) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_pick_start(self, start);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /** What getProjection returns. */
    public record ProjectionResult(int kind, float size, float near, float far) {}

    /**
     * How the camera projects, as it was set.
     * Cost: O(1).
     * @return what of the following was called last: Camera.setPerspective, as at creation,
     *     Camera.setOrthographic (or those with a width of their own), or Camera.setProjection. the
     *     vertical field of view in radians of a perspective, the height in metres of an orthographic
     *     projection, 0 of a matrix. the distance of the near plane, metres; 0 of a matrix. that of the
     *     far plane; INFINITY without one; 0 of a matrix.
     */
    public ProjectionResult getProjection() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_projection(self, scratch.slot(1), scratch.slot(2), scratch.slot(3), scratch.slot(4));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new ProjectionResult(scratch.getInt(1), scratch.getFloat(2), scratch.getFloat(3), scratch.getFloat(4));
    }

    /** What getViewport returns. */
    public record ViewportResult(float width, float height) {}

    /**
     * The size of the viewport, in pixels, as it was set. Its width over its height is the aspect of the
     * image.
     * Cost: O(1).
     */
    public ViewportResult getViewport() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_viewport(self, scratch.slot(1), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new ViewportResult(scratch.getFloat(1), scratch.getFloat(2));
    }

    /** What getViewportOrigin returns. */
    public record ViewportOriginResult(float x, float y) {}

    /**
     * Where the viewport is in its window, in pixels, as it was set.
     * Cost: O(1). Since 1.1.
     */
    public ViewportOriginResult getViewportOrigin() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_viewport_origin(self, scratch.slot(1), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new ViewportOriginResult(scratch.getFloat(1), scratch.getFloat(2));
    }

    /** What getAspect returns. */
    public record AspectResult(float aspect, boolean isFixed) {}

    /**
     * Width over height of what is seen: as it was set, or else, and always with a matrix, that of the
     * viewport.
     * Cost: O(1). Since 1.1.
     * @return 1 if Camera.setPerspectiveAspect or Camera.setOrthographicSize was the last to set the
     *     projection; 0 if it follows the viewport.
     */
    public AspectResult getAspect() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_aspect(self, scratch.slot(1), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new AspectResult(scratch.getFloat(1), scratch.getInt(2) != 0);
    }

    /** What getImageSize returns. */
    public record ImageSizeResult(float width, float height) {}

    /**
     * Width and height of what is seen, within an ulp: at a distance of one metre by a perspective (twice
     * the tangents of half the angles; over the viewport's size, what a pixel spans there), at any
     * distance by an orthographic projection, in metres as they were set; 0 by a matrix.
     * Cost: O(1). Since 1.1.
     */
    public ImageSizeResult getImageSize() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_image_size(self, scratch.slot(1), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new ImageSizeResult(scratch.getFloat(1), scratch.getFloat(2));
    }

    /**
     * Where the rays of a perspective begin, as it was set.
     * Cost: O(1). Since 1.1.
     */
    public int getPickStart() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_pick_start(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return scratch.getInt(1);
    }

    /** What getConventions returns. */
    public record ConventionsResult(int handedness, int depthRange, boolean reverseZ) {}

    /**
     * What the camera was created with, as in CameraDesc.
     * Cost: O(1). Since 1.1.
     */
    public ConventionsResult getConventions() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_conventions(self, scratch.slot(1), scratch.slot(2), scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new ConventionsResult(scratch.getInt(1), scratch.getInt(2), scratch.getInt(3) != 0);
    }

    /**
     * Place the camera.
     * Cost: O(1).
     * @param position metres, of its centre
     * @param rotation from its own axes to those of the world
     */
    public void setTransform(Vec3 position, Quat rotation) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_transform(self, scratch.put(1, position), scratch.put(2, rotation));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Place it by a world matrix (camera to world). The axes are made orthonormal (the view direction
     * kept, then up), so that a matrix which drifted is corrected.
     * Cost: O(1).
     * @throws GamephysException with ERROR_SINGULAR: if the axes do not span space
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if they mirror or the last row is not 0 0 0 1
     */
    public void setWorldMatrix(Mat4 world) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_world_matrix(self, scratch.put(1, world));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Place it by a view matrix (world to camera): by the world matrix that is its inverse, as
     * Camera.setWorldMatrix. That of Camera.getViewMatrix puts a camera back within 2^-22 of its distance
     * from the origin and 2^-22 rad.
     * Cost: O(1). Since 1.1.
     * @throws GamephysException with ERROR_SINGULAR: if the axes do not span space
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if they mirror, the last row is not 0 0 0 1,
     *     or the camera would be beyond MAX_COORDINATE
     */
    public void setViewMatrix(Mat4 view) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_view_matrix(self, scratch.put(1, view));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Stand at eye and look at target. When up is parallel to the view, a perpendicular direction is
     * chosen in its place, always the same for the same input.
     * Cost: O(1).
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if eye equals target or up is zero
     */
    public void lookAt(Vec3 eye, Vec3 target, Vec3 up) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_look_at(self, scratch.put(1, eye), scratch.put(2, target), scratch.put(3, up));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /** What getTransform returns. */
    public record TransformResult(Vec3 position, Quat rotation) {}

    /**
     * The camera's position, in metres, and its rotation, rounded to float32.
     * Cost: O(1).
     */
    public TransformResult getTransform() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_transform(self, scratch.slot(1), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return new TransformResult(Vec3.read(scratch.memory, Scratch.at(1)), Quat.read(scratch.memory, Scratch.at(2)));
    }

    /**
     * The matrix from camera to world.
     * Cost: O(1).
     */
    public Mat4 getWorldMatrix() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_world_matrix(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * The matrix from world to camera: the transpose of the orthonormal world axes, and the position
     * transformed by it.
     * Cost: O(1).
     */
    public Mat4 getViewMatrix() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_view_matrix(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * The matrix from camera to clip space.
     * Cost: O(1).
     */
    public Mat4 getProjectionMatrix() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_projection_matrix(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Projection * view, multiplied in double precision and rounded once.
     * Cost: O(1).
     */
    public Mat4 getViewProjectionMatrix() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_view_projection_matrix(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Mat4.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Start orbiting with these settings; places the camera at once and drops pending input. An angle or a
     * distance outside its limits is brought inside.
     * Cost: O(1).
     */
    public void setOrbit(Orbit orbit) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_orbit(self, scratch.put(1, orbit));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The present settings, angles and distance of the orbit.
     * Cost: O(1).
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public Orbit getOrbit() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_orbit(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Orbit.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Set a speed for each input of the orbit, in place of the two of Orbit, which Camera.setOrbit starts
     * from. Input since the last update uses the new speeds.
     * Cost: O(1). Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public void setOrbitSpeeds(OrbitSpeeds speeds) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_set_orbit_speeds(self, scratch.put(1, speeds));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The present speeds of the orbit's inputs.
     * Cost: O(1). Since 1.1.
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public OrbitSpeeds getOrbitSpeeds() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_orbit_speeds(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return OrbitSpeeds.read(scratch.memory, Scratch.at(1));
    }

    /**
     * Add input to the orbit: yaw by unitsX, pitch by unitsY, times radians_per_unit or the speeds that
     * were set.
     * Cost: O(1).
     * @param unitsX finite, any size
     * @param unitsY finite, any size
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public void orbitRotate(float unitsX, float unitsY) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_orbit_rotate(self, unitsX, unitsY);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Add input to the orbit: move closer by units times metres_per_unit or the speed that was set, or
     * away if negative.
     * Cost: O(1).
     * @param units finite, any size
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public void orbitZoom(float units) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_orbit_zoom(self, units);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Add input to the orbit: move the target to the camera's right and up, as the last update left them,
     * by units times metres_per_unit or the speeds that were set.
     * Cost: O(1).
     * @param unitsRight finite, any size
     * @param unitsUp finite, any size
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public void orbitPan(float unitsRight, float unitsUp) {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_orbit_pan(self, unitsRight, unitsUp);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * Apply the input since the last update, within the limits, and place the camera. Angles are wrapped
     * to -pi .. pi in constant time.
     * Cost: O(1).
     * @throws GamephysException with ERROR_UNSUPPORTED: if the camera was never set to orbit
     */
    public void orbitUpdate() {
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_orbit_update(self);
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
    }

    /**
     * The view frustum, with origin at the camera's position and planes from its parameters: each number
     * within 2 ulp. All functions of shapes accept it. A user projection gives its planes by
     * Gribb-Hartmann in double precision.
     * Cost: O(1).
     */
    public Frustum getFrustum() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_frustum(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Frustum.read(scratch.memory, Scratch.at(1));
    }

    /**
     * World positions of the corners of the view frustum, in the order of Gamephys.frustumCorners.
     * Cost: O(1).
     * @return empty with an infinite far plane, or a corner beyond the largest float.
     */
    public Optional<java.util.List<Vec3>> getCorners() {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_corners(self, scratch.slot(1));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(scratch.list(1, 8, Vec3.LAYOUT)) : Optional.empty();
    }

    /**
     * What is seen in a rectangle of pixels, as Camera.getFrustum: of a tile, a marquee, a portal.
     * Cost: O(1). Since 1.1.
     * @param x0 pixels, a corner of the rectangle; may lie outside the viewport
     * @param y0 pixels, a corner of the rectangle; may lie outside the viewport
     * @param x1 pixels, the opposite corner, in any order; may lie outside the viewport
     * @param y1 pixels, the opposite corner, in any order; may lie outside the viewport
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if the rectangle has no area, or a side of
     *     what a matrix shows in it lies at infinity or beyond MAX_COORDINATE
     */
    public Frustum getRectangleFrustum(float x0, float y0, float x1, float y1) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_rectangle_frustum(self, x0, y0, x1, y1, scratch.slot(5));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        Low.check(status);
        return Frustum.read(scratch.memory, Scratch.at(5));
    }

    /**
     * World positions of the corners of what is seen in a rectangle of pixels, as Camera.getCorners.
     * Cost: O(1). Since 1.1.
     * @param x0 as Camera.getRectangleFrustum
     * @param y0 as Camera.getRectangleFrustum
     * @param x1 as Camera.getRectangleFrustum
     * @param y1 as Camera.getRectangleFrustum
     * @return empty as Camera.getCorners.
     */
    public Optional<java.util.List<Vec3>> getRectangleCorners(float x0, float y0, float x1, float y1) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_get_rectangle_corners(self, x0, y0, x1, y1, scratch.slot(5));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(scratch.list(5, 8, Vec3.LAYOUT)) : Optional.empty();
    }

    /**
     * World point to pixel, within 1e-3 pixel and 1 ulp, depth within 2^-22. x, y may lie outside the
     * viewport; z is the depth in the camera's range.
     * Cost: O(1).
     * @return empty if the point is not in front of the camera's centre (no image), or its image lies
     *     beyond the range of coordinates.
     */
    public Optional<Vec3> project(Vec3 point) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_project(self, scratch.put(1, point), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Vec3.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * Pixels of count world points, as Camera.project; a point without an image gets x = y = z = INFINITY.
     * Cost: O(elements).
     * @param points metres
     */
    public Batch<Vec3> projectBatch(Batch<Vec3> points, Batch<Vec3> out) {
        int count = Low.common(points.common());
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_project_batch(self, points.pointer(), points.stride(), count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, points, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> projectBatch(Batch<Vec3> points) {
        return projectBatch(points, (Batch<Vec3>) null);
    }

    /**
     * Pixel and depth to world point: the inverse of Camera.project.
     * Cost: O(1).
     * @return empty for the depth of an infinite far plane, and for points beyond that or beyond the range
     *     of coordinates.
     */
    public Optional<Vec3> unproject(Vec3 pixel) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_unproject(self, scratch.put(1, pixel), scratch.slot(2));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Vec3.read(scratch.memory, Scratch.at(2))) : Optional.empty();
    }

    /**
     * World points of the pixels with depth, as Camera.unproject; one at infinity gets x = y = z =
     * INFINITY.
     * Cost: O(elements).
     * @param pixels x, y in pixels, z the depth
     */
    public Batch<Vec3> unprojectBatch(Batch<Vec3> pixels, Batch<Vec3> out) {
        int count = Low.common(pixels.common());
        Batch<Vec3> room = Batch.room(Vec3.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_unproject_batch(self, pixels.pointer(), pixels.stride(), count, room.pointer(), Vec3.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, pixels, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Vec3> unprojectBatch(Batch<Vec3> pixels) {
        return unprojectBatch(pixels, (Batch<Vec3>) null);
    }

    /**
     * The ray through a pixel, of unit direction, from the near plane on; t_max ends on the far plane
     * (INFINITY without one). With PICK_FROM_CENTRE that of a perspective starts at the camera's position.
     * Its image is within 1e-3 pixel of the given one or, for fields of view below about 3 degrees, within
     * half an ulp of its direction. Its start is rounded to float32, too, which moves the ray by half an
     * ulp of the coordinates (but not from the camera's position, which has float coordinates);
     * Camera.pick is not limited in this way.
     * Cost: O(1).
     * @param pixelX pixels; may lie outside the viewport
     * @param pixelY pixels; may lie outside the viewport
     * @return empty if the line of sight does not meet the near plane (user projections), or would begin
     *     beyond MAX_COORDINATE.
     */
    public Optional<Ray> pickRay(float pixelX, float pixelY) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_pick_ray(self, pixelX, pixelY, scratch.slot(3));
        } finally {
            Owned.leave(this);
        }
        Low.keep(this);
        return Low.found(status) ? Optional.of(Ray.read(scratch.memory, Scratch.at(3))) : Optional.empty();
    }

    /**
     * Rays for a rectangle of pixel centres, as Camera.pickRay, row by row.
     * Cost: O(width * height).
     * @param x the left column of the rectangle
     * @param y its top row
     * @param width its columns
     * @param height its rows; width * height fewer than 2^32
     */
    public Batch<Ray> pickRays(int x, int y, int width, int height, Batch<Ray> out) {
        Batch<Ray> room = Batch.room(Ray.LAYOUT, width * height, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            status = Low.gphys_camera_pick_rays(self, x, y, width, height, room.pointer(), Ray.LAYOUT.bytes());
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Ray> pickRays(int x, int y, int width, int height) {
        return pickRays(x, y, width, height, (Batch<Ray>) null);
    }

    /**
     * The model under a pixel: the first hit of Camera.pickRay, before that is rounded to float32; t is in
     * metres from where it starts.
     * Cost: O(log n) expected.
     * @param pixelX pixels; may lie outside the viewport
     * @param pixelY pixels; may lie outside the viewport
     * @return empty if nothing is found.
     */
    public Optional<Hit> pick(Scene scene, float pixelX, float pixelY, int layers) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_camera_pick(self, scene_, pixelX, pixelY, layers, scratch.slot(5));
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> pick(Scene scene, float pixelX, float pixelY) {
        return pick(scene, pixelX, pixelY, Gamephys.ALL_LAYERS);
    }

    /**
     * The models under the pixels, as Camera.pick; a pixel without one gets model = 0 and t = INFINITY.
     * Cost: at most that of as many single calls; shared among the scene's workers.
     * @param pixels x, y pairs of floats
     */
    public Batch<Hit> pickBatch(Scene scene, Batch<Float> pixels, int layers, Batch<Hit> out) {
        int count = Low.common(pixels.common(2));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_camera_pick_batch(self, scene_, pixels.pointer(), pixels.stride(8), count, layers, room.pointer(), Hit.LAYOUT.bytes());
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
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
     * Marquee: ids of all models in the pixel rectangle, hidden ones included, between near and far plane;
     * tested by their exact shapes, ascending.
     * Cost: that of Scene.overlap.
     * @param x0 pixels, a corner of the rectangle; may lie outside the viewport
     * @param y0 pixels, a corner of the rectangle; may lie outside the viewport
     * @param x1 pixels, the opposite corner, in any order; may lie outside the viewport
     * @param y1 pixels, the opposite corner, in any order; may lie outside the viewport
     * @throws GamephysException with ERROR_INVALID_ARGUMENT: if the rectangle has no area
     */
    public Batch<Integer> pickRectangle(Scene scene, float x0, float y0, float x1, float y1, int layers) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Pointer scene_ = Owned.enter(scene);
                    try {
                        status = Low.gphys_camera_pick_rectangle(self, scene_, x0, y0, x1, y1, layers, room, capacity, total);
                    } finally {
                        Owned.leave(scene);
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, scene);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> pickRectangle(Scene scene, float x0, float y0, float x1, float y1) {
        return pickRectangle(scene, x0, y0, x1, y1, Gamephys.ALL_LAYERS);
    }

    /**
     * Ids of the models to draw: Scene.cull with the camera's frustum.
     * Cost: O(log n + k) expected.
     */
    public Batch<Integer> cull(Scene scene, int layers) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Pointer scene_ = Owned.enter(scene);
                    try {
                        status = Low.gphys_camera_cull(self, scene_, layers, room, capacity, total);
                    } finally {
                        Owned.leave(scene);
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, scene);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> cull(Scene scene) {
        return cull(scene, Gamephys.ALL_LAYERS);
    }

    /**
     * The model under a pixel that the filter sees, as Camera.pick: what lies behind a selection.
     * Cost: as Scene.raycastFiltered.
     * @param pixelX pixels; may lie outside the viewport
     * @param pixelY pixels; may lie outside the viewport
     * @param filter null: the defaults
     * @return empty if nothing is found.
     */
    public Optional<Hit> pickFiltered(Scene scene, float pixelX, float pixelY, QueryFilterDesc filter) {
        Scratch scratch = Scratch.get();
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_camera_pick_filtered(self, scene_, pixelX, pixelY, filter == null ? null : filter.pointer(), scratch.slot(5));
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene, filter);
        return Low.found(status) ? Optional.of(Hit.read(scratch.memory, Scratch.at(5))) : Optional.empty();
    }

    /** The same with defaults. */
    public Optional<Hit> pickFiltered(Scene scene, float pixelX, float pixelY) {
        return pickFiltered(scene, pixelX, pixelY, (QueryFilterDesc) null);
    }

    /**
     * The models under the pixels that the filters see, as Camera.pickBatch.
     * Cost: at most that of as many single calls; shared among the scene's workers.
     * @param pixels x, y pairs of floats
     * @param filters null: the defaults
     */
    public Batch<Hit> pickFilteredBatch(Scene scene, Batch<Float> pixels, Batch<QueryFilterDesc> filters, Batch<Hit> out) {
        int count = Low.common(pixels.common(2), Batch.common(filters));
        Batch<Hit> room = Batch.room(Hit.LAYOUT, count, out);
        int status;
        Pointer self = Owned.enter(this);
        try {
            Pointer scene_ = Owned.enter(scene);
            try {
                status = Low.gphys_camera_pick_filtered_batch(self, scene_, pixels.pointer(), pixels.stride(8), count, Batch.pointer(filters), Batch.stride(filters), room.pointer(), Hit.LAYOUT.bytes());
            } finally {
                Owned.leave(scene);
            }
        } finally {
            Owned.leave(this);
        }
        Low.keep(this, scene, pixels, filters, room);
        Low.check(status);
        return room;
    }

    /** The same with defaults. */
    public Batch<Hit> pickFilteredBatch(Scene scene, Batch<Float> pixels, Batch<QueryFilterDesc> filters) {
        return pickFilteredBatch(scene, pixels, filters, (Batch<Hit>) null);
    }

    /** The same with defaults. */
    public Batch<Hit> pickFilteredBatch(Scene scene, Batch<Float> pixels) {
        return pickFilteredBatch(scene, pixels, (Batch<QueryFilterDesc>) null, (Batch<Hit>) null);
    }

    /**
     * Marquee: ids of all models in the pixel rectangle that the filter sees, as Camera.pickRectangle.
     * Cost: as Scene.overlapFiltered.
     * @param x0 pixels, a corner of the rectangle
     * @param y0 pixels, a corner of the rectangle
     * @param x1 pixels, the opposite corner, in any order
     * @param y1 pixels, the opposite corner, in any order
     * @param filter null: the defaults
     */
    public Batch<Integer> pickRectangleFiltered(Scene scene, float x0, float y0, float x1, float y1, QueryFilterDesc filter) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Pointer scene_ = Owned.enter(scene);
                    try {
                        status = Low.gphys_camera_pick_rectangle_filtered(self, scene_, x0, y0, x1, y1, filter == null ? null : filter.pointer(), room, capacity, total);
                    } finally {
                        Owned.leave(scene);
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, scene, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> pickRectangleFiltered(Scene scene, float x0, float y0, float x1, float y1) {
        return pickRectangleFiltered(scene, x0, y0, x1, y1, (QueryFilterDesc) null);
    }

    /**
     * Ids of the models to draw that the filter sees: Scene.cullFiltered with the camera's frustum.
     * Cost: as Scene.cullFiltered.
     * @param filter null: the defaults
     */
    public Batch<Integer> cullFiltered(Scene scene, QueryFilterDesc filter) {
        return Low.list(Layout.INT, (room, capacity, total) -> {
                int status;
                Pointer self = Owned.enter(this);
                try {
                    Pointer scene_ = Owned.enter(scene);
                    try {
                        status = Low.gphys_camera_cull_filtered(self, scene_, filter == null ? null : filter.pointer(), room, capacity, total);
                    } finally {
                        Owned.leave(scene);
                    }
                } finally {
                    Owned.leave(this);
                }
                Low.keep(this, scene, filter);
                return status;
            });
    }

    /** The same with defaults. */
    public Batch<Integer> cullFiltered(Scene scene) {
        return cullFiltered(scene, (QueryFilterDesc) null);
    }
}
