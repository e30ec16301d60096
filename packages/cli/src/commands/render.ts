import { performance } from 'node:perf_hooks'
import { InvalidArgumentError, Option } from 'commander'
import { EXPRESSIONS } from 'furrow'
import { encodeRgb } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, parseWeight } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'
import {
  MODE_NAMES,
  PICTURE_DEFAULTS,
  PICTURE_SIDE,
  type PictureRequest,
  RELIEF_NAMES,
  RENDERER_NAMES,
  VIEW_NAMES,
} from '../render/picture.ts'
import { type Picture, renderPictures } from '../render/render-pictures.ts'

const WHO = 'furrow render'

const DEFAULT_SIZE = `${PICTURE_DEFAULTS.width}x${PICTURE_DEFAULTS.height}`

interface Options
  extends Pick<
    PictureRequest,
    'wrinkles' | 'mesh' | 'expression' | 'view' | 'renderer' | 'mode' | 'relief' | 'allowOutside'
  > {
  output: string
  set?: Record<string, number>
  activation?: Record<string, number>
  size: { width: number; height: number }
  json?: boolean
}

export const renderCommand = createCommand('render')
  .description('render a face with wrinkles to an image')
  .argument('<face>', 'face (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <file>', 'image (.png)')
  .option('--wrinkles <file>', 'wrinkles.json to use (default: wrinkles in the face)')
  .option('--mesh <name>', 'mesh with wrinkles (default: "skin" or largest)')
  .addOption(
    new Option('--expression <name>', 'expression to apply').choices(EXPRESSIONS.map(({ name }) => name)),
  )
  .option('--set <target=weight...>', 'blendshape weights, 0 to 1', parseWeight)
  .option('--activation <area=value...>', 'activations of areas, 0 to 1', parseWeight)
  .addOption(
    new Option('--size <size>', `WIDTHxHEIGHT, ${PICTURE_SIDE.min} to ${PICTURE_SIDE.max}`)
      .argParser(parseSize)
      .default({ width: PICTURE_DEFAULTS.width, height: PICTURE_DEFAULTS.height }, DEFAULT_SIZE),
  )
  .addOption(new Option('--view <name>', 'camera view').choices(VIEW_NAMES).default(PICTURE_DEFAULTS.view))
  .addOption(
    new Option('--renderer <name>', 'renderer').choices(RENDERER_NAMES).default(PICTURE_DEFAULTS.renderer),
  )
  .addOption(
    new Option('--mode <name>', 'shading of wrinkles; off hides them')
      .choices(MODE_NAMES)
      .default(PICTURE_DEFAULTS.mode),
  )
  .addOption(
    new Option('--relief <when>', 'displace the surface; near: only in close views')
      .choices(RELIEF_NAMES)
      .default(PICTURE_DEFAULTS.relief),
  )
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
--set and --activation override the expression. Without --activation, the
drivers of the file set the activations. "left" and "right" are sides of the
character, not of the image. If NAME.glb has no wrinkles, the command uses
NAME/wrinkles.json.

Examples:
  $ furrow render wrinkled.glb -o surprised.png --expression surprised
  $ furrow render wrinkled.glb -o brow.png --set browInnerUp=1 --view close`,
  )
  .action(render)

async function render(input: string, options: Options): Promise<void> {
  const start = performance.now()
  const { output, set, activation, size, json, ...rest } = options
  await checkOutputs([output], WHO, { inputs: [input] })
  const [picture] = await drawWithBar({ input, ...rest, ...size, targets: set, activations: activation })
  for (const warning of picture.warnings) warn(warning)
  const { width, height, pixels, renderer, adapter } = picture
  const bytes = await encodeRgb({ width, height, channels: 4, data: pixels })
  await writeAll([{ path: output, bytes }], WHO)
  const milliseconds = Math.round(performance.now() - start)
  const line = json
    ? JSON.stringify({ file: output, width, height, renderer, adapter, milliseconds })
    : `${output}: ${width} x ${height}, ${renderer} on ${adapter}, ${(milliseconds / 1000).toFixed(1)} s`
  print(line, output)
}

function drawWithBar(request: PictureRequest): Promise<Picture[]> {
  const steps = ['starting the browser', 'drawing', 'writing']
  return withBar('render', (progress) => {
    progress(0, steps.length, steps[0])
    return renderPictures([request], (done) => progress(done + 1, steps.length, steps[done + 1]))
  })
}

function parseSize(text: string): { width: number; height: number } {
  const match = /^(\d+)x(\d+)$/.exec(text)
  const [width, height] = match ? [Number(match[1]), Number(match[2])] : [Number.NaN, Number.NaN]
  const { min, max } = PICTURE_SIDE
  if ([width, height].every((side) => side >= min && side <= max)) return { width, height }
  throw new InvalidArgumentError(`It must be WIDTHxHEIGHT with sides from ${min} to ${max} pixels.`)
}
