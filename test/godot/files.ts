import { encodeFile } from '../../conformance/src/encode-file.ts'
import { flat, image, noise, normals, uniform } from '../../conformance/src/map-image.ts'
import type { SampleFile } from '../../conformance/src/sample.ts'

/** A square with occlusion, whose wrinkles are at rest. Its drivers read the blendshape `up` and the input `age`. */
export const FACE: SampleFile = {
  base: normals(3),
  layers: [{ name: 'skin', normal: normals(2), occlusion: noise(10) }],
  areas: [{ name: 'a', weights: uniform(255, 255, 255) }],
  targets: [{ name: 'up' }],
  drivers: [
    { type: 'morph', area: 'a', targets: [{ name: 'up' }] },
    { type: 'expression', name: 'surprised', targets: [{ name: 'up', weight: 0.5 }] },
  ],
}

export const bytesOf = (file: SampleFile): ArrayBuffer => encodeFile(file).buffer

/** A map of smooth normals, which repeats. */
const WAVES = image(64, (column, row) => {
  const [x, y] = [column, row].map((texel) => 0.4 * Math.sin((2 * Math.PI * texel) / 64))
  const length = Math.hypot(x, y, 1)
  return [x / length, y / length, 1 / length].map((value) => Math.round((value * 0.5 + 0.5) * 255))
})

/** A face whose layer has only occlusion. */
export const OCCLUDED: SampleFile = {
  ...FACE,
  base: WAVES,
  layers: [{ name: 'skin', kind: 'detail', normal: flat(), occlusion: noise(10) }],
}

/** Returns a face with tangents along +x and repeating textures. The material is changed by the fields in `change`. */
export function withMaterial({ extensions = {}, ...change }: { extensions?: object } = {}): SampleFile {
  return {
    ...OCCLUDED,
    edit(json) {
      const [material] = json.materials
      Object.assign(material, change, { extensions: { ...material.extensions, ...extensions } })
      json.extensionsUsed.push(...Object.keys(extensions))
      Object.assign(json.samplers[0], { wrapS: 10497, wrapT: 10497 })
      const { attributes } = json.meshes[0].primitives[0]
      const { count } = json.accessors[attributes.POSITION]
      const tangents = Float32Array.from({ length: 4 * count }, (_, i) =>
        i % 4 === 0 || i % 4 === 3 ? 1 : 0,
      )
      const bytes = new Uint8Array(tangents.buffer)
      const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...bytes))}`
      attributes.TANGENT = json.accessors.length
      json.accessors.push({ bufferView: json.bufferViews.length, componentType: 5126, count, type: 'VEC4' })
      json.bufferViews.push({ buffer: json.buffers.length, byteLength: bytes.length })
      json.buffers.push({ byteLength: bytes.length, uri })
    },
  }
}
