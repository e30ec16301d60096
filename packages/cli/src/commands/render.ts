import { performance } from 'node:perf_hooks'
import { SingleBar } from 'cli-progress'
import { Command } from 'commander'
import { EXPRESSIONS, FurrowError } from 'furrow'
import { weightCollector } from '../numbers.ts'
import {
  MODE_NAMES,
  PICTURE_DEFAULTS,
  PICTURE_SIDE,
  type PictureRequest,
  RENDERER_NAMES,
  VIEW_NAMES,
} from '../render/picture.ts'
import { type Picture, renderPictures } from '../render/render-pictures.ts'
import { checkWritable, writePng } from '../render/write-png.ts'

const WHO = 'furrow render'

interface Options
  extends Pick<PictureRequest, 'wrinkles' | 'mesh' | 'expression' | 'view' | 'renderer' | 'mode'> {
  output: string
  set?: Record<string, number>
  activation?: Record<string, number>
  size?: { width: number; height: number }
  json?: boolean
}

/** `furrow render`: one picture of a face with its wrinkles. */
export const renderCommand = new Command('render')
  .description('make a picture of a face with its wrinkles, without a window')
  .argument('<face>', 'the face (.glb)')
  .requiredOption('-o, --output <file>', 'the picture (.png)')
  .option(
    '--wrinkles <file>',
    "another wrinkle set (default: the face's own, else NAME/wrinkles.json beside NAME.glb)",
  )
  .option('--mesh <name>', 'the mesh that wrinkles (default: "skin", or the largest)')
  .option('--expression <name>', EXPRESSIONS.map(({ name }) => name).join(', '))
  .option('--set <target=weight...>', 'blendshapes, 0..1, on top of the expression', weightCollector(WHO))
  .option(
    '--activation <area=share...>',
    'wrinkles of an area, 0..1, on top of the expression',
    weightCollector(WHO),
  )
  .option('--size <size>', `WIDTHxHEIGHT in pixels (default: ${sizeText()})`, parseSize)
  .option('--view <name>', `${VIEW_NAMES.join(', ')} (default: ${PICTURE_DEFAULTS.view})`)
  .option('--renderer <name>', `${RENDERER_NAMES.join(', ')} (default: ${PICTURE_DEFAULTS.renderer})`)
  .option('--mode <name>', `${MODE_NAMES.join(', ')} (default: ${PICTURE_DEFAULTS.mode})`)
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
"left" and "right" are the person's own. With --set alone the wrinkles follow the blendshapes, where the file says how.

Examples:
  $ furrow render faces/human.glb -o surprised.png --expression surprised
  $ furrow render faces/human.glb -o brow.png --set browOuterUpLeft=1 --activation foreheadLeft=0.7 --view close
  $ furrow render faces/human.glb -o plain.png --expression surprised --mode off --size 1600x1200`,
  )
  .action(render)

async function render(input: string, options: Options): Promise<void> {
  const start = performance.now()
  const { output, set, activation, size, json, ...rest } = options
  await checkWritable(output, WHO)
  const [picture] = await drawWithBar({ input, ...rest, ...size, targets: set, activations: activation })
  for (const warning of picture.warnings) console.error(warning)
  await writePng(output, picture, WHO)
  const milliseconds = Math.round(performance.now() - start)
  const { width, height, renderer, adapter } = picture
  const text = json
    ? JSON.stringify({ file: output, width, height, renderer, adapter, milliseconds })
    : `${output}: ${width} x ${height}, ${renderer} on ${adapter}, ${(milliseconds / 1000).toFixed(1)} s`
  process.stdout.write(`${text}\n`)
}

/** On a terminal stderr shows the steps; elsewhere it stays silent. */
async function drawWithBar(request: PictureRequest): Promise<Picture[]> {
  const bar = new SingleBar({
    format: 'render {bar} {step}',
    stream: process.stderr,
    clearOnComplete: true,
  })
  const steps = ['starting the browser', 'drawing', 'writing']
  bar.start(steps.length, 0, { step: steps[0] })
  try {
    return await renderPictures([request], (done) => bar.update(done + 1, { step: steps[done + 1] }))
  } finally {
    bar.stop()
  }
}

function parseSize(text: string): { width: number; height: number } {
  const match = /^(\d+)x(\d+)$/.exec(text)
  const [width, height] = match ? [Number(match[1]), Number(match[2])] : [Number.NaN, Number.NaN]
  const { min, max } = PICTURE_SIDE
  if ([width, height].every((side) => side >= min && side <= max)) return { width, height }
  throw new FurrowError({
    who: WHO,
    what: 'no size of a picture',
    value: text,
    limit: `WIDTHxHEIGHT, ${min}..${max} pixels each`,
    remedy: `write e.g. --size ${sizeText()}`,
  })
}

function sizeText(): string {
  return `${PICTURE_DEFAULTS.width}x${PICTURE_DEFAULTS.height}`
}
