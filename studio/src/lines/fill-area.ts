import { FurrowError, type GrayImage } from 'furrow'
import { AUTO_DEFAULTS, AUTO_REGIONS, type SkinCanvas } from 'furrow/author'
import { layAreaLines } from 'furrow/internal'
import type { StudioDocument } from '../document/document.ts'
import { isActivated } from '../document/drivers.ts'
import { findNamed } from '../document/names.ts'
import { splitSide } from '../document/sides.ts'
import { edited } from '../document/strokes.ts'

/**
 * Fills an area with lines along its long axis. If nothing activates the area, makes it always visible. Lines are spaced as in the automatic
 * region that the area overlaps most, and depend on the settings of automatic wrinkles.
 *
 * @throws FurrowError if the area is too small for lines.
 */
export function fillArea(document: StudioDocument, name: string, canvas: SkinCanvas): StudioDocument {
  const { layer, weights } = findNamed(document.areas, name, 'area')
  const { age = AUTO_DEFAULTS.age, strength = 1, seed = 0 } = document.auto ?? {}
  const region = regionUnder(document, name, weights)
  const strokes = layAreaLines(canvas, weights, { region, age, strength, seed, stream: name })
  if (strokes.length === 0) throw tooSmallError(name)
  const activation = isActivated(document, name) ? undefined : { activation: 1 }
  return {
    ...document,
    strokes: [...document.strokes, ...strokes.map((stroke) => edited({ ...stroke, group: name, layer }))],
    areas: document.areas.map((area) => (area.name === name ? { ...area, ...activation } : area)),
  }
}

/** Returns the region of automatic wrinkles that an area belongs to, or overlaps most. */
function regionUnder({ areas }: StudioDocument, name: string, weights: GrayImage): string | undefined {
  const regionOf = (area: string) => AUTO_REGIONS.find((region) => region === splitSide(area)[0])
  const own = regionOf(name)
  if (own) return own
  let [best, most] = [undefined as string | undefined, 0]
  for (const other of areas) {
    const region = regionOf(other.name)
    if (!region) continue
    const common = weights.data.reduce((sum, weight, i) => sum + Math.min(weight, other.weights.data[i]), 0)
    if (common > most) [best, most] = [region, common]
  }
  return best
}

function tooSmallError(name: string): FurrowError {
  return new FurrowError({
    who: 'Studio',
    problem: `the region ${name} is too small for lines`,
    remedy: 'paint more skin, or draw the line by hand',
  })
}
