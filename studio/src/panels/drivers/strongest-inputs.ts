import type { Curve, ExpressionDriver, Link, Rule, WrinkleDriver } from 'furrow'
import { curveAt } from 'furrow/internal'
import { areaOf } from '../../document/drivers.ts'

/** Input of a driver, or a whole driver whose inputs work only together. */
export interface StrongInput {
  /** Index of the driver in the list of drivers. */
  readonly index: number
  /** Index of the driver's link, or -1 for a whole driver. */
  readonly link: number
  /** Names of the inputs. Empty for drivers without names, such as the age. */
  readonly names: readonly string[]
  /** Activation that the input gives on its own when it is full, 0..1. */
  readonly full: number
}

/** Inputs that give less are omitted. */
const LEAST = 0.01

/** Driver that combines links to blendshapes or areas. */
interface LinkedDriver {
  readonly rule: Rule
  readonly curve: Curve
  readonly targets?: readonly Link[]
  readonly areas?: readonly Link[]
}

/** Returns the inputs that can show an area most, the strongest first. @param count maximum number of inputs. */
export function strongestInputs(
  drivers: readonly WrinkleDriver[],
  area: string,
  count: number,
): readonly StrongInput[] {
  return drivers
    .flatMap((driver, index) => inputsOf(driver, area).map((input) => ({ ...input, index })))
    .filter(({ full }) => full >= LEAST)
    .toSorted((a, b) => b.full - a.full)
    .slice(0, count)
}

function inputsOf(driver: WrinkleDriver, area: string): Omit<StrongInput, 'index'>[] {
  if (driver.type === 'expression') {
    const { name, activations } = driver as ExpressionDriver
    const own = activations.find((each) => each.area === area)
    return own ? [{ link: -1, names: [name], full: own.activation }] : []
  }
  if (areaOf(driver) !== area) return []
  if (driver.type === 'morph' || driver.type === 'area') return linksOf(driver as unknown as LinkedDriver)
  const { type, name, joints, curve } = driver as WrinkleDriver & {
    name?: string
    joints?: [from: string, joint: string]
    curve?: Curve
  }
  const names = name !== undefined ? [name] : joints ? [joints[1]] : []
  if (type === 'muscle') return [{ link: -1, names, full: 1 }]
  return curve ? [{ link: -1, names, full: Math.max(...curve.map(([, output]) => output)) }] : []
}

function linksOf({ rule, curve, targets, areas }: LinkedDriver): Omit<StrongInput, 'index'>[] {
  const links = targets ?? areas ?? []
  const values = links.map((link) => link.weight * (link.curve ? curveAt(link.curve, 1) : 1))
  if (links.length > 1 && (rule === 'min' || rule === 'product')) {
    const together = rule === 'min' ? Math.min(...values) : values.reduce((product, value) => product * value)
    return [{ link: -1, names: links.map(({ name }) => name), full: curveAt(curve, together) }]
  }
  return links.map(({ name }, link) => ({ link, names: [name], full: curveAt(curve, values[link]) }))
}
