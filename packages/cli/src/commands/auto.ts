import { join } from 'node:path'
import { InvalidArgumentError, Option } from 'commander'
import { FurrowError } from 'furrow'
import {
  AUTO_DEFAULTS,
  AUTO_REGIONS,
  type AutoPreset,
  type AutoRegion,
  CLOTH_KINDS,
  type ClothKind,
  parseAutoPreset,
} from 'furrow/author'
import { AUTO_STEPS, BULGES_FROM, SURFACE_KINDS, type SurfaceKind, strokesOf } from 'furrow/internal'
import {
  checkBasisSize,
  checkTriangles,
  documentOf,
  findSurfaces,
  jsonFile,
  parsePoses,
  shadingOf,
  withPoses,
} from 'furrow-files'
import { FACE_EXTENSIONS, readGlbFile, readJson } from 'furrow-files/node'
import { makeReport } from '../auto/report/make-report.ts'
import { Steps } from '../auto/steps.ts'
import { summaryLines, summaryOf } from '../auto/summary.ts'
import { wrinkleSurfaces } from '../auto/wrinkle-surface.ts'
import { createCommand } from '../command.ts'
import { faceFiles } from '../face-outputs.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, forceOption, numberParser } from '../options.ts'
import { checkFolder, checkOutputs, isStdout } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow auto'

const SIZES = ['512', '1024', '2048', '4096'] as const

/**
 * Number of progress steps before and after `autoWrinkles` of the first mesh: read, encode (with the wrinkles of other meshes), write. A
 * report adds `REPORT_STEPS`.
 */
const OWN_STEPS = 3
const REPORT_STEPS = 2

/** Default maximum number of layers with lines, with `--ktx2`. Two layers of 1024 x 1024 texels take 2 MB in the file. */
const KTX2_LAYERS = 2

interface Options {
  output: string
  preset?: string
  age?: number
  strength?: number
  size: (typeof SIZES)[number]
  seed?: number
  symmetry?: number
  mesh?: string
  kind?: Map<string, SurfaceKind>
  cloth?: ClothKind
  poses?: string
  layers?: number
  areas: number
  furrows?: boolean
  ktx2?: boolean
  regions?: AutoRegion[]
  replace?: boolean
  allowOutside?: boolean
  force?: boolean
  report?: string
  strokes?: string
  json?: boolean
}

const years = numberParser({ min: 20, max: 80, unit: 'years' })
const factor = numberParser({ min: 0, max: 2 })
const fraction = numberParser({ min: 0, max: 1 })
const count = (min: number, max: number) => numberParser({ min, max, integer: true })

