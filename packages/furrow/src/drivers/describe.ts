import type { AreaActivation, Input } from './activation.ts'
import type { Curve } from './curve.ts'
import type { Link } from './link.ts'
import { definitionOf, type WrinkleDriver } from './registry.ts'

/**
 * Describes a driver in one line, such as `brow = 0.5 browInnerUp + browDown, curve (0, 0) (0.5, 1)`. If the driver activates no area and
 * its type defines no description, the fields of the driver are listed.
 */
export function describeDriver(driver: WrinkleDriver): string {
  const definition = definitionOf(driver.type)
  if (!definition) return `${driver.type}: unknown type, kept as it is`
  if (definition.describe) return definition.describe(driver)
  const activation = definition.activate?.(driver)
  if (!activation) return `${driver.type}: ${fieldsText(driver)}`
  return `${activation.area} = ${linksText(activation, driver.type)}${curveText(activation.curve)}`
}

/** Describes a link, such as `0.5 browInnerUp`. The points of a curve follow in brackets. */
export function describeLink({ name, weight, curve }: Readonly<Link>): string {
  return `${weight === 1 ? '' : `${weight} `}${name}${curve ? ` [${pointsText(curve)}]` : ''}`
}

/** Formats sums and products with operators, and other rules as function calls. Calls of a custom rule use the name of the driver type. */
function linksText({ links, rule }: AreaActivation, type: string): string {
  const texts = links.map(({ input, weight, curve }) =>
    describeLink({ name: inputText(input), weight, ...(curve && { curve: [...curve] }) }),
  )
  if (rule === 'sum') {
    const signed = texts.map((text, i) => (links[i].weight < 0 ? ` - ${text.slice(1)}` : ` + ${text}`))
    return [texts[0], ...signed.slice(1)].join('')
  }
  if (rule === 'product') return texts.join(' x ')
  return `${typeof rule === 'function' ? type : rule}(${texts.join(', ')})`
}

function inputText(input: Input): string {
  if (input.kind === 'target') return input.name
  if (input.kind === 'value') return `input ${input.name}`
  if (input.kind === 'area') return `area ${input.name}`
  if (input.kind === 'tension') {
    const { measure, direction } = input
    return `${measure} of the skin${direction ? ` along ${direction.join(' ')}` : ''}`
  }
  const { measure, from, joint, axis } = input
  return `${measure} of joint ${joint} from ${from}${axis ? ` about ${axis.join(' ')}` : ''}`
}

function curveText(curve: Readonly<Curve>): string {
  const text = pointsText(curve)
  return text === '(0, 0) (1, 1)' ? '' : `, curve ${text}`
}

function pointsText(curve: Readonly<Curve>): string {
  return curve.map(([input, output]) => `(${input}, ${output})`).join(' ')
}

/** Formats the fields of a driver, e.g. as `area brow, attack 0.1, release 0.4`. */
function fieldsText({ type: _, ...fields }: WrinkleDriver): string {
  return Object.entries(fields)
    .map(([name, value]) => `${name} ${valueText(value)}`)
    .join(', ')
}

function valueText(value: unknown): string {
  if (Array.isArray(value)) return value.map(valueText).join(' and ') || 'none'
  return typeof value === 'object' && value !== null
    ? Object.values(value).map(valueText).join(' ')
    : String(value)
}
