import { useId } from 'preact/hooks'

interface NumberSliderProps {
  label: string
  /** Minimum, maximum, step. */
  range: readonly [number, number, number]
  /** Value. It can be outside the range. */
  value: number
  /** Displayed value with unit. Default: the number. */
  text?: string
  onMove(value: number): void
  onRest?(value: number): void
}

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
