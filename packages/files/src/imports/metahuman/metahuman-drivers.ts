import type { WrinkleDriver } from 'furrow'
import { targetFinder } from 'furrow/internal'
import { ARKIT_NAMES, CURVES, type WrinkleCurve } from './curves.ts'

/**
 * Creates the drivers of the areas: from blendshapes with the names of MetaHuman's controls, else from ARKit's blendshapes, else from inputs
 * with the names of the rig curves.
 *
 * @param targets names of the face's blendshapes.
 */
export function metahumanDrivers(targets: readonly string[]): {
  drivers: WrinkleDriver[]
  kind: 'controls' | 'arkit' | 'inputs'
} {
  const controls = new Map(targets.map((name) => [keyOf(name), name]))
  const own = (control: string) => [controls.get(keyOf(control))].filter((name) => name !== undefined)
  const find = targetFinder(targets)
  const arkit = (control: string) => find(arkitNameOf(control)).map((index) => targets[index])
  const named = driversOf(own)
  if (named.length > 0) return { drivers: named, kind: 'controls' }
  const similar = driversOf(arkit)
  if (similar.length > 0) return { drivers: similar, kind: 'arkit' }
  return { drivers: CURVES.map(inputDriver), kind: 'inputs' }
}

const IDENTITY: [number, number][] = [
  [0, 0],
  [1, 1],
]

function driversOf(find: (control: string) => string[]): WrinkleDriver[] {
  return CURVES.flatMap(({ area, controls }): WrinkleDriver[] => {
    const factors = new Map<string, number>()
    for (const [control, factor] of Object.entries(controls)) {
      for (const name of find(control)) factors.set(name, Math.max(factor, factors.get(name) ?? 0))
    }
    if (factors.size === 0) return []
    const targets = [...factors].map(([name, weight]) => ({ name, weight }))
    return [{ type: 'morph', area, targets, rule: 'sum', curve: IDENTITY }]
  })
}

function inputDriver({ area, curve }: WrinkleCurve): WrinkleDriver {
  return { type: 'input', name: curve, area, curve: IDENTITY }
}

/** Returns a key such that `CTRL_expressions_browRaiseInL`, `head_lod0_mesh__brow_raiseIn_L` and `Brow_Raise_In_L` have the same one. */
function keyOf(name: string): string {
  return name
    .replace(/^.*__/, '')
    .replace(/^CTRL_expressions_/i, '')
    .replace(/[^a-z0-9]/gi, '')
    .toLowerCase()
}

function arkitNameOf(control: string): string {
  const [, name, side] = /^(.*?[a-z](?:[UD](?=[LR]$))?)([LR])?$/.exec(control) ?? [
    undefined,
    control,
    undefined,
  ]
  const sideName = side === undefined ? '' : side === 'L' ? 'Left' : 'Right'
  const known = ARKIT_NAMES[name]
  // ARKit has one shape for both sides of these.
  const isSided = !['browInnerUp', 'mouthPucker', 'mouthClose', 'mouthShrugLower'].includes(known)
  return `${known ?? name}${isSided ? sideName : ''}`
}
