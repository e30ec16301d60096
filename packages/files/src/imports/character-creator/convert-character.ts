import { FurrowError, type GrayImage } from 'furrow'
import { resampleGray } from 'furrow/internal'
import { channelOf, type Pixels } from '../../images/pixels.ts'
import { targetNamesOf } from '../../json/gltf-json.ts'
import type { AreaToPack, LayerToPack } from '../../pack/set-to-pack.ts'
import { cellOf } from '../area-cells.ts'
import { largestWeights, sumsOfWeights } from '../combine-weights.ts'
import { type FaceToImport, faceColours, faceNormalMap } from '../face-maps.ts'
import type { ImportedSet, ImportSettings } from '../imported-set.ts'
import { LayerCanvas, normalBytes } from '../layer-canvas.ts'
import { FLOW_LEVELS, fitOnset, type OnsetFit } from '../onset-fit.ts'
import type { SourceFiles } from '../source-files.ts'
import { coloursOf, normalsOf, readSourceImage } from '../source-image.ts'
import { areaNameOf, characterDrivers, inputAreaOf, isCorrected } from './character-drivers.ts'
import { readMasks, ruleWeights } from './character-masks.ts'
import { type CharacterWrinkles, characterFiles, readCharacter, SETS } from './read-character.ts'
import { ruleStrengths } from './region-settings.ts'
import { RULES, type Rule, type Side } from './rules.ts'
import { shapeLinks } from './shapes.ts'

/** Width and height of the areas in texels: half of the masks that the add-ons ship. */
const AREA_SIZE = 256

/** Area of a rule on one side. */
interface RuleArea {
  rule: Rule
  side: Side
  weights: GrayImage
}

/**
 * Converts the wrinkles of Character Creator. Each set of maps becomes a layer, each rule an area per side. Flow maps become onset.
 *
 * @throws FurrowError if the JSON file, a map or a mask is missing or invalid.
 */
export async function convertCharacter(
  files: SourceFiles,
  face: FaceToImport,
  { size, green, powers }: ImportSettings,
  who: string,
): Promise<ImportedSet> {
  const character = await findCharacter(files, who)
  const masks = await readMasks(files, who)
  const lost: string[] = []
  const base = await faceNormalMap(face, size, who)
  if (!base) lost.push('the face has no normal map, so its resting skin is smooth; export it with textures')
  const layers: LayerToPack[] = []
  const areas: RuleArea[] = []
  const fits = new Map<number, OnsetFit>()
  for (const set of SETS) {
    const normal = character.textures[set].Normal
    if (normal === undefined) {
      lost.push(`the wrinkles of set ${set}, because it has no normal map`)
      continue
    }
    const read = (path: string) => readSourceImage(files, path, who, size)
    const normals = normalsOf(await read(normal), green === 'down')
    const own = RULES.filter((rule) => rule.set === set).flatMap((rule) => {
      const sides: Side[] = rule.isSided ? ['L', 'R'] : ['L']
      return sides.map((side) => ({ rule, side, weights: ruleWeights(masks, rule, side, AREA_SIZE) }))
    })
    const flowPath = character.textures[set].Flow
    const flow = flowPath === undefined ? undefined : channelOf(await read(flowPath), 0)
    const ownWeights = own.map(({ weights }) => weights)
    const shown = largestWeights(ownWeights)
    const sums = sumsOfWeights(ownWeights)
    const changes =
      flow &&
      changesPerFlow(flow, shown, await changesOf(normals, base, character, set, face, size, read, who))
    const fit = fitOnset(changes ?? [])
    fits.set(set, fit)
    areas.push(
      ...(flow
        ? own.map((area) => ({ ...area, weights: fittedWeights(area.weights, shown, sums, flow, fit) }))
        : own),
    )
    const canvas = new LayerCanvas(size)
    await paintSet(canvas, character, set, normals, shown, read)
    if (flow && fit.strength > 0) paintOnset(canvas, flow, shown, fit)
    layers.push({
      name: layerNameOf(set),
      kind: 'replace',
      maps: canvas.maps(),
      ...(fit.strength > 0 && { onsetStrength: fit.strength }),
    })
  }
  if (layers.length === 0) throw noMaps(files, who)
  const links = shapeLinks(targetNamesOf(face.glb.json.meshes![face.target.mesh]))
  if (links.length === 0)
    lost.push("no blendshape has a name of Character Creator; the page sets inputs with the rules' names")
  const strengths = ruleStrengths(character, face, powers)
  const drivers = characterDrivers(
    links,
    strengths,
    (set) => fits.get(set)?.activationOf ?? ((value) => value),
  )
  const all = [...areas.map(areaToPack), ...inputAreas(layers[0].name)]
  const names = new Set(all.map(({ name }) => name))
  return {
    set: {
      areaSize: AREA_SIZE,
      layers,
      areas: all,
      drivers: drivers.filter((driver) => 'area' in driver && names.has(String(driver.area))),
    },
    lost,
    unread: [...character.unread, ...unknownRules(character)],
  }
}

/** Returns the only character with wrinkles in a folder, or the one of the named document. */
export async function findCharacter(files: SourceFiles, who: string): Promise<CharacterWrinkles> {
  const found: CharacterWrinkles[] = []
  for (const path of characterFiles(files)) {
    const character = await readCharacter(files, path, who)
    if (character) found.push(character)
  }
  if (found.length === 1) return found[0]
  throw new FurrowError({
    who,
    problem: `${found.length === 0 ? 'no JSON file' : 'several JSON files'} with wrinkles in ${files.name}`,
    limit: 'one .json file with Wrinkle in a material',
    remedy: 'export the character with its JSON file, or name the file',
  })
}

