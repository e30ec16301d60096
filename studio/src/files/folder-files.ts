import type { DroppedFile } from './dropped-files.ts'

/** A file of an avatar with its path, relative to what was dropped. */
export interface AvatarFile {
  path: string
  file: Blob
}

/** A file of a project's folder, with its path in it. */
export interface FolderFile {
  path: string
  content: Uint8Array | Blob
}

/** A folder as `furrow pack` reads it. */
export interface WrinklesFolder {
  name: string
  /** All that is below it, with paths relative to it. */
  files: DroppedFile[]
}
