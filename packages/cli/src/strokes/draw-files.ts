import { join } from 'node:path'
import { FurrowError } from 'furrow'
import {
  combineNormals,
  type HeightMap,
  heightToNormal,
  paintAreas,
  type RgbaImage,
  type Stroke,
  type StrokesDocument,
  skinCanvas,
  strokesToHeight,
  type TangentFrame,
} from 'furrow/author'
import { addFurrows, DEFAULT_AREA_SIZE, HEIGHT_STEPS_PER_MM } from 'furrow/internal'
import { jsonFile, type OutputFile, STROKES_FILE, WRINKLES_FILE } from 'furrow-files'
import {
  decodeNormalMap,
  drawSet,
  encodeArea,
  encodeHeight,
  encodeRgbaNormalMap,
  type FaceMesh,
  HEIGHT_ZERO,
  type OpenSet,
  readBytes,
  readReferenced,
  wasRead,
} from 'furrow-files/node'
import { withBar } from '../progress.ts'

const WHO = 'furrow strokes'

/** Width and height of the maps in texels, if neither `--size`, the document nor the base sets a size. */
export const DEFAULT_SIZE = 1024

export interface DrawOptions {
  base?: string
  detail?: boolean
  output?: string
  normal?: string
  layer?: string
  size?: number
  allowOutside?: boolean
}

export const areaPath = (folder: string, name: string) => join(folder, `${name}.png`)

/** File to write, with a note that is printed. */
export interface DrawnFile extends OutputFile {
  note: string
}

/** Draws the height map (`output`) and the normal map (`normal`), if their paths are given. */
export async function drawMaps(
  document: StrokesDocument,
  strokes: readonly Stroke[],
  face: FaceMesh,
  options: DrawOptions,
): Promise<DrawnFile[]> {
  const { output, normal } = options
  if (!output && !normal) return []
  const size = options.size ?? document.size
  const base = normal ? await readBase(options, face, size) : undefined
  const side = size ?? DEFAULT_SIZE
  const canvas = skinCanvas(face.mesh, base?.width ?? side, base?.height ?? side, document.scale)
  const { metric } = canvas
  const heights = withBar('strokes', (progress) => strokesToHeight(strokes, canvas, progress))
  const { furrows } = document
  if (furrows && (furrows.layer === undefined || furrows.layer === options.layer))
    addFurrows(heights, canvas, furrows, document.strokes)
  const drawn: DrawnFile[] = []
  const sizeText = `${metric.width} x ${metric.height}`
  if (output) {
    const scale = `${HEIGHT_ZERO} = 0 mm, 1 step = ${1 / HEIGHT_STEPS_PER_MM} mm`
    const note = `${sizeText}, 16-bit, ${scale}, ${rangeOf(heights)}`
    drawn.push({ path: output, bytes: await encodeHeight(heights), note })
  }
  if (normal) {
    const wrinkles = heightToNormal(heights, metric, frameOf(face))
    const bytes = await encodeRgbaNormalMap(base ? combineNormals(base, wrinkles) : wrinkles)
    const over = `over ${base ? (options.base ?? 'the normal map of the skin') : 'flat skin'}`
    const { length } = strokes
    const count = `${length} ${length === 1 ? 'stroke' : 'strokes'}`
    drawn.push({ path: normal, bytes, note: `${sizeText}, ${count} ${over}` })
  }
  return drawn
}

/**
 * Draws all maps of the layers `open.layers` of a folder. Returns these maps and `wrinkles.json`, and for a new folder
 * also the strokes and the areas, so that `furrow pack` can read the folder. Writes nothing.
 */
export async function drawInto(
  open: OpenSet,
  document: StrokesDocument,
  json: unknown,
  face: FaceMesh,
  { size = document.size ?? DEFAULT_SIZE, allowOutside }: DrawOptions,
): Promise<DrawnFile[]> {
  if (size % 2 !== 0) throw oddSizeError(size)
  const { folder, set, isNew } = open
  const canvas = skinCanvas(face.mesh, size, size, document.scale)
  const read = (uri: string) => readReferenced(folder, uri, WHO, { allowOutside })
  const on = { canvas, frame: frameOf(face) }
  const { layers, files } = await drawSet(set, open.layers, document, read, on, WHO)
  files.unshift({ path: WRINKLES_FILE, bytes: jsonFile({ ...open.json, layers }) })
  // Keeps `strokes.json` of the folder if it is the strokes document that the user gave.
  if (isNew && !wasRead(join(folder, STROKES_FILE)))
    files.push({ path: STROKES_FILE, bytes: jsonFile(json as object) })
  const drawn = files.map(({ path, bytes }) => ({
    path: join(folder, path),
    bytes,
    note: `${bytes.length} bytes`,
  }))
  return isNew ? [...drawn, ...(await drawAreas(document, face, join(folder, 'areas')))] : drawn
}

const frameOf = ({ hasTangents }: FaceMesh): TangentFrame => (hasTangents ? 'orthonormal' : 'derivative')

function oddSizeError(size: number): FurrowError {
  return new FurrowError({
    who: WHO,
    problem: 'the size is odd, but heights, occlusion and blood have half this size',
    value: size,
    limit: 'even sizes',
    remedy: `choose --size ${size + 1}`,
  })
}

export function drawAreas(
  document: StrokesDocument,
  face: FaceMesh,
  areas: string | undefined,
): Promise<DrawnFile[]> {
  if (!areas) return Promise.resolve([])
  const painted = paintAreas(
    document,
    skinCanvas(face.mesh, DEFAULT_AREA_SIZE, DEFAULT_AREA_SIZE, document.scale),
  )
  return Promise.all(
    painted.map(async ({ name, weights }) => ({
      path: areaPath(areas, name),
      bytes: await encodeArea(weights),
      note: `${weights.width} x ${weights.height}, black = fully visible wrinkles`,
    })),
  )
}

/** Formats the lowest and the highest height, e.g. `-0.30..0.12 mm`. */
function rangeOf({ data }: HeightMap): string {
  let [low, high] = [0, 0]
  for (const mm of data) {
    low = Math.min(low, mm)
    high = Math.max(high, mm)
  }
  return `${low.toFixed(2)}..${high.toFixed(2)} mm`
}

/**
 * Reads the normal map under the strokes: `--base`, or by default the normal map of the mesh. With `--detail` there is
 * no such map.
 */
async function readBase(
  { base, detail }: DrawOptions,
  face: FaceMesh,
  size: number | undefined,
): Promise<RgbaImage | undefined> {
  if (detail) return undefined
  if (base !== undefined) return decodeNormalMap(await readBytes(base, WHO, 'the base'), base, WHO, size)
  return face.normalMap && decodeNormalMap(face.normalMap, `of the mesh ${face.name}`, WHO, size)
}
