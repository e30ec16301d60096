import { join } from 'node:path'
import { Command } from 'commander'
import { FurrowError, WRINKLE_MAPS } from 'furrow'
import {
  AUTO_DEFAULTS,
  AUTO_REGIONS,
  AUTO_STEPS,
  type AutoRegion,
  type AutoWrinkles,
  autoWrinkles,
} from 'furrow/author'
import { checkTriangles } from '../auto/check-triangles.ts'
import { packAuto } from '../auto/pack-auto.ts'
import { type FoundSkin, findSkin } from '../auto/read-skin.ts'
import { makeReport } from '../auto/report.ts'
import { Steps } from '../auto/steps.ts'
import { readDocument } from '../face.ts'
import { writeAll } from '../images.ts'
import { readChoice, readNumber } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'
import { embedWrinkles } from '../wrinkles/embed.ts'
import { encodeGlb, type Glb, readGlbFile } from '../wrinkles/glb-file.ts'
import { stripWrinkles } from '../wrinkles/strip.ts'

const WHO = 'furrow auto'

const SIZES = ['512', '1024', '2048', '4096']

/** Steps of the work besides those of `autoWrinkles`: reading, encoding, writing; and with a report its maps and pictures. */
const OWN_STEPS = 3
const REPORT_STEPS = 2

interface Options {
  output: string
  age?: string
  strength?: string
  size?: string
  seed?: string
  mesh?: string
  layers?: string
  areas?: string
  regions?: AutoRegion[]
  replace?: boolean
  report?: string
  json?: boolean
}

