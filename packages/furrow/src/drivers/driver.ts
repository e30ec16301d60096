/** What every driver offers, whatever it reads. */
export interface Driver {
  /** The areas it moves. */
  readonly areaNames: readonly string[]
  /** Activations in the order of `areaNames`, 0..1, as of its last update. */
  readonly activations: Float32Array
  /** What drivers name and is not there, e.g. `target "jawOpen" of a driver of area "chin"`: it counts as 0, or at rest. */
  readonly missing: readonly string[]
}

/** The areas of some drivers, each once, and the place of each driver's own among them. */
export function areasOf(drivers: readonly { area: string }[]): { areaNames: string[]; places: Uint16Array } {
  const areaNames = [...new Set(drivers.map(({ area }) => area))]
  return { areaNames, places: Uint16Array.from(drivers, ({ area }) => areaNames.indexOf(area)) }
}
