import { useId } from 'preact/hooks'

interface NumberSliderProps {
  label: string
  /** Least, most, step. */
  range: readonly [number, number, number]
  value: number
  onMove(value: number): void
  onRest(value: number): void
}

/** A labelled slider of a number. */
export function NumberSlider({ label, range: [min, max, step], value, onMove, onRest }: NumberSliderProps) {
  const id = useId()
  const fill = (value - min) / (max - min)
  return (
    <div class="row">
      <label for={id}>{label}</label>
      <input
        id={id}
        type="range"
        {...{ min, max, step, value }}
        style={{ '--value': fill }}
        onInput={({ currentTarget }) => onMove(currentTarget.valueAsNumber)}
        onChange={({ currentTarget }) => onRest(currentTarget.valueAsNumber)}
      />
      <output for={id} aria-live="off">
        {step < 1 ? value.toFixed(2) : value}
      </output>
    </div>
  )
}
