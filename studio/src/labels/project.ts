export const FILE = {
  project: 'Project',
  open: 'Open…',
  openFolder: 'Open folder…',
  face: 'Example face',
  recent: 'Recent work',
  edit: 'Edit wrinkles',
  undo: 'Undo',
  redo: 'Redo',
  share: 'Share',
  copyLink: 'Copy link',
  screenshot: 'Save picture',
  export: 'Export',
  exported: 'Exported file',
  ktx2: 'Compress for the GPU (KTX 2)',
  copyCode: 'Copy the code',
  code: 'Code that loads the file',
  saveProject: 'Save project (.zip)',
  preferences: 'Preferences',
  shortcuts: 'Shortcuts',
  close: 'Close',
} as const

/** Card on the empty stage. */
export const START = {
  drop: 'Drop your avatar',
  kinds: 'A .glb, .gltf or .vrm, alone or with its folder. It stays on this computer.',
  faces: 'Or begin with a face',
} as const
