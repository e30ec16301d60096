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

/** `furrow render`: draws a picture of a face with its wrinkles. */
export const renderCommand = createCommand('render')
  .description('draw a picture of a face with its wrinkles, without a window')
  .argument('<face>', 'the face (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <file>', 'the picture (.png)')
  .option(
    '--wrinkles <file>',
    "another wrinkle set (default: the face's own, or NAME/wrinkles.json beside NAME.glb)",
  )
  .option('--mesh <name>', 'the mesh that wrinkles (default: "skin", or the largest)')
  .addOption(new Option('--expression <name>', 'an expression').choices(EXPRESSIONS.map(({ name }) => name)))
  .option('--set <target=weight...>', 'blendshapes, 0 to 1, on top of the expression', parseWeight)
  .option('--activation <area=value...>', 'areas of wrinkles, 0 to 1, on top of the expression', parseWeight)
  .addOption(
    new Option('--size <size>', 'WIDTHxHEIGHT in pixels')
      .argParser(parseSize)
      .default({ width: PICTURE_DEFAULTS.width, height: PICTURE_DEFAULTS.height }, DEFAULT_SIZE),
  )
  .addOption(new Option('--view <name>', 'camera view').choices(VIEW_NAMES).default(PICTURE_DEFAULTS.view))
  .addOption(
    new Option('--renderer <name>', 'renderer').choices(RENDERER_NAMES).default(PICTURE_DEFAULTS.renderer),
  )
  .addOption(
    new Option('--mode <name>', 'mode of the wrinkles').choices(MODE_NAMES).default(PICTURE_DEFAULTS.mode),
  )
  .addOption(
    new Option('--relief <when>', 'whether the heights of layers move the surface')
      .choices(RELIEF_NAMES)
      .default(PICTURE_DEFAULTS.relief),
  )
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
"left" and "right" are the person's own. With --set alone the drivers of the file set the wrinkles.

Examples:
  $ furrow render wrinkled.glb -o surprised.png --expression surprised
  $ furrow render wrinkled.glb -o brow.png --set browOuterUpLeft=1 --activation glabellaLeft=0.7 --view close
  $ furrow render wrinkled.glb -o plain.png --expression surprised --mode off --size 1600x1200
  $ furrow render wrinkled.glb -o profile.png --set browInnerUp=1 --view left`,
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
