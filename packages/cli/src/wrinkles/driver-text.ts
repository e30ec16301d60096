import type { Curve, DriverOf, DriverType, Link, Rule, WrinkleDriver } from 'furrow'

/** How drivers of each type read. */
const TEXTS: { [T in DriverType]: (driver: DriverOf<T>) => string } = {
  morph: ({ area, targets, rule, curve }) => `${area} = ${joined(targets, rule)}${curveText(curve)}`,
  area: ({ area, areas, rule, curve }) => `${area} = ${joined(areas, rule)} (areas)${curveText(curve)}`,
  conflict: ({ targets }) => `${targets.join(' and ')} cancel`,
  bone: ({ area, joints: [from, joint], measure, axis, curve }) =>
    measure === 'distance'
      ? `${area} = metres from joint ${from} to ${joint}${curveText(curve)}`
      : `${area} = turn of joint ${joint} seen from ${from}${axis ? ` about ${axis.join(' ')}` : ''}${curveText(curve)}`,
  tension: ({ area, measure, curve }) => `${area} = ${measure} of its skin${curveText(curve)}`,
  muscle: ({ name, area, kind }) => `${area ? `${area} = ` : ''}contraction of the ${kind} muscle ${name}`,
  age: ({ area, curve }) => `${area} = age${curveText(curve)}`,
  time: ({ area, attack, release }) => `${area} follows in ${attack} s, fades in ${release} s`,
  expression: ({ name, targets, activations }) =>
    `expression ${name}: ${[
      ...targets.map(({ name, weight }) => `${name} ${weight}`),
      ...activations.map(({ area, activation }) => `area ${area} ${activation}`),
    ].join(', ')}`,
}

/** A driver as one line: `brow = 0.5 browInnerUp + browDown, curve (0, 0) (1, 1)`. */
export function driverText(driver: WrinkleDriver): string {
  if (!Object.hasOwn(TEXTS, driver.type)) return `${driver.type}: not played by this version, kept as it is`
  return (TEXTS[driver.type as DriverType] as (driver: WrinkleDriver) => string)(driver)
}

/** Sums read as sums, the other rules as functions. */
function joined(links: readonly Link[], rule: Rule): string {
  const texts = links.map(linkText)
  if (rule === 'sum') return texts.join(' + ')
  return rule === 'product' ? texts.join(' x ') : `${rule}(${texts.join(', ')})`
}

/** A link as it reads in a driver: `0.5 browInnerUp`. */
export function linkText({ name, weight, curve }: Link): string {
  return `${weight === 1 ? '' : `${weight} `}${name}${curve ? ` [${points(curve)}]` : ''}`
}

function curveText(curve: Curve): string {
  const text = points(curve)
  return text === '(0, 0) (1, 1)' ? '' : `, curve ${text}`
}

function points(curve: Curve): string {
  return curve.map(([input, output]) => `(${input}, ${output})`).join(' ')
}
