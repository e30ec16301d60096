import type { RendererKind } from '../stage/stage.ts'

export const RENDERER_KINDS: readonly RendererKind[] = ['webgl', 'webgpu']

/** Scene that all variants render. */
export interface Case {
  areas: number
  /** Number of areas with nonzero activation. */
  active: number
  layers: number
  /** Maps of the layers: only normals, or also occlusion and blood, as in the shipped face. */
  maps: 'normals' | 'all'
  /** Whether activations are constant. */
  still: boolean
}

/** Options of a measurement. */
export interface Plan {
  /** Number of rounds; each compiles every variant. */
  rounds: number
  /** Names of the variants, including `plain`. Default: all. */
  variants?: readonly string[]
  /** Called after each round. */
  onRound?: () => void
  /** Stops the measurement. */
  signal?: AbortSignal
}

export const PLANS = {
  full: { rounds: 5 },
  quick: { rounds: 5 },
} as const satisfies Record<string, Plan>

const AREAS = [2, 8, 16, 64, 256]
const EIGHT = { areas: 8, active: 8 }
/** A large set with few active areas, as in an expression. */
const FEW_OF_MANY = { areas: 256, active: 8 }

/** Lists the cases of a full or quick run. */
export function listCases(quick: boolean): Case[] {
  const counts = quick ? [EIGHT] : [...AREAS.map((areas) => ({ areas, active: areas })), FEW_OF_MANY]
  const normals = (quick ? [1] : [1, 4]).flatMap((layers) =>
    counts.map((count) => ({ ...count, layers, maps: 'normals' as const })),
  )
  const all = { ...EIGHT, layers: 1, maps: 'all' as const }
  return [...normals, all].flatMap((shown) => [false, true].map((still) => ({ ...shown, still })))
}

/** Returns an area's activation in a frame, 0..1: a sine wave with a different phase per area. */
export function activationOf(
  area: number,
  frame: number,
  { areas, active, still }: Pick<Case, 'areas' | 'active' | 'still'>,
): number {
  // Activates the middle of each group, because outer strips are hardly visible.
  const groupSize = areas / active
  if (area % groupSize !== Math.floor(groupSize / 2)) return 0
  return 0.5 + 0.5 * Math.sin((still ? 0 : frame) * 0.37 + area * 2.4)
}
