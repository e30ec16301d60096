@tool
class_name FurrowKtx2Slice
extends RefCounted
## Takes images out of KTX 2 texture arrays, which Godot does not read.

# Byte offsets from the Khronos KTX File Format Specification 2.0, sections 3 and 4.
const WIDTH := 20
const HEIGHT := 24
const LAYER_COUNT := 32
const LEVEL_COUNT := 40
const SCHEME := 44
const DFD := 48
const DFD_LENGTH := 52
const KVD := 56
const LEVEL := 80
const HEADER_BYTES := 104

const NONE := 0
const ZSTANDARD := 2
## Largest size of a block of 4 x 4 texels in bytes.
const BLOCK_BYTES := 16


## Returns a KTX 2 file with the largest mipmap level of one slice. Returns no bytes if the file has no such slice, or is
## compressed by another scheme than Zstandard.
static func extract(bytes: PackedByteArray, slice: int) -> PackedByteArray:
	if bytes.size() < HEADER_BYTES:
		return PackedByteArray()
	var slices := maxi(bytes.decode_u32(LAYER_COUNT), 1)
	var scheme := bytes.decode_u32(SCHEME)
	var level := bytes.slice(bytes.decode_u64(LEVEL), bytes.decode_u64(LEVEL) + bytes.decode_u64(LEVEL + 8))
	var size := bytes.decode_u64(LEVEL + 16)
	var largest := BLOCK_BYTES * ceili(bytes.decode_u32(WIDTH) / 4.0) * ceili(bytes.decode_u32(HEIGHT) / 4.0) * slices
	if slice >= slices or size > largest or (scheme != NONE and scheme != ZSTANDARD):
		return PackedByteArray()
	if scheme == ZSTANDARD:
		level = level.decompress(size, FileAccess.COMPRESSION_ZSTD)
	if level.size() != size:
		return PackedByteArray()
	var dfd := bytes.slice(bytes.decode_u32(DFD), bytes.decode_u32(DFD) + bytes.decode_u32(DFD_LENGTH))
	var file := bytes.slice(0, HEADER_BYTES)
	for offset: int in [LAYER_COUNT, SCHEME, KVD, KVD + 4]:
		file.encode_u32(offset, 0)
	file.encode_u32(LEVEL_COUNT, 1)
	file.encode_u32(DFD, HEADER_BYTES)
	file.append_array(dfd)
	while file.size() % BLOCK_BYTES != 0:
		file.append(0)
	file.encode_u64(LEVEL, file.size())
	file.encode_u64(LEVEL + 8, size / slices)
	file.encode_u64(LEVEL + 16, size / slices)
	file.append_array(level.slice(slice * size / slices, (slice + 1) * size / slices))
	return file
