import { FurrowError } from 'furrow'
import { checkDeclared, mapProblems, parseWrinkleMaps, texturesOfFace, WRINKLE_MAPS } from 'furrow/internal'
import { firstLine } from '../base/errors.ts'
import type { Glb } from '../gltf/glb.ts'
import { ktx2HeaderOf } from '../gltf/texture-image.ts'
import { pixelsOf } from '../gltf/texture-pixels.ts'
import { correctionsIn, missingIn } from '../json/corrections.ts'
import { jointNamesOf, targetNamesOf } from '../json/gltf-json.ts'
import { facesOfMaterial } from '../json/target-names.ts'
import { findDriverProblems } from '../wrinkles/driver-problems.ts'
import { type Inspection, inspectWrinkles } from '../wrinkles/inspect.ts'
import { strokesIn } from '../wrinkles/strokes.ts'
import { readShapes } from '../wrinkles/texture-shapes.ts'
import { type WrinkledFile, wrinkledMaterials } from '../wrinkles/wrinkled-file.ts'
import { checkFaces, isDrawn } from './face-rules.ts'
import { errorFinding, type Finding, warningFinding } from './finding.ts'

/**
 * Checks every material with wrinkles by the rules of the extension FURROW_wrinkle_maps. Reports an error exactly if
 * loaders would show a material without its wrinkles. Never throws FurrowError.
 */
export async function checkWrinkles(glb: Glb): Promise<Finding[]> {
  const materials = wrinkledMaterials(glb)
  if (materials.length === 0) return [warningFinding('NO_WRINKLES', `no material has ${WRINKLE_MAPS}`)]
  const findings = checkLists(glb)
  for (const material of materials) findings.push(...(await checkMaterial(glb, material)))
  return findings
}

function checkLists({ json }: Glb): Finding[] {
  const findings: Finding[] = []
  try {
    checkDeclared(json, WRINKLE_MAPS)
  } catch (error) {
    findings.push(errorFinding('NOT_DECLARED', firstLine(error), '/extensionsUsed'))
  }
  if (json.extensionsRequired?.includes(WRINKLE_MAPS)) {
    const message =
      'extensionsRequired lists the extension: viewers that do not support it cannot open the file'
    findings.push(warningFinding('REQUIRED', message, '/extensionsRequired'))
  }
  return findings
}

async function checkMaterial(glb: Glb, material: number): Promise<Finding[]> {
  const pointer = `/materials/${material}/extensions/${WRINKLE_MAPS}`
  const findings = await findingsOf(glb, material)
  // Loaders skip materials that no scene uses.
  const reported = isDrawn(glb.json, material)
    ? findings
    : [warningFinding('NOT_DRAWN', 'no mesh in a scene has this material')]
  return reported.map((finding) => ({ ...finding, pointer }))
}

async function findingsOf(glb: Glb, material: number): Promise<Finding[]> {
  const json = glb.json.materials![material].extensions![WRINKLE_MAPS]
  const all = [...(glb.json.meshes ?? []).keys()]
  let faces = checkFaces(glb.json, material, all)
  try {
    const maps = parseWrinkleMaps(json, glb.json.textures?.length ?? 0)
    faces = checkFaces(glb.json, material, facesOfMaterial(glb.json, material, maps.drivers))
    const shapes = await readShapes(glb, maps)
    const problems = mapProblems(
      maps,
      (texture) => shapes.get(texture)!,
      texturesOfFace(glb.json),
      WRINKLE_MAPS,
    )
    const errors = problems.map((problem) => errorFinding(problem.rule, new FurrowError(problem).message))
    const file = await withoutDamagedHeights({ glb, material, maps })
    const report = await inspectWrinkles(file, WRINKLE_MAPS)
    return [
      ...faces,
      ...errors,
      ...heightFindings(maps, file.maps),
      ...checkSizes(report),
      ...checkImages(report),
      ...checkEncodings(file),
      ...checkAreas(report),
      ...checkCoordinates(file),
      ...checkDrivers(file),
      ...checkStrokes(file),
      ...checkShapes(file),
    ]
  } catch (thrown) {
    if (!(thrown instanceof FurrowError)) throw thrown
    return [...faces, errorFinding('INVALID', firstLine(thrown))]
  }
}

/** Removes height maps that cannot be decoded. Loaders still show the other maps, because only relief uses heights. */
async function withoutDamagedHeights({ glb, material, maps }: WrinkledFile): Promise<WrinkledFile> {
  const layers = maps.layers.map(async (layer) => {
    const { heightTexture, ...rest } = layer
    if (!heightTexture) return layer
    const isDecodable = await pixelsOf(glb, heightTexture, WRINKLE_MAPS).then(
      () => true,
      () => false,
    )
    return isDecodable ? layer : rest
  })
  return { glb, material, maps: { ...maps, layers: await Promise.all(layers) } }
}

function heightFindings(before: WrinkledFile['maps'], after: WrinkledFile['maps']): Finding[] {
  const lost = before.layers.filter((layer, i) => layer.heightTexture && !after.layers[i].heightTexture)
  return lost.map(({ name }) =>
    warningFinding('HEIGHT', `layer "${name}": the height map cannot be read, so the layer has no relief`),
  )
}

