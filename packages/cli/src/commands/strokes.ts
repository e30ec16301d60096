import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { parseStrokes, type Stroke, type StrokesDocument } from 'furrow/author'
import { didYouMean, fileNamesOf, isFileName, MAX_IMAGE_SIDE, paintedNames } from 'furrow/internal'
import { layersOf, withCommandErrors } from 'furrow-files'
import { openSet, readFaceMesh, readJson, wasRead } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, forceOption, numberParser } from '../options.ts'
import { checkFolder, checkOutputs } from '../outputs.ts'
import { print } from '../print.ts'
import {
  areaPath,
  DEFAULT_SIZE,
  type DrawOptions,
  drawAreas,
  drawInto,
  drawMaps,
} from '../strokes/draw-files.ts'

const WHO = 'furrow strokes'

interface Options extends DrawOptions {
  face: string
  mesh?: string
  areas?: string
  into?: string
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
At least one of -o, --normal, --areas and --into is needed. Documents of strokes: docs/strokes-format.md.

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
      problem: 'no output',
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
  // The folder is updated, but not where the face has its textures in it.
  const updated = set ? [set.document, ...set.images.filter((image) => !wasRead(image))] : []
  const drawn = await withCommandErrors(WHO, async () => [
    ...(await drawMaps(document, strokes, face, options)),
    ...(await drawAreas(document, face, areas)),
    ...(set ? await drawInto(set, document, json, face, options) : []),
  ])
  await writeAll(drawn, WHO, { named: [output, normal], force, updated })
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
      problem: 'no stroke is of that layer',
      value: layer,
      limit: layers.length > 0 ? layers.join(', ') : 'the document has no layers',
      remedy: didYouMean(layer, layers, layers.length > 0 ? 'name one of them' : 'leave --layer out'),
    })
  }
  if (layer === undefined && layers.length > 1 && (output ?? normal) !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      problem: 'the document has strokes of several layers, and a map is of one',
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
    problem: 'the group of a stroke is not a valid file name, and its area is written to a file of that name',
    value: wrong,
    limit: `e.g. ${fileNamesOf([wrong])}`,
    remedy: 'rename the group',
  })
}
