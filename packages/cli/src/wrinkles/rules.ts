import { FurrowError, parseWrinkleMaps, WRINKLE_MAPS } from 'furrow'
import { firstLine } from '../errors.ts'
import type { Glb } from '../gltf/glb-file.ts'
import { jointNamesOf, targetNamesOf } from '../gltf/gltf-json.ts'
import { imageOf, layerCount } from '../gltf/texture-image.ts'
import { arrayOf } from '../gltf/texture-pixels.ts'
import { errorFinding, type Finding, warningFinding } from '../validate/finding.ts'
import { findDriverFaults } from './driver-faults.ts'
import { type Inspection, inspectWrinkles } from './inspect.ts'
import { MAP_SLOTS, type WrinkledFile, wrinkledMaterials } from './wrinkled-file.ts'

/** Checks the rules of the extension on every material with wrinkles. Never throws FurrowError. */
export async function checkWrinkles(glb: Glb): Promise<Finding[]> {
  const materials = wrinkledMaterials(glb)
  if (materials.length === 0) return [warningFinding('NO_WRINKLES', `no material has ${WRINKLE_MAPS}`)]
  const all = await Promise.all(materials.map((material) => checkMaterial(glb, material)))
  return [...checkLists(glb), ...all.flat()]
}

function checkLists({ json }: Glb): Finding[] {
  const findings: Finding[] = []
  if (!json.extensionsUsed?.includes(WRINKLE_MAPS)) {
    findings.push(errorFinding('NOT_DECLARED', `extensionsUsed lacks ${WRINKLE_MAPS}`, '/extensionsUsed'))
  }
  if (json.extensionsRequired?.includes(WRINKLE_MAPS)) {
    const message = 'extensionsRequired lists it: viewers without it will not open the file at all'
    findings.push(warningFinding('REQUIRED', message, '/extensionsRequired'))
  }
  return findings
}

async function checkMaterial(glb: Glb, material: number): Promise<Finding[]> {
  const pointer = `/materials/${material}/extensions/${WRINKLE_MAPS}`
  const json = glb.json.materials![material].extensions![WRINKLE_MAPS]
  try {
    const maps = parseWrinkleMaps(json, glb.json.textures?.length ?? 0)
    const file = { glb, material, maps }
    const report = await inspectWrinkles(file, WRINKLE_MAPS)
    const findings = [
      ...checkSizes(report),
      ...checkImages(report),
      ...(await checkArrays(file)),
      ...checkAreas(report),
      ...checkCoordinates(file),
      ...checkDrivers(file),
    ]
    return findings.map((finding) => ({ ...finding, pointer }))
  } catch (thrown) {
    if (!(thrown instanceof FurrowError)) throw thrown
    return [errorFinding('INVALID', firstLine(thrown), pointer)]
  }
}

function checkSizes({ layers }: Inspection): Finding[] {
  const sizes = layers.map(({ maps }) => sizeText(maps[0]))
  const findings: Finding[] = []
  if (new Set(sizes).size > 1) {
    findings.push(
      errorFinding('LAYER_SIZES', `normal maps of the layers differ in size: ${sizes.join(', ')}`),
    )
  }
  for (const { name, maps } of layers) {
    for (const map of maps) {
      if (sizeText(map) === sizeText(maps[0])) continue
      const message = `layer "${name}": ${map.map} is ${sizeText(map)}, its normal map ${sizeText(maps[0])}`
      findings.push(warningFinding('MAP_SIZES', message))
    }
  }
  return findings
}

function checkImages({ layers }: Inspection): Finding[] {
  return layers.flatMap(({ name, maps }) => {
    const lossy = maps[0].mimeType === 'image/jpeg'
    return lossy
      ? [warningFinding('JPEG_NORMALS', `layer "${name}": JPEG causes blocks in normals; use PNG or UASTC`)]
      : []
  })
}

/** Every slice must exist; the blocks of ETC1S, 4 x 4 texels between two colours, show in normals. */
async function checkArrays({ glb, maps }: WrinkledFile): Promise<Finding[]> {
  const findings: Finding[] = []
  for (const layer of maps.layers) {
    for (const [map, slot] of MAP_SLOTS) {
      const info = layer[slot]
      if (info?.slice === undefined) continue
      const { layers, compression } = await arrayOf(glb, info.index, WRINKLE_MAPS)
      if (info.slice >= layers.length) {
        const message = `layer "${layer.name}": ${map} is slice ${info.slice} of ${layers.length}`
        findings.push(errorFinding('NO_SLICE', message))
      }
      if (map === 'normal' && compression === 'etc1s') {
        findings.push(
          warningFinding('ETC1S_NORMALS', `layer "${layer.name}": ETC1S causes blocks in normals; use UASTC`),
        )
      }
    }
  }
  return [...findings, ...checkArrayUses(glb, maps)]
}

