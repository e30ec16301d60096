import type { Rule } from './activation.ts'
import type { Curve } from './curve.ts'
import type { Link } from './link.ts'

/** Links and their rule in one line: sums read as sums, the other rules as functions. */
export function linksText(links: readonly Link[], rule: Rule): string {
  const texts = links.map(linkText)
  if (rule === 'sum') return texts.join(' + ')
  return rule === 'product' ? texts.join(' x ') : `${rule}(${texts.join(', ')})`
}

/** A link in one line: `0.5 browInnerUp`. */
export function linkText({ name, weight, curve }: Link): string {
  return `${weight === 1 ? '' : `${weight} `}${name}${curve ? ` [${points(curve)}]` : ''}`
}

/** `, curve (0, 0) (0.5, 1)`, or nothing for the identity. */
export function curveText(curve: Readonly<Curve>): string {
  const text = points(curve)
  return text === '(0, 0) (1, 1)' ? '' : `, curve ${text}`
}

function points(curve: Readonly<Curve>): string {
  return curve.map(([input, output]) => `(${input}, ${output})`).join(' ')
}
