import type { RendererKind } from '../stage/stage.ts'

export const RENDERER_KINDS: readonly RendererKind[] = ['webgl', 'webgpu']

/** Returns the renderers that a user chose by `names`, or all that are available. Throws if a name is not `allowed`. */
export function checkRenderers(
  names: readonly string[] | undefined,
  allowed: readonly RendererKind[] = RENDERER_KINDS,
): RendererKind[] {
  const unknown = names?.find((name) => !allowed.some((kind) => kind === name))
  if (unknown === undefined) return [...((names as RendererKind[] | undefined) ?? allowed)]
  throw new Error(
    `bench: renderer not available here, got "${unknown}", allowed: ${allowed.join(', ')}; name one of these`,
  )
}

/** A scene that the benchmark measures. Each variant renders it with a different technique for wrinkles, and `plain` without wrinkles. */
export interface Case {
  areas: number
  /** Number of areas with nonzero activation. */
  active: number
  layers: number
  /**
   * Maps per layer: `normals` = a normal map; `all` = the normal, occlusion and blood maps of `faces/human.glb`; `onset` = all these maps, and
   * an onset map.
   */
  maps: 'normals' | 'all' | 'onset'
  /** Whether activations are constant. */
  still: boolean
}

export interface Plan {
  /** Number of rounds. Each round compiles every variant. */
  rounds: number
  /** Names of the variants. Must include `plain`, the face without wrinkles. Default: all variants. */
  variants?: readonly string[]
  onRound?: () => void
  signal?: AbortSignal
}

export const PLANS = {
  full: { rounds: 5 },
  quick: { rounds: 5 },
} as const satisfies Record<string, Plan>

const AREAS = [2, 8, 16, 64, 256]
const EIGHT = { areas: 8, active: 8 }
/** 256 areas, of which one expression activates only 8. */
const FEW_OF_MANY = { areas: 256, active: 8 }

export function listCases(quick: boolean): Case[] {
  const counts = quick ? [EIGHT] : [...AREAS.map((areas) => ({ areas, active: areas })), FEW_OF_MANY]
  const normals = (quick ? [1] : [1, 4]).flatMap((layers) =>
    counts.map((count) => ({ ...count, layers, maps: 'normals' as const })),
  )
  const richer = (['all', 'onset'] as const).map((maps) => ({ ...EIGHT, layers: 1, maps }))
  return [...normals, ...richer].flatMap((shown) => [false, true].map((still) => ({ ...shown, still })))
}

/** Returns an area's activation in a frame, 0..1: a sine wave with a different phase per area. */
export function activationOf(
  area: number,
  frame: number,
  { areas, active, still }: Pick<Case, 'areas' | 'active' | 'still'>,
): number {
  // In cases with more areas than active areas, the areas are strips of the face's areas, see `divideAreas`. One strip per area of the face is
  // active: the middle one, because areas fade out towards their borders.
  const groupSize = areas / active
  if (area % groupSize !== Math.floor(groupSize / 2)) return 0
  return 0.5 + 0.5 * Math.sin((still ? 0 : frame) * 0.37 + area * 2.4)
}
