package gamephys

// #cgo pkg-config: gamephys
import "C"