function layerNameOf(set: number): string {
  return `wrinkles ${set}`
}

function areaToPack({ rule, side, weights }: RuleArea): AreaToPack {
  return { name: areaNameOf(rule, side), layer: layerNameOf(rule.set), weights: async () => weights }
}

/** Areas without wrinkles, which keep values for other areas. */
function inputAreas(layer: string): AreaToPack[] {
  const weights: GrayImage = { width: AREA_SIZE, height: AREA_SIZE, data: new Uint8Array(AREA_SIZE ** 2) }
  return RULES.filter(isCorrected).flatMap((rule) =>
    (['L', 'R'] as const).map((side) => ({
      name: inputAreaOf(rule.key, side),
      layer,
      isHidden: true,
      weights: async () => weights,
    })),
  )
}

async function paintSet(
  canvas: LayerCanvas,
  { textures }: CharacterWrinkles,
  set: number,
  normals: Float32Array,
  weights: GrayImage,
  read: (path: string) => Promise<Pixels>,
): Promise<void> {
  const colourAt = (i: number) => normalBytes(normals[3 * i], normals[3 * i + 1], normals[3 * i + 2])
  canvas.paint('normal', [{ weights, colourAt }])
  for (const [kind, map, channels] of [
    ['Diffuse', 'baseColor', 3],
    ['Roughness', 'roughness', 1],
    ['AO', 'occlusion', 1],
  ] as const) {
    const path = textures[set][kind]
    if (path === undefined) continue
    const colours = coloursOf(await read(path))
    canvas.paint(map, [{ weights, colourAt: (i) => colours.subarray(3 * i, 3 * i + channels) }])
  }
}

/** Returns the largest change of a component of normal or colour per texel, in steps of 1/255. */
async function changesOf(
  normals: Float32Array,
  base: Pixels | undefined,
  { textures }: CharacterWrinkles,
  set: number,
  face: FaceToImport,
  size: number,
  read: (path: string) => Promise<Pixels>,
  who: string,
): Promise<Float32Array> {
  const rest = base && normalsOf(base, false)
  const changes = new Float32Array(size * size)
  for (let i = 0; i < normals.length; i++) {
    const own = rest ? rest[i] : +(i % 3 === 2)
    changes[Math.floor(i / 3)] = Math.max(changes[Math.floor(i / 3)], 127.5 * Math.abs(normals[i] - own))
  }
  const path = textures[set].Diffuse
  const skin = await faceColours(face, size, who)
  if (path === undefined || !skin) return changes
  const [before, after] = [coloursOf(skin), coloursOf(await read(path))]
  for (let i = 0; i < after.length; i++) {
    changes[Math.floor(i / 3)] = Math.max(changes[Math.floor(i / 3)], Math.abs(after[i] - before[i]))
  }
  return changes
}

/** Returns the largest change per level of flow, where wrinkles are fully visible. */
function changesPerFlow(flow: GrayImage, shown: GrayImage, changes: Float32Array): Float64Array {
  const largest = new Float64Array(FLOW_LEVELS)
  for (let i = 0; i < flow.data.length; i++) {
    if (shown.data[cellOf(i, flow.width, shown.width)] < 128) continue
    const level = Math.round((flow.data[i] / 255) * (FLOW_LEVELS - 1))
    largest[level] = Math.max(largest[level], changes[i])
  }
  return largest
}

/**
 * Returns the weights of an area for the curve of a fit. Where areas overlap, takes the mean of the weight for this area alone and of its share
 * for all areas together. The curve of a sum is not the sum of the curves.
 *
 * @param sums sums of the weights of all areas, 0..255 per area.
 */
function fittedWeights(
  weights: GrayImage,
  shown: GrayImage,
  sums: Uint16Array,
  flow: GrayImage,
  fit: OnsetFit,
): GrayImage {
  const coarse = resampleGray(flow, weights.width)
  const data = weights.data.map((weight, i) => {
    const fitted = (one: number) => fit.weightOf(coarse.data[i] / 255, one / 255, shown.data[i] / 255)
    const alone = fitted(weight)
    const together = sums[i] > weight ? fitted(Math.min(255, sums[i])) * (weight / sums[i]) : alone
    return Math.round((255 * (alone + together)) / 2)
  })
  return { ...weights, data }
}

function paintOnset(canvas: LayerCanvas, flow: GrayImage, weights: GrayImage, fit: OnsetFit): void {
  const colourAt = (i: number) => {
    const weight = weights.data[cellOf(i, flow.width, weights.width)] / 255
    return [Math.round(255 * fit.onsetOf(flow.data[i] / 255, weight))]
  }
  canvas.paint('onset', [{ weights, colourAt }])
}

function unknownRules({ weights }: CharacterWrinkles): string[] {
  const known = RULES.flatMap(({ names }) => Object.values(names))
  return [...weights.keys()].filter((name) => !known.includes(name)).map((name) => `rule ${name}`)
}

function noMaps({ name }: SourceFiles, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: `no wrinkle normal map in ${name}`,
    limit: 'Normal_1, Normal_2 or Normal_3 in Wrinkle.Textures',
    remedy: 'export the character with its wrinkle textures',
  })
}
