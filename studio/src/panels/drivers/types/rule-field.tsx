import type { Rule } from 'furrow'
import type { FormProps } from '../context.ts'
import { SelectField } from '../fields.tsx'

const RULES: readonly (readonly [Rule, string])[] = [
  ['sum', 'Added'],
  ['max', 'The largest'],
  ['min', 'The smallest: all are needed'],
  ['product', 'Multiplied'],
]

interface RuleFieldProps extends Omit<FormProps<never>, 'driver'> {
  rule: Rule
}

/** Field that chooses how a driver combines the values of its links. */
export function RuleField({ rule, index, context: { editor } }: RuleFieldProps) {
  return (
    <SelectField
      label="Together"
      value={rule}
      options={RULES}
      onChange={(next) => {
        editor.set(index, 'rule', { rule: next })
        editor.settle()
      }}
    />
  )
}
