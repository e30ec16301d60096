import { Command } from 'commander'
import { FurrowError, WRINKLE_MAPS } from 'furrow'
import { AUTO_DEFAULTS, type AutoWrinkles, autoWrinkles } from 'furrow/author'
import { packAuto } from '../auto/pack-auto.ts'
import { findSkin } from '../auto/read-skin.ts'
import { readDocument } from '../face.ts'
import { writeAll } from '../images.ts'
import { readChoice, readNumber } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'
import { embedWrinkles } from '../wrinkles/embed.ts'
import { encodeGlb, readGlbFile } from '../wrinkles/glb-file.ts'
import { stripWrinkles } from '../wrinkles/strip.ts'

const WHO = 'furrow auto'

const SIZES = ['512', '1024', '2048', '4096']

interface Options {
  output: string
  age?: string
  strength?: string
  size?: string
  seed?: string
  mesh?: string
  layers?: string
  replace?: boolean
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
  .option('--replace', 'drop the wrinkles that the file has')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Examples:
  $ furrow auto avatar.glb -o wrinkled.glb
  $ furrow auto avatar.glb -o old.glb --age 70 --size 2048`,
  )
  .action(auto)

async function auto(face: string, options: Options): Promise<void> {
  const age = readNumber(WHO, '--age', options.age ?? String(AUTO_DEFAULTS.age), {
    low: 20,
    high: 80,
    example: 45,
  })
  const strength = readNumber(WHO, '--strength', options.strength ?? '1', { low: 0, high: 2, example: 1 })
  const size = Number(readChoice(WHO, '--size', options.size ?? String(AUTO_DEFAULTS.size), SIZES))
  const seed = readNumber(WHO, '--seed', options.seed ?? '1', {
    low: 0,
    high: 2 ** 31 - 1,
    whole: true,
    example: 1,
  })
  const layers = readNumber(WHO, '--layers', options.layers ?? '4', {
    low: 1,
    high: 4,
    whole: true,
    example: 4,
  })
  await checkWritable(options.output, WHO, '.glb')
  const glb = await readGlbFile(face, WHO)
  const found = findSkin(await readDocument(face, WHO), face, WHO, options.mesh)
  const material = glb.json.materials![found.material]!
  if (material.extensions?.[WRINKLE_MAPS] !== undefined) {
    if (!options.replace) throw hasWrinkles(found.materialName)
    stripWrinkles(glb, found.material, WHO)
  }
  const frame = found.hasTangents ? 'orthonormal' : 'derivative'
  const wrinkles = withBar('auto', (progress) =>
    autoWrinkles(found.skin, { age, strength, size, seed, layers, frame }, progress),
  )
  embedWrinkles(glb, found.material, await packAuto(wrinkles), WHO)
  const bytes = encodeGlb(glb)
  await writeAll([{ path: options.output, bytes }], WHO)
  for (const warning of [...glb.warnings, ...wrinkles.warnings.map((text) => `${WHO}: ${text}`)])
    console.error(warning)
  process.stdout.write(
    options.json
      ? `${JSON.stringify(summary(wrinkles, found, options.output, bytes.length))}\n`
      : text(wrinkles, found, options.output),
  )
}

function hasWrinkles(material: string): FurrowError {
  return new FurrowError({
    who: WHO,
    what: 'the material has wrinkles',
    value: material,
    remedy: 'say --replace to make new ones in their place',
  })
}

interface Names {
  meshName: string
  materialName: string
}

function summary(
  { layers, areas }: AutoWrinkles,
  { meshName, materialName }: Names,
  file: string,
  bytes: number,
) {
  return {
    file,
    mesh: meshName,
    material: materialName,
    bytes,
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

function text({ layers, areas }: AutoWrinkles, { meshName, materialName }: Names, file: string): string {
  const head = `${file}: mesh "${meshName}", material "${materialName}"; layers: ${layers.length}; areas: ${areas.length}`
  const rows = areas.map(({ name, layer, compression, error, driver }) => {
    const links = driver.targets.map(({ name: target, weight }) => `${target} ${weight ?? 1}`).join(', ')
    const share = `${Math.round(100 * compression)}%`.padStart(4)
    return `  ${name.padEnd(20)} layer ${layer + 1}  shortened by ${share}  error ${error.toFixed(2)}  ${links}`
  })
  return `${[head, ...rows].join('\n')}\n`
}
