import { depthProblem } from '../base/json-depth.ts'

type Check = (value: unknown) => boolean

const isText: Check = (value) => typeof value === 'string'
const isIndex: Check = (value) => Number.isSafeInteger(value) && (value as number) >= 0
const isNumber: Check = (value) => Number.isFinite(value)
const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value)
const listOf =
  (check: Check): Check =>
  (value) =>
    Array.isArray(value) && value.every(check)
const mapOf =
  (check: Check): Check =>
  (value) =>
    isObject(value) && Object.values(value).every(check)
/** Creates a check of an object with optional fields. The object may have further fields. */
const shape =
  (fields: Record<string, Check>): Check =>
  (value) =>
    isObject(value) &&
    Object.entries(fields).every(([name, check]) => value[name] === undefined || check(value[name]))
/** Creates a check of an object with required and optional fields. The object may have further fields. */
const shapeWith =
  (required: Record<string, Check>, fields: Record<string, Check> = {}): Check =>
  (value) =>
    shape({ ...required, ...fields })(value) &&
    Object.keys(required).every((name) => (value as Record<string, unknown>)[name] !== undefined)

const textureInfo = shapeWith({ index: isIndex }, { texCoord: isIndex })

const numbers = (count: number): Check => {
  return (value) => Array.isArray(value) && value.length === count && value.every(isNumber)
}

const view = { buffer: isIndex, byteLength: isIndex }

const MESHOPT_MODES: unknown[] = ['ATTRIBUTES', 'TRIANGLES', 'INDICES']

/** Compressed buffer view of EXT_meshopt_compression or KHR_meshopt_compression. */
const compressedView = shapeWith(
  { ...view, count: isIndex, byteStride: isIndex, mode: (value) => MESHOPT_MODES.includes(value) },
  { byteOffset: isIndex },
)

const primitive = shape({
  attributes: mapOf(isIndex),
  indices: isIndex,
  material: isIndex,
  mode: isIndex,
  targets: listOf(mapOf(isIndex)),
  extensions: shape({
    KHR_draco_mesh_compression: shapeWith({ bufferView: isIndex, attributes: mapOf(isIndex) }),
  }),
})

/** Check of the items of each top-level list in a glTF file. Covers only fields that commands read. */
const LISTS: Record<string, Check> = {
  extensionsUsed: isText,
  extensionsRequired: isText,
  accessors: shapeWith(
    { componentType: isIndex, count: isIndex, type: isText },
    {
      bufferView: isIndex,
      byteOffset: isIndex,
      sparse: shapeWith({
        count: isIndex,
        indices: shapeWith({ bufferView: isIndex, componentType: isIndex }, { byteOffset: isIndex }),
        values: shapeWith({ bufferView: isIndex }, { byteOffset: isIndex }),
      }),
    },
  ),
  animations: shapeWith({
    channels: listOf(shapeWith({ sampler: isIndex, target: shape({ node: isIndex }) })),
    samplers: listOf(shapeWith({ input: isIndex, output: isIndex })),
  }),
  buffers: shape({ byteLength: isIndex, uri: isText }),
  bufferViews: shapeWith(view, {
    byteOffset: isIndex,
    byteStride: isIndex,
    extensions: mapOf(
      (extension) => isObject(extension) && (!('byteLength' in extension) || compressedView(extension)),
    ),
  }),
  cameras: isObject,
  images: shape({ name: isText, mimeType: isText, uri: isText, bufferView: isIndex }),
  textures: shape({
    name: isText,
    sampler: isIndex,
    source: isIndex,
    extensions: mapOf(shape({ source: isIndex })),
  }),
  samplers: isObject,
  materials: shape({
    name: isText,
    normalTexture: textureInfo,
    occlusionTexture: textureInfo,
    emissiveTexture: textureInfo,
    pbrMetallicRoughness: shape({ baseColorTexture: textureInfo, metallicRoughnessTexture: textureInfo }),
    extensions: isObject,
  }),
  meshes: shapeWith({ primitives: listOf(primitive) }, { name: isText }),
  nodes: shape({
    name: isText,
    mesh: isIndex,
    skin: isIndex,
    camera: isIndex,
    children: listOf(isIndex),
    matrix: numbers(16),
    translation: numbers(3),
    rotation: numbers(4),
    scale: numbers(3),
  }),
  scenes: shape({ name: isText, nodes: listOf(isIndex) }),
  skins: shapeWith({ joints: listOf(isIndex) }, { skeleton: isIndex, inverseBindMatrices: isIndex }),
}

/**
 * Checks that all fields that commands read have the types of the glTF specification. Later code relies on these types.
 *
 * @returns error text, or undefined.
 */
export function shapeProblem(json: unknown): string | undefined {
  if (!isObject(json)) return 'its JSON is not an object'
  const version = isObject(json.asset) ? json.asset.version : undefined
  if (!isText(version)) return 'its JSON has no asset.version'
  if (!(version as string).startsWith('2.')) return `it is glTF ${version}`
  const depth = depthProblem(json)
  if (depth) return depth
  for (const [name, check] of Object.entries(LISTS)) {
    const list = json[name]
    if (list === undefined) continue
    if (!Array.isArray(list)) return `${name} is not a list`
    const invalid = list.findIndex((item) => !check(item))
    if (invalid >= 0) return `${name}[${invalid}] is malformed`
  }
  return json.scene === undefined || isIndex(json.scene) ? undefined : 'its scene is not an index'
}
