import { useId } from 'preact/hooks'
import { LabelledGroup } from './labelled-group.tsx'

interface ChoiceProps<T extends string> {
  label: string
  options: readonly { value: T; label: string; title?: string }[]
  /** Undefined if no option is chosen. */
  value: T | undefined
  /** Maximum number of columns. Default: all options in one row. */
  columns?: number
  onChange(value: T): void
}

export function Choice<T extends string>({ label, options, value, columns, onChange }: ChoiceProps<T>) {
  const name = useId()
  return (
    <LabelledGroup label={label}>
      <div
        class={columns ? 'segments wrapped' : 'segments'}
        style={columns === undefined ? undefined : { '--columns': columns }}
      >
        {options.map((option) => (
          <label key={option.value} title={option.title}>
            <input
              type="radio"
              name={name}
              value={option.value}
              checked={option.value === value}
              onChange={() => onChange(option.value)}
            />
            <span>{option.label}</span>
          </label>
        ))}
      </div>
    </LabelledGroup>
  )
}
