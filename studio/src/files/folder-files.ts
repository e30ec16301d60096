import type { DroppedFile } from './dropped-files.ts'

/** File of an avatar. `path` is relative to a folder that contains all files of the avatar. */
export interface AvatarFile {
  path: string
  file: Blob
}

/** File of a project folder. `path` is relative to the folder. */
export interface FolderFile {
  path: string
  content: Uint8Array | Blob
}

/** Project folder, which `furrow pack` can read. */
export interface WrinklesFolder {
  name: string
  /** All files in the folder, with paths relative to the folder. */
  files: DroppedFile[]
}
