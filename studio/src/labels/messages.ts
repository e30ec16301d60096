import { nameLabel, regionLabel } from './names.ts'

/** Progress while an avatar is opened. */
export const PROGRESS = {
  faces: 'Listing faces',
  opening: 'Opening',
  webgl: 'Starting WebGL',
  webgpu: 'Starting WebGPU',
} as const

/** Notes about what has happened. */
export const NOTE = {
  graphicsLost: 'The graphics device was lost and is being restored; your work is kept',
  copiedCode: 'Copied the code',
  savedPicture: 'Saved the picture',
  savedLayout: 'Saved the UV layout: paint over it',
} as const

/** @param name name of a file. */
export function loadingLabel(name: string): string {
  return `Loading ${name}`
}

/** @param name name of a face that the server offers. */
export function loadingFaceLabel(name: string): string {
  return loadingLabel(nameLabel(name))
}

export function savedLabel(file: string): string {
  return `Saved ${file}`
}

export function savedPresetLabel(file: string): string {
  return `Saved ${file}. It has the settings of automatic wrinkles, without lines, paint and sculpting`
}

export function savedToFolderLabel(folder: string): string {
  return `Saved to the folder ${folder}`
}

export function appliedLabel(file: string): string {
  return `Applied ${file}`
}

export function addedTakeLabel(take: string): string {
  return `Added ${take} to the takes`
}

export function addedRegionLabel(region: string): string {
  return `Added the region ${regionLabel(region)}`
}

export function removedRegionLabel(region: string): string {
  return `Removed the region ${regionLabel(region)}`
}

/**
 * Returns the note about a copied link.
 *
 * @param isCopied whether the browser has copied it.
 * @param opensAvatar whether the link contains the avatar's address.
 */
export function linkNote(isCopied: boolean, opensAvatar: boolean): string {
  const contents = opensAvatar ? 'it opens this avatar' : 'the avatar itself is not in it'
  return isCopied ? `Copied the link: ${contents}` : `The link is in the address of this page: ${contents}`
}

/** Returns the note about several dropped faces, of which one is opened. */
export function oneFaceNote(file: string, count: number): string {
  return `Opened ${file}, one of ${count} faces`
}

/** Returns the note about several dropped folders with wrinkles, of which one is used. */
export function oneFolderNote(folder: string, count: number): string {
  return `Took the wrinkles in ${folder}, one of ${count} folders`
}
