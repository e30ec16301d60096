import type { DroppedFile } from './dropped-files.ts'

/** File of an avatar. `path` is relative to the dropped folder. */
export interface AvatarFile {
  path: string
  file: Blob
}

/** File of a project folder, with its path there. */
export interface FolderFile {
  path: string
  content: Uint8Array | Blob
}

/** Folder for `furrow pack`. */
export interface WrinklesFolder {
  name: string
  /** Contained files, with paths relative to the folder. */
  files: DroppedFile[]
}
