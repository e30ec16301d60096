import { join } from 'node:path'
import { Option } from 'commander'
import { DEFAULT_AREA_SIZE, MAX_IMAGE_SIDE } from 'furrow/internal'
import {
  type AreasPerImage,
  addMorphNormals,
  cannotRead,
  imageBytes,
  kilobytes,
  PACK_DEFAULTS,
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

export const packCommand = createCommand('pack')
  .description('add the wrinkles in a folder of images to a face')
  .argument('<folder>', 'folder with layers and areas; see below')
  .requiredOption('-o, --output <file>', 'face with wrinkles (.glb, .vrm, .gltf)')
  .option('--face <file>', 'input face (default: face.glb in the folder)')
  .option('--mesh <name>', 'target mesh (default: from wrinkles.json, or detected)')
  .option('--material <name>', 'target material (default: detected)')
  .option('--white-is-visible', 'white means visible in areas (default: black)')
  .option(
    '--area-size <texels>',
    `size of areas, 2 to ${MAX_IMAGE_SIDE} (default: from wrinkles.json, or ${DEFAULT_AREA_SIZE})`,
    imageSide,
  )
  .addOption(
    new Option('--share <count>', 'areas per image; 4 also uses alpha')
      .choices(['1', '3', '4'])
      .default(String(PACK_DEFAULTS.areasPerImage)),
  )
  .addOption(new Option('--ktx2', 'write maps and areas as KTX 2 (UASTC)').conflicts('share'))
  .option('--size <texels>', `resize the maps, 2 to ${MAX_IMAGE_SIDE} (default: unchanged)`, imageSide)
  .option('--morph-normals', 'add missing normals to blendshapes')
  .addOption(allowOutsideOption())
  .addOption(forceOption())
  .option('--json', 'print the result as JSON')
  .addHelpText(
    'after',
    `
The folder contains layers/NAME/normal.png and areas/NAME.png, and optionally
face.glb, wrinkles.json and strokes.json. A layer can also have baseColor.png,
roughness.png, occlusion.png, height.png and blood.png; height.png and blood.png
need an amplitude in wrinkles.json.

After --share 4, do not process the file with image tools. Many of them discard
colours where alpha is 0.

Examples:
  $ furrow pack my-face -o wrinkled.glb
  $ furrow pack my-face --face avatar.vrm --ktx2 --size 512 -o wrinkled.vrm`,
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

/** Throws if the folder has no `face.glb`. Only called without `--face`. */
async function checkOwnFace(face: string): Promise<void> {
  if (await statOf(face)) return
  throw cannotRead(WHO, `the face ${face}`, new Error('it does not exist'), {
    remedy: 'add it, or pass another face with --face',
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
  /** Size of the images and strokes that the command has added, bytes. */
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
