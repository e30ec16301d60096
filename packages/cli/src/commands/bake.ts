import { performance } from 'node:perf_hooks'
import { Option } from 'commander'
import { FurrowError } from 'furrow'
import { BAKE_DEFAULTS, type BakedMaps, type BakeOptions, bakeMaps } from 'furrow/author'
import { HEIGHT_STEPS_PER_MM, MAX_IMAGE_SIDE, meshDiagonal } from 'furrow/internal'
import { DEFAULT_CAGE, type OutputFile, raySourceOf, withCommandErrors } from 'furrow-files'
import {
  encodeHeight,
  encodeNormalMap,
  encodePng,
  HEIGHT_ZERO,
  MAX_HEIGHT,
  readLow,
  readSurface,
  type Tangents,
} from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, numberParser } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow bake'

/** Default occlusion rays per sample. A texel has four samples by default, so it gets 32 rays. */
const DEFAULT_RAYS = 8

interface Options {
  output?: string
  height?: string
  occlusion?: string
  mesh?: string
  size: number
  /** Millimetres. */
  cage?: number
  samples: '1' | '4' | '9' | '16'
  tangents: Tangents
  margin: number
  bits: '8' | '16'
  rays: number
  /** Millimetres. */
  reach?: number
  allowOutside?: boolean
  json?: boolean
}

const millimetres = numberParser({ min: 0.001, max: 100_000, unit: 'mm' })
const count = (min: number, max: number) => numberParser({ min, max, integer: true })

export const bakeCommand = createCommand('bake')
  .description('bake a high-poly sculpt into texture maps')
  .argument('<high>', 'high-poly sculpt, one or more meshes (.glb, .vrm, .gltf)')
  .argument('<low>', 'low-poly mesh with UVs and normals (.glb, .vrm, .gltf)')
  .option('-o, --output <file>', 'write the tangent-space normal map (.png)')
  .option('--height <file>', 'write heights above the low-poly mesh, 16-bit gray PNG')
  .option('--occlusion <file>', 'write ambient occlusion, 8-bit gray PNG')
  .option('--mesh <name>', 'low-poly mesh to bake to (default: "skin", or detected)')
  .option(
    '--size <texels>',
    `size of the maps, 16 to ${MAX_IMAGE_SIDE}`,
    count(16, MAX_IMAGE_SIDE),
    BAKE_DEFAULTS.size,
  )
  .option(
    '--cage <mm>',
    `maximum distance from mesh to sculpt (default: ${100 * DEFAULT_CAGE}% of the mesh diagonal)`,
    millimetres,
  )
  .addOption(
    new Option('--samples <count>', 'rays per texel')
      .choices(['1', '4', '9', '16'])
      .default(String(BAKE_DEFAULTS.samples)),
  )
  .addOption(
    new Option('--tangents <kind>', 'method for tangents that the mesh lacks')
      .choices(['mikktspace', 'derivative'])
      .default('mikktspace'),
  )
  .option(
    '--margin <texels>',
    `padding around UV islands, 0 to ${MAX_IMAGE_SIDE}`,
    count(0, MAX_IMAGE_SIDE),
    BAKE_DEFAULTS.margin,
  )
  .addOption(
    new Option('--bits <bits>', 'bits per channel of the normal map')
      .choices(['8', '16'])
      .default(String(BAKE_DEFAULTS.bits)),
  )
  .option('--rays <count>', 'occlusion rays per sample, 1 to 4096', count(1, 4096), DEFAULT_RAYS)
  .option('--reach <mm>', 'maximum distance of occluders (default: no limit)', millimetres)
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
At least one of -o, --height and --occlusion is required. three.js computes
missing tangents like --tangents derivative.

Examples:
  $ furrow bake sculpt.glb face.glb -o normal.png
  $ furrow bake sculpt.glb face.glb --height height.png --size 2048 --cage 4`,
  )
  .action(bake)

async function bake(high: string, low: string, options: Options): Promise<void> {
  const start = performance.now()
  const paths = outputsOf(options)
  await checkOutputs(paths, WHO, { inputs: [high, low] })
  const { name, mesh, tangents } = await readLow(low, options.mesh, options.tangents, options)
  const surface = await readSurface(high, options)
  const cage = options.cage === undefined ? DEFAULT_CAGE * meshDiagonal(mesh) : options.cage / 1000
  const source = raySourceOf(surface)
  const baked = withCommandErrors(WHO, () =>
    withBar('bake', (progress) => bakeMaps(mesh, source, { ...settingsOf(options), cage }, progress)),
  )
  await writeAll(await encodeAll(baked, options), WHO)
  printSummary(
    baked,
    {
      files: paths,
      mesh: name,
      size: options.size,
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
  if (!surface.normals) {
    warn(`${WHO}: ${high} has no normals, so its facets are visible; export it with smooth normals`)
  }
}

function settingsOf(options: Options): Omit<BakeOptions, 'cage'> {
  const { size, margin, occlusion, rays, reach } = options
  return {
    size,
    samples: Number(options.samples),
    margin,
    bits: options.bits === '8' ? 8 : 16,
    occlusionRays: occlusion ? rays : 0,
    ...(reach !== undefined && { occlusionReach: reach / 1000 }),
  }
}

function outputsOf({ output, height, occlusion }: Options): string[] {
  const paths = [output, height, occlusion].filter((path) => path !== undefined)
  if (paths.length === 0) {
    throw new FurrowError({
      code: 'usage',
      who: WHO,
      problem: 'no output',
      limit: '-o NORMAL.png, --height HEIGHT.png, --occlusion AO.png',
      remedy: 'give at least one',
    })
  }
  return paths
}

async function encodeAll(baked: BakedMaps, { output, height, occlusion }: Options): Promise<OutputFile[]> {
  const outputs: OutputFile[] = []
  if (output) outputs.push({ path: output, bytes: await encodeNormalMap(baked.normal) })
  if (height) outputs.push({ path: height, bytes: await encodeHeight(baked.height) })
  if (occlusion)
    outputs.push({ path: occlusion, bytes: await encodePng({ ...baked.occlusion!, channels: 1 }) })
  return outputs
}

interface Summary {
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

function printSummary(baked: BakedMaps, summary: Summary, options: Options): void {
  const { files, mesh, size, tangents, triangles, cageMm, samples, misses, emptyTexels, milliseconds } =
    summary
  const lines = options.json
    ? JSON.stringify(summary)
    : [
        `${files.join(', ')}: ${size} x ${size}, ${triangles.high} triangles onto ${triangles.low} of ${mesh}, cage ${cageMm} mm, ${(milliseconds / 1000).toFixed(1)} s`,
        `tangents ${tangents === 'of the mesh' ? tangents : `by ${tangents}`}; ${misses} of ${samples} rays missed (${((100 * misses) / samples).toFixed(2)}%), ${emptyTexels} texels had no hit`,
        ...(options.height
          ? [`${options.height}: ${HEIGHT_ZERO} = 0 mm, ${HEIGHT_STEPS_PER_MM} steps = 1 mm`]
          : []),
      ]
  print(lines, ...files)
  const isClamped = baked.height.data.some((mm) => Math.abs(mm) > MAX_HEIGHT)
  if (options.height && isClamped) {
    warn(`${WHO}: heights beyond ${MAX_HEIGHT} mm were clamped; use a smaller --cage`)
  }
}