/** `furrow auto`: makes wrinkles from a face's own blendshapes. */
export const autoCommand = new Command('auto')
  .description("make wrinkles from a face's own blendshapes: where they push the skin together it creases")
  .argument('<face>', 'a face with blendshapes (.glb)')
  .requiredOption('-o, --output <file>', 'the face with its wrinkles (.glb)')
  .option('--age <years>', `20 to 80: lines grow in number, length and depth (default: ${AUTO_DEFAULTS.age})`)
  .option('--strength <factor>', '0 to 2: multiplies the depth (default: 1)')
  .option('--size <texels>', `side of the maps: ${SIZES.join(', ')} (default: ${AUTO_DEFAULTS.size})`)
  .option('--seed <number>', 'another number draws other lines; the same one the same bytes (default: 1)')
  .option('--mesh <name>', 'the mesh that wrinkles (default: the one whose skin brows, lids and mouth move)')
  .option('--layers <count>', 'layers that lines which cross may lie on: 1 to 4 (default: 4)')
  .option('--areas <count>', `areas that there may be: 1 to 64 (default: ${AUTO_DEFAULTS.areas})`)
  .option(
    '--regions <names...>',
    `parts of a face that may crease (default: all): ${AUTO_REGIONS.join(', ')}`,
    (name: string, before: AutoRegion[] = []) => [
      ...before,
      readChoice(WHO, '--regions', name, AUTO_REGIONS),
    ],
  )
  .option('--replace', 'drop the wrinkles that the file has')
  .option('--report <folder>', 'write a page there: before and after, strain, areas, layers, drivers')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow auto avatar.glb -o wrinkled.glb
  $ furrow auto avatar.glb -o old.glb --age 70 --size 2048 --report report`,
  )
  .action(auto)

async function auto(face: string, options: Options): Promise<void> {
  const { output, report, mesh } = options
  const settings = readSettings(options)
  await checkWritable(output, WHO, '.glb')
  if (report !== undefined) await checkWritable(join(report, 'index.html'), WHO, '.html')
  const total = OWN_STEPS + AUTO_STEPS.length + (report === undefined ? 0 : REPORT_STEPS)
  const { found, wrinkles, bytes, warnings } = await withBar('auto', async (progress) => {
    const steps = new Steps(progress, total)
    steps.begin('reading')
    const glb = await readGlbFile(face, WHO)
    checkTriangles(glb, WHO, mesh)
    const found = findSkin(await readDocument(face, WHO), face, WHO, mesh)
    makeRoom(glb, found, options.replace ?? false)
    const frame = found.hasTangents ? 'orthonormal' : 'derivative'
    const wrinkles = guarded(() =>
      autoWrinkles(found.skin, { ...settings, frame }, (done, count, step) => {
        if (done < count) steps.begin(step)
      }),
    )
    if (wrinkles.areas.length === 0) throw nothingCreases(found.meshName)
    steps.begin('encoding')
    embedWrinkles(glb, found.material, await packAuto(wrinkles), WHO)
    const bytes = encodeGlb(glb)
    await writeAll([{ path: output, bytes }], WHO)
    const warnings = [...glb.warnings, ...wrinkles.warnings.map((text) => `${WHO}: ${text}`)]
    if (report !== undefined) {
      const shown = { ...settings, regions: settings.regions?.join(', ') ?? 'all' }
      const source = { path: output, glb, found, wrinkles, settings: shown, warnings }
      const { files, missing } = await makeReport(source, report, steps, WHO)
      steps.begin('writing')
      await writeAll(files, WHO)
      if (missing) warnings.push(`${WHO}: the report has no pictures of the face (${missing})`)
    }
    return { found, wrinkles, bytes: bytes.length, warnings }
  })
  for (const warning of warnings) console.error(warning)
  process.stdout.write(
    options.json
      ? `${JSON.stringify(summary(wrinkles, found, options, bytes))}\n`
      : text(wrinkles, found, options),
  )
}

function readSettings(options: Options) {
  type Numeric = 'age' | 'strength' | 'seed' | 'layers' | 'areas'
  const number = (option: Numeric, low: number, high: number, whole = false) => {
    const example = AUTO_DEFAULTS[option]
    return readNumber(WHO, `--${option}`, options[option] ?? String(example), { low, high, whole, example })
  }
  return {
    age: number('age', 20, 80),
    strength: number('strength', 0, 2),
    size: Number(readChoice(WHO, '--size', options.size ?? String(AUTO_DEFAULTS.size), SIZES)),
    seed: number('seed', 0, 2 ** 31 - 1, true),
    layers: number('layers', 1, 4, true),
    areas: number('areas', 1, 64, true),
    ...(options.regions && { regions: options.regions }),
  }
}

/** A material has one set of wrinkles: those that it has go only if the user says so. */
function makeRoom(glb: Glb, { material, materialName }: FoundSkin, replace: boolean): void {
  if (glb.json.materials![material].extensions?.[WRINKLE_MAPS] === undefined) return
  if (!replace) throw hasWrinkles(materialName)
  stripWrinkles(glb, material, WHO)
}

/** The command speaks for the functions: users know none of them, and no memory that cannot be had. */
function guarded<T>(work: () => T): T {
  try {
    return work()
  } catch (error) {
    if (error instanceof FurrowError) error.message = error.message.replace(/^\w+(?=:)/, WHO)
    if (!(error instanceof RangeError)) throw error
    throw new FurrowError({
      who: WHO,
      what: 'not enough memory for maps of this size',
      remedy: 'choose a smaller --size',
    })
  }
}

function nothingCreases(mesh: string): FurrowError {
  return new FurrowError({
    who: WHO,
    what: 'no blendshape pushes the skin together enough to crease it',
    value: mesh,
    remedy: 'name another mesh with --mesh, or draw the wrinkles with furrow strokes',
  })
}

function hasWrinkles(material: string): FurrowError {
  return new FurrowError({
    who: WHO,
    what: 'the material has wrinkles',
    value: material,
    remedy: 'say --replace to make new ones in their place',
  })
}

function summary(
  { layers, areas, landmarks, warnings }: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, report }: Options,
  bytes: number,
) {
  return {
    file: output,
    ...(report !== undefined && { report: join(report, 'index.html') }),
    mesh: meshName,
    material: materialName,
    reason,
    bytes,
    isFace: landmarks !== undefined,
    warnings,
    layers: layers.map(({ name }) => name),
    areas: areas.map(({ name, layer, driver, compression, error, lines }) => ({
      name,
      layer,
      lines,
      compression,
      error,
      links: driver.targets,
    })),
  }
}

function text(
  { layers, areas }: AutoWrinkles,
  { meshName, materialName, reason }: FoundSkin,
  { output, report }: Options,
): string {
  const head = `${output}: mesh "${meshName}", material "${materialName}" (${reason}); layers: ${layers.length}; areas: ${areas.length}`
  const rows = areas.map(({ name, layer, compression, error, driver }) => {
    const links = driver.targets.map(({ name: target, weight }) => `${target} ${weight ?? 1}`).join(', ')
    const share = `${Math.round(100 * compression)}%`.padStart(4)
    return `  ${name.padEnd(20)} layer ${layer + 1}  shortened by ${share}  error ${error.toFixed(2)}  ${links}`
  })
  const page = report === undefined ? [] : [`${join(report, 'index.html')}: the report`]
  return `${[head, ...rows, ...page].join('\n')}\n`
}
