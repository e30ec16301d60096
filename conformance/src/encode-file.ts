import { encode } from 'fast-png'
import type { MapImage } from './map-image.ts'
import type { SampleFile, SampleLayer, SampleTarget } from './sample.ts'

const FLOAT = 5126
const UNSIGNED_SHORT = 5123

/** Sampler with linear filtering, without mipmaps, clamped to the edge. */
const SAMPLER = { magFilter: 9729, minFilter: 9729, wrapS: 33071, wrapT: 33071 }

/** Number of rows and of columns of vertices in each mesh. With four corner vertices only, a mesh would be too coarse to deform. */
const ROWS = 5

/** Encodes a sample file as .glb. Uses no library, because a library would reject or correct files that break rules. */
export function encodeFile(file: SampleFile): Uint8Array<ArrayBuffer> {
  const buffer = new BufferWriter()
  const images = new ImageWriter(buffer)
  const { targets = [], nodes = [], uvs = {} } = file
  const normalTexture = file.base && textureInfo(images.add(file.base), file)
  const material = {
    name: 'skin',
    pbrMetallicRoughness: { metallicFactor: 0 },
    ...(normalTexture && {
      normalTexture: { ...normalTexture, scale: file.baseScale, ...transformOf(file) },
    }),
    extensions: {
      // Turns highlights off, so that pictures show only diffuse shading.
      KHR_materials_specular: { specularFactor: 0 },
      FURROW_wrinkle_maps: {
        layers: file.layers.map((layer) => layerJson(layer, images, file)),
        areas: file.areas.map(({ name, layer, weights, channel, combine, activation }) => ({
          name,
          layer,
          texture: textureInfo(images.add(weights), file),
          channel,
          combine,
          activation,
        })),
        drivers: file.drivers,
      },
    },
  }
  const halves = file.isHalved ? [[0, 0.5] as const, [0.5, 1] as const] : [[0, 1] as const]
  const meshes = halves.map(([left, right], i) => ({
    name: `square${i}`,
    primitives: [{ ...sheet(buffer, left, right, targets, uvs), material: 0 }],
    ...(targets.length > 0 && {
      weights: targets.map(() => 0),
      extras: { targetNames: targets.map(({ name }) => name) },
    }),
  }))
  const json = {
    asset: { version: '2.0', generator: 'Furrow conformance' },
    extensionsUsed: [
      'FURROW_wrinkle_maps',
      'KHR_materials_specular',
      ...(uvs.transform ? ['KHR_texture_transform'] : []),
    ],
    scene: 0,
    scenes: [{ nodes: [...meshes, ...nodes].map((_, i) => i) }],
    nodes: [...meshes.map(({ name }, mesh) => ({ name, mesh })), ...nodes],
    meshes,
    materials: [material],
    samplers: [SAMPLER],
    textures: images.json.map((_, source) => ({ source, sampler: 0 })),
    images: images.json,
    accessors: buffer.accessors,
    bufferViews: buffer.views,
    buffers: [{ byteLength: buffer.length }],
  }
  file.edit?.(json)
  return glb(json, buffer)
}

function layerJson(layer: SampleLayer, images: ImageWriter, file: SampleFile): object {
  const info = (map: MapImage | undefined, more: object = {}) =>
    map && { ...textureInfo(images.add(map), file), ...more }
  const { normal, normalScale, baseColor, roughness, occlusion, occlusionStrength } = layer
  const { blood, bloodAmplitude, onset, onsetStrength } = layer
  return {
    name: layer.name,
    kind: layer.kind,
    normalTexture: info(normal, { scale: normalScale }),
    baseColorTexture: info(baseColor),
    roughnessTexture: info(roughness),
    occlusionTexture: info(occlusion, { strength: occlusionStrength }),
    bloodTexture: info(blood, { amplitude: bloodAmplitude }),
    onsetTexture: info(onset, { strength: onsetStrength }),
  }
}

function textureInfo(index: number, { uvs = {} }: SampleFile): object {
  return { index, texCoord: uvs.set }
}

function transformOf({ uvs = {} }: SampleFile): object {
  const { transform, set } = uvs
  return transform ? { extensions: { KHR_texture_transform: { ...transform, texCoord: set } } } : {}
}

/**
 * Writes the mesh of a part of the square. The whole square faces +z and spans -1..1 in x and y.
 *
 * @param left left edge of the part, as a fraction of the square, 0..1.
 * @param right right edge of the part, 0..1.
 */
