import type { AreaDriverType } from '../../document/new-driver.ts'

/** Types of drivers in an artist's words, in the order in which they are offered. */
export const LABELS: { readonly [Type in AreaDriverType]: string } = {
  morph: 'Blendshapes',
  area: 'Other areas',
  tension: 'Skin tension',
  bone: 'Joint',
  age: 'Age',
  input: 'Number',
  muscle: 'Muscle',
  time: 'Delay',
  expression: 'Expression',
}

/** What a type is called; an unknown one is itself. */
export function labelOf(type: string): string {
  return (LABELS as Record<string, string>)[type] ?? type
}
