export const RENDERER_KINDS = ['webgl', 'webgpu'] as const
export type RendererKind = (typeof RENDERER_KINDS)[number]

/** What is drawn: every variant draws the same. */
export interface Case {
  areas: number
  /** How many of the areas are not at rest. */
  active: number
  layers: number
  /** Whether the activations stay as they are from frame to frame. */
  still: boolean
}

/** How long it is watched. */
export interface Plan {
  rounds: number
}

export const PLANS = {
  full: { rounds: 7 },
  quick: { rounds: 5 },
} as const satisfies Record<string, Plan>

const AREAS = [2, 8, 16, 64, 256]
/** As many areas as one face moves at a time, of a set with many. */
const FEW_OF_MANY = { areas: 256, active: 8 }

/** Every case of a run, or two that tell whether it works. */
export function listCases(quick: boolean): Case[] {
  const counts = quick
    ? [{ areas: 8, active: 8 }]
    : [...AREAS.map((areas) => ({ areas, active: areas })), FEW_OF_MANY]
  return (quick ? [1] : [1, 4]).flatMap((layers) =>
    counts.flatMap((count) => [false, true].map((still) => ({ ...count, layers, still }))),
  )
}

/** An area's activation in a frame, 0..1: waves out of step with each other, so that no two areas move alike. */
export function activationOf(area: number, frame: number, { areas, active, still }: Case): number {
  // The middle one of as many: where areas are strips of others, the outer ones hardly show.
  const every = areas / active
  if (area % every !== Math.floor(every / 2)) return 0
  return 0.5 + 0.5 * Math.sin((still ? 0 : frame) * 0.37 + area * 2.4)
}