/** KHR_texture_basisu allows plain 2D images only, so that an array may be used only by texture infos with a slice. */
function checkArrayUses(glb: Glb, maps: WrinkledFile['maps']): Finding[] {
  const own = [
    ...maps.layers.flatMap((layer) => MAP_SLOTS.flatMap(([, slot]) => layer[slot] ?? [])),
    ...maps.areas.map(({ texture }) => texture),
  ]
  const plain = plainTextures([glb.json.materials, glb.json.extensions])
  const wrong = new Set(own.map(({ index }) => index).filter((index) => plain.has(index)))
  return [...wrong].flatMap((index) => {
    const count = layerCount(imageOf(glb, index, WRINKLE_MAPS))
    if (count === 0) return []
    const message = `texture ${index} is an array of ${count}, and a texture info without a slice refers to it`
    return [errorFinding('ARRAY_AS_IMAGE', message)]
  })
}

/** Indices of the textures that texture infos anywhere below `value` use as plain images. */
function plainTextures(value: unknown, key = '', found = new Set<number>()): Set<number> {
  if (typeof value !== 'object' || value === null) return found
  const { index, slice } = value as { index?: unknown; slice?: unknown }
  if (/texture$/i.test(key) && typeof index === 'number' && slice === undefined) found.add(index)
  for (const [name, item] of Object.entries(value)) plainTextures(item, name, found)
  return found
}

function checkAreas({ areas }: Inspection): Finding[] {
  // Image tools do not open arrays, so that only images are at risk.
  const inImages = areas.filter(({ channel, slice }) => channel === 'A' && slice === undefined)
  const withAlpha = new Set(inImages.map(({ texture }) => texture))
  return areas.flatMap((area) => {
    const findings: Finding[] = []
    if (area.largest === 0)
      findings.push(warningFinding('AREA_INVISIBLE', `area "${area.name}" is visible nowhere`))
    if (area.channel !== 'A' && withAlpha.has(area.texture)) {
      const message = `area "${area.name}" shares texture ${area.texture} with an area in alpha: tools that resize or compress it lose the colours where alpha is 0`
      findings.push(warningFinding('AREA_UNDER_ALPHA', message))
    }
    return findings
  })
}

/** Readers use the texture coordinates of the skin's normal map for all maps; a file that says otherwise misleads. */
function checkCoordinates({ glb, material, maps }: WrinkledFile): Finding[] {
  const expected = glb.json.materials![material].normalTexture?.texCoord ?? 0
  const infos = [
    ...maps.layers.map(({ normalTexture }) => normalTexture),
    ...maps.areas.map(({ texture }) => texture),
  ]
  const other = infos.find((info) => ((info as { texCoord?: number }).texCoord ?? 0) !== expected)
  if (!other) return []
  const message = `texture ${other.index} has another texCoord than the normalTexture (${expected}), which is used instead`
  return [warningFinding('TEXCOORD', message)]
}

function checkDrivers({ glb, material, maps: { drivers } }: WrinkledFile): Finding[] {
  const meshes = (glb.json.meshes ?? []).filter(({ primitives }) => {
    return primitives.some((primitive) => primitive.material === material)
  })
  const { unknownTypes, missing, cyclicAreas } = findDriverFaults(
    drivers,
    meshes.flatMap(targetNamesOf),
    jointNamesOf(glb.json),
  )
  return [
    ...unknownTypes.map((type) => warningFinding('DRIVER_TYPE', `drivers of type "${type}" are ignored`)),
    ...missing.map((what) => warningFinding('DRIVER_NAME', `${what} does not exist`)),
    ...cyclicAreas.map((area) =>
      warningFinding('DRIVER_CYCLE', `area "${area}" drives itself; its drivers that read areas are ignored`),
    ),
  ]
}

const sizeText = ({ width, height }: { width: number; height: number }) => `${width} x ${height}`
