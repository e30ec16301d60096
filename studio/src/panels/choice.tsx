import { useId } from 'preact/hooks'

interface ChoiceProps<T extends string> {
  legend: string
  options: readonly { value: T; label: string; title?: string }[]
  value: T
  onChange(value: T): void
}

/** Radio buttons in one row. */
export function Choice<T extends string>({ legend, options, value, onChange }: ChoiceProps<T>) {
  const name = useId()
  return (
    <fieldset class="setting">
      <legend>{legend}</legend>
      <div class="segments">
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
    </fieldset>
  )
}
