import { FurrowError } from 'furrow'
import type { Skin } from 'furrow/author'
import type { Progress } from '../base/progress.ts'
import { documentOf } from '../gltf/document.ts'
import type { Glb } from '../gltf/glb.ts'
import { namesOfTarget, type TargetNames } from '../json/target-names.ts'
import { skinOfTarget } from '../mesh/find-skin.ts'
import { findTarget } from '../mesh/target.ts'
import { imageBytes } from '../pack/image-bytes.ts'
import { PACK_DEFAULTS, type PackOptions } from '../pack/pack.ts'
import { type PackedFace, packFace } from '../pack/pack-face.ts'
import { kilobytes } from '../wrinkles/sizes.ts'
import { addNormalMap } from './add-normal-map.ts'
import { convertCharacter, findCharacter } from './character-creator/convert-character.ts'
import { characterFiles, readCharacter } from './character-creator/read-character.ts'
import { convertExpressions } from './expressions/convert-expressions.ts'
import type { FaceToImport } from './face-maps.ts'
import type { ImportedSet, ImportSettings, ImportSource } from './imported-set.ts'
import { convertMetahuman } from './metahuman/convert-metahuman.ts'
import { animatedMaps } from './metahuman/metahuman-files.ts'
import { isImagePath, type SourceFiles, stemOf } from './source-files.ts'
import { sideOf } from './source-image.ts'

/** Largest size of imported wrinkles in bytes. Larger maps are scaled down. */
export const MAX_IMPORT_BYTES = 5 * 2 ** 20
/** Default width and height of the maps in texels, if the maps of the source are larger. */
const DEFAULT_SIZE = 1024
/** Maps are not scaled down further than to this width and height. */
const SMALLEST_SIZE = 128

/**
 * Converts the files of a source.
 *
 * @param skin the face's mesh, or undefined if it has no triangles with texture coordinates.
 */
type Convert = (
  files: SourceFiles,
  face: FaceToImport,
  skin: Skin | undefined,
  settings: ImportSettings,
  who: string,
) => Promise<ImportedSet>

const CONVERTERS: Readonly<Record<ImportSource, Convert>> = {
  'character-creator': (files, face, _, settings, who) => convertCharacter(files, face, settings, who),
  metahuman: (files, face, _, settings, who) => convertMetahuman(files, face, settings, who),
  expressions: convertExpressions,
}

/** Options of an import. */
export interface ImportOptions extends TargetNames, Pick<PackOptions, 'ktx2'> {
  /** Width and height of the maps in texels. Default: as in the source, at most 1024, and smaller if the result is too large. */
  size?: number | undefined
  /** Direction of green in the source's normal maps. */
  green?: ImportSettings['green'] | undefined
  /** Exponents of Character Creator's regions by name, or for `all`. Default: as in the file, else 1. */
  powers?: ImportSettings['powers'] | undefined
}

/** Result of an import. */
export interface ImportResult extends PackedFace, Pick<ImportedSet, 'lost' | 'unread'> {
  source: ImportSource
  /** The face with its wrinkles. */
  glb: Glb
  /** Width and height of the maps in texels. */
  size: number
  /** Size of the images of the wrinkles in bytes. */
  bytes: number
  /** Whether the face had no normal map and got the one of the source. */
  hasNewNormalMap: boolean
}

/**
 * Adds the wrinkles of another program to a face.
 *
 * @param source program that wrote the files.
 * @param glb the face; not changed.
 * @param path path of the face, for errors.
 * @throws FurrowError if the source or the face is invalid, or the wrinkles do not fit into 5 MB.
 */
export async function importWrinkles(
  source: ImportSource,
  files: SourceFiles,
  glb: Glb,
  path: string,
  options: ImportOptions,
  who: string,
  progress: Progress,
): Promise<ImportResult> {
  const target = await findTarget(glb, path, who, await targetNames(source, files, glb, options, who))
  const skin = skinOfTarget(await documentOf(glb, path, who), target)
  // Unreal's normal maps follow Direct3D.
  const { green = source === 'metahuman' ? 'down' : 'up', powers = {}, ktx2 } = options
  let size = options.size ?? Math.min(DEFAULT_SIZE, await largestSide(files, who))
  for (;;) {
    const face: FaceToImport = { glb: { ...glb, json: structuredClone(glb.json) }, path, target }
    const { set, normalMap, lost, unread } = await CONVERTERS[source](
      files,
      face,
      skin,
      { size, green, powers },
      who,
    )
    if (normalMap) addNormalMap(face, normalMap)
    const names = namesOfTarget(glb.json, target)
    const packed = await packFace(face.glb, path, set, { ...PACK_DEFAULTS, ktx2, ...names }, who, progress)
    const bytes = imageBytes(packed.wrinkles)
    if (bytes <= MAX_IMPORT_BYTES) {
      return {
        ...packed,
        source,
        glb: face.glb,
        lost,
        unread,
        size,
        bytes,
        hasNewNormalMap: normalMap !== undefined,
      }
    }
    if (options.size !== undefined || size <= SMALLEST_SIZE) throw tooLarge(bytes, size, who)
    size = Math.max(SMALLEST_SIZE, Math.round(size / 2))
  }
}

/** Recognises the program that wrote the files. */
export async function detectSource(files: SourceFiles, who: string): Promise<ImportSource> {
  for (const path of characterFiles(files))
    if (await readCharacter(files, path, who)) return 'character-creator'
  return animatedMaps(files).normals.size > 0 ? 'metahuman' : 'expressions'
}

/** Returns the names of mesh and material: as the user says, else as the source says if the face has them. */
async function targetNames(
  source: ImportSource,
  files: SourceFiles,
  { json }: Glb,
  { mesh, material }: ImportOptions,
  who: string,
): Promise<TargetNames> {
  if (source !== 'character-creator' || material !== undefined) return { mesh, material }
  const wanted = (await findCharacter(files, who)).material.toLowerCase()
  // Blender appends numbers to names that exist already, e.g. `Std_Skin_Head.001`.
  const found = json.materials?.find(({ name = '' }) => name.toLowerCase().replace(/\.\d+$/, '') === wanted)
  return { mesh, material: found?.name }
}

/** Returns the largest side of all images that are not masks, in texels. */
async function largestSide(files: SourceFiles, who: string): Promise<number> {
  let largest = 1
  for (const path of files.paths) {
    const isMap = isImagePath(path) && !/mask|_msk_/.test(stemOf(path))
    if (isMap) largest = Math.max(largest, await sideOf(files, path, who))
  }
  return largest
}

function tooLarge(bytes: number, size: number, who: string): FurrowError {
  return new FurrowError({
    code: 'out-of-range',
    who,
    problem: `the wrinkles are too large with maps of ${size} x ${size}`,
    value: kilobytes(bytes),
    limit: kilobytes(MAX_IMPORT_BYTES),
    remedy: 'choose a smaller --size, or --ktx2',
  })
}
