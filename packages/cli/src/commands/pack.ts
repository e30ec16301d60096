import { join } from 'node:path'
import { Option } from 'commander'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE } from 'furrow/internal'
import {
  type AreasPerImage,
  addMorphNormals,
  cannotRead,
  kilobytes,
  PACK_DEFAULTS,
  type PackedSet,
  packFace,
  setOfFolder,
  strokesBytes,
} from 'furrow-files'
import { FACE_EXTENSIONS, readFolder, readGlbFile, readReferenced, statOf } from 'furrow-files/node'
import { createCommand } from '../command.ts'
import { faceFiles } from '../face-outputs.ts'
import { writeAll } from '../files.ts'
import { allowOutsideOption, forceOption, numberParser } from '../options.ts'
import { checkOutputs } from '../outputs.ts'
import { print, warn } from '../print.ts'
import { withBar } from '../progress.ts'

const WHO = 'furrow pack'

interface Options {
  output: string
  face?: string
  mesh?: string
  material?: string
  whiteIsVisible?: boolean
  areaSize?: number
  share: `${AreasPerImage}`
  ktx2?: boolean
  size?: number
  morphNormals?: boolean
  allowOutside?: boolean
  force?: boolean
  json?: boolean
}

const imageSide = numberParser({ min: 2, max: MAX_IMAGE_SIDE, unit: 'texels', integer: true })

/** `furrow pack`: adds the wrinkles of a folder to a face. */
export const packCommand = createCommand('pack')
  .description('add wrinkles to a face: a folder of images becomes one .glb')
  .argument(
    '<folder>',
    'face.glb, layers/NAME/normal.png, areas/NAME.png, optionally wrinkles.json and strokes.json',
  )
  .requiredOption('-o, --output <file>', 'the face with its wrinkles (.glb, .vrm, .gltf)')
  .option('--face <file>', 'the face (default: face.glb in the folder)')
  .option(
    '--mesh <name>',
    'the mesh that wrinkles (default: that of wrinkles.json, "skin", or as furrow auto finds it)',
  )
  .option('--material <name>', 'its material (default: likewise)')
  .option('--white-is-visible', 'areas are white where wrinkles show, instead of black')
  .option(
    '--area-size <texels>',
    `side of the areas (default: wrinkles.json's, or ${DEFAULT_AREA_SIZE})`,
    imageSide,
  )
  .addOption(
    new Option('--share <count>', 'areas that share an image; of 4, one is in alpha')
      .choices(['1', '3', '4'])
      .default(String(PACK_DEFAULTS.areasPerImage)),
  )
  .addOption(
    new Option(
      '--ktx2',
      'maps and areas as KTX 2 arrays (UASTC), which stay compressed on the GPU',
    ).conflicts('share'),
  )
  .option('--size <texels>', "side of the layers' maps (default: unchanged)", imageSide)
  .option('--morph-normals', 'add normals to blendshapes that have none, so that shading follows them')
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
Layers may also have baseColor.png, roughness.png, occlusion.png, height.png and blood.png; the last two need an
amplitude in wrinkles.json.
Image tools drop the colours where alpha is 0: use --share 4 only for files that no such tool will process.
A slice of a KTX 2 array always holds four areas.

Examples:
  $ furrow pack my-face -o wrinkled.glb
  $ furrow pack my-face --face avatar.glb -o wrinkled.glb
  $ furrow pack my-face --ktx2 --size 512 -o small.glb
  $ furrow pack my-face --face avatar.vrm --mesh Face --material Face_SKIN -o wrinkled.glb --white-is-visible`,
  )
  .action(pack)

async function pack(folder: string, options: Options): Promise<void> {
  const {
    output,
    face = join(folder, 'face.glb'),
    whiteIsVisible = false,
    ktx2 = PACK_DEFAULTS.ktx2,
    areaSize,
    size,
  } = options
  const areasPerImage = Number(options.share) as AreasPerImage
  const rules = { extensions: FACE_EXTENSIONS, inputs: [face], force: options.force ?? false }
  await checkOutputs([output], WHO, rules)
  const replacing = { named: [output], force: rules.force }
  const document = await readFolder(folder, whiteIsVisible, WHO)
  if (options.face === undefined) await checkOwnFace(face)
  const glb = await readGlbFile(face, WHO, options)
  const read = (uri: string) => readReferenced(folder, uri, WHO, options)
  const { mesh: meshName, material: materialName } = options
  const packOptions = { mesh: meshName, material: materialName, areasPerImage, ktx2, areaSize, size }
  const { target, wrinkles, warnings } = await withBar('pack', (progress) =>
    packFace(glb, face, setOfFolder(document, read, WHO), packOptions, WHO, progress),
  )
  const morphNormals = options.morphNormals
    ? await withBar('normals', (progress) => addMorphNormals(glb, face, target.mesh, WHO, progress))
    : 0
  const files = await faceFiles(glb, output, WHO, replacing)
  await writeAll(files, WHO, replacing)

  const mesh = glb.json.meshes![target.mesh]
  const material = glb.json.materials![target.material]
  for (const warning of warnings) warn(warning)
  const result: Result = {
    file: output,
    mesh: mesh.name,
    material: material.name,
    layers: wrinkles.layers.map(({ name }) => name),
    areas: wrinkles.areas.map(({ name }) => name),
    areaSize: wrinkles.areaSize,
    drivers: wrinkles.drivers.length,
    strokes: wrinkles.strokes?.strokes.length ?? 0,
    bytes: files.reduce((sum, { bytes }) => sum + bytes.length, 0),
    added: imageBytes(wrinkles) + strokesBytes(wrinkles.strokes),
    morphNormals,
  }
  print(options.json ? JSON.stringify(result) : describe(result), output)
}

/** Throws FurrowError where a folder has no face of its own and none was named. */
async function checkOwnFace(face: string): Promise<void> {
  if (await statOf(face)) return
  throw cannotRead(WHO, `the face ${face}`, new Error('it does not exist'), {
    remedy: 'put it there, or name another one with --face',
  })
}

interface Result {
  file: string
  mesh?: string
  material?: string
  layers: string[]
  areas: string[]
  areaSize: number
  drivers: number
  strokes: number
  bytes: number
  /** Bytes of the wrinkles' images and strokes. */
  added: number
  /** Number of blendshapes that got normals. */
  morphNormals: number
}

function describe(result: Result): string {
  const { file, material, layers, areas, areaSize, drivers, strokes, bytes, added, morphNormals } = result
  const names = `layers: ${layers.join(', ')}; areas: ${areas.join(', ')} (${areaSize} x ${areaSize})`
  const normals = morphNormals > 0 ? `; blendshapes that got normals: ${morphNormals}` : ''
  const lines = strokes > 0 ? `strokes: ${strokes}; ` : ''
  const size = `wrinkles are ${kilobytes(added)} of ${kilobytes(bytes)}`
  return `${file}: material "${material ?? ''}"; ${names}; drivers: ${drivers}; ${lines}${size}${normals}`
}

/** Bytes of all images, each once. */
function imageBytes({ layers, areas }: PackedSet): number {
  const maps = layers.flatMap(({ normal, baseColor, roughness, occlusion, height, blood }) => {
    return [normal, baseColor, roughness, occlusion, height, blood]
  })
  const images = new Set([...maps, ...areas.map(({ image }) => image)].map((image) => image?.bytes))
  return [...images].reduce((sum, bytes) => sum + (bytes?.length ?? 0), 0)
}
