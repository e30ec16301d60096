import { BoundLinks } from './links.ts'
import type { AreaDriver } from './types.ts'

/** Activates areas by other areas, each after those it is driven by. Nothing is allocated by `addTo`. */
export class AreaActivation {
  /** Areas that drive themselves, by whatever detour: their drivers are left out. */
  readonly cyclic: readonly string[]
  readonly #links: BoundLinks

  /** @param areaNames all areas there are, in the order of the activations. */
  constructor(drivers: readonly AreaDriver[], areaNames: readonly string[]) {
    const cyclic = cyclesOf(drivers)
    const linked = sort(drivers.filter(({ area }) => !cyclic.includes(area))).map(
      ({ area, areas, rule, curve }) => {
        return { area: areaNames.indexOf(area), links: areas, rule, curve }
      },
    )
    const find = (name: string) => [areaNames.indexOf(name)]
    this.#links = new BoundLinks(linked, find, 'AreaActivation')
    this.cyclic = cyclic
  }

  /** Adds to the activations of all areas what others of them give. */
  addTo(activations: Float32Array): void {
    this.#links.addTo(activations, activations, 0)
  }
}

/** Drivers in an order in which those of an area come after all that move what it reads. */
function sort(drivers: readonly AreaDriver[]): AreaDriver[] {
  const sorted: AreaDriver[] = []
  let rest = drivers
  while (rest.length > 0) {
    const pending = new Set(rest.map(({ area }) => area))
    const isReady = ({ areas }: AreaDriver) => areas.every(({ name }) => !pending.has(name))
    sorted.push(...rest.filter(isReady))
    rest = rest.filter((driver) => !isReady(driver))
  }
  return sorted
}

function cyclesOf(drivers: readonly AreaDriver[]): string[] {
  const reads = (area: string) =>
    drivers.flatMap((driver) => (driver.area === area ? driver.areas.map(({ name }) => name) : []))
  const reaches = (from: string, to: string, seen: Set<string>): boolean =>
    reads(from).some((name) => {
      if (name === to) return true
      if (seen.has(name)) return false
      seen.add(name)
      return reaches(name, to, seen)
    })
  return [...new Set(drivers.map(({ area }) => area))].filter((area) => reaches(area, area, new Set()))
}
