import { NumberSlider } from '../controls/number-slider.tsx'

interface BrushSizeProps {
  label: string
  /** Radius, millimetres. */
  radius: number
  /** Minimum, maximum and step of the diameter, millimetres. */
  range: readonly [min: number, max: number, step: number]
  onChange(radius: number): void
}

/** Slider for the diameter of a brush. */
export function BrushSize({ label, radius, range, onChange }: BrushSizeProps) {
  return (
    <NumberSlider
      label={label}
      range={range}
      value={2 * radius}
      text={`${(2 * radius).toFixed(radius < 5 ? 1 : 0)} mm`}
      onMove={(size) => onChange(size / 2)}
    />
  )
}
