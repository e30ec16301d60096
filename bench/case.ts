import type { RendererKind } from '../stage/stage.ts'

export const RENDERER_KINDS: readonly RendererKind[] = ['webgl', 'webgpu']

/** What is drawn, the same by every variant. */
export interface Case {
  areas: number
  /** Number of areas that are not at rest. */
  active: number
  layers: number
  /** The layers' maps: normals alone, or with occlusion and blood, as the face's file and those of `furrow auto` have them. */
  maps: 'normals' | 'all'
  /** Whether the activations are the same in every frame. */
  still: boolean
}

/** How often each case is measured. */
export interface Plan {
  /** Each compiles every variant anew. */
  rounds: number
  /** Names of the variants, all by default; the plain face must be one. */
  variants?: readonly string[]
  /** Called after each round. */
  onRound?: () => void
  /** Ends it early. */
  signal?: AbortSignal
}

export const PLANS = {
  full: { rounds: 5 },
  quick: { rounds: 5 },
} as const satisfies Record<string, Plan>

const AREAS = [2, 8, 16, 64, 256]
const EIGHT = { areas: 8, active: 8 }
/** A large set of which an expression moves only a few areas. */
const FEW_OF_MANY = { areas: 256, active: 8 }

/** Every case of a run, or the two of a quick one. */
export function listCases(quick: boolean): Case[] {
  const counts = quick ? [EIGHT] : [...AREAS.map((areas) => ({ areas, active: areas })), FEW_OF_MANY]
  const normals = (quick ? [1] : [1, 4]).flatMap((layers) =>
    counts.map((count) => ({ ...count, layers, maps: 'normals' as const })),
  )
  const all = { ...EIGHT, layers: 1, maps: 'all' as const }
  return [...normals, all].flatMap((shown) => [false, true].map((still) => ({ ...shown, still })))
}

/** An area's activation in a frame, 0..1: a wave with a phase of its own for each area. */
export function activationOf(
  area: number,
  frame: number,
  { areas, active, still }: Pick<Case, 'areas' | 'active' | 'still'>,
): number {
  // The middle one of each group: where areas are strips, the outer ones are hardly visible.
  const groupSize = areas / active
  if (area % groupSize !== Math.floor(groupSize / 2)) return 0
  return 0.5 + 0.5 * Math.sin((still ? 0 : frame) * 0.37 + area * 2.4)
}
