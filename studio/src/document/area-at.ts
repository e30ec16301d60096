import type { Uv } from 'furrow/author'
import { texelAt } from 'furrow/internal'
import type { StudioArea } from './document.ts'

/** Minimum weight of an area at a point of the skin that counts as being on the area, 0..255. */
const LEAST = 40
/** Names of areas of blood. They cover several regions, so the pointer prefers others. */
const BLOOD = /^(flush|pale)/

/** Whether an area shows blood and no wrinkles. */
export function isBloodArea({ name }: StudioArea): boolean {
  return BLOOD.test(name)
}

/** Returns the name of the area with the greatest weight at a point of the skin, or null if no area covers the point. */
export function areaAt(areas: readonly StudioArea[], uv: Uv): string | null {
  let best: { name: string; weight: number } | null = null
  for (const { name, weights } of areas) {
    const weight = texelAt(weights, uv) * (BLOOD.test(name) ? 0.2 : 1)
    if (weight >= LEAST && weight > (best?.weight ?? 0)) best = { name, weight }
  }
  return best?.name ?? null
}
