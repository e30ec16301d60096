import { AUTO_REGIONS, type AutoPreset } from 'furrow/author'
import { regionStrength, sidesOf } from 'furrow/internal'
import { AUTO_SETTINGS, type AutoSettings } from './document.ts'
import { limited } from './region-strengths.ts'

/**
 * Returns the preset that carries settings to other faces. It has no seeds, so that each face gets lines of its own, and neither the map size
 * nor the kind of the surface.
 */
export function presetOf({
  age,
  strength,
  symmetry,
  strengths = {},
  densities,
  regions,
}: AutoSettings): AutoPreset {
  const byRegion = shortest(limited(strengths))
  return {
    ...(age !== undefined && { age }),
    strength,
    ...(symmetry !== undefined && { symmetry }),
    ...(Object.keys(byRegion).length > 0 && { strengths: byRegion }),
    ...(densities && { densities }),
    ...(regions && { regions }),
  }
}

/** Returns the settings of a face after a preset is applied. The face keeps its map size, its surface, and its seeds if the preset has none. */
export function applyPreset(
  { size, seed, seeds, kind, cloth }: AutoSettings,
  preset: AutoPreset,
): AutoSettings {
  const own = preset.seed === undefined && {
    ...(seed !== undefined && { seed }),
    ...(seeds && { seeds }),
  }
  const surface = { ...(kind && { kind }), ...(cloth && { cloth }) }
  return { ...AUTO_SETTINGS, size, ...surface, ...own, ...preset }
}

/** Rounds strengths, omits those that are 1, and joins those of both halves of a region if they are equal. */
function shortest(strengths: NonNullable<AutoSettings['strengths']>): typeof strengths {
  const entries = AUTO_REGIONS.flatMap((region) => {
    const sides = sidesOf(region).map(
      (side) => [side, Math.round(1000 * regionStrength(strengths, side)) / 1000] as const,
    )
    const [[, first]] = sides
    const isSame = sides.every(([, value]) => value === first)
    return (isSame ? [[region, first] as const] : sides).filter(([, value]) => value !== 1)
  })
  return Object.fromEntries(entries)
}
