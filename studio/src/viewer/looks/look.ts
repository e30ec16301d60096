import type { WrinkleMode } from 'furrow/three'

export type LookName = Look['name']

/**
 * Appearance of the face. A vertical divider splits the stage: the right side shows the face with wrinkles, the left side without.
 *
 * @property area areas to show, as if they were fully active. Default: all areas with their activations.
 * @property layer layer whose onset map is shown. Default: the first layer that has one.
 */
export type Look =
  | { name: 'shaded' | 'clay' | 'normals' | 'strain' | 'wireframe' }
  | { name: 'influence'; area?: string | readonly string[] }
  | { name: 'onset'; layer?: string }

/** Returns the label for the side of the divider with wrinkles. */
export function lookLabel(look: Look, mode: WrinkleMode): string {
  if (look.name === 'influence') return look.area === undefined ? 'Influence' : [look.area].flat().join(', ')
  if (look.name === 'wireframe') return 'Wireframe'
  if (look.name === 'strain') return 'Strain'
  if (look.name === 'onset') return look.layer === undefined ? 'Onset' : `Onset of ${look.layer}`
  return mode === 'off' ? 'Wrinkles off' : 'With wrinkles'
}
