# frozen_string_literal: true

module Gamephys
  # What every kind of value knows: FORMAT of Array#pack, COUNT of its numbers and BYTES of its struct,
  # which holds them without gaps.
  module Kind
    # Memory for values to be written by the library.
    def room(count = 1) = "\0".b * (count * self::BYTES)

    def unpack(memory, at = 0) = from(memory.unpack(self::FORMAT, offset: at))

    def unpack_all(memory, count) = Array.new(count) { |i| unpack(memory, i * self::BYTES) }

    def pack(value)
      numbers = numbers_of(value)
      raise ArgumentError, "#{name} has #{self::COUNT} numbers, got #{numbers.size}" if numbers.size != self::COUNT

      numbers.pack(self::FORMAT)
    end

    def pack_all(values, count = values.size)
      raise ArgumentError, "expected #{count} of #{name}, got #{values.size}" if values.size != count

      values.map { |value| pack(value) }.join
    end
  end

  # Numbers, and vectors as Arrays of them.
  module Plain
    include Kind

    def from(numbers) = numbers
    def numbers_of(value) = Array(value)
  end

  # Ids, indices and words.
  module Whole
    include Plain

    def numbers_of(value) = super.map { |number| Low.whole(number) }
  end

  # Structs, for which an Array or a Hash of their fields does too.
  module Value
    include Kind

    def numbers_of(value) = coerce(value).numbers

    def coerce(value)
      case value
      when self then value
      when Hash then new(*members.map { |member| value.fetch(member) })
      when Array then new(*value)
      else raise TypeError, "#{value.class} is no #{name}"
      end
    end
  end

  # Elements of a batch in the library's layout. They are read from memory when asked for.
  class Records
    include Enumerable
    attr_reader :kind, :size, :pointer

    def initialize(kind, size, pointer = FFI::MemoryPointer.new(:uint8, [kind::BYTES * size, 1].max))
      bytes = kind::BYTES * size
      raise ArgumentError, "#{size} of #{kind.name} need #{bytes} bytes, not #{pointer.size}" if size.negative? || pointer.size < bytes

      @kind = kind
      @size = size
      @pointer = pointer
    end

    def [](index)
      raise IndexError, "no element #{index}" unless index.between?(0, size - 1)

      kind.unpack(pointer.get_bytes(index * kind::BYTES, kind::BYTES))
    end

    def []=(index, value)
      raise IndexError, "no element #{index}" unless index.between?(0, size - 1)

      pointer.put_bytes(index * kind::BYTES, kind.pack(value))
    end

    def each
      return to_enum(:each) { size } unless block_given?

      bytes = to_s
      size.times { |i| yield kind.unpack(bytes, i * kind::BYTES) }
    end

    # All bytes, for String#unpack.
    def to_s = pointer.get_bytes(0, kind::BYTES * size)
  end

  # Owns one object of the library, which is freed by close, or when nothing refers to it.
  class Owned
    # Yields a new object and closes it after the block.
    def self.open(...)
      object = new(...)
      return object unless block_given?

      begin
        yield object
      ensure
        object.close
      end
    end

    # Frees the object now. Using it afterwards raises Closed; closing again does nothing.
    def close
      @pointer&.free
      @pointer = nil
    end

    # The C object.
    def opened = @pointer || raise(Closed, "#{self.class.name} is closed")

    # A copy would own the same C object.
    def initialize_copy(_other) = raise(TypeError, "#{self.class.name} cannot be copied")

    private

    def own(kind)
      made = FFI::MemoryPointer.new(:pointer)
      Low.check(yield(made))
      @pointer = kind.new(made.read_pointer)
    end
  end

  # Turns arguments into memory and statuses into results.
  module Low
    Memory = ::Struct.new(:kind, :pointer, :count, :stride, :kept)
    ERRORS = { -1 => InvalidArgument, -2 => InvalidId, -4 => OutOfMemory }.freeze
    OK, INCOMPLETE = 0, 2
    FIRST_GUESS = 64

    module_function

    def check(status)
      raise ERRORS.fetch(status, Error).new(status, gphys_last_error.force_encoding(Encoding::UTF_8)) if status.negative?

      status
    end

    def found(status) = check(status) == OK

    # A status that is an answer: OK is yes, the one given is no.
    def answered(status, no) = status != no && found(status)

    # A number as it is, of which 32 bits would hold another one if it is not such.
    def whole(value)
      raise TypeError, "expected a whole number, got #{value.inspect}" unless value.is_a?(Integer)
      raise RangeError, "#{value} is not a whole number from 0 to 4294967295" unless value.between?(0, 0xffffffff)

      value
    end

    def flag(value)
      return value if value.is_a?(Integer)

      value ? 1 : 0
    end

    # Settings: the library's defaults, changed by keywords; nil, which stands for them, without any.
    def desc(kind, init, fields)
      fields.empty? ? nil : filled(kind.new, init, fields)
    end

    def filled(made, init, fields)
      check(public_send(init, made, made.class.size))
      fields.each do |name, value|
        unless made.members.include?(name) && !lists_of(made).value?(name)
          raise ArgumentError, "#{made.class.name.split('::').last} has no field #{name}"
        end
        next list_into(made, name, value) if lists_of(made).key?(name)

        value.is_a?(Array) ? value.each_with_index { |number, i| made[name][i] = number } : made[name] = value
      end
      made
    end

    # The lists among a struct's fields, and the fields with their lengths.
    def lists_of(made) = made.class.const_defined?(:LISTS) ? made.class::LISTS : {}

    # A list of ids, whose memory the struct keeps.
    def list_into(made, name, value)
      given = array(UInt32, value || [])
      memory = given.pointer
      memory = FFI::MemoryPointer.new(:uint8, [memory.bytesize, 1].max).put_bytes(0, memory) if memory.is_a?(String)
      made[name] = given.count.zero? ? nil : memory
      made[lists_of(made)[name]] = given.count
    end

    def kind(shape)
      shape.class.const_defined?(:KIND) ? shape.class::KIND : raise(TypeError, "#{shape.class} is not a shape")
    end

    # The C object of a given one.
    def opened(object, kind)
      object.is_a?(kind) ? object.opened : raise(TypeError, "#{object.class.name} is no #{kind.name}")
    end

    def shape(shape) = shape.is_a?(Mesh) ? shape.opened : shape.class.pack(shape)

    # Memory of a batch, its number of elements and the bytes between them. One value stands for all: it
    # has no number, and a step of 0. Strings and pointers are taken as they are.
    def array(kind, given, width = 1)
      bytes = kind::BYTES * width
      case given
      when nil then Memory.new(kind, nil, nil, 0)
      when Records
        raise TypeError, "expected #{kind.name}, got #{given.kind.name}" if given.kind != kind

        sized(kind, given.pointer, given.size * kind::BYTES, bytes)
      when String then sized(kind, given, given.bytesize, bytes)
      when FFI::Pointer then sized(kind, given, given.size, bytes)
      when Array
        packed = kind::COUNT == 1 ? kind.pack_all(given.flatten) : kind.pack_all(given)
        sized(kind, packed, packed.bytesize, bytes)
      else Memory.new(kind, kind.pack(given), nil, 0)
      end
    end

    def sized(kind, memory, size, bytes)
      raise ArgumentError, "not a whole number of elements of #{bytes} bytes" if size % bytes != 0

      Memory.new(kind, memory, size / bytes, bytes)
    end

    # The same for shapes: Records of them, an Array of one kind, or one that stands for all.
    def shapes(given)
      case given
      when Mesh then Memory.new(Mesh, given.opened, nil, 0)
      when Records then array(given.kind, given)
      when Array
        of = given.empty? ? Sphere : given.first.class # no shapes are of any kind
        kind(given.first) unless given.empty?
        array(of, given)
      else
        kind(given)
        array(given.class, given)
      end
    end

    # The same for settings: an Array of Hashes, or one Hash that stands for all.
    def descs(kind, init, given)
      case given
      when nil then Memory.new(kind, nil, nil, 0)
      when Hash then Memory.new(kind, filled(kind.new, init, given), nil, 0)
      when Array
        memory = FFI::MemoryPointer.new(kind, [given.size, 1].max)
        kept = given.each_with_index.map { |fields, i| filled(kind.new(memory + i * kind.size), init, fields) }
        Memory.new(kind, memory, given.size, kind.size, kept)
      else raise TypeError, "#{given.class} is neither an Array of Hashes nor a Hash"
      end
    end

    # The length that batches share.
    def common(*arrays)
      counts = arrays.filter_map(&:count).uniq
      raise ArgumentError, "batches of different lengths: #{counts.join(', ')}" if counts.size > 1

      counts.first || raise(ArgumentError, 'no batch says how many there are')
    end

    # Room for results: the caller's, if it gave some.
    def results(kind, out, count)
      return Records.new(kind, count) if out.nil?
      raise TypeError, "room must be Records of #{kind.name}" unless out.is_a?(Records) && out.kind == kind
      raise ArgumentError, "room for #{out.size} results, not #{count}" if out.size != count

      out
    end

    # All elements of a list, whose call is repeated with enough room if it has to be.
    def list(kind)
      total = FFI::MemoryPointer.new(:uint32)
      capacity = FIRST_GUESS
      loop do
        out = FFI::MemoryPointer.new(:uint8, kind::BYTES * capacity)
        complete = check(yield(out, capacity, total)) != INCOMPLETE
        return Records.new(kind, total.read_uint32, out) if complete

        capacity = total.read_uint32
      end
    end

    # A list for each element: those of element i are values[offsets[i]...offsets[i + 1]].
    def ragged(kind, count)
      offsets = FFI::MemoryPointer.new(:uint32, count + 1)
      capacity = [FIRST_GUESS, count].max
      loop do
        out = FFI::MemoryPointer.new(:uint8, kind::BYTES * capacity)
        complete = check(yield(out, capacity, offsets)) != INCOMPLETE
        ends = offsets.read_array_of_uint32(count + 1)
        return Records.new(kind, ends.last, out), ends if complete

        capacity = ends.last
      end
    end
  end
end
