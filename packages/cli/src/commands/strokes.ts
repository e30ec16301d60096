import { join } from 'node:path'
import { Option } from 'commander'
import { FurrowError } from 'furrow'
import {
  combineNormals,
  type HeightMap,
  heightToNormal,
  paintAreas,
  parseStrokes,
  type RgbaImage,
  type Stroke,
  type StrokesDocument,
  skinCanvas,
  strokesToHeight,
  type TangentFrame,
} from 'furrow/author'
import {
  addFurrows,
  DEFAULT_AREA_SIZE,
  didYouMean,
  fileNamesOf,
  isFileName,
  MAX_IMAGE_SIDE,
  paintedNames,
} from 'furrow/internal'
import {
  jsonFile,
  layersOf,
  type OutputFile,
  STROKES_FILE,
  WRINKLES_FILE,
  withCommandErrors,
} from 'furrow-files'
import {
  decodeNormalMap,
  drawSet,
  encodeArea,
  encodeHeight,
  encodeRgbaNormalMap,
  type FaceMesh,
  HEIGHT_STEPS_PER_MM,
  HEIGHT_ZERO,
  type OpenSet,
  openSet,
  readBytes,
  readFaceMesh,
  readJson,
  readReferenced,
} from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, forceOption, numberParser } from '../options.ts'
import { checkFolder, checkOutputs } from '../outputs.ts'
import { print } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow strokes'

/** Side of the maps in texels where neither --size, nor the document, nor a base gives it. */
const DEFAULT_SIZE = 1024

interface Options {
  face: string
  mesh?: string
  base?: string
  detail?: boolean
  output?: string
  normal?: string
  areas?: string
  into?: string
  layer?: string
  size?: number
  allowOutside?: boolean
  force?: boolean
}

/** `furrow strokes`: draws the wrinkles of a document into the maps of a face. */
export const strokesCommand = createCommand('strokes')
  .description('draw strokes into a height map, a normal map and the areas of a face')
  .argument('<strokes>', 'document of strokes (JSON)')
  .requiredOption('--face <file>', 'the face that the strokes are drawn on (.glb, .vrm, .gltf)')
  .option('--mesh <name>', 'its mesh (default: "skin", the only one, or as furrow auto finds it)')
  .option('--base <image>', "smooth normal map under the wrinkles (default: the mesh's own)")
  .addOption(
    new Option('--detail', 'wrinkles without a base, for a layer of kind "detail"').conflicts('base'),
  )
  .option('-o, --output <file>', 'height map, 16-bit gray PNG')
  .option('--normal <file>', 'wrinkled normal map, 8-bit RGB PNG')
  .option('--areas <folder>', 'one gray PNG per area, white = no wrinkles')
  .addOption(
    new Option(
      '--into <folder>',
      'all maps of the layers, heights, occlusion and blood too, into a folder that furrow pack reads',
    ).conflicts(['base', 'detail']),
  )
  .option('--layer <name>', 'draw only the strokes of this layer')
  .option(
    '--size <texels>',
    `side of both maps (default: the document's, the base's up to 4096, or ${DEFAULT_SIZE})`,
    numberParser({ min: 16, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true }),
  )
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .addHelpText(
    'after',
    `
At least one of -o, --normal, --areas and --into is needed. Documents of strokes: docs/strokes.md.

Examples:
  $ furrow strokes scars.json --face avatar.glb --normal normal.png --areas areas
  $ furrow strokes scars.json --face avatar.glb --detail --normal scars.png -o height.png --size 2048
  $ furrow strokes scars.json --face avatar.glb --into scars`,
  )
  .action(drawStrokes)

async function drawStrokes(path: string, options: Options): Promise<void> {
  if (!options.output && !options.normal && !options.areas && !options.into) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      what: 'no output',
      limit: '-o HEIGHT.png, --normal NORMAL.png, --areas FOLDER, --into FOLDER',
      remedy: 'name at least one of them',
    })
  }
  const { output, normal, areas, into, base, force = false } = options
  for (const folder of [areas, into]) if (folder !== undefined) await checkFolder(folder, WHO)
  const json = await readJson(path, WHO, 'the strokes')
  const document = withCommandErrors(WHO, () => parseStrokes(json))
  const strokes = strokesOfLayer(document, options)
  const maps = areas === undefined ? [] : areaNames(document).map((name) => areaPath(areas, name))
  const inputs = [path, options.face, ...(base === undefined ? [] : [base])]
  const set = into === undefined ? undefined : await openSet(into, document, options.layer, WHO)
  await checkOutputs([output, normal, ...maps, ...(set?.images ?? [])], WHO, { inputs, force })
  if (set) await checkOutputs([set.document], WHO, { inputs, force, extensions: ['.json'] })
  const face = await readFaceMesh(options.face, WHO, options)
  const drawn = await withCommandErrors(WHO, async () => [
    ...(await drawMaps(document, strokes, face, options)),
    ...(await drawAreas(document, face, areas)),
    ...(set ? await drawInto(set, document, json, face, options) : []),
  ])
  await writeAll(drawn, WHO)
  print(
    drawn.map(({ path, note }) => `${path}: ${note}`),
    output,
    normal,
  )
}