export const autoCommand = createCommand('auto')
  .description('generate wrinkles from blendshapes and joints')
  .argument('<face>', 'character with blendshapes or joints (.glb, .vrm, .gltf)')
  .requiredOption('-o, --output <file>', 'character with wrinkles (.glb, .vrm, .gltf)')
  .option('--preset <file>', 'settings per region; other options override them (.json)')
  .option(
    '--age <years>',
    `age, 20 to 80; also ages the neutral face if given, with bulges from ${BULGES_FROM} on (default: ${AUTO_DEFAULTS.age})`,
    years,
  )
  .option(
    '--strength <factor>',
    `scale of line depth and blood, 0 to 2 (default: ${AUTO_DEFAULTS.strength})`,
    factor,
  )
  .addOption(
    new Option('--size <texels>', 'size of the maps').choices(SIZES).default(String(AUTO_DEFAULTS.size)),
  )
  .option(
    '--seed <number>',
    'integer seed; same seed, same lines (default: from the file, or else from the proportions of the face)',
    count(0, 2 ** 31 - 1),
  )
  .option(
    '--symmetry <fraction>',
    `how much the right side mirrors the left, 0 (as in people) to 1 (default: ${AUTO_DEFAULTS.symmetry})`,
    fraction,
  )
  .option(
    '--mesh <name>',
    'only mesh to wrinkle (default: the face, and all skin and cloth of a humanoid that joints move)',
  )
  .option('--kind <mesh=kind...>', `what a mesh or material is: ${SURFACE_KINDS.join(', ')}`, parseKind)
  .addOption(
    new Option('--cloth <kind>', 'how stiff all cloth is (default: told by names)').choices(CLOTH_KINDS),
  )
  .option('--poses <file>', 'poses that joints reach besides those of animations (.json)')
  .option(
    '--layers <count>',
    `maximum number of layers, 1 to 4 (default: ${AUTO_DEFAULTS.layers}; with --ktx2: ${KTX2_LAYERS}, plus 1 with --furrows, plus 1 with --age over ${BULGES_FROM})`,
    count(1, 4),
  )
  .option('--areas <count>', 'maximum number of areas with lines, 1 to 64', count(1, 64), AUTO_DEFAULTS.areas)
  .addOption(new Option('--regions <names...>', 'regions to wrinkle, all by default').choices(AUTO_REGIONS))
  .option('--furrows', 'add a layer of fine skin furrows; needs a large --size')
  .option('--ktx2', 'write maps and areas as KTX 2 (UASTC); heights stay PNG')
  .option('--replace', 'replace existing wrinkles')
  .option('--strokes <file>', 'also write the wrinkle lines as strokes (.json)')
  .option('--report <folder>', 'also write an HTML report')
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow auto avatar.glb -o wrinkled.glb
  $ furrow auto avatar.glb -o old.glb --age 70 --size 2048 --report report
  $ furrow auto body.glb -o wrinkled.glb --kind Body=skin`,
  )
  .action(auto)

/** Parses one value of `--kind`, and adds it to the values before. */
function parseKind(text: string, before: Map<string, SurfaceKind> = new Map()): Map<string, SurfaceKind> {
  const at = text.lastIndexOf('=')
  const kind = SURFACE_KINDS.find((name) => name === text.slice(at + 1))
  if (at < 1 || !kind)
    throw new InvalidArgumentError(`It must be MESH=KIND, with one of the kinds ${SURFACE_KINDS.join(', ')}.`)
  return new Map([...before, [text.slice(0, at), kind]])
}

async function auto(face: string, options: Options): Promise<void> {
  const { output, report, strokes, mesh, areas, furrows = false, ktx2 = false } = options
  const preset = await presetOf(options)
  const { age, regions, strength = AUTO_DEFAULTS.strength, symmetry = AUTO_DEFAULTS.symmetry } = preset
  const others = [furrows, age !== undefined && age > BULGES_FROM].filter(Boolean).length
  const layers = options.layers ?? (ktx2 ? KTX2_LAYERS + others : AUTO_DEFAULTS.layers)
  const settings = {
    ...preset,
    strength,
    symmetry,
    size: Number(options.size),
    layers,
    areas,
    furrows,
  }
  if (furrows && layers < 2) throw withoutFurrowLayer()
  if (ktx2) checkCompressible(settings.size, layers)
  const rules = { extensions: FACE_EXTENSIONS, inputs: [face], force: options.force ?? false }
  await checkOutputs([output], WHO, rules)
  if (report !== undefined) {
    await checkFolder(report, WHO)
    await checkOutputs([join(report, 'index.html')], WHO, { extensions: ['.html'] })
  }
  if (strokes !== undefined) await checkOutputs([strokes], WHO, { ...rules, extensions: ['.json'] })
  const replacing = { named: [output, strokes], force: options.force ?? false }
  const total = OWN_STEPS + AUTO_STEPS.length + (report === undefined ? 0 : REPORT_STEPS)
  const { made, bytes, texts, warnings } = await withBar('auto', async (progress) => {
    const steps = new Steps(progress, total)
    steps.begin('reading')
    const glb = await readGlbFile(face, WHO, options)
    checkTriangles(glb, WHO, mesh)
    const document = await documentOf(glb, face, WHO)
    const isLit = (i: number) => shadingOf(glb.json, i) !== 'unlit'
    const { surfaces, notes } = findSurfaces(document, face, WHO, {
      mesh,
      kinds: options.kind,
      cloth: options.cloth,
      isLit,
    })
    const source = { glb, document, who: WHO }
    const surfaceSettings = {
      options: settings,
      ktx2,
      replace: options.replace ?? false,
    }
    const { poses } = options
    const posed = poses
      ? withPoses(surfaces, parsePoses(await readJson(poses, WHO, 'the poses'), WHO), WHO)
      : surfaces
    // Regions belong to faces.
    const wanted = regions ? posed.slice(0, 1) : posed
    const { made, failed } = await wrinkleSurfaces(source, wanted, surfaceSettings, steps)
    if (made.length === 0) throw noWrinkles(failed[0].reason, failed[0].found.meshName)
    const [{ found, wrinkles }] = made
    const files = await faceFiles(glb, output, WHO, replacing)
    const bytes = files.reduce((sum, file) => sum + file.bytes.length, 0)
    if (strokes !== undefined) files.push({ path: strokes, bytes: jsonFile(strokesOf(wrinkles)) })
    const own = made.flatMap(({ warnings }) => warnings)
    const skipped = failed.map(({ found, reason }) => `mesh "${found.meshName}" gets no wrinkles: ${reason}`)
    const texts = [...own, ...skipped, ...notes]
    const warnings = texts.map((text) => `${WHO}: ${text}`)
    if (report !== undefined) {
      const { seeds, strengths, densities, ...plain } = settings
      const byRegion = Object.entries({ seeds, strengths, densities }).flatMap(([name, values]) =>
        values ? [[name, valuesText(values)]] : [],
      )
      const listed = {
        age: AUTO_DEFAULTS.age,
        ...plain,
        seed: wrinkles.seed,
        furrows: furrows ? 'yes' : 'no',
        regions: regions?.join(', ') ?? 'all',
        ...Object.fromEntries(byRegion),
      }
      const path = isStdout(output) ? face : output
      const source = { path, glb, found, wrinkles, surfaces: made, settings: listed, warnings }
      const drawn = await makeReport(source, report, steps, WHO)
      files.push(...drawn.files)
      steps.begin('writing')
      if (drawn.missing) warnings.push(`${WHO}: the report has no pictures of the face (${drawn.missing})`)
    }
    await writeAll(files, WHO, replacing)
    return { made, bytes, texts, warnings }
  })
  for (const warning of warnings) warn(warning)
  const outputs = { output, symmetry, ktx2, ...(report !== undefined && { report }) }
  print(
    options.json ? JSON.stringify(summaryOf(made, outputs, bytes, texts)) : summaryLines(made, outputs),
    output,
  )
}

/** Reads the preset, if any, and replaces its values by the options that are given. */
async function presetOf({ preset, age, strength, symmetry, seed, regions }: Options): Promise<AutoPreset> {
  const read = preset === undefined ? {} : parseAutoPreset(await readJson(preset, WHO, 'the preset'), WHO)
  const given = { age, strength, symmetry, seed, regions }
  return { ...read, ...Object.fromEntries(Object.entries(given).filter(([, value]) => value !== undefined)) }
}

/** Formats the values of regions: `crowsFeet 0.5, chin 2`. */
function valuesText(values: object): string {
  return Object.entries(values)
    .map(([region, value]) => `${region} ${value}`)
    .join(', ')
}

/** Throws early if maps of this size and number would exceed the limit of the KTX 2 encoder. */
function checkCompressible(size: number, layers: number): void {
  const names = Array.from({ length: layers }, (_, i) => `layer ${i + 1}`)
  const maps = {
    width: size,
    height: size,
    channels: 4,
    srgb: false,
    names,
    layers: names.map(() => NO_PIXELS),
  } as const
  checkBasisSize(maps, WHO, 'choose a smaller --size or fewer --layers, or omit --ktx2')
}

const NO_PIXELS = new Uint8Array()

function withoutFurrowLayer(): FurrowError {
  return new FurrowError({
    code: 'usage',
    who: WHO,
    problem: 'fine furrows need a separate layer',
    value: '--layers 1',
    limit: '2 to 4',
    remedy: 'omit --layers or --furrows',
  })
}

function noWrinkles(problem: string, mesh: string): FurrowError {
  return new FurrowError({
    who: WHO,
    problem,
    value: mesh,
    remedy: 'choose another mesh with --mesh, or draw wrinkles with furrow strokes',
  })
}
