import { useId } from 'preact/hooks'

interface NumberFieldProps {
  label: string
  value: number
  step: number
  /** Minimum and maximum. Default: unlimited. */
  range?: readonly [number, number]
  unit?: string | undefined
  /** Whether the label is only for screen readers. */
  isLabelHidden?: boolean
  onChange(value: number): void
}

/** Number field. Rejects invalid numbers. */
export function NumberField({
  label,
  value,
  step,
  range,
  unit,
  isLabelHidden = false,
  onChange,
}: NumberFieldProps) {
  const id = useId()
  // Show one digit more than the step has.
  const shown = Number(value.toFixed(Math.max(0, Math.ceil(-Math.log10(step))) + 1))
  return (
    <span class="number-field">
      <label for={id} class={isLabelHidden ? 'hidden' : ''}>
        {label}
      </label>
      <input
        id={id}
        type="number"
        {...{ step, value: shown }}
        {...(range && { min: range[0], max: range[1] })}
        onChange={({ currentTarget }) => {
          const next = currentTarget.valueAsNumber
          if (Number.isFinite(next) && next !== shown) onChange(next)
          else currentTarget.value = String(shown)
        }}
      />
      {unit && <span aria-hidden="true">{unit}</span>}
    </span>
  )
}