/** The strokes that the maps show. A map is of one layer; areas are painted round the strokes of all. */
function strokesOfLayer(document: StrokesDocument, { layer, output, normal }: Options): Stroke[] {
  const { strokes } = document
  const layers = layersOf(document)
  if (layer !== undefined && !layers.includes(layer)) {
    throw new FurrowError({
      code: 'unknown-name',
      who: WHO,
      what: 'no stroke is of that layer',
      value: layer,
      limit: layers.length > 0 ? layers.join(', ') : 'the document has no layers',
      remedy: didYouMean(layer, layers, layers.length > 0 ? 'name one of them' : 'leave --layer out'),
    })
  }
  if (layer === undefined && layers.length > 1 && (output ?? normal) !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      what: 'the document has strokes of several layers, and a map is of one',
      value: layers.join(', '),
      remedy: `name one, e.g. --layer ${layers[0]}`,
    })
  }
  return layer === undefined ? strokes : strokes.filter((stroke) => stroke.layer === layer)
}

/** The names of the areas, each of which becomes the name of a file. */
function areaNames(document: StrokesDocument): string[] {
  const names = paintedNames(document)
  const wrong = names.find((name) => !isFileName(name))
  if (wrong === undefined) return names
  throw new FurrowError({
    who: WHO,
    what: 'the group of a stroke is not a valid file name, and its area is written to a file of that name',
    value: wrong,
    limit: `e.g. ${fileNamesOf([wrong])}`,
    remedy: 'rename the group',
  })
}

const areaPath = (folder: string, name: string) => join(folder, `${name}.png`)

/** A file to write, and what to print about it. */
interface DrawnFile extends OutputFile {
  note: string
}

/** The height map and the normal map, where they are asked for. */
async function drawMaps(
  document: StrokesDocument,
  strokes: readonly Stroke[],
  face: FaceMesh,
  options: Options,
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
    const over = `over ${base ? (options.base ?? "the skin's own normal map") : 'a flat skin'}`
    const { length } = strokes
    const count = `${length} ${length === 1 ? 'stroke' : 'strokes'}`
    drawn.push({ path: normal, bytes, note: `${sizeText}, ${count} ${over}` })
  }
  return drawn
}

/** All maps of the layers, and in a new folder whatever else `furrow pack` needs. */
async function drawInto(
  open: OpenSet,
  document: StrokesDocument,
  json: unknown,
  face: FaceMesh,
  { size = document.size ?? DEFAULT_SIZE, allowOutside }: Options,
): Promise<DrawnFile[]> {
  if (size % 2 !== 0) throw oddSize(size)
  const { folder, set, isNew } = open
  const canvas = skinCanvas(face.mesh, size, size, document.scale)
  const read = (uri: string) => readReferenced(folder, uri, WHO, { allowOutside })
  const on = { canvas, frame: frameOf(face) }
  const { layers, files } = await drawSet(set, open.layers, document, read, on, WHO)
  files.unshift({ path: WRINKLES_FILE, bytes: jsonFile({ ...open.json, layers }) })
  if (isNew) files.push({ path: STROKES_FILE, bytes: jsonFile(json as object) })
  const drawn = files.map(({ path, bytes }) => ({
    path: join(folder, path),
    bytes,
    note: `${bytes.length} bytes`,
  }))
  return isNew ? [...drawn, ...(await drawAreas(document, face, join(folder, 'areas')))] : drawn
}

const frameOf = ({ hasTangents }: FaceMesh): TangentFrame => (hasTangents ? 'orthonormal' : 'derivative')

function oddSize(size: number): FurrowError {
  return new FurrowError({
    who: WHO,
    what: 'heights, occlusion and blood have half the side of the normals, which is odd',
    value: size,
    remedy: `choose --size ${size + 1}`,
  })
}

/** A gray image per area, where they are asked for. */
function drawAreas(
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
      note: `${weights.width} x ${weights.height}, white = no wrinkles`,
    })),
  )
}

/** The lowest and highest value. */
function rangeOf({ data }: HeightMap): string {
  let [low, high] = [0, 0]
  for (const mm of data) {
    low = Math.min(low, mm)
    high = Math.max(high, mm)
  }
  return `${low.toFixed(2)}..${high.toFixed(2)} mm`
}

/** The normal map under the wrinkles: `--base`, or the mesh's own; none with `--detail`. */
async function readBase(
  { base, detail }: Options,
  face: FaceMesh,
  size: number | undefined,
): Promise<RgbaImage | undefined> {
  if (detail) return undefined
  if (base !== undefined) return decodeNormalMap(await readBytes(base, WHO, 'the base'), base, WHO, size)
  return face.normalMap && decodeNormalMap(face.normalMap, `of the mesh ${face.name}`, WHO, size)
}
