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
