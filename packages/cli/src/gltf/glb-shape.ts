/** Whether a value has its type. */
type Check = (value: unknown) => boolean

const isText: Check = (value) => typeof value === 'string'
const isIndex: Check = (value) => Number.isInteger(value) && (value as number) >= 0
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
/** An object whose fields, where present, pass their checks; other fields are ignored. */
const shape =
  (fields: Record<string, Check>): Check =>
  (value) =>
    isObject(value) &&
    Object.entries(fields).every(([name, check]) => value[name] === undefined || check(value[name]))

const textureInfo = (value: unknown) =>
  isObject(value) && isIndex(value.index) && shape({ texCoord: isIndex })(value)

const primitive = shape({
  attributes: mapOf(isIndex),
  material: isIndex,
  targets: listOf(isObject),
})

/** The lists of a glTF file that commands use, and the fields that they read. */
const LISTS: Record<string, Check> = {
  extensionsUsed: isText,
  extensionsRequired: isText,
  buffers: shape({ byteLength: isIndex, uri: isText }),
  bufferViews: shape({
    buffer: isIndex,
    byteOffset: isIndex,
    byteLength: isIndex,
    extensions: mapOf(shape({ buffer: isIndex, byteOffset: isIndex, byteLength: isIndex })),
  }),
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
    pbrMetallicRoughness: shape({ baseColorTexture: textureInfo }),
    extensions: isObject,
  }),
  meshes: (mesh) =>
    shape({ name: isText })(mesh) && listOf(primitive)((mesh as { primitives: unknown }).primitives),
  nodes: shape({ name: isText, mesh: isIndex }),
}

/**
 * Checks that what commands read of a glTF document has the types of the specification, so that no later code has to.
 *
 * @returns what is wrong, or undefined.
 */
export function shapeProblem(json: unknown): string | undefined {
  if (!isObject(json)) return 'its JSON is not an object'
  for (const [name, check] of Object.entries(LISTS)) {
    const list = json[name]
    if (list === undefined) continue
    if (!Array.isArray(list)) return `its ${name} are not a list`
    const wrong = list.findIndex((item) => !check(item))
    if (wrong >= 0) return `${name}[${wrong}] is malformed`
  }
  return undefined
}
