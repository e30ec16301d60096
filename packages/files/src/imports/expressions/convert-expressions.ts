import { FurrowError, type GrayImage } from 'furrow'
import type { Skin } from 'furrow/author'
import { DEFAULT_AREA_SIZE, MAX_AREAS, MAX_LAYERS } from 'furrow/internal'
import type { Pixels } from '../../images/pixels.ts'
import { targetNamesOf } from '../../json/gltf-json.ts'
import { type Cells, countOf, grown, largestPerCell, partsOf, weightsOfCells } from '../area-cells.ts'
import { type FaceToImport, faceColours, faceNormalMap } from '../face-maps.ts'
import type { ImportedSet, ImportSettings } from '../imported-set.ts'
import { LayerCanvas, normalBytes } from '../layer-canvas.ts'
import { placeAreas } from '../share-layers.ts'
import type { SourceFiles } from '../source-files.ts'
import { coloursOf, normalsOf, readSourceImage } from '../source-image.ts'
import { expressionDriver, inputOf } from './expression-drivers.ts'
import {
  EXTRA_MAPS,
  type ExpressionSource,
  type ExtraMap,
  type KeyFrame,
  readExpressions,
  type SourceExpression,
} from './read-expressions.ts'

/** Smallest difference of a wrinkle from the neutral map, in steps of 1/255 of a component. */
const SMALLEST = 2
/** A group of wrinkles has at least one texel that differs by this much. */
const STRONG = 10
/** A group of wrinkles covers at least so many cells. Smaller groups are noise. */
const SMALLEST_PART = 3

/** Normals of one key frame. */
interface Frame {
  expression: SourceExpression
  index: number
  maps: KeyFrame
  normals: Float32Array
  differences: Float32Array
}

interface FoundArea {
  name: string
  frame: Frame
  weights: GrayImage
  strengths: Float32Array
}

/**
 * Converts normal maps of expressions. The wrinkles of an expression are where its map differs from the neutral map. Each connected part
 * becomes an area. Layers hold the face's own normals plus the difference, so the result is the sum of the source's differences.
 *
 * @param skin the face, to find which blendshapes move an area. Without it, all blendshapes of an expression drive its areas.
 * @throws FurrowError if an image or the document is invalid, or no expression differs from the neutral map.
 */
export async function convertExpressions(
  files: SourceFiles,
  face: FaceToImport,
  skin: Skin | undefined,
  { size, green }: ImportSettings,
  who: string,
): Promise<ImportedSet> {
  const source = await readExpressions(files, who)
  const read = async (path: string) =>
    normalsOf(await readSourceImage(files, path, who, size), green === 'down')
  const neutral = await read(source.neutral.normal)
  const own = await faceNormalMap(face, size, who)
  const base = own ? normalsOf(own, false) : neutral
  const lost: string[] = []
  const areas: FoundArea[] = []
  for (const expression of source.expressions) {
    for (const [index, maps] of expression.frames.entries()) {
      const normals = await read(maps.normal)
      areas.push(
        ...findAreas(
          { expression, index, maps, normals, differences: differencesOf(normals, neutral) },
          lost,
        ),
      )
    }
  }
  if (areas.length === 0) throw nothingFound(files, who)
  limitAreas(areas, lost)
  const placed = placeAreas(areas, MAX_LAYERS)
  reportClashes(areas, placed.lost, lost)

  const canvases = Array.from({ length: placed.layerCount }, () => new LayerCanvas(size))
  for (const [layer, canvas] of canvases.entries()) {
    const members = areas.flatMap((area, i) =>
      placed.layers[i] === layer ? [{ ...area, weights: placed.weights[i] }] : [],
    )
    canvas.paint(
      'normal',
      members.map(({ weights, frame: { normals } }) => ({
        weights,
        colourAt: (i) => {
          const [x, y, z] = [3 * i, 3 * i + 1, 3 * i + 2].map((k) => base[k] + normals[k] - neutral[k])
          return normalBytes(x, y, z)
        },
      })),
    )
    for (const map of EXTRA_MAPS) await paintExtra(map, canvas, members, source, files, face, size, lost, who)
  }
  const targets = targetNamesOf(face.glb.json.meshes![face.target.mesh])
  const layerNames = canvases.map((_, i) => (canvases.length === 1 ? 'expression' : `expression ${i + 1}`))
  const drivers = areas.map(({ name, frame: { expression, index } }, i) => {
    return expressionDriver(name, placed.weights[i], expression, index, inputOf(expression, targets), skin)
  })
  for (const expression of source.expressions) {
    if (inputOf(expression, targets).kind !== 'input') continue
    lost.push(
      `no blendshape is named like "${expression.name}"; the page sets its input of this name, 0 to 1`,
    )
  }
  return {
    set: {
      areaSize: DEFAULT_AREA_SIZE,
      layers: canvases.map((canvas, i) => ({ name: layerNames[i], kind: 'replace', maps: canvas.maps() })),
      areas: areas.map(({ name }, i) => ({
        name,
        layer: layerNames[placed.layers[i]],
        weights: async () => placed.weights[i],
      })),
      drivers,
    },
    ...(!own && { normalMap: pixelsOfNormals(neutral, size) }),
    lost,
    unread: source.unread,
  }
}

