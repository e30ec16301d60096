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
} as const

/** Returns the label of the progress: `Making wrinkles: strain`. */
export function makingLabel(step: string): string {
  return `Making wrinkles: ${step}`
}
