# frozen_string_literal: true

Gem::Specification.new do |spec|
  spec.name = 'gamephys'
  spec.version = File.read("#{__dir__}/lib/gamephys/values.rb").scan(/VERSION_(?:MAJOR|MINOR|PATCH) = (\d+)/).join('.')
  spec.summary = 'A 3D scene library: ray casts, overlap and nearest queries, culling, picking, ropes and cloth'
  spec.description = 'Objects and methods over the native library gamephys, which is written in C++ and computes the same bits on every processor.'
  spec.authors = ['The gamephys authors']
  spec.license = 'MIT'
  spec.platform = Gem::Platform.local if Dir["#{__dir__}/lib/gamephys/*.{so.*,dylib,dll}"].any? # a library lies in it
  spec.files = Dir.chdir(__dir__) { Dir['lib/**/*.{rb,so.*,dylib,dll}', 'README.md', 'LICENSE'] }
  spec.required_ruby_version = '>= 3.1'
  spec.add_runtime_dependency 'ffi', '~> 1.15'
end