/** Returns the largest difference of a component per texel, in steps of 1/255. */
function differencesOf(normals: Float32Array, neutral: Float32Array): Float32Array {
  const differences = new Float32Array(normals.length / 3)
  for (let i = 0; i < normals.length; i++) {
    const texel = Math.floor(i / 3)
    differences[texel] = Math.max(differences[texel], 127.5 * Math.abs(normals[i] - neutral[i]))
  }
  return differences
}

function findAreas(frame: Frame, lost: string[]): FoundArea[] {
  const { expression, differences } = frame
  const label = expression.frames.length === 1 ? expression.name : `${expression.name} ${frame.maps.at}`
  const strengths = largestPerCell(differences, DEFAULT_AREA_SIZE)
  const threshold = thresholdOf(strengths)
  if (threshold > SMALLEST) {
    lost.push(`${label}: differences up to ${Math.round(threshold)} of 255 are noise, and are left out`)
  }
  const changed: Cells = {
    side: DEFAULT_AREA_SIZE,
    data: Uint8Array.from(strengths, (value) => +(value > threshold)),
  }
  // One ring joins cells that touch the same gap, so that a wrinkle with gaps is one area.
  const joined = partsOf(grown(changed))
  const parts = joined.map((part) => ({ ...part, data: part.data.map((cell, i) => cell & changed.data[i]) }))
  const strongest = (part: Cells) =>
    part.data.reduce((most, cell, i) => Math.max(most, cell * strengths[i]), 0)
  const kept = parts.filter(
    (part) => countOf(part) >= SMALLEST_PART && strongest(part) >= Math.max(STRONG, 2 * threshold),
  )
  if (kept.length === 0) lost.push(`${label}: it does not differ from the neutral map`)
  return kept.map((part, i) => ({
    name: kept.length === 1 ? label : `${label} ${i + 1}`,
    frame,
    weights: weightsOfCells(part),
    strengths: strengths.map((value, cell) => value * part.data[cell]),
  }))
}

/** Returns the difference above which a cell is wrinkled. Lossy images differ a little everywhere. */
function thresholdOf(strengths: Float32Array): number {
  const median = strengths.toSorted()[Math.floor(strengths.length / 2)]
  return Math.max(SMALLEST, 1.5 * median)
}

/** Removes the smallest areas if there are too many. */
function limitAreas(areas: FoundArea[], lost: string[]): void {
  if (areas.length <= MAX_AREAS) return
  const sizeOf = ({ weights }: FoundArea) => weights.data.reduce((sum, weight) => sum + weight, 0)
  const removed = areas.toSorted((a, b) => sizeOf(b) - sizeOf(a)).slice(MAX_AREAS)
  lost.push(
    `the smallest ${removed.length} of ${areas.length} areas, because a face has at most ${MAX_AREAS}`,
  )
  areas.splice(0, areas.length, ...areas.filter((area) => !removed.includes(area)))
}

function reportClashes(areas: readonly FoundArea[], cells: readonly number[], lost: string[]): void {
  for (const [i, { name, strengths }] of areas.entries()) {
    if (cells[i] === 0) continue
    const all = strengths.reduce((sum, value) => sum + +(value > 0), 0)
    const percent = Math.max(1, Math.round((100 * cells[i]) / all))
    lost.push(
      `${name}: ${percent}% of its area, where stronger wrinkles overlap it on all ${MAX_LAYERS} layers`,
    )
  }
}

/** Paints an optional map of a layer. Areas without this map show the map of the neutral face. */
async function paintExtra(
  map: ExtraMap,
  canvas: LayerCanvas,
  members: readonly FoundArea[],
  { neutral }: ExpressionSource,
  files: SourceFiles,
  face: FaceToImport,
  size: number,
  lost: string[],
  who: string,
): Promise<void> {
  if (members.every(({ frame }) => frame.maps[map] === undefined)) return
  const read = async (path: string) => coloursOf(await readSourceImage(files, path, who, size))
  const atRest = neutral[map] !== undefined ? await read(neutral[map]) : await restOf(map, face, size, who)
  const channels = map === 'baseColor' ? 3 : 1
  const areas = []
  for (const { name, weights, frame } of members) {
    const path = frame.maps[map]
    const colours = path === undefined ? atRest : await read(path)
    if (colours) areas.push({ weights, colourAt: (i: number) => colours.subarray(3 * i, 3 * i + channels) })
    else {
      lost.push(`the ${map} maps of a layer, because ${name} has none and neither has the neutral face`)
      return
    }
  }
  canvas.paint(map, areas)
}

async function restOf(
  map: ExtraMap,
  face: FaceToImport,
  size: number,
  who: string,
): Promise<Uint8Array | undefined> {
  const colours = map === 'baseColor' ? await faceColours(face, size, who) : undefined
  return colours && coloursOf(colours)
}

function nothingFound({ name }: SourceFiles, who: string): FurrowError {
  return new FurrowError({
    who,
    problem: `no expression differs from the neutral map in ${name}`,
    limit: `at least ${SMALLEST_PART} texels of a map of ${DEFAULT_AREA_SIZE} x ${DEFAULT_AREA_SIZE}`,
    remedy: 'check that the files are maps of different expressions',
  })
}

function pixelsOfNormals(normals: Float32Array, size: number): Pixels {
  const data = new Uint8Array(normals.length)
  for (let i = 0; i < normals.length; i += 3) {
    data.set(normalBytes(normals[i], normals[i + 1], normals[i + 2]), i)
  }
  return { width: size, height: size, channels: 3, data }
}
