import { join } from 'node:path'
import { Command } from 'commander'
import { DEFAULT_AREA_SIZE, FurrowError, MAX_IMAGE_SIDE, WRINKLE_MAPS } from 'furrow'
import { writeAll } from '../images.ts'
import { readChoice, readNumber } from '../numbers.ts'
import { withBar } from '../progress.ts'
import { checkWritable } from '../render/write-png.ts'
import { findDriverFaults } from '../wrinkles/driver-faults.ts'
import { embedWrinkles } from '../wrinkles/embed.ts'
import { readFolder } from '../wrinkles/folder.ts'
import { encodeGlb, readGlbFile } from '../wrinkles/glb-file.ts'
import type { Share } from '../wrinkles/map-images.ts'
import { addMorphNormals } from '../wrinkles/morph-normals.ts'
import { packFolder } from '../wrinkles/pack.ts'
import { kilobytes } from '../wrinkles/sizes.ts'
import { stripWrinkles } from '../wrinkles/strip.ts'
import { findTarget, jointNamesOf, targetNamesOf } from '../wrinkles/target.ts'

const WHO = 'furrow pack'

interface Options {
  output: string
  face?: string
  mesh?: string
  material?: string
  whiteIsVisible?: boolean
  areaSize?: string
  share?: string
  ktx2?: boolean
  size?: string
  morphNormals?: boolean
  json?: boolean
}

/** `furrow pack`: puts the wrinkles of a folder into a face. */
export const packCommand = new Command('pack')
  .description('put wrinkles into a face: a folder of images becomes one .glb')
  .argument('<folder>', 'face.glb, layers/NAME/normal.png, areas/NAME.png and, if wanted, wrinkles.json')
  .requiredOption('-o, --output <file>', 'the face with its wrinkles (.glb)')
  .option('--face <file>', 'the face (default: face.glb in the folder)')
  .option('--mesh <name>', 'the mesh that wrinkles (default: "skin", or the only one)')
  .option('--material <name>', 'its material (default: "skin", or the only one)')
  .option('--white-is-visible', 'areas are white where wrinkles show (default: the other way round)')
  .option('--area-size <texels>', `side of the areas (default: the document's, or ${DEFAULT_AREA_SIZE})`)
  .option('--share <count>', 'areas that share an image: 3 (default), 1, or 4 (puts one into alpha)')
  .option('--ktx2', 'maps and areas as KTX 2 arrays (UASTC), which stay compressed on the GPU')
  .option('--size <texels>', "side of the layers' maps (default: as they are)")
  .option('--morph-normals', 'give blendshapes normals where they have none, so that light follows them')
  .option('--json', 'print what was made as JSON')
  .addHelpText(
    'after',
    `
Layers may also have baseColor.png, roughness.png, occlusion.png and height.png.
Image tools drop the colours where alpha is 0: --share 4 is for files that no such tool will touch.

Examples:
  $ furrow pack my-face -o wrinkled.glb
  $ furrow pack faces/human --face faces/human.glb -o human.glb
  $ furrow pack faces/human --face faces/human.glb --ktx2 --size 512 -o small.glb
  $ furrow pack vroid --face avatar.vrm.glb --mesh Face --material Face_SKIN -o avatar.glb --white-is-visible`,
  )
  .action(pack)

async function pack(folder: string, options: Options): Promise<void> {
  const { output, face = join(folder, 'face.glb'), whiteIsVisible = false } = options
  if (options.ktx2 && options.share !== undefined) {
    throw new FurrowError({
      who: WHO,
      what: '--share and --ktx2 do not go together',
      value: options.share,
      limit: 'areas of an array lie four to a slice',
      remedy: 'leave one of them away',
    })
  }
  const share = Number(readChoice(WHO, '--share', options.share ?? '3', ['3', '1', '4'])) as Share
  const areaSize = readSide('--area-size', options.areaSize, DEFAULT_AREA_SIZE)
  const size = readSide('--size', options.size, 512)
  await checkWritable(output, WHO, '.glb')
  const document = await readFolder(folder, whiteIsVisible, WHO)
  const glb = await readGlbFile(face, WHO)
  const target = findTarget(glb.json, WHO, options.mesh, options.material)
  const wrinkles = await withBar('pack', (progress) =>
    packFolder(folder, document, { share, ktx2: options.ktx2 ?? false, areaSize, size }, WHO, progress),
  )
  const material = glb.json.materials![target.material]!
  if (material.extensions?.[WRINKLE_MAPS] !== undefined) stripWrinkles(glb, target.material, WHO)
  embedWrinkles(glb, target.material, wrinkles, WHO)
  const morphNormals = options.morphNormals
    ? await withBar('normals', (progress) => addMorphNormals(glb, face, target.mesh, WHO, progress))
    : 0
  const bytes = encodeGlb(glb)
  await writeAll([{ path: output, bytes }], WHO)

  const mesh = glb.json.meshes![target.mesh]!
  const faults = findDriverFaults(wrinkles.drivers, targetNamesOf(mesh), jointNamesOf(glb.json))
  const unknown = faults.missing.map((what) => `${WHO}: ${what} does not exist; it is kept`)
  for (const warning of [...glb.warnings, ...wrinkles.warnings, ...unknown]) console.error(warning)
  const made = {
    file: output,
    mesh: mesh.name,
    material: material.name,
    layers: wrinkles.layers.map(({ name }) => name),
    areas: wrinkles.areas.map(({ name }) => name),
    areaSize: wrinkles.areaSize,
    drivers: wrinkles.drivers.length,
    bytes: bytes.length,
    added: imageBytes(wrinkles),
    morphNormals,
  }
  process.stdout.write(`${options.json ? JSON.stringify(made) : sentence(made)}\n`)
}

function readSide(option: string, text: string | undefined, example: number): number | undefined {
  if (text === undefined) return undefined
  return readNumber(WHO, option, text, { low: 2, high: MAX_IMAGE_SIDE, whole: true, example })
}

interface Made {
  file: string
  material?: string
  layers: string[]
  areas: string[]
  areaSize: number
  drivers: number
  bytes: number
  added: number
  morphNormals: number
}

function sentence({
  file,
  material,
  layers,
  areas,
  areaSize,
  drivers,
  bytes,
  added,
  morphNormals,
}: Made): string {
  const names = `layers: ${layers.join(', ')}; areas: ${areas.join(', ')} (${areaSize} x ${areaSize})`
  const normals = morphNormals > 0 ? `; blendshapes that got normals: ${morphNormals}` : ''
  const size = `${kilobytes(added)} of ${kilobytes(bytes)} are wrinkles`
  return `${file}: material "${material ?? ''}"; ${names}; drivers: ${drivers}; ${size}${normals}`
}

function imageBytes({ layers, areas }: Awaited<ReturnType<typeof packFolder>>): number {
  const images = new Set(
    [
      ...layers.flatMap((layer) => [
        layer.normal,
        layer.baseColor,
        layer.roughness,
        layer.occlusion,
        layer.height,
      ]),
      ...areas.map(({ image }) => image),
    ].map((image) => image?.bytes),
  )
  return [...images].reduce((sum, bytes) => sum + (bytes?.length ?? 0), 0)
}
