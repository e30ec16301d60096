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

export const strokesCommand = createCommand('strokes')
  .description('draw wrinkle lines (strokes) into maps')
  .argument('<strokes>', 'strokes document (.json)')
  .requiredOption('--face <file>', 'face to draw on (.glb, .vrm, .gltf)')
  .option('--mesh <name>', 'mesh to draw on (default: "skin", or detected)')
  .option('--base <image>', 'normal map to draw over (default: that of the mesh)')
  .addOption(new Option('--detail', 'draw over a flat normal map, for a "detail" layer').conflicts('base'))
  .option('-o, --output <file>', 'write the height map, 16-bit gray PNG')
  .option('--normal <file>', 'write the normal map, 8-bit RGB PNG')
  .option('--areas <folder>', 'write one gray PNG per area, black = visible')
  .addOption(
    new Option('--into <folder>', 'write all maps and areas to a folder that furrow pack reads').conflicts([
      'base',
      'detail',
    ]),
  )
  .option('--layer <name>', 'draw only this layer (default: all)')
  .option(
    '--size <texels>',
    `size of the maps, 16 to ${MAX_IMAGE_SIDE} (default: from the document or base, or ${DEFAULT_SIZE})`,
    numberParser({ min: 16, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true }),
  )
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .addHelpText(
    'after',
    `
At least one of -o, --normal, --areas and --into is required.
docs/strokes-format.md describes the document.

Examples:
  $ furrow strokes scars.json --face avatar.glb --normal n.png --areas areas
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
      remedy: 'give at least one',
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
  // Files in the folder may be overwritten, but not textures of the face that are in this folder.
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

/**
 * Returns the strokes to draw: those of `layer`, by default all strokes. Throws if they have several layers and a map
 * is drawn, because a map can show only one layer.
 */
function strokesOfLayer(document: StrokesDocument, { layer, output, normal }: Options): Stroke[] {
  const { strokes } = document
  const layers = layersOf(document)
  if (layer !== undefined && !layers.includes(layer)) {
    throw new FurrowError({
      code: 'unknown-name',
      who: WHO,
      problem: 'unknown layer',
      value: layer,
      limit: layers.length > 0 ? layers.join(', ') : 'the document has no layers',
      remedy: didYouMean(layer, layers, layers.length > 0 ? 'choose one of these' : 'omit --layer'),
    })
  }
  if (layer === undefined && layers.length > 1 && (output ?? normal) !== undefined) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      problem: 'a map can show only one layer, but the document has several',
      value: layers.join(', '),
      remedy: `choose one, e.g. --layer ${layers[0]}`,
    })
  }
  return layer === undefined ? strokes : strokes.filter((stroke) => stroke.layer === layer)
}

/** Returns the names of the areas. Throws if a name is not valid as a file name. */
function areaNames(document: StrokesDocument): string[] {
  const names = paintedNames(document)
  const invalid = names.find((name) => !isFileName(name))
  if (invalid === undefined) return names
  throw new FurrowError({
    who: WHO,
    problem: 'the group of a stroke is not a valid file name',
    value: invalid,
    limit: `e.g. ${fileNamesOf([invalid])}`,
    remedy: 'rename the group',
  })
}
