import type { AreaActivation, Input, InputKind, InputOf } from './activation.ts'
import type { ActivationFilter, InputFilter } from './definition.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/** A driver that activates an area. */
export interface PlannedActivation {
  driver: WrinkleDriver
  activation: AreaActivation
}

export interface PlannedFilter {
  driver: WrinkleDriver
  filter: InputFilter
}

/** The drivers of a face, sorted for evaluation. Drivers activate areas (groups of wrinkles). Several faces can share a plan. */
export interface DriverPlan {
  /** All drivers, in their original order. */
  readonly drivers: readonly WrinkleDriver[]
  /** Names of all areas that a driver reads, activates or filters. */
  readonly areaNames: readonly string[]
  /**
   * Names of areas that are driven by motion: by blendshapes, joints, tension or other areas. If the application sets the activation of a
   * listed area, the value lasts until the next frame. For other areas, the value is kept, and inputs such as age add to the value.
   */
  readonly movedAreas: ReadonlySet<string>
  /** Drivers that filter inputs, in the order of the file. */
  readonly inputFilters: readonly PlannedFilter[]
  /**
   * Drivers that activate areas, in evaluation order. Drivers that read no area come first, in the order of the file. A driver that reads an
   * area follows all drivers that activate this area.
   */
  readonly activations: readonly PlannedActivation[]
  /** Filters of activations, at most one per area. */
  readonly activationFilters: readonly ActivationFilter[]
  /** All inputs by kind: the same objects as in `inputFilters` and `activations`. */
  readonly inputs: { readonly [K in InputKind]: readonly InputOf<K>[] }
  /** Areas that depend on themselves, directly or through other areas. Drivers that activate such an area and read areas are skipped. */
  readonly cyclicAreas: readonly string[]
  /** Driver types that are not registered. Drivers of these types are skipped. */
  readonly unknownTypes: readonly string[]
}

/** Sorts the drivers of a face for evaluation. */
export function planDrivers(drivers: readonly WrinkleDriver[]): DriverPlan {
  const known = drivers.flatMap((driver) => {
    const definition = definitionOf(driver.type)
    return definition ? [{ driver, definition }] : []
  })
  const planned = known.flatMap(({ driver, definition }): PlannedActivation[] => {
    const activation = definition.activate?.(driver)
    return activation ? [{ driver, activation }] : []
  })
  const external = planned.filter((own) => readAreas(own).length === 0)
  const dependent = planned.filter((own) => readAreas(own).length > 0)
  const cyclicAreas = findCycles(dependent)
  const activations = [
    ...external,
    ...sortByDependency(dependent.filter(({ activation }) => !cyclicAreas.includes(activation.area))),
  ]
  const inputFilters = known.flatMap(({ driver, definition }): PlannedFilter[] => {
    const filter = definition.filterInputs?.(driver)
    return filter ? [{ driver, filter }] : []
  })
  const filters = known.flatMap(({ driver, definition }) => definition.filterActivation?.(driver) ?? [])
  // If several filters have the same area, only the last one is kept.
  const activationFilters = [...new Map(filters.map((filter) => [filter.area, filter])).values()]
  const inputs = [
    ...inputFilters.flatMap(({ filter }) => filter.inputs),
    ...planned.flatMap(({ activation }) => activation.links.map((link) => link.input)),
  ]
  const written = planned.map(({ activation }) => activation.area)
  return {
    drivers,
    areaNames: [
      ...new Set([
        ...external.map(({ activation }) => activation.area),
        ...dependent.flatMap((own) => [own.activation.area, ...readAreas(own)]),
        ...activationFilters.map(({ area }) => area),
      ]),
    ],
    movedAreas: new Set(written.filter((_, i) => isMotion(planned[i].activation))),
    inputFilters,
    activations,
    activationFilters,
    inputs: {
      target: filterByKind('target', inputs),
      joint: filterByKind('joint', inputs),
      tension: filterByKind('tension', inputs),
      value: filterByKind('value', inputs),
      area: filterByKind('area', inputs),
    },
    cyclicAreas,
    unknownTypes: [...new Set(drivers.map(({ type }) => type).filter((type) => !definitionOf(type)))],
  }
}

function filterByKind<K extends InputKind>(kind: K, inputs: readonly Input[]): InputOf<K>[] {
  return inputs.filter((input): input is InputOf<K> => input.kind === kind)
}

function isMotion({ links }: AreaActivation): boolean {
  return links.some(({ input }) => input.kind !== 'value')
}

function readAreas({ activation }: PlannedActivation): string[] {
  return activation.links.flatMap(({ input }) => (input.kind === 'area' ? [input.name] : []))
}

/** Sorts drivers topologically: drivers that activate an area come before drivers that read it. */
function sortByDependency(planned: readonly PlannedActivation[]): PlannedActivation[] {
  const sorted: PlannedActivation[] = []
  let rest = planned
  while (rest.length > 0) {
    const pending = new Set(rest.map(({ activation }) => activation.area))
    const isReady = (own: PlannedActivation) => readAreas(own).every((name) => !pending.has(name))
    sorted.push(...rest.filter(isReady))
    rest = rest.filter((own) => !isReady(own))
  }
  return sorted
}

function findCycles(planned: readonly PlannedActivation[]): string[] {
  const reads = (area: string) =>
    planned.flatMap((own) => (own.activation.area === area ? readAreas(own) : []))
  const reaches = (from: string, to: string, seen: Set<string>): boolean =>
    reads(from).some((name) => {
      if (name === to) return true
      if (seen.has(name)) return false
      seen.add(name)
      return reaches(name, to, seen)
    })
  const areas = new Set(planned.map(({ activation }) => activation.area))
  return [...areas].filter((area) => reaches(area, area, new Set()))
}