function sheet(
  buffer: BufferWriter,
  left: number,
  right: number,
  targets: readonly SampleTarget[],
  { set = 0, scale = 1, offset = [0, 0] }: NonNullable<SampleFile['uvs']>,
) {
  const corners = Array.from({ length: ROWS * ROWS }, (_, i) => {
    const across = left + ((right - left) * (i % ROWS)) / (ROWS - 1)
    return [across, Math.floor(i / ROWS) / (ROWS - 1)] as const
  })
  const positions = corners.flatMap(([x, y]) => [2 * x - 1, 1 - 2 * y, 0])
  const uv = corners.flatMap(([x, y]) => [x * scale + offset[0], y * scale + offset[1]])
  const indices = Array.from({ length: (ROWS - 1) ** 2 }, (_, i) => {
    const first = Math.floor(i / (ROWS - 1)) * ROWS + (i % (ROWS - 1))
    return [first, first + ROWS, first + 1, first + 1, first + ROWS, first + ROWS + 1]
  })
  const attributes = {
    POSITION: buffer.floats('VEC3', positions, true),
    NORMAL: buffer.floats(
      'VEC3',
      corners.flatMap(() => [0, 0, 1]),
    ),
    // TEXCOORD_0 differs from TEXCOORD_1, so that a loader that uses the wrong set gives wrong results. The coordinates u and v have the
    // same directions in both sets, because engines derive tangents from TEXCOORD_0.
    ...(set === 1 && {
      TEXCOORD_0: buffer.floats(
        'VEC2',
        uv.map((value) => 0.5 * value + 0.25),
      ),
    }),
    [`TEXCOORD_${set}`]: buffer.floats('VEC2', uv),
  }
  return {
    attributes,
    indices: buffer.indices(indices.flat()),
    ...(targets.length > 0 && {
      targets: targets.map(({ move = () => [0, 0, 0] }) => ({
        POSITION: buffer.floats(
          'VEC3',
          corners.flatMap(([x, y]) => move(2 * x - 1, 1 - 2 * y)),
          true,
        ),
      })),
    }),
  }
}

/** Writes the images of a file. Stores each image once. */
class ImageWriter {
  readonly json: { name: string; mimeType: string; bufferView: number }[] = []
  readonly #indices = new Map<MapImage, number>()
  readonly #buffer: BufferWriter

  constructor(buffer: BufferWriter) {
    this.#buffer = buffer
  }

  add(map: MapImage): number {
    const known = this.#indices.get(map)
    if (known !== undefined) return known
    const index = this.json.length
    this.#indices.set(map, index)
    const bufferView = this.#buffer.view(encode({ ...map, channels: 3 }))
    this.json.push({ name: `map${index}`, mimeType: 'image/png', bufferView })
    return index
  }
}

class BufferWriter {
  readonly views: object[] = []
  readonly accessors: object[] = []
  readonly #parts: Uint8Array[] = []
  length = 0

  view(bytes: Uint8Array): number {
    const padded = new Uint8Array(Math.ceil(bytes.length / 4) * 4)
    padded.set(bytes)
    this.#parts.push(padded)
    this.views.push({ buffer: 0, byteOffset: this.length, byteLength: bytes.length })
    this.length += padded.length
    return this.views.length - 1
  }

  /**
   * Writes vectors as floats. Returns the index of the accessor.
   *
   * @param hasBounds whether to write `min` and `max`, which glTF requires for positions.
   */
  floats(type: 'VEC2' | 'VEC3', values: readonly number[], hasBounds = false): number {
    const data = Float32Array.from(values)
    const size = type === 'VEC2' ? 2 : 3
    const bufferView = this.view(new Uint8Array(data.buffer))
    const along = (axis: number) => [...data].filter((_, i) => i % size === axis)
    const axes = Array.from({ length: size }, (_, axis) => axis)
    const bounds = hasBounds && {
      min: axes.map((axis) => Math.min(...along(axis))),
      max: axes.map((axis) => Math.max(...along(axis))),
    }
    return this.#accessor({ bufferView, componentType: FLOAT, type, count: data.length / size, ...bounds })
  }

  indices(values: readonly number[]): number {
    const bufferView = this.view(new Uint8Array(Uint16Array.from(values).buffer))
    return this.#accessor({
      bufferView,
      componentType: UNSIGNED_SHORT,
      type: 'SCALAR',
      count: values.length,
    })
  }

  #accessor(json: object): number {
    this.accessors.push(json)
    return this.accessors.length - 1
  }

  bytes(): Uint8Array {
    const all = new Uint8Array(this.length)
    let at = 0
    for (const part of this.#parts) {
      all.set(part, at)
      at += part.length
    }
    return all
  }
}

/** Joins JSON and binary chunk to a .glb (glTF 2.0, section 4.4). */
function glb(json: object, buffer: BufferWriter): Uint8Array<ArrayBuffer> {
  const text = new TextEncoder().encode(JSON.stringify(json))
  const jsonLength = Math.ceil(text.length / 4) * 4
  const file = new Uint8Array(12 + 8 + jsonLength + 8 + buffer.length)
  const view = new DataView(file.buffer)
  for (const [i, value] of [0x46546c67, 2, file.length, jsonLength, 0x4e4f534a].entries()) {
    view.setUint32(4 * i, value, true)
  }
  file.fill(0x20, 20, 20 + jsonLength).set(text, 20)
  view.setUint32(20 + jsonLength, buffer.length, true)
  view.setUint32(24 + jsonLength, 0x004e4942, true)
  file.set(buffer.bytes(), 28 + jsonLength)
  return file
}
