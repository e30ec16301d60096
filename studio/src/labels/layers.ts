/** Layers and their maps. */
export const LAYER = {
  detail: 'Detail',
  detailHint: 'Wrinkles only, laid over the skin’s own normal map',
  replace: 'Replace',
  replaceHint: 'Wrinkles and pores that replace the skin’s own normal map',
  name: 'Name',
  kind: 'Kind',
  scale: 'Scale',
  height: 'Height, mm',
  blood: 'Blood',
  onset: 'Onset',
  sculpted: 'Sculpted heights',
  resetSculpted: 'Reset sculpting',
  up: 'Up',
  down: 'Down',
  remove: 'Remove',
  add: 'New layer',
  saveMaps: 'Save all maps',
  saveMapsHint: 'All layers and areas as images, in a .zip',
  saveUvs: 'Save UV layout',
  saveUvsHint: 'A template to paint regions over',
  import: 'Import…',
  save: 'Save',
  image: 'image',
  lines: 'lines',
  imageAndLines: 'image + lines',
  none: '–',
  bake: 'Bake from a sculpt… or drop one here',
  bakeHint: 'A detailed model of the wrinkled face, with the position and size of this face',
  baking: 'Baking',
  cancel: 'Cancel',
} as const

export const MAPS = {
  normal: 'Normal',
  baseColor: 'Colour',
  roughness: 'Roughness',
  occlusion: 'Occlusion',
  height: 'Height',
  blood: 'Blood',
  onset: 'Onset',
} as const

/** Returns the accessible names of a layer's controls. */
export function layerLabels(name: string) {
  return {
    name: `Name of layer ${name}`,
    up: `Move ${name} up`,
    down: `Move ${name} down`,
    remove: `Remove layer ${name}`,
    bake: `Bake a sculpt into ${name}`,
  }
}

/** Returns the accessible names of the controls of a layer's map. */
export function mapLabels(map: keyof typeof MAPS, layer: string) {
  return {
    import: `Import ${map} of ${layer}`,
    importHint: `Import ${MAPS[map].toLowerCase()} map`,
    save: `Save ${map} of ${layer}`,
    remove: `Remove ${map} of ${layer}`,
  }
}
