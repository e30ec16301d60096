import type { VRM } from '@pixiv/three-vrm'
import { type Expression, FurrowError } from 'furrow'
import type { AnimationClip, Object3D, Quaternion, SkinnedMesh } from 'three'
import type { Face } from '../../../stage/face.ts'
import type { StudioDocument } from '../document/document.ts'
import type { DroppedFile } from '../files/dropped-files.ts'
import type { WrinklesFolder } from '../files/folder-files.ts'
import { STUDIO_FILE } from '../keep/studio-file.ts'
import { readFaceFile } from './face-file.ts'
import { loadGltf } from './load-gltf.ts'
import { releaseFromGPU, texturesOf } from './release.ts'
import { indexOfSkin, type SkinCandidate, skinOfDocument } from './skins.ts'
import type { DroppedAvatar, DroppedWrinkles } from './sort-files.ts'
import { readWrinklesFolder } from './wrinkles-folder.ts'

/** Avatar opened by the user. `{ ...avatar, skin }` is the same avatar with another skin. */
export interface OpenedAvatar {
  /** File name without extension. */
  readonly name: string
  /** Original file, followed by the files that it references. */
  readonly files: readonly [DroppedFile, ...DroppedFile[]]
  /** Public URL of the file. Absent for dropped files. */
  readonly address?: string
  /** Folder with the avatar's wrinkles, if they are not in the avatar's file. */
  readonly folder?: WrinklesFolder
  /** Document of the project with which the avatar was opened, if any. */
  readonly document?: StudioDocument
  readonly root: Object3D
  readonly skins: readonly SkinCandidate[]
  /** Index of the chosen skin in `skins`. */
  readonly skin: number
  readonly animations: readonly AnimationClip[]
  /** Rotations of all objects at rest, relative to their parents. */
  readonly rest: ReadonlyMap<Object3D, Quaternion>
  readonly vrm: VRM | null
  /** Expressions of a VRM, as blendshape weights. */
  readonly expressions: readonly Expression[]
  /** Messages for the user, one sentence each. */
  readonly notes: readonly string[]
}

/**
 * Opens a dropped avatar. If only wrinkles were dropped, opens the current avatar with them.
 *
 * @param shown current avatar.
 * @throws FurrowError if the files are invalid, or if there is nothing to show.
 */
export async function openDropped(
  dropped: DroppedAvatar | DroppedWrinkles,
  shown: OpenedAvatar | undefined,
): Promise<OpenedAvatar> {
  const { wrinkles: folder, notes } = dropped
  if (folder && isProject(folder)) return openProject(folder, notes, shown)
  if (dropped.kind === 'avatar') return openAvatar(dropped.face, dropped)
  if (!shown) throw noAvatarError(dropped.wrinkles.name)
  const wrinkles = await readWrinklesFolder(dropped.wrinkles)
  const skins = shown.skins.map((skin, i) => (i === shown.skin ? { ...skin, wrinkles } : skin))
  const { document: _, ...avatar } = shown
  return { ...avatar, folder: dropped.wrinkles, skins, notes }
}

/** Whether a folder is a project that the studio saved. */
function isProject({ files }: WrinklesFolder): boolean {
  return files.some(({ path }) => path === STUDIO_FILE)
}

/** Opens a project with its avatar, or with the current avatar if the project contains none. */
async function openProject(
  folder: WrinklesFolder,
  notes: readonly string[],
  shown: OpenedAvatar | undefined,
): Promise<OpenedAvatar> {
  const { readProjectInWorker } = await import('../export/in-worker.ts')
  const read = await readProjectInWorker(folder)
  const { document, face } = read
  const files = face.map(({ path, file }) => ({ path, file: new File([file], path) }))
  const all = [...notes, ...read.notes]
  const avatar =
    files.length > 0 ? await openAvatar(files[0], { files, notes: all }) : shown && { ...shown, notes: all }
  if (!avatar) throw noAvatarError(folder.name)
  return { ...avatar, document, skin: skinOfDocument(avatar, document) }
}

/**
 * Opens an avatar. If its wrinkles are invalid, opens it without them and adds a note.
 *
 * @param dropped other dropped files: referenced files, and wrinkles that replace the wrinkles in the avatar's file.
 * @throws FurrowError if the avatar is invalid, or if there is nothing to show.
 */
export async function openAvatar(
  face: DroppedFile,
  { files = [face], wrinkles, notes: chosen = [] }: Partial<Omit<DroppedAvatar, 'kind' | 'face'>> = {},
): Promise<OpenedAvatar> {
  const name = face.path.split('/').at(-1)!
  const file = await readFaceFile(face, files)
  const { gltf, skins, vrm, expressions, notes } = await loadGltf(file, name)
  const avatar = {
    name: name.replace(/\.[^.]+$/, ''),
    files: [face, ...new Set(file.references.values())] as const,
    root: gltf.scene,
    animations: gltf.animations,
    rest: rotationsIn(gltf.scene),
    vrm,
    expressions,
  }
  if (!skins.some(({ triangles }) => triangles > 0)) throw noMeshError(name)
  const skin = indexOfSkin(skins)
  if (wrinkles) {
    try {
      skins[skin].wrinkles = await readWrinklesFolder(wrinkles)
    } catch (error) {
      notes.push((error as Error).message)
    }
  }
  const folder = skins[skin].wrinkles && wrinkles
  return {
    ...avatar,
    skins,
    skin,
    ...(folder && { folder }),
    notes: [...chosen, ...notes, ...notesOn(skins[skin])],
  }
}

function rotationsIn(root: Object3D): ReadonlyMap<Object3D, Quaternion> {
  const rotations = new Map<Object3D, Quaternion>()
  root.traverse((object) => rotations.set(object, object.quaternion.clone()))
  return rotations
}

export function faceOf({ root, skins, skin }: OpenedAvatar): Face {
  const { meshes, wrinkles } = skins[skin]
  const [first, ...parts] = meshes
  return { root, skin: first, parts, wrinkles }
}

export function disposeAvatar({ root }: OpenedAvatar): void {
  releaseFromGPU(root)
  for (const { source } of texturesOf(root)) (source.data as { close?(): void } | null)?.close?.()
  root.traverse((object) => (object as Partial<SkinnedMesh>).skeleton?.dispose())
}

function notesOn({ name, problem, blendshapes, rest }: SkinCandidate): string[] {
  if (problem) return [`${name} cannot wrinkle: ${problem}`]
  if (blendshapes > 0 || rest.joints) return []
  return [`${name} has no blendshapes: it can be painted, but no expression moves it`]
}

function noAvatarError(folder: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `there is no avatar for the wrinkles in ${folder}`,
    remedy: 'drop an avatar first, or together with the wrinkles',
  })
}

function noMeshError(name: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `${name} has no mesh`,
    limit: 'triangles in its scene',
    remedy: 'export the avatar with its meshes',
  })
}
