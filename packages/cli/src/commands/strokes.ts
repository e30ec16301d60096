import { readFile } from 'node:fs/promises'
import { join } from 'node:path'
import { Command } from 'commander'
import { DEFAULT_AREA_SIZE, FurrowError, MAX_IMAGE_SIDE } from 'furrow'
import {
  combineNormals,
  type HeightMap,
  heightToNormal,
  type Metric,
  paintAreas,
  parseStrokes,
  type RgbaImage,
  type StrokesDocument,
  strokesToHeight,
  surfaceMetric,
  type TangentFrame,
} from 'furrow/author'
import { type Face, readFace } from '../face.ts'
import {
  decodeNormalMap,
  encodeArea,
  encodeHeight,
  encodeNormal,
  firstLine,
  HEIGHT_STEPS_PER_MM,
  HEIGHT_ZERO,
  type Output,
  writeAll,
} from '../images.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow strokes'

/** Side of the maps where neither --size, nor the document, nor a base says otherwise. */
const USUAL_SIZE = 1024

interface Options {
  face: string
  mesh?: string
  base?: string
  detail?: boolean
  output?: string
  normal?: string
  areas?: string
  size?: string
}

/** `furrow strokes`: draws the wrinkles of a document into the maps of a face. */
export const strokesCommand = new Command('strokes')
  .description('draw wrinkles from strokes: a height map, a normal map and the areas of a face')
  .argument('<strokes>', 'document of strokes (JSON)')
  .requiredOption('--face <file>', 'the face the strokes are drawn on (.glb, .gltf)')
  .option('--mesh <name>', 'its mesh (default: "skin", or the only one)')
  .option('--base <image>', "smooth normal map under the wrinkles (default: the mesh's own)")
  .option('--detail', 'wrinkles alone over nothing, for a layer of kind "detail"')
  .option('-o, --output <file>', 'height map, 16-bit gray PNG')
  .option('--normal <file>', 'wrinkled normal map, 8-bit RGB PNG')
  .option('--areas <folder>', 'one gray PNG per area, white = no wrinkles')
  .option('--size <texels>', `side of both maps (default: the document's, the base's, or ${USUAL_SIZE})`)
  .action(drawStrokes)

async function drawStrokes(path: string, options: Options): Promise<void> {
  if (!options.output && !options.normal && !options.areas) {
    throw new FurrowError({
      who: WHO,
      what: 'nothing to make',
      limit: '-o HEIGHT.png, --normal NORMAL.png, --areas FOLDER',
      remedy: 'name at least one output',
    })
  }
  const asked = readSize(options.size)
  const document = await readStrokes(path)
  const face = await readFace(options.face, options.mesh)
  const outputs: Output[] = []
  const notes: string[] = []
  if (options.output || options.normal) {
    const base = options.normal ? await readBase(options, face, asked ?? document.size) : undefined
    const side = asked ?? document.size ?? USUAL_SIZE
    const metric = surfaceMetric(face.mesh, base?.width ?? side, base?.height ?? side)
    await drawMaps(
      document,
      metric,
      face.hasTangents ? 'orthonormal' : 'derivative',
      base,
      options,
      outputs,
      notes,
    )
  }
  if (options.areas) {
    const folder = options.areas
    for (const { name, weights } of paintAreas(document, surfaceMetric(face.mesh, DEFAULT_AREA_SIZE))) {
      const file = join(folder, `${name}.png`)
      outputs.push({ path: file, bytes: await encodeArea(weights) })
      notes.push(`${file}: ${weights.width} x ${weights.height}, white = no wrinkles`)
    }
  }
  await writeAll(outputs)
  process.stdout.write(`${notes.join('\n')}\n`)
}

async function drawMaps(
  document: StrokesDocument,
  metric: Metric,
  frame: TangentFrame,
  base: RgbaImage | undefined,
  { output, normal }: Options,
  outputs: Output[],
  notes: string[],
): Promise<void> {
  const size = `${metric.width} x ${metric.height}`
  const relief = withBar('strokes', (progress) => strokesToHeight(document.strokes, metric, progress))
  if (output) {
    outputs.push({ path: output, bytes: await encodeHeight(relief) })
    notes.push(`${output}: ${size}, 16-bit, ${HEIGHT_ZERO} = 0 mm, ${scaleText()}, ${rangeOf(relief)}`)
  }
  if (normal) {
    const wrinkles = heightToNormal(relief, metric, frame)
    const map = base ? combineNormals(base, wrinkles) : wrinkles
    outputs.push({ path: normal, bytes: await encodeNormal(map) })
    const over = base ? "over the skin's own normal map" : 'over a flat skin'
    notes.push(`${normal}: ${size}, ${document.strokes.length} strokes ${over}`)
  }
}

const scaleText = () => `1 step = ${1 / HEIGHT_STEPS_PER_MM} mm`

function rangeOf({ data }: HeightMap): string {
  let [low, high] = [0, 0]
  for (const mm of data) {
    low = Math.min(low, mm)
    high = Math.max(high, mm)
  }
  return `${low.toFixed(2)}..${high.toFixed(2)} mm`
}

function readSize(text: string | undefined): number | undefined {
  if (text === undefined) return undefined
  const size = Number(text)
  if (Number.isInteger(size) && size >= 16 && size <= MAX_IMAGE_SIDE) return size
  throw new FurrowError({
    who: WHO,
    what: '--size is no size of a map',
    value: text,
    limit: `whole numbers, 16..${MAX_IMAGE_SIDE}`,
    remedy: 'choose e.g. 1024',
  })
}

async function readStrokes(path: string): Promise<StrokesDocument> {
  let json: unknown
  try {
    json = JSON.parse(await readFile(path, 'utf8'))
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read the strokes ${path} (${firstLine(error)})`,
      remedy: 'check the path and that the file is JSON',
    })
  }
  return parseStrokes(json)
}

async function readBase(
  { base, detail }: Options,
  face: Face,
  size: number | undefined,
): Promise<RgbaImage | undefined> {
  if (detail && base !== undefined) {
    throw new FurrowError({
      who: WHO,
      what: 'a layer of detail has no base',
      value: base,
      remedy: 'leave out --base or --detail',
    })
  }
  if (detail) return undefined
  if (base === undefined) {
    return face.normalMap && decodeNormalMap(face.normalMap, `of the mesh ${face.name}`, size)
  }
  let bytes: Uint8Array
  try {
    bytes = await readFile(base)
  } catch (error) {
    throw new FurrowError({
      who: WHO,
      what: `cannot read the base ${base} (${firstLine(error)})`,
      remedy: 'check the path',
    })
  }
  return decodeNormalMap(bytes, base, size)
}
