export const FILE = {
  project: 'Project',
  open: 'Open…',
  openFolder: 'Open folder…',
  face: 'Example face',
  edit: 'Edit wrinkles',
  undo: 'Undo',
  redo: 'Redo',
  share: 'Share',
  copyLink: 'Copy link',
  copyLinkHint: 'Link to this expression and view; your own files are never part of it',
  screenshot: 'Save picture',
  preferences: 'Preferences',
  shortcuts: 'Shortcuts',
  shortcutsHint: 'Shortcuts (?)',
  close: 'Close',
} as const

/** Card on the empty stage. */
export const START = {
  drop: 'Drop your avatar',
  kinds: 'A .glb, .gltf or .vrm, alone or with its folder. It stays on this computer.',
  faces: 'Or begin with a face',
} as const

/** Projects in the browser and on disk. */
export const KEEPING = {
  recent: 'Recent work',
  remove: 'Delete',
  saveProject: 'Save project (.zip)',
  saveToFolder: 'Save to folder…',
  saveToOtherFolder: 'Save to another folder…',
  kept: 'Kept in this browser',
  elsewhere: 'Open in another tab. Changes in this tab are not kept.',
  newer: 'Another tab has kept a newer version. Changes in this tab are not kept.',
  keepCopy: 'Keep a copy',
  takeOver: 'Go on here',
} as const

/** Export of the avatar with its wrinkles. */
export const EXPORT = {
  export: 'Export',
  exported: 'Exported file',
  ktx2: 'Compress for the GPU (KTX 2)',
  ktx2Hint: 'Maps stay compressed on the GPU',
  takes: 'Include takes as animations',
  takesHint: 'Any viewer of the file can then play them',
  hint: 'Export saves the avatar with its wrinkles, and this card then shows its size.',
  running: 'Packing and checking',
  copyCode: 'Copy the code',
  code: 'Code that loads the file',
} as const

/** Returns the name of the button that deletes a project, for screen readers. */
export function deleteProjectLabel(project: string): string {
  return `Delete ${project}`
}

/** Returns the label of the button that saves to a folder the user has chosen before. */
export function saveToLabel(folder: string): string {
  return `Save to ${folder}`
}

/** Returns the label of a number of bytes: `640 kB` or `1.2 MB`. */
export function bytesLabel(bytes: number): string {
  return bytes < 1e6 ? `${Math.round(bytes / 1e3)} kB` : `${(bytes / 1e6).toFixed(1)} MB`
}

/** Sizes of an exported file, bytes. */
interface ExportSizes {
  all: number
  wrinkles: number
  gpu: number
}

/** Returns the sentences about an exported file. @param errors number of errors in its wrinkles. */
export function exportedLabel(name: string, { all, wrinkles, gpu }: ExportSizes, errors: number): string {
  const sizes = `${name}: ${bytesLabel(all)} in all; the wrinkles take ${bytesLabel(wrinkles)} of it and ${bytesLabel(gpu)} on the GPU.`
  return `${sizes} The wrinkles have ${errorsLabel(errors)}.`
}

/** Returns the note about errors that the avatar had before the export. */
export function otherErrorsLabel(count: number): string {
  return `The rest of the file has ${errorsLabel(count)}, which it had before`
}

function errorsLabel(count: number): string {
  return count === 1 ? '1 error' : `${count === 0 ? 'no' : count} errors`
}