function checkSizes({ layers }: Inspection): Finding[] {
  return layers.flatMap(({ name, maps }) =>
    maps
      .filter((map) => !isFractionOf(map, maps[0]))
      .map((map) => {
        const message = `layer "${name}": ${map.map} has ${sizeText(map)} texels, not an integer fraction of the normal map's ${sizeText(maps[0])}`
        return warningFinding('MAP_SIZES', message)
      }),
  )
}

/** Returns whether a map has the size of the normal map, divided by the same integer in both directions. */
function isFractionOf(map: MapSize, normal: MapSize): boolean {
  const factor = normal.width / map.width
  return Number.isInteger(factor) && factor === normal.height / map.height
}

type MapSize = Inspection['layers'][number]['maps'][number]

function checkImages({ layers }: Inspection): Finding[] {
  return layers.flatMap(({ name, maps }) => {
    const lossy = maps[0].mimeType === 'image/jpeg'
    return lossy
      ? [warningFinding('JPEG_NORMALS', `layer "${name}": JPEG causes blocks in normals; use PNG or UASTC`)]
      : []
  })
}

/**
 * Warns about normal maps in ETC1S. In this format, a block of 4 x 4 texels has at most four colours. This is too
 * coarse for normals, so the blocks are visible after shading.
 */
function checkEncodings({ glb, maps }: WrinkledFile): Finding[] {
  return maps.layers.flatMap(({ name, normalTexture }) => {
    const header = ktx2HeaderOf(glb, normalTexture.index, WRINKLE_MAPS)
    if (header?.encoding !== 'etc1s') return []
    return [warningFinding('ETC1S_NORMALS', `layer "${name}": ETC1S causes blocks in normals; use UASTC`)]
  })
}

function checkAreas({ areas }: Inspection): Finding[] {
  // Image tools may discard the colours of texels with alpha 0. They cannot open KTX 2 arrays, so arrays are safe.
  const inImages = areas.filter(({ channel, slice }) => channel === 'A' && slice === undefined)
  const withAlpha = new Set(inImages.map(({ texture }) => texture))
  return areas.flatMap((area) => {
    const findings: Finding[] = []
    if (area.largest === 0)
      findings.push(warningFinding('AREA_INVISIBLE', `area "${area.name}" is empty: all weights are 0`))
    if (area.channel !== 'A' && withAlpha.has(area.texture)) {
      const message = `area "${area.name}" shares texture ${area.texture} with an area in the alpha channel: tools that resize or compress the texture discard colours where alpha is 0`
      findings.push(warningFinding('AREA_UNDER_ALPHA', message))
    }
    return findings
  })
}

/** Warns if the `texCoord` of a texture and of `normalTexture` differ. Loaders use that of `normalTexture` for both. */
function checkCoordinates({ glb, material, maps }: WrinkledFile): Finding[] {
  const expected = glb.json.materials![material].normalTexture?.texCoord ?? 0
  const infos = [
    ...maps.layers.map(({ normalTexture }) => normalTexture),
    ...maps.areas.map(({ texture }) => texture),
  ]
  const other = infos.find((info) => ((info as { texCoord?: number }).texCoord ?? 0) !== expected)
  if (!other) return []
  const message = `loaders ignore the texCoord of texture ${other.index} and use that of normalTexture (${expected})`
  return [warningFinding('TEXCOORD', message)]
}

function checkDrivers({ glb, material, maps: { drivers } }: WrinkledFile): Finding[] {
  const meshes = (glb.json.meshes ?? []).filter(({ primitives }) => {
    return primitives.some((primitive) => primitive.material === material)
  })
  const { unknownTypes, missing, cyclicAreas } = findDriverProblems(
    drivers,
    meshes.flatMap(targetNamesOf),
    jointNamesOf(glb.json),
  )
  return [
    ...unknownTypes.map((type) =>
      warningFinding('DRIVER_TYPE', `unknown driver type "${type}"; loaders ignore it`),
    ),
    ...missing.map((input) => warningFinding('DRIVER_NAME', `${input} does not exist`)),
    ...cyclicAreas.map((area) =>
      warningFinding('DRIVER_CYCLE', `area "${area}" drives itself; its drivers that read areas are ignored`),
    ),
  ]
}

function checkStrokes(file: WrinkledFile): Finding[] {
  const { problem } = strokesIn(file, `${WRINKLE_MAPS}: strokes`)
  return problem === undefined ? [] : [warningFinding('STROKES', problem)]
}

function checkShapes({ glb, material }: WrinkledFile): Finding[] {
  const { corrections, problem } = correctionsIn(glb.json, material, WRINKLE_MAPS)
  const malformed = problem === undefined ? [] : [warningFinding('SHAPES', problem)]
  const missing = missingIn(glb.json, material, corrections)
  return [
    ...malformed,
    ...missing.map((blendshape) => warningFinding('SHAPE_NAME', `${blendshape} does not exist`)),
  ]
}

const sizeText = ({ width, height }: { width: number; height: number }) => `${width} x ${height}`
