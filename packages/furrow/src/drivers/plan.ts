import type { AreaActivation, Input, InputKind, InputOf } from './activation.ts'
import type { ActivationFilter, InputFilter } from './definition.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/** One driver that activates an area. */
export interface PlannedActivation {
  driver: WrinkleDriver
  /** Contribution to the area. */
  activation: AreaActivation
}

/** One driver that filters inputs. */
export interface PlannedFilter {
  driver: WrinkleDriver
  /** Filter of the inputs. */
  filter: InputFilter
}

/** Drivers in evaluation order: plain data, shared by all faces with these drivers. */
export interface DriverPlan {
  /** All drivers, in their original order. */
  readonly drivers: readonly WrinkleDriver[]
  /** Every area that a driver reads or writes. */
  readonly areaNames: readonly string[]
  /**
   * Areas activated by motion: blendshapes, joints, tension or other areas. An activation set on these areas lasts until the next frame. On
   * others it stays, and custom inputs add to it.
   */
  readonly movedAreas: ReadonlySet<string>
  /** Drivers that filter inputs, in the order of the file. */
  readonly inputFilters: readonly PlannedFilter[]
  /** First the drivers that read no area, in the order of the file. Then the others, sorted so that dependencies come first. */
  readonly activations: readonly PlannedActivation[]
  /** At most one per area. */
  readonly activationFilters: readonly ActivationFilter[]
  /** All inputs by kind: the same objects as in the filters and links. */
  readonly inputs: { readonly [K in InputKind]: readonly InputOf<K>[] }
  /** Areas that depend on themselves; their drivers that read areas are skipped. */
  readonly cyclicAreas: readonly string[]
  /** Unknown driver types; their drivers are skipped. */
  readonly unknownTypes: readonly string[]
}

/** Orders the drivers of a face for evaluation. Drivers of unknown type are skipped. */
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
  // With several filters for one area, the last one counts.
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

/** Sorts drivers topologically: drivers that write an area come before those that read it. */
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
