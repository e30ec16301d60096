import type { ClothKind } from 'furrow/author'

/** Fields of automatic wrinkles. */
export const AUTOMATIC = {
  age: 'Age',
  strength: 'Strength',
  symmetry: 'Symmetry',
  size: 'Map size',
  shuffle: 'Shuffle',
  regions: 'Regions with wrinkles',
  savePreset: 'Save preset',
  applyPreset: 'Apply preset…',
  surface: 'Surface',
  unknownSurface: 'Its joints can fold this mesh. What is it?',
  cloth: 'Fabric',
} as const

/** Returns the label of the progress: `Making wrinkles: strain`. */
export function makingLabel(step: string): string {
  return `Making wrinkles: ${step}`
}

/** Names of the kinds of surfaces, with what automatic wrinkles do. */
export const SURFACES = {
  skin: { label: 'Skin', title: 'Joints crease it, and blendshapes wrinkle it' },
  cloth: { label: 'Cloth', title: 'Joints fold it' },
  hard: { label: 'Hard', title: 'Joints do not fold it' },
} as const

/** Names of the kinds of cloth. */
export const CLOTHS: Readonly<Record<ClothKind, string>> = {
  silk: 'Silk',
  shirt: 'Shirt',
  denim: 'Denim',
  leather: 'Leather',
}
