import { useId } from 'preact/hooks'

interface NumberSliderProps {
  label: string
  /** Least, most, step. */
  range: readonly [number, number, number]
  /** May be beyond the range. */
  value: number
  /** The value with its unit; by default the number alone. */
  text?: string
  onMove(value: number): void
  onRest?(value: number): void
}

/** A labelled slider of a number. */
export function NumberSlider({
  label,
  range: [min, max, step],
  value,
  text = step < 1 ? value.toFixed(2) : `${value}`,
  onMove,
  onRest,
}: NumberSliderProps) {
  const id = useId()
  const fill = Math.min(Math.max((value - min) / (max - min), 0), 1)
  return (
    <div class="row number">
      <label for={id}>{label}</label>
      <input
        id={id}
        type="range"
        {...{ min, max, step, value }}
        style={{ '--value': fill }}
        onInput={({ currentTarget }) => onMove(currentTarget.valueAsNumber)}
        onChange={({ currentTarget }) => onRest?.(currentTarget.valueAsNumber)}
      />
      <output for={id} aria-live="off">
        {text}
      </output>
    </div>
  )
}
