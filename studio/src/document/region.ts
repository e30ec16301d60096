import type { WrinkleDriver } from 'furrow'
import type { LayerStroke, StudioDocument } from './document.ts'
import { areaOf } from './drivers.ts'
import { isAllowed, scaleStrengths, sidesOfArea, sidesOfLines } from './region-strengths.ts'
import { splitSide } from './sides.ts'
import { edited } from './strokes.ts'

/** Driver with a curve whose outputs are activations. */
type CurvedDriver = WrinkleDriver & { curve: [number, number][] }

/**
 * Whether a stroke belongs to an area. The group of a stroke that crosses the middle of the face has no side. The areas of the forehead share
 * strokes, whose group is one of these areas.
 */
function isIn({ group }: LayerStroke, area: string): boolean {
  if (group === undefined) return false
  return [area, ...sidesOfLines(area)].some((name) => group === name || group === splitSide(name)[0])
}

/** Returns the largest depth of an area's strokes in millimetres, or 0 if it has none. */
export function depthOf({ strokes }: StudioDocument, area: string): number {
  return Math.max(0, ...strokes.filter((stroke) => isIn(stroke, area)).map(({ depth }) => Math.abs(depth)))
}

/**
 * Scales the depths of an area's strokes, so that the largest is `depth`, millimetres. The settings of automatic wrinkles change with them, so
 * that new ones are as deep.
 */
export function setDepth(document: StudioDocument, area: string, depth: number): StudioDocument {
  const old = depthOf(document, area)
  if (old === 0) return document
  const sides = sidesOfLines(area)
  const auto = scaleStrengths(document.auto, sides, depth / old)
  const isReproducible = auto !== undefined && sides.length > 0 && isAllowed(auto, sides)
  const scale = (stroke: LayerStroke): LayerStroke => {
    if (!isIn(stroke, area)) return stroke
    const scaled = { ...stroke, depth: (stroke.depth * depth) / old }
    return isReproducible ? scaled : edited(scaled)
  }
  return { ...document, strokes: document.strokes.map(scale), ...(auto && { auto }) }
}

/** Returns the largest activation that the drivers of an area give, 0..1. Undefined if no driver has a curve. */
export function strengthOf({ drivers }: StudioDocument, area: string): number | undefined {
  const outputs = drivers.flatMap((driver) =>
    isCurvedOf(driver, area) ? driver.curve.map(([, output]) => output) : [],
  )
  return outputs.length > 0 ? Math.max(...outputs) : undefined
}

/**
 * Scales the curves of an area's drivers, so that their largest output is `strength`, 0..1. The settings of automatic wrinkles change with them:
 * new ones have the largest output 1, and are less deep instead.
 */
export function setStrength(document: StudioDocument, area: string, strength: number): StudioDocument {
  const old = strengthOf(document, area)
  if (!old) return document
  const scale = (driver: WrinkleDriver): WrinkleDriver => {
    if (!isCurvedOf(driver, area)) return driver
    const curve = driver.curve.map(([input, output]): [number, number] => [input, (output * strength) / old])
    return { ...driver, curve } as WrinkleDriver
  }
  const auto = scaleStrengths(document.auto, sidesOfArea(area), strength / old)
  return { ...document, drivers: document.drivers.map(scale), ...(auto && { auto }) }
}

function isCurvedOf(driver: WrinkleDriver, area: string): driver is CurvedDriver {
  return areaOf(driver) === area && Array.isArray((driver as Partial<CurvedDriver>).curve)
}
