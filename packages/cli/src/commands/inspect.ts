import { driversOf, FurrowError } from 'furrow'
import { describeDriver } from 'furrow/internal'
import {
  documentOf,
  type Glb,
  type GpuSizes,
  type Inspection,
  inspectPlain,
  inspectShapes,
  inspectWrinkles,
  kilobytes,
  type PlainInspection,
  type ShapeReport,
  skinOfTarget,
  targetOfMaterial,
  wrinkledFile,
  wrinkledMaterials,
} from 'furrow-files'
import { readGlbFile } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { writeAll } from '../files.ts'
import { drawPlainSheet, drawSheet } from '../inspect/sheet.ts'
import { allowOutsideOption } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print } from '../print.ts'

const WHO = 'furrow inspect'

/** Maximum number of blendshapes per mesh, and of joints per limb, in the printed lists. */
const NAMES_LISTED = 4

interface Options {
  material?: string
  sheet?: string
  allowOutside?: boolean
  json?: boolean
}

export const inspectCommand = createCommand('inspect')
  .description('show layers, areas, drivers and memory use')
  .argument('<face>', 'face with or without wrinkles (.glb, .vrm, .gltf)')
  .option('--material <name>', 'material with wrinkles (default: the only one)')
  .option('--sheet <file>', 'also draw all maps and areas into one image (.png)')
  .addOption(allowOutsideOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
The command shows which ARKit shape each blendshape is. It uses corrections in
the file, otherwise motion and names. For a face without wrinkles, it lists the
meshes, whether each is skin, cloth or hard, and the next command to add
wrinkles, and --sheet draws the UV layout.

GPU sizes include mipmaps for maps, but not for areas. 1 kB is 1024 bytes.

Examples:
  $ furrow inspect wrinkled.glb
  $ furrow inspect wrinkled.glb --sheet sheet.png --json`,
  )
  .action(inspect)

async function inspect(path: string, options: Options): Promise<void> {
  const { sheet, json } = options
  await checkOutputs([sheet], WHO, { inputs: [path] })
  const glb = await readGlbFile(path, WHO, options)
  if (wrinkledMaterials(glb).length === 0 && options.material === undefined) {
    return inspectFace(path, glb, options)
  }
  const file = wrinkledFile(glb, path, WHO, options.material)
  const report = await inspectWrinkles(file, WHO)
  const target = targetOfMaterial(glb.json, file.material, file.maps.drivers)
  const skin = target && skinOfTarget(await documentOf(glb, path, WHO), target)
  const shapes = skin ? inspectShapes(skin) : []
  if (sheet !== undefined) await writeAll([{ path: sheet, bytes: await drawSheet(file, WHO) }], WHO)
  const lines = json
    ? JSON.stringify({ file: path, ...report, shapes, ...(sheet && { sheet }) })
    : describe(path, report, shapes)
  print(json || sheet === undefined ? lines : [...lines, '', `${sheet}: all maps and areas`], sheet)
}

async function inspectFace(path: string, glb: Glb, { sheet, json }: Options): Promise<void> {
  const { report, skin } = inspectPlain(glb, await documentOf(glb, path, WHO), path)
  if (sheet !== undefined) {
    if (!skin) throw new FurrowError({ who: WHO, problem: `nothing to draw in ${path}`, remedy: report.next })
    await writeAll([{ path: sheet, bytes: await drawPlainSheet(glb, skin, WHO) }], WHO)
  }
  const lines = json
    ? JSON.stringify({ file: path, wrinkles: false, ...report, ...(sheet && { sheet }) })
    : describePlain(path, report)
  print(json || sheet === undefined ? lines : [...lines, `${sheet}: the skin and its UV layout`], sheet)
}

function describePlain(path: string, { meshes, surfaces, skin, shapes, next }: PlainInspection): string[] {
  return [
    `${path}: no wrinkles`,
    '',
    ...(meshes.length === 0
      ? ['no meshes']
      : table(
          ['mesh', 'materials', 'vertices', 'triangles', 'blendshapes'],
          meshes.map(({ mesh, materials, vertices, triangles, blendshapes }) => [
            mesh,
            materials.join(', '),
            String(vertices),
            String(triangles),
            blendshapes.length === 0 ? 'none' : `${blendshapes.length}: ${shortened(blendshapes)}`,
          ]),
        )),
    '',
    ...(surfaces.length === 0
      ? []
      : [
          ...table(
            ['mesh', 'material', 'kind', 'because', 'joints of'],
            surfaces.map(({ mesh, material, kind, why, limbs }) => [
              mesh,
              material,
              kind,
              why,
              limbs.join(', '),
            ]),
          ),
          '',
        ]),
    ...creasedJoints(surfaces),
    ...(shapes.length === 0 ? [] : [...shapeTable(shapes), '']),
    ...(skin ? [`the skin is mesh "${skin.mesh}", material "${skin.material}" (${skin.reason})`] : []),
    next,
  ]
}

/** Lists the joints that would crease skin or fold cloth. */
function creasedJoints(surfaces: PlainInspection['surfaces']): string[] {
  const rows = surfaces.flatMap(({ mesh, creased }) =>
    creased.map(({ limb, joints }) => [mesh, limb, shortened(joints)]),
  )
  return rows.length === 0 ? [] : [...table(['mesh', 'creases at', 'when these joints turn'], rows), '']
}

const EVIDENCE: Record<ShapeReport['by'], string> = {
  both: 'motion and name',
  geometry: 'motion',
  name: 'name',
  correction: 'correction',
  none: '',
}

function shapeTable(shapes: readonly ShapeReport[]): string[] {
  return table(
    ['blendshape', 'shape', 'confidence', 'by'],
    shapes.map(({ blendshape, shape, kind, confidence, by }) => [
      blendshape,
      shape ?? kind ?? (by === 'correction' ? 'none' : 'unknown'),
      shape ? confidence.toFixed(2) : '',
      EVIDENCE[by],
    ]),
  )
}

function shortened(names: readonly string[]): string {
  return names.length <= NAMES_LISTED ? names.join(', ') : `${names.slice(0, NAMES_LISTED).join(', ')}, ...`
}

function describe(path: string, report: Inspection, shapes: readonly ShapeReport[]): string[] {
  const { layers, areas, drivers, strokes, gpu, imageBytes, fileBytes } = report
  const presets = driversOf('expression', drivers)
  const others = drivers.filter(({ type }) => type !== 'expression')
  return [
    `${path}: wrinkles on material "${report.material ?? ''}"`,
    '',
    ...table(
      ['layer', 'kind', 'map', 'size', 'format', 'in the file', ...GPU_HEADS],
      layers.flatMap((layer) =>
        layer.maps.map((map) => [
          layer.name,
          layer.kind,
          map.map === 'normal' && layer.normalScale !== 1 ? `normal x ${layer.normalScale}` : map.map,
          `${map.width} x ${map.height}`,
          map.mimeType.replace('image/', ''),
          kilobytes(map.bytes),
          ...gpuCells(map.gpu),
        ]),
      ),
    ),
    '',
    ...table(
      ['area', 'layer', 'size', 'image', 'overlap', 'at rest', 'coverage', 'largest weight'],
      areas.map((area) => [
        area.name,
        area.layer,
        `${area.width} x ${area.height}`,
        `texture ${area.texture}${area.slice === undefined ? '' : ` slice ${area.slice}`} ${area.channel}`,
        area.combine,
        String(area.activation),
        `${(100 * area.coverage).toFixed(1)}%`,
        area.largest.toFixed(2),
      ]),
    ),
    '',
    others.length === 0 ? 'no drivers: the application sets the activations' : 'drivers',
    ...others.map((driver) => `  ${describeDriver(driver)}`),
    '',
    ...(presets.length === 0 ? [] : [...presets.map(describeDriver), '']),
    ...(shapes.length === 0 ? [] : [...shapeTable(shapes), '']),
    ...(strokes.count === 0 ? [] : [`strokes: ${strokes.count}`]),
    `wrinkles in the file: ${kilobytes(imageBytes + strokes.bytes)} of ${kilobytes(fileBytes)}`,
    `wrinkles on the GPU: ${kilobytes(gpu.uncompressed)} uncompressed, ${kilobytes(gpu.bits8)} with maps as BC7 or ASTC 4x4,` +
      ` ${kilobytes(gpu.bits4)} with maps as BC1 or ETC1`,
    '  compressed areas are BC4, or BC7 or ASTC 4x4 if the file stores them as a KTX 2 array',
    `  each face on the page takes another ${kilobytes(report.influenceMapBytes)} for its influence map`,
  ]
}

const GPU_HEADS = ['on the GPU', 'BC7, ASTC', 'BC1, ETC1']

const gpuCells = ({ uncompressed, bits8, bits4 }: GpuSizes) => [uncompressed, bits8, bits4].map(kilobytes)

function table(heads: string[], rows: string[][]): string[] {
  const all = [heads, ...rows]
  const widths = heads.map((_, i) => Math.max(...all.map((row) => row[i].length)))
  return all.map((row) =>
    row
      .map((cell, i) => cell.padEnd(widths[i]))
      .join('  ')
      .trimEnd(),
  )
}
