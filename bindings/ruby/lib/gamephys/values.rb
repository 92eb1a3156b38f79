# frozen_string_literal: true

# Generated from gamephys_api.json by bindings/generate.py. Not for editing.
module Gamephys
  OK = 0
  NO_HIT = 1
  INCOMPLETE = 2
  UNBOUNDED = 3
  ERROR_INVALID_ARGUMENT = -1
  ERROR_INVALID_ID = -2
  ERROR_STRUCT_SIZE = -3
  ERROR_OUT_OF_MEMORY = -4
  ERROR_CAPACITY = -5
  ERROR_CYCLE = -6
  ERROR_UNSUPPORTED = -7
  ERROR_SINGULAR = -8
  ERROR_INTERNAL = -100
  FRUSTUM_NEAR = 0
  FRUSTUM_FAR = 1
  FRUSTUM_LEFT = 2
  FRUSTUM_RIGHT = 3
  FRUSTUM_BOTTOM = 4
  FRUSTUM_TOP = 5
  HIT_INSIDE = 1
  HIT_BACK = 2
  SHAPE_SPHERE = 1
  SHAPE_CAPSULE = 2
  SHAPE_AABB = 3
  SHAPE_OBB = 4
  SHAPE_PLANE = 5
  SHAPE_TRIANGLE = 6
  SHAPE_FRUSTUM = 7
  SHAPE_MESH = 8
  SHAPE_RAY = 16
  SHAPE_SEGMENT = 17
  SIDE_OUTSIDE = -1
  SIDE_CROSSING = 0
  SIDE_INSIDE = 1
  DEPTH_ZERO_TO_ONE = 0
  DEPTH_MINUS_ONE_TO_ONE = 1
  MESH_SURFACE = 0
  MESH_BODY_SURFACE = 1
  MESH_BODY_LINKS = 2
  MESH_HULL = 3
  FILTER_SUBTREE = 1
  FILTER_NO_BACK_FACES = 2
  FILTER_NO_FRONT_FACES = 4
  PROJECTION_PERSPECTIVE = 0
  PROJECTION_ORTHOGRAPHIC = 1
  PROJECTION_USER = 2
  LEFT_HANDED = 0
  RIGHT_HANDED = 1
  PICK_FROM_NEAR_PLANE = 0
  PICK_FROM_CENTRE = 1
  CLOTH_SHEAR = 1
  CLOTH_BEND = 2
  BODY_PARTICLES = 1
  BODY_ROPE = 2
  BODY_CLOTH = 3
  SOLVE_FREE = 0
  SOLVE_DIRECT = 1
  SOLVE_GRAPH = 2
  CONSTRAINT_DISTANCE = 0
  CONSTRAINT_MAX_DISTANCE = 1
  VERSION_MAJOR = 1
  VERSION_MINOR = 1
  VERSION_PATCH = 0
  MAX_COORDINATE = 1000000000000000.0
  NO_TRIANGLE = 4294967295
  NO_PARTICLE = 4294967295
  ALL_LAYERS = 4294967295

  module Float32
    extend Plain
    FORMAT, COUNT, BYTES = 'f', 1, 4
    def self.from(n) = n[0]
  end

  module Float64
    extend Plain
    FORMAT, COUNT, BYTES = 'd', 1, 8
    def self.from(n) = n[0]
  end

  module Int32
    extend Plain
    FORMAT, COUNT, BYTES = 'l', 1, 4
    def self.from(n) = n[0]
  end

  module UInt32
    extend Whole
    FORMAT, COUNT, BYTES = 'L', 1, 4
    def self.from(n) = n[0]
  end

  module Vec3 # an Array of 3 numbers
    extend Plain
    FORMAT, COUNT, BYTES = 'f3', 3, 12
  end

  module Quat # an Array of 4 numbers
    extend Plain
    FORMAT, COUNT, BYTES = 'f4', 4, 16
  end

  module Mat4 # an Array of 16 numbers
    extend Plain
    FORMAT, COUNT, BYTES = 'f16', 16, 64
  end

  # x -> position + rotation * (scale * x); scale > 0.
  Transform = ::Struct.new(:position, :rotation, :scale) do
    extend Value

    # In order or by name; what is not given is the identity.
    def initialize(place = [0, 0, 0], turn = [0, 0, 0, 1], size = 1, position: place, rotation: turn, scale: size)
      super(position, rotation, scale)
    end

    def self.coerce(value) = value.is_a?(Hash) ? new(**value) : super
    def self.from(n) = new(n[0, 3], n[3, 4], n[7])
    def numbers = [*position, *rotation, scale]
  end
  Transform::FORMAT, Transform::COUNT, Transform::BYTES = 'f8', 8, 32

  Ray = ::Struct.new(:origin, :direction, :t_max) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6])
    def numbers = [*origin, *direction, t_max]
  end
  Ray::FORMAT, Ray::COUNT, Ray::BYTES = 'f7', 7, 28
  Ray::KIND = SHAPE_RAY

  Segment = ::Struct.new(:a, :b) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3])
    def numbers = [*a, *b]
  end
  Segment::FORMAT, Segment::COUNT, Segment::BYTES = 'f6', 6, 24
  Segment::KIND = SHAPE_SEGMENT

  Sphere = ::Struct.new(:center, :radius) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3])
    def numbers = [*center, radius]
  end
  Sphere::FORMAT, Sphere::COUNT, Sphere::BYTES = 'f4', 4, 16
  Sphere::KIND = SHAPE_SPHERE

  # All points within radius of the segment a b.
  Capsule = ::Struct.new(:a, :b, :radius) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6])
    def numbers = [*a, *b, radius]
  end
  Capsule::FORMAT, Capsule::COUNT, Capsule::BYTES = 'f7', 7, 28
  Capsule::KIND = SHAPE_CAPSULE

  Aabb = ::Struct.new(:min, :max) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3])
    def numbers = [*min, *max]
  end
  Aabb::FORMAT, Aabb::COUNT, Aabb::BYTES = 'f6', 6, 24
  Aabb::KIND = SHAPE_AABB

  Obb = ::Struct.new(:center, :half_extents, :rotation) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6, 4])
    def numbers = [*center, *half_extents, *rotation]
  end
  Obb::FORMAT, Obb::COUNT, Obb::BYTES = 'f10', 10, 40
  Obb::KIND = SHAPE_OBB

  # The points x with dot(normal, x) = distance. The normal points to the front; it need not be
  # exactly unit: signed distances are divided by its length (for a unit normal, distance is the
  # plane's distance from the origin). distance divided by that length is within the range of
  # coordinates too.
  Plane = ::Struct.new(:normal, :distance) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3])
    def numbers = [*normal, distance]
  end
  Plane::FORMAT, Plane::COUNT, Plane::BYTES = 'f4', 4, 16
  Plane::KIND = SHAPE_PLANE

  # May be degenerate: then it is the segment or point that its corners span. The normal is that
  # of cross(b - a, c - a).
  Triangle = ::Struct.new(:a, :b, :c) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6, 3])
    def numbers = [*a, *b, *c]
  end
  Triangle::FORMAT, Triangle::COUNT, Triangle::BYTES = 'f9', 9, 36
  Triangle::KIND = SHAPE_TRIANGLE

  # The points x with dot(planes[i].normal, x - origin) >= planes[i].distance for all six planes,
  # which look inward, in the order of FRUSTUM_NEAR, FAR and so on. Distances count from origin, so that a
  # frustum far out loses nothing to rounding. An infinite far plane is normal 0, distance -1.
  Frustum = ::Struct.new(:origin, :planes) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 24].each_slice(4).map { |m| Plane.from(m) })
    def numbers = [*origin, *planes.flat_map { |each| Plane.coerce(each).numbers }]
  end
  Frustum::FORMAT, Frustum::COUNT, Frustum::BYTES = 'f27', 27, 108
  Frustum::KIND = SHAPE_FRUSTUM

  # Where a ray, segment or swept sphere first meets something.
  Hit = ::Struct.new(:model, :tag, :t, :point, :normal, :triangle, :u, :v, :flags) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3, 3], n[6, 3], n[9], n[10], n[11], n[12])
    def numbers = [model, tag, t, *point, *normal, triangle, u, v, flags]
  end
  Hit::FORMAT, Hit::COUNT, Hit::BYTES = 'L2f7Lf2L', 13, 52

  # The closest point of something to a given point.
  Nearest = ::Struct.new(:model, :tag, :point, :distance, :triangle) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2, 3], n[5], n[6])
    def numbers = [model, tag, *point, distance, triangle]
  end
  Nearest::FORMAT, Nearest::COUNT, Nearest::BYTES = 'L2f4L', 7, 28

  # How far a ray goes and what it hits: fields of a Hit. Frozen.  Since 1.1.
  Distance = ::Struct.new(:t, :model, :triangle) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2])
    def numbers = [t, model, triangle]
  end
  Distance::FORMAT, Distance::COUNT, Distance::BYTES = 'fL2', 3, 12

  # How a solid gets out of something that it overlaps.
  Penetration = ::Struct.new(:model, :tag, :point, :normal, :depth, :triangle) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2, 3], n[5, 3], n[8], n[9])
    def numbers = [model, tag, *point, *normal, depth, triangle]
  end
  Penetration::FORMAT, Penetration::COUNT, Penetration::BYTES = 'L2f7L', 10, 40

  # What is in a triangle array. Frozen.
  MeshReport = ::Struct.new(:triangle_count, :degenerate_count, :first_degenerate, :out_of_range_count, :first_out_of_range, :bad_vertex_count, :first_bad_vertex, :open_edge_count) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7])
    def numbers = [triangle_count, degenerate_count, first_degenerate, out_of_range_count, first_out_of_range, bad_vertex_count, first_bad_vertex, open_edge_count]
  end
  MeshReport::FORMAT, MeshReport::COUNT, MeshReport::BYTES = 'L8', 8, 32

  # What a mesh is. Frozen.  Since 1.1.
  MeshInfo = ::Struct.new(:kind, :vertex_count, :triangle_count, :deformable, :follows_body) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4])
    def numbers = [kind, vertex_count, triangle_count, deformable, follows_body]
  end
  MeshInfo::FORMAT, MeshInfo::COUNT, MeshInfo::BYTES = 'lL2l2', 5, 20

  # How an octree is made up: a tree of boxes around the models of a scene or the triangles of a mesh, with at most
  # eight children a node (a bounding volume hierarchy). It has no cells, and no size or depth to choose. Frozen.
  OctreeStats = ::Struct.new(:item_count, :unbounded_count, :node_count, :leaf_count, :depth, :rebuilds, :cost, :memory_bytes) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7])
    def numbers = [item_count, unbounded_count, node_count, leaf_count, depth, rebuilds, cost, memory_bytes]
  end
  OctreeStats::FORMAT, OctreeStats::COUNT, OctreeStats::BYTES = 'L6fL', 8, 32

  # One box of an octree, for drawing. Frozen.
  OctreeBox = ::Struct.new(:bounds, :depth, :item_count) do
    extend Value

    def self.from(n) = new(Aabb.from(n[0, 6]), n[6], n[7])
    def numbers = [*Aabb.coerce(bounds).numbers, depth, item_count]
  end
  OctreeBox::FORMAT, OctreeBox::COUNT, OctreeBox::BYTES = 'f6L2', 8, 32

  # What a model is. Frozen.
  ModelInfo = ::Struct.new(:type, :parent, :layers, :tag, :child_count) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4])
    def numbers = [type, parent, layers, tag, child_count]
  end
  ModelInfo::FORMAT, ModelInfo::COUNT, ModelInfo::BYTES = 'lL4', 5, 20

  # Orbit control: the camera circles a target. Inputs accumulate between updates in plain units;
  # nothing depends on the frame time or on how often update is called. Frozen.
  Orbit = ::Struct.new(:target, :up, :distance, :yaw, :pitch, :radians_per_unit, :metres_per_unit, :min_distance, :max_distance, :min_pitch, :max_pitch) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6], n[7], n[8], n[9], n[10], n[11], n[12], n[13], n[14])
    def numbers = [*target, *up, distance, yaw, pitch, radians_per_unit, metres_per_unit, min_distance, max_distance, min_pitch, max_pitch]
  end
  Orbit::FORMAT, Orbit::COUNT, Orbit::BYTES = 'f15', 15, 60

  # What a unit of each input moves an orbit by; negative to invert one. Frozen.  Since 1.1.
  OrbitSpeeds = ::Struct.new(:rotate_x, :rotate_y, :zoom, :pan_x, :pan_y) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4])
    def numbers = [rotate_x, rotate_y, zoom, pan_x, pan_y]
  end
  OrbitSpeeds::FORMAT, OrbitSpeeds::COUNT, OrbitSpeeds::BYTES = 'f5', 5, 20

  # What a solver was created with and may change later. Fields as in SolverDesc. Frozen.
  SolverSettings = ::Struct.new(:gravity, :substeps, :fixed_step, :max_steps, :sleep_speed, :sleep_strain, :sleep_time, :max_strain, :tolerance, :max_substeps, :max_work) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3], n[4], n[5], n[6], n[7], n[8], n[9], n[10], n[11], n[12])
    def numbers = [*gravity, substeps, fixed_step, max_steps, sleep_speed, sleep_strain, sleep_time, max_strain, tolerance, max_substeps, max_work]
  end
  SolverSettings::FORMAT, SolverSettings::COUNT, SolverSettings::BYTES = 'f3LfLf5L2', 13, 52

  # What all particles of a body share and may change later. Fields as in BodyDesc. Frozen.
  BodySettings = ::Struct.new(:damping, :friction, :static_friction, :restitution, :layers, :body_layers, :self_collision) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6])
    def numbers = [damping, friction, static_friction, restitution, layers, body_layers, self_collision]
  end
  BodySettings::FORMAT, BodySettings::COUNT, BodySettings::BYTES = 'f4L3', 7, 28

  # Frozen.
  BodyInfo = ::Struct.new(:kind, :method, :particle_count, :constraint_count, :triangle_count) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4])
    def numbers = [kind, method, particle_count, constraint_count, triangle_count]
  end
  BodyInfo::FORMAT, BodyInfo::COUNT, BodyInfo::BYTES = 'l2L3', 5, 20

  # The air around a body. Frozen.
  Wind = ::Struct.new(:velocity, :density, :drag, :lift) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3], n[4], n[5])
    def numbers = [*velocity, density, drag, lift]
  end
  Wind::FORMAT, Wind::COUNT, Wind::BYTES = 'f6', 6, 24

  # Where an animation wants a particle, and how far from there the particle may be. Frozen.
  AnimationTarget = ::Struct.new(:position, :normal, :max_distance, :backstop) do
    extend Value

    def self.from(n) = new(n[0, 3], n[3, 3], n[6], n[7])
    def numbers = [*position, *normal, max_distance, backstop]
  end
  AnimationTarget::FORMAT, AnimationTarget::COUNT, AnimationTarget::BYTES = 'f8', 8, 32

  # A particle that is attached to a model. Frozen.  Since 1.1.
  Attachment = ::Struct.new(:particle, :model, :local_point) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2, 3])
    def numbers = [particle, model, *local_point]
  end
  Attachment::FORMAT, Attachment::COUNT, Attachment::BYTES = 'L2f3', 5, 20

  # One constraint. Frozen.
  ConstraintInfo = ::Struct.new(:id, :particle_a, :particle_b, :rest_length, :compliance) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4])
    def numbers = [id, particle_a, particle_b, rest_length, compliance]
  end
  ConstraintInfo::FORMAT, ConstraintInfo::COUNT, ConstraintInfo::BYTES = 'L3f2', 5, 20

  # The settings of a constraint. Frozen.
  ConstraintSettings = ::Struct.new(:rest_length, :compliance, :damping) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2])
    def numbers = [rest_length, compliance, damping]
  end
  ConstraintSettings::FORMAT, ConstraintSettings::COUNT, ConstraintSettings::BYTES = 'f3', 3, 12

  # One joint. Frozen.
  JointInfo = ::Struct.new(:id, :body_a, :particle_a, :body_b, :particle_b, :rest_length, :compliance, :force) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7])
    def numbers = [id, body_a, particle_a, body_b, particle_b, rest_length, compliance, force]
  end
  JointInfo::FORMAT, JointInfo::COUNT, JointInfo::BYTES = 'L5f3', 8, 32

  # A constraint that broke, or that the caller has broken. Frozen.  Since 1.1.
  Break = ::Struct.new(:body, :constraint, :particle_a, :particle_b, :torn_particle, :new_particle, :load) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6])
    def numbers = [body, constraint, particle_a, particle_b, torn_particle, new_particle, load]
  end
  Break::FORMAT, Break::COUNT, Break::BYTES = 'L6f', 7, 28

  # Frozen.
  SolverStats = ::Struct.new(:particle_count, :pinned_count, :constraint_count, :contact_count, :strain_max, :strain_rms, :kinetic_energy, :potential_energy) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4], n[5], n[6], n[7])
    def numbers = [particle_count, pinned_count, constraint_count, contact_count, strain_max, strain_rms, kinetic_energy, potential_energy]
  end
  SolverStats::FORMAT, SolverStats::COUNT, SolverStats::BYTES = 'L4f4', 8, 32

  # A particle that touched a model in the last step. Frozen.
  Contact = ::Struct.new(:body, :particle, :model, :tag, :point, :normal) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4, 3], n[7, 3])
    def numbers = [body, particle, model, tag, *point, *normal]
  end
  Contact::FORMAT, Contact::COUNT, Contact::BYTES = 'L4f6', 10, 40

  # Two particles of different bodies that touched in the last step. Frozen.  Since 1.1.
  BodyContact = ::Struct.new(:body_a, :particle_a, :body_b, :particle_b, :normal, :distance, :impulse) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2], n[3], n[4, 3], n[7], n[8])
    def numbers = [body_a, particle_a, body_b, particle_b, *normal, distance, impulse]
  end
  BodyContact::FORMAT, BodyContact::COUNT, BodyContact::BYTES = 'L4f5', 9, 36

  # What bodies gave a model in the last step, by contacts and by attachments. Frozen.
  Impulse = ::Struct.new(:model, :tag, :linear, :angular) do
    extend Value

    def self.from(n) = new(n[0], n[1], n[2, 3], n[5, 3])
    def numbers = [model, tag, *linear, *angular]
  end
  Impulse::FORMAT, Impulse::COUNT, Impulse::BYTES = 'L2f6', 8, 32
end
