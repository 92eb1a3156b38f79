# frozen_string_literal: true

require 'ffi'

# 3D scenes: shapes and meshes, rays and overlaps, a camera, particles, ropes and cloth.
#
# Values are Structs, vectors Arrays of numbers. Batches are packed Strings, Records or Arrays of
# values; what comes back is Records over memory of the library's layout. A query that finds nothing
# returns nil; what goes wrong is raised with the library's message.
module Gamephys
  # A call failed: the message is the library's, status its number.
  class Error < StandardError
    attr_reader :status

    def initialize(status, message)
      super(message)
      @status = status
    end
  end
  class InvalidArgument < Error; end
  class InvalidId < Error; end
  class OutOfMemory < Error; end

  # An object was used after close.
  class Closed < StandardError; end

  # The C functions.
  module Low
    extend FFI::Library
    names = { 'darwin' => 'libgamephys.1.dylib', 'windows' => 'gamephys.dll' }
    name = names.fetch(FFI::Platform::OS, 'libgamephys.so.1')
    packaged = "#{__dir__}/gamephys/#{name}" # in gems of a platform
    ffi_lib ENV.fetch('GAMEPHYS_LIBRARY') { File.exist?(packaged) ? packaged : name }
  end
end

require_relative 'gamephys/runtime'
require_relative 'gamephys/values'
require_relative 'gamephys/low'
require_relative 'gamephys/methods'

module Gamephys
  number = Low.gphys_version
  VERSION = [number >> 16, number >> 8 & 255, number & 255].join('.').freeze

  # Name of a status, such as "GPHYS_NO_HIT".
  def self.status_name(status) = Low.gphys_status_name(status)

  # The orbit settings that the library starts from.
  def self.default_orbit
    orbit = Orbit.room
    Low.check(Low.gphys_orbit_init(orbit))
    Orbit.unpack(orbit)
  end

  # The shape moved by a Transform; an Aabb becomes an Obb.
  def self.transform(shape, by)
    kind = [Aabb, Mesh].include?(shape.class) ? Obb : shape.class
    moved = kind.room
    Low.check(Low.gphys_shape_transform(Low.kind(shape), Low.shape(shape), Transform.pack(by), moved))
    kind.unpack(moved)
  end

  class Scene
    SHAPES = [Sphere, Capsule, Aabb, Obb, Plane, Triangle, Frustum].to_h { |kind| [kind::KIND, kind] }.freeze
    private_constant :SHAPES

    # The shape of a model in its own coordinates; an error for a mesh, which Mesh.from_scene gives.
    def get_shape(model)
      kind = SHAPES.fetch(get_info(model).type, Frustum)
      shape = kind.room
      Low.check(Low.gphys_scene_get_shape(opened, model, shape, kind::BYTES))
      kind.unpack(shape)
    end

    alias include? has?
  end
end
