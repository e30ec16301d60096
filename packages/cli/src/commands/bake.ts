import { performance } from 'node:perf_hooks'
import { Command } from 'commander'
import { FurrowError, type GrayImage, MAX_IMAGE_SIDE } from 'furrow'
import { BAKE_DEFAULTS, type BakedMaps, bakeMaps, meshDiagonal } from 'furrow/author'
import sharp from 'sharp'
import { raySourceOf } from '../bake/ray-source.ts'
import { readLow, readSurface } from '../bake/read-meshes.ts'
import { encodeHeight, HEIGHT_STEPS_PER_MM, HEIGHT_ZERO, type Output, writeAll } from '../images.ts'
import { encodeNormalMap } from '../normal-map.ts'
import { readChoice, readNumber } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'

const WHO = 'furrow bake'

/** The usual cage, as a share of the low mesh's diagonal. */
const USUAL_CAGE = 0.02

/** Rays per sample for the occlusion; with four samples 32 per texel. */
const USUAL_RAYS = 8

interface Options {
  output?: string
  height?: string
  occlusion?: string
  mesh?: string
  size: string
  cage?: string
  samples: string
  tangents: string
  margin: string
  bits: string
  rays: string
  reach?: string
  json?: boolean
}

/** `furrow bake`: a sculpt of many polygons to the maps of a mesh of few. */
export const bakeCommand = new Command('bake')
  .description('bake a detailed sculpt into normal, height and occlusion maps of a low-polygon mesh')
  .argument('<high>', 'the detailed sculpt (.glb, .gltf); all its meshes count')
  .argument('<low>', 'the mesh the maps are for (.glb, .gltf), with texture coordinates and normals')
  .option('-o, --output <file>', 'tangent-space normal map (.png), green up as in glTF')
  .option('--height <file>', 'height above the low mesh, 16-bit gray PNG')
  .option('--occlusion <file>', 'ambient occlusion, 8-bit gray PNG, white = open')
  .option('--mesh <name>', 'mesh of the low file (default: "skin", or the only one)')
  .option('--size <texels>', 'side of the maps', String(BAKE_DEFAULTS.size))
  .option(
    '--cage <mm>',
    `how far the sculpt may lie from the mesh (default: ${100 * USUAL_CAGE}% of its size)`,
  )
  .option('--samples <count>', 'rays per texel: 1, 4, 9 or 16', String(BAKE_DEFAULTS.samples))
  .option(
    '--tangents <kind>',
    'for a mesh without tangents: mikktspace, or derivative (three.js)',
    'mikktspace',
  )
  .option('--margin <texels>', 'how far islands are carried outwards', String(BAKE_DEFAULTS.margin))
  .option('--bits <bits>', 'of the normal map per channel: 8 or 16', String(BAKE_DEFAULTS.bits))
  .option('--rays <count>', 'occlusion rays per sample', String(USUAL_RAYS))
  .option('--reach <mm>', 'how far away something still occludes (default: any distance)')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow bake sculpt.glb face.glb -o normal.png
  $ furrow bake sculpt.glb face.glb -o normal.png --height height.png --occlusion ao.png --size 2048 --cage 4
  $ furrow bake sculpt.glb face.glb -o normal.png --mesh skin --tangents derivative --samples 16`,
  )
  .action(bake)

async function bake(high: string, low: string, options: Options): Promise<void> {
  const start = performance.now()
  const settings = readSettings(options)
  const paths = await checkOutputs(options)
  const { name, mesh, tangents } = await readLow(low, options.mesh, settings.tangents)
  const surface = await readSurface(high)
  const cage = settings.cage ?? USUAL_CAGE * meshDiagonal(mesh)
  const source = raySourceOf(surface)
  const baked = guarded(() =>
    withBar('bake', (progress) => bakeMaps(mesh, source, { ...settings, cage }, progress)),
  )
  await writeAll(await encodeAll(baked, options), WHO)
  report(
    baked,
    {
      files: paths,
      mesh: name,
      size: settings.size,
      tangents,
      triangles: { high: surface.indices.length / 3, low: mesh.positions.length / 9 },
      cageMm: Math.round(1e6 * cage) / 1000,
      samples: baked.samples,
      misses: baked.misses,
      emptyTexels: baked.emptyTexels,
      milliseconds: Math.round(performance.now() - start),
    },
    options,
  )
  if (!surface.normals)
    console.error(`${WHO}: ${high} has no normals, so its facets show; export it with smooth ones`)
}

function readSettings(options: Options) {
  const number = (option: string, text: string, low: number, high: number, example: number, unit?: string) =>
    readNumber(WHO, option, text, { low, high, example, ...(unit ? { unit } : { whole: true }) })
  const metres = (option: string, text: string | undefined, example: number) =>
    text === undefined ? undefined : number(option, text, 0.001, 100_000, example, 'mm') / 1000
  const reach = metres('--reach', options.reach, 20)
  const rays = number('--rays', options.rays, 1, 4096, USUAL_RAYS)
  return {
    size: number('--size', options.size, 16, MAX_IMAGE_SIDE, BAKE_DEFAULTS.size),
    cage: metres('--cage', options.cage, 5),
    samples: Number(readChoice(WHO, '--samples', options.samples, ['4', '1', '9', '16'])),
    tangents: readChoice(WHO, '--tangents', options.tangents, ['mikktspace', 'derivative']),
    margin: number('--margin', options.margin, 0, MAX_IMAGE_SIDE, BAKE_DEFAULTS.margin),
    bits: readChoice(WHO, '--bits', options.bits, ['8', '16']) === '8' ? (8 as const) : (16 as const),
    occlusionRays: options.occlusion ? rays : 0,
    ...(reach !== undefined && { occlusionReach: reach }),
  }
}

async function checkOutputs({ output, height, occlusion }: Options): Promise<string[]> {
  const paths = [output, height, occlusion].filter((path) => path !== undefined)
  const fault = (what: string, value: string | undefined, limit: string, remedy: string) =>
    new FurrowError({ who: WHO, what, value, limit, remedy })
  if (paths.length === 0) {
    const limit = '-o NORMAL.png, --height HEIGHT.png, --occlusion AO.png'
    throw fault('nothing to make', undefined, limit, 'name at least one output')
  }
  const twice = paths.find((path, i) => paths.indexOf(path) < i)
  if (twice) throw fault('one file for two maps', twice, 'a file for each', 'name them apart')
  for (const path of paths) await checkWritable(path, WHO)
  return paths
}

/** The command speaks for the function: users know no `bakeMaps`, and no memory that cannot be had. */
function guarded<T>(work: () => T): T {
  try {
    return work()
  } catch (error) {
    if (error instanceof FurrowError) error.message = error.message.replace(/^bakeMaps/, WHO)
    if (!(error instanceof RangeError)) throw error
    throw new FurrowError({
      who: WHO,
      what: 'not enough memory for maps of this size',
      remedy: 'choose a smaller --size',
    })
  }
}

async function encodeAll(baked: BakedMaps, { output, height, occlusion }: Options): Promise<Output[]> {
  const outputs: Output[] = []
  if (output) outputs.push({ path: output, bytes: await encodeNormalMap(baked.normal) })
  if (height) outputs.push({ path: height, bytes: await encodeHeight(baked.height) })
  if (occlusion) outputs.push({ path: occlusion, bytes: await encodeGray(baked.occlusion!) })
  return outputs
}

async function encodeGray({ width, height, data }: GrayImage): Promise<Uint8Array> {
  return sharp(data, { raw: { width, height, channels: 1 } })
    .toColourspace('b-w')
    .png({ compressionLevel: 9 })
    .toBuffer()
}

interface Report {
  files: string[]
  mesh: string
  size: number
  tangents: string
  triangles: { high: number; low: number }
  cageMm: number
  samples: number
  misses: number
  emptyTexels: number
  milliseconds: number
}

function report(baked: BakedMaps, facts: Report, options: Options): void {
  const { files, mesh, size, tangents, triangles, cageMm, samples, misses, emptyTexels, milliseconds } = facts
  const text = options.json
    ? JSON.stringify(facts)
    : [
        `${files.join(', ')}: ${size} x ${size}, ${triangles.high} triangles onto ${triangles.low} of ${mesh}, cage ${cageMm} mm, ${(milliseconds / 1000).toFixed(1)} s`,
        `tangents ${tangents === 'of the mesh' ? tangents : `by ${tangents}`}; ${misses} of ${samples} rays met nothing (${((100 * misses) / samples).toFixed(2)}%), ${emptyTexels} texels empty`,
        ...(options.height
          ? [`${options.height}: ${HEIGHT_ZERO} = 0 mm, ${HEIGHT_STEPS_PER_MM} steps = 1 mm`]
          : []),
      ].join('\n')
  process.stdout.write(`${text}\n`)
  const beyond = baked.height.data.some((mm) => Math.abs(mm) > 32.767)
  if (options.height && beyond) {
    console.error(
      `${WHO}: some heights are beyond 32.767 mm and were cut off; a smaller --cage keeps rays close`,
    )
  }
}
