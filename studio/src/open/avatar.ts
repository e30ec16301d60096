import type { VRM } from '@pixiv/three-vrm'
import { FurrowError } from 'furrow'
import type { AnimationClip, Object3D, SkinnedMesh } from 'three'
import type { Face } from '../../../stage/face.ts'
import { releaseFromGPU, texturesOf } from '../viewer/release.ts'
import type { DroppedFile } from './dropped-files.ts'
import { readFaceFile } from './face-file.ts'
import { loadGltf } from './load-gltf.ts'
import { indexOfSkin, type SkinCandidate } from './skins.ts'
import type { DroppedAvatar, DroppedWrinkles } from './sort-files.ts'
import { readWrinklesFolder } from './wrinkles-folder.ts'

/** An avatar that a user opened. `{ ...avatar, skin }` is the same one with another skin. */
export interface OpenedAvatar {
  /** Of its file, without the extension. */
  readonly name: string
  /** Its file as it was, then those that it refers to. */
  readonly files: readonly [DroppedFile, ...DroppedFile[]]
  readonly root: Object3D
  readonly skins: readonly SkinCandidate[]
  /** Index of the skin. */
  readonly skin: number
  readonly animations: readonly AnimationClip[]
  readonly vrm: VRM | null
  /** What the user should know of it, a sentence each. */
  readonly notes: readonly string[]
}

/**
 * Opens an avatar that was dropped, or the one on the stage with wrinkles that were.
 *
 * @param shown the avatar on the stage.
 * @throws FurrowError when it cannot be read, or there is nothing to show.
 */
export async function openDropped(
  dropped: DroppedAvatar | DroppedWrinkles,
  shown: OpenedAvatar | undefined,
): Promise<OpenedAvatar> {
  if (dropped.kind === 'avatar') return openAvatar(dropped.face, dropped)
  const { wrinkles: folder, notes } = dropped
  if (!shown) throw withoutAvatar(folder.name)
  const wrinkles = await readWrinklesFolder(folder)
  const skins = shown.skins.map((skin, i) => (i === shown.skin ? { ...skin, wrinkles } : skin))
  return { ...shown, skins, notes }
}

/**
 * Opens an avatar. What is wrong with its wrinkles costs these and a note.
 *
 * @param dropped what was dropped with it: files that it may refer to, wrinkles that take the place of its own.
 * @throws FurrowError when it cannot be read, or there is nothing to show.
 */
export async function openAvatar(
  face: DroppedFile,
  { files = [face], wrinkles, notes: chosen = [] }: Partial<Omit<DroppedAvatar, 'kind' | 'face'>> = {},
): Promise<OpenedAvatar> {
  const name = face.path.split('/').at(-1)!
  const file = await readFaceFile(face, files)
  const { gltf, skins, vrm, notes } = await loadGltf(file, name)
  const avatar = {
    name: name.replace(/\.[^.]+$/, ''),
    files: [face, ...new Set(file.references.values())] as const,
    root: gltf.scene,
    animations: gltf.animations,
    vrm,
  }
  if (!skins.some(({ triangles }) => triangles > 0)) throw nothingToShow(name)
  const skin = indexOfSkin(skins)
  if (wrinkles) {
    try {
      skins[skin].wrinkles = await readWrinklesFolder(wrinkles)
    } catch (error) {
      notes.push((error as Error).message)
    }
  }
  return { ...avatar, skins, skin, notes: [...chosen, ...notes, ...notesOn(skins[skin])] }
}

/** The avatar as the stage shows it. */
export function faceOf({ root, skins, skin }: OpenedAvatar): Face {
  const { meshes, wrinkles } = skins[skin]
  const [first, ...parts] = meshes
  return { root, skin: first, parts, wrinkles }
}

/** Frees all memory of an avatar that is no longer shown. */
export function disposeAvatar({ root }: OpenedAvatar): void {
  releaseFromGPU(root)
  for (const { source } of texturesOf(root)) (source.data as { close?(): void } | null)?.close?.()
  root.traverse((object) => (object as Partial<SkinnedMesh>).skeleton?.dispose())
}

function notesOn({ name, fault, blendshapes }: SkinCandidate): string[] {
  if (fault) return [`${name} cannot wrinkle: ${fault}`]
  if (blendshapes > 0) return []
  return [`${name} has no blendshapes: it can be painted, but no expression moves it`]
}

function withoutAvatar(folder: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    what: `there is no avatar for the wrinkles in ${folder}`,
    remedy: 'drop one first, or together with them',
  })
}

function nothingToShow(name: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    what: `${name} has no mesh`,
    limit: 'triangles in its scene',
    remedy: 'export the avatar with its meshes',
  })
}
