import type { Rule } from 'furrow'
import { RULES } from '../../../labels/driver-forms.ts'
import type { FormProps } from '../context.ts'
import { SelectField } from '../fields.tsx'

const OPTIONS: readonly (readonly [Rule, string])[] = [
  ['sum', RULES.sum],
  ['max', RULES.max],
  ['min', RULES.min],
  ['product', RULES.product],
]

interface RuleFieldProps extends Omit<FormProps<never>, 'driver'> {
  rule: Rule
}

/** Field that chooses how a driver combines the values of its links. */
export function RuleField({ rule, index, context: { editor } }: RuleFieldProps) {
  return (
    <SelectField
      label={RULES.together}
      value={rule}
      options={OPTIONS}
      onChange={(next) => {
        editor.set(index, 'rule', { rule: next })
        editor.settle()
      }}
    />
  )
}
